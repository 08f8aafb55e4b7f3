//! The cross approximation of a surface: from lines along each axis to functions of one coordinate, from a grid of the
//! nodes that tell these functions apart to the factors of their products.

use nalgebra::DMatrix;

use super::basis::Basis;
use super::compression::{Tensor, compress};
use super::leja::Leja;
use super::lines::Line;

/// A cross approximation while it grows.
#[derive(Clone, Debug)]
pub struct Cross {
    /// For each axis the lines along it.
    pub lines: Vec<Vec<Line>>,
    /// For each axis the functions that its lines are made of, and their nodes.
    pub bases: Vec<Basis>,
    /// For each quantity the factors of the products of these functions.
    pub cores: Vec<Tensor>,
}

/// A quantity in Tucker form.
#[derive(Clone, Debug)]
pub struct Tucker {
    /// Number of polynomials and rank of each axis.
    pub shape: Vec<[usize; 2]>,
    /// The factors: polynomials by ranks, the rank fastest.
    pub factors: Vec<Vec<f64>>,
    /// The core, the last axis fastest.
    pub core: Vec<f64>,
}

impl Cross {
    /// A cross of lines without nodes.
    pub fn new(dimensions: usize) -> Self {
        Self { lines: vec![Vec::new(); dimensions], bases: Vec::new(), cores: Vec::new() }
    }

    /// Adds the lines along all axes through a point.
    pub fn add_lines(&mut self, point: &[f64]) {
        // With one axis there is one line.
        let lone = self.lines.len() == 1;
        for (axis, lines) in self.lines.iter_mut().enumerate().filter(|(_, lines)| !lone || lines.is_empty()) {
            lines.push(Line::new(axis, point));
        }
    }

    /// Adds a line along each axis near to a point: through the nearest nodes of the other axes, as cases of the grid
    /// are on such a line already; or through the point itself if that line is there.
    pub fn add_lines_near(&mut self, point: &[f64], leja: &Leja) {
        let nearest = |(basis, t): (&Basis, &f64)| {
            let distance = |node: &&usize| (leja.nodes[**node] - t).abs();
            let node = basis.nodes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            node.map_or(*t, |node| leja.nodes[*node])
        };
        let on_grid: Vec<f64> = self.bases.iter().zip(point).map(nearest).collect();
        let lone = self.lines.len() == 1;
        for (axis, lines) in self.lines.iter_mut().enumerate().filter(|_| !lone) {
            let is_there = lines.iter().any(|line| line.is_through(&on_grid));
            lines.push(Line::new(axis, if is_there { point } else { &on_grid }));
        }
    }

    /// The bases of the lines as they are now. They leave of each quantity at most `raised` times its threshold, in
    /// tolerances. None if a singular value decomposition does not converge.
    pub fn new_bases(&self, leja: &Leja, thresholds: &[f64], raised: f64) -> Option<Vec<Basis>> {
        let basis = |(axis, lines): (usize, &Vec<Line>)| {
            let degrees = lines.iter().map(Line::nodes).max().unwrap_or(0);
            let of_lines: Vec<Vec<Vec<f64>>> =
                lines.iter().map(|line| line.coefficients(leja, thresholds).collect()).collect();
            let columns = |q: usize| {
                let number = |n: usize, line: usize| of_lines[line][q].get(n).copied().unwrap_or(0.0);
                DMatrix::from_fn(degrees, of_lines.len(), number)
            };
            let columns: Vec<DMatrix<f64>> = (0..thresholds.len()).map(columns).collect();
            let before = self.bases.get(axis).map_or(&[][..], |basis| &basis.nodes);
            Basis::of(&columns, raised, leja, before)
        };
        self.lines.iter().enumerate().map(basis).collect()
    }

    /// The points of the grid of the nodes, the last axis fastest.
    pub fn grid(bases: &[Basis], leja: &Leja) -> Vec<Vec<f64>> {
        bases.iter().fold(vec![Vec::new()], |points, basis| {
            let along = |point: Vec<f64>| {
                basis.nodes.iter().map(move |&node| {
                    let mut point = point.clone();
                    point.push(leja.nodes[node]);
                    point
                })
            };
            points.into_iter().flat_map(along).collect()
        })
    }

    /// Takes bases, and the series of each quantity on their grid. None if a singular value decomposition does not
    /// converge.
    pub fn take(&mut self, bases: Vec<Basis>, series: Vec<Vec<f64>>, leja: &Leja) -> Option<()> {
        let shape: Vec<usize> = bases.iter().map(|basis| basis.nodes.len()).collect();
        let core = |(q, numbers): (usize, Vec<f64>)| {
            let tensor = Tensor { numbers, shape: shape.clone() };
            bases
                .iter()
                .enumerate()
                .try_fold(tensor, |tensor, (axis, basis)| Some(tensor.along(axis, &basis.interpolation(q, leja)?)))
        };
        self.cores = series.into_iter().enumerate().map(core).collect::<Option<_>>()?;
        self.bases = bases;
        Some(())
    }

    /// A quantity in Tucker form, whose coefficients are off by at most `most` (root of the sum of squares) for the ranks
    /// that are left out, and a tenth of that for polynomials. None if a singular value decomposition does not converge.
    pub fn tucker(&self, quantity: usize, most: f64) -> Option<Tucker> {
        let (factors, core) = compress(&self.cores[quantity], most)?;
        let share = 0.1 * most / (factors.len() as f64).sqrt();
        let factors = self.bases.iter().zip(&factors).enumerate().map(|(axis, (basis, factor))| {
            let factor = &basis.vectors[quantity] * factor;
            let polynomials = needed(&factor, &core.norms(axis), share);
            factor.rows(0, polynomials).into_owned()
        });
        let factors: Vec<DMatrix<f64>> = factors.collect();
        let row_by_row = |matrix: &DMatrix<f64>| {
            (0..matrix.nrows()).flat_map(|n| (0..matrix.ncols()).map(move |r| matrix[(n, r)])).collect()
        };
        Some(Tucker {
            shape: factors.iter().map(|factor| [factor.nrows(), factor.ncols()]).collect(),
            factors: factors.iter().map(row_by_row).collect(),
            core: core.numbers,
        })
    }
}

/// The number of rows of a factor without which coefficients are off by at most `most` (root of the sum of squares),
/// where each column counts by the size of its part of the core. Not fewer than columns.
fn needed(factor: &DMatrix<f64>, norms: &[f64], most: f64) -> usize {
    let mut left_out = 0.0;
    let mut rows = factor.nrows();
    while rows > factor.ncols() {
        let part = |(value, norm): (&f64, &f64)| (value * norm).powi(2);
        left_out += factor.row(rows - 1).iter().zip(norms).map(part).sum::<f64>();
        if left_out > most * most {
            break;
        }
        rows -= 1;
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::lines::Sample;

    /// A function of three coordinates that is a sum of three products: the cross of a few lines and the grid of their
    /// nodes is that function everywhere, with as few nodes as there are products.
    #[test]
    fn a_sum_of_products_comes_back_from_a_few_lines() {
        let function = |p: &[f64]| (p[0] + 0.3).sin() * p[1].exp() + p[0] * p[0] * p[2].cos() + p[0] * p[1] * p[2];
        let leja = Leja::new(40);
        let mut cross = Cross::new(3);
        for point in [[0.1, -0.4, 0.9], [-0.8, 0.7, 0.2], [0.6, 0.3, -0.5], [0.9, -0.9, 0.8]] {
            cross.add_lines(&point);
        }
        for line in cross.lines.iter_mut().flatten() {
            for point in line.next_points(&leja, 25).collect::<Vec<_>>() {
                line.push(Sample { series: vec![function(&point)], weights: vec![1.0] });
            }
        }
        let bases = cross.new_bases(&leja, &[1e-10], 1.0).expect("converged");
        let sizes: Vec<usize> = bases.iter().map(|basis| basis.nodes.len()).collect();
        assert_eq!(sizes, [3, 3, 3]);
        let series = vec![Cross::grid(&bases, &leja).iter().map(|point| function(point)).collect()];
        cross.take(bases, series, &leja).expect("converged");
        let tucker = cross.tucker(0, 1e-9).expect("converged");
        for point in [[0.0, 0.0, 0.0], [-0.97, 0.31, 0.77], [1.0, -1.0, 1.0]] {
            let weights: Vec<Vec<f64>> = (0..3)
                .map(|axis| {
                    let [degrees, rank] = tucker.shape[axis];
                    let mut p = vec![0.0; degrees];
                    stribeck_surface::chebyshev(point[axis], &mut p);
                    (0..rank).map(|r| (0..degrees).map(|n| tucker.factors[axis][n * rank + r] * p[n]).sum()).collect()
                })
                .collect();
            let mut found = 0.0;
            for (place, number) in tucker.core.iter().enumerate() {
                let [_, b, c] = [0, 1, 2].map(|axis| weights[axis].len());
                found += number * weights[0][place / (b * c)] * weights[1][place / c % b] * weights[2][place % c];
            }
            assert!((found - function(&point)).abs() < 1e-8, "{point:?}: {found} {}", function(&point));
        }
    }
}
