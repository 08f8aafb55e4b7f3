//! What holds for any bytes in the place of a table: an answer in bounded time, whose parts fit together.

use std::path::Path;

use stribeck_lab::{ColumnChoice, Measured, TableFile};

/// Reads the bytes as tables and as measured points.
pub fn check(bytes: &[u8]) {
    let path = Path::new("any.csv");
    let Ok(file) = TableFile::of(path, bytes) else {
        assert!(Measured::of(path, bytes, &[]).is_err());
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
        let Ok((measured, understood)) = Measured::of(path, bytes, choices) else { continue };
        let points = measured.friction.len();
        assert!(points > 0 && measured.places.len() == points && !measured.coordinates.is_empty());
        assert!(measured.coordinates.iter().all(|(_, values)| values.len() == points));
        assert!(measured.errors.iter().all(|errors| errors.iter().all(|error| *error > 0.0)));
        let numbers = measured.coordinates.iter().flat_map(|(_, values)| values).chain(&measured.friction);
        assert!(numbers.into_iter().all(|number| number.is_finite()));
        assert!(understood.to_string().starts_with("any.csv: "));
    }
}
