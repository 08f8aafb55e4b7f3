//! The modulus of a section: one of four keys, relaxed or instantaneous, Young's or shear.

use std::ops::Range;

use super::substrate::MaterialDefaults;
use stribeck_input::{Entry, Fault, Section, Varying, read_varying};
use stribeck_lab::{LaboratoryQuantity, ModulusKind};

/// The keys of moduli; the two that are none of [`LaboratoryQuantity`] are shear moduli.
pub(super) const KEYS: [(&str, LaboratoryQuantity, ModulusKind); 4] = [
    ("relaxed_modulus", LaboratoryQuantity::RelaxedModulus, ModulusKind::Young),
    ("instantaneous_modulus", LaboratoryQuantity::InstantaneousModulus, ModulusKind::Young),
    ("relaxed_shear_modulus", LaboratoryQuantity::RelaxedModulus, ModulusKind::Shear),
    ("instantaneous_shear_modulus", LaboratoryQuantity::InstantaneousModulus, ModulusKind::Shear),
];

/// A modulus as a section gives it.
pub(super) struct GivenModulus<'t> {
    /// The value.
    pub(super) entry: Entry<'t>,
    /// The relaxed or the instantaneous modulus.
    pub(super) quantity: LaboratoryQuantity,
    /// What it is of.
    pub(super) kind: ModulusKind,
}

/// The one modulus of the section `name`, if it has one.
pub(super) fn find<'t>(section: &Section<'t>, name: &str) -> Result<Option<GivenModulus<'t>>, Fault> {
    let mut given = KEYS.into_iter().filter_map(|(key, quantity, kind)| {
        section.get(key).map(|entry| (key, GivenModulus { entry, quantity, kind }))
    });
    let Some((one, modulus)) = given.next() else { return Ok(None) };
    match given.next() {
        None => Ok(Some(modulus)),
        Some((other, second)) => {
            let what = format!("[{name}] may have `{one}` or `{other}`, not both");
            let why =
                if name == "laboratory" { "the other one follows from f" } else { "the terms are the difference" };
            Err(second.entry.fault(what, "both are there", format!("remove one of the two: {why}")))
        }
    }
}

/// A key that says a modulus, and not which one.
pub(super) struct Ambiguous {
    /// The key that it may stand for.
    pub(super) meant: &'static str,
    help: &'static str,
}

impl Ambiguous {
    /// What a key of a section may mean, if it is one of these.
    pub(super) fn of(section: &str, key: &str) -> Option<Self> {
        if !matches!(section, "laboratory" | "substrate" | "flat" | "roller") {
            return None;
        }
        match key.to_lowercase().as_str() {
            "shear_modulus" | "g" => Some(Self {
                meant: "relaxed_shear_modulus",
                help: "write relaxed_shear_modulus or instantaneous_shear_modulus; relaxed_modulus and \
                       instantaneous_modulus are Young's modulus, 2 (1 + poisson_ratio) times as large: three times \
                       where Poisson's ratio is 0.5",
            }),
            "modulus" | "young_modulus" | "youngs_modulus" | "elastic_modulus" | "e" => Some(Self {
                meant: "relaxed_modulus",
                help: "write relaxed_modulus or instantaneous_modulus for Young's modulus, relaxed_shear_modulus or \
                       instantaneous_shear_modulus for the shear modulus; of an elastic body give the relaxed one",
            }),
            _ => None,
        }
    }

    /// The fault of such a key, whose value stands at `span`.
    pub(super) fn fault(&self, section: &str, key: &str, span: Range<usize>) -> Fault {
        let what = format!("`{section}.{key}` does not say which modulus it is: the one at once, or after a long time");
        Fault::new(span, what, "which of the two?", self.help)
    }
}

/// Young's modulus over the modulus of a kind, by Poisson's ratio of `[laboratory]`, or else that of the flat.
pub(super) fn young_factor(laboratory: &Section<'_>, flat: &MaterialDefaults, kind: ModulusKind) -> Result<f64, Fault> {
    if kind == ModulusKind::Young {
        return Ok(1.0);
    }
    let name = LaboratoryQuantity::PoissonRatio.name();
    if let Some(ratio) = flat.poisson_ratio.filter(|_| laboratory.get(name).is_none()) {
        return Ok(kind.young_factor(ratio));
    }
    let entry = laboratory.require(name, "add poisson_ratio = 0.5: Young's modulus is 2 (1 + nu) G")?;
    match read_varying(&entry, LaboratoryQuantity::PoissonRatio)? {
        Varying::Fixed(ratio) => Ok(kind.young_factor(ratio)),
        Varying::Axis(_) => {
            let what = format!("beside a shear modulus `{}` must be one number", entry.path());
            let help = "give Young's modulus, as relaxed_modulus: with a shear modulus it would change along this axis";
            Err(entry.fault(what, "an axis", help))
        }
    }
}

/// Young's moduli of the moduli that `[laboratory]` gives.
pub(super) fn read_young(
    laboratory: &Section<'_>,
    flat: &MaterialDefaults,
    modulus: &GivenModulus<'_>,
) -> Result<Varying, Fault> {
    let factor = young_factor(laboratory, flat, modulus.kind)?;
    Ok(match read_varying(&modulus.entry, modulus.quantity)? {
        Varying::Fixed(value) => Varying::Fixed(factor * value),
        Varying::Axis(values) => Varying::Axis(values.into_iter().map(|value| factor * value).collect()),
    })
}
