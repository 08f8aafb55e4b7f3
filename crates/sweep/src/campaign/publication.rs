//! From the stored cases of a sweep to the files for the user.

use std::path::Path;

use super::merge::join_all;
use super::sweep_directory::part_directories;
use super::{CampaignError, Observer, SweepDirectory, available_threads, open_store, read_sweep, sweep_file};
use crate::engine::solver_threads;
use crate::store::{
    CaseEntry, Contents, Ending, Inspection, PackedCase, Point, Publication, Published, Store, StoreError,
};
use crate::{Grid, GridIndex, Plan, Sweep};

/// A place of the grid of a sweep as it is published.
pub fn published_point(sweep: &Sweep, plan: &Plan, place: GridIndex) -> Point {
    let laboratory = match &sweep.grid {
        Grid::Dimensionless(_) => None,
        Grid::Laboratory(axes) => Some(axes),
    };
    let (numbers, slide_roll) = (sweep.grid.numbers(place), sweep.grid.slide_roll(place));
    let power_of_strength = match laboratory {
        None => Grid::power_of_strength(numbers[0], slide_roll, &sweep.substrate),
        Some(_) => 1.0,
    };
    Point {
        case: plan.case_at(place),
        slide_roll,
        swapped: laboratory.and_then(|axes| axes.swapped(place)).map(|place| plan.case_at(place)),
        limits: laboratory.map(|axes| axes.limits).unwrap_or_default(),
        numbers,
        power_of_strength,
        experiment: sweep.grid.experiment(place),
    }
}

/// Publishes what a results directory and its parts have of a sweep, of an interrupted run too if a `partial`
/// publication will do: then places that are not solved yet have no numbers; `results.h5` and `summary.csv` say so.
///
/// # Errors
/// [`StoreError::Unfinished`] in [`CampaignError::Store`] if places are not solved and that will not do, others if the
/// directory cannot be read or written, or a run works there.
pub fn publish_stored(
    directory: &Path,
    partial: bool,
    observe: &mut Observer<'_>,
) -> Result<(Sweep, Published), CampaignError> {
    let sweep = read_sweep(&sweep_file(directory)?)?;
    let plan = Plan::new(&sweep);
    // A directory that is none is not to become one.
    SweepDirectory::read_existing(directory, &(&sweep).into(), Inspection::Size)?;
    let mut store = open_store(directory, &sweep, &plan, observe)?;
    join_all(
        part_directories(directory)?.into_iter().filter(|part| part.join("log").is_dir()),
        &sweep,
        &mut store,
        observe,
    )?;
    let threads = solver_threads(available_threads())?;
    let published = threads.install(|| publish_places(&sweep, &plan, &mut store, partial))?;
    Ok((sweep, published))
}

/// Stores cases that are solved already in a directory of their own, and publishes the sweep that has these alone.
///
/// # Errors
/// [`CampaignError`] if the directory cannot be written, or the sweep has other cases too.
pub fn publish_solved(sweep: &Sweep, directory: &Path, entries: &[CaseEntry]) -> Result<Published, CampaignError> {
    let (plan, contents) = (Plan::new(sweep), Contents::of(sweep));
    let mut store = open_store(directory, sweep, &plan, &mut |_| {})?;
    let cases: Vec<_> = entries.iter().map(|entry| PackedCase::new(entry.clone(), &contents)).collect();
    store.begin(&sweep.name, cases.len() as u64, 1)?;
    store.commit_packed(&cases)?;
    store.end(Ending::Completed)?;
    Ok(publish(sweep, &plan, &mut store)?)
}

/// Publishes a sweep whose cases are all stored.
pub(super) fn publish(sweep: &Sweep, plan: &Plan, store: &mut Store) -> Result<Published, StoreError> {
    publish_places(sweep, plan, store, false)
}

fn publish_places(sweep: &Sweep, plan: &Plan, store: &mut Store, partial: bool) -> Result<Published, StoreError> {
    let row = |row: usize| sweep.grid.shape().row(row).map(|place| published_point(sweep, plan, place)).collect();
    let dimensions = sweep.grid.dimensions();
    let (method, tolerance) = (sweep.solver.method.to_string(), sweep.solver.tolerance);
    store.publish(&Publication {
        title: &sweep.title,
        sweep_text: &sweep.text,
        method: &method,
        tolerance,
        partial,
        dimensions: &dimensions,
        row: &row,
    })
}
