//! From a sweep file with ranges to `surface.json`.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::comparison::{errors, random_points};
use super::compression::{Compressed, compress};
use super::domain::{Domain, Numbers};
use super::leja::Leja;
use super::lower_set::{LowerSet, MOST_ALONG};
use super::nodes::Nodes;
use super::rounds::Rounds;
use crate::SurfaceSweep;
use crate::campaign::{CampaignError, available_threads};
use crate::engine::ThreadsError;
use crate::store::{StoreError, write_whole};
use stribeck_solver::{Interrupt, Parameters, collocation};
use stribeck_surface::{
    Certificate, CheckPoint, ErrorRecord, FORMAT, NumberKind, QuantityRecord, Surface, SurfaceFile, encode,
};

/// The first nodes: all whose indices add up to this.
const FIRST_DEGREE: u16 = 4;
/// The first threshold, in tolerances. Errors of many indices add up.
const FIRST_THRESHOLD: f64 = 0.1;
/// The part of the tolerance that compression may take.
const COMPRESSION: f64 = 0.1;
/// The most cases of a surface.
const MOST_CASES: usize = 400_000;
/// Points in the file with which readers compare themselves.
const CHECK_POINTS: usize = 10;

/// How a surface is made. None of it changes a number.
#[derive(Clone, Debug)]
pub struct SurfaceOptions {
    /// Solver threads; by default one for each core.
    pub threads: NonZeroUsize,
    /// A request through it stops the work soon, and what is finished is stored.
    pub interrupt: Arc<Interrupt>,
}

impl Default for SurfaceOptions {
    fn default() -> Self {
        Self { threads: available_threads(), interrupt: Arc::default() }
    }
}

/// What is told while a surface is made.
#[derive(Clone, Debug, PartialEq)]
pub enum Progress {
    /// A stored file, or a line of a log, is damaged and not used. Its cases are solved again.
    Damaged {
        /// What is damaged.
        what: String,
    },
    /// A round of new nodes begins.
    Round {
        /// Its number, from 1.
        number: usize,
        /// The number of nodes so far, the new ones among them.
        nodes: usize,
        /// The largest change by an index whose neighbours are not there yet, in tolerances.
        change: f64,
    },
    /// The surface was compared with solutions at random points.
    Compared {
        /// The number of nodes.
        nodes: usize,
        /// The largest error, in tolerances.
        largest: f64,
    },
}

/// A surface that was made.
#[derive(Clone, Debug)]
pub struct SurfaceReport {
    /// The file.
    pub file: PathBuf,
    /// The surface.
    pub surface: Surface,
    /// Cases that were solved now and not before.
    pub solved: u64,
    /// True if the largest error of each quantity is below the tolerance.
    pub holds: bool,
}

/// Why a surface was not made.
#[derive(Debug, thiserror::Error)]
pub enum SurfaceBuildError {
    /// The directory cannot be used.
    #[error(transparent)]
    Campaign(#[from] CampaignError),
    /// The disk, or a file.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Threads.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
    /// A case that a surface needs has no solution.
    #[error(
        "a surface needs every case, and the one at alpha {}, beta {}, f {} failed: {reason}; choose ranges without it",
        case.alpha, case.beta, case.f
    )]
    Failed {
        /// The case.
        case: Box<Parameters>,
        /// Why it failed.
        reason: String,
    },
    /// A quantity that has no number somewhere.
    #[error(
        "`{quantity}` is {value:e} at {place}, and a surface of it must be above 0; leave it out of surface.quantities, \
         or choose other ranges"
    )]
    NoNumber {
        /// The quantity.
        quantity: &'static str,
        /// What it is.
        value: f64,
        /// Where, as in `alpha = 1, beta = 10`.
        place: String,
    },
    /// Coefficients that could not be compressed.
    #[error(
        "the singular values of the coefficients of `{quantity}` did not converge; please report it with the sweep"
    )]
    Compression {
        /// The quantity.
        quantity: &'static str,
    },
    /// Someone asked to stop.
    #[error("interrupted; the same command goes on")]
    Interrupted,
}

/// Makes the surface of a sweep, or goes on with one: `DIRECTORY/surface.json`. Nodes are stored as a run stores its
/// cases. The file does not depend on the number of threads or on interruptions.
///
/// # Errors
/// [`SurfaceBuildError`] if a case fails, the disk fails, or someone asks to stop. A surface that does not reach its
/// tolerance is written, and [`SurfaceReport::holds`] is false.
pub fn build(
    surface: &SurfaceSweep,
    directory: &Path,
    options: &SurfaceOptions,
    tell: &mut dyn FnMut(Progress),
) -> Result<SurfaceReport, SurfaceBuildError> {
    let nodes = Nodes::new(surface, Some(directory), options, tell)?;
    let mut work = Work { surface, domain: Domain::new(surface), nodes, leja: Leja::new(MOST_ALONG) };
    let (mut rounds, mut unwritten) = (Rounds::default(), None);
    let (made, holds) = work.refine(&mut |progress| {
        unwritten = unwritten.take().or(rounds.tell(directory, &progress).err());
        tell(progress);
    })?;
    unwritten.map_or(Ok(()), Err)?;
    let file = directory.join("surface.json");
    let text = serde_json::to_string_pretty(made.file()).expect("a surface is made of texts and finite numbers");
    // A link to a file stays, and the file is replaced; one to a device gives way, as the device must not.
    let linked = file.is_symlink() && file.is_file();
    let target = if linked { file.canonicalize().unwrap_or_else(|_| file.clone()) } else { file.clone() };
    write_whole(target, (text + "\n").as_bytes())?;
    Ok(SurfaceReport { file, surface: made, solved: work.nodes.solved(), holds })
}

/// Compares a surface with solutions at so many random points of a seed: the errors of each quantity.
///
/// # Errors
/// [`SurfaceBuildError`] if a case fails, or someone asks to stop.
pub fn compare_surface(
    sweep: &SurfaceSweep,
    surface: &Surface,
    points: usize,
    seed: u64,
    options: &SurfaceOptions,
) -> Result<Vec<ErrorRecord>, SurfaceBuildError> {
    let nodes = Nodes::new(sweep, None, options, &mut |_| {})?;
    let mut work = Work { surface: sweep, domain: Domain::new(sweep), nodes, leja: Leja::new(1) };
    let points = random_points(&work.domain, points, seed);
    let numbers = work.numbers(&points)?;
    Ok(errors(surface, &points, &numbers))
}

/// A surface while it is made.
struct Work<'a> {
    surface: &'a SurfaceSweep,
    domain: Domain<'a>,
    nodes: Nodes<'a>,
    leja: Leja,
}

/// Nodes with what is interpolated there.
struct Interpolation {
    set: LowerSet,
    /// For each quantity the numbers that are interpolated, at each node.
    series: Vec<Vec<f64>>,
    /// For each quantity what each index adds.
    surpluses: Vec<Vec<f64>>,
    /// For each quantity what a change of its series by the tolerance is relative to.
    scales: Vec<f64>,
}

impl Work<'_> {
    /// Refines until random points show no error above the tolerance; false if that needs too many cases.
    fn refine(&mut self, tell: &mut dyn FnMut(Progress)) -> Result<(Surface, bool), SurfaceBuildError> {
        let settings = &self.surface.settings;
        let set = LowerSet::simplex(self.domain.dimensions(), FIRST_DEGREE);
        let series = vec![Vec::new(); self.domain.columns.len()];
        let scales = vec![f64::INFINITY; series.len()];
        let mut now = Interpolation { set, series, surpluses: Vec::new(), scales };
        let (mut threshold, mut round) = (FIRST_THRESHOLD, 0);
        for attempt in 0.. {
            self.grow(&mut now, threshold, &mut round, tell)?;
            let cases = self.nodes.count();
            // Points that a decision was made by are not fresh any more.
            let seed = settings.seed + attempt;
            let points = random_points(&self.domain, settings.points, seed);
            let numbers = self.numbers(&points)?;
            let compared = self.compressed(&now, &points, &numbers, cases, seed)?;
            let worst = compared.file().certificate.errors.iter().map(|errors| errors.largest).fold(0.0, f64::max);
            let largest = worst / settings.tolerance;
            tell(Progress::Compared { nodes: now.set.indices().len(), largest });
            if largest <= 1.0 || now.set.indices().len() >= MOST_CASES {
                return Ok((compared, largest <= 1.0));
            }
            threshold *= (0.7 / largest).clamp(0.2, 0.7);
        }
        unreachable!("each attempt has a lower threshold, and the number of cases is bounded")
    }

    /// Adds nodes until each index that changes the surface by more than the threshold has its neighbours.
    fn grow(
        &mut self,
        now: &mut Interpolation,
        threshold: f64,
        round: &mut usize,
        tell: &mut dyn FnMut(Progress),
    ) -> Result<(), SurfaceBuildError> {
        loop {
            self.solve_new_nodes(now)?;
            let tolerances: Vec<f64> = now.scales.iter().map(|scale| scale * self.surface.settings.tolerance).collect();
            let changes: Vec<f64> = (0..now.set.indices().len())
                .map(|node| {
                    let changes = now.surpluses.iter().zip(&tolerances).map(|(all, tolerance)| all[node] / tolerance);
                    changes.map(f64::abs).fold(0.0, f64::max)
                })
                .collect();
            let change = now.set.open_weight(&changes);
            if change <= threshold || now.set.indices().len() >= MOST_CASES {
                return Ok(());
            }
            now.set.grow(&changes, threshold);
            *round += 1;
            tell(Progress::Round { number: *round, nodes: now.set.indices().len(), change });
        }
    }

    /// Solves the nodes that have no numbers yet.
    fn solve_new_nodes(&mut self, now: &mut Interpolation) -> Result<(), SurfaceBuildError> {
        let known = now.series[0].len();
        let node = |index: &[u16; 3]| index.map(|i| self.leja.nodes[usize::from(i)]);
        let points: Vec<Vec<f64>> =
            now.set.indices()[known..].iter().map(|index| self.domain.point(&node(index))).collect();
        for (point, numbers) in points.iter().zip(self.numbers(&points)?) {
            let series = self.domain.series(&numbers);
            if let Some(q) = series.iter().position(|number| !number.is_finite()) {
                let names = self.surface.axes.iter().zip(point).map(|(axis, x)| format!("{} = {x}", axis.name));
                let (quantity, value) = (self.domain.columns[q].name(), numbers.values[q]);
                let place = names.collect::<Vec<_>>().join(", ");
                return Err(SurfaceBuildError::NoNumber { quantity, value, place });
            }
            now.series.iter_mut().zip(series).for_each(|(all, number)| all.push(number));
            now.scales.iter_mut().zip(self.domain.scales(&numbers)).for_each(|(least, it)| *least = least.min(it));
        }
        now.surpluses = now.series.iter().map(|series| now.set.surpluses(&self.leja, series)).collect();
        Ok(())
    }

    /// The numbers at points.
    fn numbers(&mut self, points: &[Vec<f64>]) -> Result<Vec<Numbers>, SurfaceBuildError> {
        let cases: Vec<Parameters> = points.iter().map(|point| self.domain.parameters(point)).collect();
        let values = self.nodes.solve(&cases)?;
        Ok(points.iter().zip(&values).map(|(point, values)| self.domain.numbers(point, values)).collect())
    }

    /// The surface in Tucker form: of the least ranks that change it at no point by more than a part of the tolerance.
    fn compressed(
        &self,
        now: &Interpolation,
        points: &[Vec<f64>],
        numbers: &[Numbers],
        cases: usize,
        seed: u64,
    ) -> Result<Surface, SurfaceBuildError> {
        let tolerance = self.surface.settings.tolerance;
        let (mut parts, lengths) = (Vec::new(), now.set.shape());
        for ((column, surpluses), scale) in self.domain.columns.iter().zip(&now.surpluses).zip(&now.scales) {
            let coefficients = now.set.coefficients(&self.leja, surpluses);
            let failed = || SurfaceBuildError::Compression { quantity: column.name() };
            // What is left out of the series is spread over the domain; at its worst it is some times its mean.
            let part = compress(&coefficients, &lengths, COMPRESSION * tolerance * scale).ok_or_else(failed)?;
            parts.push(part);
        }
        let certificate = Certificate {
            points: points.len(),
            seed,
            solver_tolerance: self.surface.sweep.solver.tolerance,
            cases,
            errors: Vec::new(),
        };
        let mut file = self.file(parts, certificate);
        let surface = Surface::new(file.clone()).expect("it is made as it must be");
        file.certificate.errors = errors(&surface, points, numbers);
        let mut evaluator = surface.evaluator();
        file.checks = random_points(&self.domain, CHECK_POINTS, u64::MAX)
            .into_iter()
            .map(|point| {
                let values = evaluator.values(&point).expect("points are made in the domain").to_vec();
                CheckPoint { point, values }
            })
            .collect();
        Ok(Surface::new(file).expect("it is made as it must be"))
    }

    fn file(&self, parts: Vec<Compressed>, certificate: Certificate) -> SurfaceFile {
        // Single precision is 6e-8 of each number, and logarithms of up to 20 are summed of them.
        let numbers = match self.surface.settings.tolerance < 1e-5 {
            true => NumberKind::Float64,
            false => NumberKind::Float32,
        };
        let quantity = |(column, part): (&crate::Column, Compressed)| {
            let (units, scale) = self.domain.units(*column);
            QuantityRecord {
                name: column.name().to_owned(),
                units,
                scale,
                long_name: column.long_name().to_owned(),
                transform: self.domain.transform(*column),
                shape: part.shape,
                numbers,
                factors: part.factors.iter().map(|factor| encode(numbers, factor)).collect(),
                core: encode(numbers, &part.core),
            }
        };
        SurfaceFile {
            format: FORMAT.to_owned(),
            title: self.surface.sweep.title.clone(),
            program: crate::store::program(),
            results_version: collocation::RESULTS_VERSION,
            tolerance: self.surface.settings.tolerance,
            axes: self.domain.axes(),
            quantities: self.domain.columns.iter().zip(parts).map(quantity).collect(),
            certificate,
            checks: Vec::new(),
            sweep: self.surface.sweep.text.clone(),
        }
    }
}
