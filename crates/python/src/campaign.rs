//! `run`: a sweep into a results directory.

use std::path::PathBuf;

use pyo3::prelude::*;
use stribeck_sweep::campaign::{Event, RunOptions, RunOutcome, read_sweep, run as run_sweep};

use crate::background::{threads, watched};
use crate::errors;

/// What happens while a sweep runs: how many cases there are, how many converged and failed, or a warning.
enum Told {
    Solving(u64),
    Committed(u64, u64),
    Warning(String),
}

/// Runs a sweep, or resumes it: (converged, failed).
///
/// `told` is called as told("solving", cases, 0), told("committed", converged, failed), told("warning", message, 0).
///
/// # Errors
/// `InputError`, `StorageError`; what a handler of signals raises, when what is finished is stored.
#[pyfunction]
pub fn run(
    py: Python<'_>,
    sweep: PathBuf,
    directory: PathBuf,
    asked: Option<i64>,
    told: Py<PyAny>,
) -> PyResult<(usize, usize)> {
    let sweep = read_sweep(&sweep).map_err(|error| errors::campaign(&error))?;
    let options = RunOptions { threads: threads(asked)?, ..RunOptions::default() };
    let report = watched(
        py,
        &options.interrupt,
        |tell: &dyn Fn(Told)| {
            run_sweep(&sweep, &directory, &options, &mut |event| match event {
                Event::Solving { cases } => tell(Told::Solving(cases)),
                Event::Committed { converged, failed } => tell(Told::Committed(converged, failed)),
                Event::Damaged(warning) => tell(Told::Warning(warning.to_string())),
                Event::OtherSweep { .. } | Event::TookOver(_) | Event::Publishing => {}
            })
        },
        |py, message| {
            match message {
                Told::Solving(cases) => told.call1(py, ("solving", cases, 0)),
                Told::Committed(converged, failed) => told.call1(py, ("committed", converged, failed)),
                Told::Warning(message) => told.call1(py, ("warning", message, 0)),
            }
            .map(drop)
        },
    )?;
    match report.map_err(|error| errors::campaign(&error))?.outcome {
        RunOutcome::Published(published) => Ok((published.converged as usize, published.failed as usize)),
        RunOutcome::PartSolved { .. } | RunOutcome::Interrupted { .. } => unreachable!("what interrupts it is raised"),
    }
}
