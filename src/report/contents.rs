//! All numbers and words of a page, as its script reads them.

use std::collections::BTreeMap;

use serde::Serialize;

use super::axis::{AxisPart, AxisValue};
use super::columns::{ColumnPart, CostPart, columns};
use super::encoding::integers;
use super::failures::FailurePart;
use super::fields::{CasePlace, FieldsPart};
use super::measured::MeasuredPart;
use super::texts::Texts;
use super::thinning::Grid;
use crate::pictures::AxisWords;
use stribeck_lab::Measured;
use stribeck_sweep::NoteCounts;
use stribeck_sweep::store::{DataSet, Status, StoreError};

/// All that the page shows. Lists of numbers are base64 (`encoding`).
#[derive(Debug, Serialize)]
pub(super) struct Contents {
    title: String,
    version: String,
    outdated: bool,
    /// Numbers of values on the three axes of the data set.
    shape: [usize; 3],
    /// Values shown on the three axes.
    axes: [Vec<AxisValue>; 3],
    axis_words: [AxisPart; 3],
    /// True if numbers are in SI units.
    laboratory: bool,
    /// Quantities of the laboratory that are one number.
    fixed: BTreeMap<String, f64>,
    measured: Option<MeasuredPart>,
    /// For each place shown the index of its case.
    case_of: String,
    /// Ids of the cases shown.
    cases: Vec<String>,
    /// For each place shown 0 (converged) or 1 (failed).
    status: String,
    columns: Vec<ColumnPart>,
    /// None without timings.csv.
    costs: Option<CostPart>,
    /// None if the data set has no fields.
    fields: Option<FieldsPart>,
    failures: FailurePart,
    /// What was left out, a sentence each.
    pub(super) notes: Vec<String>,
}

impl Contents {
    /// The contents of the page of a data set.
    ///
    /// # Errors
    /// [`StoreError`] if the data set cannot be read.
    pub(super) fn of(data: &DataSet, measured: Option<&Measured>) -> Result<Self, StoreError> {
        let mut notes =
            vec!["Numbers are shown to at most seven digits; summary.csv and results.h5 have all.".to_owned()];
        let (grid, axes) = (Grid::of(data), AxisWords::of(data, &[]));
        notes.extend(grid.note(data, &axes));
        notes.extend(data.partial.iter().map(|partial| format!("Partial: {partial}, and stand among the failed.")));
        let (masks, all) = (data.notes()?, data.shape().places());
        for (note, count) in NoteCounts::of_masks(masks.into_iter().flatten()).iter() {
            notes.push(format!("{} at {count} of {all} places: {}.", note.name(), note.sentence()));
        }
        let places: Vec<usize> = grid.places().map(|indices| data.place(indices)).collect();
        let (statuses, reasons) = (data.statuses()?, data.reasons()?);
        let cases = Cases::of(data, &grid, &statuses)?;
        let costs = data.costs()?.map(|costs| CostPart::of(&costs, &places));
        if costs.is_none() {
            notes.push("There is no timings.csv, so nothing is known of what cases cost.".to_owned());
        }
        let fields = FieldsPart::of(data, &cases.places, &mut notes)?;
        if fields.is_none() {
            notes.push("The sweep has no fields: `fields` below [output] of the sweep file asks for them.".to_owned());
        }
        let measured = measured.map(|measured| MeasuredPart::of(measured, data, &axes, &mut notes));
        let failures = FailurePart::of(data, &places, &statuses, &reasons, &mut notes);
        let values = |axis: usize| grid.0[axis].iter().map(|i| axes[axis].values[*i].into()).collect();
        Ok(Self {
            title: data.title.clone(),
            version: data.version.clone(),
            outdated: data.outdated,
            shape: data.shape().lengths(),
            axes: std::array::from_fn(values),
            axis_words: std::array::from_fn(|axis| AxisPart::of(&axes[axis], &grid.0[axis])),
            laboratory: data.laboratory,
            fixed: data.fixed.iter().cloned().collect(),
            measured,
            case_of: integers(cases.of_places),
            cases: cases.ids,
            status: integers(places.iter().map(|place| i32::from(statuses[*place].code()))),
            columns: columns(data, &places)?,
            costs,
            fields,
            failures,
            notes,
        })
    }
}

/// Dimensions that change how fast the roller turns, and with it the shear on it.
const MOTION: [&str; 4] = ["slide_roll", "slide_roll_ratio", "roller_speed", "flat_speed"];

/// The cases of the places shown, each once for each slide-to-roll ratio.
struct Cases {
    ids: Vec<String>,
    /// For each case where it first stands.
    places: Vec<CasePlace>,
    /// For each place shown the index of its case.
    of_places: Vec<i32>,
}

impl Cases {
    fn of(data: &DataSet, grid: &Grid, statuses: &[Status]) -> Result<Self, StoreError> {
        let ids = data.cases()?;
        let (mut different, mut places, mut of_places) = (Texts::default(), Vec::new(), Vec::new());
        for indices in grid.places() {
            let place = data.place(indices);
            // Places of one case with other speeds have other shear.
            let values = data.indices(indices).into_iter().zip(&data.dimensions);
            let speeds = values.filter(|(_, dimension)| MOTION.contains(&dimension.name.as_str()));
            let own = speeds.map(|(index, _)| format!(" {index}")).collect::<String>();
            let index = different.index(&(ids[place].clone() + &own));
            if index == places.len() {
                places.push(CasePlace { indices, status: statuses[place] });
            }
            of_places.push(i32::try_from(index).expect("a page has fewer cases than 2³¹"));
        }
        let id = |text: &String| text.split(' ').next().unwrap_or_default().to_owned();
        Ok(Self { ids: different.texts.iter().map(id).collect(), places, of_places })
    }
}
