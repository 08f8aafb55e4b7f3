//! Why a command ended, in words.

use std::io;
use std::path::PathBuf;

use miette::MietteHandlerOpts;

use super::console;
use super::solve::ESTIMATE_POINTS;
use crate::pictures::PictureError;
use stribeck_charts::ChartError;
use stribeck_input::{InputError, printable, shown};
use stribeck_lab::{FrictionFitError, MasterCurveError, MaterialFileError, PronyError, RelaxationFitError, TableError};
use stribeck_solver::SubstrateError;
use stribeck_surface::{Outside, SurfaceError};
use stribeck_sweep::Method;
use stribeck_sweep::campaign::CampaignError;
use stribeck_sweep::engine::ThreadsError;
use stribeck_sweep::store::StoreError;
use stribeck_sweep::surface::SurfaceBuildError;

/// Why a command could not do what it was asked to.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// A sweep file, a study file or a table of measurements is not valid.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A table is not valid.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A sweep without quantities of the laboratory.
    #[error(
        "{} is dimensionless, and this needs a speed: write the section [laboratory] in place of [axes]; \
         `stribeck init --laboratory` prints an example",
        shown(file)
    )]
    NotLaboratory {
        /// The sweep file.
        file: PathBuf,
    },
    /// A sweep with more than one curve along the speed, or more than one case.
    #[error("{axis} has {values} values in the sweep file, and {of} has one; choose with --at {axis}=VALUE")]
    SeveralCurves {
        /// What is chosen: a curve, or a case.
        of: &'static str,
        /// The axis.
        axis: String,
        /// How many values it has.
        values: usize,
    },
    /// A flat that does not move, with a time to retard.
    #[error(
        "with --slide-roll -1 the flat is at rest in the contact and has all the time there is to creep: write --alpha inf"
    )]
    FlatAtRest,
    /// A soft roller over a flat that does not move.
    #[error(
        "with --slide-roll -1 the flat is at rest, and alpha tells no time of a roller with --roller-modes: describe both \
         bodies in a sweep file with [laboratory], and solve it with --laboratory"
    )]
    RollerOverFlatAtRest,
    /// Modes that are no substrate.
    #[error("--modes and --roller-modes: {0}; scale the shares so that those of both bodies add up to 1")]
    Modes(SubstrateError),
    /// More than one value of an axis of a curve or a case.
    #[error("--at {axis}=… asks for several values, and {of} has one of each axis; give one")]
    SeveralAsked {
        /// What is chosen: a curve, or a case.
        of: &'static str,
        /// The axis.
        axis: String,
    },
    /// An axis that a curve or a case has not.
    #[error("--at {}: {of} can be chosen by {known}", printable(axis))]
    NoSuchAxis {
        /// What is chosen: a curve along the speed, or a case.
        of: &'static str,
        /// The axis.
        axis: String,
        /// Those that there are.
        known: String,
    },
    /// Measured points that nothing was fitted to.
    #[error("nothing was fitted to {}: {what}", files.iter().map(|file| shown(file)).collect::<Vec<_>>().join(" and "))]
    NoFit {
        /// The files of the points.
        files: Vec<PathBuf>,
        /// Why.
        what: String,
    },
    /// A time limit that ended a fit before there was anything.
    #[error("{}", FrictionFitError::TimeLimit)]
    TimeIsUp,
    /// A file that is no surface.
    #[error("{}: {source}", shown(file))]
    Surface {
        /// The file.
        file: PathBuf,
        /// What is wrong with it.
        source: SurfaceError,
    },
    /// A point beyond a surface.
    #[error("{0}; nothing is extrapolated")]
    Outside(#[from] Outside),
    /// A coordinate that a surface has no axis for.
    #[error("the surface has no axis `{}`; its axes are {known}", printable(axis))]
    NotAnAxis {
        /// The name that was given.
        axis: String,
        /// The axes.
        known: String,
    },
    /// A coordinate that a surface has one value of, and another one was given.
    #[error("the surface was made for {axis} = {made_for}, which is no axis of it; leave {axis} out")]
    OtherValue {
        /// The coordinate.
        axis: String,
        /// Its value.
        made_for: f64,
    },
    /// A point without one of its coordinates.
    #[error("the point needs a value of {axis}; give --at {axis}=VALUE")]
    NoCoordinate {
        /// The axis.
        axis: String,
    },
    /// A file of points that cannot be read.
    #[error("{}: {what}", shown(file))]
    Points {
        /// The file.
        file: PathBuf,
        /// What is wrong with it.
        what: String,
    },
    /// A surface that was not made.
    #[error(transparent)]
    SurfaceBuild(#[from] SurfaceBuildError),
    /// More threads than the system gives.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
    /// An estimate on a grid that has no coarser one.
    #[error(
        "errors are estimated from a second grid of half as many intervals, which takes --points {ESTIMATE_POINTS} or \
         more, not {points}; give more points, or --estimate false"
    )]
    Estimate {
        /// The points asked for.
        points: usize,
    },
    /// An option of the relaxation method with another one.
    #[error("{option} is an option of the relaxation method; leave it out, or add --method relaxation")]
    OtherMethod {
        /// The option.
        option: &'static str,
    },
    /// Derivatives of friction from a method that has none.
    #[error("the relaxation method has no derivatives of friction; leave out --sensitivities, or --method relaxation")]
    Sensitivities,
    /// A tolerance that the method cannot keep.
    #[error("with --method {method}, --tolerance is {meaning}; give a number from {least:e} to {most:e}, not {given}")]
    Tolerance {
        /// The method.
        method: Method,
        /// What the tolerance is of.
        meaning: &'static str,
        /// The smallest that is allowed.
        least: f64,
        /// The largest.
        most: f64,
        /// What was given.
        given: f64,
    },
    /// A results directory cannot be read or written.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Several directories to be joined in none.
    #[error("several directories are joined in one that -o names; give -o DIR")]
    NoTarget,
    /// A merge of parts that lack cases.
    #[error("nothing is published: {missing}")]
    Incomplete {
        /// What is missing, and the commands that finish it.
        missing: String,
    },
    /// A part that would be told to stop before it has begun.
    #[error(
        "a time limit of {limit} leaves a part no time to work: it is told to stop {signal} s before the limit, which \
         Slurm may do {early} s early; give a longer --time, or fewer --signal-seconds"
    )]
    NoTimeToWork {
        /// The time limit as it was given.
        limit: String,
        /// Seconds before it at which a part is told.
        signal: u64,
        /// Seconds that this may come early.
        early: u64,
    },
    /// A path that cannot be the log of a job.
    #[error(
        "Slurm cannot write logs below {:?}: a %, a double quote, a backslash, a line feed or bytes that are no text \
         stand in its name; choose another directory with -o",
        path
    )]
    NameForSlurm {
        /// The path.
        path: PathBuf,
    },
    /// A command would replace a file that it has not written.
    #[error(
        "{} is there, which `stribeck {command}` has not written; move it away, or choose another place",
        shown(file)
    )]
    Foreign {
        /// The file.
        file: PathBuf,
        /// The command.
        command: &'static str,
    },
    /// A file that is written for its user to change, and that may have been changed.
    #[error("{} is there, and `stribeck init` writes over no file; choose another name with -o", shown(file))]
    IsThere {
        /// The file.
        file: PathBuf,
    },
    /// A file whose name gives no name to a directory.
    #[error("the name of the file, {stem:?} and an extension, gives no name to a results directory; name one with -o")]
    NoName {
        /// The name without its extension.
        stem: String,
    },
    /// A command would replace a file that it reads.
    #[error("{} would be written over {}, which this command reads; choose another name", shown(file), shown(input))]
    IsInput {
        /// The file to be written.
        file: PathBuf,
        /// The file that is read.
        input: PathBuf,
    },
    /// Slurm did not do what it was asked to.
    #[error("`{program}` did not work: {said}; the scripts are written, submit them by hand where Slurm runs")]
    Slurm {
        /// The program.
        program: &'static str,
        /// What it said.
        said: String,
    },
    /// A sweep cannot be run, merged or looked at. What can be done about the directory is an option of the command.
    #[error("{}{}", .0, other_directory(.0))]
    Campaign(#[from] CampaignError),
    /// A run that the disk ended.
    #[error("{source}\n{progress}")]
    Stopped {
        /// What happened.
        source: StoreError,
        /// How far the run was, and how to resume it.
        progress: String,
    },
    /// A directory cannot be made or read.
    #[error("cannot {action} the directory {}: {source}; choose another place with -o", shown(path))]
    Directory {
        /// What was tried, as a verb.
        action: &'static str,
        /// The directory.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A file cannot be written.
    #[error("cannot {action} {}: {source}; make room or choose another place, then try again", shown(path))]
    Unwritten {
        /// What was tried, as a verb.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A picture cannot be drawn.
    #[error("cannot draw a picture: {0}; please report it with the study file or the command")]
    Chart(#[from] ChartError),
    /// A picture that a data set has nothing for.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// Measurements that no material was fitted to.
    #[error("{}: {source}", shown(data))]
    Fit {
        /// The table of measurements.
        data: PathBuf,
        /// Why there is none.
        source: RelaxationFitError,
    },
    /// A series that is no material.
    #[error("{}: {source}", shown(file))]
    Series {
        /// The file.
        file: PathBuf,
        /// Why it is none.
        source: PronyError,
    },
    /// Moduli that are no master curve.
    #[error("{}: {source}", shown(data))]
    MasterCurve {
        /// The table of measurements.
        data: PathBuf,
        /// Why they are none.
        source: MasterCurveError,
    },
    /// A picture of shift factors where nothing was shifted.
    #[error(
        "{}: nothing was shifted, so there is no picture of shift factors; leave out --shift-picture, or give \
         --reference-temperature",
        shown(data)
    )]
    NoShifts {
        /// The file of the material.
        data: PathBuf,
    },
    /// An option that would change nothing.
    #[error("{option} would change nothing: {why}")]
    Unused {
        /// The option.
        option: &'static str,
        /// Why, and what to do.
        why: String,
    },
    /// The operating system refused something that is no file of ours.
    #[error("cannot {action}: {source}")]
    System {
        /// What was tried, as a verb.
        action: &'static str,
        /// What the system said.
        source: io::Error,
    },
}

impl From<MaterialFileError> for CliError {
    fn from(error: MaterialFileError) -> Self {
        match error {
            MaterialFileError::Table(error) => Self::Table(error),
            MaterialFileError::Series(error) => Self::Input(error),
        }
    }
}

/// The remedy for a place that cannot be used.
fn other_directory(error: &CampaignError) -> &'static str {
    match error {
        CampaignError::NotADirectory { .. } | CampaignError::Parts { .. } => "; choose another place with -o",
        _ => "",
    }
}

impl CliError {
    /// The text for the user; a sweep file is shown with the place of the error.
    pub fn report(self) -> String {
        match self {
            CliError::Input(error) | CliError::Campaign(CampaignError::Input(error)) => {
                // A second hook is refused; this one is set once, on the way out.
                let _ = miette::set_hook(Box::new(|_| {
                    // `file:line:column` has to stay whole, for people and editors that look for it
                    Box::new(MietteHandlerOpts::new().break_words(false).without_cause_chain().build())
                }));
                format!("{:?}", miette::Report::new(error))
            }
            error => console::harmless(&format!("error: {error}")),
        }
    }
}
