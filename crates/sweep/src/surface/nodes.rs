//! Solving the cases of a surface, and storing them: ordinary cases in an ordinary results directory.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use super::build::{Progress, SurfaceBuildError, SurfaceOptions};
use crate::campaign::{Event, case_entry, check_available, open_store};
use crate::engine::{Engine, Finished};
use crate::store::{CaseEntry, Ending, Status, Store};
use crate::{CaseId, Plan, SurfaceSweep, Values};
use stribeck_solver::continuation::{FailureKind, SolvedCase};
use stribeck_solver::{Parameters, Solver, point_chains};

/// Finished chains that may wait to be written, for each thread.
const WAITING_CHAINS: usize = 8;

/// The cases of a surface: those that are solved, and the means to solve more.
pub struct Nodes<'a> {
    surface: &'a SurfaceSweep,
    options: SurfaceOptions,
    plan: Plan,
    engine: Engine,
    store: Option<Store>,
    /// All that is stored.
    stored: HashMap<CaseId, Result<Values, String>>,
    /// What was asked for so far. The chains of later cases depend on it, and on nothing that happened by chance.
    asked: HashSet<CaseId>,
    solved: u64,
}

impl<'a> Nodes<'a> {
    /// The cases of a surface, with what a results directory has of them. Without one they are kept in memory.
    ///
    /// # Errors
    /// [`SurfaceBuildError`] if the directory cannot be used or read, or the system gives too few threads.
    pub fn new(
        surface: &'a SurfaceSweep,
        directory: Option<&Path>,
        options: &SurfaceOptions,
        tell: &mut dyn FnMut(Progress),
    ) -> Result<Self, SurfaceBuildError> {
        let engine = Engine::new(options.threads)?.with_queue(WAITING_CHAINS * options.threads.get());
        let (plan, mut stored) = (Plan::new(&surface.sweep), HashMap::new());
        let store = match directory {
            None => None,
            Some(directory) => {
                check_available(directory)?;
                let store = open_store(directory, &surface.sweep, &plan, &mut |event| {
                    if let Event::Damaged(warning) = event {
                        tell(Progress::Damaged { what: warning.to_string() });
                    }
                })?;
                store.visit(|id, status, reason, values| {
                    stored.insert(id, if status == Status::Converged { Ok(values) } else { Err(reason.to_owned()) });
                })?;
                Some(store)
            }
        };
        let (options, asked) = (options.clone(), HashSet::new());
        Ok(Self { surface, options, plan, engine, store, stored, asked, solved: 0 })
    }

    /// The number of different cases that were asked for.
    pub fn count(&self) -> usize {
        self.asked.len()
    }

    /// The number of cases that were solved and not stored before.
    pub fn solved(&self) -> u64 {
        self.solved
    }

    /// The numbers of cases, in their order. What is not stored is solved, in chains that depend on the cases alone, and
    /// stored: a chain is stored as a whole.
    ///
    /// # Errors
    /// [`SurfaceBuildError`] if a case fails, the disk fails, or someone asks to stop.
    pub fn solve(&mut self, cases: &[Parameters]) -> Result<Vec<Values>, SurfaceBuildError> {
        let ids: Vec<CaseId> = cases.iter().map(|case| self.plan.id(case)).collect();
        let new: Vec<usize> = (0..cases.len()).filter(|&place| self.asked.insert(ids[place])).collect();
        let points: Vec<Parameters> = new.iter().map(|&place| cases[place].clone()).collect();
        let settings = self.surface.sweep.solver_settings();
        let mut chains = point_chains(&points, &settings);
        chains.retain(|chain| chain.iter().any(|&point| !self.stored.contains_key(&ids[new[point]])));
        if !chains.is_empty() {
            self.solve_chains(&points, &chains, &Solver::new(&settings))?;
        }
        let outcome = |(place, id): (usize, &CaseId)| match &self.stored[id] {
            Ok(values) => Ok(*values),
            Err(reason) => {
                Err(SurfaceBuildError::Failed { case: Box::new(cases[place].clone()), reason: reason.clone() })
            }
        };
        ids.iter().enumerate().map(outcome).collect()
    }

    fn solve_chains(
        &mut self,
        points: &[Parameters],
        chains: &[Vec<usize>],
        solver: &Solver,
    ) -> Result<(), SurfaceBuildError> {
        let (plan, stored, solved) = (&self.plan, &mut self.stored, &mut self.solved);
        let chain_of = |chain: &Vec<usize>| chain.iter().map(|&point| points[point].clone()).collect::<Vec<_>>();
        let cases: usize = chains.iter().map(Vec::len).sum();
        if let Some(store) = &mut self.store {
            store.begin(&self.surface.sweep.name, cases as u64, self.options.threads.get() as u64)?;
        }
        let store = &mut self.store;
        let report = self.engine.run(
            chains,
            &self.options.interrupt,
            |chain, interrupt| solver.solve_chain(&chain_of(chain), interrupt),
            |chain, message| {
                let panic = || SolvedCase::failed(FailureKind::ChainPanic { message: message.to_owned() });
                chain.iter().map(|_| panic()).collect()
            },
            |group| -> Result<(), SurfaceBuildError> {
                let mut entries: Vec<CaseEntry> = Vec::new();
                for Finished { chain, cases, .. } in group {
                    let parameters = chain_of(chain);
                    let made = parameters.iter().zip(cases).map(|(case, solved)| case_entry(plan, case, solved));
                    entries.extend(made.filter(|entry| !stored.contains_key(&entry.id)));
                }
                if let Some(store) = store {
                    store.commit(&entries)?;
                }
                *solved += entries.len() as u64;
                for entry in entries {
                    let outcome = if entry.outcome == Status::Converged { Ok(entry.values) } else { Err(entry.reason) };
                    stored.insert(entry.id, outcome);
                }
                Ok(())
            },
        )?;
        if let Some(store) = &mut self.store {
            store.end(if report.interrupted { Ending::Interrupted } else { Ending::Completed })?;
        }
        if report.interrupted { Err(SurfaceBuildError::Interrupted) } else { Ok(()) }
    }
}
