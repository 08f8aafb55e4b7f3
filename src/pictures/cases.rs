//! The cases whose fields are shown together: a family along one axis.

use super::request::{Kind, Request, Selection, spread};
use super::sweep_data::SweepData;
use super::{Axis, PictureError};
use stribeck_sweep::store::Status;

/// Most cases in one picture.
const MOST_CASES: usize = 7;

/// Cases along an axis, the two others fixed.
pub(super) struct Cases {
    /// The axis along which they differ.
    pub(super) varied: Axis,
    /// Their indices.
    pub(super) indices: Vec<[usize; 3]>,
    /// The axes on which they agree.
    pub(super) fixed: Vec<Axis>,
}

impl Cases {
    /// The cases asked for, or a choice: along the axis that is `preferred` if it has several values, else the one with
    /// the most, and in the middle of the others.
    ///
    /// # Errors
    /// [`PictureError`] if more than one axis has several values that were asked for, or no case was solved.
    pub(super) fn choose(
        sweep: &SweepData,
        request: &Request,
        kind: Kind,
        preferred: Axis,
    ) -> Result<Self, PictureError> {
        let selection = Selection::of(sweep, request)?;
        let asked = |axis: Axis| selection.is_asked(axis) && selection.on(axis).len() > 1;
        let several: Vec<Axis> = Axis::ALL.into_iter().filter(|axis| asked(*axis)).collect();
        let varied = match several[..] {
            [] if selection.on(preferred).len() > 1 => preferred,
            [] => *Axis::ALL.iter().max_by_key(|axis| selection.on(**axis).len()).expect("there are three"),
            [axis] => axis,
            _ => {
                return Err(kind
                    .missing("the cases of one picture differ along one axis; give several values of one axis only"));
            }
        };
        let statuses = sweep.data.statuses()?;
        let mut start = [0; 3];
        for axis in Axis::ALL {
            start[axis.dimension()] = middle(sweep, axis, selection.on(axis));
        }
        let members = selection.on(varied).iter().map(|member| {
            let mut indices = start;
            indices[varied.dimension()] = *member;
            indices
        });
        let solved: Vec<[usize; 3]> =
            members.filter(|indices| statuses[sweep.data.place(*indices)] == Status::Converged).collect();
        if solved.is_empty() {
            let fixed: Vec<Axis> = Axis::ALL.into_iter().filter(|axis| *axis != varied).collect();
            return Err(
                kind.missing(format!("no case converged at {}; choose others with --at", sweep.list(&fixed, start)))
            );
        }
        let all: Vec<usize> = (0..solved.len()).collect();
        let kept = if asked(varied) { all } else { spread(&all, MOST_CASES) };
        let indices: Vec<[usize; 3]> = kept.into_iter().map(|i| solved[i]).collect();
        let fixed = Axis::ALL.into_iter().filter(|axis| *axis != varied || indices.len() == 1).collect();
        Ok(Self { varied, indices, fixed })
    }

    /// What the cases have in common, in words.
    pub(super) fn subtitle(&self, sweep: &SweepData) -> String {
        let fixed = Some(sweep.list(&self.fixed, self.indices[0])).filter(|words| !words.is_empty());
        sweep.held().into_iter().chain(fixed).collect::<Vec<_>>().join(", ")
    }

    /// The name of a case among the others.
    pub(super) fn label(&self, sweep: &SweepData, indices: [usize; 3]) -> String {
        sweep.words(self.varied, indices[self.varied.dimension()])
    }
}

/// Where an axis is cut if nothing else is asked for: the largest f, the α nearest to 1 (where a substrate dissipates
/// most), the middle β; the middle of quantities of the laboratory.
pub(super) fn middle(sweep: &SweepData, axis: Axis, indices: &[usize]) -> usize {
    let off_one = |index: &usize| {
        let value = sweep.value(axis, *index);
        if value > 0.0 { value.ln().abs() } else { f64::INFINITY }
    };
    match axis {
        Axis::F => indices[indices.len() - 1],
        Axis::Middle if sweep.data.laboratory => indices[indices.len() / 2],
        Axis::Middle => {
            *indices.iter().min_by(|one, other| off_one(one).total_cmp(&off_one(other))).expect("not empty")
        }
        Axis::Inner => indices[indices.len() / 2],
    }
}
