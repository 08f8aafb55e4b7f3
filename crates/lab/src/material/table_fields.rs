//! The columns in which files describe a material, and what instruments and programs call them.

use crate::Dimension;
use crate::table::{Field, Measures};

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
        &[
            "ω",
            "w",
            "angularfrequency",
            "angularfrequencyω",
            "angfreq",
            "angularfreq",
            "reducedangularfrequency",
            "atω",
            "kreisfrequenz",
            "winkelfrequenz",
        ],
    ),
    field(
        "frequency",
        Measures::Dimensions(&[Dimension::Frequency, Dimension::AngularFrequency]),
        &["f", "freq", "reducedfrequency", "oscillationfrequency", "frequenz", "messfrequenz"],
    ),
    field(
        "storage",
        MODULUS,
        &[
            "storagemodulus",
            "storagemoduluse'",
            "e'storagemodulus",
            "estor",
            "estorage",
            "e'",
            "e'w",
            "e'ω",
            "eprime",
            "tensilestoragemodulus",
            "speichermodul",
            "speichermodule'",
        ],
    ),
    field(
        "loss",
        MODULUS,
        &[
            "lossmodulus",
            "lossmoduluse\"",
            "e\"lossmodulus",
            "eloss",
            "e\"",
            "e\"w",
            "e\"ω",
            "edoubleprime",
            "tensilelossmodulus",
            "verlustmodul",
            "verlustmodule\"",
        ],
    ),
    field(
        "shear_storage",
        MODULUS,
        &[
            "g'",
            "g'w",
            "g'ω",
            "gstor",
            "gstorage",
            "gprime",
            "shearstoragemodulus",
            "storagemodulusg'",
            "g'storagemodulus",
            "speichermodulg'",
        ],
    ),
    field(
        "shear_loss",
        MODULUS,
        &[
            "g\"",
            "g\"w",
            "g\"ω",
            "gloss",
            "gdoubleprime",
            "shearlossmodulus",
            "lossmodulusg\"",
            "g\"lossmodulus",
            "verlustmodulg\"",
        ],
    ),
    field(
        "size",
        MODULUS,
        &["|e*|", "e*", "eabs", "complexmodulus", "dynamicmodulus", "absolutemodulus", "komplexermodul"],
    ),
    field("shear_size", MODULUS, &["|g*|", "g*", "gabs", "complexshearmodulus"]),
    field(
        "tan_delta",
        Measures::Ratio,
        &["tanδ", "tand", "lossfactor", "dampingfactor", "losstangent", "verlustfaktor"],
    ),
    field(
        "delta",
        Measures::Dimensions(&[Dimension::Angle]),
        &["δ", "phaseangle", "phase", "phaseshift", "lossangle", "phasenwinkel", "phasenverschiebung"],
    ),
    field("time", Measures::Dimensions(&[Dimension::Time]), &["t", "steptime", "testtime", "zeit", "messzeit"]),
    field(
        "relaxation",
        MODULUS,
        &["relaxationmodulus", "relaxationmoduluset", "erelax", "et", "stressrelaxationmodulus", "relaxationsmodul"],
    ),
    field("shear_relaxation", MODULUS, &["shearrelaxationmodulus", "relaxationmodulusgt", "grelax", "gt"]),
    field(
        "temperature",
        Measures::Dimensions(&[Dimension::Temperature]),
        &["t", "temp", "sampletemperature", "temperatur", "probentemperatur", "messtemperatur"],
    ),
    field(
        "tau",
        Measures::Dimensions(&[Dimension::Time]),
        &["τ", "taui", "τi", "reltime", "relaxationtime", "relaxationszeit"],
    ),
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
