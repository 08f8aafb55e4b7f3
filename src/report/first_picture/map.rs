//! The total friction over two axes, as colour.

use super::super::thinning::evenly;
use super::Shown;
use crate::pictures::{AxisScale, PictureError, Quantity};
use stribeck_charts::{Cell, ColourScale, Map, Panel};
use stribeck_sweep::Column;
use stribeck_sweep::store::Status;

/// Most cells along an axis: a page has less than 14 MB.
const MOST_CELLS: usize = 30;

impl Shown<'_> {
    /// The total friction over the last two axes at the largest f; none if no case there has it, or an axis has no map.
    pub(super) fn map(&self) -> Result<Option<Map>, PictureError> {
        let quantity = Quantity::from(Column::MuTot);
        let all = quantity.values(self.data)?;
        let kept = [1, 2].map(|axis| evenly(self.length(axis), self.length(axis).min(MOST_CELLS)));
        let [x, y] = [1, 2].map(|axis| {
            let values = self.values(axis);
            kept[axis - 1].iter().map(|i| values[*i]).collect::<Vec<f64>>()
        });
        let cell = |place: usize| match self.statuses[place] {
            Status::Failed => Cell::Failed,
            Status::Converged if all[place].is_finite() => Cell::Value(all[place]),
            Status::Converged => Cell::Unknown,
        };
        let last = self.length(0) - 1;
        let places = kept[1].iter().flat_map(|k| kept[0].iter().map(move |j| [last, *j, *k]));
        let cells: Vec<Cell> = places.map(|indices| cell(self.place(indices))).collect();
        let has_value = cells.iter().any(|cell| matches!(cell, Cell::Value(_)));
        if !has_value || x.iter().chain(&y).any(|value| *value < 0.0) {
            return Ok(None);
        }
        let shown = all.iter().copied().filter(|value| value.is_finite());
        let (low, high) = shown.clone().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        let label = quantity.unit(self.data.laboratory, high).label(&quantity.title());
        let logarithmic = AxisScale::Auto.is_logarithmic(shown);
        Ok(Some(Map {
            title: self.data.title.clone(),
            subtitle: String::new(),
            x_label: self.axes[1].shown(x.iter().copied()).1,
            y_label: self.axes[2].shown(y.iter().copied()).1,
            columns: vec![String::new()],
            rows: vec![String::new()],
            x,
            y,
            panels: vec![Panel { cells }],
            scale: ColourScale { label, logarithmic, range: (low < high).then_some((low, high)) },
            // Lines among some of the cases would be other ones.
            contours: (1..3).all(|axis| self.length(axis) <= MOST_CELLS),
        }))
    }
}
