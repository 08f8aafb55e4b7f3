//! The commands of the program, one file for each.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `run`, `plan`, `status`, `solve`, `verify` | the commands |
//! | `destination` | the results directory of a sweep, and what it was used for before |
//! | `workload` | which chains of a plan are left to be solved |
//! | `entry` | from a solved case to what the store keeps |
//! | `failures` | failed cases, listed and by region |
//! | `error`, `console`, `shell`, `wording` | errors with their exit codes; output; quoted commands; times and sizes in words |

mod console;
mod destination;
mod entry;
mod error;
mod failures;
mod run;
mod shell;
mod wording;
mod workload;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use error::CliError;

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

Exit codes: 0 all cases converged; 2 bad input; 3 done, but some cases failed; 4 the disk or a file;
130 interrupted, the same command resumes.";

#[derive(Clone, Debug, Subcommand)]
enum Command {
    /// Run a sweep, or resume it: solve what is missing, then publish
    Run(run::Arguments),
}

/// How a command ended that did what it was asked to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Exit {
    /// All is well.
    Success,
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
            Exit::CasesFailed => 3,
            Exit::Damaged => 4,
            Exit::Interrupted => 130,
        }
    }
}

/// Does what the command line says and reports errors on stderr.
pub fn execute(cli: &Cli) -> ExitCode {
    let ending = match &cli.command {
        Command::Run(arguments) => run::execute(arguments),
    };
    match ending {
        Ok(exit) => exit.code().into(),
        Err(error) => {
            let code = error.code();
            console::tell(&error.report());
            code.into()
        }
    }
}
