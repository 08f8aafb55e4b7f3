//! Units of the quantities of a laboratory.

use stribeck_input::Dimension;

use crate::LaboratoryQuantity;

/// What a quantity measures; `None` for Poisson's ratio, which has no unit.
pub fn dimension(quantity: LaboratoryQuantity) -> Option<Dimension> {
    use LaboratoryQuantity as Q;
    match quantity {
        Q::Radius => Some(Dimension::Length),
        Q::Load => Some(Dimension::LineLoad),
        Q::RelaxedModulus | Q::InstantaneousModulus => Some(Dimension::Modulus),
        Q::PoissonRatio => None,
        Q::Viscosity => Some(Dimension::Viscosity),
        Q::RetardationTime => Some(Dimension::Time),
        Q::Speed => Some(Dimension::Speed),
    }
}

/// How many SI units a unit is, as one may write it for a quantity; `None` if it is none of that kind.
pub fn unit_factor(quantity: LaboratoryQuantity, unit: &str) -> Option<f64> {
    dimension(quantity)?.factor_of(unit)
}

/// A value in a unit of so many SI units.
pub fn in_si(value: f64, factor: f64) -> f64 {
    stribeck_input::product(value, factor)
}
