//! Solving a chain: each case is seeded by the ones before it, and other seeds are tried if that fails.

use std::any::Any;
use std::borrow::Cow;
use std::iter;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use super::walk::{Corrector, push};
use super::{
    CaseSolver, Failure, FailureKind, Interrupt, Interrupted, Path, Seed, Solution, SolveContext, SolveError,
    SolvedCase, StepControl, distance,
};
use crate::model::{Limits, Output, Parameters};

/// Solves the cases of a chain in their order. A case that fails is reported as such and does not stop the others.
///
/// These seeds are tried in their order: the predictor from the last two solved cases; a walk from the last one, whose
/// first step is the whole way; from each of the solver's origins, its start there and a walk to the case. The first
/// origin comes before the predictor where the last case is [far](CaseSolver::is_far). The first case has the origins
/// alone. So every number is a function of the chain, and of nothing that happens elsewhere. A
/// [conclusive](FailureKind::is_conclusive) failure ends the search. Cases that are not
/// [computable](Parameters::computable) fail without a try.
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

/// A chain that is solved case by case; [`solve_chain`] tells how.
pub struct Chain<'a, S: CaseSolver> {
    solver: &'a S,
    /// The workspace of all cases, made for the first one.
    workspace: Option<Result<S::Workspace, Failure>>,
    solved: Solved<S>,
    output: &'a Output,
    interrupt: &'a Interrupt,
    time_limit: Option<Duration>,
    traced: bool,
}

/// The last solved cases, at most two, the nearest one at the end.
type Solved<S> = Vec<(Parameters, <S as CaseSolver>::State)>;

impl<'a, S: CaseSolver> Chain<'a, S> {
    /// A chain before its first case.
    pub fn new(solver: &'a S, output: &'a Output, interrupt: &'a Interrupt) -> Self {
        let solved = Vec::with_capacity(2);
        Self { solver, workspace: None, solved, output, interrupt, time_limit: None, traced: false }
    }

    /// The same chain with a time limit for each case.
    #[must_use]
    pub fn with_time_limit(mut self, time_limit: Duration) -> Self {
        self.time_limit = Some(time_limit);
        self
    }

    /// Turns the [trace](SolvedCase::trace) of the next cases on or off.
    pub fn traced(&mut self, traced: bool) {
        self.traced = traced;
    }

    /// Solves the next case. The first one pays for what the chain shares. A case that takes longer than the time limit
    /// fails, and so does one whose solver panics: the next one has a workspace of its own then.
    ///
    /// # Errors
    /// [`Interrupted`] if the user asks to stop before it is done.
    pub fn solve(&mut self, parameters: &Parameters) -> Result<SolvedCase, Interrupted> {
        let start = Instant::now();
        // What a panic leaves half-changed is thrown away; solved cases are added whole.
        let mut result = match catch_unwind(AssertUnwindSafe(|| self.attempt(parameters))) {
            Ok(result) => result?,
            Err(payload) => {
                self.workspace = None;
                SolvedCase::failed(FailureKind::Panic { message: panic_message(payload.as_ref()) })
            }
        };
        result.effort.seconds = start.elapsed().as_secs_f64();
        Ok(result)
    }

    fn attempt(&mut self, parameters: &Parameters) -> Result<SolvedCase, Interrupted> {
        let Self { solver, workspace, solved, output, interrupt, time_limit, traced, .. } = self;
        let prepare = || solver.prepare(parameters, output);
        let prepared = parameters
            .computable()
            .map_err(Failure::from)
            .and_then(|()| workspace.get_or_insert_with(prepare).as_mut().map_err(|why| why.clone()));
        let workspace = match prepared {
            Ok(workspace) => workspace,
            Err(failure) => return Ok(SolvedCase::failed(failure)),
        };
        let mut context = SolveContext::new(interrupt);
        if let Some(limit) = *time_limit {
            context = context.with_time_limit(limit);
        }
        if *traced {
            context = context.traced();
        }
        let control = solver.step_control();
        SeedSearch { solver: *solver, workspace, control, solved, output, time_limit: *time_limit }
            .try_seeds(parameters, context)
    }

    /// The last case that was solved, in the solver's own unknowns, and the workspace; `None` before the first.
    pub fn last(&mut self) -> Option<(&mut S::Workspace, &Parameters, &S::State)> {
        let (parameters, state) = self.solved.last()?;
        let workspace = self.workspace.as_mut()?.as_mut().ok()?;
        Some((workspace, parameters, state))
    }
}

impl<S: CaseSolver> Drop for Chain<'_, S> {
    fn drop(&mut self) {
        if let Some(Ok(workspace)) = self.workspace.take() {
            self.solver.keep(workspace);
        }
    }
}

/// The text that was given to `panic!`, in one line: its words without line feeds and other control characters.
pub fn panic_message(payload: &(dyn Any + Send)) -> String {
    let text = if let Some(text) = payload.downcast_ref::<&'static str>() {
        text
    } else if let Some(text) = payload.downcast_ref::<String>() {
        text
    } else {
        "a panic without a message"
    };
    let words = text.split(|c: char| c.is_control() || c.is_whitespace()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join(" ")
}

/// A way to get the first guess of a case.
enum SeedStrategy {
    /// The extrapolation of the last two solutions.
    Predictor,
    /// The last solution, and a walk from there.
    Neighbour,
    /// The solver's own start at a case, and a walk from there.
    Origin(Parameters),
}

/// The solution of a case from one seed after the other.
struct SeedSearch<'c, 'a, S: CaseSolver> {
    solver: &'a S,
    workspace: &'c mut S::Workspace,
    control: StepControl,
    solved: &'c mut Solved<S>,
    output: &'a Output,
    time_limit: Option<Duration>,
}

impl<S: CaseSolver> SeedSearch<'_, '_, S> {
    /// Tries the seeds in their order until one leads to a solution.
    fn try_seeds(mut self, parameters: &Parameters, mut context: SolveContext) -> Result<SolvedCase, Interrupted> {
        let solver = self.solver;
        let (mut path, mut seed) = (Path::default(), Seed::None);
        let mut attempts: Vec<Failure> = Vec::new();
        let predictor = (self.solved.len() == 2).then_some(SeedStrategy::Predictor);
        let neighbour = (!self.solved.is_empty()).then_some(SeedStrategy::Neighbour);
        let far = self.solved.last().is_some_and(|(last, _)| solver.is_far(last, parameters));
        let mut origins = iter::once_with(|| solver.origins(parameters)).flatten().map(SeedStrategy::Origin);
        let first = if far { origins.next() } else { None };
        for strategy in first.into_iter().chain(predictor).chain(neighbour).chain(origins) {
            match self.try_seed(strategy, parameters, &mut seed, &mut path, &mut context) {
                Ok((state, solution)) => {
                    push(self.solved, parameters.clone(), state);
                    if path.points.len() == 1 {
                        path = Path::default();
                    }
                    return Ok(solved_case(Ok(solution), seed, path, context));
                }
                Err(SolveError::Failed(failure)) => {
                    let conclusive = failure.kind.is_conclusive();
                    attempts.push(failure.seeded_by(seed));
                    if conclusive {
                        break;
                    }
                }
                Err(SolveError::Interrupted) => return Err(Interrupted),
                Err(SolveError::OutOfTime) => {
                    attempts = vec![FailureKind::TimeLimit(self.time_limit.unwrap_or_default()).into()];
                    break;
                }
            }
        }
        let last = attempts.pop().expect("a solver has origins");
        Ok(solved_case(Err(last.after(attempts)), seed, path, context))
    }

    /// Solves and evaluates a case from one seed. `seed` tells how far this went.
    fn try_seed(
        &mut self,
        strategy: SeedStrategy,
        case: &Parameters,
        seed: &mut Seed,
        path: &mut Path,
        context: &mut SolveContext,
    ) -> Result<(S::State, Solution), SolveError> {
        let mut corrector = Corrector { solver: self.solver, workspace: self.workspace, context, path, seed };
        let mut state = corrector.converge(strategy, self.solved, &self.control, case)?;
        context.note_evaluation();
        let solution = self.solver.evaluate(self.workspace, case, &mut state, self.output, context);
        context.note_end(solution.as_ref().map(drop));
        Ok((state, solution?))
    }
}

fn solved_case(outcome: Result<Solution, Failure>, seed: Seed, path: Path, mut context: SolveContext) -> SolvedCase {
    let (trace, effort) = (context.take_trace(), context.effort);
    SolvedCase { outcome, limits: Limits::UNKNOWN, seed, path, trace, effort }
}

impl<S: CaseSolver> Corrector<'_, '_, S> {
    /// The converged state of a case from one seed.
    fn converge(
        &mut self,
        strategy: SeedStrategy,
        solved: &[(Parameters, S::State)],
        control: &StepControl,
        case: &Parameters,
    ) -> Result<S::State, SolveError> {
        match strategy {
            SeedStrategy::Predictor => {
                *self.seed = Seed::Predictor;
                let guess = self.predict(solved, case);
                Ok(self.solve(case, guess)?.0)
            }
            SeedStrategy::Neighbour => {
                let nearest = &solved[solved.len() - 1..];
                let way = distance(&nearest[0].0, case);
                let mut points = 0;
                let reached = self.walk(Cow::Borrowed(nearest), case, way, control, &mut points);
                *self.seed = if points == 0 { Seed::Neighbour } else { Seed::Intermediate(points) };
                reached
            }
            SeedStrategy::Origin(origin) if origin == *case => {
                *self.seed = Seed::None;
                let (guess, from) = self.solver.start(self.workspace, case, self.context)?;
                *self.seed = from;
                Ok(self.solve(case, guess)?.0)
            }
            SeedStrategy::Origin(origin) => {
                *self.seed = Seed::March(0);
                let state = self.begin(&origin, case)?;
                let mut points = 1;
                let solved = Cow::Owned(vec![(origin, state)]);
                let reached = self.walk(solved, case, control.first, control, &mut points);
                *self.seed = Seed::March(points);
                reached
            }
        }
    }
}
