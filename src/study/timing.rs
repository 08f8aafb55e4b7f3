//! Error against run time: solving cases again and again by every variant.

use super::run::Session;
use super::variant::guarded;
use super::{Study, Variant};
use stribeck_solver::{Interrupted, Parameters, SolvedCase};

/// The work of one variant on one case.
#[derive(Clone, Debug)]
pub(super) struct Timed {
    /// The solution of the first repeat; the others give the same.
    pub solved: SolvedCase,
    /// Seconds of all repeats.
    pub seconds: Vec<f64>,
    /// The most bytes in use at once for the chain that the case belongs to.
    pub peak_bytes: u64,
}

impl Session<'_> {
    /// Solves the cases of a chain by every variant, over and over: `[variant][case]`.
    ///
    /// The variants take turns, so that all share what else the machine does in the meantime. Each repeat has a
    /// solver of its own, which holds nothing of other cases. Memory is that of the first repeat.
    pub(super) fn time(&self, cases: &[Parameters]) -> Result<Vec<Vec<Timed>>, Interrupted> {
        let Study { variants, repeats, .. } = self.study;
        let solve = |variant: &Variant| {
            let solver = variant.setting.solver();
            guarded(cases, || solver.solve(cases, &self.output, self.interrupt))
        };
        let mut found = Vec::with_capacity(variants.len());
        for variant in variants {
            let mut solved = Ok(Vec::new());
            let peak_bytes = (self.meter)(&mut || solved = solve(variant));
            let timed = |solved: SolvedCase| Timed { seconds: vec![solved.effort.seconds], solved, peak_bytes };
            found.push(solved?.into_iter().map(timed).collect::<Vec<_>>());
        }
        for _ in 1..*repeats {
            for (variant, found) in variants.iter().zip(&mut found) {
                for (again, timed) in solve(variant)?.iter().zip(found) {
                    timed.seconds.push(again.effort.seconds);
                }
            }
        }
        Ok(found)
    }
}
