//! What a case of the collocation method costs, and where the time goes.
//!
//! `cargo bench --bench collocation` solves, on one core, seven chains in β (f = 100, α = 10⁻³ … 10³, 20 points a
//! decade from 10 to 10⁴) at a tolerance of 10⁻⁵ and prints a table. Every chain is run several times and the fastest
//! run counts. Times are those of the machine at hand; the last columns are ratios and travel better.

use std::error::Error;
use std::sync::Mutex;
use std::time::Instant;

use nalgebra::DMatrix;
use stribeck_solver::collocation::{CollocationSolver, Settings, Timings, Workspace};
use stribeck_solver::continuation::{
    CaseSolver, Interrupt, Seed, Solution, SolveContext, SolveError, SolvedCase, StepControl, solve_chain,
};
use stribeck_solver::{Failure, FieldSelection, Output, Parameters};

const REPEATS: usize = 5;

/// The solver, telling where its time went after each case.
struct Observed {
    solver: CollocationSolver,
    timings: Mutex<[Timings; 2]>,
}

type State = <CollocationSolver as CaseSolver>::State;

impl CaseSolver for Observed {
    type Workspace = Workspace;
    type State = State;

    fn prepare(&self, parameters: &Parameters, output: &Output) -> Result<Workspace, Failure> {
        self.solver.prepare(parameters, output)
    }

    fn keep(&self, workspace: Workspace) {
        self.solver.keep(workspace);
    }

    fn origins(&self, parameters: &Parameters) -> Vec<Parameters> {
        self.solver.origins(parameters)
    }

    fn step_control(&self) -> StepControl {
        self.solver.step_control()
    }

    fn start(
        &self,
        workspace: &mut Workspace,
        case: &Parameters,
        context: &mut SolveContext,
    ) -> Result<(State, Seed), SolveError> {
        self.solver.start(workspace, case, context)
    }

    fn predict(&self, workspace: &mut Workspace, solved: &[(Parameters, State)], case: &Parameters) -> State {
        self.solver.predict(workspace, solved, case)
    }

    fn solve(
        &self,
        workspace: &mut Workspace,
        case: &Parameters,
        guess: State,
        context: &mut SolveContext,
    ) -> Result<State, SolveError> {
        self.solver.solve(workspace, case, guess, context)
    }

    fn evaluate(
        &self,
        workspace: &mut Workspace,
        case: &Parameters,
        state: &mut State,
        output: &Output,
        context: &mut SolveContext,
    ) -> Result<Solution, SolveError> {
        let result = self.solver.evaluate(workspace, case, state, output, context);
        *self.timings.lock().expect("one thread") = workspace.timings();
        result
    }
}

/// One run of a chain.
struct Run {
    cases: Vec<SolvedCase>,
    timings: [Timings; 2],
    seconds: f64,
}

fn run(observed: &Observed, alpha: f64) -> Result<Run, Box<dyn Error>> {
    let beta = (0..=60).map(|i| 10_f64.powf(1.0 + f64::from(i) / 20.0));
    let cases: Vec<Parameters> = beta.map(|beta| Parameters::new(alpha, beta, 100.0)).collect();
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    let start = Instant::now();
    let solved = solve_chain(observed, &cases, &output, &Interrupt::new()).map_err(|_| "interrupted")?;
    let seconds = start.elapsed().as_secs_f64();
    let timings = *observed.timings.lock().expect("one thread");
    Ok(Run { cases: solved, timings, seconds })
}

/// Seconds that a factorisation of a full matrix of this size takes by a plain library.
fn bare_factorisation(unknowns: usize) -> f64 {
    let matrix =
        DMatrix::from_fn(unknowns, unknowns, |i, j| ((i * 37 + j * 91) % 101) as f64 / 101.0 + f64::from(i == j));
    let times = 40;
    let best = (0..5).map(|_| {
        let start = Instant::now();
        for _ in 0..times {
            std::hint::black_box(std::hint::black_box(matrix.clone()).lu());
        }
        start.elapsed().as_secs_f64() / f64::from(times)
    });
    best.fold(f64::INFINITY, f64::min)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("collocation, tolerance 1e-5, f = 100, beta = 10 .. 1e4 with 20 points a decade; ms a case");
    println!(
        "{:>8} {:>7} {:>7} {:>7} | {:>7} {:>7} {:>8} {:>7} {:>7} {:>8} {:>6} | {:>6} {:>6} {:>7} {:>6} | {:>9}",
        "alpha",
        "median",
        "mean",
        "first",
        "kernel",
        "filter",
        "assembly",
        "LU",
        "steps",
        "estimate",
        "rest",
        "Newton",
        "LUs",
        "meshes",
        "n",
        "x bare LU"
    );
    let observed = Observed { solver: CollocationSolver::new(Settings::default()), timings: Mutex::default() };
    let (mut all, mut sum) = (Vec::new(), 0.0);
    for alpha in (-3..=3).map(|i| 10_f64.powi(i)) {
        let mut best: Option<Run> = None;
        for _ in 0..REPEATS {
            let run = run(&observed, alpha)?;
            if best.as_ref().is_none_or(|best| run.seconds < best.seconds) {
                best = Some(run);
            }
        }
        let Run { cases, timings: [solution, estimate], seconds } = best.ok_or("no run")?;
        let count = cases.len() as f64;
        if let Some(failed) = cases.iter().find_map(|case| case.outcome.as_ref().err()) {
            return Err(failed.clone().into());
        }
        let mut times: Vec<f64> = cases.iter().map(|case| 1e3 * case.effort.seconds).collect();
        let first = times[0];
        times.sort_by(f64::total_cmp);
        let mean_of = |of: fn(&SolvedCase) -> u64| cases.iter().map(of).sum::<u64>() as f64 / count;
        let factorisations = mean_of(|case| case.effort.factorisations);
        let unknowns = mean_of(|case| case.effort.unknowns as u64);
        let each = |seconds: f64| 1e3 * seconds / count;
        let estimating = estimate.assembly + estimate.factorisation + estimate.step;
        let rest = seconds - solution.total() - estimate.total();
        let bare = factorisations * bare_factorisation(unknowns as usize);
        println!(
            "{alpha:>8} {:>7.3} {:>7.3} {first:>7.3} | {:>7.3} {:>7.3} {:>8.3} {:>7.3} {:>7.3} {:>8.3} {:>6.3} | {:>6.2} \
             {factorisations:>6.2} {:>7.2} {unknowns:>6.0} | {:>9.1}",
            times[times.len() / 2],
            each(seconds),
            each(solution.kernel + estimate.kernel),
            each(solution.filter + estimate.filter),
            each(solution.assembly),
            each(solution.factorisation),
            each(solution.step),
            each(estimating),
            each(rest),
            mean_of(|case| case.effort.iterations),
            mean_of(|case| case.effort.meshes),
            seconds / count / bare,
        );
        sum += seconds / count;
        all.extend(times);
    }
    all.sort_by(f64::total_cmp);
    println!("median of all {:.3}, mean of all {:.3}", all[all.len() / 2], 1e3 * sum / 7.0);
    Ok(())
}
