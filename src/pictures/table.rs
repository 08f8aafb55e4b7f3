//! The numbers behind a picture, as CSV.

use stribeck_solver::shortest;

/// A table with one header line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with these columns.
    pub fn new(header: &[&str]) -> Self {
        Self { rows: vec![header.iter().map(|name| (*name).to_owned()).collect()] }
    }

    /// Adds a row that begins with words and goes on with numbers; NaN is empty.
    pub fn row(&mut self, words: &[&str], numbers: &[f64]) {
        let number = |number: &f64| if number.is_nan() { String::new() } else { shortest(*number) };
        self.rows.push(words.iter().map(|word| (*word).to_owned()).chain(numbers.iter().map(number)).collect());
    }

    /// The rows, the header first.
    pub fn rows(&self) -> &[Vec<String>] {
        &self.rows
    }

    /// The table as CSV.
    pub fn csv(&self) -> Vec<u8> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        for row in &self.rows {
            writer.write_record(row).expect("rows are as long as their header, and memory takes them");
        }
        writer.into_inner().expect("memory takes them")
    }
}
