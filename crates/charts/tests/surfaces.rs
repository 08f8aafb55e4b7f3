//! Surfaces in space from outside: what is given is drawn, holes as holes, and what lies behind is hidden.

use crate::chart_files::{check_formats, points, polygons, texts, with};
use crate::laws::laws;
use proptest::prelude::*;
use roxmltree::Document;
use stribeck_charts::{Chart, Paper, Surface3d, Surface3dCurve, Surface3dPanel};

const VERMILLION: &str = "#D55E00";
const GREEN: &str = "#009E73";
const WALL: &str = "#F7F7F7";

fn powers(from: i32, count: usize) -> Vec<f64> {
    (from..).take(count).map(|power| 10f64.powi(power)).collect()
}

fn surface3d(x: Vec<f64>, y: Vec<f64>, height: impl Fn(usize, usize) -> Option<f64>) -> Surface3d {
    let heights = (0..x.len() * y.len()).map(|k| height(k % x.len(), k / x.len())).collect();
    Surface3d {
        title: "Generalized Stribeck surface".to_string(),
        subtitle: "f = 100".to_string(),
        x_label: "α".to_string(),
        y_label: "β".to_string(),
        z_label: "friction coefficient".to_string(),
        x,
        y,
        logarithmic: false,
        range: None,
        panels: vec![Surface3dPanel { label: "μᵥ".to_string(), heights, curves: vec![] }],
    }
}

/// Cells that are filled: a polygon of n neighbours in a row has 2n + 2 corners.
fn cells(document: &Document) -> usize {
    polygons(document).map(|polygon| points(&polygon).len() / 2 - 1).sum()
}

/// The middle of the heights of a surface's corners.
fn middle(document: &Document) -> f64 {
    let heights: Vec<f64> = polygons(document).flat_map(|polygon| points(&polygon)).map(|point| point.1).collect();
    heights.iter().sum::<f64>() / heights.len() as f64
}

#[test]
fn a_surface_has_its_axes_panels_and_curves_named() {
    let mut chart = surface3d(powers(-3, 7), powers(1, 3), |i, j| Some(0.5 + 0.1 * (i as f64).sin() + 0.02 * j as f64));
    let mut other = chart.panels[0].clone();
    other.label = "dry limit".to_string();
    chart.panels.push(other);
    for panel in &mut chart.panels {
        for label in ["limit", "approximation"] {
            let points = vec![(1e-3, 1000.0, 0.5), (1.0, 1000.0, 0.6), (1e3, 1000.0, 0.5)];
            panel.curves.push(Surface3dCurve { label: label.to_string(), points });
        }
    }
    let svg = check_formats(&chart);
    let document = Document::parse(&svg).unwrap();
    let texts = texts(&document);
    let count = |wanted: &str| texts.iter().filter(|text| *text == wanted).count();
    for (wanted, times) in [
        ("Generalized Stribeck surface", 1),
        ("f = 100", 1),
        ("μv", 1),
        ("dry limit", 1),
        ("α", 2),
        ("β", 2),
        ("limit", 1),
        ("approximation", 1),
        // Beside the first box and beside the colour bar.
        ("friction coefficient", 2),
        ("10⁰", 2),
        ("10²", 4),
    ] {
        assert_eq!(count(wanted), times, "{wanted} among {texts:?}");
    }
    assert!(
        with(&document, &[("stroke", VERMILLION)]).count() > 4 && with(&document, &[("stroke", GREEN)]).count() > 4
    );
}

laws! {
    seed: 21, cases: 48;

    /// Every cell whose corners have heights is drawn, and no other.
    fn a_place_without_a_height_is_a_hole(
        (columns, heights) in (2..9usize, 2..9usize).prop_flat_map(|(columns, rows)| {
            (Just(columns), prop::collection::vec(prop::option::weighted(0.8, -1.0..1.0f64), columns * rows))
        }),
        logarithmic: bool,
    ) {
        let rows = heights.len() / columns;
        // On a logarithmic axis a zero is a hole as well.
        let shown = |height: Option<f64>| if logarithmic { height.map(|h| h.max(0.0)) } else { height };
        let known = |k: usize| shown(heights[k]).is_some_and(|height| !logarithmic || height > 0.0);
        prop_assume!((0..heights.len()).any(known));
        let mut chart = surface3d(powers(0, columns), powers(0, rows), |i, j| shown(heights[j * columns + i]));
        chart.logarithmic = logarithmic;
        let svg = chart.svg(&Paper::default()).unwrap();
        let corners = |k: usize| [k, k + 1, k + columns, k + columns + 1];
        let whole = |k: usize| k % columns + 1 < columns && corners(k).into_iter().all(known);
        let wanted = (0..heights.len() - columns).filter(|k| whole(*k)).count();
        prop_assert_eq!(cells(&Document::parse(&svg).unwrap()), wanted);
    }
}

#[test]
fn higher_values_stand_higher_in_the_colour_of_the_scale() {
    let level = |height: f64| {
        let mut chart = surface3d(powers(0, 5), powers(0, 4), |_, _| Some(height));
        chart.range = Some((0.0, 1.0));
        let svg = chart.svg(&Paper::default()).unwrap();
        let document = Document::parse(&svg).unwrap();
        let fills: Vec<&str> = polygons(&document).take(3).map(|node| node.attribute("fill").unwrap()).collect();
        assert!(fills.iter().all(|fill| *fill == fills[0]));
        (middle(&document), fills[0].to_string())
    };
    let levels: Vec<(f64, String)> = [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().map(level).collect();
    assert!(levels.windows(2).all(|pair| pair[0].0 > pair[1].0 && pair[0].1 != pair[1].1), "{levels:?}");
    // What lies beyond lies at the end, and the colour bar has a point.
    assert_eq!(level(2.0).1, levels[4].1);
    let pointed = |height: f64| {
        let mut chart = surface3d(powers(0, 2), powers(0, 2), |_, _| Some(height));
        chart.range = Some((0.0, 1.0));
        let svg = chart.svg(&Paper::default()).unwrap();
        polygons(&Document::parse(&svg).unwrap()).any(|polygon| points(&polygon).len() == 3)
    };
    assert!(pointed(2.0) && pointed(-1.0) && !pointed(0.5));
}

/// Curves at the back are painted before the surface, those in front of it after it, and those on it in between.
#[test]
fn a_surface_hides_what_lies_behind_it() {
    let order = |y: f64, z: f64| {
        let mut chart = surface3d(powers(0, 6), powers(0, 5), |_, _| Some(0.5));
        chart.range = Some((0.0, 1.0));
        chart.panels[0].curves = vec![Surface3dCurve { label: String::new(), points: vec![(1.0, y, z), (1e5, y, z)] }];
        let svg = chart.svg(&Paper::default()).unwrap();
        let document = Document::parse(&svg).unwrap();
        let kinds = document.descendants().filter_map(|node| {
            let dash = node.attribute("stroke") == Some(VERMILLION);
            let cell = node.has_tag_name("polygon") && node.attribute("fill") != Some(WALL);
            (dash || cell).then_some(dash)
        });
        // The last dash belongs to the legend, which has four.
        let kinds: Vec<bool> = kinds.collect();
        let last_cell = kinds.iter().rposition(|dash| !dash).unwrap();
        let first_dash = kinds.iter().position(|dash| *dash).unwrap();
        let rows_before = kinds[..first_dash].len();
        (rows_before, last_cell > first_dash)
    };
    assert_eq!(order(1e4, 0.9), (0, true));
    assert_eq!(order(1.0, 0.1), (4, false));
    // Two rows lie behind the grid line in the middle, and the one before it is painted first where the curve lies on
    // it.
    assert_eq!(order(1e2, 0.5), (3, true));
    assert_eq!(order(1e2, 0.2), (2, true));
}

/// The surface of the paper has 61 × 41 cases.
#[test]
fn a_fine_surface_is_a_small_file() {
    let grid = |from: f64, decades: f64, count: usize| -> Vec<f64> {
        (0..count).map(|i| 10f64.powf(from + decades * i as f64 / (count - 1) as f64)).collect()
    };
    let (x, y) = (grid(-3.0, 6.0, 61), grid(1.0, 2.0, 41));
    let (alpha, beta) = (x.clone(), y.clone());
    let chart = surface3d(x, y, |i, j| {
        let slide = alpha[i].log10();
        Some(0.6 * (-slide * slide).exp() + 0.5 / beta[j].sqrt())
    });
    let svg = chart.svg(&Paper::default()).unwrap();
    assert_eq!(cells(&Document::parse(&svg).unwrap()), 60 * 40);
    assert!(svg.len() < 300_000, "{} bytes", svg.len());
}

#[test]
fn surfaces_that_do_not_fit_are_refused() {
    let good = surface3d(powers(0, 3), powers(0, 2), |_, _| Some(1.0));
    let refused = |change: &dyn Fn(&mut Surface3d), says: &str| {
        let mut chart = good.clone();
        change(&mut chart);
        let error = chart.svg(&Paper::default()).unwrap_err().to_string();
        assert!(error.contains(says), "{error}");
    };
    let curve = |point| Surface3dCurve { label: "limit".to_string(), points: vec![point] };
    refused(&|chart| chart.x = vec![1.0], "axis with two values");
    refused(&|chart| chart.y = vec![0.0, 1.0], "above zero");
    refused(&|chart| chart.x = vec![1.0, 3.0, 2.0], "increase");
    refused(&|chart| chart.x[2] = f64::INFINITY, "finite");
    refused(&|chart| chart.panels.clear(), "no panel");
    refused(&|chart| chart.panels = vec![chart.panels[0].clone(); 4], "at most three");
    refused(&|chart| chart.panels[0].heights.truncate(5), "has 5 heights in panel 1, but its axes ask for 6");
    refused(&|chart| chart.panels[0].heights[4] = Some(f64::NAN), "α = 10, β = 10");
    refused(&|chart| (chart.logarithmic, chart.panels[0].heights[4]) = (true, Some(-1.0)), "below zero");
    refused(&|chart| chart.panels[0].heights = vec![None; 6], "no height");
    refused(&|chart| chart.range = Some((1.0, 1.0)), "from a lower to a higher");
    refused(&|chart| chart.panels[0].curves = vec![curve((0.5, 1.0, 1.0))], "between the first and the last value");
    refused(&|chart| chart.panels[0].curves = vec![curve((1.0, 1.0, f64::NAN))], "the curve \"limit\"");
}
