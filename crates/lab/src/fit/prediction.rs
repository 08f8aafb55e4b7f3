//! Friction at the measured points, and how it changes with the unknowns.

use rayon::prelude::*;

use super::{FitError, Task, Unknown};
use crate::Experiment;
use crate::LaboratoryQuantity;
use crate::measured::Measured;
use stribeck_solver::collocation::{self, CollocationSolver};
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::{Failure, FieldSelection, Output, Parameters, Substrate};

/// Points that seed one another: as many whatever the threads are, so that numbers do not depend on these.
const CHAIN: usize = 16;
/// Solutions are at least as good as this: a fit compares small differences.
const TOLERANCE: f64 = 1e-7;

/// How the cases of a fit are solved: by the collocation method.
#[derive(Clone, Copy, Debug)]
pub struct SolverChoice {
    /// Relative error wanted.
    pub tolerance: f64,
}

/// The points of a task.
pub(super) struct Predictor<'a> {
    measured: &'a Measured,
    /// The experiment of each point, with the start of the unknowns.
    experiments: Vec<Experiment>,
    unknowns: &'a [Unknown],
    substrate: &'a Substrate,
    solver: CollocationSolver,
    output: Output,
}

/// Friction coefficients at the points.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Prediction {
    /// μ of each point.
    pub(super) friction: Vec<f64>,
    /// dμ/d ln of each unknown, for each point.
    pub(super) derivatives: Vec<Vec<f64>>,
}

/// A point whose case failed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Failed {
    pub(super) point: usize,
    pub(super) failure: Failure,
}

impl<'a> Predictor<'a> {
    pub(super) fn new(task: &'a Task<'_>) -> Result<Self, FitError> {
        let Task { measured, unknowns, .. } = task;
        let refuse = |what: String| Err(FitError::Task { what });
        if measured.column == "mu_drag" {
            return refuse(
                "mu_drag cannot be fitted: its sensitivities are not known; fit mu (mu_tot), mu_v or mu_h".into(),
            );
        }
        for (name, _) in &measured.coordinates {
            if unknowns.iter().any(|unknown| unknown.name() == *name) {
                return refuse(format!("{name} is a column of the measured points, and cannot be looked for"));
            }
            if name.ends_with("_modulus") && unknowns.iter().any(|unknown| unknown.name().ends_with("_modulus")) {
                return refuse(format!(
                    "{name} is a column of the measured points: the other modulus follows from it and f"
                ));
            }
            if *name == "alpha" || *name == "beta" {
                return refuse(format!("{name} is no quantity of the laboratory; give speed, load and so on"));
            }
        }
        let modulus = |unknown: &&Unknown| {
            use LaboratoryQuantity::{InstantaneousModulus, RelaxedModulus};
            matches!(unknown, Unknown::Quantity(RelaxedModulus | InstantaneousModulus))
        };
        if unknowns.iter().filter(modulus).count() > 1 {
            return refuse("look for one of the moduli and f: the other modulus follows from these".into());
        }
        if let Some(unknown) = unknowns.iter().find(|unknown| unknown.value(&task.experiment) <= 0.0) {
            return refuse(format!(
                "{} begins at 0, and is looked for among positive numbers; begin above",
                unknown.name()
            ));
        }
        let experiments = (0..measured.friction.len()).map(|point| at_point(task, point)).collect();
        let tolerance = task.solver.tolerance.min(TOLERANCE);
        Ok(Self {
            measured,
            experiments,
            unknowns,
            substrate: task.substrate,
            solver: CollocationSolver::new(collocation::Settings::for_tolerance(tolerance)),
            output: Output {
                fields: FieldSelection::default(),
                limits: false,
                sensitivities: true,
                cavity_shear: task.cavity_shear,
                ..Output::default()
            },
        })
    }

    /// The experiments of the points with other values of the unknowns.
    pub(super) fn experiments(&self, unknowns: &[f64]) -> Vec<Experiment> {
        let with = |experiment: &Experiment| {
            let mut other = *experiment;
            self.unknowns.iter().zip(unknowns).for_each(|(unknown, value)| unknown.set(&mut other, *value));
            other
        };
        self.experiments.iter().map(with).collect()
    }

    /// Solves the cases of all points: in ascending β, in chains of neighbours.
    pub(super) fn predict(&self, unknowns: &[f64]) -> Result<Prediction, Failed> {
        let experiments = self.experiments(unknowns);
        let case = |experiment: &Experiment| Parameters {
            alpha: experiment.alpha(),
            beta: experiment.beta(),
            f: experiment.f,
            substrate: self.substrate.clone(),
        };
        let cases: Vec<Parameters> = experiments.iter().map(case).collect();
        let mut order: Vec<usize> = (0..cases.len()).collect();
        order.sort_by(|one, other| cases[*one].beta.total_cmp(&cases[*other].beta));
        let nobody = Interrupt::new();
        let solved: Vec<_> = order
            .par_chunks(CHAIN)
            .map(|points| {
                let chain: Vec<Parameters> = points.iter().map(|point| cases[*point].clone()).collect();
                solve_chain(&self.solver, &chain, &self.output, &nobody).expect("nobody asks this chain to stop")
            })
            .collect();
        let mut prediction =
            Prediction { friction: vec![0.0; cases.len()], derivatives: vec![Vec::new(); cases.len()] };
        for (point, solved) in order.iter().zip(solved.into_iter().flatten()) {
            let solution = solved.outcome.map_err(|failure| Failed { point: *point, failure })?;
            let sensitivities = solution.sensitivities.expect("they were asked for");
            let friction = solution.quantities.friction;
            // over a₀/R
            let (force, derivatives) = match self.measured.column {
                "mu_v" => (friction.viscoelastic, sensitivities.viscoelastic),
                "mu_h" => (friction.hydrodynamic(), sensitivities.hydrodynamic),
                _ => (friction.total(), sensitivities.total()),
            };
            let experiment = &experiments[*point];
            let scale = experiment.scales().friction;
            let along = |unknown: &Unknown| {
                let powers = unknown.powers(experiment);
                let [with_alpha, with_beta, with_f] = derivatives;
                let own = if *unknown == Unknown::Strength { with_f } else { 0.0 };
                scale * (with_alpha * powers.alpha + with_beta * powers.beta + own + force * powers.friction)
            };
            prediction.friction[*point] = scale * force;
            prediction.derivatives[*point] = self.unknowns.iter().map(along).collect();
        }
        Ok(prediction)
    }
}

/// The experiment of a point: that of the task, with what the point says of itself.
fn at_point(task: &Task<'_>, point: usize) -> Experiment {
    let mut experiment = task.experiment;
    for (name, values) in &task.measured.coordinates {
        match LaboratoryQuantity::named(name) {
            Some(quantity) => experiment.set(quantity, values[point]),
            None => experiment.f = values[point],
        }
    }
    experiment
}
