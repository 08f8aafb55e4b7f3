//! Why a case is as it is: what is stored of it, and how it is reached when its chain is solved again.

use std::path::Path;

use super::stale::{CaseState, Survey};
use super::{CampaignError, MergedCatalog, StaleReason, SweepDirectory, read_sweep, sweep_file};
use crate::store::{CaseEntry, Catalog, Inspection, Origin, Status, StoreError, Warning};
use crate::{CaseId, Column, Grid, GridIndex, Plan, Sweep, Values};
use stribeck_lab::{Experiment, LaboratoryQuantity};
use stribeck_solver::{Failure, Parameters, SolvedCase, Solver};

/// How a case is named.
#[derive(Clone, Debug, PartialEq)]
pub enum CaseName {
    /// By its id.
    Id(CaseId),
    /// As the one nearest to these f, α and β.
    Near([f64; 3]),
    /// As the one nearest to these values of axes, by their names, in SI units.
    At(Vec<(String, f64)>),
}

/// What a results directory tells of a case.
#[derive(Debug)]
pub struct CaseReport {
    /// Its id.
    pub id: CaseId,
    /// What is stored of it.
    pub storage: CaseStorage,
    /// Where it is in the sweep; `None` if the sweep has it no more.
    pub place: Option<CasePlace>,
    /// What in the directory is damaged and not used.
    pub warnings: Vec<Warning>,
    /// The sweep that was run last.
    pub sweep: Sweep,
    /// Its plan.
    pub plan: Plan,
}

/// What is stored of a case.
#[derive(Debug)]
pub enum CaseStorage {
    /// The case is stored.
    Stored {
        /// The case as it was stored.
        entry: Box<CaseEntry>,
        /// Where it is stored, and how it came there.
        origin: Box<Origin>,
        /// What the sweep asks for and is not stored of it; empty if the case is used as it is.
        lacks: Vec<&'static str>,
    },
    /// The case is not stored.
    Missing {
        /// The process that works in the directory, if there is one.
        worker: Option<String>,
        /// Why a stored solution of the same problem is of no use; `None` if there is none.
        stale: Option<StaleReason>,
    },
}

/// Where a case is in a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct CasePlace {
    /// f, α and β of the first place that has the case.
    pub numbers: [f64; 3],
    /// The slide-to-roll ratio S there (T52).
    pub slide_roll: f64,
    /// The experiment there, where the sweep is over quantities of the laboratory.
    pub experiment: Option<Experiment>,
    /// The parameters it is solved for, the same at all its places.
    pub parameters: Parameters,
    /// The cases of its chain.
    pub chain: Vec<Parameters>,
    /// Its index in the chain.
    pub index: usize,
}

/// A case that was solved again.
#[derive(Debug)]
pub struct SolvedAgain {
    /// The case, with a trace of how it was reached.
    pub case: SolvedCase,
    /// Whether it is what is stored.
    pub comparison: Comparison,
}

/// How a case that was solved again compares with what is stored.
#[derive(Clone, Debug, PartialEq)]
pub enum Comparison {
    /// It failed when it was stored, and converges now.
    ConvergesNow,
    /// It converged when it was stored, and fails now.
    FailsNow(Failure),
    /// It fails again.
    FailsAgain,
    /// All numbers are the same to the last bit.
    SameNumbers,
    /// Some numbers differ. Those of μ_v, μ_h and c differ by these parts of themselves.
    OtherNumbers([(Column, f64); 3]),
}

/// Finds a case in a results directory and its parts, and tells what is stored of it. Solves nothing, writes nothing.
///
/// # Errors
/// [`CampaignError::NoSuchCase`] if the directory does not know the case, [`CampaignError::NoSuchAxis`] if the sweep has
/// no axis of a name, others if it cannot be read.
pub fn explain(directory: &Path, name: &CaseName) -> Result<CaseReport, CampaignError> {
    let sweep = read_sweep(&sweep_file(directory)?)?;
    let plan = Plan::new(&sweep);
    let found = SweepDirectory::read_existing(directory, &(&sweep).into(), Inspection::Bytes)?;
    let stored = found.merged();
    let place = match name {
        CaseName::Near(numbers) => Some(nearest(&sweep, *numbers)),
        CaseName::At(wanted) => Some(nearest_at(&sweep, wanted)?),
        CaseName::Id(id) => plan.find(*id),
    };
    let place = place.map(|place| CasePlace::new(&sweep, &plan, place));
    let id = match (&place, name) {
        (Some(place), _) => plan.id(&place.parameters),
        (None, CaseName::Id(id)) if stored.holder(*id).is_some() => *id,
        (None, _) => return Err(CampaignError::NoSuchCase { directory: directory.to_owned() }),
    };
    let survey = Survey::new(&sweep, &plan, &stored);
    let stale = || match survey.state(id, &place.as_ref()?.parameters) {
        CaseState::Stale(reason) => Some(reason),
        CaseState::Done(_) | CaseState::New => None,
    };
    let storage = what_is_stored(id, &stored, stale)?;
    let warnings = stored.catalogs().iter().flat_map(|catalog| catalog.warnings()).cloned().collect();
    Ok(CaseReport { id, storage, place, warnings, sweep, plan })
}

fn what_is_stored(
    id: CaseId,
    stored: &MergedCatalog<'_>,
    stale: impl Fn() -> Option<StaleReason>,
) -> Result<CaseStorage, StoreError> {
    let holder: &Catalog = stored.holder(id).unwrap_or(stored.catalogs()[0]);
    Ok(match (holder.entry(id)?, holder.origin(id)?) {
        (Some(entry), Some(origin)) => {
            let lacks = if holder.holds(id).is_none() { holder.lacks(id) } else { Vec::new() };
            CaseStorage::Stored { entry: Box::new(entry), origin: Box::new(origin), lacks }
        }
        _ => CaseStorage::Missing { worker: holder.owner()?, stale: stale() },
    })
}

impl CaseReport {
    /// Solves the chain of the case again up to it, on this thread; `None` if the case is not stored, or not in the
    /// sweep.
    pub fn solve_again(&self) -> Option<SolvedAgain> {
        let (CaseStorage::Stored { entry, .. }, Some(place)) = (&self.storage, &self.place) else { return None };
        let solver = Solver::new(&self.sweep.solver_settings());
        let case = solver.trace_last(&place.chain[..=place.index])?;
        Some(SolvedAgain { comparison: compare(entry, &case), case })
    }
}

/// Whether a case that is solved again is what is stored.
fn compare(entry: &CaseEntry, case: &SolvedCase) -> Comparison {
    let solution = match (&case.outcome, entry.outcome) {
        (Ok(_), Status::Failed) => return Comparison::ConvergesNow,
        (Err(failure), Status::Converged) => return Comparison::FailsNow(failure.clone()),
        (Err(_), Status::Failed) => return Comparison::FailsAgain,
        (Ok(solution), Status::Converged) => solution,
    };
    let values = Values::converged(&solution.quantities, &solution.errors, &case.limits);
    // Limits may not have been asked for when it was stored.
    let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || a.is_nan() || b.is_nan();
    if values.0.iter().zip(&entry.values.0).all(same) {
        return Comparison::SameNumbers;
    }
    let difference = |column| (column, (values[column] / entry.values[column] - 1.0).abs());
    Comparison::OtherNumbers([Column::MuV, Column::MuH, Column::C].map(difference))
}

impl CasePlace {
    fn new(sweep: &Sweep, plan: &Plan, place: GridIndex) -> Self {
        let parameters = plan.parameters_at(place);
        let in_chain = |chain: &Vec<Parameters>| chain.iter().position(|case| *case == parameters);
        let mut chains = plan.chains().map(|chain| plan.parameters(&chain));
        let found = chains.find_map(|chain| in_chain(&chain).map(|index| (chain, index)));
        let (chain, index) = found.expect("every case of a plan is in a chain");
        let (numbers, experiment) = (sweep.grid.numbers(place), sweep.grid.experiment(place));
        Self { numbers, slide_roll: sweep.grid.slide_roll(place), experiment, parameters, chain, index }
    }
}

impl CasePlace {
    /// The value of an axis there, in SI units; none if the sweep has no such axis.
    pub fn coordinate(&self, name: &str) -> Option<f64> {
        let [f, alpha, beta] = self.numbers;
        coordinate(name, [self.slide_roll, f, alpha, beta], self.experiment.as_ref())
    }
}

fn coordinate(name: &str, [slide_roll, f, alpha, beta]: [f64; 4], experiment: Option<&Experiment>) -> Option<f64> {
    match name {
        "slide_roll" => Some(slide_roll),
        "f" => Some(f),
        "alpha" => Some(alpha),
        "beta" => Some(beta),
        name => Some(experiment?.value(LaboratoryQuantity::named(name)?)).filter(|value| value.is_finite()),
    }
}

/// A distance beyond that of all magnitudes: so far are the ends, 0 and infinity, from others.
const FARTHEST: f64 = 1e6;

/// The place nearest to values of axes, by their ratios; the first of several.
fn nearest_at(sweep: &Sweep, wanted: &[(String, f64)]) -> Result<GridIndex, CampaignError> {
    let shape = sweep.grid.shape();
    let value = |place: GridIndex, name: &str| {
        let [f, alpha, beta] = sweep.grid.numbers(place);
        let numbers = [sweep.grid.slide_roll(place), f, alpha, beta];
        coordinate(name, numbers, sweep.grid.experiment(place).as_ref())
    };
    let mut nearest = (f64::INFINITY, shape.index(0));
    for place in (0..shape.places()).map(|place| shape.index(place)) {
        let mut sum = 0.0;
        for (name, wanted) in wanted {
            let value = value(place, name).ok_or_else(|| CampaignError::NoSuchAxis { name: name.clone() })?;
            sum += match name.starts_with("slide_roll") {
                true => (value - wanted).abs(),
                false => distance(value, *wanted).min(FARTHEST),
            };
        }
        if sum < nearest.0 {
            nearest = (sum, place);
        }
    }
    Ok(nearest.1)
}

/// How far magnitudes are apart; the ends, 0 and infinity, are near to themselves alone.
fn distance(value: f64, wanted: f64) -> f64 {
    if value == wanted { 0.0 } else { (value.ln() - wanted.ln()).abs() }
}

/// The place whose f, α and β are nearest by their ratios, f first, then α, then β.
fn nearest(sweep: &Sweep, wanted: [f64; 3]) -> GridIndex {
    match &sweep.grid {
        Grid::Dimensionless(axes) => {
            let near = |axis: &[f64], wanted| {
                let by_distance =
                    |a: &usize, b: &usize| distance(axis[*a], wanted).total_cmp(&distance(axis[*b], wanted));
                (0..axis.len()).min_by(by_distance).expect("an axis has values")
            };
            let [f, alpha, beta] = wanted;
            GridIndex { block: near(&axes.f, f), row: near(&axes.alpha, alpha), along: near(&axes.beta, beta) }
        }
        Grid::Laboratory(_) => {
            // α and β change together: f comes first, then both.
            let shape = sweep.grid.shape();
            let places = (0..shape.places()).map(|place| shape.index(place));
            let distances = |place: GridIndex| {
                let [f, alpha, beta] = sweep.grid.numbers(place);
                (distance(f, wanted[0]), distance(alpha, wanted[1]).hypot(distance(beta, wanted[2])))
            };
            let key = |a: &(f64, f64), b: &(f64, f64)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1));
            places.min_by(|a, b| key(&distances(*a), &distances(*b))).expect("a sweep has places")
        }
    }
}
