//! Lines along one axis: places where a surface is solved at as many nodes as that axis needs.

use super::leja::Leja;

/// The first nodes of a line.
pub const FIRST_NODES: usize = 9;
/// The most nodes along one axis.
pub const MOST_ALONG: usize = 400;
/// So many nodes in a row must have changed little. One may have by chance, or by symmetry.
const LAST: usize = 3;

/// What a solved node gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The series of each quantity: what the polynomials interpolate.
    pub series: Vec<f64>,
    /// The error of each quantity that a change of its series by 1 makes there, in tolerances.
    pub weights: Vec<f64>,
}

/// A line along an axis.
#[derive(Clone, Debug)]
pub struct Line {
    axis: usize,
    /// t of each axis; that of the line's own axis does not count.
    at: Vec<f64>,
    /// What the first Leja nodes gave.
    samples: Vec<Sample>,
}

impl Line {
    /// A line along an axis through a point, without nodes so far.
    pub fn new(axis: usize, at: &[f64]) -> Self {
        Self { axis, at: at.to_vec(), samples: Vec::new() }
    }

    /// True if it runs through a point.
    pub fn is_through(&self, point: &[f64]) -> bool {
        self.at.iter().zip(point).enumerate().all(|(axis, (at, t))| axis == self.axis || at == t)
    }

    /// The number of nodes that are solved.
    pub fn nodes(&self) -> usize {
        self.samples.len()
    }

    /// The number of nodes that it should have: more than now while the last ones changed a quantity by more than its
    /// threshold, in tolerances.
    pub fn nodes_wanted(&self, leja: &Leja, thresholds: &[f64]) -> usize {
        let now = self.nodes();
        match now < FIRST_NODES || self.last_change(leja, thresholds) > 1.0 {
            true => (now + (now / 4).max(4)).clamp(FIRST_NODES, MOST_ALONG),
            false => now,
        }
    }

    /// The points of the next nodes up to so many.
    pub fn next_points<'a>(&'a self, leja: &'a Leja, nodes: usize) -> impl Iterator<Item = Vec<f64>> + 'a {
        leja.nodes[self.nodes()..nodes].iter().map(|&t| {
            let mut point = self.at.clone();
            point[self.axis] = t;
            point
        })
    }

    /// Takes what the next node gave.
    pub fn push(&mut self, sample: Sample) {
        self.samples.push(sample);
    }

    /// The largest change of a quantity by one of the last nodes, where that node is, over the threshold.
    fn last_change(&self, leja: &Leja, thresholds: &[f64]) -> f64 {
        let first = self.nodes().saturating_sub(LAST);
        let mut largest = 0.0_f64;
        for (q, threshold) in thresholds.iter().enumerate() {
            let mut changes = self.series(q);
            leja.surpluses(&mut changes);
            let last = changes[first..].iter().zip(&self.samples[first..]);
            largest = last.map(|(change, sample)| change.abs() * sample.weights[q] / threshold).fold(largest, f64::max);
        }
        largest
    }

    /// The Chebyshev coefficients of each quantity, over the change of its series that is its threshold where that is
    /// least.
    pub fn coefficients<'a>(&'a self, leja: &'a Leja, thresholds: &'a [f64]) -> impl Iterator<Item = Vec<f64>> + 'a {
        thresholds.iter().enumerate().map(|(q, threshold)| {
            let weight = self.samples.iter().map(|sample| sample.weights[q] / threshold).fold(0.0, f64::max);
            let mut numbers = self.series(q);
            leja.surpluses(&mut numbers);
            leja.chebyshev(&mut numbers);
            numbers.iter_mut().for_each(|number| *number *= weight);
            numbers
        })
    }

    fn series(&self, q: usize) -> Vec<f64> {
        self.samples.iter().map(|sample| sample.series[q]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solved(function: impl Fn(f64) -> f64, weight: f64, threshold: f64) -> (Line, Leja) {
        let (leja, mut line) = (Leja::new(MOST_ALONG), Line::new(1, &[0.5, f64::NAN]));
        loop {
            let wanted = line.nodes_wanted(&leja, &[threshold]);
            if wanted == line.nodes() {
                return (line, leja);
            }
            for point in line.next_points(&leja, wanted).collect::<Vec<_>>() {
                assert_eq!(point[0].to_bits(), 0.5_f64.to_bits());
                line.push(Sample { series: vec![function(point[1])], weights: vec![weight] });
            }
        }
    }

    /// 1/(a − t) has the Chebyshev coefficients 2 r^n/√(a² − 1), r = a − √(a² − 1): a line ends where they are below
    /// the threshold, and not long after.
    #[test]
    fn a_line_has_as_many_nodes_as_its_function_needs() {
        let (a, root) = (1.25_f64, 0.75);
        for threshold in [1e-2_f64, 1e-5, 1e-8] {
            let (line, leja) = solved(|t| 1.0 / (a - t), 3.0, threshold);
            let needed = (threshold * root / 6.0).ln() / (a - root).ln();
            let nodes = line.nodes() as f64;
            assert!(nodes > needed && nodes < 1.6 * needed + 8.0, "{threshold}: {nodes} nodes, {needed} needed");
            let found: Vec<Vec<f64>> = line.coefficients(&leja, &[1.0]).collect();
            assert!((found[0][1] - 3.0 * 2.0 * (a - root) / root).abs() < 10.0 * threshold, "{}", found[0][1]);
        }
    }

    #[test]
    fn a_line_across_a_kink_ends() {
        let (line, _) = solved(|t| (t - 0.1).abs(), 1.0, 1e-6);
        assert_eq!(line.nodes(), MOST_ALONG);
    }
}
