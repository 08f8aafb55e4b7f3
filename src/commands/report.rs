//! `stribeck report`: one page of HTML that shows a published data set.

use std::path::PathBuf;

use clap::Args;

use super::measured::{self, MeasuredArguments};
use super::output_file::OutputFiles;
use super::{CliError, Exit, console, published};
use crate::format::bytes;
use crate::report::{BEGINNING, page};
use stribeck_input::shown;

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck report results/quick                         then open results/quick/report.html
  stribeck report results/quick -o for-a-colleague.html
  stribeck report results/experiment --measured docs/how-to/instrument-files/traction.txt",
    after_help = "\
One file that works without a network, in any browser of 2021 or later: friction curves, surfaces and maps with a
slider for f, cases with their fields, to pin and compare, errors against times, failures, a table to sort and
download, and the sweep file. Its address is a link to what it shows. Large sweeps are thinned, and the page says how.
docs/how-to/report.md has more."
)]
pub struct Arguments {
    /// A results directory
    #[arg(value_name = "DIR")]
    directory: PathBuf,
    #[command(flatten)]
    measured: MeasuredArguments,
    /// The page [default: DIR/report.html]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let home = published::directory(&arguments.directory);
    let data = published::open(&home)?;
    let file = arguments.output.clone().unwrap_or_else(|| home.join("report.html"));
    let results = home.join("results.h5");
    let inputs = arguments.measured.files().chain([results.as_path()]);
    let is_report = |beginning: &[u8]| beginning.starts_with(BEGINNING.as_bytes());
    let output = OutputFiles::new("report", inputs).check(&file, is_report)?;
    let measured = arguments.measured.read(measured::radius(&data))?;
    measured.iter().for_each(|measured| {
        measured::note_units(measured, &data.dimensions);
        measured::note_temperatures(measured, measured::has_temperature(&data));
    });
    let page = page(&data, measured.as_ref())?;
    output.write(page.html.as_bytes())?;
    let mut text = format!("{}: {}\n", shown(&file), bytes(page.html.len() as u64));
    for note in &page.notes {
        text += &format!("note: {note}\n");
    }
    console::print(&text)?;
    Ok(Exit::Success)
}
