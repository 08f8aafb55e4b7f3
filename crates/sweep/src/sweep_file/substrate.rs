//! The retardation spectrum of a body, in `[flat]` (or `[substrate]`, its other name) and `[roller]` of a sweep file.

use super::modulus;
use super::named_series::NamedSeries;
use super::sections::section;
use stribeck_input::{Entry, Fault, Readings, Section, Values, each};
use stribeck_lab::{
    Dimension, LaboratoryQuantity, Material, Modulus, ModulusKind, PronyError, PronyParts, PronySeries,
};
use stribeck_solver::{RetardationMode, Substrate};

const MODES: &str = "write modes = [{ share = 0.7, time = 1.0 }, { share = 0.3, time = 100.0 }]";
const TERMS: &str = "write relaxation = [{ modulus = \"0.5 MPa\", time = \"1 s\" }, \
                     { modulus = \"0.1 MPa\", time = \"10 s\" }], or { fraction = 0.3, time = \"1 s\" } with fractions of the \
                     instantaneous modulus; or { file = \"prony.csv\" }";

/// The keys of a mode.
pub(super) const MODE_KEYS: [&str; 2] = ["share", "time"];
/// The keys of a term.
pub(super) const TERM_KEYS: [&str; 3] = ["modulus", "fraction", "time"];

/// What a body says of itself, for what `[laboratory]` leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MaterialDefaults {
    /// E∞ or G∞ (Pa).
    pub relaxed_modulus: Option<f64>,
    /// E₀ or G₀ (Pa), where that is given and the relaxed one is not.
    pub instantaneous_modulus: Option<f64>,
    /// What these moduli are of.
    pub kind: ModulusKind,
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

/// Reads the substrate of dimensionless cases in a file that may name none: retardation modes, or a material by its
/// relaxation.
pub fn read(entry: &Entry<'_>) -> Result<ReadSubstrate, Fault> {
    read_with(entry, &NamedSeries::default())
}

/// The same with the series of files that are named.
pub(super) fn read_with(entry: &Entry<'_>, files: &NamedSeries) -> Result<ReadSubstrate, Fault> {
    let section = section(entry)?;
    let (_, read) = (refuse_quantities(&section), read_spectrum(&section, entry.path(), files)).all()?;
    Ok(read)
}

/// Refuses what says nothing of dimensionless cases: moduli without relaxation, and other quantities.
pub(super) fn refuse_quantities(section: &Section<'_>) -> Result<(), Fault> {
    let others = ["rigid", "poisson_ratio", "f", "retardation_time", "shift"];
    let others = others.into_iter().filter_map(|key| section.get(key)).map(|other| {
        let what = format!("`{}` goes with [laboratory], which is not there", other.path());
        let help = "sweeps over alpha, beta and f need the `modes` of their bodies alone: remove it";
        other.fault(what, "without [laboratory]", help)
    });
    let moduli = modulus::KEYS.into_iter().filter_map(|(key, ..)| section.get(key));
    let moduli = moduli.filter(|_| section.get("relaxation").is_none()).map(|modulus| {
        let what = format!("`{}` goes with `relaxation`, which is not there", modulus.path());
        let help = "beside `modes` the modulus stands in [laboratory]: move it there";
        modulus.fault(what, "without `relaxation`", help)
    });
    Fault::of_all(others.chain(moduli)).map_or(Ok(()), Err)
}

/// Reads `modes` or `relaxation` of the section of a body.
pub(super) fn read_spectrum(section: &Section<'_>, name: &str, files: &NamedSeries) -> Result<ReadSubstrate, Fault> {
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
        (None, Some(relaxation)) => read_relaxation(section, name, &relaxation, files),
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
        let mode = mode.section(&MODE_KEYS, |_| None)?;
        let share = mode.require("share", MODES).and_then(|entry| match entry.number()? {
            share if share > 0.0 && share <= 1.0 => Ok(share),
            _ => {
                let help = "a share is the mode's part of f; leave out modes that have none";
                Err(entry.fault("a `share` must be above 0 and at most 1", "not a share", help))
            }
        });
        let time = mode.require("time", MODES).and_then(|entry| match entry.number()? {
            time if time > 0.0 && time.is_finite() => Ok(time),
            _ => {
                let help = "the time is the mode's retardation time over the one in alpha, as in 100.0";
                Err(entry.fault("a `time` must be finite and above 0", "not a time", help))
            }
        });
        let (share, time) = (share, time).all()?;
        Ok(RetardationMode { share, time })
    };
    each(modes_entry.require_list(MODES)?.map(read_mode))
}

/// A material by its relaxation: its terms, or a file with them.
fn read_relaxation(
    section: &Section<'_>,
    name: &str,
    entry: &Entry<'_>,
    files: &NamedSeries,
) -> Result<ReadSubstrate, Fault> {
    let series = if entry.is_section() { files.series(entry) } else { read_terms(entry) };
    let modulus = modulus::find(section, name)
        .and_then(|given| given.map(|given| Ok((Dimension::Modulus.read(&given.entry)?, given))).transpose());
    let (mut series, modulus) = (series, modulus).all()?;
    if let Some((value, given)) = modulus {
        let is_relaxed = given.quantity == LaboratoryQuantity::RelaxedModulus;
        series.modulus = Some(if is_relaxed { Modulus::Relaxed(value) } else { Modulus::Instantaneous(value) });
        series.kind = given.kind;
    }
    let relaxation = series.relaxation().map_err(|error| refused(section, name, entry, &error))?;
    let Material { relaxed_modulus, f, retardation_time, substrate } = relaxation.material();
    let material = MaterialDefaults {
        relaxed_modulus: series.modulus.map(|_| relaxed_modulus),
        kind: series.kind,
        f: Some(f),
        retardation_time: Some(retardation_time),
        ..MaterialDefaults::default()
    };
    Ok(ReadSubstrate { substrate, material, has_spectrum: true })
}

/// Terms by their moduli, or by their fractions of the instantaneous modulus.
fn read_terms(entry: &Entry<'_>) -> Result<PronySeries, Fault> {
    let read_term = |term: Entry<'_>| {
        let keys = term.section(&TERM_KEYS, |_| None)?;
        let time = keys.require("time", TERMS).and_then(|time| Dimension::Time.read(&time));
        let part = match (keys.get("modulus"), keys.get("fraction")) {
            (Some(modulus), None) => Dimension::Modulus.read(&modulus).map(|value| (PronyParts::Moduli, value)),
            (None, Some(fraction)) => read_fraction(&fraction).map(|value| (PronyParts::Fractions, value)),
            (None, None) => Err(keys.fault("a term has `modulus` or `fraction`", "has neither", TERMS)),
            (Some(_), Some(_)) => Err(keys.fault("a term has `modulus` or `fraction`", "has both", TERMS)),
        };
        (part, time).all()
    };
    let terms = each(entry.require_list(TERMS)?.map(read_term))?;
    let parts = terms.first().map_or(PronyParts::Moduli, |((parts, _), _)| *parts);
    if terms.iter().any(|((other, _), _)| *other != parts) {
        let what = "terms have `modulus` or `fraction`, all of them the same";
        return Err(entry.fault(what, "both are there", TERMS).unquoted());
    }
    let terms = terms.into_iter().map(|((_, part), time)| (part, time)).collect();
    Ok(PronySeries { parts, terms, modulus: None, kind: ModulusKind::Young })
}

/// What is wrong with a series, and what to do.
fn refused(section: &Section<'_>, name: &str, entry: &Entry<'_>, error: &PronyError) -> Fault {
    let path = entry.path();
    match error {
        PronyError::NoModulus => {
            let help = "add relaxed_modulus = \"1 MPa\", the modulus after a long time, or instantaneous_modulus";
            section.fault(format!("[{name}] needs a modulus beside `relaxation`"), "no modulus", help)
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
