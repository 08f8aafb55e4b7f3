//! Estimated error against seconds of each case.

use std::collections::HashSet;

use super::maps::largest_errors;
use super::picture::{Chart, Picture};
use super::request::{Kind, Request, Selection};
use super::sweep_data::SweepData;
use super::table::Table;
use super::{Axis, PictureError};
use stribeck_charts::{MethodLine, Outcome, SettingPoint, WorkPrecision};
use stribeck_sweep::store::Status;

/// Each case once, however often it stands in the sweep; a line for each f.
pub(super) fn cost(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let Some(costs) = sweep.data.costs()? else {
        return Err(Kind::Cost.missing("the directory has no timings.csv; run the sweep again, which publishes it"));
    };
    let selection = Selection::of(sweep, request)?;
    let (statuses, errors) = (sweep.data.statuses()?, largest_errors(sweep)?);
    let mut table = Table::new(&[&["case", "status"], &sweep.coordinate_names()[..], &["seconds", "error"]].concat());
    let mut seen = HashSet::new();
    let mut lines = Vec::new();
    for i_f in selection.on(Axis::F) {
        let mut cases = Vec::new();
        for i_alpha in selection.on(Axis::Middle) {
            for i_beta in selection.on(Axis::Inner) {
                let indices = [*i_f, *i_alpha, *i_beta];
                let place = sweep.data.place(indices);
                let cost = &costs[place];
                if !seen.insert(&cost.case) {
                    continue;
                }
                let outcome = match statuses[place] {
                    Status::Failed => Outcome::Failed,
                    Status::Converged if errors[place].is_nan() => Outcome::Unknown,
                    Status::Converged => Outcome::Error(errors[place]),
                };
                let numbers = [&sweep.coordinates(indices)[..], &[cost.seconds, errors[place]]].concat();
                table.row(&[&cost.case, statuses[place].name()], &numbers);
                // A clock may not tell the shortest cases from nothing.
                cases.push((cost.seconds.max(1e-9), outcome));
            }
        }
        if !cases.is_empty() {
            let points = vec![SettingPoint { label: format!("{} cases", cases.len()), cases }];
            lines.push(MethodLine { label: sweep.words(Axis::F, *i_f), points });
        }
    }
    let chart = WorkPrecision {
        title: sweep.data.title.clone(),
        subtitle: "each case once; large markers: medians".to_owned(),
        x_label: "seconds for a case".to_owned(),
        y_label: "largest estimated error of μᵥ, μₕ, μ_{drag} and c".to_owned(),
        lines,
    };
    Ok(vec![Picture { name: "cost".to_owned(), chart: Chart::WorkPrecision(chart), table }])
}
