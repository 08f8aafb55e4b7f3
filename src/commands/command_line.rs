//! The whole command line: its commands in groups, and how help is laid out, examples first.

use std::ffi::OsString;
use std::fmt::Write;

use clap::builder::{StyledStr, Styles};
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use super::Command;
use crate::VERSION;

/// The command line.
#[derive(Clone, Debug, Parser)]
#[command(
    name = "stribeck",
    version = VERSION,
    about = "Generalized Stribeck surfaces: friction of a lubricated cylinder sliding on a viscoelastic half space",
    before_help = EXAMPLES,
    after_help = NOTES,
    arg_required_else_help = true,
    max_term_width = 100
)]
pub struct Cli {
    #[command(subcommand)]
    pub(super) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  stribeck solve --alpha 1 --beta 100 --f 10            a single case
  stribeck init --laboratory -o mine.toml               a sweep file to start from
  stribeck plan mine.toml                               what it will cost
  stribeck curve mine.toml                              friction against speed, in the terminal
  stribeck run mine.toml                                run it, or resume it; results in results/mine
  stribeck plot results/mine                            pictures of it, in results/mine/figures
  stribeck report results/mine                          one page of it, for a browser";

const NOTES: &str = "\
`stribeck COMMAND --help` has examples and options of a command.

Exit codes: 0 all cases converged; 2 bad input; 3 done, but some cases failed; 4 the disk or a file;
130 interrupted, the same command resumes.";

/// The groups of commands, as help and `docs/reference/commands.md` list them.
pub const GROUPS: [(&str, &[&str]); 6] = [
    ("Solve", &["solve", "surface", "evaluate"]),
    ("Sweep", &["plan", "run", "status", "publish", "verify"]),
    ("Look", &["plot", "report", "explain", "study"]),
    ("Laboratory", &["material", "curve", "fit"]),
    ("Cluster", &["slurm", "merge"]),
    ("Shell", &["init", "schema", "completions", "man"]),
];

/// How the help of a command is laid out: examples stand before usage and options.
const LAYOUT: &str = "{about-with-newline}\n{before-help}{usage-heading} {usage}\n\n{all-args}{after-help}";

/// The command line as it is parsed, shown and documented.
pub fn command_line() -> clap::Command {
    Cli::command().help_template(layout_of_all()).mut_subcommands(|command| command.help_template(LAYOUT))
}

/// Reads a command line, its first word the name of the program.
///
/// # Errors
/// What is wrong with it, or the help or the version that it asks for.
pub fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Cli, clap::Error> {
    let mut command_line = command_line();
    let matches = command_line.try_get_matches_from_mut(words)?;
    Cli::from_arg_matches(&matches).map_err(|error| error.format(&mut command_line))
}

/// The same for the program as a whole, whose commands are listed in groups; clap itself has one list.
fn layout_of_all() -> StyledStr {
    const IN_MEMORY: &str = "writing to memory does not fail";
    let all = Command::augment_subcommands(clap::Command::new("stribeck"));
    let styles = Styles::default();
    let (header, literal) = (styles.get_header(), styles.get_literal());
    let mut text = StyledStr::from("{about-with-newline}\n{before-help}{usage-heading} {usage}\n");
    for (group, names) in GROUPS {
        write!(text, "\n{header}{group}:{header:#}\n").expect(IN_MEMORY);
        for name in names {
            let about = all.find_subcommand(name).and_then(clap::Command::get_about).cloned().unwrap_or_default();
            writeln!(text, "  {literal}{name:<12}{literal:#} {about}").expect(IN_MEMORY);
        }
    }
    write!(text, "\n{header}Options:{header:#}\n{{options}}{{after-help}}").expect(IN_MEMORY);
    text
}
