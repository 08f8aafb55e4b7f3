//! Failed places and why they failed.

use serde::Serialize;

use super::contents::{AxisValue, Words};
use super::encoding::integers;
use crate::pictures::AxisWords;
use stribeck_solver::continuation::kind_name_of_text;
use stribeck_sweep::GridIndex;
use stribeck_sweep::store::{DataSet, Status};

/// Most failed places that are listed.
const MOST_LISTED: usize = 1000;
/// Most bytes of different reasons.
const MOST_BYTES: usize = 1_000_000;

/// Failed places of the whole data set, those not shown on the grid included.
#[derive(Debug, Serialize)]
pub(super) struct FailurePart {
    /// How many there are.
    count: usize,
    kinds: Vec<Kind>,
    /// Values on the three axes and the index of the kind, as far as they are listed.
    listed: Vec<(AxisValue, AxisValue, AxisValue, usize)>,
    /// Different reasons of the places shown on the grid.
    reasons: Vec<String>,
    /// For each place shown on the grid the index of its reason; −1 if it converged, or its reason is not in the page.
    reason_of: String,
}

/// Places that failed for reasons of one kind.
#[derive(Debug, Serialize)]
struct Kind {
    count: usize,
    /// The first of the reasons.
    reason: String,
    /// True if there are others.
    varied: bool,
}

impl FailurePart {
    /// The failures of a data set of which these places are shown.
    pub(super) fn of(
        data: &DataSet,
        places: &[usize],
        statuses: &[Status],
        reasons: &[String],
        notes: &mut Vec<String>,
    ) -> Self {
        let (shape, axes) = (data.shape(), AxisWords::of(data));
        let failed = (0..statuses.len()).filter(|place| statuses[*place] == Status::Failed);
        let (mut words, mut kinds, mut listed) = (Words::default(), Vec::<Kind>::new(), Vec::new());
        let mut count = 0;
        for place in failed {
            let reason = &reasons[place];
            let index = words.index(kind_name_of_text(reason));
            match kinds.get_mut(index) {
                Some(kind) => {
                    kind.count += 1;
                    kind.varied |= kind.reason != *reason;
                }
                None => kinds.push(Kind { count: 1, reason: reason.clone(), varied: false }),
            }
            if count < MOST_LISTED {
                let GridIndex { f, row, along } = shape.index(place);
                let [f, alpha, beta] = [(0, f), (1, row), (2, along)].map(|(axis, i)| axes[axis].values[i].into());
                listed.push((f, alpha, beta, index));
            }
            count += 1;
        }
        if count > MOST_LISTED {
            notes.push(format!("Of {count} failed places the first {MOST_LISTED} are listed; summary.csv has all."));
        }

        let (mut texts, mut bytes, mut left_out) = (Words::default(), 0, 0_usize);
        let reason_of: Vec<i32> = places
            .iter()
            .map(|place| {
                if statuses[*place] != Status::Failed {
                    return -1;
                }
                let reason = &reasons[*place];
                if bytes + reason.len() > MOST_BYTES && !texts.has(reason) {
                    left_out += 1;
                    return -1;
                }
                let known = texts.words.len();
                let index = texts.index(reason);
                bytes += if index == known { reason.len() } else { 0 };
                i32::try_from(index).expect("fewer reasons than 2³¹")
            })
            .collect();
        if left_out > 0 {
            notes.push(format!("The reasons of {left_out} failed places are not in this page; summary.csv has them."));
        }
        Self { count, kinds, listed, reasons: texts.words, reason_of: integers(reason_of) }
    }
}
