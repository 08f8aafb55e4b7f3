//! The section `[laboratory]` of a sweep file: quantities with units in place of α and β.

use super::bodies::ReadBodies;
use super::modulus;
use super::sections::section;
use super::substrate::MaterialDefaults;
use super::temperature::read_viscosity;
use crate::{Given, LaboratoryAxes, ModelLimits};
use stribeck_input::{Entry, Fault, Quantity, Readings, Section, Values, Varying, read_varying};
use stribeck_lab::{Dimension, LaboratoryQuantity, TemperatureLaws, Turning, ViscosityLaw};

/// Most places of a sweep over quantities of the laboratory: each of them is looked at when it is planned.
const MOST_PLACES: u128 = 10_000_000;

/// Reads `[laboratory]`; `axis_of_f` is f of `[axes]`, if it stands there.
pub(super) fn read(
    entry: &Entry<'_>,
    axis_of_f: Result<Option<Vec<f64>>, Fault>,
    bodies: &ReadBodies,
) -> Result<LaboratoryAxes, Fault> {
    let section = section(entry)?;
    let softness = match bodies.flat_is_rigid {
        true => refuse_softness(&section, matches!(axis_of_f, Ok(Some(_)))),
        false => Ok(()),
    };
    let f = axis_of_f.and_then(|axis| read_strengths(&section, axis, bodies));
    let viscosity = section.optional(LaboratoryQuantity::Viscosity.name(), read_viscosity).map(Option::flatten);
    let (mut given, faults) = read_given(&section, bodies, f.as_deref().unwrap_or(&[0.0]), &viscosity);
    let laws = viscosity.map(|law| TemperatureLaws {
        flat: bodies.shifts[0],
        roller: bodies.shifts[1],
        viscosity: law.map(|(_, law)| law),
    });
    let temperatures = laws.as_ref().map_or(Ok(()), |laws| check_temperatures(&section, &given, laws));
    let moves = check_that_something_moves(&section, &given);
    let swap = read_swap(&section, &mut given);
    let length = |key: &str| section.optional(key, |entry| Dimension::Length.read(entry));
    let limits = (length("roughness"), length("thickness")).all();
    let checks = (softness, temperatures, moves, faults.map_or(Ok(()), Err)).all();
    let (f, laws, swap, (roughness, thickness), _) = (f, laws, swap, limits, checks).all()?;
    let (roller, roller_spectrum) = (bodies.roller, bodies.roller_spectrum.clone());
    let limits = ModelLimits { roughness, thickness };
    let axes = LaboratoryAxes { f, given, roller, roller_spectrum, swap, limits, laws };
    let lengths = axes.dimensions().into_iter().map(|dimension| dimension.values.len() as u128);
    let places = lengths.fold(1, u128::saturating_mul);
    if places > MOST_PLACES {
        let what = format!("a sweep over quantities of the laboratory may have at most {MOST_PLACES} cases");
        let help = "take fewer points, or split the sweep into several";
        return Err(section.fault(what, format!("{:.1e} cases", places as f64), help));
    }
    Ok(axes)
}

/// A viscosity that changes, as it was read.
type ReadViscosity = Result<Option<(f64, ViscosityLaw)>, Fault>;

/// The quantities that can be read, and what is wrong with the others.
fn read_given(
    section: &Section<'_>,
    bodies: &ReadBodies,
    f: &[f64],
    viscosity: &ReadViscosity,
) -> (Vec<Given>, Option<Fault>) {
    use LaboratoryQuantity as Q;
    let is_there = |quantity: &Q| section.get(quantity.name()).is_some();
    let (speeds, two_forms) = match form_of_motion(section) {
        Ok(form) => (form.to_vec(), None),
        // Their values can be wrong all the same.
        Err(fault) => (Q::SPEEDS.into_iter().filter(is_there).collect(), Some(fault)),
    };
    let (mut given, mut faults) = (Vec::new(), Vec::from_iter(two_forms));
    for quantity in Q::ALL.into_iter().filter(|it| !Q::SPEEDS.contains(it) || speeds.contains(it)) {
        let read = match viscosity {
            Ok(Some((value, _))) if quantity == Q::Viscosity => Ok(Some(Varying::Fixed(*value))),
            Err(fault) if quantity == Q::Viscosity => Err(fault.clone()),
            _ => read_quantity(section, quantity, &bodies.flat, f),
        };
        // Results run along the last speed, be it one number.
        let last = speeds.last() == Some(&quantity);
        match read {
            Ok(Some(Varying::Fixed(value))) => given.push(Given { quantity, values: vec![value], is_axis: last }),
            Ok(Some(Varying::Axis(values))) => given.push(Given { quantity, values, is_axis: true }),
            Ok(None) => {}
            Err(fault) => faults.push(fault),
        }
    }
    (given, Fault::of_all(faults))
}

/// The speeds of the form of motion that the section gives.
fn form_of_motion(section: &Section<'_>) -> Result<&'static [LaboratoryQuantity], Fault> {
    use LaboratoryQuantity as Q;
    const FORMS: [&[Q]; 3] = [&[Q::Speed], &[Q::SlideRollRatio, Q::EntrainmentSpeed], &[Q::RollerSpeed, Q::FlatSpeed]];
    let is_there = |quantity: &&Q| section.get(quantity.name()).is_some();
    let mut forms = FORMS.into_iter().filter(|form| form.iter().any(|quantity| is_there(&quantity)));
    let form = forms.next().unwrap_or(FORMS[0]);
    if let Some(other) = forms.next() {
        let [one, other] = [form, other].map(|form| form.iter().find(is_there).expect("one of them is there").name());
        let entry = section.get(other).expect("it is there");
        let help = "give `speed` (the roller slides without turning), or `entrainment_speed` and `slide_roll_ratio`, or \
                    `roller_speed` and `flat_speed`";
        let what = format!("`{one}` and `{other}` are two ways to say how fast the surfaces move");
        return Err(entry.fault(what, format!("beside `{one}`"), help));
    }
    Ok(form)
}

/// Refuses temperatures that change nothing, or that a law does not hold at.
fn check_temperatures(section: &Section<'_>, given: &[Given], laws: &TemperatureLaws) -> Result<(), Fault> {
    let Some(entry) = section.get(LaboratoryQuantity::Temperature.name()) else { return Ok(()) };
    if *laws == TemperatureLaws::default() {
        let what = "nothing changes with `laboratory.temperature`";
        let help = "give [flat] a `shift`, or the viscosity a law, or remove the temperature";
        return Err(entry.fault(what, "without a law", help).unquoted());
    }
    let temperatures = given.iter().filter(|given| given.quantity == LaboratoryQuantity::Temperature);
    let Some(outside) = temperatures.flat_map(|given| &given.values).find(|value| !laws.admit(**value)) else {
        return Ok(());
    };
    let what = format!("a law of temperature has no value at {outside} K");
    let help = "a table of viscosities holds between its ends, the law of WLF above its reference less c2";
    Err(entry.fault(what, "beyond a law", help).unquoted())
}

/// Refuses moduli and times of a flat that is rigid.
fn refuse_softness(section: &Section<'_>, has_axis_of_f: bool) -> Result<(), Fault> {
    let others = ["poisson_ratio", "retardation_time", "f"];
    let keys = modulus::KEYS.map(|(key, ..)| key).into_iter().chain(others);
    let what = "says nothing of a rigid flat";
    let help = "remove it, or `rigid` from the flat";
    let entries = keys.filter_map(|key| section.get(key));
    let faults = entries.map(|it| it.fault(format!("`{}` {what}", it.path()), "beside a rigid flat", help));
    let axis = has_axis_of_f.then(|| section.fault(format!("`axes.f` {what}"), "beside a rigid flat", help));
    Fault::of_all(faults.chain(axis)).map_or(Ok(()), Err)
}

/// Reads `swap`: each slide-to-roll ratio gets the opposite one beside it.
fn read_swap(section: &Section<'_>, given: &mut [Given]) -> Result<bool, Fault> {
    let Some(entry) = section.get("swap") else { return Ok(false) };
    if !entry.boolean()? {
        return Ok(false);
    }
    if section.get(LaboratoryQuantity::SlideRollRatio.name()).is_none() {
        let what = "`swap` runs each case with the faster and the slower body swapped, for which it needs \
                    `slide_roll_ratio`";
        let help = "give `entrainment_speed` and `slide_roll_ratio` in place of the other speeds, or remove `swap`";
        return Err(entry.fault(what, "without a slide-to-roll ratio", help));
    }
    let ratio = given.iter_mut().find(|given| given.quantity == LaboratoryQuantity::SlideRollRatio);
    // It has a fault of its own.
    let Some(ratio) = ratio else { return Ok(true) };
    if ratio.values[0] < 0.0 {
        let what = "with `swap` ratios are given from 0 on: the opposite ones are added";
        let help = "leave out the ratios below 0";
        let entry = section.require(LaboratoryQuantity::SlideRollRatio.name(), help)?;
        return Err(entry.fault(what, "below 0", help).unquoted());
    }
    let opposite = ratio.values.iter().rev().filter(|value| **value > 0.0).map(|value| -value);
    ratio.values = opposite.chain(ratio.values.iter().copied()).collect();
    ratio.is_axis = true;
    Ok(true)
}

/// Refuses places at which neither surface moves.
fn check_that_something_moves(section: &Section<'_>, given: &[Given]) -> Result<(), Fault> {
    use LaboratoryQuantity as Q;
    let rests = |quantity: Q| given.iter().any(|given| given.quantity == quantity && given.values[0] == 0.0);
    if !(rests(Q::RollerSpeed) && rests(Q::FlatSpeed)) {
        return Ok(());
    }
    let entry = section.get(Q::FlatSpeed.name()).expect("it was read");
    let what = "`roller_speed` and `flat_speed` are both 0 somewhere: nothing drives a film there";
    Err(entry.fault(what, "0 beside a roller at rest", "begin one of the two above 0"))
}

/// f, from `[laboratory]`, from `[axes]`, or that of the material.
fn read_strengths(section: &Section<'_>, axis_of_f: Option<Vec<f64>>, bodies: &ReadBodies) -> Result<Vec<f64>, Fault> {
    match (section.get("f"), axis_of_f, bodies.flat.f) {
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
        (None, None, None) if bodies.flat_is_elastic && section.get("retardation_time").is_none() => Ok(vec![0.0]),
        (None, None, None) => {
            let help = "add f = 10.0, say: f = E0/Einf - 1, the instantaneous modulus over the relaxed one, less 1; or \
                        describe the material by `relaxation` in [flat]";
            Err(section.fault("[laboratory] needs `f`, which is missing", "`f` is missing", help))
        }
    }
}

/// The radius by which turns of the cylinder are speeds, or why there is none; what is wrong with it is told with it.
fn one_radius(section: &Section<'_>) -> Result<f64, &'static str> {
    let Some(entry) = section.get(LaboratoryQuantity::Radius.name()) else { return Err("none is given") };
    match read_varying(&entry, LaboratoryQuantity::Radius) {
        Ok(Varying::Fixed(radius)) => Ok(radius),
        Ok(Varying::Axis(radii)) if radii.len() == 1 => Ok(radii[0]),
        Ok(Varying::Axis(_)) => Err("this sweep has several"),
        Err(_) => Err("that of this sweep cannot be read"),
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
    let is_modulus = matches!(quantity, Q::RelaxedModulus | Q::InstantaneousModulus);
    if let Some(given) = if is_modulus { modulus::find(section, "laboratory")? } else { None } {
        let is_this = given.quantity == quantity;
        return is_this.then(|| modulus::read_young(section, material, &given)).transpose();
    }
    if let Some(entry) = section.get(quantity.name()) {
        return read_varying(&entry, Turning::new(quantity, one_radius(section))).map(Some);
    }
    let young = |modulus: f64| Ok(modulus * modulus::young_factor(section, material, material.kind)?);
    let default = match quantity {
        Q::RelaxedModulus if material.instantaneous_modulus.is_some() => return Ok(None),
        Q::RelaxedModulus => material.relaxed_modulus.map(young).transpose()?,
        Q::InstantaneousModulus if material.instantaneous_modulus.is_none() => return Ok(None),
        Q::InstantaneousModulus => material.instantaneous_modulus.map(young).transpose()?,
        Q::PoissonRatio => material.poisson_ratio,
        Q::Temperature => return Ok(None),
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
                Q::Temperature => "temperature = \"20 degC\"",
                Q::Speed => "speed = { from = \"0.1 mm/s\", to = \"100 mm/s\", points = 31, scale = \"log\" }",
                Q::EntrainmentSpeed => {
                    "entrainment_speed = { from = \"0.1 mm/s\", to = \"100 mm/s\", points = 31, scale = \"log\" }"
                }
                Q::SlideRollRatio => "slide_roll_ratio = 0.5 # (flat - roller) / entrainment speed",
                Q::RollerSpeed => "roller_speed = \"1 mm/s\"",
                Q::FlatSpeed => "flat_speed = { from = \"0.1 mm/s\", to = \"100 mm/s\", points = 31, scale = \"log\" }",
            };
            let help = format!("add {example}");
            section.require(quantity.name(), &help).map(|_| None)
        }
    }
}
