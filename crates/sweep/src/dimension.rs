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
    /// A dimension.
    pub fn new(name: &str, units: &str, long_name: &str, values: &[f64]) -> Self {
        Self {
            name: name.to_owned(),
            units: units.to_owned(),
            long_name: long_name.to_owned(),
            values: values.to_vec(),
        }
    }

    /// The dimension f, the first of all results.
    pub fn strength(values: &[f64]) -> Self {
        Self::new("f", "1", "strength of retardation", values)
    }
}
