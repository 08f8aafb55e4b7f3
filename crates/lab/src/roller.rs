//! What the roller is made of, in numbers.

/// The moduli and times of a roller; its retardation spectrum stands beside it, as that of the flat does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roller {
    /// E∞/(1 − ν²) (Pa); infinite for a rigid roller.
    pub plane_strain_modulus: f64,
    /// f = E₀/E∞ − 1 of the roller; 0 for an elastic one.
    pub f: f64,
    /// τ (s) of the roller.
    pub retardation_time: f64,
}

impl Roller {
    /// A rigid roller.
    pub const RIGID: Self = Self { plane_strain_modulus: f64::INFINITY, f: 0.0, retardation_time: 0.0 };

    /// True for a rigid roller.
    pub fn is_rigid(&self) -> bool {
        self.plane_strain_modulus == f64::INFINITY
    }
}

impl Default for Roller {
    fn default() -> Self {
        Self::RIGID
    }
}
