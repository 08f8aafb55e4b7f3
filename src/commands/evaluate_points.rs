//! The numbers of a surface at the points of a file.

use std::fs::File;
use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::Path;

use csv::StringRecord;
use rayon::ThreadPool;
use rayon::prelude::*;

use super::output_file::{OutputFiles, or_empty, unwritten};
use super::{CliError, Exit, console, number};
use stribeck_input::printable;
use stribeck_solver::shortest;
use stribeck_surface::{Axis, Evaluator, Surface};

/// Rows that are in memory at a time.
const ROWS: usize = 16_384;
/// Rows that a thread takes at a time.
const CHUNK: usize = 512;

/// The files of `stribeck evaluate --points`.
pub struct PointFiles<'a> {
    /// The surface, unless it is the one that is built in.
    pub surface: Option<&'a Path>,
    /// The points.
    pub points: &'a Path,
    /// Where the rows go; standard output if not given.
    pub output: Option<&'a Path>,
}

/// The points of a file: each row with what it has, the quantities, and where it lies. Rows keep their order, and are
/// evaluated by several threads.
pub fn evaluate(surface: &Surface, files: &PointFiles<'_>, threads: NonZeroUsize) -> Result<Exit, CliError> {
    let mut reader = csv::Reader::from_path(files.points).map_err(|error| unreadable(files.points, error))?;
    let header = reader.headers().map_err(|error| unreadable(files.points, error))?.clone();
    let rows = Rows { surface, file: files.points, columns: columns(surface, files.points, &header)? };
    let failed = |source| CliError::System { action: "start threads", source: io::Error::other(source) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build().map_err(failed)?;
    let mut write = |sink: &mut dyn Write, name: &Path| rows.write(&mut reader, &pool, (sink, name));
    let Some(output) = files.output else {
        return outside_told(surface, write(&mut io::stdout().lock(), Path::new("standard output"))?);
    };
    let header = format!("{},status\n", surface.quantities().collect::<Vec<_>>().join(","));
    let is_ours = |beginning: &[u8]| {
        let line = beginning.split_inclusive(|byte| *byte == b'\n').next().unwrap_or_default();
        line.ends_with(header.as_bytes())
    };
    let inputs = files.surface.into_iter().chain([files.points]);
    let file = OutputFiles::new("evaluate", inputs).check(output, or_empty(is_ours))?;
    outside_told(surface, file.fill(|writer| write(writer, output))?)
}

/// The place of each axis among the columns.
fn columns(surface: &Surface, file: &Path, header: &StringRecord) -> Result<Vec<usize>, CliError> {
    if let Some(taken) = surface.quantities().chain(["status"]).find(|name| header.iter().any(|it| it == *name)) {
        let what = format!("it has a column `{taken}` already, which would be there twice; rename it");
        return Err(unreadable(file, what));
    }
    let place = |axis: &Axis| {
        let found = header.iter().position(|name| name.trim() == axis.name);
        let what = || format!("it has no column `{}`; name one so in the first line", axis.name);
        found.ok_or_else(|| unreadable(file, what()))
    };
    surface.axes().iter().map(place).collect()
}

fn unreadable(file: &Path, what: impl ToString) -> CliError {
    CliError::Points { file: file.to_owned(), what: what.to_string() }
}

/// How many points there are, and how many of them lie outside.
#[derive(Default)]
struct Points {
    all: u64,
    outside: u64,
}

/// How the rows of a file become those of the output.
struct Rows<'a> {
    surface: &'a Surface,
    file: &'a Path,
    columns: Vec<usize>,
}

impl Rows<'_> {
    /// Writes the rows of the points with their values.
    fn write(
        &self,
        reader: &mut csv::Reader<File>,
        pool: &ThreadPool,
        (sink, name): (&mut dyn Write, &Path),
    ) -> Result<Points, CliError> {
        let failed = unwritten(name);
        let mut header = reader.headers().map_err(|error| unreadable(self.file, error))?.clone();
        self.surface.quantities().chain(["status"]).for_each(|name| header.push_field(name));
        sink.write_all(&text(&[header]).map_err(&failed)?).map_err(&failed)?;
        let (mut points, mut rows) = (Points::default(), vec![StringRecord::new(); ROWS]);
        loop {
            let mut taken = 0;
            while taken < ROWS && reader.read_record(&mut rows[taken]).map_err(|error| unreadable(self.file, error))? {
                taken += 1;
            }
            let chunks = rows[..taken].par_chunks_mut(CHUNK);
            let evaluate =
                || chunks.map_init(|| self.surface.evaluator(), |it, rows| self.evaluate(it, rows)).collect();
            let outside: Vec<Result<u64, CliError>> = pool.install(evaluate);
            for chunk in outside {
                points.outside += chunk?;
            }
            let texts: Vec<io::Result<Vec<u8>>> = pool.install(|| rows[..taken].par_chunks(CHUNK).map(text).collect());
            for text in texts {
                sink.write_all(&text.map_err(&failed)?).map_err(&failed)?;
            }
            points.all += taken as u64;
            if taken < ROWS {
                sink.flush().map_err(failed)?;
                return Ok(points);
            }
        }
    }

    /// Adds to rows what the surface has there. Returns how many points lie outside.
    fn evaluate(&self, evaluator: &mut Evaluator<'_>, rows: &mut [StringRecord]) -> Result<u64, CliError> {
        let (mut outside, mut point) = (0, vec![0.0; self.columns.len()]);
        for row in rows {
            self.read(row, &mut point)?;
            match evaluator.values(&point) {
                Ok(values) => {
                    values.iter().for_each(|value| row.push_field(&shortest(*value)));
                    row.push_field("inside");
                }
                Err(_) => {
                    outside += 1;
                    self.surface.quantities().for_each(|_| row.push_field(""));
                    row.push_field("outside");
                }
            }
        }
        Ok(outside)
    }

    /// Reads the coordinates of a row.
    fn read(&self, row: &StringRecord, point: &mut [f64]) -> Result<(), CliError> {
        for ((x, &column), axis) in point.iter_mut().zip(&self.columns).zip(self.surface.axes()) {
            let text = row[column].trim();
            *x = number::number(text).ok_or_else(|| {
                let line = row.position().map_or(0, csv::Position::line);
                let what = format!("line {line}: `{}` in the column `{}` is no number", printable(text), axis.name);
                unreadable(self.file, what)
            })?;
        }
        Ok(())
    }
}

/// Rows as they stand in a CSV.
fn text(rows: &[StringRecord]) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row).map_err(io::Error::other)?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}

/// Tells of points that lie outside.
fn outside_told(surface: &Surface, Points { all, outside }: Points) -> Result<Exit, CliError> {
    if outside == 0 {
        return Ok(Exit::Success);
    }
    let range = |axis: &Axis| format!("{} from {} to {}", axis.name, shortest(axis.from), shortest(axis.to));
    let ranges = surface.axes().iter().map(range).collect::<Vec<_>>().join(", ");
    console::tell(&format!("{outside} of {all} points lie outside the surface, which has {ranges}"));
    Ok(Exit::CasesFailed)
}
