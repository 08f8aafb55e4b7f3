//! From the sources of error of a solution to an estimate for each of its numbers.

use super::parts::Spread;
use super::truncation::Truncation;
use crate::model::{Quantities, RelativeErrors};

/// Rounding errors of the flow c and of what depends on it, of order 1 with c = 1; two meshes may happen to have the
/// same ones.
pub const ROUNDING: f64 = 5e-17;
/// What counts of the differences panel by panel, beside that of the whole. Errors of panels may cancel on both
/// degrees, and on the richer one in another way than in the truth.
const OF_SPREAD: f64 = 0.5;
/// The same for the largest pressure, which lies on one panel, of the largest change of the pressure there, and of the
/// remainder, which is that of thin films; and what counts of its own change: it is published as the richer panels have
/// it.
const OF_LOAD: f64 = 0.3;
const OF_BESIDE_LARGEST: f64 = 0.01;
const OF_REMAINDER: f64 = 0.05;
const OF_LARGEST: f64 = 0.9;

/// What counts of the largest change of the film beside its minimum: the minimum itself may change little by accident.
const OF_BESIDE: f64 = 0.2;

/// What is known of the errors of a solution.
pub struct Sources {
    /// Differences to richer panels, panel by panel.
    pub spread: Spread,
    /// What lies beyond the mesh.
    pub cut: Truncation,
    /// The largest relative change of the film on the panel where it is thinnest.
    pub beside_thinnest: f64,
    /// The largest change of the pressure on the panel where it is largest, over the largest.
    pub beside_largest: f64,
    /// What Newton's method leaves on the richer panels, relative to film and pressure.
    pub remainder: f64,
}

impl Sources {
    /// The estimated errors of a solution from its numbers and those on richer panels: for each number the magnitudes
    /// of all sources are added, so that it is a bound for that number as far as the sources are known.
    pub fn errors(&self, solution: &Quantities, richer: &Quantities) -> RelativeErrors {
        let Self { spread, cut, beside_thinnest, beside_largest, remainder } = self;
        let (before, after) = (&solution.friction, &richer.friction);
        let shear_scale = before.shear();
        let rounding = ROUNDING / solution.c;
        let of_shear = OF_SPREAD * spread.shear + rounding * shear_scale;
        let of_pressure = OF_SPREAD * spread.pressure + rounding * before.pressure.abs();
        let of_hysteresis = OF_SPREAD * spread.viscoelastic;
        let pressure = (after.pressure - before.pressure).abs() + of_pressure + cut.pressure.abs();
        let shear = (after.shear() - before.shear()).abs() + of_shear + cut.shear.abs();
        let hysteresis = (after.viscoelastic - before.viscoelastic).abs() + of_hysteresis + cut.viscoelastic.abs();
        let film = of_pressure + of_shear + cut.pressure.abs() + cut.shear.abs();
        let hydrodynamic = (after.hydrodynamic() - before.hydrodynamic()).abs() + film;
        let drag = (after.drag - before.drag).abs() + film + of_hysteresis + cut.centroid.abs();
        let change = |of: fn(&Quantities) -> f64| (of(richer) / of(solution) - 1.0).abs();
        RelativeErrors {
            mu_v: hysteresis / before.viscoelastic_error_scale(),
            mu_h: hydrodynamic / before.hydrodynamic(),
            c: change(|numbers| numbers.c) + of_shear / shear_scale + remainder,
            drag: drag / before.drag,
            pressure: pressure / before.pressure.abs(),
            shear: shear / shear_scale,
            film_min: change(|numbers| numbers.film_min)
                + 2.0 * of_shear / shear_scale
                + OF_BESIDE * beside_thinnest
                + remainder,
            p_max: OF_LARGEST * change(|numbers| numbers.p_max)
                + OF_LOAD * spread.load
                + OF_BESIDE_LARGEST * beside_largest
                + OF_REMAINDER * remainder
                + 3.0 * rounding,
        }
    }

    /// The errors that the tolerance is about, as well as they are known: those of μ_v, μ_h and c by the richer panels
    /// and, with its sign, by what lies beyond the mesh.
    pub fn controlled(&self, solution: &Quantities, richer: &Quantities) -> [f64; 3] {
        let (before, after) = (&solution.friction, &richer.friction);
        let cut = self.cut_of_controlled(solution);
        [
            (after.viscoelastic - before.viscoelastic).abs() / before.viscoelastic_error_scale() + cut[0],
            (after.hydrodynamic() / before.hydrodynamic() - 1.0).abs() + cut[1],
            (richer.c / solution.c - 1.0).abs(),
        ]
    }

    /// The part of μ_v and μ_h that lies beyond the mesh, relative as their errors are.
    pub fn cut_of_controlled(&self, solution: &Quantities) -> [f64; 2] {
        let friction = &solution.friction;
        let of_film = self.cut.pressure + self.cut.shear;
        [self.cut.viscoelastic.abs() / friction.viscoelastic_error_scale(), of_film.abs() / friction.hydrodynamic()]
    }
}
