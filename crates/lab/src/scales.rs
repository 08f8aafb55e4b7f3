//! The scales that turn dimensionless results into SI units.

use std::f64::consts::FRAC_PI_2;

/// The units of a dimensionless solution, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// a₀ (m), of x.
    pub length: f64,
    /// a₀²/R (m), of h, w and u.
    pub height: f64,
    /// 2N/(πa₀) (Pa), of p.
    pub pressure: f64,
    /// a₀/R, of friction coefficients.
    pub friction: f64,
}

impl Scales {
    /// Names of the data set's variables that hold the scales, with unit and description, in the order of
    /// [`Scales::values`].
    pub const VARIABLES: [(&'static str, &'static str, &'static str); 4] = [
        ("a0", "m", "half width of the relaxed dry contact, the unit of x"),
        ("film_scale", "m", "a0^2/R, the scale of film thickness and displacement"),
        ("pressure_scale", "Pa", "2N/(pi a0), the scale of the pressure"),
        ("friction_scale", "1", "a0/R, the scale of friction coefficients"),
    ];

    /// The scales in the order of [`Scales::VARIABLES`].
    pub fn values(&self) -> [f64; 4] {
        [self.length, self.height, self.pressure, self.friction]
    }

    /// What a number in one of the units of dimensionless results is in SI units.
    ///
    /// # Panics
    /// If there is no such unit.
    pub fn factor(&self, units: &str) -> f64 {
        match units {
            "a0" => self.length,
            "a0^2/R" => self.height,
            "2N/(pi a0)" => self.pressure,
            "a0/R" => self.friction,
            // (2/π)(N/a₀)(a₀/R)
            "N/R" => FRAC_PI_2 * self.pressure * self.friction,
            "1" => 1.0,
            other => panic!("{other} is no unit of results"),
        }
    }
}

/// The SI unit in place of a unit of dimensionless results.
///
/// # Panics
/// If there is no such unit.
pub fn si_units(units: &str) -> &'static str {
    match units {
        "a0" | "a0^2/R" => "m",
        "2N/(pi a0)" | "N/R" => "Pa",
        "a0/R" | "1" => "1",
        other => panic!("{other} is no unit of results"),
    }
}
