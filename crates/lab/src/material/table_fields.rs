//! The columns in which files describe a material, and what instruments and programs call them.

use crate::{Dimension, Field, Measures};

const MODULUS: Measures = Measures::Dimensions(&[Dimension::Modulus]);

/// A column of a name, with what it measures and its other names.
const fn field(name: &'static str, measures: Measures, synonyms: &'static [&'static str]) -> Field {
    Field { name, synonyms, measures }
}

/// All columns. Young's modulus has the names without a mark, and E; the names of shear moduli begin with `shear`.
pub(super) const FIELDS: [Field; 18] = [
    field(
        "omega",
        Measures::Dimensions(&[Dimension::AngularFrequency]),
        &["ω", "w", "angularfrequency", "angfreq", "angularfreq"],
    ),
    field(
        "frequency",
        Measures::Dimensions(&[Dimension::Frequency, Dimension::AngularFrequency]),
        &["f", "freq", "frequenz"],
    ),
    field(
        "storage",
        MODULUS,
        &["storagemodulus", "estor", "estorage", "e'", "eprime", "speichermodul", "tensilestoragemodulus"],
    ),
    field("loss", MODULUS, &["lossmodulus", "eloss", "e\"", "edoubleprime", "verlustmodul", "tensilelossmodulus"]),
    field("shear_storage", MODULUS, &["g'", "gstor", "gstorage", "gprime", "shearstoragemodulus"]),
    field("shear_loss", MODULUS, &["g\"", "gloss", "gdoubleprime", "shearlossmodulus"]),
    field("size", MODULUS, &["|e*|", "e*", "eabs", "complexmodulus", "dynamicmodulus", "absolutemodulus"]),
    field("shear_size", MODULUS, &["|g*|", "g*", "gabs", "complexshearmodulus"]),
    field(
        "tan_delta",
        Measures::Ratio,
        &["tanδ", "tand", "lossfactor", "dampingfactor", "losstangent", "verlustfaktor"],
    ),
    field("delta", Measures::Dimensions(&[Dimension::Angle]), &["δ", "phaseangle", "phase", "phaseshift", "lossangle"]),
    field("time", Measures::Dimensions(&[Dimension::Time]), &["t", "steptime", "zeit"]),
    field("relaxation", MODULUS, &["relaxationmodulus", "erelax", "e(t)", "et", "stressrelaxationmodulus"]),
    field("shear_relaxation", MODULUS, &["shearrelaxationmodulus", "grelax", "g(t)", "gt"]),
    field(
        "temperature",
        Measures::Dimensions(&[Dimension::Temperature]),
        &["t", "temp", "sampletemperature", "temperatur"],
    ),
    field("tau", Measures::Dimensions(&[Dimension::Time]), &["τ", "taui", "τi", "reltime", "relaxationtime"]),
    field(
        "fraction",
        Measures::Ratio,
        &["g", "gi", "alpha", "alphai", "relmod", "relativemodulus", "normalizedmodulus"],
    ),
    field("modulus", MODULUS, &["e", "ei", "moduli", "relaxationstrength"]),
    field("shear_modulus", MODULUS, &["shearmoduli"]),
];

/// The columns of a table of shift factors.
pub(super) const SHIFT_FIELDS: [Field; 3] = [
    FIELDS[13],
    field("log_shift_factor", Measures::Ratio, &["logat", "log10at", "logshiftfactor", "log10shiftfactor", "logshift"]),
    field("shift_factor", Measures::Ratio, &["at", "shift", "horizontalshift"]),
];
