//! How the film ahead of the mesh changes with where it begins, with the flow, and with its gap.

use super::inlet::Inlet;
use crate::model::gauss;

/// Derivatives of the integrals of an [`Inlet`] with respect to one of the numbers that define it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InletPartial {
    /// Derivative of p(X).
    pub pressure: f64,
    /// Derivative of ∫ p dx.
    pub load: f64,
    /// Derivative of ∫ p′u dx.
    pub pressure_flow: f64,
    /// Derivative of ∫ dx/(βu).
    pub shear: f64,
}

/// Derivatives of an [`Inlet`] of the film u = x²/2 + g.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InletPartials {
    /// With respect to X, at fixed g.
    pub start: InletPartial,
    /// With respect to c.
    pub c: InletPartial,
    /// With respect to g.
    pub gap: InletPartial,
}

impl InletPartials {
    /// The derivatives of an inlet with the flow c, of (T33) under the integral.
    pub fn new(inlet: &Inlet, beta: f64, c: f64) -> Self {
        let (x, film) = (inlet.start, inlet.film);
        let g = film - 0.5 * x * x;
        let start = InletPartial {
            pressure: inlet.gradient,
            load: -inlet.pressure,
            pressure_flow: -inlet.gradient * film,
            shear: -(beta * film).recip(),
        };
        let mut partials = Self { start, c: InletPartial::default(), gap: InletPartial::default() };
        for (t, weight) in gauss::unit_interval() {
            // as for the integrals themselves, u = scaled/t²
            let scaled = 0.5 * x * x + g * t * t;
            let unit = weight * x / (beta * scaled * scaled * scaled);
            let excess = scaled - c * t * t;
            let by_c = -unit * t * t;
            let by_gap = unit * t * t * (1.0 - 3.0 * excess / scaled);
            for (partial, flow) in [(&mut partials.c, by_c), (&mut partials.gap, by_gap)] {
                partial.pressure += flow * t * t;
                partial.load += flow * x * (1.0 - t) * t;
                partial.pressure_flow -= flow * scaled;
            }
            partials.gap.pressure_flow -= unit * excess * t * t;
            partials.gap.shear -= unit * scaled * t * t;
        }
        partials
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn partials_are_derivatives_of_the_integrals() {
        let (beta, x, g, c) = (3.0, 4.0, -2.5, 0.4);
        let inlet = |x: f64, g: f64, c: f64| Inlet::new(beta, x, 0.5 * x * x + g, c);
        let partials = InletPartials::new(&inlet(x, g, c), beta, c);
        let step = 1e-4;
        let pairs = [
            (partials.start, inlet(x + step, g, c), inlet(x - step, g, c)),
            (partials.c, inlet(x, g, c + step), inlet(x, g, c - step)),
            (partials.gap, inlet(x, g + step, c), inlet(x, g - step, c)),
        ];
        for (place, (partial, above, below)) in pairs.into_iter().enumerate() {
            let numbers = [
                (partial.pressure, above.pressure, below.pressure),
                (partial.load, above.load, below.load),
                (partial.pressure_flow, above.pressure_flow, below.pressure_flow),
                (partial.shear, above.shear, below.shear),
            ];
            for (derivative, above, below) in numbers {
                let difference = (above - below) / (2.0 * step);
                assert!((derivative - difference).abs() < 1e-7 * above.abs(), "{place}: {derivative:e} {difference:e}");
            }
        }
    }
}
