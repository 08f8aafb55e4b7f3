//! What a mesh that ends leaves out: the displacement that the load ahead of it adds, and how the surface beyond it
//! bends.

use std::f64::consts::PI;

use super::displacement::{Body, Displacement};
use super::inlet::Inlet;
use crate::model::kernel::retarded_log;
use crate::model::{CavityShear, Sensitivities, gauss, retarded_mode};

/// By how much friction changes, over N a₀/R, when what lies beyond the mesh is counted, to leading order in its
/// distance (T60), (T61).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Truncation {
    /// Of F_v: what the pressure on the mesh and that ahead of it do to each other.
    pub viscoelastic: f64,
    /// The parts of the flat and of the roller in that, each with its derivative with respect to ln α of the body.
    of_bodies: [[f64; 2]; 2],
    /// Of P: the film ahead, which the contact displaces.
    pub pressure: f64,
    /// Of C: the same, and that of the gap far behind.
    pub shear: f64,
    /// Of the centroid: the load ahead tilts the surface, and the outlet moves.
    pub centroid: f64,
}

impl Truncation {
    /// What the mesh of a displacement leaves out, with the inlet ahead of it.
    pub fn new(displacement: &Displacement, beta: f64, inlet: &Inlet, cavity_shear: CavityShear) -> Self {
        let start = inlet.start;
        let kernel = |x: f64| {
            let retarded =
                displacement.filters.iter().map(|(weight, filter)| weight * retarded_mode(filter.alpha(), x));
            displacement.elastic_weight * x.abs().ln() + retarded.sum::<f64>()
        };
        // the slope of a body's retarded part of the kernel, and its derivative with respect to ln α, by S′ = S − 1/z
        // (T11)
        let slope = |body: Body, x: f64| -> [f64; 2] {
            let terms = displacement.filters[displacement.modes(body)].iter().map(|(weight, filter)| {
                let (rate, z) = (weight * filter.alpha(), filter.alpha() * x);
                let s = retarded_log(z);
                [rate * s, rate * (s + z * s - 1.0)]
            });
            terms.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d])
        };
        let (at_start, at_end) = (kernel(start), kernel(-start));
        let mut truncation = Self::default();
        let far = 1.0 / (PI * beta * start.powi(3));
        for (t, weight) in gauss::unit_interval() {
            let x = start / t;
            // p falls as x⁻³
            let load = weight * t * inlet.pressure * start / PI;
            let mut behind = 0.0;
            for (body, sums) in Body::BOTH.into_iter().zip(&mut truncation.of_bodies) {
                let (before, after) = (slope(body, x), slope(body, -x));
                behind += after[0];
                for ((sum, before), after) in sums.iter_mut().zip(before).zip(after) {
                    *sum += load * (before + after);
                }
            }
            truncation.centroid += load * (behind - displacement.elastic_weight / x);
            // half the load in w = K/2 of a load π/2, and u = x²/2
            let bent = 0.5 * weight * (kernel(x) - at_start);
            truncation.pressure -= 4.0 * far * t * t * bent;
            truncation.shear += 4.0 / 3.0 * far * t * t * bent;
            truncation.centroid += 16.0 * far * t * t * (1.0 - t * t) * bent;
            if cavity_shear == CavityShear::Full {
                truncation.shear += 2.0 / 3.0 * far * t * t * weight * (kernel(-x) - at_end);
            }
        }
        let [flat, roller] = truncation.of_bodies;
        Self { viscoelastic: flat[0] + roller[0], ..truncation }
    }

    /// How much of the derivatives of friction lies beyond the mesh. That goes as 1/β, and with the parameters
    /// of the substrate no faster than in proportion but for F_v, which changes its sign with α.
    pub fn of_sensitivities(&self) -> Sensitivities {
        let film = self.pressure.abs() + self.shear.abs();
        let [flat, roller] = self.of_bodies.map(|of_body| of_body.map(f64::abs));
        Sensitivities {
            viscoelastic_flat: [flat[1], flat[0], flat[0], 0.0, flat[0]],
            viscoelastic_roller: [0.0, roller[0], roller[0], roller[1], roller[0]],
            hydrodynamic: [film; 5],
            pressure: [self.pressure.abs(); 5],
        }
    }
}
