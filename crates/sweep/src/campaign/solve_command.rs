//! The command that solves a case again.

use crate::{Recipe, SolverRecipe};
use stribeck_solver::{Parameters, Substrate, shortest};

/// The command `stribeck solve …` that solves a case alone, with all that its numbers depend on: it prints the same id.
pub fn solve_command(recipe: &Recipe, case: &Parameters) -> String {
    let [f, alpha, beta] = [case.f, case.alpha, case.beta].map(shortest);
    let mut command = format!("stribeck solve --f {f} --alpha {alpha} --beta {beta}");
    if !case.retardation().is_empty() && case.substrate != Substrate::default() {
        let mode = |share, time| format!("{}:{}", shortest(share), shortest(time));
        let modes: Vec<String> = case.substrate.modes().iter().map(|of| mode(of.share, of.time)).collect();
        command += &format!(" --modes {}", modes.join(","));
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
