//! The film ahead of the mesh, integrated to infinity.

use crate::model::gauss;

/// The film at x ≥ X, where the displacement no longer changes: u = x²/2 + g (T33).
///
/// With x = X/t the integrals of the pressure gradient p′ = −(u − c)/(βu³) (T2) are those of smooth functions over 0 ≤
/// t ≤ 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inlet {
    /// X, where it begins.
    pub start: f64,
    /// u(X).
    pub film: f64,
    /// p(X).
    pub pressure: f64,
    /// ∫ p dx.
    pub load: f64,
    /// ∫ p x dx.
    pub moment: f64,
    /// ∫ p′u dx.
    pub pressure_flow: f64,
    /// ∫ βu³p′² dx.
    pub dissipation: f64,
    /// ∫ dx/(βu).
    pub shear: f64,
    /// dp(X)/dX at fixed g.
    pub gradient: f64,
}

impl Inlet {
    /// The inlet from X on, with the film u(X) there and the flow c.
    pub fn new(beta: f64, x: f64, film: f64, c: f64) -> Self {
        let g = film - 0.5 * x * x;
        let mut inlet = Self {
            start: x,
            film,
            pressure: 0.0,
            load: 0.0,
            moment: 0.0,
            pressure_flow: 0.0,
            dissipation: 0.0,
            shear: 0.0,
            gradient: 0.0,
        };
        for (t, weight) in gauss::unit_interval() {
            // everything over powers of t, so that nothing overflows: x = X/t, dx = X dt/t², u = scaled/t²
            let scaled = 0.5 * x * x + g * t * t;
            let flow = weight * x * (scaled - c * t * t) / (beta * scaled * scaled * scaled);
            inlet.pressure += flow * t * t;
            inlet.load += flow * x * (1.0 - t) * t;
            inlet.moment += flow * 0.5 * x * x * (1.0 - t * t);
            inlet.pressure_flow -= flow * scaled;
            inlet.dissipation += flow * (scaled - c * t * t);
            inlet.shear += weight * x / (beta * scaled);
        }
        inlet.gradient = -(film - c) / (beta * film * film * film);
        inlet
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::exact::RigidFilm;
    use crate::model::CavityShear;

    /// The film under a rigid cylinder is of this form everywhere: pressure ahead of X as its closed form has it.
    #[test]
    fn a_rigid_film_is_met_exactly() {
        for beta in [1e-2, 1.0] {
            let film = RigidFilm::new(beta);
            for x in [3.0, 10.0, 200.0] {
                let x = x * film.separation().sqrt();
                let inlet = Inlet::new(beta, x, film.film(x), film.c());
                assert!((inlet.pressure / film.pressure(x) - 1.0).abs() < 1e-11, "x {x}");
                let step = 1e-4 * x;
                let slope = (film.pressure(x + step) - film.pressure(x - step)) / (2.0 * step);
                assert!((inlet.gradient / slope - 1.0).abs() < 1e-6);
                let load = |a, b| gauss::integrate(a, b, |x| film.pressure(x));
                let to_far: f64 = (0..60).map(|i| load(x * 1.5_f64.powi(i), x * 1.5_f64.powi(i + 1))).sum();
                assert!((inlet.load / to_far - 1.0).abs() < 1e-9, "x {x}: {} {to_far}", inlet.load);
            }
            let start = film.outlet();
            let whole = film.friction(CavityShear::None).hydrodynamic_film;
            let x = 4.0 * film.separation().sqrt();
            let gradient = |x: f64| -(film.film(x) - film.c()) / (beta * film.film(x).powi(3));
            let shear = |x: f64| (gradient(x) * film.film(x) + 1.0 / (3.0 * beta * film.film(x))) / PI;
            let panels = 40;
            let width = (x - start) / f64::from(panels);
            let inside: f64 = (0..panels)
                .map(|i| gauss::integrate(start + width * f64::from(i), start + width * f64::from(i + 1), shear))
                .sum();
            let inlet = Inlet::new(beta, x, film.film(x), film.c());
            let sum = inside + (inlet.pressure_flow + inlet.shear / 3.0) / PI;
            assert!((sum / whole - 1.0).abs() < 1e-11, "{sum} {whole}");
        }
    }
}
