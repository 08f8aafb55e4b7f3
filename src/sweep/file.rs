//! The sections of a sweep file, one function each.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use toml::de::DeTable;

use super::axis::{self, Quantity};
use super::entry::{Entry, Section};
use super::error::{Fault, SweepError};
use super::specification::{Axes, Method, SolverSettings, Sweep};
use crate::model::{CavityShear, FieldSelection, Output, RetardationMode, Substrate};
use crate::relaxation::{Acceleration, Domain, Settings};

/// Most bytes of a sweep file.
const LARGEST_FILE: u64 = 16 << 20;

/// Most grid points of a sweep.
const MOST_CASES: u128 = 1_000_000_000;

/// How far a fixed domain may reach to either side, in units of a₀; the contact lies within ±1.
const FARTHEST: f64 = 100.0;

/// The tables of a sweep file and their keys; the first one is the top level.
const SECTIONS: [(&str, &[&str]); 6] = [
    ("", &["title", "axes", "substrate", "solver", "output"]),
    ("axes", &["f", "alpha", "beta"]),
    ("substrate", &["modes"]),
    ("solver", &["method", "tolerance", "relaxation"]),
    ("solver.relaxation", &["domain", "points", "tolerance", "acceleration", "estimate"]),
    ("output", &["fields", "x", "limits", "cavity_shear"]),
];

const AXES_EXAMPLE: &str = "add the three axes, for instance\n[axes]\nf = [100.0]\nalpha = [1.0, 10.0]\n\
     beta = { from = 10.0, to = 1000.0, points = 9, scale = \"log\" }";

impl Sweep {
    /// Reads a sweep file.
    ///
    /// # Errors
    /// [`SweepError`] if the file cannot be read, is larger than 16 MiB, is not UTF-8 or not a valid sweep.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, SweepError> {
        let path = path.as_ref();
        let unreadable = |cause| SweepError::Unreadable { path: path.to_owned(), cause };
        let mut bytes = Vec::new();
        let file = File::open(path).map_err(unreadable)?;
        file.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(unreadable)?;
        if bytes.len() as u64 > LARGEST_FILE {
            return Err(SweepError::TooLarge { path: path.to_owned(), limit: LARGEST_FILE });
        }
        let text = String::from_utf8(bytes).map_err(|error| {
            let valid_up_to = error.utf8_error().valid_up_to();
            SweepError::not_text(path.to_owned(), error.as_bytes(), valid_up_to)
        })?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        interpret(&name, &text).map_err(|fault| fault.located(&path.display().to_string(), &text))
    }

    /// Takes the text of a sweep file called `name`.toml.
    ///
    /// # Errors
    /// [`SweepError::Invalid`] if the text is not a valid sweep.
    pub fn parse(name: &str, text: &str) -> Result<Self, SweepError> {
        interpret(name, text).map_err(|fault| fault.located(&format!("{name}.toml"), text))
    }
}

fn interpret(name: &str, text: &str) -> Result<Sweep, Fault> {
    let document = DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or(text.len()..text.len());
        let help = "TOML has lines `key = value` under headers [section]; texts stand in double quotes, lists in \
                    brackets; a key may stand only once";
        Fault::new(span, format!("not valid TOML: {}", error.message()), "here", help)
    })?;
    let root = Section::new("", 0..0, document.get_ref(), keys(""), home)?;
    let axes = read_axes(&root.require("axes", AXES_EXAMPLE)?)?;
    Ok(Sweep {
        title: root.get("title").map(|title| read_title(&title)).transpose()?.unwrap_or_else(|| name.to_owned()),
        axes,
        substrate: root.get("substrate").map(|entry| read_substrate(&entry)).transpose()?.unwrap_or_default(),
        solver: root.get("solver").map(|entry| read_solver(&entry)).transpose()?.unwrap_or_default(),
        output: root.get("output").map(|entry| read_output(&entry)).transpose()?.unwrap_or_default(),
        text: text.to_owned(),
        name: name.to_owned(),
    })
}

/// The keys of a section.
fn keys(section: &str) -> &'static [&'static str] {
    SECTIONS.iter().find(|(name, _)| *name == section).map_or(&[], |(_, keys)| keys)
}

/// The first section below the top level that knows a key.
fn home(key: &str) -> Option<&'static str> {
    SECTIONS[1..].iter().find(|(_, keys)| keys.contains(&key)).map(|(name, _)| *name)
}

/// The table behind an entry, with the keys its path says.
fn section<'t>(entry: &Entry<'t>) -> Result<Section<'t>, Fault> {
    entry.section(keys(entry.path()), home)
}

fn read_title(entry: &Entry<'_>) -> Result<String, Fault> {
    let title = entry.text()?;
    let printable = !title.trim().is_empty() && !title.chars().any(char::is_control);
    if printable && title.chars().count() <= 500 {
        Ok(title.to_owned())
    } else {
        let what = "`title` must be one line of 1 to 500 characters";
        Err(entry.fault(what, "not one such line", "shorten the title, or leave it out: the file's name is used then"))
    }
}

fn read_axes(entry: &Entry<'_>) -> Result<Axes, Fault> {
    let section = section(entry)?;
    let axis = |key, quantity| {
        let help = format!(
            "add {key} = [10.0, 100.0], say, or {key} = {{ from = 1.0, to = 1000.0, points = 4, scale = \"log\" }}"
        );
        axis::read(&section.require(key, &help)?, quantity)
    };
    let axes = Axes {
        f: axis("f", Quantity::Strength)?,
        alpha: axis("alpha", Quantity::SlideTime)?,
        beta: axis("beta", Quantity::InverseHersey)?,
    };
    let [f, alpha, beta] = [axes.f.len(), axes.alpha.len(), axes.beta.len()];
    let cases = f as u128 * alpha as u128 * beta as u128;
    if cases > MOST_CASES {
        let what =
            format!("a sweep may have at most {MOST_CASES} cases, this one has {f} f x {alpha} alpha x {beta} beta");
        return Err(section.fault(
            what,
            format!("{cases} cases"),
            "take fewer points, or split the sweep into several",
        ));
    }
    Ok(axes)
}

fn read_substrate(entry: &Entry<'_>) -> Result<Substrate, Fault> {
    let example = "write modes = [{ share = 0.7, time = 1.0 }, { share = 0.3, time = 100.0 }]";
    let Some(modes_entry) = section(entry)?.get("modes") else { return Ok(Substrate::default()) };
    let read_mode = |mode: Entry<'_>| {
        let mode = mode.section(&["share", "time"], |_| None)?;
        let [share_entry, time_entry] = [mode.require("share", example)?, mode.require("time", example)?];
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
    let modes = modes_entry.require_list(example)?.map(read_mode).collect::<Result<Vec<_>, _>>()?;
    Substrate::new(modes).map_err(|error| {
        let help =
            "scale the shares so that they add up to 1; for the usual single retardation time leave [substrate] out";
        modes_entry.fault(format!("`substrate.modes`: {error}"), "these modes", help).unquoted()
    })
}

fn read_solver(entry: &Entry<'_>) -> Result<SolverSettings, Fault> {
    let section = section(entry)?;
    let defaults = SolverSettings::default();
    Ok(SolverSettings {
        method: section.get("method").map(|entry| read_method(&entry)).transpose()?.unwrap_or_default(),
        tolerance: match section.get("tolerance") {
            Some(entry) => {
                let tolerance = entry.number()?;
                if !(tolerance > 0.0 && tolerance < 1.0) {
                    let help = "it is the relative error wanted by the collocation method, as in 1e-5; the relaxation \
                                method has its own in [solver.relaxation]";
                    return Err(entry.fault("`solver.tolerance` must be above 0 and below 1", "out of range", help));
                }
                tolerance
            }
            None => defaults.tolerance,
        },
        relaxation: section
            .get("relaxation")
            .map(|entry| read_relaxation(&entry))
            .transpose()?
            .unwrap_or(defaults.relaxation),
    })
}

fn read_method(entry: &Entry<'_>) -> Result<Method, Fault> {
    match entry.choice(&[("relaxation", Some(Method::Relaxation)), ("collocation", None)])? {
        Some(method) => Ok(method),
        None => {
            let what = "the collocation method is not in this version yet; `solver.method` must be \"relaxation\"";
            Err(entry.fault(what, "not in this version", "write method = \"relaxation\""))
        }
    }
}

fn read_relaxation(entry: &Entry<'_>) -> Result<Settings, Fault> {
    let section = section(entry)?;
    let defaults = Settings::default();
    let accelerations = [("anderson", Acceleration::Anderson), ("none", Acceleration::None)];
    Ok(Settings {
        domain: section.get("domain").map(|entry| read_domain(&entry)).transpose()?.unwrap_or(defaults.domain),
        points: section.get("points").map(|entry| read_points(&entry)).transpose()?.unwrap_or(defaults.points),
        tolerance: match section.get("tolerance") {
            Some(entry) => {
                let tolerance = entry.number()?;
                if !(1e-12..=1e-2).contains(&tolerance) {
                    let what = "`solver.relaxation.tolerance` must be from 1e-12 to 1e-2";
                    let help = "it is the residual at which a case counts as converged; 1e-8 is a good value";
                    return Err(entry.fault(what, "out of range", help));
                }
                tolerance
            }
            None => defaults.tolerance,
        },
        acceleration: match section.get("acceleration") {
            Some(entry) => entry.choice(&accelerations)?,
            None => defaults.acceleration,
        },
        estimate: section.get("estimate").map(|entry| entry.boolean()).transpose()?.unwrap_or(defaults.estimate),
    })
}

fn read_points(entry: &Entry<'_>) -> Result<usize, Fault> {
    let points = entry.whole(51..=20_001)?;
    if points % 2 == 1 {
        return Ok(points);
    }
    let help = format!(
        "coarse-to-fine solving halves the grid, which takes an even number of intervals: write {}; 401, 801 and 1601 \
         can be halved several times and are good",
        points + 1
    );
    Err(entry.fault("`solver.relaxation.points` must be an odd number from 51 to 20001", "even", help))
}

fn read_domain(entry: &Entry<'_>) -> Result<Domain, Fault> {
    let help = "write domain = \"auto\" (on the dry contact of each case), or both ends as in [-3.0, 4.0]";
    let what = "`solver.relaxation.domain` must be \"auto\" or [x_min, x_max]";
    let Some(ends) = entry.list() else {
        return match entry.text() {
            Ok("auto") => Ok(Domain::Auto),
            _ => Err(entry.fault(what, "neither", help)),
        };
    };
    let ends: Vec<Entry<'_>> = ends.take(3).collect();
    let [left, right] = ends.as_slice() else { return Err(entry.fault(what, "not two numbers", help)) };
    let (x_min, x_max) = (left.number()?, right.number()?);
    let help = "the contact lies within -1 and 1 (in units of a0), and the film needs room on both sides of it, as in \
                [-3.0, 4.0]";
    if !(-FARTHEST..-1.0).contains(&x_min) {
        let what = format!("x_min of the domain must be below -1 and at least {:?}", -FARTHEST);
        return Err(left.fault(what, "not left of the contact", help));
    }
    if !(x_max > 1.0 && x_max <= FARTHEST) {
        let what = format!("x_max of the domain must be above 1 and at most {FARTHEST:?}");
        return Err(right.fault(what, "not right of the contact", help));
    }
    Ok(Domain::Fixed { x_min, x_max })
}

fn read_output(entry: &Entry<'_>) -> Result<Output, Fault> {
    let section = section(entry)?;
    let defaults = Output::default();
    let shears = [("full", CavityShear::Full), ("streamers", CavityShear::Streamers), ("none", CavityShear::None)];
    Ok(Output {
        fields: section.get("fields").map(|entry| read_fields(&entry)).transpose()?.unwrap_or(defaults.fields),
        x: match section.get("x") {
            Some(entry) => axis::read(&entry, Quantity::Position)?.into(),
            None => defaults.x,
        },
        limits: section.get("limits").map(|entry| entry.boolean()).transpose()?.unwrap_or(defaults.limits),
        cavity_shear: match section.get("cavity_shear") {
            Some(entry) => entry.choice(&shears)?,
            None => defaults.cavity_shear,
        },
    })
}

fn read_fields(entry: &Entry<'_>) -> Result<FieldSelection, Fault> {
    type Part = fn(&mut FieldSelection) -> &mut bool;
    let parts: [(&str, Part); 3] = [
        ("pressure", |fields| &mut fields.pressure),
        ("film_thickness", |fields| &mut fields.film_thickness),
        ("displacement", |fields| &mut fields.displacement),
    ];
    let mut fields = FieldSelection::default();
    let help = "write fields = [\"pressure\", \"film_thickness\", \"displacement\"], some of them, or [] for none";
    for item in entry.require_list(help)? {
        let selected = item.choice(&parts)?(&mut fields);
        if *selected {
            let what = "a field may stand in `output.fields` only once";
            return Err(item.fault(what, "stands there before", "remove one of the two"));
        }
        *selected = true;
    }
    Ok(fields)
}
