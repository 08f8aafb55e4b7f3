//! From a point of the axes to a case, and from its numbers to those that a surface has.

use super::lines::Sample;
use crate::{Column, Grid, GridIndex, RangeAxis, SurfaceSweep, Values};
use stribeck_lab::{LaboratoryQuantity, Scales, si_units};
use stribeck_solver::Parameters;
use stribeck_surface::{Axis, Spread, Transform};

/// Where parts of the drag begin to count: errors of smaller ones are relative to this share of it.
const SHARE: f64 = 1e-3;

/// What is added to a loss over its share of the drag before its root is taken: where the root is steeper, errors of the
/// solver would show.
const OFFSET: f64 = 1e-7;

/// What a surface has of a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// The number itself; errors are relative to the unit where that is larger.
    Number,
    /// Its logarithm: the number is positive.
    Positive,
    /// A part of the drag that may change its sign.
    PartOfDrag,
    /// A part of the drag that is a loss in the solid: never negative, and 0 in the limits.
    LossOfDrag,
}

/// The domain of a surface: its axes, and what is asked for.
#[derive(Clone, Debug)]
pub struct Domain<'a> {
    surface: &'a SurfaceSweep,
    /// The quantities: those asked for, and before their parts the drag.
    pub columns: Vec<Column>,
}

/// The numbers of a case at a place.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// The value of each quantity.
    pub values: Vec<f64>,
    /// What the error of each is relative to, at least.
    pub least: Vec<f64>,
}

impl<'a> Domain<'a> {
    /// The domain of a surface.
    pub fn new(surface: &'a SurfaceSweep) -> Self {
        let asked = &surface.settings.quantities;
        let sliding = is_sliding(&surface.sweep.grid);
        let is_part = |column: &Column| matches!(form(*column, sliding), Form::PartOfDrag | Form::LossOfDrag);
        let has_parts = asked.iter().any(is_part);
        let drag = Some(Column::MuDrag).filter(|drag| has_parts || asked.contains(drag));
        let others = asked.iter().copied().filter(|column| *column != Column::MuDrag);
        Self { surface, columns: drag.into_iter().chain(others).collect() }
    }

    /// The number of axes.
    pub fn dimensions(&self) -> usize {
        self.surface.axes.len()
    }

    /// What a surface has of a column.
    pub fn form(&self, column: Column) -> Form {
        form(column, is_sliding(&self.surface.sweep.grid))
    }

    /// The axes as they stand in a file.
    pub fn axes(&self) -> Vec<Axis> {
        let axis = |it: &RangeAxis| Axis {
            name: it.name.clone(),
            units: it.units.clone(),
            long_name: it.long_name.clone(),
            spread: it.spread,
            from: it.from,
            to: it.to,
        };
        self.surface.axes.iter().map(axis).collect()
    }

    /// The point at which each mapped axis has the value t; the ends exactly.
    pub fn point(&self, t: &[f64]) -> Vec<f64> {
        self.surface.axes.iter().zip(t).map(|(axis, &t)| backward(axis, t)).collect()
    }

    /// The mapped axes at a point.
    pub fn mapped(&self, point: &[f64]) -> Vec<f64> {
        self.axes().iter().zip(point).map(|(axis, &x)| axis.forward(x)).collect()
    }

    /// The grid of the one place at a point.
    fn grid(&self, point: &[f64]) -> Grid {
        let mut grid = self.surface.sweep.grid.clone();
        for (axis, &x) in self.surface.axes.iter().zip(point) {
            match &mut grid {
                Grid::Dimensionless(axes) => match axis.name.as_str() {
                    "alpha" => axes.alpha = vec![x],
                    "beta" => axes.beta = vec![x],
                    "f" => axes.f = vec![x],
                    _ => axes.slide_roll = Some(vec![x]),
                },
                Grid::Laboratory(axes) if axis.name == "f" => axes.f = vec![x],
                Grid::Laboratory(axes) => {
                    let quantity = LaboratoryQuantity::named(&axis.name).expect("an axis is a quantity");
                    let given = axes.given.iter_mut().find(|given| given.quantity == quantity);
                    given.expect("an axis is given").values = vec![x];
                }
            }
        }
        grid
    }

    /// The case at a point.
    pub fn parameters(&self, point: &[f64]) -> Parameters {
        self.grid(point).parameters(FIRST, &self.surface.sweep.substrate)
    }

    /// The numbers at a point, from those of its case.
    pub fn numbers(&self, point: &[f64], case: &Values) -> Numbers {
        let grid = self.grid(point);
        let values = case.at_slide_roll(grid.slide_roll(FIRST));
        let scales = grid.experiment(FIRST).map(|experiment| experiment.scales());
        let unit = |column: Column| scales.as_ref().map_or(1.0, |scales: &Scales| scales.factor(column.units()));
        let least = |column: &Column| match self.form(*column) {
            Form::Number => unit(*column),
            Form::Positive => 0.0,
            Form::PartOfDrag | Form::LossOfDrag => SHARE * values[Column::MuDrag].abs() * unit(Column::MuDrag),
        };
        Numbers {
            values: self.columns.iter().map(|column| values[*column] * unit(*column)).collect(),
            least: self.columns.iter().map(least).collect(),
        }
    }

    /// What the polynomials interpolate, of each quantity, and what error of the quantity a change of that by 1 makes,
    /// over `tolerance`.
    pub fn sample(&self, numbers: &Numbers, tolerance: f64) -> Sample {
        let drag = numbers.values[0];
        let number = |((column, &value), &least): ((&Column, &f64), &f64)| match self.form(*column) {
            Form::Number => (value, 1.0 / value.abs().max(least)),
            Form::Positive => (value.ln(), 1.0),
            Form::PartOfDrag => {
                let part = value / (SHARE * drag);
                (part.asinh(), part.hypot(1.0) / part.abs().max(1.0))
            }
            Form::LossOfDrag => {
                let part = value / (SHARE * drag);
                // Errors of the solver may lead below 0.
                let root = (part + OFFSET).max(0.0).sqrt();
                (2.0 * (root - OFFSET.sqrt()).ln_1p(), root * (1.0 + root - OFFSET.sqrt()) / part.max(1.0))
            }
        };
        let (series, weights): (Vec<f64>, Vec<f64>) =
            self.columns.iter().zip(&numbers.values).zip(&numbers.least).map(number).unzip();
        Sample { series, weights: weights.into_iter().map(|weight| weight / tolerance).collect() }
    }

    /// How a quantity follows from its series.
    pub fn transform(&self, column: Column) -> Transform {
        match self.form(column) {
            Form::Number => Transform::Identity,
            Form::Positive => Transform::Exp,
            Form::PartOfDrag => Transform::Sinh { of: Column::MuDrag.name().to_owned(), share: SHARE },
            Form::LossOfDrag => Transform::Root { of: Column::MuDrag.name().to_owned(), share: SHARE, offset: OFFSET },
        }
    }

    /// Unit of a column, and what a dimensionless number is over.
    pub fn units(&self, column: Column) -> (String, Option<String>) {
        match &self.surface.sweep.grid {
            Grid::Laboratory(_) => (si_units(column.units()).to_owned(), None),
            Grid::Dimensionless(_) => ("1".to_owned(), Some(column.units().to_owned()).filter(|scale| scale != "1")),
        }
    }
}

const FIRST: GridIndex = GridIndex { block: 0, row: 0, along: 0 };

/// True if the roller slides without turning, everywhere.
fn is_sliding(grid: &Grid) -> bool {
    match grid {
        Grid::Dimensionless(axes) => axes.slide_roll.as_ref().is_none_or(|ratios| *ratios == [1.0]),
        Grid::Laboratory(axes) => !axes.rolls(),
    }
}

fn form(column: Column, sliding: bool) -> Form {
    match column {
        Column::MuDrag | Column::MuShear | Column::C | Column::FilmMin | Column::PMax | Column::Dissipation => {
            Form::Positive
        }
        Column::MuH | Column::MuTot if sliding => Form::Positive,
        Column::MuV if sliding => Form::LossOfDrag,
        Column::XOutlet | Column::XPMax | Column::Centroid | Column::Separation => Form::Number,
        _ => Form::PartOfDrag,
    }
}

/// The value of an axis at t. Functions are the program's own: nodes are the same cases on every machine.
fn backward(axis: &RangeAxis, t: f64) -> f64 {
    if t <= -1.0 {
        return axis.from;
    }
    if t >= 1.0 {
        return axis.to;
    }
    let forward = |x: f64| match axis.spread {
        Spread::Linear => x,
        Spread::Log => pxfm::f_log(x),
        Spread::Compact { .. } => axis.spread.forward(x),
    };
    let (from, to) = (forward(axis.from), forward(axis.to));
    let z = from + 0.5 * (1.0 + t) * (to - from);
    let x = match axis.spread {
        Spread::Linear => z,
        Spread::Log => pxfm::f_exp(z),
        Spread::Compact { center } => {
            let s = z / (1.0 - z);
            center * (s * s) * (s * s)
        }
    };
    x.clamp(axis.from, axis.to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spread_goes_there_and_back() {
        let text = "[axes]\nalpha = { from = 0.0, to = inf }\nbeta = { from = 1.0, to = 1e8, scale = \"log\" }\n\
                    f = { from = 0.0, to = 1e4, scale = \"log\" }\n";
        let surface = SurfaceSweep::parse("a", text).expect("valid");
        let domain = Domain::new(&surface);
        let axes = domain.axes();
        for t in [-1.0, -0.999, -0.3, 0.0, 0.7, 0.9999, 1.0] {
            for (axis, x) in axes.iter().zip(domain.point(&[t; 3])) {
                assert!((axis.forward(x) - t).abs() < 1e-12, "{} {t} {x}", axis.name);
            }
        }
        assert_eq!(domain.point(&[-1.0, 1.0, -1.0]), [0.0, 1e8, 0.0]);
        assert_eq!(domain.point(&[1.0; 3])[0], f64::INFINITY);
    }
}
