//! What cases are solved with, as far as it changes their numbers.

use serde::{Deserialize, Serialize};

use crate::{Method, SolverSettings};
use stribeck_solver::collocation;
use stribeck_solver::relaxation;
use stribeck_solver::{CavityShear, shortest};

/// The method, the version of its results, its settings, and what fills the cavity: together with the parameters all
/// that the numbers of a case depend on. It is kept with stored cases, so that a later sweep can tell why one of them
/// is of no use.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Recipe {
    /// The method with its settings.
    #[serde(flatten)]
    pub solver: SolverRecipe,
    /// What fills the gap behind the outlet.
    pub cavity_shear: CavityShear,
}

/// A method, the version of its results and its settings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "method", rename_all = "lowercase")]
pub enum SolverRecipe {
    /// Collocation.
    Collocation {
        /// [`collocation::RESULTS_VERSION`].
        version: u32,
        /// Relative error wanted.
        tolerance: f64,
        /// Degree of the panels.
        degree: usize,
    },
    /// Relaxation.
    Relaxation {
        /// [`relaxation::RESULTS_VERSION`].
        version: u32,
        /// The settings.
        #[serde(flatten)]
        settings: relaxation::Settings,
    },
}

impl Recipe {
    /// The recipe of this version of the program.
    pub fn new(solver: &SolverSettings, cavity_shear: CavityShear) -> Self {
        let solver = match solver.method {
            Method::Collocation => {
                let collocation::Settings { tolerance, degree } = solver.collocation();
                SolverRecipe::Collocation { version: collocation::RESULTS_VERSION, tolerance, degree }
            }
            Method::Relaxation => {
                SolverRecipe::Relaxation { version: relaxation::RESULTS_VERSION, settings: solver.relaxation }
            }
        };
        Self { solver, cavity_shear }
    }

    /// Describes how this recipe differs from another one: `tolerance 1e-5, now 1e-6`.
    pub fn differences(&self, now: &Self) -> String {
        let (then_names, now_names) = (self.solver.settings(), now.solver.settings());
        let mut differences = Vec::new();
        if self.solver.method() != now.solver.method() {
            differences.push(format!("method {}, now {}", self.solver.method(), now.solver.method()));
        } else {
            for ((name, then), (_, now)) in then_names.into_iter().zip(now_names).filter(|(then, now)| then != now) {
                differences.push(format!("{name} {then}, now {now}"));
            }
        }
        if self.cavity_shear != now.cavity_shear {
            differences.push(format!("cavity_shear {}, now {}", self.cavity_shear, now.cavity_shear));
        }
        differences.join("; ")
    }
}

impl SolverRecipe {
    /// The method.
    pub fn method(&self) -> Method {
        match self {
            Self::Collocation { .. } => Method::Collocation,
            Self::Relaxation { .. } => Method::Relaxation,
        }
    }

    /// Name and value of everything that changes the numbers; for one method always the same names.
    fn settings(&self) -> Vec<(&'static str, String)> {
        match self {
            Self::Collocation { version, tolerance, degree } => vec![
                ("version of the results", version.to_string()),
                ("tolerance", shortest(*tolerance)),
                ("degree of the panels", degree.to_string()),
            ],
            Self::Relaxation { version, settings } => vec![
                ("version of the results", version.to_string()),
                ("domain", settings.domain.to_string()),
                ("points", settings.points.to_string()),
                ("tolerance", shortest(settings.tolerance)),
                ("acceleration", settings.acceleration.to_string()),
                ("estimate", settings.estimate.to_string()),
            ],
        }
    }
}
