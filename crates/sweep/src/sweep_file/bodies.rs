//! The two bodies of a sweep: the sections `[flat]` (or `[substrate]`, its other name) and `[roller]`.

use super::modulus;
use super::named_series::NamedSeries;
use super::sections::{keys, section};
use super::substrate::{self, MaterialDefaults, ReadSubstrate};
use super::temperature::read_shift;
use stribeck_input::{Entry, Fault, Quantity, Section, Values};
use stribeck_lab::{Dimension, LaboratoryQuantity, Modulus, Roller, ShiftLaw};
use stribeck_solver::Substrate;

/// The two bodies as a sweep file has them.
#[derive(Default)]
pub(super) struct ReadBodies {
    /// The spectrum of the flat; in a dimensionless sweep of both bodies.
    pub(super) substrate: Substrate,
    /// What the flat says of itself.
    pub(super) flat: MaterialDefaults,
    /// True for a rigid flat.
    pub(super) flat_is_rigid: bool,
    /// True for a flat that has a modulus, and nothing of its own that takes time.
    pub(super) flat_is_elastic: bool,
    /// The roller in numbers; rigid in a dimensionless sweep.
    pub(super) roller: Roller,
    /// The spectrum of the roller, where it has an f.
    pub(super) roller_spectrum: Substrate,
    /// How the times of flat and roller change with temperature.
    pub(super) shifts: [Option<ShiftLaw>; 2],
}

/// Reads the sections of both bodies, with the series of files that they name.
pub(super) fn read(root: &Section<'_>, files: &NamedSeries) -> Result<ReadBodies, Fault> {
    let flat = match (root.get("substrate"), root.get("flat")) {
        (Some(_), Some(flat)) => {
            let what = "[substrate] and [flat] are two names of one section";
            return Err(flat.fault(what, "beside [substrate]", "keep one of the two").unquoted());
        }
        (substrate, flat) => substrate.or(flat),
    };
    let roller = root.get("roller");
    match root.get("laboratory") {
        None => read_dimensionless(flat.as_ref(), roller.as_ref(), files),
        Some(_) => read_quantities(flat.as_ref(), roller.as_ref(), files),
    }
}

/// Both bodies of cases over α, β and f: their modes, whose shares add up to 1.
fn read_dimensionless(
    flat: Option<&Entry<'_>>,
    roller: Option<&Entry<'_>>,
    files: &NamedSeries,
) -> Result<ReadBodies, Fault> {
    let Some(roller) = roller else {
        let read = flat.map(|entry| substrate::read_with(entry, files)).transpose()?.unwrap_or_default();
        return Ok(ReadBodies { substrate: read.substrate, flat: read.material, ..ReadBodies::default() });
    };
    let modes = |entry: &Entry<'_>| {
        let section = section(entry)?;
        substrate::refuse_quantities(&section)?;
        if let Some(relaxation) = section.get("relaxation") {
            let what = format!("`{}` beside [roller] goes with [laboratory], which is not there", relaxation.path());
            let help = "give the `modes` of both bodies: their shares are parts of one f, and add up to 1";
            return Err(relaxation.fault(what, "without [laboratory]", help).unquoted());
        }
        section.get("modes").map_or(Ok(Vec::new()), |modes| substrate::read_modes(&modes))
    };
    let flat_modes = flat.map_or(Ok(Vec::new()), modes)?;
    let substrate = substrate::substrate_of(roller, flat_modes, modes(roller)?)?;
    Ok(ReadBodies { substrate, ..ReadBodies::default() })
}

/// Both bodies of an experiment.
fn read_quantities(
    flat: Option<&Entry<'_>>,
    roller: Option<&Entry<'_>>,
    files: &NamedSeries,
) -> Result<ReadBodies, Fault> {
    let mut bodies = ReadBodies::default();
    if let Some(entry) = flat {
        if is_rigid(entry)? {
            bodies.flat_is_rigid = true;
            bodies.flat = MaterialDefaults {
                relaxed_modulus: Some(f64::INFINITY),
                poisson_ratio: Some(0.0),
                f: Some(0.0),
                retardation_time: Some(0.0),
                ..MaterialDefaults::default()
            };
        } else {
            let read = read_body(entry, files)?;
            let MaterialDefaults { relaxed_modulus, instantaneous_modulus, f, retardation_time, .. } = read.material;
            let has_modulus = relaxed_modulus.or(instantaneous_modulus).is_some();
            bodies.flat_is_elastic = has_modulus && !read.has_spectrum && f.or(retardation_time).is_none();
            (bodies.substrate, bodies.flat) = (read.substrate, read.material);
        }
    }
    match roller {
        Some(entry) if !is_rigid(entry)? => {
            (bodies.roller, bodies.roller_spectrum) = soft_roller(entry, files)?;
        }
        _ if bodies.flat_is_rigid => {
            let help =
                "give [roller] a modulus, or remove `rigid` from the flat: elastohydrodynamic films need a soft body";
            return Err(flat.expect("it is rigid").fault("both bodies are rigid", "rigid", help).unquoted());
        }
        _ => {}
    }
    for (shift, entry) in bodies.shifts.iter_mut().zip([flat, roller]) {
        let body = entry.map(section).transpose()?;
        *shift = body.and_then(|body| body.get("shift")).map(|entry| read_shift(&entry)).transpose()?;
    }
    Ok(bodies)
}

/// True for a section that says `rigid = true`, which then has no other key.
fn is_rigid(entry: &Entry<'_>) -> Result<bool, Fault> {
    let body = section(entry)?;
    if !body.get("rigid").map_or(Ok(false), |rigid| rigid.boolean())? {
        return Ok(false);
    }
    let others = keys(entry.path()).into_iter().filter(|key| *key != "rigid");
    match others.into_iter().find_map(|key| body.get(key)) {
        None => Ok(true),
        Some(other) => {
            let what = format!("`{}` says nothing of a rigid body", other.path());
            Err(other.fault(what, "beside `rigid`", "remove it, or `rigid`"))
        }
    }
}

/// Spectrum, moduli, Poisson's ratio, f and time of a body, as far as they are given.
fn read_body(entry: &Entry<'_>, files: &NamedSeries) -> Result<ReadSubstrate, Fault> {
    let (body, name) = (section(entry)?, entry.path());
    let mut read = substrate::read_spectrum(&body, name, files)?;
    let material = &mut read.material;
    let number = |key: &str, quantity: &dyn Values| body.get(key).map(|entry| quantity.read(&entry)).transpose();
    material.poisson_ratio = number("poisson_ratio", &LaboratoryQuantity::PoissonRatio)?;
    if let (Some(_), Some(other)) = (body.get("relaxation"), body.get("f").or(body.get("retardation_time"))) {
        let what = format!("`{}` follows from the terms of `relaxation`", other.path());
        return Err(other.fault(what, "beside `relaxation`", "remove it, or the terms"));
    }
    if body.get("relaxation").is_none() {
        material.f = number("f", &Quantity::Strength)?;
        material.retardation_time = body.get("retardation_time").map(|time| Dimension::Time.read(&time)).transpose()?;
        if let Some(given) = modulus::find(&body, name)? {
            let value = Some(Dimension::Modulus.read(&given.entry)?);
            material.kind = given.kind;
            match given.quantity {
                LaboratoryQuantity::RelaxedModulus => material.relaxed_modulus = value,
                _ => material.instantaneous_modulus = value,
            }
        }
    }
    Ok(read)
}

/// A roller that is not rigid: elastic, or with a spectrum.
fn soft_roller(entry: &Entry<'_>, files: &NamedSeries) -> Result<(Roller, Substrate), Fault> {
    let body = section(entry)?;
    let ReadSubstrate { substrate, material, has_spectrum } = read_body(entry, files)?;
    let poisson_ratio = match material.poisson_ratio {
        Some(ratio) => ratio,
        None => LaboratoryQuantity::PoissonRatio.read(&body.require("poisson_ratio", "add poisson_ratio = 0.5")?)?,
    };
    let f = material.f.unwrap_or(0.0);
    if has_spectrum && material.f.is_none() {
        let help = "add f = 10.0, say: f = E0/Einf - 1 of the roller; or describe it by `relaxation`";
        return Err(body.fault("[roller] needs `f` beside `modes`", "`f` is missing", help));
    }
    let retardation_time = match material.retardation_time {
        Some(time) => time,
        None if f == 0.0 => 0.0,
        None => Dimension::Time.read(&body.require("retardation_time", "add retardation_time = \"20 ms\"")?)?,
    };
    let modulus = match (material.relaxed_modulus, material.instantaneous_modulus) {
        (Some(modulus), _) => Modulus::Relaxed(modulus),
        (None, Some(modulus)) => Modulus::Instantaneous(modulus),
        (None, None) => {
            let help =
                "add relaxed_modulus = \"1 MPa\" (or instantaneous_modulus); for a rigid roller leave the section out";
            return Err(body.fault("[roller] needs a modulus, which is missing", "no modulus", help));
        }
    };
    let modulus = modulus.times(material.kind.young_factor(poisson_ratio));
    Ok((Roller { modulus, poisson_ratio, f, retardation_time }, substrate))
}
