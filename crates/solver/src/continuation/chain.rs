//! Solving a chain: each case seeded by the ones before it, with a ladder of other seeds should one fail.

use std::any::Any;
use std::borrow::Cow;
use std::iter;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use super::walk::{Corrector, push};
use super::{
    CaseSolver, Cut, Halt, Interrupt, Interrupted, Path, Seed, Solution, SolvedCase, StepControl, Work, distance,
};
use crate::exact::ChainLimits;
use crate::model::{Failure, Limits, Output, Parameters, shortest};

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
    time_limit: Option<Duration>,
    traced: bool,
}

/// The last solved cases, at most two, the nearest last.
type Solved<S> = Vec<(Parameters, <S as CaseSolver>::State)>;

impl<'a, S: CaseSolver> Chain<'a, S> {
    /// A chain without any case yet.
    pub fn new(solver: &'a S, output: &'a Output, interrupt: &'a Interrupt) -> Self {
        let (limits, solved) = (ChainLimits::default(), Vec::with_capacity(2));
        Self { solver, workspace: None, limits, solved, output, interrupt, time_limit: None, traced: false }
    }

    /// The chain with a limit to the time that each of its cases may take.
    #[must_use]
    pub fn within(self, time_limit: Duration) -> Self {
        Self { time_limit: Some(time_limit), ..self }
    }

    /// From now on the way to each case is recorded, or no longer.
    pub fn traced(&mut self, traced: bool) {
        self.traced = traced;
    }

    /// Solves the next case. The first one pays for what the chain shares. A case that takes longer than it may fails, and so
    /// does one whose solver panics: the next one has a workspace of its own then.
    ///
    /// # Errors
    /// [`Interrupted`] if the user asks to stop before it is done.
    pub fn solve(&mut self, parameters: &Parameters) -> Result<SolvedCase, Interrupted> {
        let start = Instant::now();
        let limits = self.limits(parameters);
        // What a panic leaves half-changed is thrown away; solved cases are added whole.
        let mut result = match catch_unwind(AssertUnwindSafe(|| self.attempt(parameters, limits))) {
            Ok(result) => result?,
            Err(payload) => {
                self.workspace = None;
                let reason = format!("the solver panicked: {}", panic_message(payload.as_ref()));
                let failed = SolvedCase::failed(Failure::new(reason), limits);
                SolvedCase { cut: Some(Cut::Panic), ..failed }
            }
        };
        result.effort.seconds = start.elapsed().as_secs_f64();
        Ok(result)
    }

    /// The limits beside the solution of a case, if they are wanted; not known if their computation panics.
    fn limits(&mut self, parameters: &Parameters) -> Limits {
        if !self.output.limits || parameters.computable().is_err() {
            return Limits::UNKNOWN;
        }
        let limits = &mut self.limits;
        catch_unwind(AssertUnwindSafe(|| limits.of(parameters))).unwrap_or_else(|_| {
            self.limits = ChainLimits::default();
            Limits::UNKNOWN
        })
    }

    fn attempt(&mut self, parameters: &Parameters, limits: Limits) -> Result<SolvedCase, Interrupted> {
        let Self { solver, workspace, solved, output, interrupt, time_limit, traced, .. } = self;
        let prepare = || solver.prepare(parameters, output);
        let prepared = parameters
            .computable()
            .and_then(|()| workspace.get_or_insert_with(prepare).as_mut().map_err(|why| why.clone()));
        let workspace = match prepared {
            Ok(workspace) => workspace,
            Err(failure) => return Ok(SolvedCase::failed(failure, limits)),
        };
        let mut work = Work::new(interrupt);
        if let Some(limit) = *time_limit {
            work = work.within(limit);
        }
        if *traced {
            work = work.traced();
        }
        let control = solver.step_control();
        Ladder { solver: *solver, workspace, control, solved, output, time_limit: *time_limit }
            .climb(parameters, limits, work)
    }

    /// The last case that was solved, in the solver's own unknowns, and the workspace; `None` before the first.
    pub fn last(&mut self) -> Option<(&mut S::Workspace, &Parameters, &S::State)> {
        let (parameters, state) = self.solved.last()?;
        let workspace = self.workspace.as_mut()?.as_mut().ok()?;
        Some((workspace, parameters, state))
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

/// The seeds of one case, tried one after the other.
struct Ladder<'c, 'a, S: CaseSolver> {
    solver: &'a S,
    workspace: &'c mut S::Workspace,
    control: StepControl,
    solved: &'c mut Solved<S>,
    output: &'a Output,
    time_limit: Option<Duration>,
}

/// A place on the ladder of seeds.
enum Rung {
    Predictor,
    Neighbour,
    Origin(Parameters),
}

impl<S: CaseSolver> Ladder<'_, '_, S> {
    /// Tries one rung after the other.
    fn climb(mut self, parameters: &Parameters, limits: Limits, mut work: Work) -> Result<SolvedCase, Interrupted> {
        let solver = self.solver;
        let mut path = Path::default();
        let (mut seed, mut cut) = (Seed::None, None);
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
                    let (trace, effort) = (work.take_trace(), work.effort);
                    return Ok(SolvedCase { outcome: Ok(solution), limits, seed, cut: None, path, trace, effort });
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
                Err(Halt::OutOfTime) => {
                    let limit = self.time_limit.unwrap_or_default();
                    reasons = vec![format!(
                        "not solved within {} s, the time limit of a case; raise `time_limit` in [solver] to try it again",
                        shortest(limit.as_secs_f64())
                    )];
                    cut = Some(Cut::TimeLimit(limit));
                    break;
                }
            }
        }
        let failure = Failure::new(reasons.join("; "));
        let (trace, effort) = (work.take_trace(), work.effort);
        Ok(SolvedCase { outcome: Err(failure), limits, seed, cut, path, trace, effort })
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
        work.note_evaluation();
        let solution = self.solver.evaluate(self.workspace, case, &mut state, output, work);
        work.note_end(solution.as_ref().map(drop));
        Ok((state, solution?))
    }
}
