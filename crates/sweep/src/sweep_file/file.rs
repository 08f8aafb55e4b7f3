//! A sweep file as a whole: reading it, its keys, and the sections that say which cases there are.

use std::path::Path;

use toml::de::DeTable;

use super::bodies::{self, ReadBodies};
use super::named_series::NamedSeries;
use super::sections::{home, keys, section};
use super::specification::{SolverSettings, Sweep};
use super::spelling::{Keys, Spelt};
use super::{laboratory, output, solver, surface};
use crate::{Axes, Grid};
use stribeck_input::{Entry, Fault, InputError, Quantity, Readings, Section, read_axis};
use stribeck_input::{is_printable, printable};
use stribeck_solver::Output;

/// What the file is called in messages.
pub(super) const KIND: stribeck_input::Kind = "sweep file";

/// Most grid points of a sweep.
const MOST_CASES: u128 = 1_000_000_000;

const AXES_EXAMPLE: &str = "add the three axes, for instance\n[axes]\nf = [100.0]\nalpha = [1.0, 10.0]\n\
     beta = { from = 10.0, to = 1000.0, points = 9, scale = \"log\" }";

impl Sweep {
    /// Reads a sweep file, and the files that it names beside it.
    ///
    /// # Errors
    /// [`InputError`] if the file cannot be read, is larger than 8 MiB, is not UTF-8 or not a valid sweep.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, InputError> {
        let folder = path.as_ref().parent();
        stribeck_input::read(KIND, path.as_ref(), |name, text| interpret(name, text, folder))
    }

    /// Takes the text of a sweep file called `name`.toml.
    ///
    /// # Errors
    /// [`InputError::Invalid`] if the text is not a valid sweep.
    pub fn parse(name: &str, text: &str) -> Result<Self, InputError> {
        stribeck_input::parse(name, text, |name, text| interpret(name, text, None))
    }
}

fn interpret(name: &str, text: &str, folder: Option<&Path>) -> Result<Sweep, Fault> {
    let spelt = Spelt::of(stribeck_input::document(text)?.into_inner(), Keys::OF_SWEEP);
    let read = interpret_document(name, text, &spelt.document, folder);
    spelt.judge(read)
}

/// Takes the document of a sweep file, whose text it is, but for axes that stand for others.
///
/// What does not depend on a section with a fault is read and judged all the same, so that all faults are told.
pub(super) fn interpret_document(
    name: &str,
    text: &str,
    document: &DeTable<'_>,
    folder: Option<&Path>,
) -> Result<Sweep, Fault> {
    let root = Section::new("", 0..0, document, &keys(""), home)?;
    let files = NamedSeries::read(&root, folder);
    let (bodies, stand_in) = (bodies::read(&root, &files), ReadBodies::stand_in());
    let grid = read_grid(&root, bodies.as_ref().unwrap_or(&stand_in));
    let title = root.optional("title", read_title);
    let surface = root.optional("surface", surface::read_settings);
    let solver = root.optional("solver", solver::read).map(Option::unwrap_or_default);
    // what can be asked for depends on how it is solved
    let solved = solver.as_ref().map_or_else(|_| SolverSettings::default(), |solver| *solver);
    let output = root.optional("output", |entry| output::read(entry, &solved));
    let output = output.map(|output| output.unwrap_or_else(output::default));
    let fields = match (&grid, &output) {
        (Ok(grid), Ok(wanted)) => check_fields(&root, grid, &wanted.output),
        _ => Ok(()),
    };
    let checks = (fields, surface).all();
    let (bodies, grid, title, solver, wanted, _) = (bodies, grid, title, solver, output, checks).all()?;
    Ok(Sweep {
        title: title.unwrap_or_else(|| printable(name).into_owned()),
        grid,
        substrate: bodies.substrate,
        solver,
        output: wanted.output,
        field_precision: wanted.field_precision,
        text: files.written_into(text)?,
        name: name.to_owned(),
    })
}

/// Refuses the shear on a roller that turns without the film that it follows from.
fn check_fields(root: &Section<'_>, grid: &Grid, output: &Output) -> Result<(), Fault> {
    let rolls = match grid {
        Grid::Laboratory(axes) => axes.rolls(),
        Grid::Dimensionless(axes) => axes.slide_roll.is_some(),
    };
    if !(rolls && output.fields.shear_traction) || output.fields.film_thickness {
        return Ok(());
    }
    let help = "add \"film_thickness\" to output.fields";
    let output = root.require("output", help)?;
    let entry = section(&output)?.require("fields", help)?;
    let what = "where the roller may turn `shear_traction` follows from the film: `output.fields` needs \
                `film_thickness` too";
    Err(entry.fault(what, "no film_thickness among them", help))
}

/// Reads a title.
pub fn read_title(entry: &Entry<'_>) -> Result<String, Fault> {
    let title = entry.text()?;
    let visible = !title.trim().is_empty() && is_printable(title);
    if visible && title.chars().count() <= 500 {
        Ok(title.to_owned())
    } else {
        let what = "`title` must be one line of 1 to 500 characters";
        Err(entry.fault(what, "not one such line", "shorten the title, or leave it out: the file's name is used then"))
    }
}

/// Reads `[axes]`, or `[laboratory]` with f in either.
fn read_grid(root: &Section<'_>, bodies: &ReadBodies) -> Result<Grid, Fault> {
    let Some(laboratory) = root.get("laboratory") else {
        let entry = root.require("axes", AXES_EXAMPLE)?;
        let axes = read_axes(&entry, bodies.flat.f)?;
        check_ratios(&entry, &axes, bodies.substrate.of_roller() > 0)?;
        return Ok(Grid::Dimensionless(axes));
    };
    let axes = root.optional("axes", section);
    let axis_of_f = axes.and_then(|axes| {
        let Some(axes) = axes else { return Ok(None) };
        let others = ["slide_roll", "alpha", "beta"].into_iter().filter_map(|key| axes.get(key)).map(|other| {
            let what = format!("`{}` may not stand beside [laboratory], which it follows from", other.path());
            let help = "remove it; an axis of [laboratory], the speed for instance, takes its place";
            other.fault(what, "follows from [laboratory]", help)
        });
        let alone = Fault::of_all(others).map_or(Ok(()), Err);
        (alone, axes.optional("f", |entry| read_axis(entry, Quantity::Strength))).all().map(|(_, f)| f)
    });
    laboratory::read(&laboratory, axis_of_f, bodies).map(Grid::Laboratory)
}

/// Refuses what a ratio S makes of bodies at rest. At S = −1 the flat rests and is relaxed, whatever the axis α says; and
/// α, which is that of the flat, says nothing of a soft roller, which alone moves then.
fn check_ratios(entry: &Entry<'_>, axes: &Axes, roller_retards: bool) -> Result<(), Fault> {
    let rests = axes.slide_roll.as_ref().is_some_and(|ratios| ratios[0] == -1.0);
    let ratios = section(entry)?.get("slide_roll");
    let Some(ratios) = ratios.filter(|_| rests) else { return Ok(()) };
    if roller_retards {
        let what = "at slide_roll = -1 the flat is at rest and the soft roller alone moves: `axes.alpha` is that of the \
                    flat, and infinite whatever the speed of the roller is";
        let help = "begin above -1, say slide_roll = [-0.99]; or describe both bodies and their speeds in [laboratory], \
                    where slide_roll_ratio = -2 is a flat at rest";
        return Err(ratios.fault(what, "no time of the roller is known here", help).unquoted());
    }
    if axes.alpha == [f64::INFINITY] || axes.f == [0.0] {
        return Ok(());
    }
    let what = "where slide_roll is -1 the flat is at rest in the contact, where alpha is infinite: \
                `axes.alpha` must be [inf] then";
    let help = "begin above -1, or write alpha = [inf]";
    Err(ratios.fault(what, "-1 beside a finite alpha", help).unquoted())
}

/// Reads `[axes]`; f may be left out where a material has its own.
pub fn read_axes(entry: &Entry<'_>, own_f: Option<f64>) -> Result<Axes, Fault> {
    let section = section(entry)?;
    let axis = |key, quantity| {
        let help = format!(
            "add {key} = [10.0, 100.0], say, or {key} = {{ from = 1.0, to = 1000.0, points = 4, scale = \"log\" }}"
        );
        read_axis(&section.require(key, &help)?, quantity)
    };
    let slide_roll = section.optional("slide_roll", |entry| read_axis(entry, Quantity::SlideRoll));
    let f = match own_f.filter(|_| section.get("f").is_none()) {
        Some(f) => Ok(vec![f]),
        None => axis("f", Quantity::Strength),
    };
    let (slide_roll, f, alpha, beta) =
        (slide_roll, f, axis("alpha", Quantity::SlideTime), axis("beta", Quantity::InverseHersey)).all()?;
    let axes = Axes { slide_roll, f, alpha, beta };
    let [f, alpha, beta] = [axes.f.len(), axes.alpha.len(), axes.beta.len()];
    let ratios = axes.slide_roll.as_ref().map_or(1, Vec::len);
    let cases = ratios as u128 * f as u128 * alpha as u128 * beta as u128;
    if cases > MOST_CASES {
        let what = format!(
            "a sweep may have at most {MOST_CASES} cases, this one has {}{f} f x {alpha} alpha x {beta} beta",
            if ratios > 1 { format!("{ratios} slide_roll x ") } else { String::new() }
        );
        return Err(section.fault(
            what,
            format!("{cases} cases"),
            "take fewer points, or split the sweep into several",
        ));
    }
    Ok(axes)
}
