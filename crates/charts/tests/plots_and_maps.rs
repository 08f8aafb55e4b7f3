//! Charts from outside: what is given is drawn, failures as failures, in well-formed SVG and in PNG of the promised
//! width.

use crate::chart_files::{check_formats, number, texts, with};
use roxmltree::{Document, Node};
use stribeck_charts::Outcome::{Error, Failed, Unknown};
use stribeck_charts::{
    Cell, Chart, ChartError, ColourScale, Map, MethodLine, Outcome, Panel, Paper, SettingPoint, WorkPrecision,
};

const BLUE: &str = "#0072B2";
const VERMILLION: &str = "#D55E00";
const FAILED: &str = "#FAD6D0";
const UNKNOWN: &str = "#D0D0D0";

fn setting(label: &str, cases: &[(f64, Outcome)]) -> SettingPoint {
    SettingPoint { label: label.to_string(), cases: cases.to_vec() }
}

fn work_precision(lines: Vec<(&str, Vec<SettingPoint>)>) -> WorkPrecision {
    let line = |(label, points): (&str, Vec<SettingPoint>)| MethodLine { label: label.to_string(), points };
    WorkPrecision {
        title: "Error & time <of both>".to_string(),
        subtitle: "all cases".to_string(),
        x_label: "seconds for a case".to_string(),
        y_label: "relative error of μᵥ".to_string(),
        lines: lines.into_iter().map(line).collect(),
    }
}

/// Two methods, with failed and exact cases.
fn two_methods() -> WorkPrecision {
    work_precision(vec![
        (
            "collocation",
            vec![
                setting("1e-3", &[(0.01, Error(1e-4)), (0.02, Error(3e-4)), (0.04, Error(2e-5))]),
                setting("1e-5", &[(0.03, Error(1e-6)), (0.05, Error(0.0)), (0.06, Error(2e-6)), (0.07, Unknown)]),
            ],
        ),
        (
            "relaxation",
            vec![
                setting("401", &[(0.3, Error(1e-2)), (0.5, Failed), (0.6, Error(2e-2))]),
                setting("801", &[(2.0, Failed), (3.0, Failed)]),
            ],
        ),
    ])
}

fn map(columns: &[&str], rows: &[&str], x: &[f64], y: &[f64], cell: impl Fn(usize) -> Cell) -> Map {
    let owned = |labels: &[&str]| labels.iter().map(|label| label.to_string()).collect();
    let cells = x.len() * y.len();
    let panel = |p: usize| Panel { cells: (0..cells).map(|i| cell(p * cells + i)).collect() };
    Map {
        title: "Estimated error".to_string(),
        subtitle: "tolerance 1e-5".to_string(),
        x_label: "α".to_string(),
        y_label: "β".to_string(),
        columns: owned(columns),
        rows: owned(rows),
        x: x.to_vec(),
        y: y.to_vec(),
        panels: (0..columns.len() * rows.len()).map(panel).collect(),
        scale: ColourScale { label: "relative error".to_string(), logarithmic: true, range: None },
        contours: false,
    }
}

#[test]
fn every_label_is_in_the_picture() {
    let chart = two_methods();
    let text = check_formats(&chart);
    let texts = texts(&Document::parse(&text).unwrap());
    for wanted in [
        "Error & time <of both>",
        "all cases",
        "seconds for a case",
        "relative error of μv",
        "collocation",
        "relaxation",
        "1e-3",
        "1e-5",
        "401",
        "1 of 3 failed",
        "801",
        "all 2 failed",
        "failed",
        "0 (exact)",
        "case that failed",
    ] {
        assert!(texts.iter().any(|text| text == wanted), "{wanted} is not among {texts:?}");
    }
}

#[test]
fn each_case_is_a_marker_and_each_failed_case_a_cross() {
    let chart = two_methods();
    let svg = chart.svg(&Paper::default()).unwrap();
    let document = Document::parse(&svg).unwrap();
    for (line, colour) in chart.lines.iter().zip([BLUE, VERMILLION]) {
        let cases = || line.points.iter().flat_map(|point| &point.cases);
        let solved = cases().filter(|(_, error)| matches!(error, Error(_))).count();
        let settings =
            line.points.iter().filter(|point| point.cases.iter().any(|case| matches!(case.1, Error(_)))).count();
        assert_eq!(with(&document, &[("fill", colour), ("opacity", "0.35")]).count(), solved);
        // One more in the legend.
        assert_eq!(with(&document, &[("fill", colour), ("opacity", "1")]).count(), settings + 1);
        let strokes = with(&document, &[("stroke", colour), ("stroke-width", "3.6")]).count();
        assert_eq!(strokes, 2 * cases().filter(|(_, error)| *error == Failed).count());
    }
}

#[test]
fn failed_cases_lie_above_and_exact_ones_below_all_others() {
    let svg = two_methods().svg(&Paper::default()).unwrap();
    let document = Document::parse(&svg).unwrap();
    let heights: Vec<f64> =
        with(&document, &[("fill", BLUE), ("opacity", "0.35")]).map(|marker| number(&marker, "cy")).collect();
    // The fifth case of the first method has no error at all.
    assert!((0..6).filter(|i| *i != 4).all(|i| heights[i] < heights[4]), "{heights:?}");
    let highest = heights.iter().copied().fold(f64::INFINITY, f64::min);
    for cross in with(&document, &[("stroke", VERMILLION), ("stroke-width", "3.6")]) {
        let ends = cross.attribute("points").unwrap().split([' ', ',']).filter(|n| !n.is_empty()).collect::<Vec<_>>();
        assert!(ends[1].parse::<f64>().unwrap() < highest && ends[3].parse::<f64>().unwrap() < highest);
    }
}

#[test]
fn places_follow_seconds_and_errors() {
    let cases: Vec<(f64, Outcome)> = (0..40).map(|i| (1e-3 * 1.2f64.powi(i), Error(1e-12 * 1.9f64.powi(i)))).collect();
    let svg = work_precision(vec![("one", vec![setting("all", &cases)])]).svg(&Paper::default()).unwrap();
    let document = Document::parse(&svg).unwrap();
    let places: Vec<(f64, f64)> = with(&document, &[("fill", BLUE), ("opacity", "0.35")])
        .map(|marker| (number(&marker, "cx"), number(&marker, "cy")))
        .collect();
    assert_eq!(places.len(), cases.len());
    assert!(places.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 > pair[1].1), "{places:?}");
}

#[test]
fn the_order_of_cases_does_not_move_the_medians() {
    let cases = [(0.1, Error(1e-3)), (0.2, Error(1e-5)), (0.7, Failed), (0.3, Error(1e-4)), (0.25, Error(2e-4))];
    let mut other = cases;
    other.reverse();
    let medians = |cases: &[(f64, Outcome)]| {
        let svg = work_precision(vec![("one", vec![setting("all", cases)])]).svg(&Paper::default()).unwrap();
        let document = Document::parse(&svg).unwrap();
        let places: Vec<(f64, f64)> = with(&document, &[("fill", BLUE), ("opacity", "1")])
            .map(|marker| (number(&marker, "cx"), number(&marker, "cy")))
            .collect();
        places
    };
    assert_eq!(medians(&cases), medians(&other));
}

/// A case that was solved without a known error counts among the cases of its setting, and leaves no other trace.
#[test]
fn cases_without_a_known_error_are_drawn_nowhere() {
    let with_unknown = |unknown: &[(f64, Outcome)]| {
        let cases = |known: &[(f64, Outcome)]| [known, unknown].concat();
        work_precision(vec![
            ("one", vec![setting("a", &cases(&[(0.1, Error(1e-3)), (0.3, Error(1e-5))]))]),
            ("other", vec![setting("b", &cases(&[(0.2, Error(1e-2)), (0.4, Failed)])), setting("c", unknown)]),
            ("neither", vec![setting("d", &cases(&[(0.2, Failed)]))]),
        ])
    };
    let without = with_unknown(&[]).svg(&Paper::default()).unwrap();
    let chart = with_unknown(&[(1e-3, Unknown), (1e3, Unknown)]);
    let svg = check_formats(&chart);
    let document = Document::parse(&svg).unwrap();
    let found = texts(&document);
    for wanted in ["1 of 4 failed", "1 of 3 failed"] {
        assert!(found.iter().any(|text| text == wanted), "{wanted} is not among {found:?}");
    }
    assert!(
        !found.iter().any(|text| text == "c" || text.starts_with("all 1") || text.starts_with("all 3")),
        "{found:?}"
    );
    // The labels differ in width, the marks not at all.
    let marks = |document: &Document| -> Vec<String> {
        let shapes = document.descendants().filter(|node| node.has_tag_name("circle") || node.has_tag_name("polygon"));
        let attributes = shapes.map(|node| node.attributes().map(|a| a.value().to_string() + ";").collect());
        attributes.collect()
    };
    assert_eq!(marks(&document), marks(&Document::parse(&without).unwrap()));
}

#[test]
fn a_chart_without_a_known_error_says_why() {
    let says = |cases: &[(f64, Outcome)]| {
        let chart = work_precision(vec![("one", vec![setting("801", cases)])]);
        let svg = check_formats(&chart);
        texts(&Document::parse(&svg).unwrap())
    };
    let reasons = ["no error is known", "no case was solved", "no error above zero"];
    for (cases, reason, label) in [
        (&[(1.0, Unknown), (2.0, Unknown)][..], Some(reasons[0]), None),
        (&[(1.0, Unknown), (2.0, Failed)], Some(reasons[0]), Some("1 of 2 failed")),
        (&[(1.0, Failed), (2.0, Failed)], Some(reasons[1]), Some("all 2 failed")),
        (&[(1.0, Unknown), (2.0, Error(0.0))], Some(reasons[2]), None),
        (&[(1.0, Unknown), (2.0, Error(1e-3))], None, None),
    ] {
        let found = says(cases);
        let said: Vec<&str> = reasons.into_iter().filter(|words| found.iter().any(|text| text == words)).collect();
        assert_eq!(said, Vec::from_iter(reason), "{cases:?}");
        let labels: Vec<&str> = found.iter().map(String::as_str).filter(|text| text.contains(" 2 failed")).collect();
        assert_eq!(labels, Vec::from_iter(label), "{found:?}");
    }
}

#[test]
fn charts_with_next_to_nothing_are_drawn() {
    let charts = [
        work_precision(vec![("one", vec![setting("801", &[(1.0, Error(1e-3))])])]),
        work_precision(vec![(
            "equal",
            vec![setting("a", &[(1.0, Error(1e-3)); 5]), setting("b", &[(1.0, Error(1e-3)); 5])],
        )]),
        work_precision(vec![("failed", vec![setting("a", &[(1.0, Failed), (2.0, Failed)])]), ("empty", vec![])]),
        work_precision(vec![("exact", vec![setting("a", &[(1.0, Error(0.0)), (2.0, Error(0.0))])])]),
        work_precision(vec![(
            "apart",
            vec![setting("", &[(1e-9, Error(1e-300)), (1e9, Error(1e30))]), setting("none", &[])],
        )]),
    ];
    for chart in &charts {
        check_formats(chart);
    }
    let failed = texts(&Document::parse(&charts[2].svg(&Paper::default()).unwrap()).unwrap());
    assert!(failed.contains(&"no case was solved".to_string()) && failed.contains(&"all 2 failed".to_string()));
}

#[test]
fn a_line_may_be_one_of_many() {
    let lines = ["a", "b", "c", "d", "e", "f", "g", "h", "i"];
    let one = |(i, label): (usize, &&'static str)| {
        let at = |k: usize| (0.01 * 2f64.powi((i + k) as i32), Error(1e-3 / 5f64.powi((2 * k) as i32)));
        (*label, vec![setting("5", &[at(0)]), setting("6", &[at(1)])])
    };
    let svg = work_precision(lines.iter().enumerate().map(one).collect()).svg(&Paper::default()).unwrap();
    let document = Document::parse(&svg).unwrap();
    let texts = texts(&document);
    assert!(lines.iter().all(|line| texts.iter().any(|text| text == line)));
    // Colour and form together tell any two lines apart: eighth and first share a colour, not a form.
    let large: Vec<Node> = with(&document, &[("fill", BLUE), ("opacity", "1")]).collect();
    assert_eq!(large.len(), 6);
    assert_eq!(large.iter().filter(|marker| marker.has_tag_name("circle")).count(), 3);
}

#[test]
fn numbers_without_a_place_are_refused() {
    for (case, says) in [
        ((0.0, Error(1e-3)), "seconds are finite and above zero"),
        ((f64::NAN, Failed), "seconds are finite and above zero"),
        ((f64::INFINITY, Error(1.0)), "seconds are finite and above zero"),
        ((1.0, Error(-1e-3)), "an error is finite and not negative"),
        ((1.0, Error(f64::NAN)), "an error is finite and not negative"),
    ] {
        let error = work_precision(vec![("one", vec![setting("801", &[case])])])
            .svg(&Paper::default())
            .unwrap_err()
            .to_string();
        assert!(error.contains(says) && error.contains("\"801\" of \"one\""), "{error}");
    }
    let empty = work_precision(vec![("one", vec![setting("801", &[])])]).png(&Paper::default()).unwrap_err();
    assert!(matches!(empty, ChartError::Empty { .. }), "{empty}");
}

#[test]
fn maps_show_every_cell_and_say_what_the_marks_mean() {
    let x = [0.0, 1e-2, 1.0, 1e2, f64::INFINITY];
    let y = [10.0, 100.0, 1000.0];
    let kind = |i: usize| match i % 5 {
        0 => Cell::Failed,
        1 => Cell::Absent,
        2 => Cell::Unknown,
        _ => Cell::Value(1e-9 * (i as f64 + 1.0)),
    };
    let chart = map(&["f = 1", "f = 100"], &["collocation", "relaxation, 801 points"], &x, &y, kind);
    let svg = check_formats(&chart);
    let document = Document::parse(&svg).unwrap();
    let texts = texts(&document);
    for wanted in [
        "Estimated error",
        "tolerance 1e-5",
        "α",
        "β",
        "f = 1",
        "f = 100",
        "collocation",
        "relaxation, 801 points",
        "relative error",
        "failed",
        "no case",
        "solved, quantity not known",
        "0",
        "∞",
    ] {
        assert!(texts.iter().any(|text| text == wanted), "{wanted} is not among {texts:?}");
    }
    let cells = 2 * 2 * x.len() * y.len();
    // One more of each in the legend.
    assert_eq!(with(&document, &[("fill", FAILED)]).count(), cells / 5 + 1);
    assert_eq!(with(&document, &[("fill", UNKNOWN)]).count(), cells / 5 + 1);
    // Two strokes on each failed cell.
    assert_eq!(with(&document, &[("stroke", "#AA2222")]).count(), 2 * (cells / 5 + 1));
}

#[test]
fn cells_of_a_map_follow_their_values() {
    let x = [0.0, 1e-3, 1e-2, 1.0, 1e3, f64::INFINITY];
    let svg = map(&["f = 1"], &[""], &x, &[1.0], |_| Cell::Unknown).svg(&Paper::default()).unwrap();
    let document = Document::parse(&svg).unwrap();
    let spans: Vec<(f64, f64)> = with(&document, &[("fill", UNKNOWN)])
        .take(x.len())
        .map(|cell| (number(&cell, "x"), number(&cell, "x") + number(&cell, "width")))
        .collect();
    let gaps: Vec<f64> = spans.windows(2).map(|pair| pair[1].0 - pair[0].1).collect();
    assert!(spans.iter().all(|span| span.0 < span.1));
    assert!(gaps[0] > 0.0 && gaps[4] > 0.0, "0 and ∞ are set off: {gaps:?}");
    assert_eq!(gaps[1..4], [0.0; 3]);
    // 1e-2 to 1 and 1 to 1e3: the cell of 1 reaches from a decade below to one and a half above.
    let decade = (spans[3].1 - spans[3].0) / 2.5;
    assert!((spans[2].1 - spans[2].0 - 1.5 * decade).abs() < 2.0);
}

#[test]
fn maps_of_next_to_nothing_are_drawn() {
    let one = |cell: Cell| map(&["f = 1"], &["method"], &[1.0], &[10.0], move |_| cell);
    for cell in [Cell::Value(3.0), Cell::Value(0.0), Cell::Failed, Cell::Absent, Cell::Unknown] {
        let mut chart = one(cell);
        check_formats(&chart);
        chart.scale.logarithmic = false;
        check_formats(&chart);
    }
    let limits = map(&["f = 1"], &["method"], &[0.0, f64::INFINITY], &[0.0], |i| Cell::Value(i as f64));
    check_formats(&limits);
}

#[test]
fn maps_that_do_not_fit_are_refused() {
    let good = map(&["f = 1"], &["method"], &[1.0, 2.0], &[10.0], |_| Cell::Value(1.0));
    let refused = |change: &dyn Fn(&mut Map), says: &str| {
        let mut chart = good.clone();
        change(&mut chart);
        let error = chart.svg(&Paper::default()).unwrap_err().to_string();
        assert!(error.contains(says), "{error}");
    };
    refused(&|map| map.columns.clear(), "no column of panels");
    refused(&|map| map.x.clear(), "no value of the horizontal axis");
    refused(&|map| map.x = vec![2.0, 1.0], "increase");
    refused(&|map| map.y = vec![f64::NAN], "increase");
    refused(&|map| map.panels.clear(), "has 0 panels, but its axes ask for 1");
    refused(&|map| map.panels[0].cells.truncate(1), "has 1 cells in panel 1, but its axes ask for 2");
    refused(&|map| map.panels[0].cells[1] = Cell::Value(f64::NAN), "α = 2, β = 10");
    refused(&|map| map.panels[0].cells[1] = Cell::Value(-1.0), "below zero on a logarithmic scale");
    refused(&|map| map.scale.range = Some((0.0, 1.0)), "above zero if the scale is logarithmic");
    refused(&|map| map.scale.range = Some((2.0, 1.0)), "from a lower to a higher");
}
