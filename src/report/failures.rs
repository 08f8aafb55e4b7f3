//! Failed places and why they failed.

use serde::Serialize;

use super::axis::AxisValue;
use super::encoding::integers;
use super::texts::Texts;
use crate::pictures::AxisWords;
use stribeck_solver::continuation::kind_name_of_text;
use stribeck_sweep::GridIndex;
use stribeck_sweep::store::{DataSet, Status};

/// Most failed places that are listed.
const MOST_LISTED: usize = 1000;
/// Most bytes of different reasons.
const MOST_BYTES: usize = 1_000_000;

/// The failed places of the whole data set, those not shown on the grid included.
#[derive(Debug, Serialize)]
pub(super) struct FailurePart {
    #[serde(flatten)]
    list: FailureList,
    #[serde(flatten)]
    reasons: ReasonPart,
}

/// The failed places, with what kinds of reasons they have.
#[derive(Debug, Default, Serialize)]
struct FailureList {
    /// How many there are.
    count: usize,
    kinds: Vec<Kind>,
    /// Values on the three axes and the index of the kind, as far as they are listed.
    listed: Vec<([AxisValue; 3], usize)>,
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

/// The reasons of the places shown on the grid.
#[derive(Debug, Serialize)]
struct ReasonPart {
    /// Different reasons.
    reasons: Vec<String>,
    /// For each place the index of its reason; −1 if it converged, or its reason is not in the page.
    reason_of: String,
}

impl FailurePart {
    /// The failures of a data set of which these places are shown. Notes say what is left out.
    pub(super) fn of(
        data: &DataSet,
        places: &[usize],
        statuses: &[Status],
        reasons: &[String],
        notes: &mut Vec<String>,
    ) -> Self {
        // By place; none where a case converged.
        let reason = |place: usize| (statuses[place] == Status::Failed).then(|| reasons[place].as_str());
        let failed = (0..statuses.len()).filter_map(|place| Some((place, reason(place)?)));
        Self {
            list: FailureList::of(data, failed, notes),
            reasons: ReasonPart::of(places.iter().map(|place| reason(*place)), notes),
        }
    }
}

impl FailureList {
    fn of<'a>(data: &DataSet, failed: impl Iterator<Item = (usize, &'a str)>, notes: &mut Vec<String>) -> Self {
        let (shape, axes) = (data.shape(), AxisWords::of(data, &[]));
        let (mut kinds, mut list) = (Texts::default(), Self::default());
        for (place, reason) in failed {
            let index = kinds.index(kind_name_of_text(reason));
            match list.kinds.get_mut(index) {
                Some(kind) => {
                    kind.count += 1;
                    kind.varied |= kind.reason != *reason;
                }
                None => list.kinds.push(Kind { count: 1, reason: reason.to_owned(), varied: false }),
            }
            if list.count < MOST_LISTED {
                let GridIndex { block, row, along } = shape.index(place);
                let values = [(0, block), (1, row), (2, along)].map(|(axis, index)| axes[axis].values[index].into());
                list.listed.push((values, index));
            }
            list.count += 1;
        }
        if list.count > MOST_LISTED {
            let count = list.count;
            notes.push(format!("Of {count} failed places the first {MOST_LISTED} are listed; summary.csv has all."));
        }
        list
    }
}

impl ReasonPart {
    /// The reasons of places in their order, none for a place that converged.
    fn of<'a>(places: impl Iterator<Item = Option<&'a str>>, notes: &mut Vec<String>) -> Self {
        let (mut texts, mut bytes, mut left_out) = (Texts::default(), 0, 0_usize);
        let mut index = |reason: &str| {
            if !texts.has(reason) {
                if bytes + reason.len() > MOST_BYTES {
                    left_out += 1;
                    return -1;
                }
                bytes += reason.len();
            }
            i32::try_from(texts.index(reason)).expect("fewer reasons than 2³¹")
        };
        let reason_of: Vec<i32> = places.map(|reason| reason.map_or(-1, &mut index)).collect();
        if left_out > 0 {
            notes.push(format!("The reasons of {left_out} failed places are not in this page; summary.csv has them."));
        }
        Self { reasons: texts.texts, reason_of: integers(reason_of) }
    }
}
