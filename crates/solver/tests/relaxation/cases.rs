//! What the tests solve, and the reference they compare with.

use std::sync::LazyLock;

use rayon::prelude::*;
use stribeck_solver::continuation::{Interrupt, Solution, SolvedCase, solve_chain};
use stribeck_solver::exact::contact_bounds;
use stribeck_solver::gauss::unit_interval;
use stribeck_solver::relaxation::{RelaxationSolver, Settings};
use stribeck_solver::{FieldSelection, Friction, Output, Parameters, Quantities};

/// Default settings with so many points.
pub fn settings(points: usize) -> Settings {
    Settings { points, ..Settings::default() }
}

/// The points of the automatic domain.
pub fn grid(parameters: &Parameters, points: usize) -> Vec<f64> {
    let (trailing, leading, half_width) = contact_bounds(parameters);
    uniform(trailing - 2.0 * half_width, leading + 3.0 * half_width, points)
}

/// So many points from one end to the other.
pub fn uniform(from: f64, to: f64, points: usize) -> Vec<f64> {
    (0..points).map(|i| from + (to - from) * i as f64 / (points - 1) as f64).collect()
}

/// Every field on the given points.
pub fn fields_at(x: Vec<f64>) -> Output {
    Output { fields: FieldSelection::ALL, x: x.into(), ..Output::default() }
}

/// No field.
pub fn no_fields() -> Output {
    Output { fields: FieldSelection::default(), ..Output::default() }
}

/// A chain in β.
pub fn chain(alpha: f64, f: f64, betas: &[f64]) -> Vec<Parameters> {
    betas.iter().map(|&beta| Parameters::new(alpha, beta, f)).collect()
}

/// What comes of a chain.
pub fn outcomes(settings: Settings, cases: &[Parameters], output: &Output) -> Vec<SolvedCase> {
    solve_chain(&RelaxationSolver::new(settings), cases, output, &Interrupt::new()).expect("nobody interrupts")
}

/// The solutions of a chain in which no case may fail.
pub fn solutions(settings: Settings, cases: &[Parameters], output: &Output) -> Vec<Solution> {
    let solved = outcomes(settings, cases, output).into_iter().zip(cases);
    solved.map(|(case, parameters)| case.outcome.unwrap_or_else(|why| panic!("{parameters:?}: {why:?}"))).collect()
}

/// The solution of one case, with fields at the points of the automatic grid, which are returned too.
pub fn on_grid(points: usize, parameters: &Parameters) -> (Vec<f64>, Solution) {
    let x = grid(parameters, points);
    let solution = solutions(settings(points), std::slice::from_ref(parameters), &fields_at(x.clone())).remove(0);
    (x, solution)
}

/// The numbers of one case.
pub fn quantities(settings: Settings, parameters: &Parameters) -> Quantities {
    solutions(settings, std::slice::from_ref(parameters), &no_fields()).remove(0).quantities
}

/// A row of `tests/reference/single_mode.csv`.
#[derive(Clone, Debug)]
pub struct Reference {
    pub parameters: Parameters,
    pub c: f64,
    pub film_min: f64,
    pub p_max: f64,
    pub x_outlet: f64,
    pub viscoelastic: f64,
    pub film_shear: f64,
    pub cavity_full: f64,
    pub cavity_streamers: f64,
    pub drag: f64,
}

impl Reference {
    pub fn hydrodynamic(&self) -> f64 {
        self.film_shear + self.cavity_full
    }
}

/// The reference, α = ∞ where f = 0.
pub fn reference() -> Vec<Reference> {
    let records = csv::Reader::from_reader(include_bytes!("../reference/single_mode.csv").as_slice()).into_records();
    let rows = records.map(|record| {
        let row: Vec<f64> = record.unwrap().iter().map(|number| number.parse().unwrap()).collect();
        let [
            f,
            alpha,
            beta,
            c,
            film_min,
            p_max,
            x_outlet,
            viscoelastic,
            film_shear,
            cavity_full,
            cavity_streamers,
            drag,
        ] = row.try_into().unwrap();
        let parameters = if f == 0.0 { Parameters::elastic(beta) } else { Parameters::new(alpha, beta, f) };
        Reference {
            parameters,
            c,
            film_min,
            p_max,
            x_outlet,
            viscoelastic,
            film_shear,
            cavity_full,
            cavity_streamers,
            drag,
        }
    });
    rows.collect()
}

/// A reference case as the solver has it on one grid.
pub struct Solved {
    pub reference: Reference,
    /// The grid.
    pub x: Vec<f64>,
    /// Fields on the grid, then at [`ahead`] of it.
    pub solution: Solution,
}

/// The film ahead of the grid: position, quadrature weight of an integral to infinity, film thickness and p′ by (T2).
pub struct Ahead {
    pub x: f64,
    pub weight: f64,
    pub film: f64,
    pub gradient: f64,
}

/// Where the film ahead of a grid is looked at, ascending, with the weights of an integral from its end to infinity.
fn ahead(end: f64) -> Vec<(f64, f64)> {
    let mut nodes: Vec<(f64, f64)> = unit_interval().map(|(t, weight)| (end / t, weight * end / (t * t))).collect();
    nodes.reverse();
    nodes
}

impl Solved {
    pub fn pressure(&self) -> &[f64] {
        &self.solution.fields.pressure.as_ref().unwrap()[..self.x.len()]
    }

    pub fn film(&self) -> &[f64] {
        &self.solution.fields.film_thickness.as_ref().unwrap()[..self.x.len()]
    }

    pub fn displacement(&self) -> &[f64] {
        &self.solution.fields.displacement.as_ref().unwrap()[..self.x.len()]
    }

    /// The end of the grid.
    pub fn end(&self) -> f64 {
        self.x[self.x.len() - 1]
    }

    pub fn ahead(&self) -> Vec<Ahead> {
        let film = &self.solution.fields.film_thickness.as_ref().unwrap()[self.x.len()..];
        let (beta, c) = (self.reference.parameters.beta, self.quantities().c);
        let nodes = ahead(self.end()).into_iter().zip(film);
        nodes
            .map(|((x, weight), &film)| Ahead { x, weight, film, gradient: -(film - c) / (beta * film.powi(3)) })
            .collect()
    }

    pub fn quantities(&self) -> &Quantities {
        &self.solution.quantities
    }

    /// Largest |β p′u³ + u − c|/u at mid-points under pressure (T2): how well the grid resolves the film.
    pub fn flow_error(&self) -> f64 {
        let (x, p, u) = (&self.x, self.pressure(), self.film());
        let error = |i: usize| {
            let film = 0.5 * (u[i - 1] + u[i]);
            let flow = self.reference.parameters.beta * (p[i] - p[i - 1]) / (x[i] - x[i - 1]) * film.powi(3) + film;
            (flow - self.quantities().c).abs() / film
        };
        (1..x.len()).filter(|&i| p[i - 1] > 0.0).map(error).fold(0.0, f64::max)
    }

    pub fn is_resolved(&self) -> bool {
        self.flow_error() < 0.05
    }
}

/// The reference cases of one grid: those that were solved, and those that were not with their reasons.
pub struct OnGrid {
    pub solved: Vec<Solved>,
    pub failed: Vec<(Parameters, String)>,
}

/// The reference cases that a test wants, each (f, α) a chain in β.
pub fn solve_reference(points: usize, wanted: impl Fn(&Parameters) -> bool) -> OnGrid {
    let rows: Vec<Reference> = reference().into_iter().filter(|row| wanted(&row.parameters)).collect();
    let same_chain =
        |a: &Reference, b: &Reference| (a.parameters.f, a.parameters.alpha) == (b.parameters.f, b.parameters.alpha);
    let chains: Vec<&[Reference]> = rows.chunk_by(same_chain).collect();
    let solve = |chain: &[Reference]| {
        let x = grid(&chain[0].parameters, points);
        let cases: Vec<Parameters> = chain.iter().map(|row| row.parameters.clone()).collect();
        let wanted = x.iter().copied().chain(ahead(x[points - 1]).iter().map(|node| node.0)).collect();
        let solved = outcomes(settings(points), &cases, &fields_at(wanted));
        let outcome = |(reference, case): (&Reference, SolvedCase)| match case.outcome {
            Ok(solution) => Ok(Solved { reference: reference.clone(), x: x.clone(), solution }),
            Err(failure) => Err((reference.parameters.clone(), failure.to_string())),
        };
        chain.iter().zip(solved).map(outcome).collect::<Vec<_>>()
    };
    let outcomes: Vec<_> = chains.into_par_iter().with_max_len(1).flat_map_iter(solve).collect();
    let (mut solved, mut failed) = (Vec::new(), Vec::new());
    for outcome in outcomes {
        match outcome {
            Ok(case) => solved.push(case),
            Err(failure) => failed.push(failure),
        }
    }
    OnGrid { solved, failed }
}

/// The range that the tests compare with the reference: β up to 1000, and f up to 100 where α is below 1 (beyond, the
/// film is thick: `failure::a_film_longer_than_its_grid_is_a_failure_that_says_so`).
pub fn is_compared(case: &Parameters) -> bool {
    case.beta <= 1000.0 && (case.alpha >= 1.0 || case.f <= 100.0)
}

/// All of them with 401 points, solved once; `reference::only_a_film_that_is_not_resolved_fails` says which one fails.
pub static ON_401: LazyLock<OnGrid> = LazyLock::new(|| solve_reference(401, is_compared));
/// The same with 801 points.
pub static ON_801: LazyLock<OnGrid> = LazyLock::new(|| solve_reference(801, is_compared));

/// Every solution on either grid.
pub fn on_any_grid() -> impl Iterator<Item = &'static Solved> {
    ON_401.solved.iter().chain(&ON_801.solved)
}

/// The cases solved on both grids, coarse and fine.
pub fn on_both_grids() -> impl Iterator<Item = (&'static Solved, &'static Solved)> {
    let fine = |coarse: &'static Solved| {
        let same = |fine: &&Solved| fine.reference.parameters == coarse.reference.parameters;
        ON_801.solved.iter().find(same).map(|fine| (coarse, fine))
    };
    ON_401.solved.iter().filter_map(fine)
}

/// |a/b − 1|.
pub fn relative(a: f64, b: f64) -> f64 {
    (a / b - 1.0).abs()
}

/// Friction and its parts, c, the smallest film, the largest pressure and the outlet.
pub fn friction_and_film(quantities: &Quantities) -> [f64; 9] {
    let Quantities { friction, c, film_min, p_max, x_outlet, .. } = *quantities;
    let [total, hydrodynamic] = [friction.total(), friction.hydrodynamic()];
    let Friction { viscoelastic, hydrodynamic_cavity, drag, .. } = friction;
    [viscoelastic, hydrodynamic, total, drag, hydrodynamic_cavity, c, film_min, p_max, x_outlet]
}
