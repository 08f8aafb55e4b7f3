//! From what the solver gives to what the store keeps.

use std::panic::catch_unwind;

use crate::continuation::{Effort, Path, Seed, SolvedCase};
use crate::exact;
use crate::model::{CaseId, Failure, Fields, Limits, Output, Parameters};
use crate::store::{CaseEntry, Status, Timing};

/// A solved case with its id.
pub fn case_entry(id: CaseId, case: SolvedCase) -> CaseEntry {
    let Effort { iterations, factorisations, seconds, .. } = case.effort;
    let timing = Timing { seconds, iterations, factorisations, seed: case.seed.to_string() };
    let (outcome, reason, values, fields) = match case.outcome {
        Ok(solution) => {
            let values = solution.quantities.row(&solution.errors, &case.limits);
            (Status::Converged, String::new(), values, solution.fields)
        }
        Err(failure) => (Status::Failed, failure.reason, case.limits.failed_row(), Fields::default()),
    };
    CaseEntry { id, outcome, reason, values, fields, timing }
}

/// The cases of a chain whose solver panicked.
pub fn panicked(cases: &[Parameters], output: &Output, message: &str) -> Vec<SolvedCase> {
    let reason = format!("the solver panicked: {}; please report it", one_line(message));
    let failed = |parameters: &Parameters| {
        let limits = output.limits.then(|| catch_unwind(|| exact::limits(parameters)).ok()).flatten();
        SolvedCase {
            outcome: Err(Failure::new(reason.clone())),
            limits: limits.unwrap_or(Limits::UNKNOWN),
            seed: Seed::None,
            path: Path::default(),
            effort: Effort::default(),
        }
    };
    cases.iter().map(failed).collect()
}

/// The words of a text, without line feeds and other control characters.
fn one_line(text: &str) -> String {
    let words: Vec<&str> =
        text.split(|c: char| c.is_control() || c.is_whitespace()).filter(|w| !w.is_empty()).collect();
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::COLUMNS;
    use crate::store::Store;

    #[test]
    fn cases_of_a_panic_can_be_stored_with_their_limits() {
        let output = Output::default();
        let cases = [Parameters::new(1.0, 100.0, 10.0), Parameters::new(1.0, 200.0, 10.0)];
        let entries: Vec<_> = (1..)
            .zip(panicked(&cases, &output, "index out of bounds:\n\tthe len is 3\u{7}"))
            .map(|(id, case)| case_entry(CaseId(id), case))
            .collect();
        for (entry, parameters) in entries.iter().zip(&cases) {
            assert_eq!(entry.reason, "the solver panicked: index out of bounds: the len is 3; please report it");
            let dry = COLUMNS.iter().position(|column| column.name == "dry_mu_v").expect("a column");
            assert_eq!(entry.values[dry], exact::limits(parameters).dry_mu_v);
        }
        let directory = tempfile::tempdir().expect("a temporary directory");
        let mut store = Store::open(directory.path(), "", &output).expect("opened");
        store.commit(&entries).expect("committed");
        assert_eq!(store.holds(CaseId(2)), Some(Status::Failed));
    }
}
