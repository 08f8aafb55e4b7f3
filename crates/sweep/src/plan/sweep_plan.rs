//! From a sweep to rows, chains and case ids.

use super::chain::{Chain, MAX_CHAIN};
use super::fingerprint::{Fingerprint, canonical};
use super::listing::Listing;
use super::recipe::Recipe;
use crate::{Axes, CaseId, Grid, GridIndex, Method, Sweep};
use stribeck_solver::{Parameters, Substrate};

/// What there is to solve for a sweep, and in what pieces.
///
/// A *row* is all cases along β, or along the speed, with the same other numbers. A row is cut into as few *chains* as
/// the method's [`chain_limit`](crate::Method::chain_limit) lets, with lengths that differ by at most one; short chains
/// mean that an interruption loses little.
///
/// In a dimensionless sweep all grid points whose substrate is relaxed elastic (f = 0 or α = ∞) share row 0, which is
/// solved once; the other rows follow in the order f, then α. Everything is index arithmetic: such a plan is as large
/// as its axes; the slide-to-roll ratio changes no problem. Over quantities of the laboratory different places can have
/// the same α, β and f, and with a viscoelastic roller the ratio does change problems. Each problem is solved at the
/// first place that has it, and rows are listed.
///
/// Grid points are published in the order f, then α, then β, behind the slide-to-roll ratio if it is an axis; or f,
/// then the quantities in their order, the speed last.
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
            Grid::Dimensionless(axes) if sweep.substrate.of_roller() == 0 => {
                Layout::Product { axes: axes.clone(), chains_per_row: axes.beta.len().div_ceil(limit) }
            }
            _ => {
                // What chains of the relaxation method share belongs to one α.
                let is_alone = |case: Parameters| case.f > 0.0 && sweep.solver.method == Method::Relaxation;
                let case = |place| sweep.grid.parameters(place, &sweep.substrate);
                let limit = |first| if is_alone(case(first)) { 1 } else { limit };
                let id = |place| fingerprint.id(&canonical(&case(place)));
                Layout::Listed(Listing::new(sweep.grid.shape(), sweep.grid.axes().is_none(), id, limit))
            }
        };
        Self { grid: sweep.grid.clone(), substrate: sweep.substrate.clone(), recipe, fingerprint, layout }
    }

    /// The recipe that the cases are solved with.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// The number of places, which is the number of rows of the summary.
    pub fn cases(&self) -> usize {
        self.grid.cases()
    }

    /// The number of distinct problems, which is the number of cases that are solved.
    pub fn problems(&self) -> usize {
        match &self.layout {
            Layout::Product { axes, .. } => rows(axes) * axes.beta.len(),
            Layout::Listed(listing) => listing.problems(),
        }
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        match &self.layout {
            Layout::Product { axes, .. } => rows(axes),
            Layout::Listed(listing) => listing.rows(),
        }
    }

    /// The place of a case of a row. Of several places with the same row it is the first in the order of publication.
    ///
    /// # Panics
    /// If there is no such row or case.
    pub fn place(&self, row: usize, case: usize) -> GridIndex {
        assert!(row < self.rows(), "row {row} is not in the sweep");
        let axes = match &self.layout {
            Layout::Product { axes, .. } => axes,
            Layout::Listed(listing) => return listing.place(row, case),
        };
        let (f, row) = match row.checked_sub(elastic_rows(axes)) {
            Some(row) => (elastic_f(axes) + row / retarding_alpha(axes), row % retarding_alpha(axes)),
            None if elastic_f(axes) > 0 => (0, 0),
            None => (0, retarding_alpha(axes)),
        };
        GridIndex { block: f, row, along: case }
    }

    /// The number of chains.
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

    /// All chains, row by row in ascending β. They are made as they are asked for: a billion cases have too many to
    /// list.
    pub fn chains(&self) -> impl ExactSizeIterator<Item = Chain> + DoubleEndedIterator + Clone + '_ {
        (0..self.chain_count()).map(|index| self.chain(index))
    }

    /// The places of the cases of a chain, in the order in which they are solved.
    pub fn places(&self, chain: &Chain) -> impl Iterator<Item = GridIndex> + '_ {
        let row = chain.row;
        chain.cases.clone().map(move |case| self.place(row, case))
    }

    /// The cases of a chain, in the order in which they are solved.
    pub fn parameters(&self, chain: &Chain) -> Vec<Parameters> {
        self.places(chain).map(|place| self.parameters_at(place)).collect()
    }

    /// The ids of the cases of a chain, in the order in which they are solved.
    pub fn ids(&self, chain: &Chain) -> Vec<CaseId> {
        self.parameters(chain).iter().map(|parameters| self.id(parameters)).collect()
    }

    /// The same problem with what does not matter set to its default: equal problems get equal parameters.
    pub fn canonical(parameters: &Parameters) -> Parameters {
        canonical(parameters)
    }

    /// The id of a case solved with the settings of this sweep.
    pub fn id(&self, parameters: &Parameters) -> CaseId {
        self.fingerprint.id(parameters)
    }

    /// The problem at a place. Places with the same problem give equal parameters: elastic ones are
    /// [`Parameters::elastic`] or, at α = 0, have the default substrate, as their modes mean nothing.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn parameters_at(&self, place: GridIndex) -> Parameters {
        canonical(&self.grid.parameters(place, &self.substrate))
    }

    /// The id of the case at a place.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn case_at(&self, place: GridIndex) -> CaseId {
        self.id(&self.parameters_at(place))
    }

    /// The first place of a case in the order of publication; `None` if the case is not in the sweep.
    ///
    /// Goes through the problems one by one.
    pub fn find(&self, id: CaseId) -> Option<GridIndex> {
        let places = self.chains().flat_map(|chain| self.places(&chain).collect::<Vec<_>>());
        places.into_iter().find(|place| self.case_at(*place) == id)
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
