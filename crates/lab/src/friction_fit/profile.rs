//! Intervals of unknowns from the profile of the residuals: one unknown is held, the others are fitted again.

use super::prediction::{NotPredicted, Predictor};
use super::problem::Found;
use crate::Measured;

use super::{Estimate, FrictionFit, FrictionFitError, FrictionTask, Watch, search};

/// Values tried for each end.
const MOST: usize = 8;
/// How near the sum of squares must come to its value at an end, relative to its rise.
const NEAR: f64 = 0.02;

impl FrictionFit {
    /// The interval of each unknown within which the sum of squares rises by no more than one standard error makes of
    /// it: by 1 where standard errors are known, else by s². The other unknowns follow. An end that is not found within
    /// the reach of eight standard errors or has no solutions is `None`.
    ///
    /// To first order these are the values plus and minus their standard errors; where they are not, the errors are
    /// not alike on both sides.
    ///
    /// # Errors
    /// [`FrictionFitError::TimeLimit`] if the interrupt was requested.
    pub fn intervals(
        &self,
        task: &FrictionTask<'_>,
        watch: &Watch<'_>,
    ) -> Result<Vec<[Option<f64>; 2]>, FrictionFitError> {
        let ends =
            |estimate: &Estimate| Ok([self.end(task, estimate, -1.0, watch)?, self.end(task, estimate, 1.0, watch)?]);
        self.estimates.iter().map(ends).collect()
    }

    /// The end of an interval on the side of the sign.
    fn end(
        &self,
        task: &FrictionTask<'_>,
        estimate: &Estimate,
        sign: f64,
        watch: &Watch<'_>,
    ) -> Result<Option<f64>, FrictionFitError> {
        let relative = estimate.error / estimate.value;
        let sum: f64 = self.points.iter().map(|point| point.residual * point.residual).sum();
        let rise = if task.measured.errors.is_some() { 1.0 } else { self.reduced_chi_squared };
        if !(relative > 0.0 && rise > 0.0) {
            return Ok(None);
        }
        // The root of the rise grows as the logarithm does, about.
        let mut at = relative;
        for _ in 0..MOST {
            let value = estimate.value * (sign * at).exp();
            let Some(held) = self.held(task, estimate, value, watch)? else { return Ok(None) };
            let reached = ((held - sum) / rise).max(0.0).sqrt();
            if (reached - 1.0).abs() < NEAR {
                return Ok(Some(value));
            }
            at *= (1.0 / reached).clamp(0.3, 3.0);
            if at > 8.0 * relative {
                return Ok(None);
            }
        }
        Ok(None)
    }

    /// The sum of squares where one unknown has a value and the others are fitted; `None` if there is no solution.
    fn held(
        &self,
        task: &FrictionTask<'_>,
        estimate: &Estimate,
        value: f64,
        watch: &Watch<'_>,
    ) -> Result<Option<f64>, FrictionFitError> {
        let mut experiment = task.experiment;
        self.estimates.iter().for_each(|it| it.unknown.set(&mut experiment, it.value));
        estimate.unknown.set(&mut experiment, value);
        let unknowns = task.unknowns.iter().copied().filter(|unknown| *unknown != estimate.unknown).collect();
        let task = FrictionTask { experiment, unknowns, ..task.clone() };
        let predictor = Predictor::new(&task)?;
        if task.unknowns.is_empty() {
            return match predictor.predict(&[], watch.interrupt) {
                Ok(prediction) => Ok(Some(squares(task.measured, &prediction.friction))),
                Err(NotPredicted::Failed { .. }) => Ok(None),
                Err(NotPredicted::Interrupted) => Err(FrictionFitError::TimeLimit),
            };
        }
        match search(&task, &predictor, watch) {
            Ok((Found { is_minimum: false, .. }, _)) | Err(FrictionFitError::TimeLimit) => {
                Err(FrictionFitError::TimeLimit)
            }
            Ok((Found { friction, .. }, _)) => Ok(Some(squares(task.measured, &friction))),
            Err(_) => Ok(None),
        }
    }
}

/// The sum of the squares of the residuals of these friction coefficients.
fn squares(measured: &Measured, friction: &[f64]) -> f64 {
    let residuals = measured.weights().into_iter().zip(friction).enumerate();
    residuals.map(|(i, (weight, mu))| (weight * measured.difference(i, *mu)).powi(2)).sum()
}
