//! What a number is in: a unit, and for a dimensionless one what it is over.

use stribeck_lab::si_units;

/// The unit of a variable of a data set, as CF and libraries of units read it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// The unit: of SI, or 1.
    pub units: &'static str,
    /// What a dimensionless number is over, as in `a0/R`; `None` if it is a number by itself.
    pub scale: Option<&'static str>,
}

impl Unit {
    /// 1.
    pub const ONE: Self = Self { units: "1", scale: None };

    /// The unit of a column or a field with this scale, dimensionless or in SI.
    pub fn of(scale: &'static str, in_si: bool) -> Self {
        match scale {
            "1" => Self::ONE,
            scale if in_si => Self { units: si_units(scale), scale: None },
            scale => Self { units: "1", scale: Some(scale) },
        }
    }
}
