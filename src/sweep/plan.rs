//! From a sweep to rows, chains and case ids.

use std::ops::Range;

use super::fingerprint::{Fingerprint, canonical};
use super::recipe::Recipe;
use super::specification::{Axes, Sweep};
use crate::model::{CaseId, Parameters, Substrate};

/// Most cases in one chain, whatever the method.
pub const MAX_CHAIN: usize = 64;

/// Neighbouring cases of one row, solved in ascending β, each seeding the next: the unit of work.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Chain {
    /// The row, below [`Plan::rows`].
    pub row: usize,
    /// Places on the β axis.
    pub beta: Range<usize>,
}

/// What there is to solve for a sweep, and in what pieces.
///
/// A *row* is one (f, α) with all its β. All grid points whose substrate is relaxed elastic (f = 0 or α = ∞) share
/// row 0, which is solved once; the other rows follow in the order f, then α. A row is cut into as few *chains* as the
/// method's [`chain_limit`](super::Method::chain_limit) lets, with lengths that differ by at most one; short chains
/// mean that an interruption loses little. Everything is index arithmetic: a plan is as large as its axes.
///
/// Grid points are published in the order f, then α, then β.
#[derive(Clone, Debug)]
pub struct Plan {
    axes: Axes,
    substrate: Substrate,
    recipe: Recipe,
    fingerprint: Fingerprint,
    chains_per_row: usize,
}

impl Plan {
    /// The plan of a sweep.
    pub fn new(sweep: &Sweep) -> Self {
        let limit = sweep.solver.method.chain_limit().min(MAX_CHAIN);
        let recipe = Recipe::new(&sweep.solver, sweep.output.cavity_shear);
        Self {
            axes: sweep.axes.clone(),
            substrate: sweep.substrate.clone(),
            recipe,
            fingerprint: Fingerprint::new(&recipe),
            chains_per_row: sweep.axes.beta.len().div_ceil(limit),
        }
    }

    /// What its cases are solved with.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// Number of grid points: rows of the summary.
    pub fn cases(&self) -> usize {
        self.axes.cases()
    }

    /// Number of distinct problems: what is solved.
    pub fn problems(&self) -> usize {
        self.rows() * self.axes.beta.len()
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        let retarding_f = self.axes.f.len() - self.elastic_f();
        self.elastic_rows() + retarding_f * self.retarding_alpha()
    }

    /// The first grid place (i_f, i_alpha) of a row in the order of publication.
    ///
    /// # Panics
    /// If there is no such row.
    pub fn place_of_row(&self, row: usize) -> (usize, usize) {
        assert!(row < self.rows(), "row {row} is not in the sweep");
        match row.checked_sub(self.elastic_rows()) {
            Some(row) => (self.elastic_f() + row / self.retarding_alpha(), row % self.retarding_alpha()),
            None if self.elastic_f() > 0 => (0, 0),
            None => (0, self.retarding_alpha()),
        }
    }

    /// Number of chains.
    pub fn chain_count(&self) -> usize {
        self.rows() * self.chains_per_row
    }

    /// The chain at a place in [`Plan::chains`].
    ///
    /// # Panics
    /// If `index` is not below [`Plan::chain_count`].
    pub fn chain(&self, index: usize) -> Chain {
        assert!(index < self.chain_count(), "chain {index} is not in the sweep");
        let (row, piece) = (index / self.chains_per_row, index % self.chains_per_row);
        let cut = |piece: usize| piece * self.axes.beta.len() / self.chains_per_row;
        Chain { row, beta: cut(piece)..cut(piece + 1) }
    }

    /// All chains, row by row in ascending β. They are made as they are asked for: a billion cases have too many to list.
    pub fn chains(&self) -> impl ExactSizeIterator<Item = Chain> + DoubleEndedIterator + Clone + '_ {
        (0..self.chain_count()).map(|index| self.chain(index))
    }

    /// The cases of a chain, in the order in which they are solved.
    pub fn parameters(&self, chain: &Chain) -> Vec<Parameters> {
        let (i_f, i_alpha) = self.place_of_row(chain.row);
        chain.beta.clone().map(|i_beta| self.parameters_at(i_f, i_alpha, i_beta)).collect()
    }

    /// The first case of a chain.
    pub(super) fn first_case(&self, chain: &Chain) -> Parameters {
        let (i_f, i_alpha) = self.place_of_row(chain.row);
        self.parameters_at(i_f, i_alpha, chain.beta.start)
    }

    /// Their ids, in the same order.
    pub fn ids(&self, chain: &Chain) -> Vec<CaseId> {
        self.parameters(chain).iter().map(|parameters| self.id(parameters)).collect()
    }

    /// The id of a case solved with the settings of this sweep.
    pub fn id(&self, parameters: &Parameters) -> CaseId {
        self.fingerprint.id(parameters)
    }

    /// The problem at a grid point. Grid points with the same problem give equal parameters: elastic ones are
    /// [`Parameters::elastic`] or, at α = 0, have the default substrate, as their modes mean nothing.
    ///
    /// # Panics
    /// If a place is not on its axis.
    pub fn parameters_at(&self, i_f: usize, i_alpha: usize, i_beta: usize) -> Parameters {
        let (f, alpha, beta) = (self.axes.f[i_f], self.axes.alpha[i_alpha], self.axes.beta[i_beta]);
        canonical(&Parameters { alpha, beta, f, substrate: self.substrate.clone() })
    }

    /// The id of the case at a grid point.
    ///
    /// # Panics
    /// If a place is not on its axis.
    pub fn case_at(&self, i_f: usize, i_alpha: usize, i_beta: usize) -> CaseId {
        self.id(&self.parameters_at(i_f, i_alpha, i_beta))
    }

    /// The first grid place (i_f, i_alpha, i_beta) of a case in the order of publication, if it is in the sweep. Goes
    /// through the problems one by one.
    pub fn find(&self, id: CaseId) -> Option<(usize, usize, usize)> {
        let places = (0..self.rows()).flat_map(|row| {
            let (i_f, i_alpha) = self.place_of_row(row);
            (0..self.axes.beta.len()).map(move |i_beta| (i_f, i_alpha, i_beta))
        });
        places.into_iter().find(|&(i_f, i_alpha, i_beta)| self.case_at(i_f, i_alpha, i_beta) == id)
    }

    /// Values of f without retardation: f = 0, which an ascending axis can only have first.
    fn elastic_f(&self) -> usize {
        usize::from(self.axes.f.first() == Some(&0.0))
    }

    /// Values of α with retardation: all but α = ∞, which an ascending axis can only have last.
    fn retarding_alpha(&self) -> usize {
        self.axes.alpha.len() - usize::from(self.axes.alpha.last() == Some(&f64::INFINITY))
    }

    /// 1 if the sweep has relaxed elastic cases, else 0.
    fn elastic_rows(&self) -> usize {
        usize::from(self.elastic_f() > 0 || self.retarding_alpha() < self.axes.alpha.len())
    }
}
