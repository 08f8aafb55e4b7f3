//! From a sweep file with ranges to `surface.json`.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::comparison::{errors, random_points, summary};
use super::nodes::Nodes;
use super::refinement::Work;
use super::rounds::Rounds;
use crate::SurfaceSweep;
use crate::campaign::{CampaignError, available_threads};
use crate::engine::ThreadsError;
use crate::store::{StoreError, write_whole};
use stribeck_solver::{Interrupt, Parameters};
use stribeck_surface::{ErrorRecord, Surface};

/// How a surface is made. None of it changes a number.
#[derive(Clone, Debug)]
pub struct SurfaceOptions {
    /// Solver threads; by default one for each core.
    pub threads: NonZeroUsize,
    /// A request through it stops the work soon, and what is finished is stored.
    pub interrupt: Arc<Interrupt>,
}

impl Default for SurfaceOptions {
    fn default() -> Self {
        Self { threads: available_threads(), interrupt: Arc::default() }
    }
}

/// What is told while a surface is made.
#[derive(Clone, Debug, PartialEq)]
pub enum Progress {
    /// A stored file, or a line of a log, is damaged and not used. Its cases are solved again.
    Damaged {
        /// What is damaged.
        what: String,
    },
    /// A round of refinement has ended.
    Round {
        /// Its number, from 1.
        number: usize,
        /// The number of cases so far.
        cases: usize,
        /// The largest error at random points that lead the refinement, in tolerances.
        largest: f64,
    },
    /// The surface was compared with solutions at fresh random points.
    Compared {
        /// The number of cases that it was made from.
        cases: usize,
        /// The largest error, in tolerances.
        largest: f64,
    },
}

/// A surface that was made.
#[derive(Clone, Debug)]
pub struct SurfaceReport {
    /// The file.
    pub file: PathBuf,
    /// The surface.
    pub surface: Surface,
    /// Cases that were solved now and not before.
    pub solved: u64,
    /// True if the largest error of each quantity is below the tolerance.
    pub holds: bool,
}

/// Why a surface was not made.
#[derive(Debug, thiserror::Error)]
pub enum SurfaceBuildError {
    /// The directory cannot be used.
    #[error(transparent)]
    Campaign(#[from] CampaignError),
    /// The disk, or a file.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Threads.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
    /// A case that a surface needs has no solution.
    #[error(
        "a surface needs every case, and the one at alpha {}, beta {}, f {} failed: {reason}; choose ranges without it",
        case.alpha, case.beta, case.f
    )]
    Failed {
        /// The case.
        case: Box<Parameters>,
        /// Why it failed.
        reason: String,
    },
    /// A quantity that has no number somewhere.
    #[error(
        "`{quantity}` is {value:e} at {place}, and a surface of it must be above 0; leave it out of surface.quantities, \
         or choose other ranges"
    )]
    NoNumber {
        /// The quantity.
        quantity: &'static str,
        /// What it is.
        value: f64,
        /// Where, as in `alpha = 1, beta = 10`.
        place: String,
    },
    /// A singular value decomposition that did not converge.
    #[error("the singular values of the coefficients did not converge; please report it with the sweep")]
    SingularValues,
    /// Someone asked to stop.
    #[error("interrupted; the same command goes on")]
    Interrupted,
}

/// Makes the surface of a sweep, or goes on with one: `DIRECTORY/surface.json`. Nodes are stored as a run stores its
/// cases. The file does not depend on the number of threads or on interruptions.
///
/// # Errors
/// [`SurfaceBuildError`] if a case fails, the disk fails, or someone asks to stop. A surface that does not reach its
/// tolerance is written, and [`SurfaceReport::holds`] is false.
pub fn build(
    surface: &SurfaceSweep,
    directory: &Path,
    options: &SurfaceOptions,
    tell: &mut dyn FnMut(Progress),
) -> Result<SurfaceReport, SurfaceBuildError> {
    let nodes = Nodes::new(surface, Some(directory), options, tell)?;
    let mut work = Work::new(surface, nodes);
    let (mut rounds, mut unwritten) = (Rounds::begin(directory)?, None);
    let (made, holds) = work.refine(&mut |progress| {
        unwritten = unwritten.take().or(rounds.tell(directory, &progress).err());
        tell(progress);
    })?;
    unwritten.map_or(Ok(()), Err)?;
    let file = directory.join("surface.json");
    let text = serde_json::to_string_pretty(made.file()).expect("a surface is made of texts and finite numbers");
    // A link to a file stays, and the file is replaced; one to a device gives way, as the device must not.
    let linked = file.is_symlink() && file.is_file();
    let target = if linked { file.canonicalize().unwrap_or_else(|_| file.clone()) } else { file.clone() };
    write_whole(target, (text + "\n").as_bytes())?;
    Ok(SurfaceReport { file, surface: made, solved: work.solved(), holds })
}

/// Compares a surface with solutions at so many random points of a seed: the errors of each quantity.
///
/// # Errors
/// [`SurfaceBuildError`] if a case fails, or someone asks to stop.
pub fn compare_surface(
    sweep: &SurfaceSweep,
    surface: &Surface,
    points: usize,
    seed: u64,
    options: &SurfaceOptions,
) -> Result<Vec<ErrorRecord>, SurfaceBuildError> {
    let nodes = Nodes::new(sweep, None, options, &mut |_| {})?;
    let mut work = Work::new(sweep, nodes);
    let points = random_points(work.domain(), points, seed);
    let known = work.known(points)?;
    Ok(errors(surface, &known).into_iter().map(summary).collect())
}
