//! The limits that are published beside solutions.

use super::dry::DryContact;
use super::dry_gradient::DryGradient;
use super::large_beta::LargeBeta;
use crate::model::{Limits, Parameters};

/// The limits of one case after the other. What does not depend on β is kept as long as α, f and substrate stay.
#[derive(Clone, Debug, Default)]
pub struct ChainLimits {
    /// A case with these α, f and substrate, its dry contact and the pressure gradient there.
    dry: Option<(Parameters, DryContact, DryGradient)>,
}

impl ChainLimits {
    /// The limits of a case; NaN for several retardation times, where there is no closed form.
    pub fn of(&mut self, case: &Parameters) -> Limits {
        let same =
            |known: &Parameters| (known.alpha, known.f) == (case.alpha, case.f) && known.substrate == case.substrate;
        let dry = match self.dry.take().filter(|(known, ..)| same(known)) {
            Some(dry) => dry,
            None => match DryContact::of(case) {
                Some(contact) => (case.clone(), contact, DryGradient::new(&contact)),
                None => return Limits::UNKNOWN,
            },
        };
        let (_, contact, gradient) = self.dry.insert(dry);
        let Some(approximation) = LargeBeta::on(*contact, case) else { return Limits::UNKNOWN };
        Limits { dry_mu_v: approximation.approx_mu_v(), approx_mu_h: approximation.shear(gradient) }
    }
}

/// The limits of one case; NaN for several retardation times, where there is no closed form.
pub fn limits(parameters: &Parameters) -> Limits {
    ChainLimits::default().of(parameters)
}
