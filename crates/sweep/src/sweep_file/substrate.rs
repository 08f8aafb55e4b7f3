//! The section `[substrate]` of a sweep file.

use std::path::Path;

use super::modulus;
use super::named_series::{self, NamedSeries};
use super::sections::section;
use stribeck_input::{Entry, Fault, Section, Values};
use stribeck_lab::{
    Dimension, LaboratoryQuantity, Material, Modulus, ModulusKind, PronyError, PronyParts, PronySeries,
};
use stribeck_solver::{RetardationMode, Substrate};

const MODES: &str = "write modes = [{ share = 0.7, time = 1.0 }, { share = 0.3, time = 100.0 }]";
const TERMS: &str = "write relaxation = [{ modulus = \"0.5 MPa\", time = \"1 s\" }, \
                     { modulus = \"0.1 MPa\", time = \"10 s\" }], or { fraction = 0.3, time = \"1 s\" } with fractions of the \
                     instantaneous modulus; or { file = \"prony.csv\" }";

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
    /// The series of a file that the section names.
    pub(super) named: Option<NamedSeries>,
}

/// Reads `[substrate]`: retardation modes, or a material by its relaxation. Files that it names are relative to a folder;
/// without one it may name none.
pub fn read(entry: &Entry<'_>, folder: Option<&Path>) -> Result<ReadSubstrate, Fault> {
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
            Ok(ReadSubstrate { substrate, ..ReadSubstrate::default() })
        }
        (None, Some(relaxation)) => read_relaxation(&section, &relaxation, entry, folder),
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

/// A material by its relaxation: its terms, or a file with them.
fn read_relaxation(
    section: &Section<'_>,
    entry: &Entry<'_>,
    whole: &Entry<'_>,
    folder: Option<&Path>,
) -> Result<ReadSubstrate, Fault> {
    let mut named = if entry.is_section() { Some(named_series::read(entry, whole, folder)?) } else { None };
    let mut series = match &named {
        Some(named) => named.series.clone(),
        None => read_terms(entry)?,
    };
    if let Some(given) = modulus::find(section, "substrate", ONE_MODULUS)? {
        let value = Dimension::Modulus.read(&given.entry)?;
        let is_relaxed = given.quantity == LaboratoryQuantity::RelaxedModulus;
        series.modulus = Some(if is_relaxed { Modulus::Relaxed(value) } else { Modulus::Instantaneous(value) });
        series.kind = given.kind;
        // the section says it already
        if let Some(named) = &mut named {
            named.series.modulus = None;
        }
    }
    let relaxation = series.relaxation().map_err(|error| refused(section, entry, error))?;
    let Material { relaxed_modulus, f, retardation_time, substrate } = relaxation.material();
    let material = MaterialDefaults {
        relaxed_modulus: series.modulus.map(|_| (relaxed_modulus, series.kind)),
        f: Some(f),
        retardation_time: Some(retardation_time),
    };
    Ok(ReadSubstrate { substrate, material, named })
}

/// Terms by their moduli, or by their fractions of the instantaneous modulus.
fn read_terms(entry: &Entry<'_>) -> Result<PronySeries, Fault> {
    let read_term = |term: Entry<'_>| {
        let keys = term.section(&["modulus", "fraction", "time"], |_| None)?;
        let time = Dimension::Time.read(&keys.require("time", TERMS)?)?;
        let part = match (keys.get("modulus"), keys.get("fraction")) {
            (Some(modulus), None) => (PronyParts::Moduli, Dimension::Modulus.read(&modulus)?),
            (None, Some(fraction)) => (PronyParts::Fractions, read_fraction(&fraction)?),
            (None, None) => return Err(keys.fault("a term has `modulus` or `fraction`", "has neither", TERMS)),
            (Some(_), Some(_)) => return Err(keys.fault("a term has `modulus` or `fraction`", "has both", TERMS)),
        };
        Ok((part, time))
    };
    let terms = entry.require_list(TERMS)?.map(read_term).collect::<Result<Vec<_>, _>>()?;
    let parts = terms.first().map_or(PronyParts::Moduli, |((parts, _), _)| *parts);
    if terms.iter().any(|((other, _), _)| *other != parts) {
        let what = "terms have `modulus` or `fraction`, all of them the same";
        return Err(entry.fault(what, "both are there", TERMS).unquoted());
    }
    let terms = terms.into_iter().map(|((_, part), time)| (part, time)).collect();
    Ok(PronySeries { parts, terms, modulus: None, kind: ModulusKind::Young })
}

/// What is wrong with a series, and what to do.
fn refused(section: &Section<'_>, entry: &Entry<'_>, error: PronyError) -> Fault {
    let path = entry.path();
    match error {
        PronyError::NoModulus => {
            let help = "add relaxed_modulus = \"1 MPa\", the modulus after a long time, or instantaneous_modulus";
            section.fault("[substrate] needs a modulus beside `relaxation`", "no modulus", help)
        }
        PronyError::NoFractionLeft { .. } | PronyError::NoModulusLeft { .. } => {
            let what = format!("the terms of `{path}` must leave a relaxed modulus above 0; {error}");
            let help = "the parts of all terms together are less than the instantaneous modulus (less than 1 as fractions): a \
                        solid keeps a load for ever; what flows at last is no substrate here";
            entry.fault(what, "nothing is left", help).unquoted()
        }
        PronyError::TooMany { .. } | PronyError::Material(_) => {
            entry.fault(format!("`{path}`: {error}"), "these terms", TERMS).unquoted()
        }
    }
}

fn read_fraction(entry: &Entry<'_>) -> Result<f64, Fault> {
    let fraction = entry.number()?;
    if fraction > 0.0 && fraction < 1.0 {
        return Ok(fraction);
    }
    let help = "a fraction is the term's part of the instantaneous modulus, g_i of a normalised Prony series";
    Err(entry.fault("a `fraction` must be above 0 and below 1", "not a fraction", help))
}
