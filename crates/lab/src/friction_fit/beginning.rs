//! Where a fit begins: the best of many values of its unknowns, by a function of friction that costs next to nothing.

use super::bounds::Bounds;
use super::prediction::Predictor;
use super::{FrictionFitError, FrictionTask, Unknown};
use crate::{Experiment, Measured};
use stribeck_solver::Parameters;

/// How far from its start an unknown without bounds is looked for: a factor of a thousand, as a logarithm.
const FAR: f64 = 6.91;
/// Values that are tried before the box around the best is made smaller.
const TRIED: u32 = 600;
/// How often that happens, and what is left of the box each time: in the end 1 % of its logarithm.
const ROUNDS: usize = 6;
const LEFT: f64 = 0.4;
/// More points than these would not change what is best.
const POINTS: usize = 40;

/// The experiment of a task with the start of each unknown where friction agrees best with the measured points.
/// `friction` is μ over a₀/R of the measured column, or `None` where it is not known; values with such a point are left
/// out. Unknowns are looked for between their bounds, or up to a factor of a thousand from where they begin.
///
/// # Errors
/// [`FrictionFitError::Task`] if the file does not go with the unknowns, or no values have all points where friction is
/// known.
pub fn best_beginning(
    task: &FrictionTask<'_>,
    friction: &mut dyn FnMut(&Parameters) -> Option<f64>,
) -> Result<Experiment, FrictionFitError> {
    let predictor = Predictor::new(task)?;
    let mut sum = |logarithms: &[f64]| {
        let values: Vec<f64> = logarithms.iter().map(|logarithm| logarithm.exp()).collect();
        sum_of_squares(task, &predictor.experiments(&values), friction)
    };
    let start: Vec<f64> = predictor.start().iter().map(|value| value.ln()).collect();
    let ends = task.unknowns.iter().zip(&start).map(|(unknown, start)| ends(*unknown, *start, &task.bounds));
    let ends = ends.collect::<Result<Vec<[f64; 2]>, _>>()?;
    let mut best = (sum(&start), start);
    let mut centre: Vec<f64> = ends.iter().map(|[least, most]| 0.5 * (least + most)).collect();
    let mut half: Vec<f64> = ends.iter().map(|[least, most]| 0.5 * (most - least)).collect();
    for _ in 0..ROUNDS {
        for n in 0..TRIED {
            let within = evenly(n, centre.len());
            let at = |i: usize| (centre[i] + (2.0 * within[i] - 1.0) * half[i]).clamp(ends[i][0], ends[i][1]);
            let tried: Vec<f64> = (0..centre.len()).map(at).collect();
            let sum = sum(&tried);
            if sum < best.0 {
                best = (sum, tried);
            }
        }
        centre.clone_from(&best.1);
        half.iter_mut().for_each(|half| *half *= LEFT);
    }
    if best.0.is_infinite() {
        let what = "no values of the unknowns have all points where friction is known without solving; \
                    give bounds, or leave the search out";
        return Err(FrictionFitError::Task { what: what.to_owned() });
    }
    let mut experiment = task.experiment;
    task.unknowns.iter().zip(best.1).for_each(|(unknown, value)| unknown.set(&mut experiment, value.exp()));
    Ok(experiment)
}

/// The sum of the squared residuals; infinite where it is not known.
fn sum_of_squares(
    task: &FrictionTask<'_>,
    experiments: &[Experiment],
    friction: &mut dyn FnMut(&Parameters) -> Option<f64>,
) -> f64 {
    let measured: &Measured = task.measured;
    let weights = measured.weights();
    let mut residual = |point: usize| {
        let experiment = &experiments[point];
        let over_scale = friction(&experiment.parameters_of_both(task.substrate, task.roller_spectrum))?;
        Some(weights[point] * measured.difference(point, over_scale * experiment.scales().friction))
    };
    let step = experiments.len().div_ceil(POINTS);
    let squares = (0..experiments.len()).step_by(step).map(|point| Some(residual(point)?.powi(2)));
    squares.sum::<Option<f64>>().filter(|sum| !sum.is_nan()).unwrap_or(f64::INFINITY)
}

/// Where the logarithm of an unknown is looked for.
fn ends(unknown: Unknown, start: f64, bounds: &[Bounds]) -> Result<[f64; 2], FrictionFitError> {
    let bounds = bounds.iter().find(|bounds| bounds.unknown == unknown);
    let end =
        |bound: Option<f64>, far: f64| bound.filter(|it| *it > 0.0 && it.is_finite()).map_or(start + far, f64::ln);
    let (least, most) = (end(bounds.and_then(|it| it.least), -FAR), end(bounds.and_then(|it| it.most), FAR));
    if least >= most {
        let what = format!("the bounds of {} leave nothing between them; give the lower one first", unknown.name());
        return Err(FrictionFitError::Task { what });
    }
    // A bound is no place to begin at: there the search would not move.
    let inner = 1e-3 * (most - least);
    Ok([least + inner, most - inner])
}

/// The n-th of points that fill the unit cube evenly: multiples of powers of the root of x^(d+1) = x + 1 (Roberts).
fn evenly(n: u32, dimensions: usize) -> Vec<f64> {
    let mut root = 1.5_f64;
    for _ in 0..40 {
        root = (1.0 + root).powf(1.0 / (dimensions as f64 + 1.0));
    }
    (1..=dimensions).map(|k| (0.5 + f64::from(n + 1) / root.powi(k as i32)).fract()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each half of each coordinate has its half of the points, and each quarter of each two has its quarter.
    #[test]
    fn points_are_even() {
        let points: Vec<Vec<f64>> = (0..600).map(|n| evenly(n, 3)).collect();
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let in_corner = points.iter().filter(|point| point[i] < 0.5 && point[j] >= 0.5).count();
            assert!((140..=160).contains(&in_corner), "{i} {j}: {in_corner}");
        }
    }
}
