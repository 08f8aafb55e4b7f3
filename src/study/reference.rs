//! What errors are measured against.

use crate::collocation::{CollocationSolver, Settings};
use crate::continuation::{Interrupt, Interrupted, solve_chain};
use crate::model::{Output, Parameters, Quantities};

use super::{Setting, Variant};

/// How much tighter a reference is than the tightest setting.
const TIGHTER: f64 = 1e-2;
/// Where panels are fixed the error is not known beforehand: the reference is as tight as the method can.
const OF_PANELS: f64 = *Settings::TOLERANCE.start();
/// The error of a grid does not come near this.
const OF_GRIDS: f64 = 1e-7;
/// Degree of the panels of a reference; not that of the solutions it is the reference of.
const DEGREE: usize = 12;

/// A collocation solution that is so much better than what is compared with it that its own error does not count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Its numbers.
    pub quantities: Quantities,
    /// The tolerance it was solved to.
    pub tolerance: f64,
    /// The largest of its estimated errors of μ_v, μ_h and c.
    pub error: f64,
}

/// Relative errors against a reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Of μ_v; over μ_tot/1000 where μ_v is smaller, for it vanishes on an elastic substrate.
    pub mu_v: f64,
    /// Of μ_h.
    pub mu_h: f64,
    /// Of c.
    pub c: f64,
    /// Of the smallest film thickness.
    pub film_min: f64,
}

impl Errors {
    /// Names of their columns are `error_` and these.
    pub const QUANTITIES: [&'static str; 4] = ["mu_v", "mu_h", "c", "film_min"];

    /// In the order of [`Errors::QUANTITIES`].
    pub fn values(&self) -> [f64; 4] {
        [self.mu_v, self.mu_h, self.c, self.film_min]
    }

    /// Of some numbers against better ones.
    pub fn between(numbers: &Quantities, better: &Quantities) -> Self {
        let (ours, theirs) = (&numbers.friction, &better.friction);
        let relative = |ours: f64, theirs: f64| (ours / theirs - 1.0).abs();
        let scale = theirs.viscoelastic.abs().max(1e-3 * theirs.total());
        Self {
            mu_v: (ours.viscoelastic - theirs.viscoelastic).abs() / scale,
            mu_h: relative(ours.hydrodynamic(), theirs.hydrodynamic()),
            c: relative(numbers.c, better.c),
            film_min: relative(numbers.film_min, better.film_min),
        }
    }

    /// The largest of those that a tolerance is about: μ_v, μ_h and c.
    pub fn largest(&self) -> f64 {
        [self.mu_v, self.mu_h, self.c].into_iter().fold(0.0, f64::max)
    }
}

/// The tolerance of the references of some variants: a hundredth of the tightest, as far as the method goes.
pub fn tolerance(variants: &[Variant]) -> f64 {
    let of = |variant: &Variant| match variant.setting {
        Setting::Tolerance(settings) => TIGHTER * settings.tolerance,
        Setting::Panels { .. } => OF_PANELS,
        Setting::Grid(_) => OF_GRIDS,
    };
    let tightest = variants.iter().map(of).fold(f64::INFINITY, f64::min).max(*Settings::TOLERANCE.start());
    // 1e-7 and not 1.0000000000000001e-7, for people read it
    format!("{tightest:.2e}").parse().expect("a number was printed")
}

/// References of some cases. Where a tolerance is out of reach (a film too thin for it) one ten times as large is tried, up to
/// 1e-4; `Err` says why there is none at all.
///
/// # Errors
/// [`Interrupted`] if the user asks to stop.
pub fn references(
    cases: &[Parameters],
    tolerance: f64,
    output: &Output,
    interrupt: &Interrupt,
) -> Result<Vec<Result<Reference, String>>, Interrupted> {
    const LOOSEST: f64 = 1e-4;
    let mut found = Vec::with_capacity(cases.len());
    for case in cases {
        let mut wanted = tolerance;
        found.push(loop {
            let solver = CollocationSolver::new(Settings { tolerance: wanted, degree: DEGREE });
            let solved = solve_chain(&solver, std::slice::from_ref(case), output, interrupt)?.remove(0);
            match solved.outcome {
                Ok(solution) => {
                    let errors = solution.errors;
                    let error = [errors.mu_v, errors.mu_h, errors.c].into_iter().fold(0.0, f64::max);
                    break Ok(Reference { quantities: solution.quantities, tolerance: wanted, error });
                }
                Err(failure) if 10.0 * wanted > LOOSEST => break Err(failure.reason),
                Err(_) => wanted *= 10.0,
            }
        });
    }
    Ok(found)
}
