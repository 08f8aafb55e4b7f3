//! Tables of shift factors.

use std::path::Path;

use super::ShiftFactors;
use super::table_fields::SHIFT_FIELDS;
use crate::table::{Column, ColumnChoice, TableError, TableFile, Understood, bytes};
use stribeck_input::printable;

impl ShiftFactors {
    /// Reads a table with the columns `temperature` and `log_shift_factor` (log₁₀ a_T) or `shift_factor` (a_T), and
    /// says what was understood of it. Choices say what columns hold whose names do not tell.
    ///
    /// # Errors
    /// [`TableError`] if the file cannot be read, a column is missing, or the values are no shift factors.
    pub fn read(path: &Path, choices: &[ColumnChoice]) -> Result<(Self, Understood), TableError> {
        Self::of(path, &bytes("table of shift factors", path)?, choices)
    }

    /// The shift factors in the bytes of a file, likewise.
    ///
    /// # Errors
    /// As [`ShiftFactors::read`].
    pub fn of(path: &Path, bytes: &[u8], choices: &[ColumnChoice]) -> Result<(Self, Understood), TableError> {
        let file = TableFile::of(path, bytes)?;
        let refuse = |what: String| TableError::NotATable { path: path.to_owned(), what };
        let table = &file.tables[0];
        let columns = table.columns(&SHIFT_FIELDS, choices).map_err(refuse)?;
        let factors = columns.find("log_shift_factor").or_else(|| columns.find("shift_factor"));
        let (Some(temperatures), Some(factors)) = (columns.find("temperature"), factors) else {
            return Err(refuse(
                "it has no shift factors: the columns are temperature (degC) and log_shift_factor, or shift_factor; \
                 name them so, or say which they are: --shift-columns \"temperature=#1 (degC),log_shift_factor=#2\""
                    .to_owned(),
            ));
        };
        let mut pairs = Vec::new();
        for row in table.rows() {
            let value = |column: &Column, allowed: &str, fits: fn(f64) -> bool| {
                column.value(&row).filter(|value| fits(*value)).ok_or_else(|| TableError::Value {
                    path: path.to_owned(),
                    line: row.line,
                    column: printable(&column.heading).into_owned(),
                    value: column.text(&row).to_owned(),
                    allowed: allowed.to_owned(),
                })
            };
            let allowed = "a temperature of a laboratory is above 100 K; write the unit, as in temperature (degC)";
            let temperature = value(temperatures, allowed, |value| value > 100.0)?;
            let log = if factors.field == "log_shift_factor" {
                value(factors, "log a_T is a number", |_| true)?
            } else {
                value(factors, "a_T is a number above 0", |value| value > 0.0)?.log10()
            };
            pairs.push((temperature, log));
        }
        let factors = Self::new(pairs).map_err(|error| refuse(error.to_string()))?;
        Ok((factors, Understood::new(&file, table, &columns)))
    }
}
