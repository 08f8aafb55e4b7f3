//! The section `[laboratory]` of a sweep file: quantities with units in place of α and β.

use super::sections::section;
use super::substrate::MaterialDefaults;
use crate::{Given, LaboratoryAxes};
use stribeck_input::{Entry, Fault, Quantity, Section, Varying, read_varying};
use stribeck_lab::LaboratoryQuantity;

/// Most places of a sweep over quantities of the laboratory: each of them is looked at when it is planned.
const MOST_PLACES: u128 = 10_000_000;

/// Reads `[laboratory]`; `axis_of_f` is f of `[axes]`, if it stands there.
pub(super) fn read(
    entry: &Entry<'_>,
    axis_of_f: Option<Vec<f64>>,
    material: &MaterialDefaults,
) -> Result<LaboratoryAxes, Fault> {
    let section = section(entry)?;
    let f = read_strengths(&section, axis_of_f, material)?;
    let mut given = Vec::new();
    for quantity in LaboratoryQuantity::ALL {
        let read = read_quantity(&section, quantity, material, &f)?;
        let Some(varying) = read else { continue };
        let speed = quantity == LaboratoryQuantity::Speed;
        given.push(match varying {
            Varying::Fixed(value) => Given { quantity, values: vec![value], is_axis: speed },
            Varying::Axis(values) => Given { quantity, values, is_axis: true },
        });
    }
    let axes = LaboratoryAxes { f, given };
    let lengths = axes.dimensions().into_iter().map(|dimension| dimension.values.len() as u128);
    let places = lengths.fold(1, u128::saturating_mul);
    if places > MOST_PLACES {
        let what = format!("a sweep over quantities of the laboratory may have at most {MOST_PLACES} cases");
        let help = "take fewer points, or split the sweep into several";
        return Err(section.fault(what, format!("{:.1e} cases", places as f64), help));
    }
    Ok(axes)
}

/// f, from `[laboratory]`, from `[axes]`, or that of the material.
fn read_strengths(
    section: &Section<'_>,
    axis_of_f: Option<Vec<f64>>,
    material: &MaterialDefaults,
) -> Result<Vec<f64>, Fault> {
    match (section.get("f"), axis_of_f, material.f) {
        (Some(entry), Some(_), _) => {
            let help = "remove one of the two";
            Err(entry.fault("f may stand in [laboratory] or in [axes], not in both", "also in [axes]", help))
        }
        (Some(entry), None, _) => Ok(match read_varying(&entry, Quantity::Strength)? {
            Varying::Fixed(value) => vec![value],
            Varying::Axis(values) => values,
        }),
        (None, Some(values), _) => Ok(values),
        (None, None, Some(f)) => Ok(vec![f]),
        (None, None, None) => {
            let help = "add f = 10.0, say: f = E0/Einf - 1, the instantaneous modulus over the relaxed one, less 1; or \
                        describe the material by `relaxation` in [substrate]";
            Err(section.fault("[laboratory] needs `f`, which is missing", "`f` is missing", help))
        }
    }
}

/// Reads a quantity; `None` for the modulus that is not given.
fn read_quantity(
    section: &Section<'_>,
    quantity: LaboratoryQuantity,
    material: &MaterialDefaults,
    f: &[f64],
) -> Result<Option<Varying>, Fault> {
    use LaboratoryQuantity as Q;
    if let Some(entry) = section.get(quantity.name()) {
        if quantity == Q::InstantaneousModulus && section.get(Q::RelaxedModulus.name()).is_some() {
            let what = "[laboratory] may have `relaxed_modulus` or `instantaneous_modulus`, not both";
            let help = "remove one of the two: the other one follows from f";
            return Err(entry.fault(what, "both are there", help));
        }
        return read_varying(&entry, quantity).map(Some);
    }
    let default = match quantity {
        Q::RelaxedModulus if section.get(Q::InstantaneousModulus.name()).is_some() => return Ok(None),
        Q::RelaxedModulus => material.relaxed_modulus,
        Q::InstantaneousModulus => return Ok(None),
        // An elastic substrate responds at once: α = ∞.
        Q::RetardationTime => material.retardation_time.or((f == [0.0]).then_some(0.0)),
        _ => None,
    };
    match default {
        Some(value) => Ok(Some(Varying::Fixed(value))),
        None => {
            let example = match quantity {
                Q::Radius => "radius = \"2 mm\"",
                Q::Load => "load = \"119 N/m\"",
                Q::RelaxedModulus | Q::InstantaneousModulus => {
                    "relaxed_modulus = \"100 kPa\" (or instantaneous_modulus)"
                }
                Q::PoissonRatio => "poisson_ratio = 0.5",
                Q::Viscosity => "viscosity = \"5.1 Pa s\"",
                Q::RetardationTime => "retardation_time = \"20 ms\"",
                Q::Speed => "speed = { from = \"0.1 mm/s\", to = \"100 mm/s\", points = 31, scale = \"log\" }",
            };
            let help = format!("add {example}");
            section.require(quantity.name(), &help).map(|_| None)
        }
    }
}
