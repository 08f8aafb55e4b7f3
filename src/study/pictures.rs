//! A study as pictures.

use std::ops::Range;

use super::{Row, Study, Variant};
use crate::pictures::Chart;
use stribeck_charts::{Cell, ColourScale, Map, MethodLine, Outcome, Panel, SettingPoint, WorkPrecision};
use stribeck_solver::shortest;
use stribeck_sweep::Axes;

/// A picture of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name of its files, without extension.
    pub name: String,
    /// What is drawn.
    pub chart: Chart,
}

/// Symbols of the quantities of [`Errors::values`](super::Errors::values).
const SYMBOLS: [&str; 4] = ["μᵥ", "μₕ", "c", "uₘᵢₙ"];

/// A number of a row that is drawn as a map.
struct Quantity {
    /// Part of the picture's name.
    name: &'static str,
    /// Beside the colour bar.
    label: &'static str,
    /// The number.
    of: fn(&Row) -> Option<f64>,
    /// Whether it means the same for all methods, so that all pictures of it have the same colours.
    comparable: bool,
}

/// The maps.
const MAPS: [Quantity; 7] = [
    Quantity { name: "iterations", label: "iterations", of: |row| Some(row.iterations as f64), comparable: false },
    Quantity { name: "error", label: "largest error of μᵥ, μₕ and c", of: Row::largest_error, comparable: true },
    Quantity {
        name: "estimated_error",
        label: "largest estimated error of μᵥ, μₕ and c",
        of: |row| row.stability.as_ref()?.estimated_error,
        comparable: true,
    },
    Quantity {
        name: "pressure_min",
        label: "largest tension / largest pressure",
        of: |row| Some(-row.stability.as_ref()?.pressure_min?),
        comparable: false,
    },
    Quantity {
        name: "load_residual",
        label: "load residual",
        of: |row| row.stability.as_ref()?.load_residual,
        comparable: false,
    },
    Quantity {
        name: "condition",
        label: "condition number",
        of: |row| row.stability.as_ref()?.condition,
        comparable: true,
    },
    Quantity {
        name: "seed_difference",
        label: "difference between two seeds",
        of: |row| row.stability.as_ref()?.seed_difference,
        comparable: true,
    },
];

/// Most rows of maps in one picture.
const MAP_ROWS: usize = 3;

/// The settings of each picture of maps: those of one method, as far as there is room.
fn pages(study: &Study) -> Vec<Range<usize>> {
    let pages = |(_, variants): (&str, Range<usize>)| {
        let firsts = variants.clone().step_by(MAP_ROWS);
        firsts.map(move |first| first..variants.end.min(first + MAP_ROWS))
    };
    study.methods().into_iter().flat_map(pages).collect()
}

/// Every name, without extension, that the pictures of a study may have had.
pub fn is_picture_name(name: &str) -> bool {
    let errors = || super::Errors::QUANTITIES.iter().map(|name| format!("error_{name}"));
    let page = |rest: &str| rest.is_empty() || rest.strip_prefix('_').is_some_and(|page| page.parse::<u32>().is_ok());
    let map = |quantity: &Quantity| {
        name.strip_prefix("map_").and_then(|rest| rest.strip_prefix(quantity.name)).is_some_and(page)
    };
    errors().any(|error| error == name) || MAPS.iter().any(map)
}

/// The pictures of a study: one of each error against run time, and the maps of its box, if it has one.
pub fn pictures(study: &Study, rows: &[Row]) -> Vec<Picture> {
    let mut found = Vec::new();
    if study.measure.error {
        for (quantity, (name, symbol)) in super::Errors::QUANTITIES.iter().zip(SYMBOLS).enumerate() {
            let chart = work_precision(study, rows, quantity, symbol);
            if chart.lines.iter().all(|line| line.points.iter().all(|point| point.cases.is_empty())) {
                continue;
            }
            found.push(Picture { name: format!("error_{name}"), chart: Chart::WorkPrecision(chart) });
        }
    }
    if let Some(axes) = study.axes.as_ref().filter(|_| study.measure.stability) {
        for quantity in MAPS {
            for (page, variants) in (1..).zip(pages(study)) {
                let map = map(study, axes, rows, variants, &quantity);
                let page = if page == 1 { String::new() } else { format!("_{page}") };
                found.push(Picture { name: format!("map_{}{page}", quantity.name), chart: Chart::Map(map) });
            }
        }
    }
    found
}

fn work_precision(study: &Study, rows: &[Row], quantity: usize, symbol: &str) -> WorkPrecision {
    let outcome = |row: &Row| match (&row.failure, row.errors[quantity]) {
        (Some(_), _) => Outcome::Failed,
        (None, Some(error)) => Outcome::Error(error),
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
        subtitle: match study.cases.len() {
            1 => "one case".to_owned(),
            cases => format!("{cases} cases; large markers: medians"),
        },
        x_label: "seconds for a case".to_owned(),
        y_label: format!("relative error of {symbol}"),
        lines: study.methods().into_iter().map(line).collect(),
    }
}

fn map(study: &Study, axes: &Axes, rows: &[Row], variants: Range<usize>, quantity: &Quantity) -> Map {
    let (columns, alphas, betas) = (axes.f.len(), axes.alpha.len(), axes.beta.len());
    let mut panels = vec![Panel { cells: vec![Cell::Absent; alphas * betas] }; columns * variants.len()];
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for row in rows.iter().filter(|row| row.case < axes.cases()) {
        let cell = match (&row.failure, (quantity.of)(row)) {
            (Some(_), _) => Cell::Failed,
            // −0 is 0
            (None, Some(number)) if number.is_finite() => Cell::Value(number + 0.0),
            (None, _) => Cell::Unknown,
        };
        if let Cell::Value(value) = cell
            && value > 0.0
            && (quantity.comparable || variants.contains(&row.variant))
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
        subtitle: quantity.label.to_owned(),
        x_label: "α".to_owned(),
        y_label: "β".to_owned(),
        columns: axes.f.iter().map(|f| format!("f = {}", shortest(*f))).collect(),
        rows: study.variants[variants].iter().map(name).collect(),
        x: axes.alpha.clone(),
        y: axes.beta.clone(),
        panels,
        scale: ColourScale {
            label: quantity.label.to_owned(),
            logarithmic: true,
            range: (least < most).then_some((least, most)),
        },
        contours: false,
    }
}
