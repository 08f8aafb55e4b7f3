//! From a sweep to rows, chains and case ids.

use super::chain::{Chain, MAX_CHAIN};
use super::fingerprint::{Fingerprint, canonical};
use super::listing::Listing;
use super::recipe::Recipe;
use crate::{Axes, CaseId, Grid, Method, Sweep};
use stribeck_solver::{Parameters, Substrate};

/// What there is to solve for a sweep, and in what pieces.
///
/// A *row* is all cases along β, or along the speed, with the same other numbers. A row is cut into as few *chains* as the
/// method's [`chain_limit`](crate::Method::chain_limit) lets, with lengths that differ by at most one; short chains
/// mean that an interruption loses little.
///
/// In a dimensionless sweep all grid points whose substrate is relaxed elastic (f = 0 or α = ∞) share row 0, which is solved
/// once; the other rows follow in the order f, then α. Everything is index arithmetic: such a plan is as large as its axes.
/// Over quantities of the laboratory different places can have the same α, β and f: each problem is solved at the first place
/// that has it, and rows are listed.
///
/// Grid points are published in the order f, then α, then β, or f, then the quantities in their order, the speed last.
#[derive(Clone, Debug)]
pub struct Plan {
    grid: Grid,
    substrate: Substrate,
    recipe: Recipe,
    fingerprint: Fingerprint,
    layout: Layout,
}

/// How the cases of a plan are numbered.
#[derive(Clone, Debug)]
enum Layout {
    /// By arithmetic.
    Product { axes: Axes, chains_per_row: usize },
    /// By lists of rows and chains.
    Listed(Listing),
}

impl Plan {
    /// The plan of a sweep.
    pub fn new(sweep: &Sweep) -> Self {
        let limit = sweep.solver.method.chain_limit().min(MAX_CHAIN);
        let recipe = Recipe::new(&sweep.solver, sweep.output.cavity_shear);
        let fingerprint = Fingerprint::new(&recipe);
        let layout = match &sweep.grid {
            Grid::Dimensionless(axes) => {
                Layout::Product { axes: axes.clone(), chains_per_row: axes.beta.len().div_ceil(limit) }
            }
            Grid::Laboratory(_) => {
                // What chains of the relaxation method share belongs to one α.
                let limit = |f: f64| if f > 0.0 && sweep.solver.method == Method::Relaxation { 1 } else { limit };
                let id = |place| fingerprint.id(&canonical(&sweep.grid.parameters(place, &sweep.substrate)));
                Layout::Listed(Listing::new(sweep.grid.shape(), id, |i_f| limit(sweep.grid.numbers([i_f, 0, 0])[0])))
            }
        };
        Self { grid: sweep.grid.clone(), substrate: sweep.substrate.clone(), recipe, fingerprint, layout }
    }

    /// What its cases are solved with.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// Number of grid points: rows of the summary.
    pub fn cases(&self) -> usize {
        self.grid.cases()
    }

    /// Number of distinct problems: what is solved.
    pub fn problems(&self) -> usize {
        match &self.layout {
            Layout::Product { axes, .. } => rows(axes) * axes.beta.len(),
            Layout::Listed(listing) => listing.problems(),
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        match &self.layout {
            Layout::Product { axes, .. } => rows(axes),
            Layout::Listed(listing) => listing.rows(),
        }
    }

    /// The first grid place (i_f, i_alpha) of a row in the order of publication.
    ///
    /// # Panics
    /// If there is no such row.
    pub fn place_of_row(&self, row: usize) -> (usize, usize) {
        assert!(row < self.rows(), "row {row} is not in the sweep");
        let axes = match &self.layout {
            Layout::Product { axes, .. } => axes,
            Layout::Listed(listing) => return listing.place_of_row(row),
        };
        match row.checked_sub(elastic_rows(axes)) {
            Some(row) => (elastic_f(axes) + row / retarding_alpha(axes), row % retarding_alpha(axes)),
            None if elastic_f(axes) > 0 => (0, 0),
            None => (0, retarding_alpha(axes)),
        }
    }

    /// Number of chains.
    pub fn chain_count(&self) -> usize {
        match &self.layout {
            Layout::Product { axes, chains_per_row } => rows(axes) * chains_per_row,
            Layout::Listed(listing) => listing.chains().len(),
        }
    }

    /// The chain at a place in [`Plan::chains`].
    ///
    /// # Panics
    /// If `index` is not below [`Plan::chain_count`].
    pub fn chain(&self, index: usize) -> Chain {
        assert!(index < self.chain_count(), "chain {index} is not in the sweep");
        match &self.layout {
            Layout::Product { axes, chains_per_row } => {
                let (row, piece) = (index / chains_per_row, index % chains_per_row);
                let cut = |piece: usize| piece * axes.beta.len() / chains_per_row;
                Chain { row, cases: cut(piece)..cut(piece + 1) }
            }
            Layout::Listed(listing) => listing.chains()[index].clone(),
        }
    }

    /// All chains, row by row in ascending β. They are made as they are asked for: a billion cases have too many to list.
    pub fn chains(&self) -> impl ExactSizeIterator<Item = Chain> + DoubleEndedIterator + Clone + '_ {
        (0..self.chain_count()).map(|index| self.chain(index))
    }

    /// The grid places of the cases of a chain, in the order in which they are solved.
    pub fn places(&self, chain: &Chain) -> impl Iterator<Item = [usize; 3]> + '_ {
        let (row, (i_f, i_row)) = (chain.row, self.place_of_row(chain.row));
        chain.cases.clone().map(move |case| [i_f, i_row, self.along(row, case)])
    }

    /// Where the case of a row is along it.
    fn along(&self, row: usize, case: usize) -> usize {
        match &self.layout {
            Layout::Product { .. } => case,
            Layout::Listed(listing) => listing.along(row, case),
        }
    }

    /// The cases of a chain, in the order in which they are solved.
    pub fn parameters(&self, chain: &Chain) -> Vec<Parameters> {
        self.places(chain).map(|[i_f, i_alpha, i_beta]| self.parameters_at(i_f, i_alpha, i_beta)).collect()
    }

    /// The first case of a chain.
    pub(super) fn first_case(&self, chain: &Chain) -> Parameters {
        let (i_f, i_alpha) = self.place_of_row(chain.row);
        self.parameters_at(i_f, i_alpha, self.along(chain.row, chain.cases.start))
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
        canonical(&self.grid.parameters([i_f, i_alpha, i_beta], &self.substrate))
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
        let places = self.chains().flat_map(|chain| self.places(&chain).collect::<Vec<_>>());
        let found = places.into_iter().find(|&[i_f, i_alpha, i_beta]| self.case_at(i_f, i_alpha, i_beta) == id);
        found.map(|[i_f, i_alpha, i_beta]| (i_f, i_alpha, i_beta))
    }
}

/// Values of f without retardation: f = 0, which an ascending axis can only have first.
fn elastic_f(axes: &Axes) -> usize {
    usize::from(axes.f.first() == Some(&0.0))
}

/// Values of α with retardation: all but α = ∞, which an ascending axis can only have last.
fn retarding_alpha(axes: &Axes) -> usize {
    axes.alpha.len() - usize::from(axes.alpha.last() == Some(&f64::INFINITY))
}

/// 1 if the sweep has relaxed elastic cases, else 0.
fn elastic_rows(axes: &Axes) -> usize {
    usize::from(elastic_f(axes) > 0 || retarding_alpha(axes) < axes.alpha.len())
}

/// Number of rows.
fn rows(axes: &Axes) -> usize {
    elastic_rows(axes) + (axes.f.len() - elastic_f(axes)) * retarding_alpha(axes)
}
