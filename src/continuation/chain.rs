//! Solving a chain: each case seeded by the ones before it, with a ladder of other seeds should one fail.

use std::borrow::Cow;
use std::iter;
use std::time::Instant;

use super::walk::{Corrector, push};
use super::{
    CaseSolver, Effort, Halt, Interrupt, Interrupted, Path, Seed, Solution, SolvedCase, StepControl, Work, distance,
};
use crate::exact::ChainLimits;
use crate::model::{Failure, Limits, Output, Parameters};

/// Solves the cases of a chain in their order. A case that fails is reported as such and does not stop the others.
///
/// A ladder of seeds is tried: the predictor from the last two solved cases; a walk from the last one, whose first step is
/// the whole way; from each of the solver's origins, its start there and a walk to the case. The first case has the origins
/// alone. So every number is a function of the chain, and of nothing that happens elsewhere. A conclusive failure ends the
/// search. Cases that are not [computable](Parameters::computable) fail without a try.
///
/// # Errors
/// [`Interrupted`] if the user asks to stop before the last case is done; what was solved of the chain is dropped.
pub fn solve_chain<S: CaseSolver>(
    solver: &S,
    cases: &[Parameters],
    output: &Output,
    interrupt: &Interrupt,
) -> Result<Vec<SolvedCase>, Interrupted> {
    let mut chain = Chain::new(solver, output, interrupt);
    cases.iter().map(|parameters| chain.solve(parameters)).collect()
}

/// A chain at work, case by case; [`solve_chain`] says how.
pub struct Chain<'a, S: CaseSolver> {
    solver: &'a S,
    /// What the cases share, once the first one is there.
    workspace: Option<Result<S::Workspace, Failure>>,
    limits: ChainLimits,
    solved: Solved<S>,
    output: &'a Output,
    interrupt: &'a Interrupt,
}

/// The last solved cases, at most two, the nearest last.
type Solved<S> = Vec<(Parameters, <S as CaseSolver>::State)>;

impl<'a, S: CaseSolver> Chain<'a, S> {
    /// A chain without any case yet.
    pub fn new(solver: &'a S, output: &'a Output, interrupt: &'a Interrupt) -> Self {
        let (limits, solved) = (ChainLimits::default(), Vec::with_capacity(2));
        Self { solver, workspace: None, limits, solved, output, interrupt }
    }

    /// Solves the next case. The first one pays for what the chain shares.
    ///
    /// # Errors
    /// [`Interrupted`] if the user asks to stop before it is done.
    pub fn solve(&mut self, parameters: &Parameters) -> Result<SolvedCase, Interrupted> {
        let start = Instant::now();
        let Self { solver, workspace, solved, output, interrupt, .. } = self;
        let computable = parameters.computable();
        let wanted = output.limits && computable.is_ok();
        let limits = if wanted { self.limits.of(parameters) } else { Limits::UNKNOWN };
        let prepare = || solver.prepare(parameters, output);
        let prepared =
            computable.and_then(|()| workspace.get_or_insert_with(prepare).as_mut().map_err(|why| why.clone()));
        let mut result = match prepared {
            Ok(workspace) => {
                let control = solver.step_control();
                Ladder { solver: *solver, workspace, control, solved, output, interrupt }.climb(parameters, limits)?
            }
            Err(failure) => SolvedCase {
                outcome: Err(failure),
                limits,
                seed: Seed::None,
                path: Path::default(),
                effort: Effort::default(),
            },
        };
        result.effort.seconds = start.elapsed().as_secs_f64();
        Ok(result)
    }

    /// The last case that was solved, in the solver's own unknowns, and the workspace; `None` before the first.
    pub fn last(&mut self) -> Option<(&mut S::Workspace, &Parameters, &S::State)> {
        let (parameters, state) = self.solved.last()?;
        let workspace = self.workspace.as_mut()?.as_mut().ok()?;
        Some((workspace, parameters, state))
    }
}

/// The seeds of one case, tried one after the other.
struct Ladder<'c, 'a, S: CaseSolver> {
    solver: &'a S,
    workspace: &'c mut S::Workspace,
    control: StepControl,
    solved: &'c mut Solved<S>,
    output: &'a Output,
    interrupt: &'a Interrupt,
}

/// A place on the ladder of seeds.
enum Rung {
    Predictor,
    Neighbour,
    Origin(Parameters),
}

impl<S: CaseSolver> Ladder<'_, '_, S> {
    /// Tries one rung after the other.
    fn climb(mut self, parameters: &Parameters, limits: Limits) -> Result<SolvedCase, Interrupted> {
        let solver = self.solver;
        let mut work = Work::new(self.interrupt);
        let mut path = Path::default();
        let mut seed = Seed::None;
        let mut reasons: Vec<String> = Vec::new();
        let predictor = (self.solved.len() == 2).then_some(Rung::Predictor);
        let neighbour = (!self.solved.is_empty()).then_some(Rung::Neighbour);
        let origins = iter::once_with(|| solver.origins(parameters)).flatten().map(Rung::Origin);
        for rung in predictor.into_iter().chain(neighbour).chain(origins) {
            match self.step_on(rung, parameters, &mut seed, &mut path, &mut work) {
                Ok((state, solution)) => {
                    push(self.solved, parameters.clone(), state);
                    if path.points.len() == 1 {
                        path = Path::default();
                    }
                    return Ok(SolvedCase { outcome: Ok(solution), limits, seed, path, effort: work.effort });
                }
                Err(Halt::Failed(Failure { reason, conclusive })) => {
                    reasons.push(match seed {
                        Seed::None => format!("no first guess: {reason}"),
                        _ => format!("from {seed}: {reason}"),
                    });
                    if conclusive {
                        break;
                    }
                }
                Err(Halt::Interrupted) => return Err(Interrupted),
            }
        }
        let failure = Failure::new(reasons.join("; "));
        Ok(SolvedCase { outcome: Err(failure), limits, seed, path, effort: work.effort })
    }

    /// The solution by way of one rung, and what is to be known of it; `seed` is how far this went.
    fn step_on(
        &mut self,
        rung: Rung,
        case: &Parameters,
        seed: &mut Seed,
        path: &mut Path,
        work: &mut Work,
    ) -> Result<(S::State, Solution), Halt> {
        let Self { solver, control, solved, output, .. } = self;
        let mut corrector = Corrector { solver: *solver, workspace: self.workspace, work, path };
        let mut state = match rung {
            Rung::Predictor => {
                *seed = Seed::Predictor;
                let guess = corrector.predict(solved, case);
                corrector.solve(case, guess)?.0
            }
            Rung::Neighbour => {
                let nearest = &solved[solved.len() - 1..];
                let way = distance(&nearest[0].0, case);
                let mut points = 0;
                let reached = corrector.walk(Cow::Borrowed(nearest), case, way, control, &mut points);
                *seed = if points == 0 { Seed::Neighbour } else { Seed::Intermediate(points) };
                reached?
            }
            Rung::Origin(origin) if origin == *case => {
                *seed = Seed::None;
                let (guess, from) = corrector.solver.start(corrector.workspace, case, corrector.work)?;
                *seed = from;
                corrector.solve(case, guess)?.0
            }
            Rung::Origin(origin) => {
                *seed = Seed::March(0);
                let state = corrector.begin(&origin, case)?;
                let mut points = 1;
                let solved = Cow::Owned(vec![(origin, state)]);
                let reached = corrector.walk(solved, case, control.first, control, &mut points);
                *seed = Seed::March(points);
                reached?
            }
        };
        let solution = self.solver.evaluate(self.workspace, case, &mut state, output, work)?;
        Ok((state, solution))
    }
}
