//! Fitted friction along the speed, for points that differ in nothing else.

use super::prediction::{coefficient, settings};
use super::{FrictionFit, FrictionTask};
use crate::{Experiment, Measured};
use stribeck_solver::{Interrupt, Parameters, solve_points};

/// The speeds at which a curve is solved.
const SPEEDS: u32 = 60;

/// Points that differ in their speed alone, and the solutions between the slowest and the fastest of them.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedCurve {
    /// The places of its points among those of the fit.
    pub points: Vec<usize>,
    /// Speed and friction coefficient, in the order of speeds; empty for a single speed.
    pub line: Vec<(f64, f64)>,
}

impl FrictionFit {
    /// The curves through the points, with the unknowns found. A case that fails leaves a gap, which is NaN.
    pub fn curves(&self, task: &FrictionTask<'_>) -> Vec<FittedCurve> {
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (point, fitted) in self.points.iter().enumerate() {
            let is_own = |group: &&mut Vec<usize>| is_beside(&self.points[group[0]].experiment, &fitted.experiment);
            match groups.iter_mut().find(is_own) {
                Some(group) => group.push(point),
                None => groups.push(vec![point]),
            }
        }
        groups.into_iter().map(|points| FittedCurve { line: self.line(task, &points), points }).collect()
    }

    /// The solutions from the slowest to the fastest of some points.
    fn line(&self, task: &FrictionTask<'_>, points: &[usize]) -> Vec<(f64, f64)> {
        let speeds = || points.iter().map(|point| self.points[*point].experiment.motion.along().1);
        let (slowest, fastest) = (speeds().fold(f64::INFINITY, f64::min), speeds().fold(0.0, f64::max));
        if !(slowest > 0.0 && slowest < fastest) {
            return Vec::new();
        }
        let share = |i: u32| f64::from(i) / f64::from(SPEEDS - 1);
        let experiments: Vec<Experiment> = (0..SPEEDS)
            .map(|i| at_speed(&self.points[points[0]].experiment, slowest * (fastest / slowest).powf(share(i))))
            .collect();
        let cases: Vec<Parameters> =
            experiments.iter().map(|it| it.parameters_of_both(task.substrate, task.roller_spectrum)).collect();
        let solved = solve_points(&cases, &settings(task, false), &Interrupt::new()).expect("nobody interrupts");
        let friction = |experiment: &Experiment, outcome: Result<stribeck_solver::Solution, _>| {
            let over_scale = outcome.map_or(f64::NAN, |solution| {
                coefficient(task.measured.column, &solution.quantities.friction, experiment.motion.slide_roll())
            });
            (experiment.motion.along().1, over_scale * experiment.scales().friction)
        };
        experiments.iter().zip(solved).map(|(experiment, case)| friction(experiment, case.outcome)).collect()
    }
}

/// True for experiments that differ in their speed alone.
fn is_beside(one: &Experiment, other: &Experiment) -> bool {
    let (along, _) = one.motion.along();
    let mut others = one.given().filter(|quantity| *quantity != along);
    other.motion.along().0 == along
        && Measured::is_same(one.f, other.f)
        && others.all(|quantity| Measured::is_same(one.value(quantity), other.value(quantity)))
}

fn at_speed(experiment: &Experiment, speed: f64) -> Experiment {
    let mut other = *experiment;
    other.set(experiment.motion.along().0, speed);
    other
}
