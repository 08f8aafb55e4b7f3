//! `stribeck solve`: one case to the terminal.

use std::path::PathBuf;

use clap::{ArgAction, Args};

use super::at::{self, At};
use super::curve::{Choice, choose, laboratory};
use super::number::number;
use super::solution::SolvedProblem;
use super::{CliError, Exit, case_fields, console, measured, solve_batch};
use stribeck_solver::collocation;
use stribeck_solver::relaxation;
use stribeck_solver::relaxation::{Acceleration, Domain};
use stribeck_solver::{CavityShear, FieldSelection, Interrupt, Output, Parameters, RetardationMode, Solver, Substrate};
use stribeck_sweep::campaign::{case_entry, published_point, read_sweep};
use stribeck_sweep::store::Status;
use stribeck_sweep::{Axes, Field, FieldPrecision, Grid, GridIndex, Method, Plan, SolverSettings, Sweep};

/// Fewest points of a grid whose errors can be estimated.
pub const ESTIMATE_POINTS: usize = relaxation::Settings::ESTIMATE_POINTS;

/// What a sweep file says in place of options.
const OF_DIMENSIONLESS: [&str; 16] = [
    "alpha",
    "beta",
    "f",
    "batch",
    "method",
    "tolerance",
    "points",
    "acceleration",
    "estimate",
    "domain",
    "modes",
    "roller_modes",
    "slide_roll",
    "cavity_shear",
    "sensitivities",
    "time_limit",
];

#[derive(Clone, Debug, Args)]
#[command(
    before_help = "\
Examples:
  stribeck solve --alpha 1 --beta 100 --f 10
  stribeck solve --alpha inf --beta 100 --f 10          relaxed: the elastic case, whatever f is
  stribeck solve --alpha 1 --beta 1000 --f 100 --tolerance 1e-8 --json
  stribeck solve --alpha 1 --beta 100 --f 10 --modes 0.7:1,0.3:100
  stribeck solve --alpha 1 --beta 100 --f 10 --slide-roll 0        pure rolling
  stribeck solve --alpha 1 --beta 100 --f 10 --slide-roll 0 --modes 0.5:1 --roller-modes 0.5:1
  stribeck solve --alpha 1 --beta 100 --f 10 --method relaxation --points 401
  stribeck solve --batch sweeps/points.csv --tolerance 1e-7 > solved.csv
  stribeck solve --laboratory sweeps/rubber.toml --at speed=\"3 mm/s\",load=\"200 N/m\" --fields fields.csv",
    after_help = "\
Friction coefficients are over a0/R; docs/reference/columns.md has all names and units. With --json the keys are the
columns of summary.csv and slide_roll, seed, path, iterations, factorisations, unknowns, seconds. The key path has the
points that were solved on the way to the case. A number that is not known is null, an infinite alpha is \"inf\".
With --sensitivities there are also dmu_v_dln_alpha and the like, and sensitivity_errors.

With --laboratory numbers are in SI units, and method and tolerance are those of the sweep file. --fields writes x,
pressure, film_thickness, displacement, shear_traction and hysteresis_traction, each with its unit; x is that of the
sweep file, or from -3 to 3 a0.
Exit code 3: the case failed."
)]
pub struct Arguments {
    /// Slide time over retardation time, at least 0, or inf
    #[arg(long, value_name = "A", value_parser = alpha, allow_negative_numbers = true)]
    #[arg(required_unless_present_any = ["batch", "laboratory"])]
    alpha: Option<f64>,
    /// Inverse Hersey number, above 0
    #[arg(long, value_name = "B", value_parser = beta, allow_negative_numbers = true)]
    #[arg(required_unless_present_any = ["batch", "laboratory"])]
    beta: Option<f64>,
    /// Strength of retardation E0/Einf - 1, at least 0
    #[arg(long, value_name = "F", value_parser = strength, allow_negative_numbers = true)]
    #[arg(required_unless_present_any = ["batch", "laboratory"])]
    f: Option<f64>,
    /// Solve the cases of a CSV with f, alpha, beta, and where it has them modes and slide_roll; prints the rows of a
    /// summary.csv in its order
    #[arg(long, value_name = "FILE", conflicts_with_all = ["alpha", "beta", "f", "sensitivities", "json"])]
    batch: Option<PathBuf>,
    /// Solve a case of the experiment in the section [laboratory] of this sweep file
    #[arg(long, value_name = "SWEEP", conflicts_with_all = OF_DIMENSIONLESS)]
    laboratory: Option<PathBuf>,
    /// With --laboratory: quantities of the case, as in speed="3 mm/s",load="200 N/m"; without a unit in SI units. What
    /// has one value in the sweep file may be left out
    #[arg(long, value_name = "NAME=V,…", value_parser = at::parse, requires = "laboratory")]
    at: Vec<At>,
    /// Write the fields of the case along x to this file: a table by the ending .csv, HDF5 by .h5
    #[arg(long, value_name = "FILE", value_parser = case_fields::parse, conflicts_with = "batch")]
    fields: Option<PathBuf>,
    /// Method of solution: collocation or relaxation
    #[arg(long, default_value_t, value_parser = method)]
    method: Method,
    /// With collocation the relative error wanted in mu_v, mu_h and c, 1e-10 to 1e-1 [default: 1e-5]; with relaxation
    /// the residuals of Reynolds' equation and of the load at which the case is converged, 1e-12 to 1e-2 [default:
    /// 1e-8]
    #[arg(long, value_name = "T", value_parser = tolerance, allow_negative_numbers = true)]
    tolerance: Option<f64>,
    /// Relaxation: points of the uniform grid, odd, 51 to 20001 [default: 801]
    #[arg(long, value_name = "N", value_parser = points)]
    points: Option<usize>,
    /// Relaxation: anderson, or none, the paper's plain iteration [default: anderson]
    #[arg(long, value_parser = acceleration)]
    acceleration: Option<Acceleration>,
    /// Relaxation: solve on a second grid too, to estimate errors; from 201 points on [default: true where it can]
    #[arg(long, value_name = "true|false", action = ArgAction::Set)]
    estimate: Option<bool>,
    /// Relaxation: auto, or both ends of the grid in a0, as in --domain=-3,4 [default: auto]
    #[arg(long, value_name = "MIN,MAX", value_parser = domain, allow_hyphen_values = true)]
    domain: Option<Domain>,
    /// Retardation modes as SHARE:TIME, shares of f and times over the one in alpha, as in 0.7:1,0.3:100 [default: 1:1]
    #[arg(long, value_name = "MODES", value_parser = modes)]
    modes: Option<Modes>,
    /// Retardation modes of the roller, written in the same way; the shares of both bodies add up to 1 [default: none]
    #[arg(long, value_name = "MODES", value_parser = modes)]
    roller_modes: Option<Modes>,
    /// Slide-to-sum ratio S = (u2 - u1)/(u1 + u2) of flat and roller, half of an instrument's slide-to-roll ratio: -1 to
    /// 1, where 1 is a roller that slides without turning, 0 pure rolling; alpha is that of the flat as it moves
    #[arg(long, value_name = "S", default_value_t = 1.0, value_parser = slide_roll, allow_negative_numbers = true)]
    slide_roll: f64,
    /// What fills the gap behind the film: full, streamers or none
    #[arg(long, default_value_t, value_parser = cavity_shear)]
    cavity_shear: CavityShear,
    /// Derivatives of friction with respect to ln(alpha), ln(beta) and ln(f) too; with collocation
    #[arg(long)]
    sensitivities: bool,
    /// Seconds after which the case is given up, or inf [default: 3600]
    #[arg(long, value_name = "S", value_parser = time_limit)]
    time_limit: Option<f64>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

fn among(text: &str, allowed: &str, is_allowed: impl Fn(f64) -> bool) -> Result<f64, String> {
    number(text).filter(|&number| is_allowed(number)).ok_or_else(|| format!("give {allowed}"))
}

fn alpha(text: &str) -> Result<f64, String> {
    among(text, "a number that is at least 0, or inf", |alpha| alpha >= 0.0)
}

fn beta(text: &str) -> Result<f64, String> {
    let allowed = "a finite number above 0; dry sliding is the limit of large beta";
    among(text, allowed, |beta| beta > 0.0 && beta.is_finite())
}

fn slide_roll(text: &str) -> Result<f64, String> {
    let allowed = "a number from -1 to 1; beyond, the surfaces would move against each other, which is not computed";
    among(text, allowed, |slide_roll| (-1.0..=1.0).contains(&slide_roll))
}

fn strength(text: &str) -> Result<f64, String> {
    let allowed = "a finite number that is at least 0; 0 is an elastic substrate";
    among(text, allowed, |f| f >= 0.0 && f.is_finite())
}

/// What is allowed depends on the method.
fn tolerance(text: &str) -> Result<f64, String> {
    among(text, "a number above 0, as in 1e-6", |tolerance| tolerance > 0.0)
}

fn points(text: &str) -> Result<usize, String> {
    let points = text.parse().ok().filter(|points| relaxation::Settings::POINTS.contains(points) && points % 2 == 1);
    points.ok_or_else(|| "give an odd whole number from 51 to 20001, such as 401, 801 or 1601".to_owned())
}

fn method(text: &str) -> Result<Method, String> {
    match text {
        "collocation" => Ok(Method::Collocation),
        "relaxation" => Ok(Method::Relaxation),
        _ => Err("give collocation or relaxation".to_owned()),
    }
}

fn acceleration(text: &str) -> Result<Acceleration, String> {
    match text {
        "anderson" => Ok(Acceleration::Anderson),
        "none" => Ok(Acceleration::None),
        _ => Err("give anderson or none".to_owned()),
    }
}

fn domain(text: &str) -> Result<Domain, String> {
    if text == "auto" {
        return Ok(Domain::Auto);
    }
    let (least, most) = Domain::ENDS.into_inner();
    let ends = text.split_once(',').and_then(|(min, max)| Some((number(min)?, number(max)?)));
    match ends {
        Some((x_min, x_max)) if (least..0.0).contains(&x_min) && x_max > 0.0 && x_max <= most => {
            Ok(Domain::Fixed { x_min, x_max })
        }
        _ => Err(format!("give auto, or two numbers on both sides of 0, from {least} to {most}, as in -3,4")),
    }
}

/// The modes of a body, as one argument.
#[derive(Clone, Debug)]
pub struct Modes(pub Vec<RetardationMode>);

/// Reads modes.
pub fn modes(text: &str) -> Result<Modes, String> {
    let mode = |part: &str| {
        let (share, time) = part.split_once(':')?;
        Some(RetardationMode { share: number(share)?, time: number(time)? })
    };
    let modes: Option<Vec<_>> = text.split(',').map(mode).collect();
    modes
        .map(Modes)
        .ok_or_else(|| "give SHARE:TIME, or several with commas between them, as in 0.7:1,0.3:100".to_owned())
}

fn cavity_shear(text: &str) -> Result<CavityShear, String> {
    let all = [CavityShear::Full, CavityShear::Streamers, CavityShear::None];
    all.into_iter().find(|shear| shear.to_string() == text).ok_or_else(|| "give full, streamers or none".to_owned())
}

fn time_limit(text: &str) -> Result<f64, String> {
    among(text, "a number of seconds above 0, or inf", |limit| limit > 0.0)
}

impl Arguments {
    /// The settings of the method asked for.
    fn settings(&self) -> Result<SolverSettings, CliError> {
        let defaults = SolverSettings::default();
        let time_limit = self.time_limit.unwrap_or(defaults.time_limit);
        match self.method {
            Method::Collocation => {
                let others = [
                    ("--points", self.points.is_some()),
                    ("--acceleration", self.acceleration.is_some()),
                    ("--estimate", self.estimate.is_some()),
                    ("--domain", self.domain.is_some()),
                ];
                if let Some((option, _)) = others.into_iter().find(|(_, given)| *given) {
                    return Err(CliError::OtherMethod { option });
                }
                let (least, most) = collocation::Settings::TOLERANCE.into_inner();
                let tolerance = self.tolerance.unwrap_or(defaults.tolerance);
                self.check(tolerance, "the relative error wanted in mu_v, mu_h and c", least, most)?;
                Ok(SolverSettings { method: self.method, tolerance, time_limit, ..defaults })
            }
            Method::Relaxation => {
                if self.sensitivities {
                    return Err(CliError::Sensitivities);
                }
                let points = self.points.unwrap_or(defaults.relaxation.points);
                let (least, most) = relaxation::Settings::TOLERANCE.into_inner();
                let tolerance = self.tolerance.unwrap_or(defaults.relaxation.tolerance);
                self.check(tolerance, "the residual at which a case is converged", least, most)?;
                if self.estimate == Some(true) && points < ESTIMATE_POINTS {
                    return Err(CliError::Estimate { points });
                }
                let relaxation = relaxation::Settings {
                    points,
                    tolerance,
                    acceleration: self.acceleration.unwrap_or_default(),
                    estimate: self.estimate.unwrap_or(points >= ESTIMATE_POINTS),
                    domain: self.domain.unwrap_or_default(),
                };
                Ok(SolverSettings { method: self.method, relaxation, time_limit, ..defaults })
            }
        }
    }

    fn check(&self, given: f64, meaning: &'static str, least: f64, most: f64) -> Result<(), CliError> {
        match (least..=most).contains(&given) {
            true => Ok(()),
            false => Err(CliError::Tolerance { method: self.method, meaning, least, most, given }),
        }
    }

    /// The modes of both bodies.
    fn substrate(&self) -> Result<Substrate, CliError> {
        match (&self.modes, &self.roller_modes) {
            (None, None) => Ok(Substrate::default()),
            (flat, roller) => {
                let modes = |modes: &Option<Modes>| modes.as_ref().map_or_else(Vec::new, |modes| modes.0.clone());
                Substrate::of_two_bodies(modes(flat), modes(roller)).map_err(CliError::Modes)
            }
        }
    }

    /// f, α and β of the case; those of a list are in its file.
    fn case(&self) -> [f64; 3] {
        [self.f, self.alpha, self.beta].map(|given| given.unwrap_or(1.0))
    }

    /// The fields that are kept: all, or none if they go nowhere.
    fn kept_fields(&self) -> FieldSelection {
        self.fields.as_ref().map_or_else(FieldSelection::default, |_| Field::selection(Field::ALL))
    }

    /// The case as a sweep, so that it is the same as in a sweep, id included.
    fn sweep(&self) -> Result<Sweep, CliError> {
        if let Some(file) = &self.laboratory {
            let sweep = read_sweep(file)?;
            let axes = laboratory(&sweep, file)?;
            let at = at::all(&self.at);
            at.iter().for_each(|(axis, values)| measured::note_value(axis, values, &sweep.grid.dimensions()));
            let grid = Grid::Laboratory(choose(axes, &at, Choice::Case)?);
            let output = Output { fields: self.kept_fields(), sensitivities: false, ..sweep.output };
            return Ok(Sweep { grid, output, ..sweep });
        }
        let [f, alpha, beta] = self.case();
        Ok(Sweep {
            title: String::new(),
            grid: Grid::Dimensionless(Axes {
                slide_roll: Some(vec![self.slide_roll]),
                f: vec![f],
                alpha: vec![alpha],
                beta: vec![beta],
            }),
            substrate: self.substrate()?,
            solver: self.settings()?,
            output: Output {
                fields: self.kept_fields(),
                cavity_shear: self.cavity_shear,
                sensitivities: self.sensitivities,
                ..Output::default()
            },
            field_precision: FieldPrecision::Double,
            text: String::new(),
            name: String::new(),
        })
    }
}

pub fn execute(arguments: &Arguments) -> Result<Exit, CliError> {
    let sweep = arguments.sweep()?;
    if let Some(file) = &arguments.batch {
        return solve_batch::execute(file, &sweep, arguments.slide_roll);
    }
    let place = GridIndex::from([0, 0, 0]);
    let ([f, alpha, beta], slide_roll) = (sweep.grid.numbers(place), sweep.grid.slide_roll(place));
    let experiment = sweep.grid.experiment(place);
    if slide_roll == -1.0 && experiment.is_none() && sweep.substrate.of_roller() > 0 {
        return Err(CliError::RollerOverFlatAtRest);
    }
    if slide_roll == -1.0 && f > 0.0 && alpha != f64::INFINITY {
        return Err(CliError::FlatAtRest);
    }
    let settings = &sweep.solver;
    let chooses_grid = arguments.estimate.is_none() && experiment.is_none();
    if settings.method == Method::Relaxation && !settings.relaxation.estimate && chooses_grid {
        console::tell(&format!("note: no errors are estimated; that takes {ESTIMATE_POINTS} points or more"));
    }
    let fields = arguments.fields.as_deref();
    let output = fields.map(|file| case_fields::check(file, arguments.laboratory.as_deref())).transpose()?;
    let plan = Plan::new(&sweep);
    let parameters = plan.parameters_at(place);
    let solver = Solver::new(&sweep.solver_settings());
    let solved = solver.solve_chain(std::slice::from_ref(&parameters), &Interrupt::new());
    let mut case = solved.expect("no one asks this chain to stop").remove(0);
    let (path, unknowns) = (std::mem::take(&mut case.path), case.effort.unknowns);
    let mut entry = case_entry(&plan, &parameters, case);
    if let (Some(output), Some(file)) = (output, fields) {
        case_fields::write(output, file, &sweep, entry.clone())?;
    }
    let sensitivities = [entry.sensitivities, entry.sensitivity_errors];
    let point = published_point(&sweep, &plan, place);
    entry.values = point.numbers_of(&entry.values, sensitivities, None, &sweep.output).values;
    [entry.sensitivities, entry.sensitivity_errors] = point.sensitivities_of(sensitivities);
    let asked = Parameters { alpha, beta, f, ..parameters };
    let problem =
        SolvedProblem { asked: &asked, slide_roll, settings, entry: &entry, path: &path, unknowns, experiment };
    console::print(&if arguments.json { problem.json() } else { problem.table() })?;
    Ok(match entry.outcome {
        Status::Converged => Exit::Success,
        Status::Failed => Exit::CasesFailed,
    })
}
