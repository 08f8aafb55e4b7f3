//! `stribeck study`: error against run time, and where each method is stable.

use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use clap::{Args, ValueEnum};

use super::destination::destination;
use super::output_file::OutputFiles;
use super::paper::PaperArguments;
use super::{CliError, Exit, console, shell, threads};
use crate::format::{count, duration};
use crate::pictures::Format;
use crate::study::{Findings, Meter, Picture, Row, Study, csv, is_picture_name, markdown, pictures, run};
use stribeck_input::shown;
use stribeck_solver::continuation::Interrupt;
use stribeck_sweep::campaign::CampaignError;
use stribeck_sweep::engine::{Progress, ProgressStyle, Signals};
use stribeck_sweep::store::{create_directory, holds_text, write_whole};

/// The file of a study in its directory; a directory that holds one is a study's own.
const COPY: &str = "study.toml";

/// The tables that a study writes.
const TABLES: [&str; 2] = ["study.csv", "study.md"];

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck study sweeps/study-small.toml                tables and pictures in results/study-small
  stribeck study sweeps/study-small.toml --quiet -o elsewhere/study --threads 2
  stribeck study sweeps/study-small.toml --format pdf --width 85mm --font-size 8 --no-title",
    after_help = "\
Written are study.csv (one row for each case and setting), study.md (tables) and pictures.
docs/reference/study-file.md has the keys of a study file and the columns. A case that fails is a row with its reason.
Where run times are measured one thread is used unless --threads says otherwise: with more, times are those
of a busy machine. Ctrl-C writes what is finished and ends with exit code 130; a study is not resumed.
Exit code 3: a case failed, as some do by intent in sweeps/study-quick.toml, which takes a minute."
)]
pub struct Arguments {
    /// The study file (TOML)
    study: PathBuf,
    /// Directory of the tables and pictures [default: results/<file stem>]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Solver threads [default: 1 where run times are measured, else all cores]
    #[arg(long, value_name = "N", value_parser = threads::parse)]
    threads: Option<NonZeroUsize>,
    /// Formats of the pictures
    #[arg(long, value_name = "FORMAT,…", value_delimiter = ',', value_enum, default_values_t = [Format::Svg, Format::Png])]
    format: Vec<Format>,
    #[command(flatten)]
    paper: PaperArguments,
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
}

pub fn execute(arguments: &Arguments, meter: Meter<'_>) -> Result<Exit, CliError> {
    let start = Instant::now();
    let study = Study::read(&arguments.study)?;
    let directory = destination(arguments.output.as_deref(), &study.name)?;
    check_available(&directory)?;
    let threads = match study.measure.error {
        true => arguments.threads.unwrap_or(NonZeroUsize::MIN),
        false => threads::number(arguments.threads),
    };
    // Before the work: whether letters fit, and maps, which are drawn without any row here.
    let paper = arguments.paper.paper(&[]);
    paper.check(1)?;
    for picture in pictures(&study, &[]) {
        picture.chart.paint(Format::Svg, &paper)?;
    }
    let interrupt = Arc::new(Interrupt::new());
    let signals = Signals::watch(&interrupt)
        .map_err(|source| CliError::System { action: "watch for signals that stop the study", source })?;
    // before the work, so that a disk that takes nothing is known before hours are spent
    create_directory(&directory)?;
    let copy = directory.join(COPY);
    if !copy.exists() {
        write_whole(copy, study.text.as_bytes())?;
    } else if !holds_text(&copy, &study.text) {
        let place = shown(&directory);
        console::tell(&format!("note: {place} has the results of another study file, which will be replaced"));
    }

    let all = study.cases.len() * study.variants.len();
    let progress = Progress::start(all as u64, "rows", ProgressStyle::detect(arguments.quiet))
        .map_err(|source| CliError::System { action: "start the thread that shows progress", source })?;
    let findings = run(&study, threads, meter, &interrupt, |converged| progress.count_case(converged))?;
    drop(progress);
    if findings.interrupted {
        let signal = signals.received().map_or_else(String::new, |signal| format!(" by {signal}"));
        let (done, place, command) = (findings.rows.len(), shown(&directory), shell::own_command());
        let written = if done == 0 {
            format!("none of {all} rows was finished, and no table is changed in {place}")
        } else {
            publish(arguments, &study, &findings.rows, &directory)?;
            format!("{done} of {all} rows are in {place}")
        };
        console::tell(&format!("interrupted{signal}: {written}; to begin again\n    {command}"));
        return Ok(Exit::Interrupted);
    }
    let drawn = publish(arguments, &study, &findings.rows, &directory)?;
    console::print(&summary(&study, &findings, &directory, &drawn, start.elapsed().as_secs_f64()))?;
    let failed = findings.rows.iter().any(|row| row.failure.is_some());
    Ok(if failed { Exit::CasesFailed } else { Exit::Success })
}

/// Checks that a study can write to a directory.
///
/// # Errors
/// [`CliError::NotADirectory`] if a file is there, [`CliError::Foreign`] if files are there that no study has written.
fn check_available(path: &Path) -> Result<(), CliError> {
    if path.exists() && !path.is_dir() {
        return Err(CampaignError::NotADirectory { path: path.to_owned() }.into());
    }
    if path.exists() && !path.join(COPY).exists() {
        let ours = |file: &PathBuf| {
            let name = file.file_name().unwrap_or_default();
            ["sweep.toml"].into_iter().chain(TABLES).any(|table| name == table) || is_picture(file)
        };
        if let Some(file) = files(path)?.into_iter().find(ours) {
            return Err(CliError::Foreign { file, command: "study" });
        }
    }
    Ok(())
}

/// The files in a directory, sorted.
fn files(directory: &Path) -> Result<Vec<PathBuf>, CliError> {
    let unreadable = |source| CliError::Directory { action: "read", path: directory.to_owned(), source };
    let entries = fs::read_dir(directory).map_err(unreadable)?;
    let mut files: Vec<PathBuf> =
        entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>().map_err(unreadable)?;
    files.sort();
    Ok(files)
}

/// True for a file that a study may have drawn.
fn is_picture(file: &Path) -> bool {
    let stem = file.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
    let mut formats = Format::value_variants().iter();
    let is_known = file.extension().is_some_and(|extension| formats.any(|format| extension == format.extension()));
    is_known && is_picture_name(stem)
}

/// Writes a file of the study. All in its directory are its own.
fn write(file: &Path, content: &[u8]) -> Result<(), CliError> {
    OutputFiles::new("study", []).check(file, |_| true)?.write(content)
}

/// Writes tables and pictures; how many pictures, and their formats.
fn publish(arguments: &Arguments, study: &Study, rows: &[Row], directory: &Path) -> Result<String, CliError> {
    let table = csv(study, rows).map_err(|error| CliError::System { action: "write a table", source: error.into() })?;
    write_whole(directory.join(COPY), study.text.as_bytes())?;
    write(&directory.join("study.csv"), &table)?;
    let paper = arguments.paper.paper(&[]);
    let mut drawn = pictures(study, rows);
    let mut written = Vec::new();
    for Picture { name, chart } in &mut drawn {
        arguments.paper.entitle(chart);
        for format in &arguments.format {
            let file = directory.join(format!("{name}.{}", format.extension()));
            write(&file, &chart.paint(*format, &paper)?)?;
            written.push(file);
        }
    }
    // pictures of the study before, which this one does not have
    for file in files(directory)?.iter().filter(|file| is_picture(file)) {
        if !written.contains(file) {
            fs::remove_file(file).map_err(|source| CliError::Unwritten {
                action: "remove",
                path: file.clone(),
                source,
            })?;
        }
    }
    let names: Vec<&str> = drawn.iter().map(|picture| picture.name.as_str()).collect();
    // A page shows no PDF.
    let shown = arguments.format.iter().find(|format| **format != Format::Pdf).unwrap_or(&Format::Pdf);
    write(&directory.join("study.md"), markdown(study, rows, (&names, *shown)).as_bytes())?;
    let formats: Vec<String> = arguments.format.iter().map(|format| format.extension().to_uppercase()).collect();
    Ok(format!("{} as {}", count(drawn.len() as u64, "picture"), formats.join(" and ")))
}

fn summary(study: &Study, findings: &Findings, directory: &Path, pictures: &str, seconds: f64) -> String {
    let rows = &findings.rows;
    let failed = rows.iter().filter(|row| row.failure.is_some()).count();
    let cases = count(study.cases.len() as u64, "case");
    let mut text = format!("{cases} with {}: ", count(study.variants.len() as u64, "setting"));
    text += &format!("{} converged, {failed} failed, in {}\n", rows.len() - failed, duration(seconds));
    for (method, variants) in study.methods() {
        let of = rows.iter().filter(|row| variants.contains(&row.variant));
        let failed = of.clone().filter(|row| row.failure.is_some()).count();
        text += &format!("  {method}: {} of {} converged\n", of.clone().count() - failed, of.count());
    }
    text + &format!("results in {}: study.md, study.csv, {pictures}\n", shown(directory))
}
