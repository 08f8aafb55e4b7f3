//! How many terms a spectrum needs.

use super::measurement::Measurements;
use super::relaxation_fit::{RelaxationFit, RelaxationFitError};

/// Residual over the least one, up to which fewer terms are as good.
const AS_GOOD: f64 = 1.1;
/// The most terms that are tried for a decade of rates.
const PER_DECADE: f64 = 3.0;

/// A fit with the number of terms that the residuals ask for.
#[derive(Clone, Debug, PartialEq)]
pub struct TermChoice {
    /// The fit.
    pub fit: RelaxationFit,
    /// The number of terms offered to it.
    pub offered: usize,
    /// The most terms that were tried, three for a decade.
    pub most: usize,
    /// The least residual of all that were tried.
    pub least_residual: f64,
    /// The number of terms of that one.
    pub least_at: usize,
}

impl TermChoice {
    /// A residual that no measurement goes below: fewer terms are enough then.
    pub const GOOD_ENOUGH: f64 = 1e-3;

    /// Fits with one term, two, and so on up to three for a decade of rates, and takes the fewest whose residual is
    /// within a tenth of the least one, or below a thousandth.
    ///
    /// # Errors
    /// [`RelaxationFitError`] of the fit with the most terms, which tells a liquid best, if that gives no material.
    pub fn new(measurements: &Measurements) -> Result<Self, RelaxationFitError> {
        let (from, to) = measurements.rates();
        let wanted = (PER_DECADE * (to / from).log10()).ceil() as usize + 1;
        let most = wanted.min(RelaxationFit::MOST_TERMS).min(measurements.numbers() - 1);
        let finest = RelaxationFit::new(measurements, most)?;
        let fewer = (1..most).filter_map(|terms| Some((terms, RelaxationFit::new(measurements, terms).ok()?)));
        let fits: Vec<(usize, RelaxationFit)> = fewer.chain([(most, finest)]).collect();
        let residual = |(_, fit): &(usize, RelaxationFit)| fit.rms_residual;
        let least = fits.iter().min_by(|a, b| residual(a).total_cmp(&residual(b))).expect("the finest one is there");
        let (least_residual, least_at) = (residual(least), least.0);
        let enough = (AS_GOOD * least_residual).max(Self::GOOD_ENOUGH);
        let chosen = fits.into_iter().find(|fit| residual(fit) <= enough).expect("the least one is below");
        let (offered, fit) = chosen;
        Ok(Self { fit, offered, most, least_residual, least_at })
    }

    /// True if the residual is one that no measurement goes below.
    pub fn is_good_enough(&self) -> bool {
        self.fit.rms_residual <= Self::GOOD_ENOUGH
    }
}
