//! Error against run time: solving cases again and again by every variant.

use super::variant::guarded;
use super::{Meter, Variant};
use stribeck_solver::continuation::{Interrupt, Interrupted, SolvedCase};
use stribeck_solver::{Output, Parameters};

/// What one variant did with one case.
#[derive(Clone, Debug)]
pub(super) struct Timed {
    /// What the first repeat gave; the others give the same.
    pub solved: SolvedCase,
    /// Seconds of all repeats.
    pub seconds: Vec<f64>,
    /// The most bytes that were in use at once for the chain that the case belongs to.
    pub peak_bytes: u64,
}

/// Solves the cases of a chain by every variant, over and over: `[variant][case]`.
///
/// The variants take turns, so that what else the machine does in the meantime is shared by all; each repeat has a solver
/// of its own, with nothing in it from other cases. Memory is that of the first repeat.
pub(super) fn time(
    variants: &[Variant],
    cases: &[Parameters],
    repeats: usize,
    meter: Meter<'_>,
    output: &Output,
    interrupt: &Interrupt,
) -> Result<Vec<Vec<Timed>>, Interrupted> {
    let solve = |variant: &Variant| -> Result<Vec<SolvedCase>, Interrupted> {
        let solver = variant.setting.solver();
        guarded(cases, || solver.solve(cases, output, interrupt))
    };
    let mut found = Vec::with_capacity(variants.len());
    for variant in variants {
        let mut solved = Ok(Vec::new());
        let peak_bytes = meter(&mut || solved = solve(variant));
        let timed = |solved: SolvedCase| Timed { seconds: vec![solved.effort.seconds], solved, peak_bytes };
        found.push(solved?.into_iter().map(timed).collect::<Vec<_>>());
    }
    for _ in 1..repeats {
        for (variant, found) in variants.iter().zip(&mut found) {
            for (again, timed) in solve(variant)?.iter().zip(found) {
                timed.seconds.push(again.effort.seconds);
            }
        }
    }
    Ok(found)
}
