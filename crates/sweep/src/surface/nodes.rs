//! Solving the cases of a surface, and storing them: ordinary cases in an ordinary results directory.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::build::SurfaceBuildError;
use crate::campaign::case_entry;
use crate::engine::{Engine, Finished};
use crate::store::{CaseEntry, Ending, Status, Store};
use crate::{CaseId, Plan, SurfaceSweep, Values};
use stribeck_solver::continuation::{FailureKind, SolvedCase};
use stribeck_solver::{Interrupt, Parameters, Solver, point_chains};

/// The cases of a surface: those that are solved, and the means to solve more.
pub struct Nodes<'a> {
    surface: &'a SurfaceSweep,
    plan: Plan,
    engine: Engine,
    store: Option<Store>,
    interrupt: Arc<Interrupt>,
    threads: u64,
    /// All that is stored.
    stored: HashMap<CaseId, Result<Values, String>>,
    /// What was asked for so far. The chains of later cases depend on it, and on nothing that happened by chance.
    asked: HashSet<CaseId>,
    solved: u64,
}

impl<'a> Nodes<'a> {
    /// The cases of a surface, with what a store has of them. Without a store they are kept in memory.
    ///
    /// # Errors
    /// [`SurfaceBuildError::Store`] if what is stored cannot be read.
    pub fn new(
        surface: &'a SurfaceSweep,
        plan: Plan,
        engine: Engine,
        store: Option<Store>,
        interrupt: Arc<Interrupt>,
        threads: u64,
    ) -> Result<Self, SurfaceBuildError> {
        let mut stored = HashMap::new();
        if let Some(store) = &store {
            store.visit(|id, status, reason, values| {
                let outcome = if status == Status::Converged { Ok(values) } else { Err(reason.to_owned()) };
                stored.insert(id, outcome);
            })?;
        }
        Ok(Self { surface, plan, engine, store, interrupt, threads, stored, asked: HashSet::new(), solved: 0 })
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
            store.begin(&self.surface.sweep.name, cases as u64, self.threads)?;
        }
        let store = &mut self.store;
        let report = self.engine.run(
            chains,
            &self.interrupt,
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
