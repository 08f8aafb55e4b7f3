//! The expected cost of a case on this machine.

use std::time::Instant;

use super::iteration::{Discretisation, Iteration, LOAD_GAIN};
use super::reynolds::Relaxation;
use super::{Acceleration, Grid, Settings, State};
use crate::model::Parameters;

/// Expected seconds of one case: the time of a pass, measured here and now in a few milliseconds, times the passes that
/// cases of the paper's range typically need, 3n accelerated (each half again as dear, for the acceleration) or 0.6n²
/// plain; half as much again for an error estimate.
pub fn expected_seconds(settings: &Settings) -> f64 {
    const ROUNDS: usize = 20;
    const BETA: f64 = 100.0;
    let n = settings.points as f64;
    let passes = match settings.acceleration {
        Acceleration::Anderson => 1.5 * 3.0 * n,
        Acceleration::None => 0.6 * n * n,
    };
    let grid = Grid { x_min: -3.0, x_max: 4.0, points: settings.points };
    let shared = Discretisation::new(&Parameters::elastic(BETA), grid);
    let hertz = (0..grid.points).map(|i| (1.0 - grid.x(i) * grid.x(i)).max(0.0).sqrt()).collect();
    let mut iteration = Iteration::new(&shared, BETA, &State::resting(&shared, hertz, 0.03));
    let start = Instant::now();
    for _ in 0..ROUNDS {
        iteration.round(Relaxation::Uniform(0.1), LOAD_GAIN);
    }
    let second_grid = if settings.estimate { 1.5 } else { 1.0 };
    start.elapsed().as_secs_f64() / iteration.passes as f64 * passes * second_grid
}
