//! The film under a rigid cylinder on a rigid plane (β → 0), with the Swift–Stieber outlet.

use std::f64::consts::{FRAC_PI_2, PI};

use super::root::bracketed_root;
use crate::model::{CavityShear, Friction};

/// Film and pressure where the half space does not yield: u = h₀ + x²/2.
///
/// With x = √(2h₀) tan θ the film is h₀/cos²θ, and (T2) integrated from the inlet (T6) gives
///
/// ```text
/// p(θ) = √(2h₀)/(β h₀²) ∫_θ^{π/2} (cos²φ − (c/h₀) cos⁴φ) dφ
/// ```
///
/// The outlet θₒ has p = 0 and u = c (T5), so c/h₀ = 1/cos²θₒ and θₒ is the root of the integral: a number. The load of
/// this pressure is 1/(2βc), so that (T4) gives c = 1/(πβ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidFilm {
    beta: f64,
    separation: f64,
    outlet_angle: f64,
}

/// ∫_θ^{π/2} cos²φ dφ.
fn cos2_integral(angle: f64) -> f64 {
    0.5 * (FRAC_PI_2 - angle) - 0.25 * (2.0 * angle).sin()
}

/// ∫_θ^{π/2} cos⁴φ dφ.
fn cos4_integral(angle: f64) -> f64 {
    0.375 * (FRAC_PI_2 - angle) - 0.25 * (2.0 * angle).sin() - (4.0 * angle).sin() / 32.0
}

impl RigidFilm {
    /// The rigid film at β.
    ///
    /// # Panics
    /// If β is not a positive finite number.
    pub fn new(beta: f64) -> Self {
        assert!(beta > 0.0 && beta.is_finite(), "beta must be a positive number, not {beta}");
        let pressure = |angle: f64| {
            let cos = angle.cos();
            cos * cos * cos2_integral(angle) - cos4_integral(angle)
        };
        let outlet_angle = bracketed_root(pressure, -1.0, 0.0);
        Self { beta, separation: outlet_angle.cos().powi(2) / (PI * beta), outlet_angle }
    }

    /// h₀, the film on the cylinder's axis; 0.2596861/β.
    pub fn separation(&self) -> f64 {
        self.separation
    }

    /// c = 1/(πβ), the film at the largest pressure and at the outlet; 1.2257484 h₀.
    pub fn c(&self) -> f64 {
        1.0 / (PI * self.beta)
    }

    /// x_out; −0.4751299 √(2h₀).
    pub fn outlet(&self) -> f64 {
        self.width() * self.outlet_angle.tan()
    }

    /// Largest pressure, at x = −x_out.
    pub fn max_pressure(&self) -> f64 {
        self.pressure(-self.outlet())
    }

    /// u(x) = h₀ + x²/2.
    pub fn film(&self, x: f64) -> f64 {
        self.separation + 0.5 * x * x
    }

    /// p(x) ahead of the outlet, 0 behind it.
    pub fn pressure(&self, x: f64) -> f64 {
        let angle = (x / self.width()).atan();
        if angle <= self.outlet_angle {
            return 0.0;
        }
        // Far ahead the closed integrals cancel; there the integrand is a series in the small angle from π/2.
        let rest = (self.width() / x).atan();
        let integral = if x > 0.0 && rest < 0.01 {
            let (r2, c) = (rest * rest, self.c() / self.separation);
            rest * r2 * (1.0 / 3.0 - r2 * ((1.0 / 3.0 + c) / 5.0 - r2 * (2.0 / 45.0 + c * 2.0 / 3.0) / 7.0))
        } else {
            cos2_integral(angle) - self.c() / self.separation * cos4_integral(angle)
        };
        self.width() / (self.beta * self.separation * self.separation) * integral.max(0.0)
    }

    /// The friction forces of this film; a rigid half space has no viscoelastic one.
    pub fn friction(&self, cavity: CavityShear) -> Friction {
        let unit = self.width() / (PI * self.beta * self.separation);
        let c_ratio = self.c() / self.separation;
        let ahead = FRAC_PI_2 - self.outlet_angle;
        // −∫ p′u dx / π, from (T2).
        let pressure_part = unit * (ahead - c_ratio * cos2_integral(self.outlet_angle));
        let hydrodynamic_film = unit / 3.0 * ahead - pressure_part;
        let behind = match cavity {
            CavityShear::Full => PI - ahead,
            CavityShear::Streamers => c_ratio * (FRAC_PI_2 - cos2_integral(self.outlet_angle)),
            CavityShear::None => 0.0,
        };
        let hydrodynamic_cavity = unit / 3.0 * behind;
        Friction {
            viscoelastic: 0.0,
            viscoelastic_roller: 0.0,
            hydrodynamic_film,
            hydrodynamic_cavity,
            pressure: -pressure_part,
            drag: hydrodynamic_film + hydrodynamic_cavity + 2.0 * pressure_part,
        }
    }

    /// √(2h₀), the length in which the film doubles.
    fn width(&self) -> f64 {
        (2.0 * self.separation).sqrt()
    }
}
