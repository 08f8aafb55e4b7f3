//! What measurements do not tell of a fitted material.

use super::measurement::{Measurement, Measurements};
use super::relaxation::Relaxation;

/// E∞ over the lowest modulus measured, below which it is called extrapolated.
const EXTRAPOLATED: f64 = 0.5;
/// The part of the modulus lost over the slowest decade, above which it is called not levelled off.
const FALLS: f64 = 1.0 / 3.0;

/// Why E∞ of a fit, and f with it, may be no property of the material.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Doubt {
    /// At the lowest frequency more is lost than stored.
    #[error(
        "at the lowest frequency, {omega:.3e} rad/s, the loss modulus is {ratio:.2} times the storage modulus: as far as \
         it was measured the material is a liquid. Einf and f are extrapolated, and there may be none; measure at lower \
         frequencies"
    )]
    Flows {
        /// The lowest ω, in rad/s.
        omega: f64,
        /// E″/E′ there.
        ratio: f64,
    },
    /// The relaxed modulus lies far below what was measured.
    #[error(
        "Einf is {part:.2} of the lowest {what} measured: Einf and f are extrapolated; measure at {slower}, until the \
         modulus levels off"
    )]
    Extrapolated {
        /// E∞ over that modulus.
        part: f64,
        /// Which modulus it is.
        what: &'static str,
        /// What to measure at.
        slower: &'static str,
    },
    /// The modulus has not levelled off.
    #[error(
        "over the slowest decade the {what} still falls by {:.0} %: what it falls to is not known, and Einf and f are \
         extrapolated; measure at {slower}",
        100.0 * part
    )]
    Falls {
        /// The part that it loses.
        part: f64,
        /// Which modulus it is.
        what: &'static str,
        /// What to measure at.
        slower: &'static str,
    },
}

impl Doubt {
    /// What is doubtful in a material that fits these measurements.
    pub fn about(relaxation: &Relaxation, measurements: &Measurements) -> Option<Self> {
        let lowest = &measurements.rows()[0];
        let [stiffness, loss] = lowest.moduli();
        if loss > stiffness {
            return Some(Self::Flows { omega: lowest.rate(), ratio: loss / stiffness });
        }
        let part = relaxation.relaxed_modulus() / stiffness;
        let (what, slower) = match lowest {
            Measurement::Oscillation { .. } => ("storage modulus", "lower frequencies"),
            Measurement::Relaxation { .. } => ("relaxation modulus", "longer times"),
        };
        if part < EXTRAPOLATED {
            return Some(Self::Extrapolated { part, what, slower });
        }
        let (from, to) = measurements.rates();
        let decade = (to / from).min(10.0);
        let [low, high] = [1.0, decade].map(|factor| relaxation.answer(&lowest.faster(factor)).moduli()[0]);
        let part = 1.0 - (low / high).powf(1.0 / decade.log10());
        (part > FALLS).then_some(Self::Falls { part, what, slower })
    }
}
