//! The sections of a sweep file, and the keys of each: what the reader knows, and what the JSON schema says of them.

use super::schema::{self, Shape};
use stribeck_input::{Entry, Fault, Quantity, Section};
use stribeck_lab::LaboratoryQuantity;

/// A key of a section.
pub(super) struct Key {
    pub(super) name: &'static str,
    /// The values that it may have.
    pub(super) shape: Shape,
    /// What it is, in words.
    pub(super) meaning: &'static str,
}

const fn key(name: &'static str, shape: Shape, meaning: &'static str) -> Key {
    Key { name, shape, meaning }
}

/// A quantity of the laboratory as a key of its name.
const fn quantity(name: &'static str, quantity: LaboratoryQuantity, meaning: &'static str) -> Key {
    key(name, Shape::Varying(quantity), meaning)
}

/// The tables of a sweep file and their keys; the first one is the top level.
static SECTIONS: [(&str, &[Key]); 10] = [
    (
        "",
        &[
            key("title", Shape::Title, "Title of the results, in one line. Default: the file's name."),
            key("axes", Shape::Section("axes"), "The values whose product is the sweep."),
            key(
                "laboratory",
                Shape::Section("laboratory"),
                "An experiment by its quantities, in place of alpha and beta.",
            ),
            key("substrate", Shape::Section("substrate"), "The other name of [flat]."),
            key("flat", Shape::Section("flat"), "What the flat is made of."),
            key("roller", Shape::Section("roller"), "What the roller is made of. Default: it is rigid."),
            key("solver", Shape::Section("solver"), "How each case is solved."),
            key("output", Shape::Section("output"), "What is kept of each case beside friction, film and pressure."),
            key("surface", Shape::Section("surface"), "What `stribeck surface` makes of the file."),
        ],
    ),
    (
        "axes",
        &[
            key(
                "slide_roll",
                Shape::Axis(Quantity::SlideRoll),
                "Slide-to-sum ratio S = (u2 - u1)/(u1 + u2) of flat and roller, -1 to 1: 1 is a roller that does not \
                 turn, 0 pure rolling. An instrument's slide-to-roll ratio is twice that.",
            ),
            key("f", Shape::Axis(Quantity::Strength), "Strength of retardation E0/Einf - 1; 0 is elastic."),
            key(
                "alpha",
                Shape::Axis(Quantity::SlideTime),
                "Time to slide over a contact length, over the retardation time; inf may stand at the end of a list.",
            ),
            key(
                "beta",
                Shape::Axis(Quantity::InverseHersey),
                "Inverse Hersey number: thick films where it is small, near contact where it is large.",
            ),
        ],
    ),
    (
        "laboratory",
        &[
            quantity("radius", LaboratoryQuantity::Radius, "Radius of the cylinder, in m or with a unit."),
            quantity("load", LaboratoryQuantity::Load, "Load per length of the cylinder, in N/m or with a unit."),
            quantity("relaxed_modulus", LaboratoryQuantity::RelaxedModulus, RELAXED),
            quantity("instantaneous_modulus", LaboratoryQuantity::InstantaneousModulus, INSTANTANEOUS),
            quantity("relaxed_shear_modulus", LaboratoryQuantity::RelaxedModulus, RELAXED_SHEAR),
            quantity("instantaneous_shear_modulus", LaboratoryQuantity::InstantaneousModulus, INSTANTANEOUS_SHEAR),
            quantity("poisson_ratio", LaboratoryQuantity::PoissonRatio, POISSON),
            key(
                "viscosity",
                Shape::Viscosity,
                "Viscosity of the fluid, in Pa s or with a unit; or how it changes with temperature.",
            ),
            quantity("retardation_time", LaboratoryQuantity::RetardationTime, RETARDATION),
            quantity(
                "temperature",
                LaboratoryQuantity::Temperature,
                "Temperature, in K or with a unit. It shifts times and viscosity by their laws.",
            ),
            quantity(
                "speed",
                LaboratoryQuantity::Speed,
                "Speed of a roller that slides without turning, in m/s or with a unit.",
            ),
            quantity(
                "entrainment_speed",
                LaboratoryQuantity::EntrainmentSpeed,
                "Mean speed of both surfaces, in m/s or with a unit.",
            ),
            quantity(
                "slide_roll_ratio",
                LaboratoryQuantity::SlideRollRatio,
                "Slide-to-roll ratio (flat_speed - roller_speed)/entrainment_speed, -2 to 2, or in per cent as \"50 %\".",
            ),
            quantity(
                "roller_speed",
                LaboratoryQuantity::RollerSpeed,
                "Speed of the roller's surface, in m/s or with a unit.",
            ),
            quantity("flat_speed", LaboratoryQuantity::FlatSpeed, "Speed of the flat, in m/s or with a unit."),
            key("f", Shape::Axis(Quantity::Strength), "Strength of retardation E0/Einf - 1; 0 is elastic."),
            key(
                "swap",
                Shape::Boolean(false),
                "Run each slide_roll_ratio with the opposite one beside it, and publish their half sum and difference.",
            ),
            key(
                "roughness",
                Shape::Quantity,
                "Combined r.m.s. roughness of both surfaces, in m or with a unit; for notes only.",
            ),
            key("thickness", Shape::Quantity, "Thickness of the soft layer, in m or with a unit; for notes only."),
        ],
    ),
    ("substrate", BODY),
    ("flat", BODY),
    ("roller", BODY),
    (
        "solver",
        &[
            key("method", Shape::Computed(schema::method), "The method of solution."),
            key(
                "tolerance",
                Shape::Computed(schema::tolerance),
                "Relative error wanted in mu_v, mu_h and c by the collocation method.",
            ),
            key(
                "time_limit",
                Shape::Computed(schema::time_limit),
                "Seconds after which a case is given up; inf is no limit.",
            ),
            key("relaxation", Shape::Section("solver.relaxation"), "Settings of the relaxation method."),
        ],
    ),
    (
        "solver.relaxation",
        &[
            key(
                "domain",
                Shape::Computed(schema::domain),
                "Where the grid lies: \"auto\", on the dry contact of each case, or both ends in a0.",
            ),
            key("points", Shape::Computed(schema::grid_points), "Grid points, an odd number."),
            key(
                "tolerance",
                Shape::Computed(schema::residual),
                "Residuals of Reynolds' equation and of the load at which a case has converged.",
            ),
            key("acceleration", Shape::Computed(schema::acceleration), "none is the paper's plain iteration."),
            key(
                "estimate",
                Shape::Boolean(false),
                "Estimate errors from a second grid of half as many intervals; from 201 points on.",
            ),
        ],
    ),
    (
        "output",
        &[
            key("fields", Shape::Computed(schema::fields), "Fields to keep along x; [] for none."),
            key("x", Shape::Axis(Quantity::Position), "Where fields are kept, in a0; the inlet is at x > 0."),
            key(
                "field_precision",
                Shape::Computed(schema::field_precision),
                "single rounds fields to 24 significant bits, which makes them less than half as large.",
            ),
            key(
                "limits",
                Shape::Boolean(true),
                "Keep the dry limit and the large-beta approximation beside the solution.",
            ),
            key("cavity_shear", Shape::Computed(schema::cavity_shear), "What fills the gap behind the film."),
            key(
                "sensitivities",
                Shape::Boolean(false),
                "Publish derivatives of friction with respect to each input; with the collocation method.",
            ),
        ],
    ),
    (
        "surface",
        &[
            key(
                "tolerance",
                Shape::Computed(schema::surface_tolerance),
                "The largest relative error of each quantity.",
            ),
            key("quantities", Shape::Computed(schema::surface_quantities), "The columns that the surface has."),
            key(
                "points",
                Shape::Computed(schema::surface_points),
                "The number of random points that the surface is compared with.",
            ),
            key("seed", Shape::Computed(schema::surface_seed), "The seed of these points."),
        ],
    ),
];

const RELAXED: &str = "Young's modulus after a long time, in Pa or with a unit.";
const INSTANTANEOUS: &str = "Young's modulus at once, in Pa or with a unit.";
const RELAXED_SHEAR: &str = "Shear modulus after a long time, in Pa or with a unit.";
const INSTANTANEOUS_SHEAR: &str = "Shear modulus at once, in Pa or with a unit.";
const POISSON: &str = "Poisson's ratio, 0 to 0.5.";
const RETARDATION: &str = "Retardation time, in s or with a unit.";

/// The keys of a body.
const BODY: &[Key] = &[
    key("rigid", Shape::Boolean(false), "A rigid body, without any other key."),
    key(
        "modes",
        Shape::Computed(schema::modes),
        "Retardation modes: shares of f, which add up to 1, and times over the one in alpha.",
    ),
    key(
        "relaxation",
        Shape::Computed(schema::relaxation),
        "Terms of the relaxation modulus (a Prony series), or a file with them.",
    ),
    key("relaxed_modulus", Shape::Quantity, RELAXED),
    key("instantaneous_modulus", Shape::Quantity, INSTANTANEOUS),
    key("relaxed_shear_modulus", Shape::Quantity, RELAXED_SHEAR),
    key("instantaneous_shear_modulus", Shape::Quantity, INSTANTANEOUS_SHEAR),
    key("poisson_ratio", Shape::Computed(schema::poisson_ratio), POISSON),
    key("f", Shape::Computed(schema::strength), "Strength of retardation E0/Einf - 1 of the body."),
    key("retardation_time", Shape::Quantity, RETARDATION),
    key("shift", Shape::Computed(schema::shift), "How all times of the body change with the temperature."),
];

/// The keys of a section, and what is known of them.
pub(super) fn entries(section: &str) -> &'static [Key] {
    SECTIONS.iter().find(|(name, _)| *name == section).map_or(&[], |(_, keys)| keys)
}

/// The keys of a section of sweep files, for files that have it too.
pub fn keys(section: &str) -> Vec<&'static str> {
    entries(section).iter().map(|key| key.name).collect()
}

/// The keys of a section that are sections themselves, each with the name of its own.
pub(super) fn within(section: &str) -> Vec<(&'static str, &'static str)> {
    let named = entries(section).iter().filter_map(|key| match key.shape {
        Shape::Section(name) => Some((key.name, name)),
        _ => None,
    });
    named.collect()
}

/// The first section below the top level that knows a key.
pub(super) fn home(key: &str) -> Option<&'static str> {
    SECTIONS[1..].iter().find(|(_, keys)| keys.iter().any(|known| known.name == key)).map(|(name, _)| *name)
}

/// The table behind an entry, with the keys its path says.
pub(super) fn section<'t>(entry: &Entry<'t>) -> Result<Section<'t>, Fault> {
    entry.section(&keys(entry.path()), home)
}
