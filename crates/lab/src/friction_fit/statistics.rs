//! Standard errors and correlations of the unknowns.

use nalgebra::{DMatrix, DVector};

use super::Unknown;

/// The smallest ratio of singular values of the Jacobian, its columns scaled to length 1, with which every direction
/// is known.
const SMALLEST: f64 = 1e-6;

/// Standard errors, correlations and the goodness of a fit.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Statistics {
    /// Standard errors of the logarithms: relative standard errors.
    pub(super) errors: Vec<f64>,
    pub(super) correlation: Vec<Vec<f64>>,
    pub(super) degrees_of_freedom: usize,
    pub(super) reduced_chi_squared: f64,
}

impl Statistics {
    /// Of residuals that are not at their minimum: nothing but their size is known.
    pub(super) fn of_no_minimum(residuals: &DVector<f64>, unknowns: usize) -> Self {
        let (degrees_of_freedom, none) = (residuals.len() - unknowns, vec![f64::NAN; unknowns]);
        Self {
            correlation: vec![none.clone(); unknowns],
            errors: none,
            degrees_of_freedom,
            reduced_chi_squared: reduced_chi_squared(residuals, degrees_of_freedom),
        }
    }
}

/// The mean square of residuals over their degrees of freedom; NaN without any.
fn reduced_chi_squared(residuals: &DVector<f64>, degrees_of_freedom: usize) -> f64 {
    if degrees_of_freedom == 0 { f64::NAN } else { residuals.norm_squared() / degrees_of_freedom as f64 }
}

/// Unknowns with the same effect on all points.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "{} cannot be told apart by these points: {}; keep some of them fixed, or measure where they differ",
    names.join(" and "),
    if names.len() == 1 { "the friction does not depend on it" } else { "a change of one is made up for by the others" }
)]
pub struct Inseparable {
    /// Their names.
    pub names: Vec<&'static str>,
}

/// Standard errors from the Jacobian with respect to the logarithms of the unknowns.
///
/// The covariance is (JᵀJ)⁻¹ where the standard errors of the points are known, else s²(JᵀJ)⁻¹ with s² = Σr²/(m − n).
///
/// # Errors
/// [`Inseparable`] if a combination of unknowns changes nothing.
pub(super) fn statistics(
    jacobian: &DMatrix<f64>,
    residuals: &DVector<f64>,
    known_errors: bool,
    unknowns: &[Unknown],
) -> Result<Statistics, Inseparable> {
    let (points, count) = jacobian.shape();
    let degrees_of_freedom = points - count;
    let reduced_chi_squared = reduced_chi_squared(residuals, degrees_of_freedom);
    if count == 0 {
        return Ok(Statistics { errors: vec![], correlation: vec![], degrees_of_freedom, reduced_chi_squared });
    }
    let lengths: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
    if let Some(place) = lengths.iter().position(|length| *length == 0.0) {
        return Err(Inseparable { names: vec![unknowns[place].name()] });
    }
    let scaled = DMatrix::from_fn(points, count, |i, j| jacobian[(i, j)] / lengths[j]);
    let decomposition = scaled.svd(false, true);
    let (values, vectors) = (&decomposition.singular_values, decomposition.v_t.as_ref().expect("it was asked for"));
    let least = values.imin();
    if values[least] < SMALLEST * values.max() {
        let part = |j: usize| vectors[(least, j)].abs();
        let names = (0..count).filter(|j| part(*j) > 0.1).map(|j| unknowns[j].name()).collect();
        return Err(Inseparable { names });
    }
    let variance = if known_errors { 1.0 } else { reduced_chi_squared };
    let covariance = |j: usize, k: usize| {
        let sum: f64 = (0..values.len()).map(|i| vectors[(i, j)] * vectors[(i, k)] / values[i].powi(2)).sum();
        variance * sum / (lengths[j] * lengths[k])
    };
    let errors: Vec<f64> = (0..count).map(|j| covariance(j, j).sqrt()).collect();
    let correlation = (0..count)
        .map(|j| (0..count).map(|k| if j == k { 1.0 } else { covariance(j, k) / (errors[j] * errors[k]) }).collect())
        .collect();
    Ok(Statistics { errors, correlation, degrees_of_freedom, reduced_chi_squared })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LaboratoryQuantity;

    const UNKNOWNS: [Unknown; 2] = [Unknown::Strength, Unknown::Quantity(LaboratoryQuantity::Viscosity)];

    /// A straight line through points with equal errors σ: the variance of its slope is σ²/Σ(x − x̄)², its intercept's
    /// σ²(1/m + x̄²/Σ(x − x̄)²), their covariance −x̄ times that of the slope.
    #[test]
    fn a_line_has_the_errors_of_the_books() {
        let x = [1.0, 2.0, 4.0, 7.0];
        let sigma = 0.3;
        let jacobian = DMatrix::from_fn(4, 2, |i, j| if j == 0 { 1.0 / sigma } else { x[i] / sigma });
        let residuals = DVector::from_row_slice(&[1.0, -2.0, 0.5, 0.5]);
        let mean = 3.5;
        let spread: f64 = x.iter().map(|x| (x - mean) * (x - mean)).sum();
        let (slope, intercept) = (sigma / spread.sqrt(), sigma * (0.25 + mean * mean / spread).sqrt());
        let known = statistics(&jacobian, &residuals, true, &UNKNOWNS).expect("a line");
        assert!((known.errors[0] - intercept).abs() < 1e-14 && (known.errors[1] - slope).abs() < 1e-14);
        let expected = -mean * slope * slope / (slope * intercept);
        assert!((known.correlation[0][1] - expected).abs() < 1e-14);
        assert_eq!((known.degrees_of_freedom, known.reduced_chi_squared), (2, 5.5 / 2.0));
        let unknown = statistics(&jacobian, &residuals, false, &UNKNOWNS).expect("a line");
        assert!((unknown.errors[1] / known.errors[1] - 2.75_f64.sqrt()).abs() < 1e-14);
    }

    #[test]
    fn unknowns_with_one_effect_are_named() {
        let residuals = DVector::zeros(3);
        let same = DMatrix::from_fn(3, 2, |i, j| (i + 1) as f64 * (j + 1) as f64);
        let error = statistics(&same, &residuals, true, &UNKNOWNS).unwrap_err();
        assert_eq!(error.names, ["f", "viscosity"]);
        let none = DMatrix::from_fn(3, 2, |i, j| if j == 0 { (i + 1) as f64 } else { 0.0 });
        let error = statistics(&none, &residuals, true, &UNKNOWNS).unwrap_err();
        assert_eq!(
            error.to_string(),
            "viscosity cannot be told apart by these points: the friction does not depend on it; keep some of \
             them fixed, or measure where they differ"
        );
    }
}
