//! From a cross approximation to the file of a surface: compressed as far as known points allow, with its certificate.

use super::build::SurfaceBuildError;
use super::comparison::{Known, errors, random_points, summary};
use super::cross::{Cross, Tucker};
use super::domain::Domain;
use crate::{Column, SurfaceSweep};
use stribeck_solver::collocation;
use stribeck_surface::{Certificate, CheckPoint, FORMAT, NumberKind, QuantityRecord, Surface, SurfaceFile, encode};

/// The largest error that compression may lead to at the leading points, in tolerances.
const COMPRESSED: f64 = 0.8;
/// What compression may leave out, in tolerances: the most that leads to no larger error is taken.
const BUDGETS: [f64; 6] = [0.5, 0.35, 0.25, 0.15, 0.1, LEAST_BUDGET];
/// What is left out where nothing is said.
const LEAST_BUDGET: f64 = 0.02;
/// Points in the file with which readers compare themselves.
const CHECK_POINTS: usize = 10;

/// What is to be published of a surface, and where.
#[derive(Clone, Copy)]
pub struct Draft<'a> {
    /// The surface that is made.
    pub surface: &'a SurfaceSweep,
    /// Its domain.
    pub domain: &'a Domain<'a>,
    /// The cases it is made from, so far.
    pub cases: usize,
}

impl Draft<'_> {
    /// The surface of a cross, with next to nothing left out. It has no certificate.
    pub fn exact(&self, cross: &Cross) -> Result<Surface, SurfaceBuildError> {
        self.of(cross, &vec![LEAST_BUDGET; self.domain.columns.len()])
    }

    /// The surface as it is published, compressed as far as the leading points allow, with its certificate by fresh
    /// ones; and its largest error.
    pub fn published(
        &self,
        cross: &Cross,
        leading: &Known,
        fresh: &Known,
        seed: u64,
    ) -> Result<(Surface, f64), SurfaceBuildError> {
        let surface = self.of(cross, &self.budgets(cross, leading)?)?;
        let mut file = surface.file().clone();
        file.certificate.points = fresh.points.len();
        file.certificate.seed = seed;
        file.certificate.errors = errors(&surface, fresh).into_iter().map(summary).collect();
        let mut evaluator = surface.evaluator();
        file.checks = random_points(self.domain, CHECK_POINTS, u64::MAX)
            .into_iter()
            .map(|point| {
                let values = evaluator.values(&point).expect("points are made in the domain").to_vec();
                CheckPoint { point, values }
            })
            .collect();
        let largest = file.certificate.errors.iter().map(|errors| errors.largest).fold(0.0, f64::max);
        Ok((Surface::new(file).expect("it is made as it must be"), largest))
    }

    /// For each quantity the most that may be left out of it.
    fn budgets(&self, cross: &Cross, leading: &Known) -> Result<Vec<f64>, SurfaceBuildError> {
        let mut chosen = vec![None; self.domain.columns.len()];
        for budget in BUDGETS {
            let surface = self.of(cross, &vec![budget; chosen.len()])?;
            for (chosen, errors) in chosen.iter_mut().zip(errors(&surface, leading)) {
                let largest = errors.into_iter().fold(0.0, f64::max);
                *chosen = chosen.or((largest <= COMPRESSED * self.surface.settings.tolerance).then_some(budget));
            }
        }
        Ok(chosen.into_iter().map(|budget| budget.unwrap_or(LEAST_BUDGET)).collect())
    }

    /// The surface of a cross, with so much left out of each quantity, in tolerances. It has no certificate yet.
    fn of(&self, cross: &Cross, budgets: &[f64]) -> Result<Surface, SurfaceBuildError> {
        let tolerance = self.surface.settings.tolerance;
        let mut quantities = Vec::with_capacity(budgets.len());
        for (q, budget) in budgets.iter().enumerate() {
            let tucker = cross.tucker(q, budget * tolerance).ok_or(SurfaceBuildError::SingularValues)?;
            quantities.push(self.quantity(self.domain.columns[q], tucker));
        }
        let file = SurfaceFile {
            format: FORMAT.to_owned(),
            title: self.surface.sweep.title.clone(),
            program: crate::store::program(),
            results_version: collocation::RESULTS_VERSION,
            tolerance,
            axes: self.domain.axes(),
            quantities,
            certificate: Certificate {
                points: 0,
                seed: self.surface.settings.seed,
                solver_tolerance: self.surface.sweep.solver.tolerance,
                cases: self.cases,
                errors: Vec::new(),
            },
            checks: Vec::new(),
            sweep: self.surface.sweep.text.clone(),
        };
        Ok(Surface::new(file).expect("it is made as it must be"))
    }

    fn quantity(&self, column: Column, tucker: Tucker) -> QuantityRecord {
        // Single precision is 6e-8 of each number, and logarithms of up to 20 are summed of them.
        let numbers = match self.surface.settings.tolerance < 1e-5 {
            true => NumberKind::Float64,
            false => NumberKind::Float32,
        };
        let (units, scale) = self.domain.units(column);
        QuantityRecord {
            name: column.name().to_owned(),
            units,
            scale,
            long_name: column.long_name().to_owned(),
            transform: self.domain.transform(column),
            shape: tucker.shape,
            numbers,
            factors: tucker.factors.iter().map(|factor| encode(numbers, factor)).collect(),
            core: encode(numbers, &tucker.core),
        }
    }
}
