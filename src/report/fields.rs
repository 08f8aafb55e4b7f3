//! The fields of the cases, thinned to what a page can hold.

use std::collections::BTreeMap;

use serde::Serialize;

use super::encoding::{floats, integers, shorts, step};
use super::scaled::Scaled;
use super::thinning::{deviation, shape_points};
use crate::pictures::Quantity;
use stribeck_lab::si_units;
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
    /// What pictures call it.
    words: String,
    units: &'static str,
    /// For each case the lowest and the highest number; their decimal logarithms if the third is 1.
    low: String,
    high: String,
    logarithmic: Vec<u8>,
    /// For each point of each case where its number lies between these two, in steps of 16 bits.
    steps: String,
}

/// A case of the page: where it first stands in the data set, and what became of it.
pub(super) struct CasePlace {
    pub(super) indices: [usize; 3],
    pub(super) status: Status,
}

impl FieldsPart {
    /// The fields of these cases; `None` if the data set has none. Notes say what is left out.
    pub(super) fn of(data: &DataSet, cases: &[CasePlace], notes: &mut Vec<String>) -> Result<Option<Self>, StoreError> {
        if data.fields.is_empty() {
            return Ok(None);
        }
        let solved: Vec<usize> = (0..cases.len()).filter(|i| cases[*i].status == Status::Converged).collect();
        let Room { every, points } = Room::of(data, solved.len());
        let kept: Vec<usize> = solved.iter().copied().step_by(every).collect();
        if every > 1 {
            notes.push(format!(
                "Fields are here for {} of {} solved cases, one in {every}; where they are not, those of the nearest \
                 case stand, with its name. `stribeck plot DIR --what profiles` draws any other.",
                kept.len(),
                solved.len()
            ));
        }
        let mut thinned = Thinned { steps: vec![Steps::default(); data.fields.len()], ..Thinned::default() };
        let mut slots = vec![-1; cases.len()];
        for (slot, case) in (0..).zip(kept) {
            slots[case] = slot;
            thinned.add(data, cases[case].indices, points)?;
        }
        if points < data.x.len() {
            notes.push(format!(
                "Fields are shown at {points} of their {} points, those that show the shape of each case best, to 16 \
                 bits of their range. Lines through them are off by at most {:.1} % of that range, of its logarithm \
                 where a film spans more than a decade; results.h5 has all.",
                data.x.len(),
                100.0 * thinned.worst
            ));
        }
        Ok(Some(Self {
            x: floats(data.x.iter().copied()),
            points,
            slots: integers(slots),
            indices: shorts(thinned.indices),
            fields: data
                .fields
                .iter()
                .zip(thinned.steps)
                .map(|(field, steps)| (field.name(), FieldPart::of(data, *field, steps)))
                .collect(),
        }))
    }
}

/// What fits into the budget: one in `every` solved case, with so many points.
struct Room {
    every: usize,
    points: usize,
}

impl Room {
    fn of(data: &DataSet, solved: usize) -> Self {
        // Two bytes for a number, four characters of base64 for three bytes; the indices are as long as a field.
        let bytes = |cases: usize, points: usize| cases * points * (data.fields.len() + 1) * 2 * 4 / 3;
        let fits = |cases: usize, points: usize| bytes(cases, points) <= BUDGET;
        let every = (1..).find(|every| fits(solved.div_ceil(*every), FEWEST_POINTS)).expect("none fits");
        let kept = solved.div_ceil(every);
        let points = (FEWEST_POINTS..).take_while(|points| fits(kept, *points) && *points <= data.x.len());
        Self { every, points: points.last().unwrap_or(FEWEST_POINTS).min(data.x.len()) }
    }
}

/// The fields of some cases, one case behind the other, before they are encoded.
#[derive(Default)]
struct Thinned {
    /// Indices in x.
    indices: Vec<u16>,
    /// One for each field.
    steps: Vec<Steps>,
    /// How far lines through the points are from a field at most, over its range.
    worst: f64,
}

/// One field: for each case its lowest and highest number and their kind, then all steps.
#[derive(Clone, Default)]
struct Steps {
    low: Vec<f64>,
    high: Vec<f64>,
    logarithmic: Vec<u8>,
    steps: Vec<u16>,
}

impl Thinned {
    /// Adds the case that stands here in the data set, at its best points.
    fn add(&mut self, data: &DataSet, case: [usize; 3], points: usize) -> Result<(), StoreError> {
        let fields = data.fields.iter().map(|field| data.field(*field, case)).collect::<Result<Vec<_>, _>>()?;
        let chosen = shape_points(&fields, &data.x, points);
        for (part, values) in self.steps.iter_mut().zip(&fields) {
            self.worst = self.worst.max(deviation(&data.x, values, &chosen));
            let shown: Vec<f64> = chosen.iter().map(|i| values[*i]).collect();
            let Scaled { low, high, logarithmic, shares } = Scaled::of(&shown);
            part.low.push(low);
            part.high.push(high);
            part.logarithmic.push(u8::from(logarithmic));
            part.steps.extend(shares.into_iter().map(step));
        }
        self.indices.extend(chosen.iter().map(|i| u16::try_from(*i).expect("a sweep has fewer x than 65536")));
        Ok(())
    }
}

impl FieldPart {
    fn of(data: &DataSet, field: Field, Steps { low, high, logarithmic, steps }: Steps) -> Self {
        let quantity = Quantity::from(field);
        let units = if data.laboratory { si_units(quantity.units) } else { quantity.units };
        Self { words: quantity.plain(), units, low: floats(low), high: floats(high), logarithmic, steps: shorts(steps) }
    }
}
