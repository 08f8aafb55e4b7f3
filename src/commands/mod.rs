//! The commands of the program, one file for each.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `run`, `plan`, `status`, `solve`, `explain`, `merge`, `publish`, `slurm`, `verify` | commands: sweeps and cases |
//! | `surface`, `evaluate` | commands: friction as a function |
//! | `curve`, `fit`, `material`, `plot`, `report`, `study` | commands: experiments, pictures and methods |
//! | `init`, `completions`, `man`, `schema` | commands: what a user starts with |
//! | `command_line` | the whole command line: groups of commands, layout of help |
//! | `destination` | the results directory of a sweep |
//! | `published` | the published data set, for commands that show it |
//! | `run_report`, `trace_report` | what a run tells of itself; how a case was reached |
//! | `slurm_script` | the job scripts of `slurm` |
//! | `terminal_plot` | a small plot of characters |
//! | `solve_batch` | a list of cases to the rows of a summary |
//! | `solution` | one solved case as a table and as JSON |
//! | `fitted_material`, `fitted_friction` | a fit as a table, as JSON and as charts |
//! | `prony_material` | a Prony series that was read, likewise |
//! | `material_text`, `shifted` | a material and a master curve as lines of text, as JSON and as charts |
//! | `error`, `console` | errors with their exit codes; output |
//! | `shell`, `threads` | quoted commands; number of threads |
//! | `number`, `at` | numbers of the command line; values of axes, with units |
//! | `case_fields` | the fields of one case in a file |
//! | `output_file` | files that a command writes for its user |
//! | `sbatch_option` | options of sbatch that a user adds |

mod at;
mod case_fields;
mod command_line;
mod completions;
mod console;
mod curve;
mod destination;
mod error;
mod evaluate;
mod evaluate_points;
mod exit;
mod explain;
mod fit;
mod fit_progress;
mod fitted_curves;
mod fitted_friction;
mod fitted_material;
mod init;
mod man;
mod material;
mod material_text;
mod measured;
mod merge;
mod number;
mod output_file;
mod paper;
mod plan;
mod plot;
mod prony_material;
mod publish;
mod published;
mod report;
mod run;
mod run_report;
mod sbatch_option;
mod schema;
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

use clap::Subcommand;

use crate::study::Meter;
pub use command_line::{Cli, GROUPS, command_line, parse};
use error::CliError;
use exit::Exit;
pub use shell::set_command_line;

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
    /// Write a sweep file to start from, with comments
    Init(init::Arguments),
    /// Print what completes commands in a shell
    Completions(completions::Arguments),
    /// Write the manual pages
    Man(man::Arguments),
    /// Print the JSON schema of sweep files, for editors
    Schema(schema::Arguments),
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
        Command::Init(arguments) => init::execute(arguments),
        Command::Completions(arguments) => completions::execute(arguments),
        Command::Man(arguments) => man::execute(arguments),
        Command::Schema(arguments) => schema::execute(arguments),
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
