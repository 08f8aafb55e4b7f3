//! The two bodies of a sweep: the sections `[flat]` (or `[substrate]`, its other name) and `[roller]`.

use super::modulus;
use super::named_series::NamedSeries;
use super::sections::{keys, section};
use super::substrate::{self, MaterialDefaults, ReadSubstrate};
use super::temperature::read_shift;
use stribeck_input::{Entry, Fault, Quantity, Readings, Section, Values};
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

impl ReadBodies {
    /// Bodies that lack nothing, in place of those with a fault: what depends on them is not told as missing.
    pub(super) fn stand_in() -> Self {
        let flat = MaterialDefaults {
            relaxed_modulus: Some(1.0),
            poisson_ratio: Some(0.5),
            f: Some(1.0),
            retardation_time: Some(1.0),
            ..MaterialDefaults::default()
        };
        let shift = ShiftLaw::Arrhenius { activation_energy: 1.0, reference: 300.0 };
        Self { flat, shifts: [Some(shift), None], ..Self::default() }
    }
}

/// Reads the sections of both bodies, with the series of files that they name.
pub(super) fn read(root: &Section<'_>, files: &NamedSeries) -> Result<ReadBodies, Fault> {
    let (substrate, flat) = (root.get("substrate"), root.get("flat"));
    let one_name = match (&substrate, &flat) {
        (Some(_), Some(flat)) => {
            let what = "[substrate] and [flat] are two names of one section";
            Err(flat.fault(what, "beside [substrate]", "keep one of the two").unquoted())
        }
        _ => Ok(()),
    };
    let (flat, roller) = (substrate.or(flat), root.get("roller"));
    let bodies = match root.get("laboratory") {
        None => read_dimensionless(flat.as_ref(), roller.as_ref(), files),
        Some(_) => read_quantities(flat.as_ref(), roller.as_ref(), files),
    };
    (one_name, bodies).all().map(|(_, bodies)| bodies)
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
        let foreign = match section.get("relaxation") {
            None => Ok(()),
            Some(relaxation) => {
                let what =
                    format!("`{}` beside [roller] goes with [laboratory], which is not there", relaxation.path());
                let help = "give the `modes` of both bodies: their shares are parts of one f, and add up to 1";
                Err(relaxation.fault(what, "without [laboratory]", help).unquoted())
            }
        };
        let modes = section.optional("modes", substrate::read_modes);
        (substrate::refuse_quantities(&section), foreign, modes).all().map(|(.., modes)| modes.unwrap_or_default())
    };
    let (flat_modes, roller_modes) = (flat.map_or(Ok(Vec::new()), modes), modes(roller)).all()?;
    let substrate = substrate::substrate_of(roller, flat_modes, roller_modes)?;
    Ok(ReadBodies { substrate, ..ReadBodies::default() })
}

/// Both bodies of an experiment.
fn read_quantities(
    flat: Option<&Entry<'_>>,
    roller: Option<&Entry<'_>>,
    files: &NamedSeries,
) -> Result<ReadBodies, Fault> {
    let shift = |body: Option<&Entry<'_>>| match body.map(section).transpose()? {
        Some(body) => body.optional("shift", read_shift),
        None => Ok(None),
    };
    let flat_body = flat.map_or(Ok(ReadBodies::default()), |entry| read_flat(entry, files));
    let roller = (roller.map_or(Ok(None), |entry| read_roller(entry, files)), shift(roller)).all();
    let (mut bodies, flat_shift, (roller, roller_shift)) = (flat_body, shift(flat), roller).all()?;
    match roller {
        Some(soft) => (bodies.roller, bodies.roller_spectrum) = soft,
        None if bodies.flat_is_rigid => {
            let help =
                "give [roller] a modulus, or remove `rigid` from the flat: elastohydrodynamic films need a soft body";
            return Err(flat.expect("it is rigid").fault("both bodies are rigid", "rigid", help).unquoted());
        }
        None => {}
    }
    bodies.shifts = [flat_shift, roller_shift];
    Ok(bodies)
}

/// The flat of an experiment.
fn read_flat(entry: &Entry<'_>, files: &NamedSeries) -> Result<ReadBodies, Fault> {
    if is_rigid(entry)? {
        let flat = MaterialDefaults {
            relaxed_modulus: Some(f64::INFINITY),
            poisson_ratio: Some(0.0),
            f: Some(0.0),
            retardation_time: Some(0.0),
            ..MaterialDefaults::default()
        };
        return Ok(ReadBodies { flat, flat_is_rigid: true, ..ReadBodies::default() });
    }
    let ReadSubstrate { substrate, material, has_spectrum } = read_body(entry, files)?;
    let has_modulus = material.relaxed_modulus.or(material.instantaneous_modulus).is_some();
    let flat_is_elastic = has_modulus && !has_spectrum && material.f.or(material.retardation_time).is_none();
    Ok(ReadBodies { substrate, flat: material, flat_is_elastic, ..ReadBodies::default() })
}

/// True for a section that says `rigid = true`, which then has no other key.
fn is_rigid(entry: &Entry<'_>) -> Result<bool, Fault> {
    let body = section(entry)?;
    if !body.get("rigid").map_or(Ok(false), |rigid| rigid.boolean())? {
        return Ok(false);
    }
    let others = keys(entry.path()).into_iter().filter(|key| *key != "rigid").filter_map(|key| body.get(key));
    let faults = others.map(|other| {
        let what = format!("`{}` says nothing of a rigid body", other.path());
        other.fault(what, "beside `rigid`", "remove it, or `rigid`")
    });
    Fault::of_all(faults).map_or(Ok(true), Err)
}

/// Spectrum, moduli, Poisson's ratio, f and time of a body, as far as they are given.
fn read_body(entry: &Entry<'_>, files: &NamedSeries) -> Result<ReadSubstrate, Fault> {
    let (body, name) = (section(entry)?, entry.path());
    let spectrum = substrate::read_spectrum(&body, name, files);
    let poisson_ratio = body.optional("poisson_ratio", |entry| LaboratoryQuantity::PoissonRatio.read(entry));
    if body.get("relaxation").is_some() {
        let others = ["f", "retardation_time"].into_iter().filter_map(|key| body.get(key));
        let faults = others.map(|other| {
            let what = format!("`{}` follows from the terms of `relaxation`", other.path());
            other.fault(what, "beside `relaxation`", "remove it, or the terms")
        });
        let alone = Fault::of_all(faults).map_or(Ok(()), Err);
        let (mut read, poisson_ratio, ()) = (spectrum, poisson_ratio, alone).all()?;
        read.material.poisson_ratio = poisson_ratio;
        return Ok(read);
    }
    let f = body.optional("f", |entry| Quantity::Strength.read(entry));
    let retardation_time = body.optional("retardation_time", |entry| Dimension::Time.read(entry));
    let modulus = modulus::find(&body, name)
        .and_then(|given| given.map(|given| Ok((Dimension::Modulus.read(&given.entry)?, given))).transpose());
    let (mut read, poisson_ratio, f, retardation_time, modulus) =
        (spectrum, poisson_ratio, f, retardation_time, modulus).all()?;
    read.material = MaterialDefaults { poisson_ratio, f, retardation_time, ..read.material };
    if let Some((value, given)) = modulus {
        read.material.kind = given.kind;
        match given.quantity {
            LaboratoryQuantity::RelaxedModulus => read.material.relaxed_modulus = Some(value),
            _ => read.material.instantaneous_modulus = Some(value),
        }
    }
    Ok(read)
}

/// The roller of an experiment; `None` if it is rigid.
fn read_roller(entry: &Entry<'_>, files: &NamedSeries) -> Result<Option<(Roller, Substrate)>, Fault> {
    if is_rigid(entry)? { Ok(None) } else { soft_roller(entry, files).map(Some) }
}

/// Refuses a soft roller that lacks a key, whatever its other keys say.
fn check_roller(body: &Section<'_>) -> Result<(), Fault> {
    let has = |key| body.get(key).is_some();
    let ratio = body.require("poisson_ratio", "add poisson_ratio = 0.5").map(|_| ());
    let strength = match has("modes") && !has("f") {
        false => Ok(()),
        true => {
            let help = "add f = 10.0, say: f = E0/Einf - 1 of the roller; or describe it by `relaxation`";
            Err(body.fault("[roller] needs `f` beside `modes`", "`f` is missing", help))
        }
    };
    let modulus = match has("relaxation") || modulus::KEYS.iter().any(|(key, ..)| has(key)) {
        true => Ok(()),
        false => Err(without_modulus(body)),
    };
    (ratio, strength, modulus).all().map(|_| ())
}

fn without_modulus(roller: &Section<'_>) -> Fault {
    let help = "add relaxed_modulus = \"1 MPa\" (or instantaneous_modulus); for a rigid roller leave the section out";
    roller.fault("[roller] needs a modulus, which is missing", "no modulus", help)
}

/// A roller that is not rigid: elastic, or with a spectrum.
fn soft_roller(entry: &Entry<'_>, files: &NamedSeries) -> Result<(Roller, Substrate), Fault> {
    let body = section(entry)?;
    let (read, ()) = (read_body(entry, files), check_roller(&body)).all()?;
    let (substrate, material) = (read.substrate, read.material);
    let poisson_ratio = material.poisson_ratio.expect("it was looked for");
    let f = material.f.unwrap_or(0.0);
    let retardation_time = match material.retardation_time {
        Some(time) => time,
        None if f == 0.0 => 0.0,
        None => Dimension::Time.read(&body.require("retardation_time", "add retardation_time = \"20 ms\"")?)?,
    };
    let modulus = match (material.relaxed_modulus, material.instantaneous_modulus) {
        (Some(modulus), _) => Modulus::Relaxed(modulus),
        (None, Some(modulus)) => Modulus::Instantaneous(modulus),
        (None, None) => return Err(without_modulus(&body)),
    };
    let modulus = modulus.times(material.kind.young_factor(poisson_ratio));
    Ok((Roller { modulus, poisson_ratio, f, retardation_time }, substrate))
}
