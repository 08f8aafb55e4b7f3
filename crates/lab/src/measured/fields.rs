//! The columns of measured points: their names, and the values that they may have.

use crate::table::{Field, Measures};
use crate::{Dimension, LaboratoryQuantity, Turning};

/// Names of columns that hold friction coefficients, with the column of the results that they are compared with.
pub(super) const FRICTION: [(&str, &str); 5] =
    [("mu", "mu_drag"), ("mu_drag", "mu_drag"), ("mu_tot", "mu_tot"), ("mu_v", "mu_v"), ("mu_h", "mu_h")];
/// Name of the column of the standard error of the friction coefficient.
pub(super) const ERROR: &str = "error";
/// Numbers without a unit that say where a point belongs.
const DIMENSIONLESS: [&str; 3] = ["f", "alpha", "beta"];

/// What instruments and people call a friction coefficient.
const FRICTION_SYNONYMS: &[&str] = &[
    "cof",
    "cofmu",
    "coff",
    "averagecof",
    "avgcof",
    "meancof",
    "µ",
    "friction",
    "frictioncoefficient",
    "frictioncoeff",
    "coefficientoffriction",
    "coeffoffriction",
    "tractioncoefficient",
    "tractioncoeff",
    "traction",
    "tractioncoefficientµ",
    "frictioncoefficientµ",
    "frictioncoefficientmu",
    "frictioncoef",
    "coefficientoffrictionµ",
    "coefficientoffrictionmu",
    "kineticfrictioncoefficient",
    "dynamicfrictioncoefficient",
    "reibwert",
    "reibwertµ",
    "reibungszahl",
    "reibzahl",
    "reibungskoeffizient",
    "reibkoeffizient",
    "reibbeiwert",
    "measured",
];
/// What they call its standard error.
const ERROR_SYNONYMS: &[&str] = &[
    "err",
    "sd",
    "se",
    "sem",
    "std",
    "stddev",
    "stderr",
    "stderror",
    "standarderror",
    "standarddeviation",
    "sigma",
    "σ",
    "uncertainty",
    "muerror",
    "mustd",
    "musd",
    "mustderr",
    "cofsd",
    "cofstd",
    "coferror",
    "stdcof",
    "sdcof",
    "cofstddev",
    "cofstandarddeviation",
    "frictioncoefficientsd",
    "fehler",
    "standardfehler",
    "standardabweichung",
    "stdabw",
    "unsicherheit",
];

/// All columns that measured points may have.
pub(super) fn fields() -> Vec<Field> {
    let ratio = |name, synonyms| Field { name, synonyms, measures: Measures::Ratio };
    let friction = FRICTION.map(|(name, _)| ratio(name, if name == "mu" { FRICTION_SYNONYMS } else { &[] }));
    let dimensionless = DIMENSIONLESS.map(|name| ratio(name, &[]));
    let quantities = LaboratoryQuantity::ALL.map(|quantity| Field {
        name: quantity.name(),
        synonyms: synonyms(quantity),
        measures: match quantity {
            it if Turning::is_of(it) => Measures::Dimensions(&[Dimension::Speed, Dimension::AngularFrequency]),
            other => other.dimension().map_or(Measures::Ratio, |dimension| Measures::Dimensions(alone(dimension))),
        },
    });
    let error = ratio(ERROR, ERROR_SYNONYMS);
    friction.into_iter().chain([error]).chain(dimensionless).chain(quantities).collect()
}

/// A list of one dimension.
fn alone(dimension: Dimension) -> &'static [Dimension] {
    match dimension {
        Dimension::Length => &[Dimension::Length],
        Dimension::LineLoad => &[Dimension::LineLoad],
        Dimension::Modulus => &[Dimension::Modulus],
        Dimension::Viscosity => &[Dimension::Viscosity],
        Dimension::Time => &[Dimension::Time],
        Dimension::Speed => &[Dimension::Speed],
        Dimension::Temperature => &[Dimension::Temperature],
        other => unreachable!("no quantity of the laboratory is {}", other.words()),
    }
}

/// What instruments and people call a quantity.
fn synonyms(quantity: LaboratoryQuantity) -> &'static [&'static str] {
    match quantity.name() {
        "radius" => &["cylinderradius", "rollerradius", "ballradius", "halbmesser"],
        "viscosity" => &["dynamicviscosity", "viskosität", "dynamischeviskosität"],
        "speed" => &[
            "slidingspeed",
            "slidingvelocity",
            "velocity",
            "linearspeed",
            "linearvelocity",
            "geschwindigkeit",
            "gleitgeschwindigkeit",
        ],
        "entrainment_speed" => &[
            "rollingspeed",
            "rollingvelocity",
            "meanspeed",
            "entrainmentvelocity",
            "entrainingspeed",
            "meanrollingspeed",
            "rollgeschwindigkeit",
            "mittleregeschwindigkeit",
        ],
        "slide_roll_ratio" => &["srr", "slidetorollratio", "slideroll", "slip", "schlupf"],
        "roller_speed" => &["ballspeed", "cylinderspeed", "kugelgeschwindigkeit", "walzengeschwindigkeit"],
        "flat_speed" => &["discspeed", "diskspeed", "scheibengeschwindigkeit"],
        "load" => &[
            "normalload",
            "ballload",
            "normalforce",
            "appliedload",
            "lineload",
            "loadperlength",
            "force",
            "kraft",
            "normalkraft",
            "last",
            "linienlast",
            "streckenlast",
        ],
        "temperature" => &[
            "temp",
            "luberttemp",
            "lubertdtemp",
            "lubetemp",
            "lubricanttemperature",
            "oiltemperature",
            "temperatur",
            "öltemperatur",
        ],
        _ => &[],
    }
}

/// True for a value that the column of a field may have.
pub(super) fn admits(field: &str, value: f64) -> bool {
    match (field, LaboratoryQuantity::named(field)) {
        (_, Some(quantity)) => quantity.admits(value),
        (ERROR | "beta", _) => value > 0.0,
        ("f" | "alpha", _) => value >= 0.0,
        _ => true,
    }
}

/// The values that the column of a field may have, in words.
pub(super) fn allowed(field: &str) -> &'static str {
    use LaboratoryQuantity::{FlatSpeed, PoissonRatio, RollerSpeed, SlideRollRatio, Temperature};
    match (field, LaboratoryQuantity::named(field)) {
        (_, Some(PoissonRatio)) => "it is a number from 0 to 0.5",
        (_, Some(SlideRollRatio)) => "it is a number from -2 to 2, flat less roller over the mean",
        (_, Some(RollerSpeed | FlatSpeed)) => "it is a number from 0: both surfaces move the same way",
        (_, Some(Temperature)) => "it is a temperature from 100 K to 2000 K, in K or as in `temperature (degC)`",
        (_, Some(_)) | ("beta", _) => "it is a number above 0",
        ("f" | "alpha", _) => "it is a number from 0",
        (ERROR, _) => "a standard error is a number above 0",
        _ => "a friction coefficient is a number",
    }
}
