//! The section `[surface]`, and sweep files whose ranges are the domain of a surface.
//!
//! A surface file is a sweep file in which each axis with more than one value is a range. The range gives the two ends,
//! and how values are spread between them; `points` may be left out. On an axis of α, a range may begin at 0 and end at
//! `inf`; one of f may begin at 0 on a scale of logarithms.

use std::path::Path;

use toml::Spanned;
use toml::de::{DeArray, DeValue};

use super::file::{KIND, interpret_document};
use super::sections::section;
use super::specification::{Method, Sweep};
use super::spelling::{Keys, Spelt};
use crate::{Column, Grid};
use stribeck_input::{Entry, Fault, InputError, RANGE_KEYS, Readings, Section, each};
use stribeck_surface::Spread;

/// The tolerances that a surface may have.
pub(super) const TOLERANCE: std::ops::RangeInclusive<f64> = 1e-7..=1e-2;
/// The numbers of points that it may be compared with.
pub(super) const POINTS: std::ops::RangeInclusive<usize> = 1000..=100_000;
/// The seeds of these points.
pub(super) const SEED: std::ops::RangeInclusive<usize> = 0..=u32::MAX as usize;
/// Nodes and points to compare with are solved so many times tighter.
const TIGHTER: f64 = 100.0;

/// A sweep whose ranges are the domain of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceSweep {
    /// The sweep over the ends of the ranges: what is the same everywhere. Its tolerance is that of the nodes.
    pub sweep: Sweep,
    /// One to three axes: α, β, f, or quantities of the laboratory and f.
    pub axes: Vec<RangeAxis>,
    /// What is asked of the surface.
    pub settings: SurfaceSettings,
}

/// An axis of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeAxis {
    /// Its name.
    pub name: String,
    /// Its unit; `1` for pure numbers.
    pub units: String,
    /// What it is, in words.
    pub long_name: String,
    /// How values are spread between its ends.
    pub spread: Spread,
    /// Its least value.
    pub from: f64,
    /// Its largest value.
    pub to: f64,
}

/// What is asked of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceSettings {
    /// The largest relative error wanted, from 1e-7 to 1e-2.
    pub tolerance: f64,
    /// The columns wanted; those that are parts of the drag have it before them.
    pub quantities: Vec<Column>,
    /// The number of random points that the surface is compared with.
    pub points: usize,
    /// The seed of these points.
    pub seed: u64,
}

impl Default for SurfaceSettings {
    fn default() -> Self {
        let quantities = vec![Column::MuDrag, Column::MuV, Column::MuH, Column::C];
        Self { tolerance: 1e-4, quantities, points: 1000, seed: 1 }
    }
}

impl SurfaceSweep {
    /// Reads a sweep file whose ranges are the domain of a surface.
    ///
    /// # Errors
    /// [`InputError`] if the file cannot be read or is no such sweep.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, InputError> {
        let folder = path.as_ref().parent();
        stribeck_input::read(KIND, path.as_ref(), |name, text| interpret(name, text, folder))
    }

    /// Takes the text of such a sweep file called `name`.toml.
    ///
    /// # Errors
    /// [`InputError::Invalid`] if the text is no such sweep.
    pub fn parse(name: &str, text: &str) -> Result<Self, InputError> {
        stribeck_input::parse(name, text, |name, text| interpret(name, text, None))
    }
}

fn interpret(name: &str, text: &str, folder: Option<&Path>) -> Result<SurfaceSweep, Fault> {
    let mut spelt = Spelt::of(stribeck_input::document(text)?.into_inner(), Keys::OF_SWEEP);
    let mut ranges = Vec::new();
    let mut faults = Vec::new();
    for (section, table) in spelt.document.iter_mut() {
        if let (true, DeValue::Table(table)) = (is_home(section.get_ref()), table.get_mut()) {
            for (key, value) in table.iter_mut() {
                match take_range(key.get_ref(), value) {
                    Ok(range) => ranges.extend(range),
                    Err(fault) => faults.push((fault, value.span())),
                }
            }
        }
    }
    for (fault, place) in faults {
        spelt.told(fault, place);
    }
    let root = Section::new("", 0..0, &spelt.document, &super::sections::keys(""), |_| None)?;
    let settings = root.optional("surface", read_settings).map(Option::unwrap_or_default);
    let read = (interpret_document(name, text, &spelt.document, folder), settings).all();
    let (mut sweep, settings) = spelt.judge(read)?;
    let whole = |what: &str, label: &str, help: &str| Fault::new(0..text.len().min(1), what, label, help).unquoted();
    if sweep.solver.method == Method::Relaxation {
        let help = "leave `method` out: the collocation method gives the errors that a surface needs";
        return Err(whole("a surface is made by the collocation method", "method = \"relaxation\"", help));
    }
    let axes = axes_of(&sweep.grid, &ranges, &whole)?;
    sweep.solver.tolerance = sweep.solver.tolerance.min(tighter(settings.tolerance));
    sweep.output.fields = Default::default();
    sweep.output.sensitivities = false;
    sweep.output.limits = settings.quantities.contains(&Column::DryMuV);
    Ok(SurfaceSweep { sweep, axes, settings })
}

/// The tolerance of nodes: a decimal number as one would write it, so that sweeps share its cases.
fn tighter(tolerance: f64) -> f64 {
    let rounded = format!("{:.12e}", tolerance / TIGHTER).parse();
    rounded.expect("a number that was written is read")
}

/// True for the sections that axes stand in.
fn is_home(section: &str) -> bool {
    matches!(section, "axes" | "laboratory")
}

/// A range of a file: the key, its place, and whether it is on a scale of logarithms.
struct Range {
    key: String,
    span: std::ops::Range<usize>,
    logarithmic: bool,
}

/// Puts the list of its two ends in place of a range; refuses lists of several values.
fn take_range(key: &str, value: &mut Spanned<DeValue<'_>>) -> Result<Option<Range>, Fault> {
    let span = value.span();
    match value.get_ref() {
        DeValue::Array(items) if items.len() > 1 => {
            let what = format!("`{key}` has several values, and a surface runs over ranges");
            let help = "write { from = 1.0, to = 1000.0, scale = \"log\" }, or one value";
            return Err(Fault::new(span, what, "a list", help).unquoted());
        }
        DeValue::Table(table) if table.contains_key("from") => {
            if let Some(other) = table.keys().find(|name| !RANGE_KEYS.contains(&name.get_ref().as_ref())) {
                let what = format!("a range has `from`, `to`, `points` and `scale`, and no `{}`", other.get_ref());
                return Err(Fault::new(other.span(), what, "unknown key", "remove it").unquoted());
            }
            let Some(to) = table.get("to").cloned() else {
                let help = "write { from = 1.0, to = 1000.0, scale = \"log\" }";
                return Err(Fault::new(span, format!("the range `{key}` needs `to`"), "no `to`", help).unquoted());
            };
            let range = Section::new(key, span.clone(), table, &RANGE_KEYS, |_| None)?;
            range.optional("points", |points| points.whole(2..=1_000_000))?;
            let logarithmic = match table.get("scale").map(|scale| (scale.span(), scale.get_ref())) {
                None => false,
                Some((_, DeValue::String(scale))) if scale == "log" => true,
                Some((_, DeValue::String(scale))) if scale == "linear" => false,
                Some((span, _)) => {
                    let what = format!("the scale of `{key}` must be \"linear\" or \"log\"");
                    return Err(Fault::new(span, what, "neither", "write scale = \"log\""));
                }
            };
            let mut list = DeArray::new();
            list.push(table.get("from").cloned().expect("looked for above"));
            list.push(to);
            *value.get_mut() = DeValue::Array(list);
            return Ok(Some(Range { key: key.to_owned(), span, logarithmic }));
        }
        _ => {}
    }
    Ok(None)
}

/// The axes of a surface over the ends of these ranges.
fn axes_of(grid: &Grid, ranges: &[Range], whole: &impl Fn(&str, &str, &str) -> Fault) -> Result<Vec<RangeAxis>, Fault> {
    let mut dimensions: Vec<_> = grid.dimensions().into_iter().filter(|it| it.values.len() > 1).collect();
    // α, β, f, S, as they are spoken of; f behind the quantities of the laboratory.
    let order = |name: &str| match name {
        "f" => 1,
        "slide_roll" => 2,
        _ => 0,
    };
    dimensions.sort_by_key(|dimension| order(&dimension.name));
    if !(1..=3).contains(&dimensions.len()) {
        let help = "make one to three axes ranges, as in alpha = { from = 1e-3, to = 1e3, scale = \"log\" }, and give \
                    the others one value";
        let what = format!("a surface has one to three axes that are ranges, and this file has {}", dimensions.len());
        return Err(whole(&what, "not one to three", help));
    }
    let strongest = dimensions.iter().find(|it| it.name == "f").map(|it| it.values[1]);
    let strongest = strongest.unwrap_or_else(|| grid.numbers([0, 0, 0].into())[0]);
    let axis = |dimension: crate::Dimension| {
        let crate::Dimension { name, units, long_name, values } = dimension;
        let range = ranges.iter().find(|range| range.key == name);
        let Some(range) = range else {
            let what = format!("`{name}` has several values, and a surface runs over ranges");
            return Err(whole(&what, "not a range", "give it one value, or a range"));
        };
        let [from, to] = [values[0], values[1]];
        let spread = match name.as_str() {
            // The film and the solid relax where α is between 1/(1 + f) and 1.
            "alpha" if from == 0.0 || to.is_infinite() => Spread::Compact { center: (1.0 + strongest).powf(-0.5) },
            // Friction is linear in f up to about 1e-3, below which hysteresis does not count beside the rest.
            "f" if from == 0.0 && range.logarithmic => Spread::Compact { center: 1.0 },
            _ if range.logarithmic && from > 0.0 => Spread::Log,
            _ if range.logarithmic => {
                let what = format!("`{name}` cannot begin at {from} on a scale of logarithms");
                return Err(Fault::new(range.span.clone(), what, "begins at or below 0", "begin above 0").unquoted());
            }
            _ => Spread::Linear,
        };
        Ok(RangeAxis { name, units, long_name, spread, from, to })
    };
    dimensions.into_iter().map(axis).collect()
}

/// Reads `[surface]`.
pub(super) fn read_settings(entry: &Entry<'_>) -> Result<SurfaceSettings, Fault> {
    let section = section(entry)?;
    let defaults = SurfaceSettings::default();
    let (tolerance, quantities, points, seed) = (
        section.optional("tolerance", read_tolerance),
        section.optional("quantities", read_quantities),
        section.optional("points", |entry| entry.whole(POINTS)),
        section.optional("seed", |entry| entry.whole(SEED)),
    )
        .all()?;
    Ok(SurfaceSettings {
        tolerance: tolerance.unwrap_or(defaults.tolerance),
        quantities: quantities.unwrap_or(defaults.quantities),
        points: points.unwrap_or(defaults.points),
        seed: seed.map_or(defaults.seed, |seed| seed as u64),
    })
}

fn read_tolerance(entry: &Entry<'_>) -> Result<f64, Fault> {
    let tolerance = entry.number()?;
    match TOLERANCE.contains(&tolerance) {
        true => Ok(tolerance),
        false => {
            let remedy = "it is the largest relative error of each quantity, as in 1e-4";
            Err(entry.not_allowed("from 1e-7 to 1e-2", remedy))
        }
    }
}

fn read_quantities(entry: &Entry<'_>) -> Result<Vec<Column>, Fault> {
    let read = |item: Entry<'_>| {
        let name = item.text()?;
        Column::named(name).filter(|column| is_function(*column)).ok_or_else(|| {
            let known: Vec<_> = Column::ALL.into_iter().filter(|it| is_function(*it)).map(Column::name).collect();
            let help = format!("write one of {}", known.join(", "));
            item.fault(format!("a surface has no quantity `{name}`"), "not a quantity", help)
        })
    };
    let mut quantities: Vec<Column> = Vec::new();
    for column in each(entry.require_list("write names of columns, as in [\"mu_drag\", \"c\"]")?.map(read))? {
        if !quantities.contains(&column) {
            quantities.push(column);
        }
    }
    match quantities.is_empty() {
        true => Err(entry.fault("`surface.quantities` is empty", "empty", "name a column, as in [\"mu_drag\"]")),
        false => Ok(quantities),
    }
}

/// True for columns that are functions of the place: estimated errors and residuals are none, and the approximation of
/// μ_h is a formula.
pub(super) fn is_function(column: Column) -> bool {
    !(column.is_error() || matches!(column, Column::LoadResidual | Column::EnergyResidual | Column::ApproxMuH))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<SurfaceSweep, String> {
        SurfaceSweep::parse("a", text).map_err(|error| error.to_string())
    }

    #[test]
    fn ranges_become_axes() {
        let text = "[axes]\nalpha = { from = 0.0, to = inf }\nbeta = { from = 1.0, to = 1e8, scale = \"log\", points = 9 }\n\
                    f = { from = 0.0, to = 99.0, scale = \"log\" }\n[surface]\ntolerance = 1e-3\nquantities = [\"c\"]\n";
        let surface = parse(text).expect("valid");
        let names: Vec<_> = surface.axes.iter().map(|axis| (axis.name.as_str(), axis.from, axis.to)).collect();
        assert_eq!(names, [("alpha", 0.0, f64::INFINITY), ("beta", 1.0, 1e8), ("f", 0.0, 99.0)]);
        let spreads: Vec<_> = surface.axes.iter().map(|axis| axis.spread).collect();
        assert_eq!(spreads, [Spread::Compact { center: 0.1 }, Spread::Log, Spread::Compact { center: 1.0 }]);
        assert_eq!(surface.settings.quantities, [Column::C]);
        assert_eq!(surface.sweep.solver.tolerance, 1e-5);
        assert_eq!(surface.sweep.text, text);
    }

    #[test]
    fn laboratory_ranges_have_units() {
        let text = "[laboratory]\nradius = \"2 mm\"\nload = { from = \"10 N/m\", to = \"100 N/m\", scale = \"log\" }\n\
                    relaxed_modulus = \"100 kPa\"\npoisson_ratio = 0.5\nviscosity = \"1 Pa s\"\nretardation_time = \"20 ms\"\n\
                    f = 10.0\nspeed = { from = \"1 mm/s\", to = \"1 m/s\", points = 5, scale = \"log\" }\n";
        let surface = parse(text).expect("valid");
        let ends: Vec<_> = surface.axes.iter().map(|axis| (axis.name.as_str(), axis.from, axis.to)).collect();
        assert_eq!(ends, [("load", 10.0, 100.0), ("speed", 1e-3, 1.0)]);
    }

    #[test]
    fn what_is_no_surface_is_refused_with_its_place() {
        let with = |axes: &str, more: &str| parse(&format!("[axes]\n{axes}\n{more}")).expect_err("refused");
        let good = "alpha = [1.0]\nbeta = { from = 1.0, to = 10.0, scale = \"log\" }\nf = [1.0]";
        assert!(with("alpha = [1.0, 2.0]\nbeta = [1.0]\nf = [1.0]", "").contains("several values"));
        assert!(with("alpha = [1.0]\nbeta = [1.0]\nf = [1.0]", "").contains("this file has 0"));
        assert!(with(good, "[solver]\nmethod = \"relaxation\"").contains("collocation"));
        assert!(with(good, "[surface]\nquantities = [\"error_c\"]").contains("no quantity `error_c`"));
        assert!(with(good, "[surface]\ntolerance = 1.0").contains("from 1e-7 to 1e-2"));
        assert!(with("alpha = [1.0]\nbeta = { from = 1.0 }\nf = [1.0]", "").contains("needs `to`"));
        assert!(parse(&format!("[axes]\n{good}")).is_ok());
    }
}
