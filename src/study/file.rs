//! A study file: its keys, and what they mean.

use std::path::Path;

use super::schema::{CASE_KEYS, KEYS, METHOD_KEYS, names};
use super::{Measure, Setting, Start, Study, Variant};
use stribeck_input::printable;
use stribeck_input::{Entry, Fault, InputError, Section};
use stribeck_solver::collocation::{self, Settings};
use stribeck_solver::relaxation::{self, Acceleration};
use stribeck_solver::{Parameters, Substrate};
use stribeck_sweep::{Axes, Method, read_axes, read_error, read_points, read_substrate, read_title};

/// What the file is called in messages.
const KIND: stribeck_input::Kind = "study file";

const CASES_EXAMPLE: &str = "add a box, for instance\n[axes]\nf = [100.0]\nalpha = [1.0, 10.0]\nbeta = [10.0, 100.0]\n\
     or single cases, each as\n[[case]]\nalpha = 1.0\nbeta = 100.0\nf = 10.0";
const METHOD_EXAMPLE: &str =
    "add a method, for instance\n[[method]]\nmethod = \"collocation\"\ntolerance = [1e-3, 1e-5]";
const CASE_EXAMPLE: &str = "a case is written as\n[[case]]\nalpha = 1.0\nbeta = 100.0\nf = 10.0";

/// Most repeats.
pub(super) const MOST_REPEATS: usize = 1000;
/// Longest label of a method, in characters.
pub(super) const LONGEST_LABEL: usize = 40;

impl Study {
    /// Reads a study file.
    ///
    /// # Errors
    /// [`InputError`] if the file cannot be read, is larger than 8 MiB, is not UTF-8 or not a valid study.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, InputError> {
        stribeck_input::read(KIND, path.as_ref(), interpret)
    }

    /// Takes the text of a study file called `name`.toml.
    ///
    /// # Errors
    /// [`InputError::Invalid`] if the text is not a valid study.
    pub fn parse(name: &str, text: &str) -> Result<Self, InputError> {
        stribeck_input::parse(name, text, interpret)
    }
}

fn interpret(name: &str, text: &str) -> Result<Study, Fault> {
    let document = stribeck_input::document(text)?;
    let root = Section::new("", 0..0, document.get_ref(), &names(&KEYS), home)?;
    let read_substrate = root.get("substrate").map(|entry| read_substrate(&entry)).transpose()?;
    let (substrate, own_f) = read_substrate.map(|read| (read.substrate, read.material.f)).unwrap_or_default();
    let axes = root.get("axes").map(|entry| read_axes(&entry, own_f)).transpose()?;
    if axes.as_ref().is_some_and(|axes| axes.slide_roll.is_some()) {
        let help = "remove it: no case changes with the slide-to-sum ratio";
        let section = root.require("axes", help)?;
        return Err(section.fault("a study has no axis `slide_roll`", "with `slide_roll`", help).unquoted());
    }
    let single = root.get("case").map(|entry| read_cases(&entry, &substrate)).transpose()?.unwrap_or_default();
    let number = axes.as_ref().map_or(0, Axes::cases) + single.len();
    if number == 0 {
        return Err(root.require("axes", CASES_EXAMPLE).err().expect("there is no box"));
    }
    let methods = root.require("method", METHOD_EXAMPLE)?;
    let variants = read_methods(&methods)?;
    if number.saturating_mul(variants.len()) > Study::MOST_ROWS {
        let what = format!(
            "a study may have at most {} rows, this one has {number} cases x {} settings",
            Study::MOST_ROWS,
            variants.len()
        );
        return Err(methods.fault(what, "too many", "take fewer cases or settings, or split the study").unquoted());
    }
    let measure = root.get("measure").map(|entry| read_measure(&entry)).transpose()?;
    let starts = [("alone", Start::Alone), ("chain", Start::Chain)];
    let mut cases = axes.as_ref().map_or_else(Vec::new, |axes| product(axes, &substrate));
    for (case, place) in single.into_iter().zip(root.get("case").iter().filter_map(Entry::list).flatten()) {
        if cases.contains(&case) {
            let help = "remove it; a case is solved once by each method";
            return Err(place.fault("a case may stand there only once", "the same as one before it", help).unquoted());
        }
        cases.push(case);
    }
    Ok(Study {
        title: root
            .get("title")
            .map(|title| read_title(&title))
            .transpose()?
            .unwrap_or_else(|| printable(name).into_owned()),
        axes,
        cases,
        variants,
        measure: measure.unwrap_or(Measure { error: true, stability: false }),
        repeats: root.get("repeats").map(|entry| entry.whole(1..=MOST_REPEATS)).transpose()?.unwrap_or(3),
        start: root.get("start").map(|entry| entry.choice(&starts)).transpose()?.unwrap_or_default(),
        text: text.to_owned(),
        name: name.to_owned(),
    })
}

/// The section below the top level that knows a key.
fn home(key: &str) -> Option<&'static str> {
    match key {
        "f" | "alpha" | "beta" => Some("axes"),
        "modes" => Some("substrate"),
        key if names(&METHOD_KEYS).contains(&key) => Some("[method]"),
        _ => None,
    }
}

/// The cases of a box: f, then α, then β.
fn product(axes: &Axes, substrate: &Substrate) -> Vec<Parameters> {
    let mut cases = Vec::with_capacity(axes.cases());
    for &f in &axes.f {
        for &alpha in &axes.alpha {
            let case = |&beta: &f64| Parameters { alpha, beta, f, substrate: substrate.clone() };
            cases.extend(axes.beta.iter().map(case));
        }
    }
    cases
}

fn read_cases(entry: &Entry<'_>, substrate: &Substrate) -> Result<Vec<Parameters>, Fault> {
    let read = |item: Entry<'_>| {
        let case = item.section(&names(&CASE_KEYS), |_| None)?;
        let number = |key: &str, admits: fn(f64) -> bool, allowed: &str| {
            let entry = case.require(key, CASE_EXAMPLE)?;
            let value = entry.number()?;
            if admits(value) {
                return Ok(value);
            }
            Err(entry.fault(format!("`{key}` of a case must be {allowed}"), "not allowed", CASE_EXAMPLE))
        };
        Ok(Parameters {
            alpha: number("alpha", |alpha| alpha >= 0.0, "at least 0, or inf")?,
            beta: number("beta", |beta| beta > 0.0 && beta.is_finite(), "finite and above 0")?,
            f: number("f", |f| f >= 0.0 && f.is_finite(), "finite and at least 0")?,
            substrate: substrate.clone(),
        })
    };
    entry.require_list(CASE_EXAMPLE)?.map(read).collect()
}

fn read_measure(entry: &Entry<'_>) -> Result<Measure, Fault> {
    type Part = fn(&mut Measure) -> &mut bool;
    let parts: [(&str, Part); 2] =
        [("error", |measure| &mut measure.error), ("stability", |measure| &mut measure.stability)];
    let help = "write measure = [\"error\"], [\"stability\"] or [\"error\", \"stability\"]";
    let mut measure = Measure::default();
    for item in entry.require_list(help)? {
        let chosen = item.choice(&parts)?(&mut measure);
        if *chosen {
            return Err(item.fault(
                "each may stand in `measure` only once",
                "stands there before",
                "remove one of them",
            ));
        }
        *chosen = true;
    }
    match measure {
        Measure { error: false, stability: false } => {
            Err(entry.fault("`measure` must name at least one thing", "empty", help))
        }
        measure => Ok(measure),
    }
}

fn read_methods(entry: &Entry<'_>) -> Result<Vec<Variant>, Fault> {
    let mut variants: Vec<Variant> = Vec::new();
    for item in entry.require_list(METHOD_EXAMPLE)? {
        let section = item.section(&names(&METHOD_KEYS), |_| None)?;
        let (label, settings) = read_method(&section)?;
        let label_entry = section.get("label");
        if variants.iter().any(|variant| variant.method == label) {
            let what = format!("two methods have the label \"{label}\"");
            let help =
                "give one of them another label, as in label = \"relaxation, plain\", or put its settings to the other";
            return Err(label_entry.unwrap_or(item).fault(what, "the second one", help).unquoted());
        }
        variants.extend(settings.into_iter().map(|setting| Variant { method: label.clone(), setting }));
    }
    if variants.is_empty() {
        return Err(entry.fault("`method` must name at least one method", "empty", METHOD_EXAMPLE));
    }
    Ok(variants)
}

/// The label of a method, and its settings.
fn read_method(section: &Section<'_>) -> Result<(String, Vec<Setting>), Fault> {
    let methods = [("collocation", Method::Collocation), ("relaxation", Method::Relaxation)];
    let method = section.require("method", METHOD_EXAMPLE)?.choice(&methods)?;
    let (default_label, settings) = match (method, section.get("panels")) {
        (Method::Collocation, None) => read_tolerances(section)?,
        (Method::Collocation, Some(panels)) => read_panels(section, &panels)?,
        (Method::Relaxation, _) => read_grids(section)?,
    };
    let label = section.get("label").map(|entry| read_label(&entry)).transpose()?.unwrap_or(default_label);
    Ok((label, settings))
}

fn read_label(entry: &Entry<'_>) -> Result<String, Fault> {
    let label = entry.text()?;
    let fits =
        !label.trim().is_empty() && label.chars().count() <= LONGEST_LABEL && !label.chars().any(char::is_control);
    match fits {
        true => Ok(label.to_owned()),
        false => {
            let what = format!("`label` must be one line of 1 to {LONGEST_LABEL} characters");
            Err(entry.fault(what, "not one such line", "it names the method in tables and pictures"))
        }
    }
}

/// An error if a key stands there that the method does not have.
fn refuse(section: &Section<'_>, keys: &[&str], of: &str) -> Result<(), Fault> {
    match keys.iter().find_map(|key| section.get(key).map(|entry| (key, entry))) {
        Some((key, entry)) => {
            let help = format!("remove `{key}`, or put it to a method that has it");
            Err(entry.fault(format!("{of} has no `{key}`"), "not a setting of this method", help).unquoted())
        }
        None => Ok(()),
    }
}

/// The values of a setting: a list, or a single one.
fn values<'t, T: PartialEq>(entry: &Entry<'t>, read: impl Fn(&Entry<'t>) -> Result<T, Fault>) -> Result<Vec<T>, Fault> {
    let Some(items) = entry.list() else { return Ok(vec![read(entry)?]) };
    let mut found = Vec::with_capacity(items.len());
    for item in items {
        let value = read(&item)?;
        if found.contains(&value) {
            let what = format!("a value of `{}` may stand there only once", entry.path());
            return Err(item.fault(what, "stands there before", "remove one of the two"));
        }
        found.push(value);
    }
    if found.is_empty() {
        let what = format!("`{}` must have at least one value", entry.path());
        return Err(entry.fault(what, "empty", "write a value, or several in brackets"));
    }
    Ok(found)
}

fn read_degree(section: &Section<'_>) -> Result<Option<usize>, Fault> {
    section.get("degree").map(|entry| entry.whole(Settings::DEGREE)).transpose()
}

fn read_tolerances(section: &Section<'_>) -> Result<(String, Vec<Setting>), Fault> {
    refuse(section, &["points", "acceleration"], "collocation")?;
    let help =
        "collocation is varied by its tolerance, as in tolerance = [1e-3, 1e-5, 1e-7], or by panels = [8, 12, 18]";
    let tolerances = values(&section.require("tolerance", help)?, |entry| read_error(entry))?;
    let degree = read_degree(section)?;
    let setting = |tolerance| {
        let settings = Settings::for_tolerance(tolerance);
        Setting::Tolerance(collocation::Settings { degree: degree.unwrap_or(settings.degree), ..settings })
    };
    let label = degree.map_or("collocation".to_owned(), |degree| format!("collocation, degree {degree}"));
    Ok((label, tolerances.into_iter().map(setting).collect()))
}

fn read_panels(section: &Section<'_>, panels: &Entry<'_>) -> Result<(String, Vec<Setting>), Fault> {
    refuse(section, &["tolerance", "points", "acceleration"], "collocation with `panels`")?;
    let numbers = values(panels, |entry| entry.whole(Settings::PANELS))?;
    let degree = read_degree(section)?.unwrap_or(Settings::default().degree);
    let settings = numbers.into_iter().map(|panels| Setting::Panels { panels, degree }).collect();
    Ok((format!("collocation, panels of degree {degree}"), settings))
}

fn read_grids(section: &Section<'_>) -> Result<(String, Vec<Setting>), Fault> {
    refuse(section, &["panels", "degree"], "relaxation")?;
    let help = "relaxation is varied by the points of its grid, as in points = [201, 401, 801]";
    let points = values(&section.require("points", help)?, |entry| read_points(entry))?;
    let defaults = relaxation::Settings::default();
    let tolerance = match section.get("tolerance") {
        Some(entry) => {
            let tolerance = entry.number()?;
            let (allowed, what) = (relaxation::Settings::TOLERANCE, "of relaxation must be from 1e-12 to 1e-2");
            if !allowed.contains(&tolerance) {
                let help = "it is the residual at which a case counts as converged; 1e-8 is a good value";
                return Err(entry.fault(format!("`tolerance` {what}"), "out of range", help));
            }
            tolerance
        }
        None => defaults.tolerance,
    };
    let accelerations = [("anderson", Acceleration::Anderson), ("none", Acceleration::None)];
    let acceleration =
        section.get("acceleration").map(|entry| entry.choice(&accelerations)).transpose()?.unwrap_or_default();
    let label = match acceleration {
        Acceleration::Anderson => "relaxation",
        Acceleration::None => "relaxation, plain",
    };
    let setting = |points| Setting::Grid(relaxation::Settings { points, tolerance, acceleration, ..defaults });
    Ok((label.to_owned(), points.into_iter().map(setting).collect()))
}
