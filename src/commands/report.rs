//! `stribeck report`: one page of HTML that shows a published data set.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

use clap::Args;

use super::measured::MeasuredArguments;
use super::{CliError, Exit, console, published, replaceable};
use crate::format::bytes;
use crate::report::{BEGINNING, page};
use stribeck_input::shown;
use stribeck_sweep::store::write_whole;

#[derive(Clone, Debug, Args)]
#[command(after_help = "\
Examples:
  stribeck report results/quick                         then open results/quick/report.html
  stribeck report results/quick -o for-a-colleague.html
  stribeck report results/rubber --measured points.csv  with measured points in the curves of friction

One file that works without a network, in any browser of 2021 or later: surfaces and maps with a slider for f, any
case with its fields, curves, errors against seconds, failures, a table to sort and download, and the sweep file.
Large sweeps are thinned, and the page says how. docs/report.md has more.")]
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
    let data = published::open(&arguments.directory)?;
    let file = arguments.output.clone().unwrap_or_else(|| arguments.directory.join("report.html"));
    replaceable::check(&file, "report", "name another file", || is_report(&file))?;
    let measured = arguments.measured.read()?;
    let page = page(&data, measured.as_ref())?;
    write_whole(file.clone(), page.html.as_bytes())?;
    let mut text = format!("{}: {}\n", shown(&file), bytes(page.html.len() as u64));
    for note in &page.notes {
        text += &format!("note: {note}\n");
    }
    console::print(&text)?;
    Ok(Exit::Success)
}

/// True if a report wrote the file.
fn is_report(path: &Path) -> io::Result<bool> {
    if path.file_name().is_none() {
        return Err(ErrorKind::IsADirectory.into());
    }
    let mut beginning = vec![0; BEGINNING.len()];
    File::open(path)?.read_exact(&mut beginning)?;
    Ok(beginning == BEGINNING.as_bytes())
}
