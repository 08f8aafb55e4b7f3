//! The friction along an axis: the drag, over the parts that it is the sum of.

use super::Shown;
use crate::pictures::{AxisWords, PictureError, Quantity};
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_solver::shortest;
use stribeck_sweep::Column;

/// Most drags at other values of an axis across.
const MOST_OTHERS: usize = 7;

/// A part of the drag: its numbers, its name and its look.
struct Part {
    numbers: Vec<f64>,
    label: String,
    stroke: Stroke,
    colour: Colour,
}

impl Shown<'_> {
    /// The drag along an axis over its parts (T54), and faintly the drag at other values of an axis across; none if no
    /// case converged.
    pub(super) fn friction(&self, along: usize) -> Result<Option<Lines>, PictureError> {
        let Some(first) = self.first_place() else { return Ok(None) };
        let (places, drag) = (self.along(along, first), self.data.column(Column::MuDrag)?);
        let values = self.values(along);
        let (unit, label) = self.axes[along].shown(values.iter().copied());
        let x: Vec<f64> = values.iter().map(|value| unit.shown(*value)).collect();
        let curve = |numbers: Vec<f64>, label: String, stroke, colour| {
            let points = x.iter().copied().zip(numbers).collect();
            Curve { label, points, failed: Vec::new(), stroke, colour, mark: None }
        };
        let mut curves = Vec::new();
        for Part { numbers, label, stroke, colour } in self.parts(&places)? {
            curves.push(curve(numbers, label, stroke, colour));
        }
        for other in self.places_across(along, first) {
            let numbers = self.solved(&drag, &self.along(along, other));
            curves.push(curve(numbers, String::new(), Stroke::Solid, Colour::Faint));
        }
        let title = Quantity::from(Column::MuDrag).title();
        curves.push(curve(self.solved(&drag, &places), title, Stroke::Solid, Colour::Black));
        let is_linear = self.axes[along].unit == "K"
            || self.axes[along].name == AxisWords::COMBINATION
            || values.iter().any(|value| *value < 0.0);
        let y = Quantity::from(Column::MuDrag).unit(self.data.laboratory, 1.0).label("friction coefficient");
        Ok(Some(Lines {
            title: self.data.title.clone(),
            subtitle: String::new(),
            x: LineAxis { label, logarithmic: !is_linear, range: None },
            y: LineAxis { label: y, logarithmic: false, range: None },
            curves,
        }))
    }

    /// The parts of the drag at these places, as lines or, where none is negative, one upon the other.
    fn parts(&self, places: &[usize]) -> Result<Vec<Part>, PictureError> {
        let hysteresis = if self.data.has_hysteresis_of_roller()? { Column::MuVFlat } else { Column::MuV };
        let ratios: Vec<f64> = places.iter().map(|place| self.slide_roll(*place)).collect();
        let of_shear = match ratios[0] {
            first if ratios.iter().any(|ratio| *ratio != first) => "S times ".to_owned(),
            1.0 => String::new(),
            first => format!("{} times ", shortest(first)),
        };
        let columns =
            [(hysteresis, String::new()), (Column::MuShear, of_shear), (Column::MuPressure, "less ".to_owned())];
        let mut parts = Vec::new();
        for (column, before) in columns {
            let values = self.solved(&self.data.column(column)?, places);
            let factor = |i: usize| match column {
                Column::MuShear => ratios[i],
                Column::MuPressure => -1.0,
                _ => 1.0,
            };
            let values: Vec<f64> = values.iter().enumerate().map(|(i, value)| factor(i) * value).collect();
            parts.push((values, before + &Quantity::from(column).title()));
        }
        let is_pile = parts.iter().flat_map(|(values, _)| values).all(|value| *value >= 0.0);
        let mut below = vec![0.0; places.len()];
        let looks = [(Stroke::Solid, 0), (Stroke::Dashed, 2), (Stroke::Dotted, 1)];
        let look = |((mut numbers, label), (stroke, colour)): ((Vec<f64>, String), (Stroke, usize))| {
            if is_pile {
                numbers.iter_mut().zip(&below).for_each(|(number, below)| *number += below);
                below.clone_from(&numbers);
            }
            Part { numbers, label, stroke: if is_pile { Stroke::Band } else { stroke }, colour: Colour::Kind(colour) }
        };
        Ok(parts.into_iter().zip(looks).map(look).collect())
    }

    /// The slide-to-roll ratio S at a place.
    fn slide_roll(&self, place: usize) -> f64 {
        let shape = self.data.shape();
        let indices = self.data.indices([
            place / (shape.rows * shape.length),
            place / shape.length % shape.rows,
            place % shape.length,
        ]);
        let of_axis = |name: &str| {
            let at = self.data.dimensions.iter().position(|dimension| dimension.name == name)?;
            Some(self.data.dimensions[at].values[indices[at]])
        };
        let fixed = |name: &str| self.data.fixed.iter().find(|(fixed, _)| fixed == name).map(|(_, value)| *value);
        let value = |name: &str| of_axis(name).or_else(|| fixed(name));
        if let Some(ratio) = value("slide_roll") {
            return ratio;
        }
        if let Some(twice) = value("slide_roll_ratio") {
            return 0.5 * twice;
        }
        let speeds = value("roller_speed").zip(value("flat_speed"));
        speeds.map_or(1.0, |(roller, flat)| (flat - roller) / (flat + roller))
    }

    /// Places like this one at some other values of an axis that the curve does not run along.
    fn places_across(&self, along: usize, first: [usize; 3]) -> Vec<[usize; 3]> {
        let Some(across) = [1, 2, 0].into_iter().find(|axis| *axis != along && self.length(*axis) > 1) else {
            return Vec::new();
        };
        let others: Vec<usize> = (0..self.length(across)).filter(|i| *i != first[across]).collect();
        let at = |i: &usize| {
            let mut place = first;
            place[across] = *i;
            place
        };
        others.iter().step_by(others.len().div_ceil(MOST_OTHERS).max(1)).map(at).collect()
    }
}
