//! The fields of the cases, thinned to what a page can hold.

use std::collections::BTreeMap;

use serde::Serialize;

use super::encoding::{Quantised, floats, integers, shorts};
use super::thinning::{deviation, shape_points};
use stribeck_sweep::Field;
use stribeck_sweep::store::{DataSet, Status, StoreError};

/// Bytes that all fields together may take in the page.
const BUDGET: usize = 6_000_000;
/// Fewer points than this show no shape.
const FEWEST_POINTS: usize = 48;

/// The fields of a page. Each case has points of its own, the same for all its fields.
#[derive(Debug, Serialize)]
pub(super) struct FieldsPart {
    /// All x of the data set.
    x: String,
    /// How many points a case has.
    points: usize,
    /// For each case of the page its place among those with fields, −1 if it has none.
    slots: String,
    /// For each case with fields the indices of its points in x.
    indices: String,
    /// The fields by name.
    fields: BTreeMap<&'static str, FieldPart>,
}

/// One field of all cases that have fields.
#[derive(Debug, Serialize)]
struct FieldPart {
    low: String,
    high: String,
    logarithmic: Vec<u8>,
    steps: String,
}

/// One field before it is encoded: for each case its lowest and highest number and their kind, then all steps.
#[derive(Clone, Debug, Default)]
struct Steps {
    low: Vec<f64>,
    high: Vec<f64>,
    logarithmic: Vec<u8>,
    steps: Vec<u16>,
}

/// What a case of the page is: where it first stands in the data set, and what became of it.
pub(super) struct CasePlace {
    pub(super) indices: [usize; 3],
    pub(super) status: Status,
}

/// The fields of these cases, and what was left out, in words; `None` if the data set has none.
pub(super) fn fields(
    data: &DataSet,
    cases: &[CasePlace],
    notes: &mut Vec<String>,
) -> Result<Option<FieldsPart>, StoreError> {
    if data.fields.is_empty() {
        return Ok(None);
    }
    let solved: Vec<usize> = (0..cases.len()).filter(|i| cases[*i].status == Status::Converged).collect();
    // Two bytes for a number, four characters of base64 for three bytes; the indices are as long as a field.
    let bytes = |cases: usize, points: usize| cases * points * (data.fields.len() + 1) * 2 * 4 / 3;
    let every = (1..).find(|every| bytes(solved.len().div_ceil(*every), FEWEST_POINTS) <= BUDGET).expect("none fits");
    let kept: Vec<usize> = solved.iter().copied().step_by(every).collect();
    let points = (FEWEST_POINTS..).take_while(|points| bytes(kept.len(), *points) <= BUDGET && *points <= data.x.len());
    let points = points.last().unwrap_or(FEWEST_POINTS).min(data.x.len());
    if every > 1 {
        notes.push(format!(
            "Fields are here for {} of {} solved cases, one in {every}; where they are not, those of the nearest case stand, with \
             its name. `stribeck plot DIR --what profiles` draws any other.",
            kept.len(),
            solved.len()
        ));
    }

    let mut slots = vec![-1; cases.len()];
    let mut indices: Vec<u16> = Vec::with_capacity(kept.len() * points);
    let mut parts = vec![Steps::default(); data.fields.len()];
    let mut worst = 0.0_f64;
    for (slot, case) in (0..).zip(&kept) {
        slots[*case] = slot;
        let read = |field: &Field| data.field(*field, cases[*case].indices);
        let values = data.fields.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let chosen = shape_points(&values, &data.x, points);
        for (part, values) in parts.iter_mut().zip(&values) {
            worst = worst.max(deviation(&data.x, values, &chosen));
            let shown: Vec<f64> = chosen.iter().map(|i| values[*i]).collect();
            let Quantised { low, high, logarithmic, steps } = Quantised::of(&shown);
            part.low.push(low);
            part.high.push(high);
            part.logarithmic.push(u8::from(logarithmic));
            part.steps.extend(steps);
        }
        indices.extend(chosen.iter().map(|i| u16::try_from(*i).expect("a sweep has fewer x than 65536")));
    }
    if points < data.x.len() {
        notes.push(format!(
            "Fields are shown at {points} of their {} points, those that show the shape of each case best, to 16 bits of their \
             range. Lines through them are off by at most {:.1} % of that range, of its logarithm where a film spans more than \
             a decade; results.h5 has all.",
            data.x.len(),
            100.0 * worst
        ));
    }
    let part = |Steps { low, high, logarithmic, steps }| FieldPart {
        low: floats(low),
        high: floats(high),
        logarithmic,
        steps: shorts(steps),
    };
    Ok(Some(FieldsPart {
        x: floats(data.x.iter().copied()),
        points,
        slots: integers(slots),
        indices: shorts(indices),
        fields: data.fields.iter().map(|field| field.name()).zip(parts.into_iter().map(part)).collect(),
    }))
}
