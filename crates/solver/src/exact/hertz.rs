//! Hertz's elastic line contact.

use std::f64::consts::LN_2;

/// Dry contact with an elastic half space under the load π/2 (Eq. 35 for half width 1).
///
/// The half width a is the square root of the compliance over the relaxed one: 1 for the relaxed modulus, 1/√(1+f) for
/// the instantaneous one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzContact {
    half_width: f64,
}

impl HertzContact {
    /// The contact with compliance E∞/E of the relaxed one, in (0, 1].
    ///
    /// # Panics
    /// If the compliance is not a positive finite number.
    pub fn new(compliance: f64) -> Self {
        assert!(compliance > 0.0 && compliance.is_finite(), "a compliance is a positive number, not {compliance}");
        Self { half_width: compliance.sqrt() }
    }

    /// a, over a₀.
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// p = √(1 − (x/a)²)/a inside the contact, 0 outside; over 2N/(πa₀).
    pub fn pressure(&self, x: f64) -> f64 {
        let x = x / self.half_width;
        ((1.0 - x) * (1.0 + x)).max(0.0).sqrt() / self.half_width
    }

    /// w = a² (1/π) ∫ p(s) ln|x − s| ds, over a₀²/R: the displacement (T7) times the compliance.
    ///
    /// Inside w = x²/2 and a constant, so that the surface follows the cylinder; far away a² ½ ln|x|.
    pub fn displacement(&self, x: f64) -> f64 {
        let a = self.half_width;
        let x = (x / a).abs();
        let level = 0.5 * a.ln() - 0.25 - 0.5 * LN_2;
        let shape = if x <= 1.0 {
            0.5 * x * x
        } else {
            // x² − x√(x² − 1), written so that it does not cancel far away.
            let sum = x + ((x - 1.0) * (x + 1.0)).sqrt();
            0.5 * (x / sum + sum.ln())
        };
        a * a * (level + shape)
    }
}
