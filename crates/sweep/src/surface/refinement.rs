//! The rounds of a surface: lines, a grid, and random points that tell where it is bad, until it is good everywhere.

use super::build::{Progress, SurfaceBuildError};
use super::comparison::{Known, errors, random_numbers, random_points};
use super::cross::Cross;
use super::domain::{Domain, Numbers};
use super::draft::Draft;
use super::leja::Leja;
use super::lines::{Line, MOST_ALONG, Sample};
use super::nodes::Nodes;
use crate::SurfaceSweep;
use stribeck_solver::Parameters;
use stribeck_surface::Surface;

/// What lines may leave unsaid of a quantity in the first round, in tolerances, for one to three axes. The errors of
/// several axes add up; with three, less costs much.
const FIRST_THRESHOLD: [f64; 3] = [0.1, 0.1, 0.15];
/// What the threshold of a bad quantity is multiplied by where more lines do not help.
const LOWER: f64 = 0.7;
/// What lines leave unsaid makes an error of about so many thresholds.
const FLOOR: f64 = 8.0;
/// More lines do not help after so many rounds without a smaller error.
const STALLED: usize = 2;
/// Below this threshold the errors of the solver would be followed, for one to three axes.
const LEAST_THRESHOLD: [f64; 3] = [0.01, 0.01, 0.07];
/// The largest error at the leading points with which a surface is compared with fresh ones, in tolerances, for one to
/// three axes. With few axes there are few leading points.
const GOOD: [f64; 3] = [0.6, 0.6, 1.0];
/// Lines along each axis that are added in a round, at most, for each axis that they do not run along: through random
/// points, and as many through nodes of lines.
const LINES: [usize; 3] = [2, 2, 3];
/// Random lines of the first round along each axis, for one to three axes.
const FIRST_LINES: [usize; 3] = [0, 4, 25];
/// Points whose mapped coordinates are all so near to those of a worse one have the same cause.
const NEAR: f64 = 0.15;
/// Leading points of a round, for one to three axes.
const LEADING: [usize; 3] = [50, 100, 300];
/// The most cases of a surface.
const MOST_CASES: usize = 400_000;

/// A surface while it is made.
pub struct Work<'a> {
    surface: &'a SurfaceSweep,
    domain: Domain<'a>,
    nodes: Nodes<'a>,
    leja: Leja,
}

impl<'a> Work<'a> {
    /// The work on a surface whose cases `nodes` solves.
    pub fn new(surface: &'a SurfaceSweep, nodes: Nodes<'a>) -> Self {
        Self { surface, domain: Domain::new(surface), nodes, leja: Leja::new(MOST_ALONG) }
    }

    /// The domain of the surface.
    pub fn domain(&self) -> &Domain<'a> {
        &self.domain
    }

    /// The number of cases that were solved and not stored before.
    pub fn solved(&self) -> u64 {
        self.nodes.solved()
    }

    /// Refines until fresh random points show no error above the tolerance; false if that needs too many cases.
    pub fn refine(&mut self, tell: &mut dyn FnMut(Progress)) -> Result<(Surface, bool), SurfaceBuildError> {
        let settings = &self.surface.settings;
        let (tolerance, good) = (settings.tolerance, self.good());
        let mut cross = Cross::new(self.domain.dimensions());
        self.first_points().iter().for_each(|point| cross.add_lines(point));
        let (mut leading, mut on_lines, mut seed) = (Known::default(), Known::default(), settings.seed);
        let (mut best, mut stalled) = (f64::INFINITY, 0);
        let mut thresholds = vec![FIRST_THRESHOLD[self.domain.dimensions() - 1]; self.domain.columns.len()];
        for number in 1.. {
            let fits = self.solve_cross(&mut cross, &mut on_lines, &thresholds)?;
            let seed_of_round = u64::MAX - number as u64;
            let points = random_points(&self.domain, LEADING[self.domain.dimensions() - 1], seed_of_round);
            leading.add(self.known(points)?);
            let exact = self.draft().exact(&cross)?;
            let of_each = errors(&exact, &leading);
            let worst = worst_at_each_point(&of_each);
            let largest = worst.iter().copied().fold(0.0, f64::max) / tolerance;
            tell(Progress::Round { number, cases: self.nodes.count(), largest });
            let least = thresholds.iter().copied().fold(f64::INFINITY, f64::min);
            let is_at_end = least < LEAST_THRESHOLD[self.domain.dimensions() - 1];
            let last = !fits || is_at_end || self.nodes.count() >= MOST_CASES;
            if largest <= good || last {
                let cases = self.nodes.count();
                let fresh = self.known(random_points(&self.domain, settings.points, seed))?;
                let draft = Draft { cases, ..self.draft() };
                let (surface, error) = draft.published(&cross, &leading, &fresh, seed)?;
                tell(Progress::Compared { cases, largest: error / tolerance });
                if error <= tolerance || last {
                    return Ok((surface, error <= tolerance));
                }
                // Points that a decision was made by are not fresh any more.
                leading.add(fresh);
                seed += 1;
            }
            self.add_lines(&mut cross, &leading, &worst);
            let worst = worst_at_each_point(&errors(&exact, &on_lines));
            self.add_lines(&mut cross, &on_lines, &worst);
            stalled = if largest < best { 0 } else { stalled + 1 };
            best = best.min(largest);
            if stalled >= STALLED || (stalled > 0 && largest < FLOOR * least) {
                for (threshold, errors) in thresholds.iter_mut().zip(of_each) {
                    let is_bad = errors.into_iter().fold(0.0, f64::max) > good * tolerance;
                    *threshold *= if is_bad { LOWER } else { 1.0 };
                }
                (best, stalled) = (f64::INFINITY, 0);
            }
        }
        unreachable!("the threshold falls, or the error does")
    }

    fn draft(&self) -> Draft<'_> {
        Draft { surface: self.surface, domain: &self.domain, cases: self.nodes.count() }
    }

    fn good(&self) -> f64 {
        GOOD[self.domain.dimensions() - 1]
    }

    /// The points of the first lines, in mapped coordinates: along each axis a line at every combination of middles and
    /// ends of the others, and random ones, which are dense at the ends as nodes are.
    fn first_points(&self) -> Vec<Vec<f64>> {
        let dimensions = self.domain.dimensions();
        let others = dimensions - 1;
        // Of a Latin square, each two coordinates have all combinations.
        let combination = |number: usize| -> Vec<f64> {
            let places: Vec<usize> = (0..others).map(|axis| number / 3_usize.pow(axis as u32) % 3).collect();
            let last = places.iter().sum::<usize>() % 3;
            places.into_iter().chain([last]).map(|place| self.leja.nodes[place]).collect()
        };
        let random = random_numbers(dimensions, FIRST_LINES[others], 0);
        let dense = random.into_iter().map(|point| point.into_iter().map(|t| pxfm::f_sinpi(0.5 * t)).collect());
        (0..3_usize.pow(others as u32)).map(combination).chain(dense).collect()
    }

    /// Solves the lines as far as they need it, and the grid of their nodes. False if so many cases are needed that the
    /// thresholds had to be raised.
    fn solve_cross(
        &mut self,
        cross: &mut Cross,
        on_lines: &mut Known,
        thresholds: &[f64],
    ) -> Result<bool, SurfaceBuildError> {
        self.solve_lines(cross, on_lines, thresholds)?;
        let (mut raised, none) = (1.0, SurfaceBuildError::SingularValues);
        let room = MOST_CASES.saturating_sub(self.nodes.count());
        let bases = loop {
            let Some(bases) = cross.new_bases(&self.leja, thresholds, raised) else { return Err(none) };
            let grid = bases.iter().map(|basis| basis.nodes.len()).product::<usize>();
            // The grid of the round before did fit.
            if grid <= room || raised > 1e9 {
                break bases;
            }
            raised *= 2.0;
        };
        let (_, samples) = self.samples(&Cross::grid(&bases, &self.leja))?;
        let quantities = 0..self.domain.columns.len();
        let series = quantities.map(|q| samples.iter().map(|sample| sample.series[q]).collect()).collect();
        cross.take(bases, series, &self.leja).ok_or(none)?;
        Ok(raised == 1.0)
    }

    /// Adds nodes to lines until all have those that they need. They are points that are known, too.
    fn solve_lines(
        &mut self,
        cross: &mut Cross,
        on_lines: &mut Known,
        thresholds: &[f64],
    ) -> Result<(), SurfaceBuildError> {
        loop {
            let open: Vec<(&mut Line, usize)> = cross
                .lines
                .iter_mut()
                .flatten()
                .filter_map(|line| {
                    let wanted = line.nodes_wanted(&self.leja, thresholds);
                    (wanted > line.nodes()).then_some((line, wanted))
                })
                .collect();
            if open.is_empty() {
                return Ok(());
            }
            let points: Vec<Vec<f64>> = open
                .iter()
                .flat_map(|(line, wanted)| line.next_points(&self.leja, *wanted).collect::<Vec<_>>())
                .collect();
            let (known, samples) = self.samples(&points)?;
            on_lines.add(known);
            let mut samples = samples.into_iter();
            for (line, wanted) in open {
                samples.by_ref().take(wanted - line.nodes()).for_each(|sample| line.push(sample));
            }
        }
    }

    /// Adds the lines through the points with the largest errors that are not near to each other.
    fn add_lines(&self, cross: &mut Cross, leading: &Known, worst: &[f64]) {
        let enough = 0.5 * self.good() * self.surface.settings.tolerance;
        let mut places: Vec<usize> = (0..worst.len()).filter(|&place| worst[place] > enough).collect();
        places.sort_by(|&a, &b| worst[b].total_cmp(&worst[a]));
        let is_near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < NEAR);
        let mut chosen: Vec<Vec<f64>> = Vec::new();
        for place in places {
            let point = self.domain.mapped(&leading.points[place]);
            if chosen.len() < LINES[self.domain.dimensions() - 1] * (self.domain.dimensions() - 1)
                && !chosen.iter().any(|it| is_near(it, &point))
            {
                chosen.push(point);
            }
        }
        chosen.iter().for_each(|point| cross.add_lines_near(point, &self.leja));
    }

    /// The samples at mapped points.
    fn samples(&mut self, mapped: &[Vec<f64>]) -> Result<(Known, Vec<Sample>), SurfaceBuildError> {
        let known = self.known(mapped.iter().map(|t| self.domain.point(t)).collect())?;
        let samples = known.points.iter().zip(&known.numbers).map(|(point, numbers)| self.sample(point, numbers));
        let samples = samples.collect::<Result<_, _>>()?;
        Ok((known, samples))
    }

    fn sample(&self, point: &[f64], numbers: &Numbers) -> Result<Sample, SurfaceBuildError> {
        let sample = self.domain.sample(numbers, self.surface.settings.tolerance);
        if let Some(q) = sample.series.iter().position(|number| !number.is_finite()) {
            let names = self.surface.axes.iter().zip(point).map(|(axis, x)| format!("{} = {x}", axis.name));
            let (quantity, value) = (self.domain.columns[q].name(), numbers.values[q]);
            let place = names.collect::<Vec<_>>().join(", ");
            return Err(SurfaceBuildError::NoNumber { quantity, value, place });
        }
        Ok(sample)
    }

    /// Points with their numbers.
    pub fn known(&mut self, points: Vec<Vec<f64>>) -> Result<Known, SurfaceBuildError> {
        let cases: Vec<Parameters> = points.iter().map(|point| self.domain.parameters(point)).collect();
        let values = self.nodes.solve(&cases)?;
        let numbers = points.iter().zip(&values).map(|(point, values)| self.domain.numbers(point, values)).collect();
        Ok(Known { points, numbers })
    }
}

/// The largest error of a quantity at each point.
fn worst_at_each_point(errors: &[Vec<f64>]) -> Vec<f64> {
    (0..errors[0].len()).map(|point| errors.iter().map(|of_one| of_one[point]).fold(0.0, f64::max)).collect()
}
