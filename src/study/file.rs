//! A study file: its keys, and what they mean.

use std::path::Path;

use toml::de::DeTable;

use super::schema::{CASE_KEYS, KEYS, METHOD_KEYS, names};
use super::{Measure, Setting, Start, Study, Variant};
use stribeck_input::printable;
use stribeck_input::{Entry, Fault, InputError, Readings, Section, each};
use stribeck_solver::collocation::{self, Settings};
use stribeck_solver::relaxation::{self, Acceleration};
use stribeck_solver::{Parameters, Substrate};
use stribeck_sweep::{
    Axes, Keys, Method, Spelt, read_axes, read_error, read_points, read_substrate, read_title, section_keys,
};

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
    let keys = Keys { of: keys_of, within, home };
    let spelt = Spelt::of(stribeck_input::document(text)?.into_inner(), keys);
    let read = interpret_document(name, text, &spelt.document);
    spelt.judge(read)
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

/// The keys of a section; those of axes and substrate are a sweep's.
fn keys_of(section: &str) -> Vec<&'static str> {
    match section {
        "" => names(&KEYS).to_vec(),
        "case" => names(&CASE_KEYS).to_vec(),
        "method" => names(&METHOD_KEYS).to_vec(),
        other => section_keys(other),
    }
}

/// The sections within a section.
fn within(section: &str) -> Vec<(&'static str, &'static str)> {
    if section.is_empty() { ["axes", "substrate", "case", "method"].map(|name| (name, name)).to_vec() } else { vec![] }
}

/// Takes the document of a study file. What does not depend on a section with a fault is read all the same.
fn interpret_document(name: &str, text: &str, document: &DeTable<'_>) -> Result<Study, Fault> {
    let root = Section::new("", 0..0, document, &names(&KEYS), home)?;
    let substrate = root.optional("substrate", read_substrate).map(Option::unwrap_or_default);
    // A substrate with a fault may have an f.
    let own_f = substrate.as_ref().map_or(Some(1.0), |read| read.material.f);
    let axes = root.optional("axes", |entry| read_box(entry, own_f));
    let single = root.optional("case", read_cases).map(Option::unwrap_or_default);
    let methods = root.require("method", METHOD_EXAMPLE).and_then(|entry| read_methods(&entry));
    let measure = root.optional("measure", read_measure);
    let repeats = root.optional("repeats", |entry| entry.whole(1..=MOST_REPEATS));
    let starts = [("alone", Start::Alone), ("chain", Start::Chain)];
    let start = root.optional("start", |entry| entry.choice(&starts));
    let title = root.optional("title", read_title);
    let is_empty = matches!((&axes, &single), (Ok(None), Ok(single)) if single.is_empty());
    let some_case = if is_empty { root.require("axes", CASES_EXAMPLE).map(|_| ()) } else { Ok(()) };
    let substrate = (some_case, substrate).all().map(|(_, read)| read.substrate);
    let (substrate, axes, single, variants, measure, repeats, start, title) =
        (substrate, axes, single, methods, measure, repeats, start, title).all()?;
    check_rows(&root, axes.as_ref().map_or(0, Axes::cases) + single.len(), variants.len())?;
    Ok(Study {
        title: title.unwrap_or_else(|| printable(name).into_owned()),
        cases: all_cases(&root, axes.as_ref(), single, &substrate)?,
        axes,
        variants,
        measure: measure.unwrap_or(Measure { error: true, stability: false }),
        repeats: repeats.unwrap_or(3),
        start: start.unwrap_or_default(),
        text: text.to_owned(),
        name: name.to_owned(),
    })
}

/// Refuses more rows than a study may have.
fn check_rows(root: &Section<'_>, cases: usize, settings: usize) -> Result<(), Fault> {
    if cases.saturating_mul(settings) <= Study::MOST_ROWS {
        return Ok(());
    }
    let most = Study::MOST_ROWS;
    let what = format!("a study may have at most {most} rows, this one has {cases} cases x {settings} settings");
    let methods = root.require("method", METHOD_EXAMPLE)?;
    Err(methods.fault(what, "too many", "take fewer cases or settings, or split the study").unquoted())
}

/// Reads `[axes]`, which are a sweep's but for the slide-to-sum ratio.
fn read_box(entry: &Entry<'_>, own_f: Option<f64>) -> Result<Axes, Fault> {
    let no_ratio = match entry.member("slide_roll") {
        None => Ok(()),
        Some(ratio) => {
            let help = "remove it: no case changes with the slide-to-sum ratio";
            Err(ratio.fault("a study has no axis `slide_roll`", "no axis of a study", help).unquoted())
        }
    };
    (no_ratio, read_axes(entry, own_f)).all().map(|(_, axes)| axes)
}

/// The cases of the box and those that stand alone, each once.
fn all_cases(
    root: &Section<'_>,
    axes: Option<&Axes>,
    single: Vec<[f64; 3]>,
    substrate: &Substrate,
) -> Result<Vec<Parameters>, Fault> {
    let mut cases = axes.map_or_else(Vec::new, |axes| product(axes, substrate));
    let places = root.get("case").iter().filter_map(Entry::list).flatten().collect::<Vec<_>>();
    let mut faults = Vec::new();
    for ([alpha, beta, f], place) in single.into_iter().zip(places) {
        let case = Parameters { alpha, beta, f, substrate: substrate.clone() };
        if cases.contains(&case) {
            let help = "remove it; a case is solved once by each method";
            faults.push(place.fault("a case may stand there only once", "the same as one before it", help).unquoted());
        }
        cases.push(case);
    }
    Fault::of_all(faults).map_or(Ok(cases), Err)
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

/// Reads single cases: α, β and f of each.
fn read_cases(entry: &Entry<'_>) -> Result<Vec<[f64; 3]>, Fault> {
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
        let numbers = (
            number("alpha", |alpha| alpha >= 0.0, "at least 0, or inf"),
            number("beta", |beta| beta > 0.0 && beta.is_finite(), "finite and above 0"),
            number("f", |f| f >= 0.0 && f.is_finite(), "finite and at least 0"),
        );
        numbers.all().map(|(alpha, beta, f)| [alpha, beta, f])
    };
    each(entry.require_list(CASE_EXAMPLE)?.map(read))
}

fn read_measure(entry: &Entry<'_>) -> Result<Measure, Fault> {
    type Part = fn(&mut Measure) -> &mut bool;
    let parts: [(&str, Part); 2] =
        [("error", |measure| &mut measure.error), ("stability", |measure| &mut measure.stability)];
    let help = "write measure = [\"error\"], [\"stability\"] or [\"error\", \"stability\"]";
    let mut measure = Measure::default();
    each(entry.require_list(help)?.map(|item| {
        let chosen = item.choice(&parts)?(&mut measure);
        if *chosen {
            let what = "each may stand in `measure` only once";
            return Err(item.fault(what, "stands there before", "remove one of them"));
        }
        *chosen = true;
        Ok(())
    }))?;
    match measure {
        Measure { error: false, stability: false } => {
            Err(entry.fault("`measure` must name at least one thing", "empty", help))
        }
        measure => Ok(measure),
    }
}

fn read_methods(entry: &Entry<'_>) -> Result<Vec<Variant>, Fault> {
    let mut labels: Vec<String> = Vec::new();
    let methods = each(entry.require_list(METHOD_EXAMPLE)?.map(|item| {
        let section = item.section(&names(&METHOD_KEYS), |_| None)?;
        let (label, settings) = read_method(&section)?;
        if labels.contains(&label) {
            let what = format!("two methods have the label \"{label}\"");
            let help =
                "give one of them another label, as in label = \"relaxation, plain\", or put its settings to the other";
            return Err(section.get("label").unwrap_or(item).fault(what, "the second one", help).unquoted());
        }
        labels.push(label.clone());
        Ok(settings.into_iter().map(move |setting| Variant { method: label.clone(), setting }))
    }))?;
    if methods.is_empty() {
        return Err(entry.fault("`method` must name at least one method", "empty", METHOD_EXAMPLE));
    }
    Ok(methods.into_iter().flatten().collect())
}

/// The label of a method, and its settings.
fn read_method(section: &Section<'_>) -> Result<(String, Vec<Setting>), Fault> {
    let methods = [("collocation", Method::Collocation), ("relaxation", Method::Relaxation)];
    let method = section.require("method", METHOD_EXAMPLE).and_then(|entry| entry.choice(&methods));
    let settings = method.and_then(|method| match (method, section.get("panels")) {
        (Method::Collocation, None) => read_tolerances(section),
        (Method::Collocation, Some(panels)) => read_panels(section, &panels),
        (Method::Relaxation, _) => read_grids(section),
    });
    let ((default_label, settings), label) = (settings, section.optional("label", read_label)).all()?;
    Ok((label.unwrap_or(default_label), settings))
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

/// An error if keys stand there that the method does not have.
fn refuse(section: &Section<'_>, keys: &[&str], of: &str) -> Result<(), Fault> {
    let foreign = keys.iter().filter_map(|key| section.get(key).map(|entry| (key, entry)));
    let faults = foreign.map(|(key, entry)| {
        let help = format!("remove `{key}`, or put it to a method that has it");
        entry.fault(format!("{of} has no `{key}`"), "not a setting of this method", help).unquoted()
    });
    Fault::of_all(faults).map_or(Ok(()), Err)
}

/// The values of a setting: a list, or a single one.
fn values<'t, T: PartialEq + Copy>(
    entry: &Entry<'t>,
    read: impl Fn(&Entry<'t>) -> Result<T, Fault>,
) -> Result<Vec<T>, Fault> {
    let Some(items) = entry.list() else { return Ok(vec![read(entry)?]) };
    let mut before = Vec::with_capacity(items.len());
    let found = each(items.map(|item| {
        let value = read(&item)?;
        if before.contains(&value) {
            let what = format!("a value of `{}` may stand there only once", entry.path());
            return Err(item.fault(what, "stands there before", "remove one of the two"));
        }
        before.push(value);
        Ok(value)
    }))?;
    if found.is_empty() {
        let what = format!("`{}` must have at least one value", entry.path());
        return Err(entry.fault(what, "empty", "write a value, or several in brackets"));
    }
    Ok(found)
}

fn read_degree(section: &Section<'_>) -> Result<Option<usize>, Fault> {
    section.optional("degree", |entry| entry.whole(Settings::DEGREE))
}

fn read_tolerances(section: &Section<'_>) -> Result<(String, Vec<Setting>), Fault> {
    let help =
        "collocation is varied by its tolerance, as in tolerance = [1e-3, 1e-5, 1e-7], or by panels = [8, 12, 18]";
    let tolerances = section.require("tolerance", help).and_then(|entry| values(&entry, read_error));
    let foreign = refuse(section, &["points", "acceleration"], "collocation");
    let (_, tolerances, degree) = (foreign, tolerances, read_degree(section)).all()?;
    let setting = |tolerance| {
        let settings = Settings::for_tolerance(tolerance);
        Setting::Tolerance(collocation::Settings { degree: degree.unwrap_or(settings.degree), ..settings })
    };
    let label = degree.map_or("collocation".to_owned(), |degree| format!("collocation, degree {degree}"));
    Ok((label, tolerances.into_iter().map(setting).collect()))
}

fn read_panels(section: &Section<'_>, panels: &Entry<'_>) -> Result<(String, Vec<Setting>), Fault> {
    let foreign = refuse(section, &["tolerance", "points", "acceleration"], "collocation with `panels`");
    let numbers = values(panels, |entry| entry.whole(Settings::PANELS));
    let (_, numbers, degree) = (foreign, numbers, read_degree(section)).all()?;
    let degree = degree.unwrap_or(Settings::default().degree);
    let settings = numbers.into_iter().map(|panels| Setting::Panels { panels, degree }).collect();
    Ok((format!("collocation, panels of degree {degree}"), settings))
}

fn read_grids(section: &Section<'_>) -> Result<(String, Vec<Setting>), Fault> {
    let help = "relaxation is varied by the points of its grid, as in points = [201, 401, 801]";
    let points = section.require("points", help).and_then(|entry| values(&entry, read_points));
    let accelerations = [("anderson", Acceleration::Anderson), ("none", Acceleration::None)];
    let acceleration = section.optional("acceleration", |entry| entry.choice(&accelerations));
    let tolerance = section.optional("tolerance", read_residual);
    let foreign = refuse(section, &["panels", "degree"], "relaxation");
    let (_, points, tolerance, acceleration) = (foreign, points, tolerance, acceleration).all()?;
    let (defaults, acceleration) = (relaxation::Settings::default(), acceleration.unwrap_or_default());
    let tolerance = tolerance.unwrap_or(defaults.tolerance);
    let label = match acceleration {
        Acceleration::Anderson => "relaxation",
        Acceleration::None => "relaxation, plain",
    };
    let setting = |points| Setting::Grid(relaxation::Settings { points, tolerance, acceleration, ..defaults });
    Ok((label.to_owned(), points.into_iter().map(setting).collect()))
}

/// Reads the residual at which a case of relaxation counts as converged.
fn read_residual(entry: &Entry<'_>) -> Result<f64, Fault> {
    let tolerance = entry.number()?;
    if relaxation::Settings::TOLERANCE.contains(&tolerance) {
        return Ok(tolerance);
    }
    let help = "it is the residual at which a case counts as converged; 1e-8 is a good value";
    Err(entry.fault("`tolerance` of relaxation must be from 1e-12 to 1e-2", "out of range", help))
}
