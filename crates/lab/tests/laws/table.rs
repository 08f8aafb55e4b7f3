//! What holds for any bytes in the place of a table: an answer in bounded time, whose parts fit together.

use std::path::Path;

use stribeck_lab::table::{ColumnChoice, TableFile};
use stribeck_lab::{MaterialData, MaterialFile, MaterialOptions, Measured};

/// Reads the bytes as tables and as measured points.
pub fn check(bytes: &[u8]) {
    let path = Path::new("any.csv");
    let Ok(file) = TableFile::of(path, bytes) else {
        assert!(Measured::of(path, bytes, &[], None).is_err());
        return;
    };
    assert!(!file.tables.is_empty());
    let mut line = 0;
    for row in file.tables.iter().flat_map(|table| table.rows()) {
        assert!(row.line > line, "rows stand in the order of the file");
        line = row.line;
    }
    let choices = ColumnChoice::list("speed=#1,mu=#2").expect("choices");
    for choices in [&[][..], &choices] {
        let Ok((measured, understood)) = Measured::of(path, bytes, choices, Some(0.01)) else { continue };
        let points = measured.friction.len();
        assert!(points > 0 && measured.places.len() == points && !measured.coordinates.is_empty());
        assert!(measured.coordinates.iter().all(|(_, values)| values.len() == points));
        assert!(measured.errors.iter().all(|errors| errors.iter().all(|error| *error > 0.0)));
        let numbers = measured.coordinates.iter().flat_map(|(_, values)| values).chain(&measured.friction);
        assert!(numbers.into_iter().all(|number| number.is_finite()));
        assert!(understood.to_string().starts_with("any.csv: "));
    }
}

/// Reads the bytes as a material.
pub fn check_material(bytes: &[u8]) {
    let options = MaterialOptions { poisson_ratio: Some(0.5), ..MaterialOptions::default() };
    for name in ["any.csv", "any.tts"] {
        let Ok(MaterialFile { data: MaterialData::Moduli(moduli), .. }) =
            MaterialFile::of(Path::new(name), bytes, &options)
        else {
            continue;
        };
        let numbers = moduli.rows().iter().flat_map(|row| [row.rate(), row.size()]);
        assert!(numbers.into_iter().all(|number| number > 0.0 && number.is_finite()));
    }
}
