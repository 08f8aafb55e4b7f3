//! Residuals and their Jacobian, for the Levenberg–Marquardt method.

use levenberg_marquardt::LeastSquaresProblem;
use nalgebra::{DMatrix, DVector, Dyn, Owned};

use super::FrictionFitError;
use super::prediction::{Failed, Prediction, Predictor};
use crate::Measured;
use stribeck_solver::FailureKind;

/// The residual of each point where a case has no solution: so large that the method takes the step back and tries a
/// shorter one.
const REFUSED: f64 = 1e50;
/// The farthest that an unknown may move from its start, in its logarithm: a factor of a million.
const FARTHEST: f64 = 13.8;

/// A fit at work: the unknowns as ln(θ/θ₀), and the prediction that follows from them.
pub(super) struct Problem<'a> {
    predictor: &'a Predictor<'a>,
    measured: &'a Measured,
    start: Vec<f64>,
    logarithms: DVector<f64>,
    prediction: Result<Prediction, Failed>,
    evaluations: usize,
    /// The number of evaluations in which cases had no solution.
    refused: usize,
}

/// The end of a search.
pub(super) struct Found {
    pub(super) unknowns: Vec<f64>,
    /// μ of each point.
    pub(super) friction: Vec<f64>,
    pub(super) residuals: DVector<f64>,
    /// With respect to the logarithms of the unknowns.
    pub(super) jacobian: DMatrix<f64>,
}

impl<'a> Problem<'a> {
    /// The problem at its start, where every point must have a solution.
    pub(super) fn new(
        predictor: &'a Predictor<'a>,
        measured: &'a Measured,
        start: Vec<f64>,
    ) -> Result<Self, FrictionFitError> {
        let (points, unknowns) = (measured.friction.len(), start.len());
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
        let prediction = predictor.predict(&start);
        if let Err(Failed { point, failure }) = &prediction {
            return Err(FrictionFitError::Start { place: measured.place(*point), failure: failure.clone() });
        }
        let logarithms = DVector::zeros(start.len());
        Ok(Self { predictor, measured, start, logarithms, prediction, evaluations: 1, refused: 0 })
    }

    pub(super) fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// True if a step was taken back because cases had no solution.
    pub(super) fn was_refused(&self) -> bool {
        self.refused > 0
    }

    /// The end of the search; `None` if cases failed there.
    pub(super) fn found(self) -> Option<Found> {
        let (unknowns, residuals, jacobian) = (self.unknowns(), self.residuals()?, self.jacobian()?);
        Some(Found { unknowns, friction: self.prediction.ok()?.friction, residuals, jacobian })
    }

    fn unknowns(&self) -> Vec<f64> {
        self.start.iter().zip(&self.logarithms).map(|(start, logarithm)| start * logarithm.exp()).collect()
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, logarithms: &DVector<f64>) {
        if *logarithms == self.logarithms {
            return;
        }
        self.logarithms.copy_from(logarithms);
        let near = logarithms.iter().all(|logarithm| logarithm.abs() <= FARTHEST);
        self.prediction = match near {
            true => self.predictor.predict(&self.unknowns()),
            false => {
                let failure = FailureKind::Other("an unknown is a million times what it began at".to_owned()).into();
                Err(Failed { point: 0, failure })
            }
        };
        self.evaluations += 1;
        self.refused += usize::from(self.prediction.is_err());
    }

    fn params(&self) -> DVector<f64> {
        self.logarithms.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let measured = self.measured;
        match &self.prediction {
            Ok(Prediction { friction, .. }) => {
                let residual = |(i, mu): (usize, &f64)| match &measured.errors {
                    Some(errors) => (mu - measured.friction[i]) / errors[i],
                    None => (mu / measured.friction[i]).ln(),
                };
                Some(DVector::from_iterator(friction.len(), friction.iter().enumerate().map(residual)))
            }
            Err(Failed { .. }) => Some(DVector::from_element(measured.friction.len(), REFUSED)),
        }
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let Prediction { friction, derivatives } = self.prediction.as_ref().ok()?;
        let element = |i: usize, j: usize| match &self.measured.errors {
            Some(errors) => derivatives[i][j] / errors[i],
            None => derivatives[i][j] / friction[i],
        };
        Some(DMatrix::from_fn(friction.len(), self.start.len(), element))
    }
}
