//! A material as lines of text, as JSON and as a section of a sweep file.

use serde_json::{Map, Value, json};

use crate::format::{Align, table_line};
use stribeck_lab::{Modulus, ModulusKind, PronyParts, PronySeries, Relaxation, RelaxationTerm};

/// The numbers of a material, each in a line with its unit and meaning. Without a known modulus there are only those of
/// its creep.
pub fn numbers(relaxation: &Relaxation, modulus_is_known: bool) -> String {
    let material = relaxation.material();
    let moduli = [
        ("E0", relaxation.instantaneous_modulus(), "Pa, instantaneous modulus"),
        ("Einf", relaxation.relaxed_modulus(), "Pa, relaxed modulus"),
    ];
    let creep = [
        ("f", material.f, "E0/Einf - 1"),
        ("retardation time", material.retardation_time, "s, mean weighted by shares"),
    ];
    moduli.iter().filter(|_| modulus_is_known).chain(&creep).map(|row| number_line(row.0, row.1, row.2)).collect()
}

/// A number in six digits between its name and its meaning.
pub fn number_line(name: &str, value: f64, meaning: &str) -> String {
    table_line(&[Align::Left(18), Align::Right(11), Align::Left(0)], &[name, &digits(value), meaning])
}

/// Both spectra, a line for each term: the retardation time is above a relaxation time and below the next.
pub fn spectra(relaxation: &Relaxation, modulus_is_known: bool) -> String {
    let material = relaxation.material();
    let modulus = if modulus_is_known { "modulus/Pa" } else { "modulus/E0" };
    let mut text = format!("\nrelaxation   {modulus}       time/s      retardation        share       time/s\n");
    let columns = [23, 11, 28, 11].map(Align::Right);
    for (term, (strength, time)) in ascending(relaxation).iter().zip(material.retardation()) {
        text += &table_line(&columns, &[term.modulus, term.time, strength / material.f, time].map(digits));
    }
    text
}

/// The same numbers for programs.
pub fn json(relaxation: &Relaxation, modulus_is_known: bool) -> Map<String, Value> {
    let material = relaxation.material();
    let known = |value: f64| if modulus_is_known { json!(value) } else { Value::Null };
    let term = |term: &RelaxationTerm| json!({ "modulus": term.modulus, "time": term.time });
    let mode = |(strength, time): (f64, f64)| json!({ "share": strength / material.f, "time": time });
    let object = json!({
        "instantaneous_modulus": known(relaxation.instantaneous_modulus()),
        "relaxed_modulus": known(relaxation.relaxed_modulus()),
        "f": material.f,
        "retardation_time": material.retardation_time,
        "relaxation": ascending(relaxation).iter().map(term).collect::<Vec<_>>(),
        "retardation": material.retardation().map(mode).collect::<Vec<_>>(),
    });
    let Value::Object(map) = object else { unreachable!("it is written as one") };
    map
}

/// A fitted material as a series.
pub fn series(relaxation: &Relaxation) -> PronySeries {
    PronySeries {
        parts: PronyParts::Moduli,
        terms: ascending(relaxation).iter().map(|term| (term.modulus, term.time)).collect(),
        modulus: Some(Modulus::Relaxed(relaxation.relaxed_modulus())),
        kind: ModulusKind::Young,
    }
}

/// The section `[substrate]` of a sweep file with a series.
pub fn toml(series: &PronySeries) -> String {
    let modulus = series.toml_modulus().map(|modulus| format!("{modulus:<34}  # Pa\n")).unwrap_or_default();
    format!("[substrate]\n{modulus}relaxation = {}\n", series.toml_terms(None))
}

/// The relaxation terms in ascending order of their times.
fn ascending(relaxation: &Relaxation) -> Vec<RelaxationTerm> {
    let mut terms = relaxation.terms().to_vec();
    terms.sort_by(|a, b| a.time.total_cmp(&b.time));
    terms
}

/// Six digits.
pub fn digits(value: f64) -> String {
    format!("{value:.5e}")
}
