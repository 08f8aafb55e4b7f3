//! `stribeck schema`: the JSON schemas of sweep files and study files.

use clap::Args;

use super::{CliError, Exit, console};
use crate::study;

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck schema > sweep.schema.json
  stribeck schema --study > study.schema.json",
    after_help = "\
Editors that read TOML by Taplo, as VS Code does with Even Better TOML, complete keys, show what they mean and mark
mistakes, if a sweep file begins with the line

  #:schema ./sweep.schema.json

The schema knows keys, types and ranges. What depends on several keys at once `stribeck plan` alone tells."
)]
pub struct Arguments {
    /// The schema of study files, for `stribeck study`
    #[arg(long)]
    study: bool,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let schema = if arguments.study { study::schema() } else { stribeck_sweep::schema() };
    let schema = serde_json::to_string_pretty(&schema).expect("a value becomes text");
    console::print(&format!("{schema}\n"))?;
    Ok(Exit::Success)
}
