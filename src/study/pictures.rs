//! A study as pictures.

use std::ops::Range;

use super::{Row, Study, Variant};
use crate::figures::{Cell, ColourScale, FigureError, Map, MethodLine, Outcome, Panel, SettingPoint, WorkPrecision};
use crate::sweep::Axes;

/// A picture in both formats.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name of its files, without extension.
    pub name: String,
    /// As SVG.
    pub svg: String,
    /// As PNG.
    pub png: Vec<u8>,
}

/// Symbols of the quantities of [`Errors::values`](super::Errors::values).
const SYMBOLS: [&str; 4] = ["μᵥ", "μₕ", "c", "uₘᵢₙ"];

/// A number of a row that is drawn as a map.
type Quantity = (&'static str, &'static str, fn(&Row) -> Option<f64>);

/// The maps: name, label of the colours, number.
const MAPS: [Quantity; 7] = [
    ("iterations", "iterations", |row| Some(row.iterations as f64)),
    ("error", "largest error of μᵥ, μₕ and c", |row| Some(row.errors?.largest())),
    ("estimated_error", "largest estimated error of μᵥ, μₕ and c", |row| row.stability.as_ref()?.estimated_error),
    ("pressure_min", "largest tension / largest pressure", |row| Some(-row.stability.as_ref()?.pressure_min?)),
    ("load_residual", "load residual", |row| row.stability.as_ref()?.load_residual),
    ("condition", "condition number", |row| row.stability.as_ref()?.condition),
    ("seed_difference", "difference between two seeds", |row| row.stability.as_ref()?.seed_difference),
];

/// Most rows of maps in one picture; more settings go to further pictures with the same colours.
const MAP_ROWS: usize = 4;

/// The pictures of a study: one of each error against run time, and the maps of its box, if it has one.
///
/// # Errors
/// [`FigureError`] if a picture cannot be drawn.
pub fn pictures(study: &Study, rows: &[Row]) -> Result<Vec<Picture>, FigureError> {
    let mut found = Vec::new();
    if study.measure.error {
        for (quantity, (name, symbol)) in super::Errors::QUANTITIES.iter().zip(SYMBOLS).enumerate() {
            let chart = work_precision(study, rows, quantity, symbol);
            if chart.lines.iter().all(|line| line.points.iter().all(|point| point.cases.is_empty())) {
                continue;
            }
            found.push(Picture { name: format!("error_{name}"), svg: chart.svg()?, png: chart.png()? });
        }
    }
    if let Some(axes) = study.axes.as_ref().filter(|_| study.measure.stability) {
        for (name, label, number) in MAPS {
            for (page, first) in (1..).zip((0..study.variants.len()).step_by(MAP_ROWS)) {
                let variants = first..study.variants.len().min(first + MAP_ROWS);
                let map = map(study, axes, rows, variants, label, number);
                let page = if page == 1 { String::new() } else { format!("_{page}") };
                found.push(Picture { name: format!("map_{name}{page}"), svg: map.svg()?, png: map.png()? });
            }
        }
    }
    Ok(found)
}

fn work_precision(study: &Study, rows: &[Row], quantity: usize, symbol: &str) -> WorkPrecision {
    let outcome = |row: &Row| match (&row.failure, row.errors) {
        (Some(_), _) => Outcome::Failed,
        (None, Some(errors)) => Outcome::Error(errors.values()[quantity]),
        (None, None) => Outcome::Unknown,
    };
    let point = |variant: usize| SettingPoint {
        label: study.variants[variant].setting.mark(),
        cases: rows
            .iter()
            .filter(|row| row.variant == variant)
            .filter_map(|row| Some((row.cost?.seconds, outcome(row))))
            .collect(),
    };
    let line = |(method, variants): (&str, Range<usize>)| MethodLine {
        label: method.to_owned(),
        points: variants.map(point).collect(),
    };
    WorkPrecision {
        title: study.title.clone(),
        subtitle: format!("{} cases; large markers: medians", study.cases.len()),
        x_label: "seconds for a case".to_owned(),
        y_label: format!("relative error of {symbol}"),
        lines: study.methods().into_iter().map(line).collect(),
    }
}

fn map(
    study: &Study,
    axes: &Axes,
    rows: &[Row],
    variants: Range<usize>,
    label: &str,
    number: fn(&Row) -> Option<f64>,
) -> Map {
    let (columns, alphas, betas) = (axes.f.len(), axes.alpha.len(), axes.beta.len());
    let mut panels = vec![Panel { cells: vec![Cell::Absent; alphas * betas] }; columns * variants.len()];
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for row in rows.iter().filter(|row| row.case < axes.cases()) {
        let cell = match (&row.failure, number(row)) {
            (Some(_), _) => Cell::Failed,
            // −0 is 0
            (None, Some(number)) if number.is_finite() => Cell::Value(number + 0.0),
            (None, _) => Cell::Unknown,
        };
        if let Cell::Value(value) = cell
            && value > 0.0
        {
            (least, most) = (least.min(value), most.max(value));
        }
        if variants.contains(&row.variant) {
            let (i_f, i_alpha, i_beta) = (row.case / (alphas * betas), row.case / betas % alphas, row.case % betas);
            panels[(row.variant - variants.start) * columns + i_f].cells[i_beta * alphas + i_alpha] = cell;
        }
    }
    let name = |variant: &Variant| format!("{}, {}", variant.method, variant.setting.words());
    Map {
        title: study.title.clone(),
        subtitle: label.to_owned(),
        x_label: "α".to_owned(),
        y_label: "β".to_owned(),
        columns: axes.f.iter().map(|f| format!("f = {f}")).collect(),
        rows: study.variants[variants].iter().map(name).collect(),
        x: axes.alpha.clone(),
        y: axes.beta.clone(),
        panels,
        scale: ColourScale {
            label: label.to_owned(),
            logarithmic: true,
            range: (least < most).then_some((least, most)),
        },
    }
}
