//! A validated sweep.

use std::fmt;
use std::time::Duration;

use crate::{FieldPrecision, Grid};
use stribeck_solver::collocation;
use stribeck_solver::relaxation;
use stribeck_solver::{self as solver, Output, Substrate};

/// A sweep: which cases, of what substrate, solved how, and what is wanted of each.
///
/// [`Sweep::read`] and [`Sweep::parse`] only give sweeps that keep the promises below; who makes one by hand has to
/// keep them too.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// Title of the published results; the name if the file gives none.
    pub title: String,
    /// The values whose product is the sweep.
    pub grid: Grid,
    /// The retardation spectrum of the substrate.
    pub substrate: Substrate,
    /// How the cases are solved.
    pub solver: SolverSettings,
    /// What is wanted of each case.
    pub output: Output,
    /// How precisely the fields of each case are kept.
    pub field_precision: FieldPrecision,
    /// The sweep file as it was read, with the content of files that it names in place of their names.
    pub text: String,
    /// Stem of the file's name.
    pub name: String,
}

impl Sweep {
    /// How the solver crate solves the cases of this sweep.
    pub fn solver_settings(&self) -> solver::Settings {
        let method = match self.solver.method {
            Method::Collocation => solver::Method::Collocation(self.solver.collocation()),
            Method::Relaxation => solver::Method::Relaxation(self.solver.relaxation),
        };
        // Infinity, and what is as good as that, is no duration.
        let time_limit = Duration::try_from_secs_f64(self.solver.time_limit).ok();
        solver::Settings { method, time_limit, output: self.output.clone() }
    }
}

/// A method of solution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Method {
    /// Collocation on panels fitted to the film, with its own error estimate.
    #[default]
    Collocation,
    /// The paper's Gauss–Seidel relaxation on a uniform grid.
    Relaxation,
}

impl Method {
    /// Most cases in one chain, at most [`MAX_CHAIN`](crate::MAX_CHAIN).
    ///
    /// What an interruption throws away is at most one chain per thread. A relaxation case takes long, so its chains
    /// are short. Collocation cases are quick, save the first one of a chain, which has no neighbour to start from:
    /// their chains are long.
    pub fn chain_limit(self) -> usize {
        match self {
            Method::Collocation => 64,
            Method::Relaxation => 16,
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Method::Collocation => "collocation",
            Method::Relaxation => "relaxation",
        })
    }
}

/// How the cases of a sweep are solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolverSettings {
    /// The method.
    pub method: Method,
    /// Relative error wanted in μ_v, μ_h and c by the collocation method, within
    /// [`collocation::Settings::TOLERANCE`]; the relaxation method does not look at it.
    pub tolerance: f64,
    /// Settings of the relaxation method; the collocation method does not look at them.
    pub relaxation: relaxation::Settings,
    /// Seconds that a case may take, above 0; +∞ is no limit. It changes no number, only what is given up.
    pub time_limit: f64,
}

impl SolverSettings {
    /// The default time limit in seconds: an hour, hundreds of times what the slowest known case takes.
    pub const TIME_LIMIT: f64 = 3600.0;

    /// Settings of the collocation method: a sweep chooses the tolerance alone.
    pub fn collocation(&self) -> collocation::Settings {
        collocation::Settings::for_tolerance(self.tolerance)
    }
}

impl Default for SolverSettings {
    fn default() -> Self {
        let tolerance = collocation::Settings::default().tolerance;
        Self {
            method: Method::default(),
            tolerance,
            relaxation: relaxation::Settings::default(),
            time_limit: Self::TIME_LIMIT,
        }
    }
}
