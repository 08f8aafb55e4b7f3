//! Solving a chain: each case seeded by the ones before it, with a ladder of other seeds should one fail.

use std::time::Instant;

use super::{CaseSolver, Effort, Halt, Interrupt, Interrupted, Seed, Solution, SolvedCase, Work};

use crate::exact;
use crate::model::{Failure, Limits, Output, Parameters};

/// Numbers of unpublished points that are put between a case and its neighbour when longer steps fail.
const INTERMEDIATE_POINTS: [usize; 2] = [1, 3];

/// Decades of β below a case from which it is reached by way of thicker films when its own start fails.
const MARCH_DECADES: [i32; 2] = [1, 2];

/// Points between the two ends of such a way, four steps a decade.
fn march_points(decades: i32) -> usize {
    4 * decades as usize - 1
}

/// Solves the cases of a chain in their order. A case that fails is reported as such and does not stop the others.
///
/// Seeds are tried in this order: the predictor from the last two solved cases, the last one as it is, the same with
/// one and with three points in between, the solver's own start, and the same one and two decades of β below, where films
/// are thick, with four steps a decade from there. The first case has the last three alone. So every number is a function
/// of the chain, and of nothing that happens elsewhere. A conclusive failure ends the search.
///
/// # Errors
/// [`Interrupted`] if the user asks to stop before the last case is done; what was solved of the chain is dropped.
pub fn solve_chain<S: CaseSolver>(
    solver: &S,
    cases: &[Parameters],
    output: &Output,
    interrupt: &Interrupt,
) -> Result<Vec<SolvedCase>, Interrupted> {
    let Some(first) = cases.first() else { return Ok(Vec::new()) };
    let start = Instant::now();
    let shared = solver.prepare(first, output);
    let mut preparation = start.elapsed().as_secs_f64();
    let mut solved = Vec::with_capacity(2);
    let mut results = Vec::with_capacity(cases.len());
    for parameters in cases {
        let start = Instant::now();
        let limits = if output.limits { exact::limits(parameters) } else { Limits::UNKNOWN };
        let mut result = match &shared {
            Err(failure) => {
                SolvedCase { outcome: Err(failure.clone()), limits, seed: Seed::Elastic, effort: Effort::default() }
            }
            Ok(shared) => {
                let ladder = Ladder { solver, shared, solved: &mut solved, output, interrupt };
                ladder.solve(parameters, limits)?
            }
        };
        // the first case pays for what the chain shares
        result.effort.seconds = start.elapsed().as_secs_f64() + std::mem::take(&mut preparation);
        results.push(result);
    }
    Ok(results)
}

/// The seeds of one case, and what they need.
struct Ladder<'a, S: CaseSolver> {
    solver: &'a S,
    shared: &'a S::Shared,
    /// The last solved cases of the chain, at most two, each with its β.
    solved: &'a mut Vec<(f64, S::State)>,
    output: &'a Output,
    interrupt: &'a Interrupt,
}

impl<S: CaseSolver> Ladder<'_, S> {
    /// Tries one rung after the other.
    fn solve(self, parameters: &Parameters, limits: Limits) -> Result<SolvedCase, Interrupted> {
        let mut work = Work::new(self.interrupt);
        let mut reasons: Vec<String> = Vec::new();
        let mut seed = Seed::Elastic;
        for rung in self.rungs() {
            seed = rung.seed();
            let attempt = self.guess(&rung, parameters, &mut work).and_then(|(guess, from)| {
                seed = from;
                self.solution(parameters, &guess, &mut work)
            });
            match attempt {
                Ok((state, solution)) => {
                    if self.solved.len() == 2 {
                        self.solved.remove(0);
                    }
                    self.solved.push((parameters.beta, state));
                    return Ok(SolvedCase { outcome: Ok(solution), limits, seed, effort: work.effort });
                }
                Err(Halt::Failed(Failure { reason, conclusive })) => {
                    reasons.push(format!("from {seed}: {reason}"));
                    if conclusive {
                        break;
                    }
                }
                Err(Halt::Interrupted) => return Err(Interrupted),
            }
        }
        let failure = Failure::new(reasons.join("; "));
        Ok(SolvedCase { outcome: Err(failure), limits, seed, effort: work.effort })
    }

    fn rungs(&self) -> Vec<Rung> {
        let mut rungs = Vec::new();
        if self.solved.len() == 2 {
            rungs.push(Rung::Predictor);
        }
        if !self.solved.is_empty() {
            rungs.push(Rung::Neighbour);
            rungs.extend(INTERMEDIATE_POINTS.map(Rung::Intermediate));
        }
        rungs.push(Rung::Start);
        rungs.extend(MARCH_DECADES.map(Rung::March));
        rungs
    }

    /// The first guess of a rung, and where it came from.
    fn guess(&self, rung: &Rung, parameters: &Parameters, work: &mut Work) -> Result<(S::State, Seed), Halt> {
        let guess = match *rung {
            Rung::Predictor => self.solver.predict(self.shared, self.solved, parameters.beta),
            Rung::Neighbour => self.solver.predict(self.shared, self.nearest(), parameters.beta),
            Rung::Intermediate(points) => self.walk(self.nearest().to_vec(), points, parameters, work)?,
            Rung::March(decades) => self.march(decades, parameters, work)?,
            Rung::Start => return self.solver.start(self.shared, parameters, work),
        };
        Ok((guess, rung.seed()))
    }

    /// The solution near a guess, and what is to be known of it.
    fn solution(
        &self,
        parameters: &Parameters,
        guess: &S::State,
        work: &mut Work,
    ) -> Result<(S::State, Solution), Halt> {
        let state = self.solver.solve(self.shared, parameters, guess, work)?;
        let solution = self.solver.evaluate(self.shared, parameters, &state, self.output, work)?;
        Ok((state, solution))
    }

    /// The guess at a case after solving thicker films, from so many decades of β below it.
    fn march(&self, decades: i32, parameters: &Parameters, work: &mut Work) -> Result<S::State, Halt> {
        let first = Parameters { beta: parameters.beta * 0.1_f64.powi(decades), ..parameters.clone() };
        let (guess, _) = self.solver.start(self.shared, &first, work)?;
        let state = self.solver.solve(self.shared, &first, &guess, work)?;
        self.walk(vec![(first.beta, state)], march_points(decades), parameters, work)
    }

    /// The guess at a case after solving `points` cases between it and the one that `path` starts from, evenly spaced in
    /// ln β.
    fn walk(
        &self,
        mut path: Vec<(f64, S::State)>,
        points: usize,
        parameters: &Parameters,
        work: &mut Work,
    ) -> Result<S::State, Halt> {
        let from = path.last().expect("a walk starts somewhere").0;
        for step in 1..=points {
            let part = step as f64 / (points + 1) as f64;
            let beta = from * (parameters.beta / from).powf(part);
            let between = Parameters { beta, ..parameters.clone() };
            let guess = self.solver.predict(self.shared, &path, beta);
            let state = self.solver.solve(self.shared, &between, &guess, work)?;
            if path.len() == 2 {
                path.remove(0);
            }
            path.push((beta, state));
        }
        Ok(self.solver.predict(self.shared, &path, parameters.beta))
    }

    /// The last solved case alone.
    fn nearest(&self) -> &[(f64, S::State)] {
        &self.solved[self.solved.len() - 1..]
    }
}

enum Rung {
    Predictor,
    Neighbour,
    Intermediate(usize),
    Start,
    March(i32),
}

impl Rung {
    /// The seed of a case that climbed so far; the solver's own start may name another.
    fn seed(&self) -> Seed {
        match *self {
            Rung::Predictor => Seed::Predictor,
            Rung::Neighbour => Seed::Neighbour,
            Rung::Intermediate(points) => Seed::Intermediate(points),
            Rung::Start => Seed::Elastic,
            Rung::March(decades) => Seed::March(march_points(decades) + 1),
        }
    }
}
