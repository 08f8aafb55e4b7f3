//! The section `[substrate]` of a sweep file.

use super::modulus;
use super::sections::section;
use stribeck_input::{Entry, Fault, Section, Values};
use stribeck_lab::{Dimension, LaboratoryQuantity, Material, ModulusKind, Relaxation, RelaxationTerm};
use stribeck_solver::{RetardationMode, Substrate};

/// Most terms of a relaxation.
const MOST_TERMS: usize = 1000;

const MODES: &str = "write modes = [{ share = 0.7, time = 1.0 }, { share = 0.3, time = 100.0 }]";
const TERMS: &str = "write relaxation = [{ modulus = \"0.5 MPa\", time = \"1 s\" }, \
                     { modulus = \"0.1 MPa\", time = \"10 s\" }], or { fraction = 0.3, time = \"1 s\" } with fractions of the instantaneous modulus";

/// Why there is no second modulus.
const ONE_MODULUS: &str = "the terms are the difference";

/// What a material says of itself, for what `[laboratory]` leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MaterialDefaults {
    /// E∞ or G∞ (Pa), and which of the two.
    pub relaxed_modulus: Option<(f64, ModulusKind)>,
    /// f.
    pub f: Option<f64>,
    /// τ (s).
    pub retardation_time: Option<f64>,
}

/// A substrate, and what it says of itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadSubstrate {
    /// The retardation spectrum.
    pub substrate: Substrate,
    /// Of a material: modulus, f and retardation time.
    pub material: MaterialDefaults,
}

/// Reads `[substrate]`: retardation modes, or a material by its relaxation.
pub fn read(entry: &Entry<'_>) -> Result<ReadSubstrate, Fault> {
    let section = section(entry)?;
    match (section.get("modes"), section.get("relaxation")) {
        (Some(_), Some(relaxation)) => {
            let what = "[substrate] may have `modes` or `relaxation`, not both";
            Err(relaxation.fault(what, "both are there", "remove one of the two: each describes the whole substrate"))
        }
        (modes, None) => {
            if let Some(modulus) = modulus::find(&section, "substrate", ONE_MODULUS)? {
                let what = format!("`{}` goes with `relaxation`, which is not there", modulus.entry.path());
                let help = "beside `modes` the modulus stands in [laboratory]: move it there";
                return Err(modulus.entry.fault(what, "without `relaxation`", help));
            }
            let substrate = modes.map(|modes| read_modes(&modes)).transpose()?.unwrap_or_default();
            Ok(ReadSubstrate { substrate, material: MaterialDefaults::default() })
        }
        (None, Some(relaxation)) => read_relaxation(&section, &relaxation),
    }
}

fn read_modes(modes_entry: &Entry<'_>) -> Result<Substrate, Fault> {
    let read_mode = |mode: Entry<'_>| {
        let mode = mode.section(&["share", "time"], |_| None)?;
        let [share_entry, time_entry] = [mode.require("share", MODES)?, mode.require("time", MODES)?];
        let (share, time) = (share_entry.number()?, time_entry.number()?);
        if !(share > 0.0 && share <= 1.0) {
            let help = "a share is the mode's part of f; leave out modes that have none";
            return Err(share_entry.fault("a `share` must be above 0 and at most 1", "not a share", help));
        }
        if !(time > 0.0 && time.is_finite()) {
            let help = "the time is the mode's retardation time over the one in alpha, as in 100.0";
            return Err(time_entry.fault("a `time` must be finite and above 0", "not a time", help));
        }
        Ok(RetardationMode { share, time })
    };
    let modes = modes_entry.require_list(MODES)?.map(read_mode).collect::<Result<Vec<_>, _>>()?;
    Substrate::new(modes).map_err(|error| {
        let help =
            "scale the shares so that they add up to 1; for the usual single retardation time leave [substrate] out";
        modes_entry.fault(format!("`substrate.modes`: {error}"), "these modes", help).unquoted()
    })
}

/// Part of a modulus that a term has: in Pa, or of the instantaneous modulus.
#[derive(Clone, Copy)]
enum Part {
    Modulus(f64),
    Fraction(f64),
}

fn read_relaxation(section: &Section<'_>, entry: &Entry<'_>) -> Result<ReadSubstrate, Fault> {
    let read_term = |term: Entry<'_>| {
        let keys = term.section(&["modulus", "fraction", "time"], |_| None)?;
        let time = Dimension::Time.read(&keys.require("time", TERMS)?)?;
        let part = match (keys.get("modulus"), keys.get("fraction")) {
            (Some(modulus), None) => Part::Modulus(Dimension::Modulus.read(&modulus)?),
            (None, Some(fraction)) => Part::Fraction(read_fraction(&fraction)?),
            (None, None) => return Err(keys.fault("a term has `modulus` or `fraction`", "has neither", TERMS)),
            (Some(_), Some(_)) => return Err(keys.fault("a term has `modulus` or `fraction`", "has both", TERMS)),
        };
        Ok((part, time))
    };
    let list = entry.require_list(TERMS)?;
    if list.len() > MOST_TERMS {
        let what = format!("`substrate.relaxation` may have at most {MOST_TERMS} terms, not {}", list.len());
        let help = "one or two for each decade of time describe any material";
        return Err(entry.fault(what, "too many terms", help).unquoted());
    }
    let terms = list.map(read_term).collect::<Result<Vec<_>, _>>()?;
    let fractions = terms.iter().filter(|(part, _)| matches!(part, Part::Fraction(_))).count();
    if fractions != 0 && fractions != terms.len() {
        return Err(entry
            .fault("terms have `modulus` or `fraction`, all of them the same", "both are there", TERMS)
            .unquoted());
    }
    // Fractions alone say nothing of the modulus: f and the times are the same whatever it is.
    let (given, kind) = match modulus::find(section, "substrate", ONE_MODULUS)? {
        None => (None, None),
        Some(given) => (Some((Dimension::Modulus.read(&given.entry)?, given.quantity)), Some(given.kind)),
    };
    let parts: f64 = terms.iter().map(|(Part::Modulus(part) | Part::Fraction(part), _)| part).sum();
    let (relaxed, unit) = match (given, fractions > 0) {
        (None, true) => (1.0 - parts, 1.0),
        (None, false) => {
            let help = "add relaxed_modulus = \"1 MPa\", the modulus after a long time, or instantaneous_modulus";
            return Err(section.fault("[substrate] needs a modulus beside `relaxation`", "no modulus", help));
        }
        (Some((modulus, LaboratoryQuantity::RelaxedModulus)), false) => (modulus, 1.0),
        (Some((modulus, LaboratoryQuantity::RelaxedModulus)), true) => (modulus, modulus / (1.0 - parts)),
        (Some((modulus, _)), false) => (modulus - parts, 1.0),
        (Some((modulus, _)), true) => (modulus * (1.0 - parts), modulus),
    };
    if parts.is_nan() || (fractions > 0 && parts >= 1.0) || relaxed <= 0.0 {
        let what = "the terms of `substrate.relaxation` must leave a relaxed modulus above 0";
        let help = "the parts of all terms together are less than the instantaneous modulus (less than 1 as fractions): a \
                    solid keeps a load for ever; what flows at last is no substrate here";
        return Err(entry.fault(what, "nothing is left", help).unquoted());
    }
    let term = |(part, time): &(Part, f64)| {
        let (Part::Modulus(part) | Part::Fraction(part)) = part;
        RelaxationTerm { modulus: part * unit, time: *time }
    };
    let relaxation = Relaxation::new(relaxed, terms.iter().map(term).collect())
        .map_err(|error| entry.fault(format!("`substrate.relaxation`: {error}"), "these terms", TERMS).unquoted())?;
    let Material { relaxed_modulus, f, retardation_time, substrate } = relaxation.material();
    let material = MaterialDefaults {
        relaxed_modulus: kind.map(|kind| (relaxed_modulus, kind)),
        f: Some(f),
        retardation_time: Some(retardation_time),
    };
    Ok(ReadSubstrate { substrate, material })
}

fn read_fraction(entry: &Entry<'_>) -> Result<f64, Fault> {
    let fraction = entry.number()?;
    if fraction > 0.0 && fraction < 1.0 {
        return Ok(fraction);
    }
    let help = "a fraction is the term's part of the instantaneous modulus, g_i of a normalised Prony series";
    Err(entry.fault("a `fraction` must be above 0 and below 1", "not a fraction", help))
}
