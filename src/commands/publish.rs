//! `stribeck publish`: the files for the user, from what is stored.

use std::path::PathBuf;

use clap::Args;

use super::{CliError, Exit, console};
use crate::format::count;
use stribeck_input::shown;
use stribeck_sweep::campaign::{Event, publish_stored};

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck publish results/quick                        results.h5 and the tables again, from what is stored
  stribeck publish results/quick --partial              what an interrupted run has so far",
    after_help = "\
A run publishes by itself when all is solved. With --partial, places that are not solved yet have no numbers, the status
failed and the reason `not solved yet`. The attribute `partial` of results.h5 says how many they are; plot and report
say so too. The run goes on as if nothing had been published, and replaces these files at its end."
)]
pub struct Arguments {
    /// A results directory
    #[arg(value_name = "DIR")]
    directory: PathBuf,
    /// Publish what there is, though places are not solved yet
    #[arg(long)]
    partial: bool,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let (sweep, published) = publish_stored(&arguments.directory, arguments.partial, &mut |event| {
        if let Event::Damaged(warning) = event {
            console::tell(&format!("warning: {warning}"));
        }
    })?;
    let mut text = format!(
        "{}: {} converged, {} failed",
        sweep.title,
        count(published.converged, "place"),
        count(published.failed, "place")
    );
    if published.missing > 0 {
        text += &format!(", {} not solved yet: these files are partial", published.missing);
    }
    let files: Vec<String> = published.files.iter().map(|file| shown(file)).collect();
    text += &format!("\n{}{}\n", files.join(", "), if published.rewritten { "" } else { ": in place already" });
    console::print(&text)?;
    Ok(if published.failed == 0 { Exit::Success } else { Exit::CasesFailed })
}
