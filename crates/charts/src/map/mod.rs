//! One quantity over two axes: what the chart is given.

mod contours;
mod layout;

use crate::ChartError;
use crate::chart::Drawing;
use crate::checks;
use crate::paint::scene::Scene;
use crate::paper::Paper;

/// A quantity as colour over two logarithmic axes, in panels: a row for each method, say, and a column for each value
/// of a third parameter.
///
/// Each value of an axis has cells as wide as the way to its neighbours (in the logarithm). 0 and ∞ have cells of their
/// own at the ends of the axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Heading.
    pub title: String,
    /// Second line of the heading; may be empty.
    pub subtitle: String,
    /// Name of the horizontal axis: "α".
    pub x_label: String,
    /// Name of the vertical axis: "β".
    pub y_label: String,
    /// Label of each column of panels: "f = 100".
    pub columns: Vec<String>,
    /// Label of each row of panels.
    pub rows: Vec<String>,
    /// Values of the horizontal axis, increasing, ≥ 0; ∞ allowed.
    pub x: Vec<f64>,
    /// Values of the vertical axis, likewise.
    pub y: Vec<f64>,
    /// One panel for each row and column, row by row.
    pub panels: Vec<Panel>,
    /// From values to colours, the same in all panels.
    pub scale: ColourScale,
    /// Whether lines of equal value are drawn over the cells, at levels marked on the colour bar. They are interpolated
    /// between the values of the axes, and keep out of cells without a value, of those of 0 and ∞, and of zeros on a
    /// logarithmic scale.
    pub contours: bool,
}

/// One map: a cell for each y and x, x running fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// `y.len() * x.len()` cells.
    pub cells: Vec<Cell>,
}

/// What is known at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// The quantity; not negative if the scale is logarithmic.
    Value(f64),
    /// The case failed.
    Failed,
    /// There is no case here.
    Absent,
    /// The case was solved, but has no such quantity.
    Unknown,
    /// The case was solved, and that is all the map shows.
    Solved,
}

/// From values to colours.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourScale {
    /// Name of the quantity, beside the colour bar.
    pub label: String,
    /// Equal ratios, not equal differences, are equal steps of colour. Zeros then have a colour of their own.
    pub logarithmic: bool,
    /// Ends of the scale, low < high (> 0 if logarithmic); from the smallest to the largest value if none. Values
    /// beyond have the colour of the end, and the colour bar ends in a point there.
    pub range: Option<(f64, f64)>,
}

impl Drawing for Map {
    fn scene(&self, paper: &Paper, stretch: f64) -> Result<Scene, ChartError> {
        self.check()?;
        Ok(layout::draw(self, paper, stretch))
    }

    fn side_by_side(&self) -> usize {
        layout::columns(self)
    }
}

impl Map {
    /// Every value shown.
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> {
        self.cells().filter_map(|cell| if let Cell::Value(value) = cell { Some(*value) } else { None })
    }

    /// Every cell.
    pub(crate) fn cells(&self) -> impl Iterator<Item = &Cell> {
        self.panels.iter().flat_map(|panel| &panel.cells)
    }

    fn check(&self) -> Result<(), ChartError> {
        for (list, what) in [(self.rows.len(), "row of panels"), (self.columns.len(), "column of panels")] {
            if list == 0 {
                return Err(ChartError::Empty { chart: self.title.clone(), what });
            }
        }
        self.check_axis(&self.x, "value of the horizontal axis", &self.x_label)?;
        self.check_axis(&self.y, "value of the vertical axis", &self.y_label)?;
        let count = |what: String, found, wanted| checks::count(&self.title, what, found, wanted);
        count("panels".to_string(), self.panels.len(), self.rows.len() * self.columns.len())?;
        for (i, panel) in self.panels.iter().enumerate() {
            count(format!("cells in panel {}", i + 1), panel.cells.len(), self.x.len() * self.y.len())?;
            for (k, cell) in panel.cells.iter().enumerate() {
                if let Cell::Value(value) = cell {
                    let (row, column) = (&self.rows[i / self.columns.len()], &self.columns[i % self.columns.len()]);
                    let (x, y) = (self.x[k % self.x.len()], self.y[k / self.x.len()]);
                    let place = format!("{} = {x}, {} = {y}, \"{row}\", \"{column}\"", self.x_label, self.y_label);
                    self.check_value(*value, "a cell", place)?;
                }
            }
        }
        checks::range(&self.title, &self.scale.label, self.scale.range, self.scale.logarithmic)
    }

    fn check_axis(&self, values: &[f64], what: &'static str, label: &str) -> Result<(), ChartError> {
        if values.is_empty() {
            return Err(ChartError::Empty { chart: self.title.clone(), what });
        }
        for (i, value) in values.iter().enumerate() {
            let increasing = i == 0 || values[i - 1] < *value;
            if !(*value >= 0.0 && increasing) {
                let place = format!("the axis {label}");
                return Err(self.refused(
                    "a value",
                    *value,
                    place,
                    "values are not negative and increase; ∞ may be the last",
                ));
            }
        }
        Ok(())
    }

    fn check_value(&self, value: f64, what: &'static str, place: String) -> Result<(), ChartError> {
        if !value.is_finite() {
            return Err(self.refused(
                what,
                value,
                place,
                "values are finite; a case without one is Failed, Absent or Unknown",
            ));
        }
        if self.scale.logarithmic && value < 0.0 {
            return Err(self.refused(what, value, place, "nothing is below zero on a logarithmic scale"));
        }
        Ok(())
    }

    fn refused(&self, what: &'static str, value: f64, place: String, wanted: &'static str) -> ChartError {
        ChartError::Value { chart: self.title.clone(), what, value, place, wanted }
    }
}
