//! From what the solver gives to what the store keeps.

use std::panic::catch_unwind;

use super::solve_command;
use crate::Plan;
use crate::store::{CaseEntry, Status, Timing};
use stribeck_solver::continuation::{Cut, Effort};
use stribeck_solver::{Failure, Fields, Limits, Output, Parameters, SolvedCase, exact};

/// Makes what the store keeps of a solved case of a plan.
pub fn case_entry(plan: &Plan, parameters: &Parameters, case: SolvedCase) -> CaseEntry {
    let Effort { iterations, factorisations, seconds, .. } = case.effort;
    let time_limit = match case.cut {
        Some(Cut::TimeLimit(limit)) => Some(limit.as_secs_f64()),
        Some(Cut::Panic) | None => None,
    };
    let timing = Timing { seconds, iterations, factorisations, seed: case.seed.to_string(), time_limit };
    let (outcome, reason, values, fields, sensitivities) = match case.outcome {
        Ok(solution) => {
            let values = solution.quantities.row(&solution.errors, &case.limits);
            (Status::Converged, String::new(), values, solution.fields, solution.sensitivities)
        }
        Err(Failure { mut reason, .. }) => {
            if case.cut == Some(Cut::Panic) {
                reason += &format!("; please report it with `{}`", solve_command(plan.recipe(), parameters));
            }
            (Status::Failed, reason, case.limits.failed_row(), Fields::default(), None)
        }
    };
    CaseEntry { id: plan.id(parameters), outcome, reason, values, fields, sensitivities, timing }
}

/// Makes failed cases of a chain whose thread panicked outside of its solver: a panic of a solver fails its own case alone.
pub(super) fn panicked(cases: &[Parameters], output: &Output, message: &str) -> Vec<SolvedCase> {
    let reason = format!("the solver of its chain panicked: {message}");
    let failed = |parameters: &Parameters| {
        let limits = output.limits.then(|| catch_unwind(|| exact::limits(parameters)).ok()).flatten();
        let failed = SolvedCase::failed(Failure::new(reason.clone()), limits.unwrap_or(Limits::UNKNOWN));
        SolvedCase { cut: Some(Cut::Panic), ..failed }
    };
    cases.iter().map(failed).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Sweep;
    use crate::store::Store;
    use stribeck_solver::COLUMNS;

    #[test]
    fn cases_of_a_panic_can_be_stored_with_their_limits_and_the_command_that_repeats_them() {
        let text = "[axes]\nf = [10.0]\nalpha = [1.0]\nbeta = [100.0, 200.0]\n";
        let sweep = Sweep::parse("panic", text).expect("valid");
        let plan = Plan::new(&sweep);
        let cases = plan.parameters(&plan.chain(0));
        let entries: Vec<_> = panicked(&cases, &sweep.output, "index out of bounds")
            .into_iter()
            .zip(&cases)
            .map(|(case, parameters)| case_entry(&plan, parameters, case))
            .collect();
        for (entry, parameters) in entries.iter().zip(&cases) {
            let beta = parameters.beta;
            let expected = format!(
                "the solver of its chain panicked: index out of bounds; please report it with `stribeck solve --f 10 --alpha 1 \
                 --beta {beta} --method collocation --tolerance 1e-5 --cavity-shear full`"
            );
            assert_eq!(entry.reason, expected);
            let dry = COLUMNS.iter().position(|column| column.name == "dry_mu_v").expect("a column");
            assert_eq!(entry.values[dry], exact::limits(parameters).dry_mu_v);
        }
        let directory = tempfile::tempdir().expect("a temporary directory");
        let mut store = Store::open(directory.path(), "", &sweep.output).expect("opened");
        store.commit(&entries).expect("committed");
        assert_eq!(store.holds(plan.id(&cases[1])), Some(Status::Failed));
    }
}
