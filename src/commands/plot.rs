//! `stribeck plot`: pictures of a published data set.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::at::{self, At};
use super::measured::{self, MeasuredArguments};
use super::number::number;
use super::output_file::{OutputFile, OutputFiles, or_empty};
use super::paper::PaperArguments;
use super::{CliError, Exit, console, published};
use crate::format::count;
use crate::pictures::{
    AxisScale, Format, Kind, Picture, Request, SweepData, is_picture, largest_error, made_with, pictures,
};
use stribeck_input::{printable, shown};
use stribeck_sweep::Sweep;
use stribeck_sweep::store::create_directory;

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck plot results/quick                                       all that makes sense
  stribeck plot results/quick --what surfaces,maps --of mu_tot --format png
  stribeck plot results/quick --what curves --of mu_v --along alpha --beta 10,100,1000 --f 100
  stribeck plot results/quick --what curves --of mu_tot,mu_v,mu_h --together --along alpha --beta 10 --f 100
  stribeck plot results/quick --what profiles --of pressure --alpha 1 --beta 100,1000 --x=-1,1.5
  stribeck plot results/quick --what stress --f 100 --alpha 0.1,1,10 --beta 1000
  stribeck plot results/quick --what curves --of mu_v --format pdf --width 85mm --font-size 8 --no-title
  stribeck plot results/experiment --what curves --of mu_drag --along entrainment_speed \\
      --measured docs/how-to/instrument-files/traction.txt",
    after_help = "\
The numbers behind each picture are written beside it as CSV. Values that the sweep has not are replaced by the
nearest ones it has, which the picture names. A picture that was drawn with options is kept where plot is run without
any: remove it, or draw elsewhere with -o. Columns and fields are those of docs/reference/columns.md.
docs/how-to/figures.md and docs/gallery.md show pictures of each kind with their commands."
)]
pub struct Arguments {
    /// A results directory
    #[arg(value_name = "DIR")]
    directory: PathBuf,
    /// Kinds of pictures [default: all that the sweep has something for]
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', value_enum)]
    what: Vec<Kind>,
    /// Columns and fields to be shown [default: a choice]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    of: Vec<String>,
    /// Axis along which curves run: f, alpha, beta, or one of the laboratory [default: each that has several values]
    #[arg(long, value_name = "AXIS")]
    along: Option<String>,
    /// Values of f
    #[arg(long, value_name = "F,…", value_delimiter = ',')]
    f: Vec<f64>,
    /// Values of α; inf is one
    #[arg(long, value_name = "A,…", value_delimiter = ',')]
    alpha: Vec<f64>,
    /// Values of β
    #[arg(long, value_name = "B,…", value_delimiter = ',')]
    beta: Vec<f64>,
    /// Values of any axis, as in load=100,200 or speed="3 mm/s"; may be given several times
    #[arg(long, value_name = "AXIS=V,…", value_parser = at::parse)]
    at: Vec<At>,
    #[command(flatten)]
    measured: MeasuredArguments,
    /// Where profiles and stresses are shown, in a₀ [default: all of the sweep's x]
    #[arg(long, value_name = "FROM,TO", value_parser = range, allow_hyphen_values = true)]
    x: Option<(f64, f64)>,
    /// Ends of the vertical axis of curves, profiles and loops [default: from the values]
    #[arg(long, value_name = "FROM,TO", value_parser = range, allow_hyphen_values = true)]
    y: Option<(f64, f64)>,
    /// Scale of the quantity
    #[arg(long, value_enum, default_value_t)]
    scale: AxisScale,
    /// All quantities of curves in one picture
    #[arg(long)]
    together: bool,
    /// No known limits and approximations beside the solutions
    #[arg(long)]
    bare: bool,
    /// Format of the pictures
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    paper: PaperArguments,
    /// Directory of the pictures [default: DIR/figures]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

impl Arguments {
    /// The options by which a picture differs from the one of its name that is drawn without any.
    fn changing(&self) -> Vec<&'static str> {
        let all = [
            ("--f", !self.f.is_empty()),
            ("--alpha", !self.alpha.is_empty()),
            ("--beta", !self.beta.is_empty()),
            ("--at", !self.at.is_empty()),
            ("--measured", self.measured.files().next().is_some()),
            ("--x", self.x.is_some()),
            ("--y", self.y.is_some()),
            ("--scale", self.scale != AxisScale::Auto),
            ("--bare", self.bare),
        ];
        all.into_iter().filter(|(_, is_there)| *is_there).map(|(name, _)| name).collect()
    }
}

/// Two numbers, the first below the second.
fn range(text: &str) -> Result<(f64, f64), String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    match numbers.as_deref() {
        Some([from, to]) if from < to && from.is_finite() && to.is_finite() => Ok((*from, *to)),
        _ => Err("two numbers with a comma between them, the first below the second, as in -1,1.5".to_owned()),
    }
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let home = published::directory(&arguments.directory);
    let data = published::open(&home)?;
    let sweep = match Sweep::parse("sweep", &data.sweep_text) {
        Ok(sweep) if sweep.grid.dimensions() == data.dimensions => Some(sweep),
        _ => {
            console::tell(&format!(
                "note: no known limits are drawn beside the solutions: the sweep file in results.h5, which version {} \
                 of the program wrote, is none for this version",
                printable(&data.version)
            ));
            None
        }
    };
    let measured = arguments.measured.read(measured::radius(&data))?;
    measured.iter().for_each(|measured| {
        measured::note_units(measured, &data.dimensions);
        measured::note_temperatures(measured, measured::has_temperature(&data));
    });
    let named = [("f", &arguments.f), ("alpha", &arguments.alpha), ("beta", &arguments.beta)].into_iter();
    let named = named.filter(|(_, values)| !values.is_empty()).map(|(name, values)| (name.to_owned(), values.clone()));
    let values: Vec<(String, Vec<f64>)> = named.chain(at::all(&arguments.at)).collect();
    let sweep = SweepData::new(data, sweep, measured, &values)?;
    let request = Request {
        kinds: arguments.what.clone(),
        of: arguments.of.clone(),
        along: arguments.along.clone(),
        values,
        x: arguments.x,
        y: arguments.y,
        scale: arguments.scale,
        together: arguments.together,
        bare: arguments.bare,
    };
    let pictures = pictures(&sweep, &request)?;
    let directory = arguments.output.clone().unwrap_or_else(|| home.join("figures"));
    if let Some(measured) = sweep.measured.as_ref().filter(|_| !pictures.iter().any(Picture::shows_points)) {
        console::tell(&format!(
            "note: no point of {} is drawn: no curve here is of {} along a column of it, at the other columns' values",
            shown(&measured.files[0]),
            measured.column
        ));
    }
    let mut text = write(arguments, &directory, pictures)?;
    let has_curves = arguments.what.is_empty() || arguments.what.contains(&Kind::Curves);
    if let Some(error) = largest_error(&sweep, &request)?.filter(|_| has_curves) {
        text += &format!("; estimated errors of curves are at most {} of the largest value", rounded_up(error));
    }
    text += "\n";
    console::print(&text)?;
    Ok(Exit::Success)
}

/// Writes the pictures with their tables; their names and their number.
fn write(arguments: &Arguments, directory: &Path, mut pictures: Vec<Picture>) -> Result<String, CliError> {
    let paper = arguments.paper.paper(&arguments.changing());
    if paper.note.is_empty() {
        pictures.retain(|picture| !is_kept(directory, &picture.name));
    }
    let files = OutputFiles::new("plot", arguments.measured.files());
    let outputs = pictures.iter().map(|picture| outputs(&files, directory, &picture.name, arguments.format));
    let outputs = outputs.collect::<Result<Vec<_>, _>>()?;
    let paint = |picture: &mut Picture| {
        arguments.paper.entitle(&mut picture.chart);
        picture.chart.paint(arguments.format, &paper)
    };
    // What cannot be drawn leaves no directory behind.
    let painted = pictures.iter_mut().map(paint).collect::<Result<Vec<_>, _>>()?;
    create_directory(directory)?;
    let mut text = String::new();
    for ((picture, [file, table]), painted) in pictures.iter().zip(outputs).zip(painted) {
        // First the picture, by which the table beside it is known as ours.
        file.write(&painted)?;
        table.write(&picture.table.csv())?;
        let file = directory.join(format!("{}.{}", picture.name, arguments.format.extension()));
        text += &format!("{}\n", shown(&file));
    }
    Ok(text + &format!("{}, each with its numbers as .csv", count(pictures.len() as u64, "picture")))
}

/// True for a picture that is there in some format and was drawn with options; says that it stays.
fn is_kept(directory: &Path, name: &str) -> bool {
    let path = |format: &Format| directory.join(format!("{name}.{}", format.extension()));
    let with = |format| Some((path(format), drawn_with(&path(format))?)).filter(|(_, options)| !options.is_empty());
    let found = Format::value_variants().iter().find_map(with);
    if let Some((file, options)) = &found {
        console::tell(&format!(
            "note: {} stays, which was drawn with {options}: remove it with its .csv, or draw elsewhere with -o DIR",
            shown(file)
        ));
    }
    found.is_some()
}

/// An error with one digit, not rounded below itself.
fn rounded_up(error: f64) -> String {
    let unit = 10_f64.powf(error.log10().floor());
    format!("{:.0e}", (error / unit).ceil() * unit)
}

/// The files of a picture and of its numbers. A table is ours if a picture of ours stands beside it.
fn outputs(files: &OutputFiles<'_>, directory: &Path, name: &str, format: Format) -> Result<[OutputFile; 2], CliError> {
    let path = |extension: &str| directory.join(format!("{name}.{extension}"));
    let has_picture = Format::value_variants().iter().any(|format| drawn_with(&path(format.extension())).is_some());
    Ok([files.check(&path(format.extension()), or_empty(is_picture))?, files.check(&path("csv"), |_| has_picture)?])
}

/// The options with which a picture of ours was drawn, if one is there.
fn drawn_with(file: &Path) -> Option<String> {
    let mut beginning = Vec::new();
    let read = File::open(file).and_then(|file| file.take(4096).read_to_end(&mut beginning));
    read.ok().filter(|_| file.is_file()).and_then(|_| made_with(&beginning))
}
