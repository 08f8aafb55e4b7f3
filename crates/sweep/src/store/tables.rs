//! `summary.csv` and `timings.csv`.

use std::fmt::{self, Display, Formatter, Write};
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use super::StoreError;
use super::further_columns::FurtherColumn;
use super::publication::{Place, Point};
use super::record::CaseRecord;
use crate::{Column, Dimension};
use stribeck_lab::{Experiment, LaboratoryQuantity};

/// A table under a temporary name.
struct Table {
    writer: csv::Writer<BufWriter<File>>,
    path: PathBuf,
    /// The text of a field while it is made.
    text: String,
    /// True if rows have the slide-to-roll ratio before f.
    has_ratios: bool,
}

impl Table {
    /// With a header behind the case and its parameters.
    fn create(path: &Path, has_ratios: bool, header: impl Iterator<Item = String>) -> Result<Self, StoreError> {
        let file = File::create(path).map_err(StoreError::file(path, "create"))?;
        let writer = csv::Writer::from_writer(BufWriter::new(file));
        let mut table = Self { writer, path: path.to_owned(), text: String::new(), has_ratios };
        let ratio = has_ratios.then_some(Dimension::SLIDE_ROLL);
        let parameters = ["case"].into_iter().chain(ratio).chain(["f", "alpha", "beta"]);
        for name in parameters.map(str::to_owned).chain(header) {
            table.field(name)?;
        }
        table.end_row()?;
        Ok(table)
    }

    fn field(&mut self, field: impl Display) -> Result<(), StoreError> {
        self.text.clear();
        write!(self.text, "{field}").expect("writing to memory does not fail");
        self.writer.write_field(&self.text).map_err(|error| failure(&self.path, error))
    }

    /// A case and its parameters, as each row begins.
    fn begin_row(&mut self, point: &Point) -> Result<(), StoreError> {
        self.field(point.case)?;
        self.numbers(self.has_ratios.then_some(point.slide_roll))?;
        self.numbers(point.numbers)
    }

    fn numbers(&mut self, numbers: impl IntoIterator<Item = f64>) -> Result<(), StoreError> {
        numbers.into_iter().try_for_each(|number| self.field(Number(number)))
    }

    fn end_row(&mut self) -> Result<(), StoreError> {
        self.writer.write_record(None::<&[u8]>).map_err(|error| failure(&self.path, error))
    }

    fn finish(mut self) -> Result<(), StoreError> {
        self.writer.flush().map_err(StoreError::file(&self.path, "write"))
    }
}

fn failure(path: &Path, error: csv::Error) -> StoreError {
    let source = match error.into_kind() {
        csv::ErrorKind::Io(source) => source,
        kind => std::io::Error::other(format!("{kind:?}")),
    };
    StoreError::file(path, "write")(source)
}

/// `summary.csv` while it is written: one row per place of the grid.
pub(super) struct Summary(Table);

impl Summary {
    /// With the quantities and scales of an experiment, if there is one, and further columns.
    pub(super) fn create(
        path: &Path,
        has_ratios: bool,
        experiment: Option<&Experiment>,
        more: &[FurtherColumn],
    ) -> Result<Self, StoreError> {
        let quantities = experiment.into_iter().flat_map(Experiment::given).map(LaboratoryQuantity::name);
        let columns = Column::summary().map(Column::name);
        let others = experiment.into_iter().flat_map(Experiment::variables).map(|((name, ..), _)| name);
        let header = quantities.chain(["status", "reason"]).chain(columns).chain(others).map(str::to_owned);
        Table::create(path, has_ratios, header.chain(more.iter().map(|column| column.name.clone()))).map(Self)
    }

    pub(super) fn rows(&mut self, places: &[Place]) -> Result<(), StoreError> {
        places.iter().try_for_each(|place| self.row(place))
    }

    fn row(&mut self, place: &Place) -> Result<(), StoreError> {
        let (table, experiment) = (&mut self.0, place.point.experiment.as_ref());
        table.begin_row(&place.point)?;
        if let Some(experiment) = experiment {
            table.numbers(experiment.given().map(|quantity| experiment.value(quantity)))?;
        }
        table.field(place.status.name())?;
        table.field(&place.reason)?;
        table.numbers(Column::summary().map(|column| place.values[column]))?;
        if let Some(experiment) = experiment {
            table.numbers(experiment.variables().map(|(_, value)| value))?;
        }
        table.numbers(place.more.iter().copied())?;
        table.end_row()
    }

    pub(super) fn finish(self) -> Result<(), StoreError> {
        self.0.finish()
    }
}

/// `timings.csv` while it is written: the rows of the summary, with what each case cost.
pub(super) struct Timings(Table);

impl Timings {
    pub(super) fn create(path: &Path, has_ratios: bool) -> Result<Self, StoreError> {
        let header = ["seconds", "iterations", "factorisations", "seed", "status"];
        Table::create(path, has_ratios, header.into_iter().map(str::to_owned)).map(Self)
    }

    pub(super) fn row(&mut self, place: &Place, case: &CaseRecord) -> Result<(), StoreError> {
        let table = &mut self.0;
        table.begin_row(&place.point)?;
        table.field(Number(case.seconds))?;
        table.field(case.iterations)?;
        table.field(case.factorisations)?;
        table.field(&case.seed)?;
        table.field(place.status.name())?;
        table.end_row()
    }

    pub(super) fn finish(self) -> Result<(), StoreError> {
        self.0.finish()
    }
}

/// A number as the shortest text that reads back as the same; empty for NaN.
struct Number(f64);

impl Display for Number {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        if self.0.is_nan() { Ok(()) } else { write!(formatter, "{:?}", self.0) }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::Number;

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        #[test]
        fn numbers_read_back_as_they_were(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(!value.is_nan());
            let text = Number(value).to_string();
            prop_assert_eq!(text.parse::<f64>().unwrap().to_bits(), bits);
            prop_assert!(text.len() <= 24, "{} is not short", text);
        }
    }

    #[test]
    fn no_value_is_empty_and_infinity_is_inf() {
        assert_eq!([f64::NAN, f64::INFINITY, 0.1].map(|value| Number(value).to_string()), ["", "inf", "0.1"]);
    }
}
