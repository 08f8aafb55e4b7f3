//! Where a fit begins, by the surface that is built in.

use crate::universe::universe;
use stribeck_lab::{Experiment, FrictionTask, best_beginning};
use stribeck_solver::Parameters;

/// The experiment of a task with its unknowns at the best beginning, of thousands between their bounds or up to a
/// thousand times off: see [`best_beginning`].
///
/// # Errors
/// What is wrong, in words: the built-in surface is not of such an experiment, or the bounds leave nothing.
pub fn searched(task: &FrictionTask<'_>) -> Result<Experiment, String> {
    check(task)?;
    let surface = universe();
    let mut evaluator = surface.evaluator();
    // μ_tot is the sum of two parts.
    let parts = match task.measured.column {
        "mu_tot" => &["mu_v", "mu_h"][..],
        "mu_v" => &["mu_v"],
        "mu_h" => &["mu_h"],
        _ => &["mu_drag"],
    };
    let places: Vec<usize> =
        (0..).zip(surface.quantities()).filter(|(_, it)| parts.contains(it)).map(|it| it.0).collect();
    let mut friction = |case: &Parameters| {
        let values = evaluator.values(&[case.alpha, case.beta, case.f]).ok()?;
        Some(places.iter().map(|place| values[*place]).sum())
    };
    best_beginning(task, &mut friction).map_err(|error| error.to_string())
}

/// Checks that the surface is of such experiments.
fn check(task: &FrictionTask<'_>) -> Result<(), String> {
    let experiment = &task.experiment;
    let slides = experiment.motion.slide_roll() == 1.0
        && task
            .measured
            .coordinates
            .iter()
            .all(|(name, _)| !["slide_roll_ratio", "roller_speed", "flat_speed"].contains(name));
    match (task.substrate.modes().len(), experiment.roller.is_rigid(), slides) {
        (1, true, true) => Ok(()),
        _ => Err("a search is for one retardation time and a rigid roller that slides, of which the built-in surface \
                  is; leave it out, and give values to begin at"
            .to_owned()),
    }
}
