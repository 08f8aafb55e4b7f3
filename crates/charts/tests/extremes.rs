//! Charts of numbers of any size and of any text: drawn in few bytes, as well-formed SVG near the picture.

use crate::chart_files::{check_formats, texts, with};
use crate::laws::laws;
use crate::numbers::{any_number, any_positive, increasing, range_of};
use proptest::prelude::*;
use roxmltree::{Document, Node};
use stribeck_charts::{
    Cell, Chart, Colour, ColourScale, CrossSection, CrossSectionPanel, Curve, LineAxis, Lines, Map, MethodLine,
    Outcome, Panel, Paper, SettingPoint, Stroke, Surface3d, Surface3dCurve, Surface3dPanel, WorkPrecision,
};

/// Numbers that are none among others.
fn anything() -> impl Strategy<Value = f64> {
    prop_oneof![9 => any_number(), 1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY])]
}

/// A text of any characters, those among them that XML forbids.
fn text() -> impl Strategy<Value = String> {
    let forbidden = prop::sample::select(vec!['\0', '\u{1}', '\u{8}', '\u{b}', '\u{1b}', '\u{fffe}', '\u{ffff}']);
    let special = prop::sample::select(vec!['<', '>', '&', '"', '\'', '\t', '\n', '\r', ' ', '\u{85}', ']', 'μ']);
    let letter = prop_oneof![any::<char>(), forbidden, special, prop::char::range('a', 'z')];
    let short = prop::collection::vec(letter, 0..12).prop_map(String::from_iter);
    prop_oneof![9 => short.clone(), 1 => (short, 1..3000usize).prop_map(|(text, count)| text.repeat(count))]
}

fn lines() -> impl Strategy<Value = Lines> {
    let axis = || {
        let ranges = (prop::option::of(range_of(any_number())), prop::option::of(range_of(any_positive())));
        (text(), any::<bool>(), ranges).prop_map(|(label, logarithmic, (linear, ratio))| LineAxis {
            label,
            logarithmic,
            range: if logarithmic { ratio } else { linear },
        })
    };
    let stroke = prop::sample::select(vec![Stroke::Solid, Stroke::Dashed, Stroke::Dotted, Stroke::Points]);
    let points = prop::collection::vec((anything(), anything()), 0..20);
    let curve = (text(), points, prop::collection::vec(anything(), 0..3), stroke, prop::option::of(0..12usize));
    let curve = curve.prop_map(|(label, points, failed, stroke, mark)| Curve {
        label,
        points,
        failed,
        stroke,
        colour: Colour::Kind(0),
        mark,
    });
    (text(), text(), axis(), axis(), prop::collection::vec(curve, 1..5)).prop_map(
        |(title, subtitle, x, y, mut curves)| {
            // One point at least has a place on any axis.
            curves[0].points.push((2.0, 3.0));
            Lines { title, subtitle, x, y, curves }
        },
    )
}

fn scale() -> impl Strategy<Value = ColourScale> {
    let ranges = (prop::option::of(range_of(any_number())), prop::option::of(range_of(any_positive())));
    (text(), any::<bool>(), ranges).prop_map(|(label, logarithmic, (linear, ratio))| ColourScale {
        label,
        logarithmic,
        range: if logarithmic { ratio } else { linear },
    })
}

fn map() -> impl Strategy<Value = Map> {
    let axis = || {
        (any::<bool>(), increasing(any_positive(), 1..7), any::<bool>()).prop_map(|(zero, finite, infinity)| {
            let ends = (zero.then_some(0.0), infinity.then_some(f64::INFINITY));
            ends.0.into_iter().chain(finite).chain(ends.1).collect::<Vec<f64>>()
        })
    };
    let values = prop::collection::vec(any_number(), 30);
    let labels = |count| prop::collection::vec(text(), 1..count);
    (text(), text(), labels(3), labels(2), axis(), axis(), values, scale()).prop_map(|given| {
        let (title, x_label, columns, rows, x, y, values, scale) = given;
        let cell = |k: usize| match (values[k % values.len()], k % 11) {
            (_, 5) => Cell::Failed,
            (_, 7) => Cell::Absent,
            (value, _) => Cell::Value(if scale.logarithmic { value.abs() } else { value }),
        };
        let panel = |p: usize| Panel { cells: (0..x.len() * y.len()).map(|k| cell(k + p)).collect() };
        let panels = (0..rows.len() * columns.len()).map(panel).collect();
        let (subtitle, y_label) = (x_label.clone(), x_label.clone());
        Map { title, subtitle, x_label, y_label, columns, rows, x, y, panels, scale, contours: true }
    })
}

fn surface3d() -> impl Strategy<Value = Surface3d> {
    let axis = || increasing(any_positive(), 2..7);
    let heights = prop::collection::vec(prop::option::weighted(0.9, any_number()), 30);
    (text(), text(), axis(), axis(), heights, scale(), 1..4usize).prop_map(
        |(title, name, x, y, heights, scale, panels)| {
            let logarithmic = scale.logarithmic;
            let height = |height: f64| if logarithmic { height.abs() } else { height };
            let at = |k: usize| heights[k % heights.len()].map(height);
            let corner = |i: usize, j: usize, z| (x[i], y[j], height(z));
            let points =
                vec![corner(0, 0, 1.0), corner(x.len() - 1, 0, f64::MAX), corner(0, y.len() - 1, f64::MIN_POSITIVE)];
            let panel = |p: usize| Surface3dPanel {
                label: name.clone(),
                heights: (0..x.len() * y.len()).map(|k| at(k + p)).collect(),
                curves: vec![Surface3dCurve { label: name.clone(), points: points.clone() }],
            };
            let panels = (0..panels).map(panel).collect();
            let [subtitle, x_label, y_label] = [&name; 3].map(String::clone);
            let (z_label, range) = (scale.label, scale.range);
            Surface3d { title, subtitle, x_label, y_label, z_label, x, y, logarithmic, range, panels }
        },
    )
}

fn cross_section() -> impl Strategy<Value = CrossSection> {
    let list = || prop::collection::vec(any_number(), 30);
    let fields = (list(), list(), list());
    let sizes = (increasing(any_number(), 2..7), increasing(any_positive(), 1..6));
    let ranges = (range_of(any_number()), range_of(any_number()));
    (text(), text(), sizes, fields, ranges, scale(), any::<usize>(), 1..4usize).prop_map(|given| {
        let (title, name, (x, depths), (surface, cylinder, values), (x_range, y_range), scale, levels, panels) = given;
        let depth: Vec<f64> = std::iter::once(0.0).chain(depths).collect();
        let value = |value: &f64| if scale.logarithmic { value.abs().max(5e-324) } else { *value };
        let panel = CrossSectionPanel {
            label: name.clone(),
            surface: surface.iter().cycle().take(x.len()).copied().collect(),
            cylinder: cylinder.iter().cycle().take(x.len()).copied().collect(),
            values: values.iter().map(value).cycle().take(x.len() * depth.len()).collect(),
            x,
            depth,
        };
        let [subtitle, x_label, y_label] = [&name; 3].map(String::clone);
        let (panels, levels) = (vec![panel; panels], levels.max(1));
        CrossSection { title, subtitle, x_label, y_label, panels, x_range, y_range, scale, levels }
    })
}

fn work_precision() -> impl Strategy<Value = WorkPrecision> {
    let outcome = prop_oneof![
        6 => any_number().prop_map(|error| Outcome::Error(error.abs())),
        1 => Just(Outcome::Failed),
        1 => Just(Outcome::Unknown),
    ];
    let setting = (text(), prop::collection::vec((any_positive(), outcome), 1..6));
    let line = (text(), prop::collection::vec(setting, 1..4)).prop_map(|(label, settings)| {
        let points = settings.into_iter().map(|(label, cases)| SettingPoint { label, cases }).collect();
        MethodLine { label, points }
    });
    (text(), text(), prop::collection::vec(line, 1..4)).prop_map(|(title, name, lines)| {
        let [subtitle, x_label, y_label] = [&name; 3].map(String::clone);
        WorkPrecision { title, subtitle, x_label, y_label, lines }
    })
}

/// All numbers of an element that are pixels.
fn pixels(node: &Node) -> Vec<f64> {
    const NAMES: [&str; 12] = ["x", "y", "x1", "x2", "y1", "y2", "cx", "cy", "width", "height", "r", "points"];
    let attributes = NAMES.iter().filter_map(|name| node.attribute(*name));
    let numbers = attributes.flat_map(|text| text.split([' ', ',']).filter(|number| !number.is_empty()));
    numbers.map(|number| number.parse().unwrap()).collect()
}

fn check(chart: &impl Chart) {
    let svg = chart.svg(&Paper::default()).unwrap();
    assert!(svg.len() < 3_000_000, "{} bytes", svg.len());
    let document = Document::parse(&svg).unwrap_or_else(|error| panic!("{error}"));
    for node in document.descendants() {
        assert!(pixels(&node).iter().all(|place| place.abs() < 50_000.0), "{node:?} lies far away");
        assert!(node.text().is_none_or(|text| text.chars().count() < 20_000), "{node:?} is long");
    }
}

laws! {
    seed: 308, cases: 192;

    fn charts_of_lines_take_any_numbers_and_texts(chart in lines()) { check(&chart); }

    fn maps_take_any_numbers_and_texts(chart in map()) { check(&chart); }

    fn surfaces_take_any_numbers_and_texts(chart in surface3d()) { check(&chart); }

    fn cross_sections_take_any_numbers_and_texts(chart in cross_section()) { check(&chart); }

    fn work_precision_charts_take_any_numbers_and_texts(chart in work_precision()) { check(&chart); }
}

fn line(points: Vec<(f64, f64)>, stroke: Stroke) -> Curve {
    let (label, failed, colour) = ("curve".to_string(), vec![], Colour::Black);
    Curve { label, points, failed, stroke, colour, mark: None }
}

fn linear(range: Option<(f64, f64)>) -> LineAxis {
    LineAxis { label: "axis".to_string(), logarithmic: false, range }
}

#[test]
fn the_whole_range_of_numbers_is_an_axis() {
    let curves = vec![line(vec![(-1.7e308, 1.7e308), (1.7e308, -1.7e308)], Stroke::Dotted)];
    let (title, subtitle) = ("All numbers".to_string(), String::new());
    let svg = check_formats(&Lines { title, subtitle, x: linear(None), y: linear(None), curves });
    let labels = texts(&Document::parse(&svg).unwrap());
    for (wanted, times) in [("−1·10³⁰⁸", 1), ("0", 2), ("10³⁰⁸", 1), ("−1.5·10³⁰⁸", 1), ("1.5·10³⁰⁸", 1)]
    {
        assert_eq!(labels.iter().filter(|label| *label == wanted).count(), times, "{wanted} among {labels:?}");
    }
}

/// The part inside of a curve that leaves the plot for 10⁴⁵ pixels beyond is that of a curve to just beyond it.
#[test]
fn a_curve_from_far_away_is_drawn_where_it_should_be() {
    let drawn = |far: f64| {
        let curves = vec![line(vec![(0.0, 0.5), (0.5, 0.5), (0.5, far)], Stroke::Dashed)];
        let (title, subtitle) = (String::new(), String::new());
        let (x, y) = (linear(Some((0.0, 1.0))), linear(Some((0.0, 1.0))));
        check_formats(&Lines { title, subtitle, x, y, curves })
    };
    assert_eq!(drawn(2.0), drawn(1e45));
    assert_eq!(drawn(2.0), drawn(f64::MAX));
    assert_eq!(drawn(-1.0), drawn(f64::MIN));
}

#[test]
fn a_dashed_curve_too_dense_for_dashes_has_none() {
    let strokes = |count: usize| {
        let points = (0..count).map(|i| (i as f64, (i % 2) as f64)).collect();
        let curves = vec![line(points, Stroke::Dotted)];
        let (title, subtitle) = (String::new(), String::new());
        let svg = Lines { title, subtitle, x: linear(None), y: linear(None), curves }.svg(&Paper::default()).unwrap();
        with(&Document::parse(&svg).unwrap(), &[("stroke", "#222222")]).count()
    };
    assert!(strokes(10) > 100 && strokes(10_000) < 20);
}
