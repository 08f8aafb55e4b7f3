//! A dimension of published results.

/// An axis with its name, unit and values.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimension {
    /// Name in files.
    pub name: String,
    /// Unit; `1` for numbers without one.
    pub units: String,
    /// What it is, in words.
    pub long_name: String,
    /// Its values, ascending.
    pub values: Vec<f64>,
}

impl Dimension {
    /// The long name of α.
    pub const ALPHA: &'static str = "slide time over a contact length / retardation time";
    /// The long name of β.
    pub const BETA: &'static str = "inverse Hersey number";

    /// The name of the slide-to-sum ratio S where it is a dimension.
    pub const SLIDE_ROLL: &'static str = "slide_roll";

    /// A dimension.
    pub fn new(name: &str, units: &str, long_name: &str, values: &[f64]) -> Self {
        Self {
            name: name.to_owned(),
            units: units.to_owned(),
            long_name: long_name.to_owned(),
            values: values.to_vec(),
        }
    }

    /// The dimension S of dimensionless results over several slide-to-roll ratios, the first then.
    pub fn slide_roll(values: &[f64]) -> Self {
        Self::new(Self::SLIDE_ROLL, "1", "slide-to-sum ratio (u2 - u1)/(u1 + u2) of flat and roller", values)
    }

    /// The dimension f.
    pub fn strength(values: &[f64]) -> Self {
        Self::new("f", "1", "strength of retardation", values)
    }

    /// The dimension α of dimensionless results.
    pub fn alpha(values: &[f64]) -> Self {
        Self::new("alpha", "1", Self::ALPHA, values)
    }

    /// The dimension β of dimensionless results.
    pub fn beta(values: &[f64]) -> Self {
        Self::new("beta", "1", Self::BETA, values)
    }
}
