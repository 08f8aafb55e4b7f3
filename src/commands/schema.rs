//! `stribeck schema`: the JSON schema of sweep files.

use clap::Args;

use super::{CliError, Exit, console};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck schema > sweep.schema.json",
    after_help = "\
Editors that read TOML by Taplo, as VS Code does with Even Better TOML, complete keys, show what they mean and mark
mistakes, if a sweep file begins with the line

  #:schema ./sweep.schema.json

The schema knows keys, types and ranges. What depends on several keys at once `stribeck plan` alone tells."
)]
pub struct Arguments {}

pub fn execute(_: &Arguments) -> Result<Exit, CliError> {
    let schema = serde_json::to_string_pretty(&stribeck_sweep::schema()).expect("a value becomes text");
    console::print(&format!("{schema}\n"))?;
    Ok(Exit::Success)
}
