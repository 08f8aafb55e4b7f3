//! The command that solves a case again.

use crate::{Recipe, SolverRecipe};
use stribeck_solver::{Parameters, RetardationMode, Substrate, shortest};

/// The command `stribeck solve …` that solves a case alone, with all that its numbers depend on: it prints the same id.
pub fn solve_command(recipe: &Recipe, case: &Parameters) -> String {
    let [f, alpha, beta] = [case.f, case.alpha, case.beta].map(shortest);
    let mut command = format!("stribeck solve --f {f} --alpha {alpha} --beta {beta}");
    if !case.retardation().is_empty() && case.substrate != Substrate::default() {
        let mode = |of: &RetardationMode| format!("{}:{}", shortest(of.share), shortest(of.time));
        let list = |modes: &[RetardationMode]| modes.iter().map(mode).collect::<Vec<_>>().join(",");
        let modes = case.substrate.modes();
        let (flat, roller) = modes.split_at(modes.len() - case.substrate.of_roller());
        if !flat.is_empty() {
            command += &format!(" --modes {}", list(flat));
        }
        if !roller.is_empty() {
            // In pure rolling the times of both bodies are what they are.
            command += &format!(" --roller-modes {} --slide-roll 0", list(roller));
        }
    }
    command += &match &recipe.solver {
        SolverRecipe::Collocation { tolerance, .. } => {
            format!(" --method collocation --tolerance {}", shortest(*tolerance))
        }
        SolverRecipe::Relaxation { settings, .. } => {
            // Without blanks and brackets, so that a shell reads one plain word.
            let domain = settings.domain.to_string().replace(['[', ']', ' '], "");
            let (tolerance, points) = (shortest(settings.tolerance), settings.points);
            format!(
                " --method relaxation --tolerance {tolerance} --points {points} --domain={domain} --acceleration {} \
                 --estimate {}",
                settings.acceleration, settings.estimate
            )
        }
    };
    command + &format!(" --cavity-shear {}", recipe.cavity_shear)
}
