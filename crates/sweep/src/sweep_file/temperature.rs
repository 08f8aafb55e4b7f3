//! Laws of temperature in a sweep file: `shift` of a body, and a viscosity that changes.

use stribeck_input::{Entry, Fault, RANGE_KEYS, Readings, Section, Values, each};
use stribeck_lab::{Dimension, LaboratoryQuantity, ShiftLaw, ViscosityLaw, ViscosityTable};

const SHIFT: &str = "write shift = { law = \"wlf\", c1 = 17.4, c2 = \"51.6 K\", reference = \"20 degC\" }, or \
                     { law = \"arrhenius\", activation_energy = \"80 kJ/mol\", reference = \"20 degC\" }";
const VISCOSITY: &str = "write viscosity = { law = \"arrhenius\", value = \"0.1 Pa s\", activation_energy = \"30 kJ/mol\", \
                         reference = \"40 degC\" }, { law = \"vogel\", value = \"0.1 Pa s\", b = \"900 K\", c = \"170 K\", \
                         reference = \"40 degC\" }, or { table = [{ temperature = \"40 degC\", value = \"0.1 Pa s\" }, \
                         { temperature = \"100 degC\", value = \"12 mPa s\" }] }";

/// The laws of `shift` by name, with the keys that each has beside `law` and `reference`.
pub(super) const SHIFT_LAWS: [(&str, &[&str]); 2] = [("wlf", &["c1", "c2"]), ("arrhenius", &["activation_energy"])];
/// The laws of a viscosity by name, with the keys that each has beside `law`, `value` and `reference`.
pub(super) const VISCOSITY_LAWS: [(&str, &[&str]); 2] = [("vogel", &["b", "c"]), ("arrhenius", &["activation_energy"])];

/// Reads `shift`: how the times of a body change with temperature.
pub(super) fn read_shift(entry: &Entry<'_>) -> Result<ShiftLaw, Fault> {
    let law = entry.section(&["law", "c1", "c2", "activation_energy", "reference"], |_| None)?;
    let [(wlf, of_wlf), (arrhenius, of_arrhenius)] = SHIFT_LAWS;
    let is_wlf = law.require("law", SHIFT).and_then(|entry| entry.choice(&[(wlf, true), (arrhenius, false)]));
    let (is_wlf, reference) = (is_wlf, temperature(&law, "reference", SHIFT)).all()?;
    // With keys of another law it may be that one that was meant.
    refuse(&law, if is_wlf { of_arrhenius } else { of_wlf }, SHIFT)?;
    match is_wlf {
        true => {
            let own = (positive(&law, "c1", SHIFT), difference(&law, "c2", SHIFT)).all();
            own.map(|(c1, c2)| ShiftLaw::Wlf { c1, c2, reference })
        }
        false => {
            activation_energy(&law, SHIFT).map(|activation_energy| ShiftLaw::Arrhenius { activation_energy, reference })
        }
    }
}

/// Reads a viscosity that changes with temperature: its value at the law's reference, and the law; `None` if the entry
/// is a number or an axis.
pub(super) fn read_viscosity(entry: &Entry<'_>) -> Result<Option<(f64, ViscosityLaw)>, Fault> {
    const OF_LAW: [&str; 7] = ["law", "value", "activation_energy", "b", "c", "reference", "table"];
    if !entry.is_section() {
        return Ok(None);
    }
    // What is neither is told by the reader of axes.
    let Ok(either) = entry.section(&[&OF_LAW[..], &RANGE_KEYS].concat(), |_| None) else { return Ok(None) };
    if OF_LAW.iter().all(|key| either.get(key).is_none()) {
        return Ok(None);
    }
    let law = entry.section(&OF_LAW, |_| None)?;
    if let Some(table) = law.get("table") {
        let (_, table) = (refuse(&law, &OF_LAW[..OF_LAW.len() - 1], VISCOSITY), read_table(&table)).all()?;
        return Ok(Some((table.first(), ViscosityLaw::Table(table))));
    }
    let [(vogel, of_vogel), (arrhenius, of_arrhenius)] = VISCOSITY_LAWS;
    let is_vogel = law.require("law", VISCOSITY).and_then(|it| it.choice(&[(vogel, true), (arrhenius, false)]));
    let value = law.require("value", VISCOSITY).and_then(|entry| Dimension::Viscosity.read(&entry));
    let (is_vogel, value, reference) = (is_vogel, value, temperature(&law, "reference", VISCOSITY)).all()?;
    refuse(&law, if is_vogel { of_arrhenius } else { of_vogel }, VISCOSITY)?;
    let found = match is_vogel {
        true => {
            let (b, c) = (difference(&law, "b", VISCOSITY), difference(&law, "c", VISCOSITY)).all()?;
            if c >= reference {
                let what = "`c` of Vogel's law must be below the reference: the fluid is solid there";
                return Err(law.require("c", VISCOSITY)?.fault(what, "not below the reference", VISCOSITY));
            }
            ViscosityLaw::Vogel { b, c, reference }
        }
        false => ViscosityLaw::Arrhenius { activation_energy: activation_energy(&law, VISCOSITY)?, reference },
    };
    Ok(Some((value, found)))
}

fn read_table(entry: &Entry<'_>) -> Result<ViscosityTable, Fault> {
    let point = |entry: Entry<'_>| {
        let point = entry.section(&["temperature", "value"], |_| None)?;
        let viscosity = point.require("value", VISCOSITY).and_then(|entry| Dimension::Viscosity.read(&entry));
        (temperature(&point, "temperature", VISCOSITY), viscosity).all()
    };
    let points = each(entry.require_list(VISCOSITY)?.map(point))?;
    ViscosityTable::new(&points).ok_or_else(|| {
        let what = format!("a table of viscosities has 2 to {} temperatures, which ascend", ViscosityTable::MOST);
        entry.fault(what, "no such table", VISCOSITY).unquoted()
    })
}

/// Refuses keys of another law.
fn refuse(law: &Section<'_>, keys: &[&str], help: &str) -> Result<(), Fault> {
    let others = keys.iter().filter_map(|key| law.get(key));
    let faults = others.map(|it| it.fault(format!("`{}` belongs to another law", it.path()), "of another law", help));
    Fault::of_all(faults).map_or(Ok(()), Err)
}

fn temperature(section: &Section<'_>, key: &str, help: &str) -> Result<f64, Fault> {
    LaboratoryQuantity::Temperature.read(&section.require(key, help)?)
}

fn positive(section: &Section<'_>, key: &str, help: &str) -> Result<f64, Fault> {
    let entry = section.require(key, help)?;
    let value = entry.number()?;
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err(entry.not_allowed("finite and above 0", help)) }
}

/// A difference of temperatures in K: a number, or one with a unit.
fn difference(section: &Section<'_>, key: &str, help: &str) -> Result<f64, Fault> {
    let unit = |unit: &str| Dimension::Temperature.conversion(unit).map(|unit| unit.of_difference(1.0));
    with_unit(&section.require(key, help)?, "a difference of temperatures, in K or with a unit, as \"51.6 K\"", unit)
}

/// An activation energy in J/mol: a number, or one with a unit.
fn activation_energy(section: &Section<'_>, help: &str) -> Result<f64, Fault> {
    let unit = |unit: &str| match unit {
        "J/mol" => Some(1.0),
        "kJ/mol" => Some(1e3),
        "kcal/mol" => Some(4184.0),
        _ => None,
    };
    let entry = section.require("activation_energy", help)?;
    with_unit(&entry, "an energy, in J/mol or with a unit, as \"80 kJ/mol\"", unit)
}

/// A number above 0, alone or with a unit behind it.
fn with_unit(entry: &Entry<'_>, what: &str, unit: impl Fn(&str) -> Option<f64>) -> Result<f64, Fault> {
    let value = if entry.is_text() {
        let text = entry.text()?.trim();
        let end = text.rfind(|c: char| c.is_ascii_digit() || c == '.').map_or(0, |last| last + 1);
        let number = text[..end].trim().parse::<f64>().ok();
        number.zip(unit(text[end..].trim())).map(|(number, unit)| number * unit)
    } else {
        Some(entry.number()?)
    };
    let value = value.filter(|value| *value > 0.0 && value.is_finite());
    value.ok_or_else(|| entry.fault(format!("`{}` must be {what}", entry.path()), "not that", "a number above 0"))
}
