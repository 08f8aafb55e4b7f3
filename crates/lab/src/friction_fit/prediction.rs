//! Friction at the measured points, and how it changes with the unknowns.

use super::{FrictionFitError, FrictionTask, Unknown};
use crate::{Experiment, LaboratoryQuantity, Measured};
use stribeck_solver::{
    Failure, Friction, Interrupt, Method, Output, Parameters, Sensitivities, Settings, Solution, Substrate,
    collocation, solve_points,
};

/// The largest relative error of a solution: a fit compares small differences.
const TOLERANCE: f64 = 1e-7;

/// The points of a task.
pub(super) struct Predictor<'a> {
    measured: &'a Measured,
    /// The experiment of the task.
    beginning: Experiment,
    /// The experiment of each point, with the start of the unknowns.
    experiments: Vec<Experiment>,
    unknowns: &'a [Unknown],
    /// The retardation spectra of flat and roller.
    spectra: [&'a Substrate; 2],
    settings: Settings,
}

/// Friction coefficients at the points.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Prediction {
    /// μ of each point.
    pub(super) friction: Vec<f64>,
    /// dμ/d ln of each unknown, for each point.
    pub(super) derivatives: Vec<Vec<f64>>,
}

/// Why there is no prediction.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum NotPredicted {
    /// The case of a point failed.
    Failed { point: usize, failure: Failure },
    /// The solver was told to stop.
    Interrupted,
}

impl<'a> Predictor<'a> {
    /// The points of a task at the start of its unknowns.
    ///
    /// # Errors
    /// [`FrictionFitError::Task`] if the file does not go with the unknowns.
    pub(super) fn new(task: &'a FrictionTask<'_>) -> Result<Self, FrictionFitError> {
        check_columns(task).and_then(|()| check_unknowns(task)).map_err(|what| FrictionFitError::Task { what })?;
        Ok(Self {
            measured: task.measured,
            beginning: task.experiment,
            experiments: (0..task.measured.friction.len()).map(|point| at_point(task, point)).collect(),
            unknowns: &task.unknowns,
            spectra: [task.substrate, task.roller_spectrum],
            settings: settings(task, true),
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

    /// The unknowns.
    pub(super) fn unknowns(&self) -> &[Unknown] {
        self.unknowns
    }

    /// The values at which they begin.
    pub(super) fn start(&self) -> Vec<f64> {
        self.unknowns.iter().map(|unknown| unknown.value(&self.beginning)).collect()
    }

    /// Solves the cases of all points, those that are equal once.
    pub(super) fn predict(&self, unknowns: &[f64], interrupt: &Interrupt) -> Result<Prediction, NotPredicted> {
        let experiments = self.experiments(unknowns);
        let [flat, roller] = self.spectra;
        let cases: Vec<Parameters> =
            experiments.iter().map(|experiment| experiment.parameters_of_both(flat, roller)).collect();
        let solved = solve_points(&cases, &self.settings, interrupt).map_err(|_| NotPredicted::Interrupted)?;
        let mut prediction = Prediction::default();
        for (point, (solved, experiment)) in solved.into_iter().zip(&experiments).enumerate() {
            let solution = solved.outcome.map_err(|failure| NotPredicted::Failed { point, failure })?;
            let (friction, derivatives) = self.friction(&solution, experiment);
            prediction.friction.push(friction);
            prediction.derivatives.push(derivatives);
        }
        Ok(prediction)
    }

    /// μ of a solution, and dμ/d ln of each unknown by way of the parameters of the case and the scale a₀/R.
    fn friction(&self, solution: &Solution, experiment: &Experiment) -> (f64, Vec<f64>) {
        let sensitivities: Sensitivities = solution.sensitivities.expect("they were asked for");
        let friction = solution.quantities.friction;
        let slide_roll = experiment.motion.slide_roll();
        // over a₀/R
        let force = coefficient(self.measured.column, &friction, slide_roll);
        let derivatives = match self.measured.column {
            "mu_v" => sensitivities.viscoelastic(),
            "mu_h" => sensitivities.hydrodynamic_at(slide_roll),
            "mu_tot" => sensitivities.total_at(slide_roll),
            _ => sensitivities.drag_at(slide_roll),
        };
        let scale = experiment.scales().friction;
        let along = |unknown: &Unknown| {
            let powers = unknown.powers(experiment);
            scale * (powers.changes(derivatives).iter().sum::<f64>() + force * powers.friction)
        };
        (scale * force, self.unknowns.iter().map(along).collect())
    }
}

/// How the cases of a task are solved.
pub(super) fn settings(task: &FrictionTask<'_>, sensitivities: bool) -> Settings {
    let output = Output { cavity_shear: task.cavity_shear, sensitivities, ..Output::numbers() };
    let method = collocation::Settings::for_tolerance(task.tolerance.min(TOLERANCE));
    Settings { method: Method::Collocation(method), time_limit: None, output }
}

/// The friction coefficient of a column, over a₀/R.
pub(super) fn coefficient(column: &str, friction: &Friction, slide_roll: f64) -> f64 {
    match column {
        "mu_v" => friction.viscoelastic,
        "mu_h" => friction.hydrodynamic_at(slide_roll),
        "mu_tot" => friction.total_at(slide_roll),
        _ => friction.drag_at(slide_roll),
    }
}

/// Checks that the columns of the file are known quantities, and none of them is looked for.
fn check_columns(task: &FrictionTask<'_>) -> Result<(), String> {
    let FrictionTask { measured, unknowns, .. } = task;
    for (name, _) in &measured.coordinates {
        if unknowns.iter().any(|unknown| unknown.name() == *name) {
            return Err(format!("{name} is a column of the measured points, and cannot be looked for"));
        }
        if name.ends_with("_modulus") && unknowns.iter().any(|unknown| unknown.is_modulus()) {
            return Err(format!("{name} is a column of the measured points: the other modulus follows from it and f"));
        }
        if let Some(quantity) = LaboratoryQuantity::named(name).filter(|it| is_speed_of_another_form(task, *it)) {
            return Err(another_form(task, quantity, "is a column of the measured points"));
        }
        if *name == "alpha" || *name == "beta" {
            return Err(format!("{name} is no quantity of the laboratory; give speed, load and so on"));
        }
    }
    Ok(())
}

/// True for a speed that is none of those by which the experiment gives its motion.
fn is_speed_of_another_form(task: &FrictionTask<'_>, quantity: LaboratoryQuantity) -> bool {
    LaboratoryQuantity::SPEEDS.contains(&quantity) && !task.experiment.motion.given().contains(&quantity)
}

fn another_form(task: &FrictionTask<'_>, quantity: LaboratoryQuantity, what: &str) -> String {
    let given: Vec<&str> = task.experiment.motion.given().iter().map(|quantity| quantity.name()).collect();
    let (name, given) = (quantity.name(), given.join(" and "));
    format!("{name} {what}, and the sweep file gives {given}; give both in the same form")
}

/// Checks that one modulus of each body at most is looked for, and that every unknown begins above 0.
fn check_unknowns(task: &FrictionTask<'_>) -> Result<(), String> {
    let moduli = |is: &dyn Fn(&Unknown) -> bool| task.unknowns.iter().filter(|unknown| is(unknown)).count();
    let is_of_roller = |unknown: &Unknown| matches!(unknown, Unknown::Roller(quantity) if quantity.is_modulus());
    if moduli(&|unknown| unknown.is_modulus()) > 1 || moduli(&is_of_roller) > 1 {
        return Err("look for one of the moduli of a body and f: the other modulus follows from these".into());
    }
    let other_form = task.unknowns.iter().find_map(|unknown| match unknown {
        Unknown::Quantity(quantity) => Some(*quantity).filter(|it| is_speed_of_another_form(task, *it)),
        Unknown::Strength | Unknown::Roller(_) => None,
    });
    if let Some(quantity) = other_form {
        return Err(another_form(task, quantity, "is looked for"));
    }
    let of_rigid = |unknown: &&Unknown| matches!(unknown, Unknown::Roller(_)) && task.experiment.roller.is_rigid();
    if let Some(unknown) = task.unknowns.iter().find(of_rigid) {
        let name = unknown.name();
        return Err(format!("{name} is looked for, and the roller is rigid; give [roller] the values to begin at"));
    }
    match task.unknowns.iter().find(|unknown| !(0.0..f64::INFINITY).contains(&unknown.value(&task.experiment))) {
        Some(unknown) => Err(format!("{} is looked for, and the flat is rigid; give it a modulus", unknown.name())),
        None => check_start(task),
    }
}

/// Checks that every unknown begins above 0.
fn check_start(task: &FrictionTask<'_>) -> Result<(), String> {
    match task.unknowns.iter().find(|unknown| unknown.value(&task.experiment) == 0.0) {
        Some(unknown) => {
            let name = unknown.name();
            Err(format!("{name} begins at 0, and is looked for among positive numbers; begin above"))
        }
        None => Ok(()),
    }
}

/// The experiment of a point: that of the task, with the values of the point's columns.
fn at_point(task: &FrictionTask<'_>, point: usize) -> Experiment {
    let mut experiment = task.experiment;
    for (name, values) in &task.measured.coordinates {
        match LaboratoryQuantity::named(name) {
            Some(quantity) => experiment.set(quantity, values[point]),
            None => experiment.f = values[point],
        }
    }
    experiment
}
