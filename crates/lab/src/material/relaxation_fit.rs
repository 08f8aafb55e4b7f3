//! Fits of relaxation spectra to measured moduli, in oscillation or after a step of strain.

use ndarray::{Array1, Array2};
use nnls::nnls;

use super::measurement::{Measurement, Measurements};
use super::relaxation::{MaterialError, Relaxation, RelaxationTerm};

/// A relaxation spectrum fitted to measured moduli.
#[derive(Clone, Debug, PartialEq)]
pub struct RelaxationFit {
    /// The material, with those of the offered terms that the measurements need.
    pub relaxation: Relaxation,
    /// Root of the mean of |E*_fit − E*|²/|E*|² over the rows; of E(t) likewise.
    pub rms_residual: f64,
    /// The largest |E*_fit − E*|/|E*| of a row.
    pub largest_residual: f64,
}

impl RelaxationFit {
    /// The most terms of a fit; data that are good to a percent tell two or three in a decade apart.
    pub const MOST_TERMS: usize = 100;

    /// Fits a spectrum with relaxation times spread evenly, on a logarithmic scale, over the measured range: from 1/ω
    /// of the highest frequency to 1/ω of the lowest, or from the shortest time to the longest, a single one in the
    /// middle.
    ///
    /// E∞ and the E_i are the non-negative numbers that make Σ |E*_fit − E*|²/|E*|² smallest, or Σ (E_fit − E)²/E². No
    /// E_i can be negative in a material that only dissipates, and without that condition the terms would swing between
    /// large numbers of both signs. What comes out as zero is dropped.
    ///
    /// # Errors
    /// [`RelaxationFitError`] if the number of terms is not from 1 to [`MOST_TERMS`](Self::MOST_TERMS) or is more
    /// than the rows can tell, or if E∞ or all E_i come out as zero.
    pub fn new(measurements: &Measurements, terms: usize) -> Result<Self, RelaxationFitError> {
        let rows = measurements.rows();
        if !(1..=Self::MOST_TERMS).contains(&terms) {
            return Err(RelaxationFitError::Terms { terms });
        }
        let numbers = measurements.numbers();
        if terms >= numbers {
            return Err(RelaxationFitError::TooFewNumbers { terms, numbers });
        }
        let offered = offered(measurements.rates(), terms);
        // All unknowns over the largest modulus, so that they and their equations are numbers around 1.
        let unit = rows.iter().map(Measurement::size).fold(0.0, f64::max);
        let (matrix, right) = equations(rows, &offered, unit);
        let (solution, _) = nnls(matrix.view(), right.view());
        let modulus = |unknown: usize| unit * solution[unknown];
        if modulus(0) == 0.0 {
            return Err(RelaxationFitError::Liquid);
        }
        let terms = offered.iter().enumerate().map(|(i, term)| RelaxationTerm { modulus: modulus(i + 1), ..*term });
        let terms: Vec<RelaxationTerm> = terms.filter(|term| term.modulus > 0.0).collect();
        if terms.is_empty() {
            return Err(RelaxationFitError::Elastic);
        }
        let relaxation = Relaxation::new(modulus(0), terms)?;
        let residuals: Vec<f64> = rows.iter().map(|row| relaxation.residual(row)).collect();
        let squares: f64 = residuals.iter().map(|residual| residual * residual).sum();
        Ok(Self {
            relaxation,
            rms_residual: (squares / rows.len() as f64).sqrt(),
            largest_residual: residuals.into_iter().fold(0.0, f64::max),
        })
    }
}

/// Why no material was fitted to measurements.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RelaxationFitError {
    /// The number of terms is out of range.
    #[error("a fit has from 1 to {} terms, not {terms}", RelaxationFit::MOST_TERMS)]
    Terms {
        /// What was asked for.
        terms: usize,
    },
    /// There are more unknowns than numbers.
    #[error(
        "{terms} terms and the relaxed modulus are more than {numbers} measured moduli can tell; ask for {} terms or \
         fewer",
        numbers - 1
    )]
    TooFewNumbers {
        /// The terms asked for.
        terms: usize,
        /// The moduli there are, storage and loss counting twice.
        numbers: usize,
    },
    /// The measurements leave no relaxed modulus.
    #[error(
        "the best fit has no relaxed modulus: as far as it was measured the material is a liquid, which carries \
         no load at rest. Measure at lower frequencies or longer times, until the modulus levels off, or leave out \
         the rows at the lowest ones"
    )]
    Liquid,
    /// The measurements show no relaxation.
    #[error("the best fit has no relaxation: as far as it was measured the material is elastic, f = 0")]
    Elastic,
    /// The result is not a material.
    #[error("the best fit is none that can be computed with: {0}")]
    Material(#[from] MaterialError),
}

/// Terms of modulus 1 with the times of the fit, ascending.
fn offered(rates: (f64, f64), terms: usize) -> Vec<RelaxationTerm> {
    let ends = (-rates.1.ln(), -rates.0.ln());
    let part = |i: usize| if terms == 1 { 0.5 } else { i as f64 / (terms - 1) as f64 };
    let time = |i: usize| (ends.0 + part(i) * (ends.1 - ends.0)).exp();
    (0..terms).map(|i| RelaxationTerm { modulus: 1.0, time: time(i) }).collect()
}

/// Two equations for each row, storage and loss, over |E*|; the second one of a row of E(t) is 0 = 0. The first unknown
/// is E∞ and the others are the E_i, over `unit`.
fn equations(rows: &[Measurement], offered: &[RelaxationTerm], unit: f64) -> (Array2<f64>, Array1<f64>) {
    let entry = |(equation, unknown): (usize, usize)| {
        let row = &rows[equation / 2];
        let response = match unknown {
            0 => [1.0, 0.0],
            term => offered[term - 1].response_at(row),
        };
        unit / row.size() * response[equation % 2]
    };
    let right = |equation: usize| {
        let row = &rows[equation / 2];
        row.moduli()[equation % 2] / row.size()
    };
    let count = 2 * rows.len();
    (Array2::from_shape_fn((count, offered.len() + 1), entry), Array1::from_shape_fn(count, right))
}
