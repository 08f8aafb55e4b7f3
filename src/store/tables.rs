//! `summary.csv` and `timings.csv`.

use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use super::publication::Place;
use super::{StoreError, Timing};
use crate::model::COLUMNS;

/// A table under a temporary name.
struct Table {
    writer: csv::Writer<BufWriter<File>>,
    path: PathBuf,
}

impl Table {
    fn create(path: &Path, header: &[&str]) -> Result<Self, StoreError> {
        let file = File::create(path).map_err(StoreError::file(path, "create"))?;
        let mut table = Self { writer: csv::Writer::from_writer(BufWriter::new(file)), path: path.to_owned() };
        table.row(header.iter().copied())?;
        Ok(table)
    }

    fn row<T: AsRef<[u8]>>(&mut self, row: impl IntoIterator<Item = T>) -> Result<(), StoreError> {
        self.writer.write_record(row).map_err(|error| {
            let source = match error.into_kind() {
                csv::ErrorKind::Io(source) => source,
                kind => std::io::Error::other(format!("{kind:?}")),
            };
            StoreError::file(&self.path, "write")(source)
        })
    }

    fn finish(mut self) -> Result<(), StoreError> {
        self.writer.flush().map_err(StoreError::file(&self.path, "write"))
    }
}

/// `summary.csv` while it is written: one row per place of the grid.
pub(super) struct Summary(Table);

impl Summary {
    pub(super) fn create(path: &Path) -> Result<Self, StoreError> {
        let columns = COLUMNS.iter().filter(|column| column.in_summary).map(|column| column.name);
        let header: Vec<&str> = ["case", "f", "alpha", "beta", "status", "reason"].into_iter().chain(columns).collect();
        Table::create(path, &header).map(Self)
    }

    pub(super) fn row(&mut self, place: &Place, parameters: [f64; 3]) -> Result<(), StoreError> {
        let mut row = vec![place.case.to_string()];
        row.extend(parameters.map(number));
        row.extend([place.status.name().to_owned(), place.reason.clone()]);
        let shown = COLUMNS.iter().zip(&place.values).filter(|(column, _)| column.in_summary);
        row.extend(shown.map(|(_, &value)| number(value)));
        self.0.row(&row)
    }

    pub(super) fn finish(self) -> Result<(), StoreError> {
        self.0.finish()
    }
}

/// `timings.csv` while it is written: the rows of the summary, with what each case cost.
pub(super) struct Timings(Table);

impl Timings {
    pub(super) fn create(path: &Path) -> Result<Self, StoreError> {
        let header = ["case", "f", "alpha", "beta", "seconds", "iterations", "factorisations", "seed", "status"];
        Table::create(path, &header).map(Self)
    }

    pub(super) fn row(&mut self, place: &Place, parameters: [f64; 3], timing: &Timing) -> Result<(), StoreError> {
        let mut row = vec![place.case.to_string()];
        row.extend(parameters.map(number));
        row.extend([number(timing.seconds), timing.iterations.to_string(), timing.factorisations.to_string()]);
        row.extend([timing.seed.clone(), place.status.name().to_owned()]);
        self.0.row(&row)
    }

    pub(super) fn finish(self) -> Result<(), StoreError> {
        self.0.finish()
    }
}

/// The shortest text that reads back as the same number; empty for NaN.
fn number(value: f64) -> String {
    if value.is_nan() { String::new() } else { format!("{value:?}") }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::number;

    proptest! {
        #[test]
        fn numbers_read_back_as_they_were(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(!value.is_nan());
            let text = number(value);
            prop_assert_eq!(text.parse::<f64>().unwrap().to_bits(), bits);
            prop_assert!(text.len() <= 24, "{} is not short", text);
        }
    }

    #[test]
    fn no_value_is_empty_and_infinity_is_inf() {
        assert_eq!([number(f64::NAN), number(f64::INFINITY), number(0.1)], ["", "inf", "0.1"]);
    }
}
