//! What a modulus is of: Young's or shear.

/// The kind of load that a modulus is of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ModulusKind {
    /// Young's modulus E, of tension and of bending.
    #[default]
    Young,
    /// Shear modulus G, of torsion and of plates that turn.
    Shear,
}

impl ModulusKind {
    /// Young's modulus over the modulus of this kind: 1, or 2(1 + ν) for G of an isotropic solid.
    pub fn young_factor(self, poisson_ratio: f64) -> f64 {
        match self {
            Self::Young => 1.0,
            Self::Shear => 2.0 * (1.0 + poisson_ratio),
        }
    }
}
