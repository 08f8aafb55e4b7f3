//! The fields of one case in a file: as CSV, or as the data set that a run of this case alone would publish.

use std::fs;
use std::path::Path;

use super::output_file::{OutputFile, OutputFiles, or_empty};
use super::{CliError, console};
use crate::pictures::Table;
use stribeck_lab::si_units;
use stribeck_sweep::campaign::publish_solved;
use stribeck_sweep::store::{CaseEntry, DataSet, Status};
use stribeck_sweep::{Field, Sweep};

/// How an HDF5 file begins.
const SIGNATURE: &[u8] = b"\x89HDF\r\n\x1a\n";
/// How a table of fields begins.
const X: &str = "x (a0)";

/// True for a file of HDF5, by its name.
fn is_data_set(file: &Path) -> bool {
    file.extension().is_some_and(|extension| extension == "h5")
}

/// Checks the name of a file of fields.
///
/// # Errors
/// What is allowed.
pub fn parse(text: &str) -> Result<std::path::PathBuf, String> {
    let file = std::path::PathBuf::from(text);
    match is_data_set(&file) || file.extension().is_some_and(|extension| extension == "csv") {
        true => Ok(file),
        false => Err("give a name that ends in .csv (a table) or .h5 (HDF5)".to_owned()),
    }
}

/// Checks that the file may be written, before the case is solved.
///
/// # Errors
/// As [`OutputFiles::check`].
pub fn check(file: &Path, sweep_file: Option<&Path>) -> Result<OutputFile, CliError> {
    let is_ours = |beginning: &[u8]| match is_data_set(file) {
        true => beginning.starts_with(SIGNATURE),
        false => beginning.starts_with(X.as_bytes()),
    };
    OutputFiles::new("solve", sweep_file).check(file, or_empty(is_ours))
}

/// Writes the fields of the only case of a sweep, whose numbers are those at S = 1; says so if it has none.
///
/// # Errors
/// [`CliError`] if the disk does not take them.
pub fn write(output: OutputFile, file: &Path, sweep: &Sweep, entry: CaseEntry) -> Result<(), CliError> {
    if entry.outcome == Status::Failed {
        console::tell("note: the case failed and has no fields; no file is written");
        return Ok(());
    }
    let system = |source| CliError::System { action: "make a directory for the fields", source };
    let folder = tempfile::tempdir().map_err(system)?;
    publish_solved(sweep, folder.path(), &[entry])?;
    let content = match is_data_set(file) {
        true => fs::read(folder.path().join("results.h5")).map_err(system)?,
        false => table(&DataSet::open(folder.path())?)?.csv(),
    };
    output.write(&content)
}

/// The fields along x, which is in a₀, and in m too where the case is one of the laboratory.
fn table(data: &DataSet) -> Result<Table, CliError> {
    let place = [0, 0, 0];
    let units = |field: Field| if data.laboratory { si_units(field.units()) } else { field.units() };
    let mut names = vec![X.to_owned()];
    let mut columns = vec![data.x.clone()];
    if data.laboratory {
        let a0 = data.variable("a0")?[0];
        names.push("x (m)".to_owned());
        columns.push(data.x.iter().map(|x| x * a0).collect());
    }
    for &field in &data.fields {
        names.push(format!("{} ({})", field.name(), units(field)));
        columns.push(data.field(field, place)?);
    }
    let mut table = Table::new(&names.iter().map(String::as_str).collect::<Vec<_>>());
    for at in 0..data.x.len() {
        table.row(&[], &columns.iter().map(|column| column[at]).collect::<Vec<_>>());
    }
    Ok(table)
}
