//! How far a running or a stopped sweep is.

use std::path::Path;

use super::failures::failure_regions;
use super::parts::part_states;
use super::{CampaignError, FailureRegion, MergedCatalog, PartState, Pending, SweepDirectory, read_sweep, sweep_file};
use crate::store::{Catalog, Counts, DataSet, Inspection, Start, StoreError, StoredOutput, Warning};
use crate::{NoteCounts, Plan, Sweep};
use stribeck_solver::{FieldSelection, Output};

/// How far a sweep is.
#[derive(Debug)]
pub struct StatusReport {
    /// What is done and what is left; only what is stored, where the sweep file cannot be read.
    pub cases: Result<PlannedStatus, UnplannedStatus>,
    /// The cases that are stored, be they of this sweep or not.
    pub stored: Counts,
    /// The processes that work in the directory and its parts, as in `process 4711`.
    pub workers: Vec<String>,
    /// True if a process works in the directory itself.
    pub running: bool,
    /// The runs in the directory itself, oldest first, each with the number of its log; those of its parts are not
    /// among them.
    pub starts: Vec<(u32, Start)>,
    /// Cases per second: of those who work here together, else of the last run that solved cases.
    pub rate: Option<f64>,
    /// What is damaged and not used.
    pub warnings: Vec<Warning>,
}

/// How far a sweep with a readable sweep file is.
#[derive(Debug)]
pub struct PlannedStatus {
    /// The sweep.
    pub sweep: Sweep,
    /// The places of the sweep.
    pub places: usize,
    /// The distinct cases at these places.
    pub problems: usize,
    /// What is done, and what is left.
    pub pending: Pending,
    /// True if all that is stored is published.
    pub published: bool,
    /// How many published places have notes.
    pub notes: NoteCounts,
    /// How far the parts are; empty if there are none.
    pub parts: Vec<PartState>,
    /// Where cases failed, the regions with most failures first.
    pub failures: Vec<FailureRegion>,
}

/// What is known of a directory whose sweep file cannot be read.
#[derive(Debug)]
pub struct UnplannedStatus {
    /// Why the sweep file cannot be read.
    pub error: CampaignError,
}

/// Tells how far the sweep of a results directory is. The directory is only read, also while a run works there.
///
/// # Errors
/// [`CampaignError::Store`] if the directory has no results or cannot be read.
pub fn status(directory: &Path, inspection: Inspection) -> Result<StatusReport, CampaignError> {
    let sweep = read_sweep(&sweep_file(directory)?);
    // Without a sweep nothing is asked for, so that whatever is stored counts.
    let nothing = Output { fields: FieldSelection::default(), limits: false, ..Output::default() };
    let wanted = sweep.as_ref().map_or_else(|_| StoredOutput::from(&nothing), StoredOutput::from);
    let found = SweepDirectory::read_existing(directory, &wanted, inspection)?;
    let owners = found.catalogs().into_iter().map(Catalog::owner).collect::<Result<Vec<_>, _>>()?;
    let cases = match sweep {
        Ok(sweep) => {
            let mut planned = planned(sweep, &found)?;
            if planned.published && inspection == Inspection::Bytes {
                planned.notes = notes(directory)?;
            }
            Ok(planned)
        }
        Err(error) => Err(UnplannedStatus { error }),
    };
    let starts = found.whole.iter().flat_map(|whole| whole.history().starts());
    Ok(StatusReport {
        cases,
        stored: stored(&found),
        running: found.whole.is_some() && owners[0].is_some(),
        starts: starts.map(|(number, start)| (number, start.clone())).collect(),
        rate: rate(&found, &owners),
        warnings: warnings(&found, &owners),
        workers: owners.into_iter().flatten().collect(),
    })
}

/// How many places of the published data set of a directory have notes.
///
/// # Errors
/// [`StoreError`] if it cannot be read.
pub fn notes(directory: &Path) -> Result<NoteCounts, StoreError> {
    Ok(NoteCounts::of_masks(DataSet::open(directory)?.notes()?.into_iter().flatten()))
}

fn planned(sweep: Sweep, found: &SweepDirectory) -> Result<PlannedStatus, StoreError> {
    let (plan, stored) = (Plan::new(&sweep), found.merged());
    Ok(PlannedStatus {
        places: plan.cases(),
        problems: plan.problems(),
        pending: Pending::survey(&sweep, &plan, None, &stored),
        published: found.whole.as_ref().is_some_and(|whole| {
            // What is published may be a part of it, and the rest be in the parts.
            let itself = Pending::survey(&sweep, &plan, None, &MergedCatalog::new(vec![whole]));
            whole.is_published() && itself.to_do() == 0
        }),
        notes: NoteCounts::default(),
        parts: part_states(&plan, found, &stored)?,
        failures: failure_regions(&plan, &stored)?,
        sweep,
    })
}

fn stored(found: &SweepDirectory) -> Counts {
    let counts = found.catalogs().into_iter().map(Catalog::counts);
    counts.fold(Counts::default(), |sum, counts| Counts {
        converged: sum.converged + counts.converged,
        failed: sum.failed + counts.failed,
    })
}

/// The warnings of all catalogs, whose owners are given in the same order.
fn warnings(found: &SweepDirectory, owners: &[Option<String>]) -> Vec<Warning> {
    let mut warnings = Vec::new();
    for (catalog, owner) in found.catalogs().into_iter().zip(owners) {
        // The last line of a log may be half written while a run works.
        let counts = |warning: &&Warning| owner.is_none() || !matches!(warning, Warning::Record { .. });
        warnings.extend(catalog.warnings().iter().filter(counts).cloned());
    }
    warnings
}

fn rate(found: &SweepDirectory, owners: &[Option<String>]) -> Option<f64> {
    let solves = |start: &Start| start.beginning.as_ref().is_some_and(|beginning| beginning.threads > 0);
    let last = |catalog: &Catalog| catalog.history().starts().rfind(|(_, start)| solves(start))?.1.rate();
    let catalogs = found.catalogs();
    let running = catalogs.iter().zip(owners).filter(|(_, owner)| owner.is_some());
    let rates: Vec<f64> = running.filter_map(|(catalog, _)| last(catalog)).collect();
    let rate = match rates.is_empty() {
        true => catalogs.iter().filter_map(|catalog| last(catalog)).next_back()?,
        false => rates.iter().sum(),
    };
    Some(rate).filter(|&rate| rate > 0.0)
}
