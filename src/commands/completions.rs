//! `stribeck completions`: what completes commands in a shell.

use clap::{Args, ValueEnum};
use clap_complete::{Shell, generate};

use super::{CliError, Exit, command_line, console};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck completions bash > stribeck.bash
  stribeck completions zsh > _stribeck
  stribeck completions fish > stribeck.fish",
    after_help = "\
Where the file goes depends on the shell:
  bash   ~/.local/share/bash-completion/completions/stribeck
  zsh    a directory of $fpath, as _stribeck
  fish   ~/.config/fish/completions/stribeck.fish
A new shell reads it."
)]
pub struct Arguments {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: OneOfThree,
}

/// The shells that are known.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum OneOfThree {
    Bash,
    Zsh,
    Fish,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let shell = match arguments.shell {
        OneOfThree::Bash => Shell::Bash,
        OneOfThree::Zsh => Shell::Zsh,
        OneOfThree::Fish => Shell::Fish,
    };
    let mut script = Vec::new();
    generate(shell, &mut command_line(), "stribeck", &mut script);
    console::print(&String::from_utf8_lossy(&script))?;
    Ok(Exit::Success)
}
