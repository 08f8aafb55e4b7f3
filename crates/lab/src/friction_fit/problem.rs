//! Residuals and their Jacobian, for the Levenberg–Marquardt method.

use levenberg_marquardt::LeastSquaresProblem;
use nalgebra::{DMatrix, DVector, Dyn, Owned};

use super::bounds::{Bounds, Path};
use super::prediction::{NotPredicted, Prediction, Predictor};
use super::{FrictionFitError, Watch};
use crate::Measured;
use stribeck_solver::FailureKind;

/// The residual of each point where a case has no solution: so large that the method takes the step back and tries a
/// shorter one.
const REFUSED: f64 = 1e50;

/// A fit at work: the parameters of the unknowns, and the prediction that follows from them.
pub(super) struct Problem<'a> {
    predictor: &'a Predictor<'a>,
    measured: &'a Measured,
    watch: &'a Watch<'a>,
    start: Vec<f64>,
    paths: Vec<Path>,
    /// What each residual is multiplied with, over what all of them have in common.
    weights: Vec<f64>,
    /// What residuals are to be multiplied with: 1 without standard errors.
    scale: f64,
    parameters: DVector<f64>,
    prediction: Result<Prediction, NotPredicted>,
    evaluations: usize,
    /// The number of evaluations in which cases had no solution.
    refused: usize,
    /// The smallest residuals so far.
    best: Option<Best>,
}

/// The best of the evaluations: parameters and unknowns, what follows from them, and the sum of the squares.
struct Best {
    parameters: DVector<f64>,
    unknowns: Vec<f64>,
    prediction: Prediction,
    sum: f64,
}

/// The end of a search. Residuals and Jacobian are those of the points over `scale`.
pub(super) struct Found {
    pub(super) unknowns: Vec<f64>,
    /// μ of each point.
    pub(super) friction: Vec<f64>,
    pub(super) residuals: DVector<f64>,
    /// With respect to the logarithms of the unknowns.
    pub(super) jacobian: DMatrix<f64>,
    pub(super) scale: f64,
    /// True for each unknown at one of its bounds.
    pub(super) at_bounds: Vec<bool>,
    /// False if the search was told to stop before.
    pub(super) is_minimum: bool,
}

impl<'a> Problem<'a> {
    /// The problem at its start, where every point must have a solution.
    pub(super) fn new(
        predictor: &'a Predictor<'a>,
        measured: &'a Measured,
        bounds: &[Bounds],
        watch: &'a Watch<'a>,
    ) -> Result<Self, FrictionFitError> {
        let start = predictor.start();
        check_points(measured, start.len())?;
        let paths = predictor.unknowns().iter().zip(&start).map(|(unknown, start)| Path::new(*unknown, *start, bounds));
        let paths = paths.collect::<Result<Vec<_>, _>>()?;
        let prediction = predictor.predict(&start, watch.interrupt);
        let friction = match &prediction {
            Ok(prediction) => &prediction.friction,
            Err(NotPredicted::Failed { point, failure }) => {
                return Err(FrictionFitError::Start {
                    place: measured.place(*point),
                    failure: Box::new(failure.clone()),
                });
            }
            Err(NotPredicted::Interrupted) => return Err(FrictionFitError::TimeLimit),
        };
        // Common factors of standard errors must not change the search: its steps are as long as residuals are large.
        let weights = measured.weights();
        let size = |(weight, mu): (&f64, &f64)| if measured.is_logarithmic() { *weight } else { (weight * mu).abs() };
        let scale = match &measured.errors {
            Some(_) => weights.iter().zip(friction).map(size).fold(0.0, f64::max),
            None => 1.0,
        };
        if !(scale > 0.0 && scale.is_finite()) {
            let what =
                "its standard errors are beyond what can be computed with; are they in the unit of the friction?";
            return Err(FrictionFitError::Task { what: what.to_owned() });
        }
        let weights = weights.into_iter().map(|weight| weight / scale).collect();
        let parameters = DVector::zeros(start.len());
        let mut problem = Self {
            predictor,
            measured,
            watch,
            start,
            paths,
            weights,
            scale,
            parameters,
            prediction,
            evaluations: 1,
            refused: 0,
            best: None,
        };
        problem.note_progress();
        Ok(problem)
    }

    pub(super) fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// True if a step was taken back because cases had no solution.
    pub(super) fn was_refused(&self) -> bool {
        self.refused > 0
    }

    /// True if the search was told to stop.
    pub(super) fn interrupted(&self) -> bool {
        matches!(self.prediction, Err(NotPredicted::Interrupted))
    }

    /// The best of the search so far; `None` if there is none.
    pub(super) fn best(mut self) -> Option<Found> {
        let Best { parameters, prediction, .. } = self.best.take()?;
        (self.parameters, self.prediction) = (parameters, Ok(prediction));
        self.found().map(|found| Found { is_minimum: false, ..found })
    }

    /// The end of the search; `None` if cases failed there.
    pub(super) fn found(self) -> Option<Found> {
        let (logarithms, _) = self.logarithms()?;
        let at_bounds = self.paths.iter().zip(&logarithms).map(|(path, at)| path.is_at_end(*at)).collect();
        let (unknowns, residuals, jacobian) = (self.unknowns()?, self.residuals()?, self.by_logarithms()?);
        Some(Found {
            unknowns,
            friction: self.prediction.ok()?.friction,
            residuals,
            jacobian,
            scale: self.scale,
            at_bounds,
            is_minimum: true,
        })
    }

    /// ln(θ/θ₀) of each unknown, and how it changes with its parameter; `None` where one is too far.
    fn logarithms(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        self.paths.iter().zip(&self.parameters).map(|(path, parameter)| path.at(*parameter)).collect()
    }

    fn unknowns(&self) -> Option<Vec<f64>> {
        let (logarithms, _) = self.logarithms()?;
        Some(self.start.iter().zip(logarithms).map(|(start, logarithm)| start * logarithm.exp()).collect())
    }

    /// Tells how far the search is.
    fn note_progress(&mut self) {
        let Some((unknowns, residuals)) = self.unknowns().zip(self.residuals()) else { return };
        let sum = residuals.norm_squared();
        if let Ok(prediction) = &self.prediction
            && self.best.as_ref().is_none_or(|best| sum < best.sum)
        {
            let (parameters, prediction) = (self.parameters.clone(), prediction.clone());
            self.best = Some(Best { parameters, unknowns, prediction, sum });
        }
        let best = self.best.as_ref().map_or(&self.start, |best| &best.unknowns);
        (self.watch.evaluated)(self.evaluations, best);
    }

    /// The Jacobian with respect to the logarithms of the unknowns.
    fn by_logarithms(&self) -> Option<DMatrix<f64>> {
        let Prediction { friction, derivatives } = self.prediction.as_ref().ok()?;
        let of_difference = |i: usize| if self.measured.is_logarithmic() { 1.0 / friction[i] } else { 1.0 };
        let factors: Vec<f64> = self.weights.iter().enumerate().map(|(i, weight)| weight * of_difference(i)).collect();
        let element = |i: usize, j: usize| factors[i] * derivatives[i][j];
        Some(DMatrix::from_fn(friction.len(), self.start.len(), element))
    }
}

/// Checks that the points are enough for the unknowns, and positive where they must be.
fn check_points(measured: &Measured, unknowns: usize) -> Result<(), FrictionFitError> {
    let points = measured.friction.len();
    let needed = if measured.errors.is_some() { unknowns } else { unknowns + 1 };
    if points < needed {
        let what = format!("{points} points are too few for {unknowns} unknowns; measure more, or look for fewer");
        return Err(FrictionFitError::Task { what });
    }
    if let (None, Some(i)) = (&measured.errors, measured.friction.iter().position(|mu| *mu <= 0.0)) {
        let what = format!(
            "the friction coefficient on {} is not above 0: relative errors need positive numbers; add \
             a column `error` with standard errors",
            measured.place(i)
        );
        return Err(FrictionFitError::Task { what });
    }
    Ok(())
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, parameters: &DVector<f64>) {
        if *parameters == self.parameters || self.interrupted() {
            return;
        }
        self.parameters.copy_from(parameters);
        self.prediction = match self.unknowns() {
            Some(unknowns) => self.predictor.predict(&unknowns, self.watch.interrupt),
            None => {
                let failure = FailureKind::Other("an unknown is a million times what it began at".to_owned()).into();
                Err(NotPredicted::Failed { point: 0, failure })
            }
        };
        self.evaluations += 1;
        self.refused += usize::from(self.prediction.is_err());
        self.note_progress();
    }

    fn params(&self) -> DVector<f64> {
        self.parameters.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let measured = self.measured;
        match &self.prediction {
            Ok(Prediction { friction, .. }) => {
                let residual = |(i, mu): (usize, &f64)| self.weights[i] * measured.difference(i, *mu);
                Some(DVector::from_iterator(friction.len(), friction.iter().enumerate().map(residual)))
            }
            Err(NotPredicted::Failed { .. }) => Some(DVector::from_element(measured.friction.len(), REFUSED)),
            Err(NotPredicted::Interrupted) => None,
        }
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let (_, slopes) = self.logarithms()?;
        let mut jacobian = self.by_logarithms()?;
        jacobian.column_iter_mut().zip(slopes).for_each(|(mut column, slope)| column *= slope);
        Some(jacobian)
    }
}
