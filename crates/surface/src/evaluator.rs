//! Values and derivatives at points, and along lines.

use crate::error::Outside;
use crate::surface::{Surface, Value};
use crate::tensor::{chebyshev, chebyshev_slopes, clenshaw, contract};

/// Evaluates a surface. It keeps the memory that a point takes.
#[derive(Clone, Debug)]
pub struct Evaluator<'a> {
    surface: &'a Surface,
    /// For each axis the polynomials at the point, and their derivatives.
    basis: Vec<[Vec<f64>; 2]>,
    /// For each axis the weights of the ranks, and their derivatives.
    weights: Vec<[Vec<f64>; 2]>,
    /// Partly contracted cores: the value, and the derivative along each axis.
    partial: Vec<Vec<f64>>,
    buffer: Vec<f64>,
    values: Vec<f64>,
    derivatives: Vec<f64>,
}

impl<'a> Evaluator<'a> {
    pub(crate) fn new(surface: &'a Surface) -> Self {
        let axes = surface.axes().len();
        let largest = surface.series.iter().map(|series| series.tucker.core.len()).max().unwrap_or(0);
        let pair = |length: &usize| [vec![0.0; *length], vec![0.0; *length]];
        Self {
            surface,
            basis: surface.degrees.iter().map(pair).collect(),
            weights: surface.degrees.iter().map(pair).collect(),
            partial: vec![vec![0.0; largest]; axes + 1],
            buffer: vec![0.0; largest],
            values: vec![0.0; surface.series.len()],
            derivatives: vec![0.0; surface.series.len() * axes],
        }
    }

    /// The values of all quantities at a point, which has a coordinate for each axis.
    ///
    /// # Errors
    /// [`Outside`] if the point is not in the domain, or is none of this surface.
    pub fn values(&mut self, point: &[f64]) -> Result<&[f64], Outside> {
        check(self.surface, point)?;
        for ((axis, &x), [basis, _]) in self.surface.axes().iter().zip(point).zip(&mut self.basis) {
            chebyshev(axis.forward(x), basis);
        }
        for q in 0..self.surface.series.len() {
            let y = self.series(q);
            self.values[q] = self.value(q, y);
        }
        Ok(&self.values)
    }

    /// The values of all quantities at a point, and their derivatives with respect to the axes: for each quantity one
    /// for each axis.
    ///
    /// At the end 0 of a compact axis the derivative along it is not known, and NaN.
    ///
    /// # Errors
    /// As for [`Evaluator::values`].
    pub fn derivatives(&mut self, point: &[f64]) -> Result<(&[f64], &[f64]), Outside> {
        check(self.surface, point)?;
        let axes = point.len();
        for ((axis, &x), [basis, slopes]) in self.surface.axes().iter().zip(point).zip(&mut self.basis) {
            let t = axis.forward(x);
            chebyshev(t, basis);
            chebyshev_slopes(t, slopes);
            let slope = axis.slope(x);
            let slope = if slope.is_finite() { slope } else { f64::NAN };
            slopes.iter_mut().for_each(|value| *value *= slope);
        }
        for q in 0..self.surface.series.len() {
            self.series_with_slopes(q);
            let y = self.partial[0][0];
            self.values[q] = self.value(q, y);
            for axis in 0..axes {
                let slope = self.partial[axis + 1][0];
                self.derivatives[q * axes + axis] = match self.surface.series[q].value {
                    Value::Identity => slope,
                    Value::Exp => self.values[q] * slope,
                    Value::Part { of, share, function } => {
                        let whole = (self.values[of], self.derivatives[of * axes + axis]);
                        let [part, change] = function.at(y);
                        share * (whole.1 * part + whole.0 * change * slope)
                    }
                };
            }
        }
        Ok((&self.values, &self.derivatives))
    }

    /// The surface along an axis, from a point whose coordinate on that axis does not count. What the other
    /// coordinates take is done once.
    ///
    /// # Errors
    /// As for [`Evaluator::values`], of the other coordinates.
    ///
    /// # Panics
    /// If there is no such axis.
    pub fn line(&mut self, axis: usize, point: &[f64]) -> Result<Line<'a>, Outside> {
        let surface = self.surface;
        let mut start = point.to_vec();
        if let Some(x) = start.get_mut(axis) {
            *x = surface.axes()[axis].from;
        }
        check(surface, &start)?;
        for ((axis, &x), [basis, _]) in surface.axes().iter().zip(&start).zip(&mut self.basis) {
            chebyshev(axis.forward(x), basis);
        }
        let coefficients = surface.series.iter().map(|series| {
            let mut shape: Vec<usize> = series.tucker.factors.iter().map(|factor| factor.rank).collect();
            let mut core = series.tucker.core.to_doubles();
            for (other, factor) in series.tucker.factors.iter().enumerate().filter(|(other, _)| *other != axis) {
                let weights = &mut self.weights[other][0][..factor.rank];
                factor.weights(&self.basis[other][0], weights);
                let (outer, inner) = (shape[..other].iter().product(), shape[other + 1..].iter().product());
                let mut contracted = vec![0.0; outer * inner];
                contract(&core, [outer, factor.rank, inner], weights, &mut contracted);
                shape[other] = 1;
                core = contracted;
            }
            series.tucker.factors[axis].coefficients(&core)
        });
        Ok(Line { surface, axis, coefficients: coefficients.collect(), values: vec![0.0; surface.series.len()] })
    }

    /// y of a quantity at the point whose polynomials are there.
    fn series(&mut self, q: usize) -> f64 {
        let tucker = &self.surface.series[q].tucker;
        let mut length = tucker.core.len();
        for (place, factor) in tucker.factors.iter().enumerate() {
            let weights = &mut self.weights[place][0][..factor.rank];
            factor.weights(&self.basis[place][0], weights);
            let shape = [1, factor.rank, length / factor.rank];
            let out = &mut self.buffer[..shape[2]];
            match place {
                0 => tucker.core.contract(shape, weights, out),
                _ => contract(&self.partial[0][..length], shape, weights, out),
            }
            std::mem::swap(&mut self.partial[0], &mut self.buffer);
            length = shape[2];
        }
        self.partial[0][0]
    }

    /// y of a quantity in the first partial contraction, and its derivative along each axis in those that follow.
    fn series_with_slopes(&mut self, q: usize) {
        let tucker = &self.surface.series[q].tucker;
        let mut length = tucker.core.len();
        for (place, factor) in tucker.factors.iter().enumerate() {
            let [weights, slopes] = &mut self.weights[place];
            let [weights, slopes] = [&mut weights[..factor.rank], &mut slopes[..factor.rank]];
            factor.weights(&self.basis[place][0], weights);
            factor.weights(&self.basis[place][1], slopes);
            let shape = [1, factor.rank, length / factor.rank];
            let short = shape[2];
            // The derivative along this axis is made from the value so far, before that is contracted itself.
            let (so_far, rest) = self.partial.split_at_mut(1);
            let whole = |weights: &[f64], out: &mut [f64]| match place {
                0 => tucker.core.contract(shape, weights, out),
                _ => contract(&so_far[0][..length], shape, weights, out),
            };
            whole(slopes, &mut rest[place][..short]);
            whole(weights, &mut self.buffer[..short]);
            std::mem::swap(&mut so_far[0], &mut self.buffer);
            for earlier in &mut rest[..place] {
                contract(&earlier[..length], shape, weights, &mut self.buffer[..short]);
                std::mem::swap(earlier, &mut self.buffer);
            }
            length = short;
        }
    }

    fn value(&self, q: usize, y: f64) -> f64 {
        value(self.surface, q, y, &self.values)
    }
}

/// A surface along one axis.
#[derive(Clone, Debug)]
pub struct Line<'a> {
    surface: &'a Surface,
    axis: usize,
    /// Chebyshev coefficients of each quantity.
    coefficients: Vec<Vec<f64>>,
    values: Vec<f64>,
}

impl Line<'_> {
    /// The values of all quantities at a place on the axis.
    ///
    /// # Errors
    /// [`Outside`] if it is beyond the axis.
    pub fn values(&mut self, x: f64) -> Result<&[f64], Outside> {
        let axis = &self.surface.axes()[self.axis];
        if !axis.contains(x) {
            return Err(beyond(self.surface, self.axis, x));
        }
        let t = axis.forward(x);
        for (q, coefficients) in self.coefficients.iter().enumerate() {
            let y = clenshaw(coefficients, t);
            self.values[q] = value(self.surface, q, y, &self.values);
        }
        Ok(&self.values)
    }
}

/// The value of a quantity from its series and the values before it.
fn value(surface: &Surface, q: usize, y: f64, values: &[f64]) -> f64 {
    match surface.series[q].value {
        Value::Identity => y,
        Value::Exp => y.exp(),
        Value::Part { of, share, function } => share * values[of] * function.at(y)[0],
    }
}

fn check(surface: &Surface, point: &[f64]) -> Result<(), Outside> {
    let axes = surface.axes();
    if point.len() != axes.len() {
        let names: Vec<&str> = axes.iter().map(|axis| axis.name.as_str()).collect();
        return Err(Outside::Coordinates { expected: axes.len(), found: point.len(), names: names.join(", ") });
    }
    match axes.iter().zip(point).position(|(axis, &x)| !axis.contains(x)) {
        Some(place) => Err(beyond(surface, place, point[place])),
        None => Ok(()),
    }
}

fn beyond(surface: &Surface, place: usize, value: f64) -> Outside {
    let axis = &surface.axes()[place];
    Outside::Axis { axis: axis.name.clone(), value, from: axis.from, to: axis.to }
}
