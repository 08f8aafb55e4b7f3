//! From what the solver gives to what the store keeps.

use super::solve_command;
use crate::store::{CaseEntry, Status, Timing};
use crate::{Plan, Values};
use stribeck_solver::continuation::{Effort, FailureKind};
use stribeck_solver::{Fields, Limits, Output, Parameters, SolvedCase, exact};

/// Makes what the store keeps of a solved case of a plan.
pub fn case_entry(plan: &Plan, parameters: &Parameters, case: SolvedCase) -> CaseEntry {
    let Effort { iterations, factorisations, seconds, .. } = case.effort;
    let time_limit = match case.outcome.as_ref().map_err(|failure| &failure.kind) {
        Err(FailureKind::TimeLimit(limit)) => Some(limit.as_secs_f64()),
        _ => None,
    };
    let timing = Timing { seconds, iterations, factorisations, seed: Some(case.seed), time_limit };
    let failure_kind = case.outcome.as_ref().err().map(|failure| failure.kind.name().to_owned());
    let (outcome, reason, values, fields, [sensitivities, sensitivity_errors]) = match case.outcome {
        Ok(solution) => {
            let values = Values::converged(&solution.quantities, &solution.errors, &case.limits);
            let sensitivities = [solution.sensitivities, solution.sensitivity_errors];
            (Status::Converged, String::new(), values, solution.fields, sensitivities)
        }
        Err(failure) => {
            let mut reason = failure.to_string();
            if matches!(failure.kind, FailureKind::Panic { .. } | FailureKind::ChainPanic { .. }) {
                reason += &format!("; please report it with `{}`", solve_command(plan.recipe(), parameters));
            }
            (Status::Failed, reason, Values::failed(&case.limits), Fields::default(), [None; 2])
        }
    };
    let id = plan.id(parameters);
    CaseEntry { id, outcome, reason, failure_kind, values, fields, sensitivities, sensitivity_errors, timing }
}

/// Makes failed cases of a chain whose thread panicked outside of its solver: a panic of a solver fails its own case
/// alone.
pub(super) fn panicked(cases: &[Parameters], output: &Output, message: &str) -> Vec<SolvedCase> {
    let failed = |parameters: &Parameters| {
        let limits = if output.limits { exact::limits(parameters) } else { Limits::UNKNOWN };
        SolvedCase { limits, ..SolvedCase::failed(FailureKind::ChainPanic { message: message.to_owned() }) }
    };
    cases.iter().map(failed).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::Store;
    use crate::{Column, Sweep};

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
                "the solver of its chain panicked: index out of bounds; please report it with `stribeck solve --f 10 \
                 --alpha 1 --beta {beta} --method collocation --tolerance 1e-5 --cavity-shear full`"
            );
            assert_eq!((&entry.reason, entry.failure_kind.as_deref()), (&expected, Some("panic")));
            assert_eq!(entry.values[Column::DryMuV], exact::limits(parameters).dry_mu_v);
        }
        let directory = tempfile::tempdir().expect("a temporary directory");
        let mut store = Store::open(directory.path(), "", &sweep.output).expect("opened");
        store.commit(&entries).expect("committed");
        assert_eq!(store.holds(plan.id(&cases[1])), Some(Status::Failed));
    }
}
