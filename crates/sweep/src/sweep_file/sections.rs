//! The sections of a sweep file, and the keys of each.

use super::modulus::check_shear_modulus;
use stribeck_input::{Entry, Fault, Section};

/// The tables of a sweep file and their keys; the first one is the top level.
const SECTIONS: [(&str, &[&str]); 10] = [
    ("", &["title", "axes", "laboratory", "substrate", "flat", "roller", "solver", "output", "surface"]),
    ("axes", &["slide_roll", "f", "alpha", "beta"]),
    (
        "laboratory",
        &[
            "radius",
            "load",
            "relaxed_modulus",
            "instantaneous_modulus",
            "relaxed_shear_modulus",
            "instantaneous_shear_modulus",
            "poisson_ratio",
            "viscosity",
            "retardation_time",
            "temperature",
            "speed",
            "entrainment_speed",
            "slide_roll_ratio",
            "roller_speed",
            "flat_speed",
            "f",
            "swap",
            "roughness",
            "thickness",
        ],
    ),
    ("substrate", BODY),
    ("flat", BODY),
    ("roller", BODY),
    ("solver", &["method", "tolerance", "time_limit", "relaxation"]),
    ("solver.relaxation", &["domain", "points", "tolerance", "acceleration", "estimate"]),
    ("output", &["fields", "x", "limits", "cavity_shear", "sensitivities"]),
    ("surface", &["tolerance", "quantities", "points", "seed"]),
];

/// The keys of a body.
const BODY: &[&str] = &[
    "rigid",
    "modes",
    "relaxation",
    "relaxed_modulus",
    "instantaneous_modulus",
    "relaxed_shear_modulus",
    "instantaneous_shear_modulus",
    "poisson_ratio",
    "f",
    "retardation_time",
    "shift",
];

/// The keys of a section.
pub(super) fn keys(section: &str) -> &'static [&'static str] {
    SECTIONS.iter().find(|(name, _)| *name == section).map_or(&[], |(_, keys)| keys)
}

/// The first section below the top level that knows a key.
pub(super) fn home(key: &str) -> Option<&'static str> {
    SECTIONS[1..].iter().find(|(_, keys)| keys.contains(&key)).map(|(name, _)| *name)
}

/// The table behind an entry, with the keys its path says.
pub(super) fn section<'t>(entry: &Entry<'t>) -> Result<Section<'t>, Fault> {
    check_shear_modulus(entry)?;
    entry.section(keys(entry.path()), home)
}
