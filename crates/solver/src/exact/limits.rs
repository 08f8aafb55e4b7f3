//! The limits that are published beside solutions.

use std::panic::{AssertUnwindSafe, catch_unwind};

use super::dry::DryContact;
use super::dry_gradient::DryGradient;
use super::dry_modes::DrySliding;
use super::large_beta::LargeBeta;
use crate::model::{Limits, Parameters};

/// The limits of one case after the other. What does not depend on β is kept as long as α, f and substrate stay.
#[derive(Clone, Debug, Default)]
pub struct ChainLimits {
    /// A case with these α, f and substrate, and its dry contact.
    dry: Option<(Parameters, Dry)>,
}

/// What is known of a dry contact.
#[derive(Clone, Debug)]
enum Dry {
    /// With one retardation time: everything, the pressure gradient too.
    Closed(DryContact, Box<DryGradient>),
    /// With several: its friction.
    Several(DrySliding),
}

impl Dry {
    fn of(case: &Parameters) -> Self {
        match DryContact::of(case) {
            Some(contact) => Self::Closed(contact, Box::new(DryGradient::new(&contact))),
            None => Self::Several(DrySliding::of(case)),
        }
    }

    fn friction(&self) -> f64 {
        match self {
            Self::Closed(contact, _) => contact.friction(),
            Self::Several(sliding) => sliding.friction(),
        }
    }
}

impl ChainLimits {
    /// The limits of a case; [`Limits::UNKNOWN`] if double precision cannot represent the case, or their computation
    /// panics. The shear is NaN for several retardation times, where the dry pressure is not at hand.
    pub fn of(&mut self, case: &Parameters) -> Limits {
        if case.computable().is_err() {
            return Limits::UNKNOWN;
        }
        catch_unwind(AssertUnwindSafe(|| self.compute(case))).unwrap_or_else(|_| {
            *self = Self::default();
            Limits::UNKNOWN
        })
    }

    fn compute(&mut self, case: &Parameters) -> Limits {
        let same =
            |known: &Parameters| (known.alpha, known.f) == (case.alpha, case.f) && known.substrate == case.substrate;
        let dry = self.dry.take().filter(|(known, _)| same(known)).unwrap_or_else(|| (case.clone(), Dry::of(case)));
        let (_, dry) = self.dry.insert(dry);
        let shear = match dry {
            Dry::Closed(contact, gradient) => LargeBeta::on(*contact, case).map(|film| film.shear(gradient)),
            Dry::Several(_) => None,
        };
        Limits { dry_mu_v: dry.friction(), approx_mu_h: shear.unwrap_or(f64::NAN) }
    }
}

/// The limits of one case; see [`ChainLimits::of`].
pub fn limits(parameters: &Parameters) -> Limits {
    ChainLimits::default().of(parameters)
}
