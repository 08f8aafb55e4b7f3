//! Why numbers are no material, or none that measurements ask for.

use super::fit::MOST_TERMS;
use stribeck_solver::Parameters;

/// Why a list of relaxation terms is no material.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MaterialError {
    /// No term at all.
    #[error("a viscoelastic material needs at least one relaxation term; without any it is elastic, f = 0")]
    Empty,
    /// A relaxed modulus that is not a positive number.
    #[error(
        "the relaxed modulus must be a number of pascals {}, not {value}: a material that relaxes to nothing is a liquid, and \
         carries no load at rest",
        allowed()
    )]
    RelaxedModulus {
        /// What was given.
        value: f64,
    },
    /// A modulus of a term that is not a positive number.
    #[error("relaxation term {term}: the modulus must be a number of pascals {}, not {value}", allowed())]
    Modulus {
        /// Place in the list, from 1.
        term: usize,
        /// What was given.
        value: f64,
    },
    /// A time of a term that is not a positive number.
    #[error("relaxation term {term}: the time must be a number of seconds {}, not {value}", allowed())]
    Time {
        /// Place in the list, from 1.
        term: usize,
        /// What was given.
        value: f64,
    },
}

fn allowed() -> String {
    let magnitudes = Parameters::MAGNITUDES;
    format!("from {:e} to {:e}", magnitudes.start(), magnitudes.end())
}

/// Why no material was fitted to measurements.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A number of terms that is none.
    #[error("a fit has from 1 to {MOST_TERMS} terms, not {terms}")]
    Terms {
        /// What was asked for.
        terms: usize,
    },
    /// More unknowns than numbers.
    #[error(
        "{terms} terms and the relaxed modulus are more than the {rows} rows of two moduli can tell; ask for {} terms or fewer",
        2 * rows - 1
    )]
    TooFewRows {
        /// The terms asked for.
        terms: usize,
        /// The rows there are.
        rows: usize,
    },
    /// Measurements that leave no relaxed modulus.
    #[error(
        "the best fit has no relaxed modulus: as far as it was measured the material is a liquid, which carries no load at rest. \
         Measure at lower frequencies, until the storage modulus levels off, or leave out the rows at the lowest ones"
    )]
    Liquid,
    /// Measurements without any relaxation.
    #[error("the best fit has no relaxation: as far as it was measured the material is elastic, f = 0")]
    Elastic,
    /// A result that is no material.
    #[error("the best fit is none that can be computed with: {0}")]
    Material(#[from] MaterialError),
}
