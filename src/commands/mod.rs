//! The commands of the program, one file for each.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `run`, `plan`, `status`, `solve`, `explain`, `merge`, `publish`, `slurm`, `verify` | commands: sweeps and cases |
//! | `surface`, `evaluate` | commands: friction as a function |
//! | `curve`, `fit`, `material`, `plot`, `report`, `study` | commands: experiments, pictures and methods |
//! | `destination` | the results directory of a sweep |
//! | `published` | the published data set, for commands that show it |
//! | `run_report`, `trace_report` | what a run tells of itself; how a case was reached |
//! | `slurm_script` | the job scripts of `slurm` |
//! | `terminal_plot` | a small plot of characters |
//! | `solve_batch` | a list of cases to the rows of a summary |
//! | `solution` | one solved case as a table and as JSON |
//! | `fitted_material`, `fitted_friction` | a fit as a table, as JSON and as charts |
//! | `prony_material` | a Prony series that was read, likewise |
//! | `material_text`, `shifted` | a material and a master curve as lines of text and as JSON |
//! | `error`, `console` | errors with their exit codes; output |
//! | `shell`, `threads` | quoted commands; number of threads |
//! | `number` | numbers of the command line |
//! | `output_file` | files that a command writes for its user |
//! | `sbatch_option` | options of sbatch that a user adds |

mod console;
mod curve;
mod destination;
mod error;
mod evaluate;
mod explain;
mod fit;
mod fit_progress;
mod fitted_friction;
mod fitted_material;
mod material;
mod material_text;
mod measured;
mod merge;
mod number;
mod output_file;
mod plan;
mod plot;
mod prony_material;
mod publish;
mod published;
mod report;
mod run;
mod run_report;
mod sbatch_option;
mod sensitivities;
mod shell;
mod shifted;
mod short_value;
mod slurm;
mod slurm_script;
mod solution;
mod solve;
mod solve_batch;
mod status;
mod study;
mod surface;
mod terminal_plot;
mod threads;
mod trace_report;
mod verify;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::study::Meter;
use error::CliError;
pub use shell::set_command_line;

/// The command line.
#[derive(Clone, Debug, Parser)]
#[command(
    name = "stribeck",
    version,
    about = "Generalized Stribeck surfaces: friction of a lubricated cylinder sliding on a viscoelastic half space",
    after_help = EXAMPLES,
    arg_required_else_help = true,
    max_term_width = 100
)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  stribeck plan sweeps/quick.toml                       what a sweep will cost
  stribeck run sweeps/quick.toml                        run it, or resume it; results in results/quick
  stribeck solve --alpha 1 --beta 100 --f 10            a single case
  stribeck explain results/quick 100,1,1000             why this one is as it is
  stribeck plot results/quick                           pictures of it, in results/quick/figures
  stribeck report results/quick                         one page of it, for a browser
  stribeck study sweeps/study-quick.toml                error against run time
  stribeck material rubber.csv --terms 12               a substrate from measured moduli

Exit codes: 0 all cases converged; 2 bad input; 3 done, but some cases failed; 4 the disk or a file;
130 interrupted, the same command resumes.";

#[derive(Clone, Debug, Subcommand)]
enum Command {
    /// Run a sweep, or resume it: solve what is missing, then publish
    Run(run::Arguments),
    /// Say what `run` would do: cases, reuse, expected time and bytes; writes nothing
    Plan(plan::Arguments),
    /// Count the cases of a running or a stopped sweep, with its rate and its failures
    Status(status::Arguments),
    /// Solve one case and print it
    Solve(solve::Arguments),
    /// Join the parts of a sweep, or the runs of one in several directories, and publish
    Merge(merge::Arguments),
    /// Publish what is stored again, or what there is of an interrupted run
    Publish(publish::Arguments),
    /// Write the scripts that solve a sweep on a cluster with Slurm, and submit them
    Slurm(slurm::Arguments),
    /// Say why a case is as it is: seed, way and residuals, and the command that repeats it
    Explain(explain::Arguments),
    /// Read every stored result again and compare it with its record
    Verify(verify::Arguments),
    /// Solve a material's friction against speed and show it in the terminal
    Curve(curve::Arguments),
    /// Fit quantities of the laboratory to measured friction
    Fit(fit::Arguments),
    /// Draw a published sweep: surfaces, maps, curves, profiles, loops, stresses, errors
    Plot(plot::Arguments),
    /// Make one HTML page of a published sweep, which works offline
    Report(report::Arguments),
    /// Measure error against run time, and where each method is stable
    Study(study::Arguments),
    /// Fit a substrate to measured storage and loss moduli
    Material(material::Arguments),
    /// Make a surface: friction as a function in a file, to a measured error
    Surface(surface::Arguments),
    /// Evaluate a surface at points, or check it
    Evaluate(evaluate::Arguments),
}

/// How a command ended that did what it was asked to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Exit {
    /// All is well.
    Success,
    /// A surface is not as exact as it says.
    DoesNotHold,
    /// Done, but some cases failed.
    CasesFailed,
    /// Damage was found.
    Damaged,
    /// Stopped by a signal.
    Interrupted,
}

impl Exit {
    fn code(self) -> u8 {
        match self {
            Exit::Success => 0,
            Exit::DoesNotHold => 1,
            Exit::CasesFailed => 3,
            Exit::Damaged => 4,
            Exit::Interrupted => 130,
        }
    }
}

/// Does what the command line says and reports errors on stderr. `meter` tells the memory that a piece of work takes.
pub fn execute(cli: &Cli, meter: Meter<'_>) -> ExitCode {
    let ending = match &cli.command {
        Command::Run(arguments) => run::execute(arguments),
        Command::Plan(arguments) => plan::execute(arguments),
        Command::Status(arguments) => status::execute(arguments),
        Command::Solve(arguments) => solve::execute(arguments),
        Command::Merge(arguments) => merge::execute(arguments),
        Command::Publish(arguments) => publish::execute(arguments),
        Command::Slurm(arguments) => slurm::execute(arguments),
        Command::Explain(arguments) => explain::execute(arguments),
        Command::Verify(arguments) => verify::execute(arguments),
        Command::Curve(arguments) => curve::execute(arguments),
        Command::Fit(arguments) => fit::execute(arguments),
        Command::Plot(arguments) => plot::execute(arguments),
        Command::Report(arguments) => report::execute(arguments),
        Command::Study(arguments) => study::execute(arguments, meter),
        Command::Material(arguments) => material::execute(arguments),
        Command::Surface(arguments) => surface::execute(arguments),
        Command::Evaluate(arguments) => evaluate::execute(arguments),
    };
    match ending {
        Ok(exit) => exit.code().into(),
        Err(error) => {
            let code = error.code();
            console::tell_coloured(&error.report());
            code.into()
        }
    }
}
