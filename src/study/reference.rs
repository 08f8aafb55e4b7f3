//! References: the solutions that errors are measured against.

use super::run::Session;
use super::variant::guarded;
use super::{Setting, Variant};
use stribeck_solver::collocation::Settings;
use stribeck_solver::{Interrupted, Method, Parameters, Quantities, RelativeErrors, Solution, Solver};

/// The tolerance of a reference over that of the tightest setting.
const TIGHTER: f64 = 1e-2;
/// The tolerance beside fixed panels, whose error is not known beforehand: the tightest one of the method.
const OF_PANELS: f64 = *Settings::TOLERANCE.start();
/// The tolerance beside grids, whose errors do not come near it.
const OF_GRIDS: f64 = 1e-7;
/// The loosest tolerance of a reference.
const LOOSEST: f64 = 1e-4;
/// Degrees of the panels of a reference. The first one that no variant has is taken, so that no error is common to
/// both.
const DEGREES: [usize; 3] = [12, 14, 10];

/// A collocation solution so accurate that its own error hardly counts in a comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Its numbers.
    pub quantities: Quantities,
    /// The tolerance it was solved to.
    pub tolerance: f64,
    /// Its own estimated errors.
    pub errors: RelativeErrors,
}

impl Reference {
    /// The largest of its estimated errors of μ_v, μ_h and c.
    pub fn error(&self) -> f64 {
        self.errors.largest().expect("collocation estimates its errors")
    }

    /// The errors of some numbers, in the order of [`Errors::QUANTITIES`]; `None` where they are below the
    /// reference's own errors. (The error of its smallest film is taken to be the largest of the others.)
    pub fn errors_of(&self, numbers: &Quantities) -> [Option<f64>; 4] {
        let RelativeErrors { mu_v, mu_h, c, .. } = self.errors;
        let known = [mu_v, mu_h, c, self.error()];
        let errors = Errors::between(numbers, &self.quantities).values();
        std::array::from_fn(|i| Some(errors[i]).filter(|error| *error >= known[i]))
    }
}

/// Relative differences between two solutions of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Of μ_v, relative to [`viscoelastic_error_scale`](stribeck_solver::viscoelastic_error_scale).
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
        let scale = theirs.viscoelastic_error_scale();
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

/// The settings of the references for some variants: a hundredth of the tightest tolerance, as far as the method goes.
pub fn settings(variants: &[Variant]) -> Settings {
    let tolerance = |variant: &Variant| match variant.setting {
        Setting::Tolerance(settings) => TIGHTER * settings.tolerance,
        Setting::Panels { .. } => OF_PANELS,
        Setting::Grid(_) => OF_GRIDS,
    };
    let tightest = variants.iter().map(tolerance).fold(f64::INFINITY, f64::min).max(*Settings::TOLERANCE.start());
    let taken = |degree: usize| {
        variants.iter().any(|variant| match variant.setting {
            Setting::Tolerance(settings) => settings.degree == degree,
            Setting::Panels { degree: other, .. } => other == degree,
            Setting::Grid(_) => false,
        })
    };
    let degree = DEGREES.into_iter().find(|&degree| !taken(degree)).unwrap_or(DEGREES[0]);
    Settings { tolerance: rounded(tightest), degree }
}

/// To three digits: 1e-7 and not 1.0000000000000001e-7, for people read it.
fn rounded(tolerance: f64) -> f64 {
    format!("{tolerance:.2e}").parse().expect("a number was printed")
}

impl Session<'_> {
    /// References of some cases; `Err` says why a case has none.
    ///
    /// Where a tolerance is out of reach (a film too thin for it) one ten times as large is tried, up to 1e-4.
    ///
    /// # Errors
    /// [`Interrupted`] if the user asks to stop.
    pub(super) fn references(&self, cases: &[Parameters]) -> Result<Vec<Result<Reference, String>>, Interrupted> {
        let settings = settings(&self.study.variants);
        cases.iter().map(|case| self.reference(case, settings)).collect()
    }

    fn reference(&self, case: &Parameters, settings: Settings) -> Result<Result<Reference, String>, Interrupted> {
        let case = std::slice::from_ref(case);
        let mut tolerance = settings.tolerance;
        loop {
            let method = Method::Collocation(Settings { tolerance, ..settings });
            let solver =
                Solver::new(&stribeck_solver::Settings { method, time_limit: None, output: self.output.clone() });
            let solved = guarded(case, || solver.solve_chain(case, self.interrupt))?.remove(0);
            match solved.outcome {
                Ok(Solution { quantities, errors, .. }) => return Ok(Ok(Reference { quantities, tolerance, errors })),
                Err(failure) if 10.0 * tolerance > 1.01 * LOOSEST => return Ok(Err(failure.to_string())),
                Err(_) => tolerance = rounded(10.0 * tolerance),
            }
        }
    }
}
