//! What holds for any bytes in the place of a table: an answer in bounded time, whose parts fit together.

use std::path::Path;

use stribeck_lab::table::{ColumnChoice, TableFile};
use stribeck_lab::{
    AtOneTemperature, Isotherms, MaterialData, MaterialFile, MaterialOptions, Measured, Measurements, ShiftFactors,
    Shifting,
};

/// Rows that are shifted at most: more take too long for one of many inputs.
const MOST_SHIFTED: usize = 60;

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

/// Reads the bytes as a material, of Young's moduli or of shear moduli, and as shift factors.
pub fn check_material(bytes: &[u8]) {
    let young = MaterialOptions { modulus_unit: Some(1e6), ..MaterialOptions::default() };
    let shear = MaterialOptions { is_shear: true, poisson_ratio: Some(0.5), ..MaterialOptions::default() };
    let unknown = MaterialOptions { poisson_ratio: Some(0.5), ..MaterialOptions::default() };
    for (name, options) in [("any.csv", &unknown), ("any.tts", &unknown), ("any.csv", &young), ("any.csv", &shear)] {
        let Ok(file) = MaterialFile::of(Path::new(name), bytes, options) else { continue };
        assert!(file.understood.starts_with(name));
        match file.data {
            MaterialData::Series(series) => assert!(series.terms.iter().all(|term| term.0 > 0.0 && term.1 > 0.0)),
            MaterialData::Moduli(moduli) => check_moduli(&moduli),
            MaterialData::Isotherms(isotherms) => check_isotherms(&isotherms),
        }
    }
    if let Ok((factors, _)) = ShiftFactors::of(Path::new("any.csv"), bytes, &[]) {
        let (least, most) = factors.range();
        assert!(least < most && factors.reference().is_none_or(|reference| (least..=most).contains(&reference)));
    }
}

fn check_moduli(moduli: &Measurements) {
    let numbers = moduli.rows().iter().flat_map(|row| [row.rate(), row.size()]);
    assert!(numbers.into_iter().all(|number| number > 0.0 && number.is_finite()));
}

/// Isotherms ascend, and a few of them are shifted or refused.
fn check_isotherms(isotherms: &Isotherms) {
    isotherms.all().iter().for_each(|isotherm| check_moduli(&isotherm.measurements));
    assert!(isotherms.all().is_sorted_by(|a, b| a.temperature < b.temperature));
    if isotherms.all().iter().map(|isotherm| isotherm.measurements.rows().len()).sum::<usize>() > MOST_SHIFTED {
        return;
    }
    let shifting = Shifting { reference: Some(isotherms.range().0), ..Shifting::default() };
    if let Ok(shifted) = AtOneTemperature::of_isotherms(isotherms, &shifting) {
        assert!(shifted.master_curve.is_some_and(|curve| curve.shifts.len() == isotherms.all().len()));
    }
}
