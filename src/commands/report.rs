//! `stribeck report`: one page of HTML that shows a published data set, a surface, or both.

use std::path::{Path, PathBuf};

use clap::Args;

use super::measured::{self, MeasuredArguments};
use super::output_file::OutputFiles;
use super::{CliError, Exit, console, published};
use crate::format::bytes;
use crate::report::{BEGINNING, Page, page, surface_page};
use stribeck_input::shown;
use stribeck_surface::Surface;
use stribeck_sweep::store::DataSet;

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck report results/quick                         then open results/quick/report.html
  stribeck report results/quick -o for-a-colleague.html
  stribeck report results/friction                      of a surface: sliders that move friction
  stribeck report results/experiment --measured docs/how-to/instrument-files/traction.txt",
    after_help = "\
One file that works without a network, in any browser of 2021 or later: friction curves, surfaces and maps with a
slider for f, cases with their fields, to pin and compare, errors against times, failures, a table to sort and
download, and the sweep file. Its address is a link to what it shows. Large sweeps are thinned, and the page says how.
A surface.json in the directory, from `stribeck surface`, adds sliders that move friction at any point.
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
    let file = arguments.output.clone().unwrap_or_else(|| home.join("report.html"));
    let [results, surface] = ["results.h5", "surface.json"].map(|name| home.join(name));
    let inputs = arguments.measured.files().chain([results.as_path(), surface.as_path()]);
    let is_report = |beginning: &[u8]| beginning.starts_with(BEGINNING.as_bytes());
    let files = OutputFiles::new("report", inputs);
    let check = || files.check(&file, is_report);
    let (output, page) = match (read_surface(&surface)?, results.exists()) {
        (Some(surface), false) => (check()?, page_of_surface(arguments, &surface)?),
        (surface, _) => {
            let data = published::open(&home)?;
            let output = check()?;
            (output, page_of_sweep(arguments, &data, surface.as_ref())?)
        }
    };
    output.write(page.html.as_bytes())?;
    let mut text = format!("{}: {}\n", shown(&file), bytes(page.html.len() as u64));
    for note in &page.notes {
        text += &format!("note: {note}\n");
    }
    console::print(&text)?;
    Ok(Exit::Success)
}

/// The surface of a results directory, if there is one.
fn read_surface(file: &Path) -> Result<Option<Surface>, CliError> {
    if !file.exists() {
        return Ok(None);
    }
    Surface::read(file).map(Some).map_err(|source| CliError::Surface { file: file.to_owned(), source })
}

fn page_of_sweep(arguments: &Arguments, data: &DataSet, surface: Option<&Surface>) -> Result<Page, CliError> {
    let measured = arguments.measured.read(measured::radius(data))?;
    measured.iter().for_each(|measured| {
        measured::note_units(measured, &data.dimensions);
        measured::note_temperatures(measured, measured::has_temperature(data));
    });
    Ok(page(data, measured.as_ref(), surface)?)
}

fn page_of_surface(arguments: &Arguments, surface: &Surface) -> Result<Page, CliError> {
    match arguments.measured.files().next() {
        None => Ok(surface_page(surface)),
        Some(_) => Err(CliError::Unused {
            option: "--measured",
            why: "points stand in the curves of a sweep, and the directory has a surface alone; leave it out"
                .to_owned(),
        }),
    }
}
