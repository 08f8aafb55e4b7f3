//! The retardation spectrum of a body, in `[flat]` (or `[substrate]`, its other name) and `[roller]` of a sweep file.

use super::sections::section;
use stribeck_input::{Entry, Fault, Section, Values};
use stribeck_lab::{Dimension, Material, Relaxation, RelaxationTerm};
use stribeck_solver::{RetardationMode, Substrate};

/// Most terms of a relaxation.
const MOST_TERMS: usize = 1000;

const MODES: &str = "write modes = [{ share = 0.7, time = 1.0 }, { share = 0.3, time = 100.0 }]";
const TERMS: &str = "write relaxation = [{ modulus = \"0.5 MPa\", time = \"1 s\" }, \
                     { modulus = \"0.1 MPa\", time = \"10 s\" }], or { fraction = 0.3, time = \"1 s\" } with fractions of the instantaneous modulus";

/// What a body says of itself, for what `[laboratory]` leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MaterialDefaults {
    /// E∞ (Pa).
    pub relaxed_modulus: Option<f64>,
    /// E₀ (Pa), where that is given and E∞ is not.
    pub instantaneous_modulus: Option<f64>,
    /// ν.
    pub poisson_ratio: Option<f64>,
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
    /// Of a material: moduli, f and retardation time.
    pub material: MaterialDefaults,
    /// True if `modes` or `relaxation` is there.
    pub has_spectrum: bool,
}

/// Reads the substrate of dimensionless cases: retardation modes, or a material by its relaxation.
pub fn read(entry: &Entry<'_>) -> Result<ReadSubstrate, Fault> {
    let section = section(entry)?;
    refuse_quantities(&section)?;
    read_spectrum(&section, entry.path())
}

/// Refuses what says nothing of dimensionless cases: moduli without relaxation, and other quantities.
pub(super) fn refuse_quantities(section: &Section<'_>) -> Result<(), Fault> {
    if let Some(other) =
        ["rigid", "poisson_ratio", "f", "retardation_time", "shift"].into_iter().find_map(|key| section.get(key))
    {
        let what = format!("`{}` goes with [laboratory], which is not there", other.path());
        let help = "sweeps over alpha, beta and f need the `modes` of their bodies alone: remove it";
        return Err(other.fault(what, "without [laboratory]", help));
    }
    let modulus = ["relaxed_modulus", "instantaneous_modulus"].into_iter().find_map(|key| section.get(key));
    match modulus.filter(|_| section.get("relaxation").is_none()) {
        None => Ok(()),
        Some(modulus) => {
            let what = format!("`{}` goes with `relaxation`, which is not there", modulus.path());
            let help = "beside `modes` the modulus stands in [laboratory]: move it there";
            Err(modulus.fault(what, "without `relaxation`", help))
        }
    }
}

/// Reads `modes` or `relaxation` of the section of a body.
pub(super) fn read_spectrum(section: &Section<'_>, name: &str) -> Result<ReadSubstrate, Fault> {
    match (section.get("modes"), section.get("relaxation")) {
        (Some(_), Some(relaxation)) => {
            let what = format!("[{name}] may have `modes` or `relaxation`, not both");
            Err(relaxation.fault(what, "both are there", "remove one of the two: each describes the whole substrate"))
        }
        (None, None) => Ok(ReadSubstrate::default()),
        (Some(modes), None) => {
            let substrate = substrate_of(&modes, read_modes(&modes)?, Vec::new())?;
            Ok(ReadSubstrate { substrate, has_spectrum: true, ..ReadSubstrate::default() })
        }
        (None, Some(relaxation)) => read_relaxation(section, name, &relaxation),
    }
}

/// The substrate of modes of both bodies; `entry` is where they stand.
pub(super) fn substrate_of(
    entry: &Entry<'_>,
    flat: Vec<RetardationMode>,
    roller: Vec<RetardationMode>,
) -> Result<Substrate, Fault> {
    Substrate::of_two_bodies(flat, roller).map_err(|error| {
        let section = entry.path().split('.').next().unwrap_or_default();
        let help = format!(
            "scale the shares so that they add up to 1, those of flat and roller together; for the usual single \
             retardation time leave [{section}] out"
        );
        entry.fault(format!("`{}`: {error}", entry.path()), "these modes", help).unquoted()
    })
}

pub(super) fn read_modes(modes_entry: &Entry<'_>) -> Result<Vec<RetardationMode>, Fault> {
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
    modes_entry.require_list(MODES)?.map(read_mode).collect()
}

/// Part of a modulus that a term has: in Pa, or of the instantaneous modulus.
#[derive(Clone, Copy)]
enum Part {
    Modulus(f64),
    Fraction(f64),
}

fn read_relaxation(section: &Section<'_>, name: &str, entry: &Entry<'_>) -> Result<ReadSubstrate, Fault> {
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
        let what = format!("`{}` may have at most {MOST_TERMS} terms, not {}", entry.path(), list.len());
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
    let given = given_modulus(section, name)?;
    // Fractions alone say nothing of the modulus: f and the times are the same whatever it is.
    let is_known = given.is_some();
    let parts: f64 = terms.iter().map(|(Part::Modulus(part) | Part::Fraction(part), _)| part).sum();
    let (relaxed, unit) = match (given, fractions > 0) {
        (None, true) => (1.0 - parts, 1.0),
        (None, false) => {
            let help = "add relaxed_modulus = \"1 MPa\", the modulus after a long time, or instantaneous_modulus";
            return Err(section.fault(format!("[{name}] needs a modulus beside `relaxation`"), "no modulus", help));
        }
        (Some(Given::Relaxed(modulus)), false) => (modulus, 1.0),
        (Some(Given::Relaxed(modulus)), true) => (modulus, modulus / (1.0 - parts)),
        (Some(Given::Instantaneous(modulus)), false) => (modulus - parts, 1.0),
        (Some(Given::Instantaneous(modulus)), true) => (modulus * (1.0 - parts), modulus),
    };
    if parts.is_nan() || (fractions > 0 && parts >= 1.0) || relaxed <= 0.0 {
        let what = format!("the terms of `{}` must leave a relaxed modulus above 0", entry.path());
        let help = "the parts of all terms together are less than the instantaneous modulus (less than 1 as fractions): a \
                    solid keeps a load for ever; what flows at last is no substrate here";
        return Err(entry.fault(what, "nothing is left", help).unquoted());
    }
    let term = |(part, time): &(Part, f64)| {
        let (Part::Modulus(part) | Part::Fraction(part)) = part;
        RelaxationTerm { modulus: part * unit, time: *time }
    };
    let relaxation = Relaxation::new(relaxed, terms.iter().map(term).collect())
        .map_err(|error| entry.fault(format!("`{}`: {error}", entry.path()), "these terms", TERMS).unquoted())?;
    let Material { relaxed_modulus, f, retardation_time, substrate } = relaxation.material();
    let material = MaterialDefaults {
        relaxed_modulus: is_known.then_some(relaxed_modulus),
        f: Some(f),
        retardation_time: Some(retardation_time),
        ..MaterialDefaults::default()
    };
    Ok(ReadSubstrate { substrate, material, has_spectrum: true })
}

fn read_fraction(entry: &Entry<'_>) -> Result<f64, Fault> {
    let fraction = entry.number()?;
    if fraction > 0.0 && fraction < 1.0 {
        return Ok(fraction);
    }
    let help = "a fraction is the term's part of the instantaneous modulus, g_i of a normalised Prony series";
    Err(entry.fault("a `fraction` must be above 0 and below 1", "not a fraction", help))
}

/// The modulus of a body, in Pa.
pub(super) enum Given {
    Relaxed(f64),
    Instantaneous(f64),
}

pub(super) fn given_modulus(section: &Section<'_>, name: &str) -> Result<Option<Given>, Fault> {
    let read = |entry: Entry<'_>| Dimension::Modulus.read(&entry);
    match (section.get("relaxed_modulus"), section.get("instantaneous_modulus")) {
        (None, None) => Ok(None),
        (Some(relaxed), None) => read(relaxed).map(Given::Relaxed).map(Some),
        (None, Some(instantaneous)) => read(instantaneous).map(Given::Instantaneous).map(Some),
        (Some(_), Some(instantaneous)) => {
            let what = format!("[{name}] may have `relaxed_modulus` or `instantaneous_modulus`, not both");
            Err(instantaneous.fault(what, "both are there", "remove one of the two: the terms are the difference"))
        }
    }
}
