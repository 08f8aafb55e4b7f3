//! What holds for the layout of any chart: no text covers another one, all lies inside the picture.

use crate::laws::laws;
use proptest::prelude::*;

use super::{
    Cell, ChartError, Colour, ColourScale, CrossSection, CrossSectionPanel, Curve, LineAxis, Lines, Map, MethodLine,
    Outcome, Panel, Paper, SettingPoint, Stroke, Surface3d, Surface3dCurve, Surface3dPanel, WorkPrecision,
};
use crate::chart::{Drawing, fitted};
use crate::paint::font;
use crate::paint::scene::{Area, Point, Scene, Shape, Text};
use crate::paper::WIDTH;

fn texts(scene: &Scene) -> Vec<&Text> {
    scene.shapes.iter().filter_map(|shape| if let Shape::Text(text) = shape { Some(text) } else { None }).collect()
}

/// Texts that cover each other.
fn collisions(scene: &Scene) -> Vec<(String, String)> {
    let texts: Vec<(&Text, Area)> = texts(scene).into_iter().map(|text| (text, text.area().grown(-0.5))).collect();
    let mut found = vec![];
    for (i, (one, area)) in texts.iter().enumerate() {
        let over = texts[..i].iter().filter(|(_, other)| other.overlaps(area));
        found.extend(over.map(|(other, _)| (other.words.clone(), one.words.clone())));
    }
    found
}

/// Points of shapes that lie outside the picture.
fn outside(scene: &Scene) -> Vec<Point> {
    let picture = Area { left: 0.0, top: 0.0, right: WIDTH, bottom: scene.height };
    let corners = |area: &Area| vec![(area.left, area.top), (area.right, area.bottom)];
    let points = |shape: &Shape| match shape {
        Shape::Rectangle { area, .. } => corners(area),
        Shape::Path { points, .. } => points.clone(),
        Shape::Polygon { corners, .. } => corners.clone(),
        Shape::Disc { centre, radius, .. } => corners(&Area::about(*centre, *radius)),
        Shape::Text(text) => corners(&text.area()),
    };
    scene.shapes.iter().flat_map(points).filter(|point| !picture.contains(&Area::about(*point, 0.0))).collect()
}

fn label() -> impl Strategy<Value = String> {
    prop::collection::vec("[a-zA-Z0-9,=⁴α]{1,14}", 1..7).prop_map(|words| words.join(" "))
}

fn setting(cases: usize) -> impl Strategy<Value = SettingPoint> {
    let outcome = prop_oneof![
        6 => (-14.0..0.0f64).prop_map(|e| Outcome::Error(10f64.powf(e))),
        1 => Just(Outcome::Failed),
        1 => Just(Outcome::Unknown),
        1 => Just(Outcome::Error(0.0)),
    ];
    let case = ((-4.0..3.0f64).prop_map(|s| 10f64.powf(s)), outcome);
    ("[0-9e-]{1,6}", prop::collection::vec(case, 1..cases)).prop_map(|(label, cases)| SettingPoint { label, cases })
}

fn work_precision() -> impl Strategy<Value = WorkPrecision> {
    let line =
        (label(), prop::collection::vec(setting(5), 1..4)).prop_map(|(label, points)| MethodLine { label, points });
    (label(), label(), label(), prop::collection::vec(line, 1..4)).prop_map(|(title, x_label, y_label, lines)| {
        WorkPrecision { title, subtitle: String::new(), x_label, y_label, lines }
    })
}

fn axis() -> impl Strategy<Value = Vec<f64>> {
    (any::<bool>(), prop::collection::btree_set(-40..40i32, 1..12), any::<bool>()).prop_map(
        |(zero, tenths, infinity)| {
            let finite = tenths.into_iter().map(|tenths| 10f64.powf(0.2 * f64::from(tenths)));
            zero.then_some(0.0).into_iter().chain(finite).chain(infinity.then_some(f64::INFINITY)).collect()
        },
    )
}

fn map() -> impl Strategy<Value = Map> {
    let labels = |most| prop::collection::vec(label(), 1..most);
    let scale = (label(), any::<bool>()).prop_map(|(label, logarithmic)| ColourScale {
        label,
        logarithmic,
        range: logarithmic.then_some((1e-6, 1e-2)),
    });
    (label(), labels(7), labels(4), axis(), axis(), scale, any::<bool>()).prop_map(|given| {
        let (title, columns, rows, x, y, scale, contours) = given;
        let cell = |i: usize| match i % 11 {
            3 => Cell::Failed,
            5 => Cell::Absent,
            7 => Cell::Unknown,
            _ => Cell::Value(1e-8 * 1.3f64.powi((i % 97) as i32)),
        };
        let panel = |p: usize| Panel { cells: (0..x.len() * y.len()).map(|i| cell(i + p)).collect() };
        let panels = (0..rows.len() * columns.len()).map(panel).collect();
        let (x_label, y_label) = ("α".to_string(), "β".to_string());
        let subtitle = "below the title".to_string();
        Map { title, subtitle, x_label, y_label, columns, rows, panels, x, y, scale, contours }
    })
}

fn lines() -> impl Strategy<Value = Lines> {
    let line_axis =
        || (label(), any::<bool>()).prop_map(|(label, logarithmic)| LineAxis { label, logarithmic, range: None });
    let x = prop_oneof![8 => (-3.0..3.0f64).prop_map(|e| 10f64.powf(e)), 1 => Just(0.0), 1 => Just(f64::INFINITY)];
    let y = prop_oneof![8 => (-9.0..3.0f64).prop_map(|e| 10f64.powf(e)), 1 => Just(f64::NAN), 1 => -5.0..5.0f64];
    let curve = (
        prop_oneof![2 => label(), 1 => Just(String::new())],
        prop::collection::vec((x, y), 0..9),
        prop::collection::vec(0.01..100.0f64, 0..3),
        any::<[bool; 2]>(),
        prop::option::of(0..12usize),
    );
    let curve = curve.prop_map(|(label, points, failed, [dashed, kind], mark)| Curve {
        label,
        points,
        failed,
        stroke: if dashed { Stroke::Dashed } else { Stroke::Solid },
        colour: if kind { Colour::Kind(1) } else { Colour::Family(0.5) },
        mark,
    });
    (label(), line_axis(), line_axis(), prop::collection::vec(curve, 1..9)).prop_map(|(title, x, y, mut curves)| {
        // One point at least has a place on any axis.
        curves[0].points.push((2.0, 3.0));
        Lines { title, subtitle: "f = 100, α = 1".to_string(), x, y, curves }
    })
}

fn surface3d() -> impl Strategy<Value = Surface3d> {
    let axis = || {
        prop::collection::btree_set(-40..40i32, 2..12).prop_map(|tenths| -> Vec<f64> {
            tenths.into_iter().map(|tenths| 10f64.powf(0.2 * f64::from(tenths))).collect()
        })
    };
    let panels = prop::collection::vec((label(), prop::collection::vec(label(), 0..3)), 1..4);
    (label(), label(), label(), label(), axis(), axis(), any::<bool>(), -3.0..3.0f64, panels).prop_map(|given| {
        let (title, x_label, y_label, z_label, x, y, logarithmic, power, panels) = given;
        let height = |k: usize| 10f64.powf(power) * (1.0 + (1.7 * k as f64).sin().powi(2) * 5.0);
        let points = || [(x[0], y[0], height(0)), (x[x.len() - 1], y[y.len() - 1], height(7))].to_vec();
        let curve = |label| Surface3dCurve { label, points: points() };
        let heights = || (0..x.len() * y.len()).map(|k| (k % 13 != 5).then(|| height(k))).collect();
        let panel = |(label, curves): (String, Vec<String>)| Surface3dPanel {
            label,
            heights: heights(),
            curves: curves.into_iter().map(curve).collect(),
        };
        let panels = panels.into_iter().map(panel).collect();
        let subtitle = String::new();
        Surface3d {
            title,
            subtitle,
            x_label,
            y_label,
            z_label,
            x: x.clone(),
            y: y.clone(),
            logarithmic,
            range: None,
            panels,
        }
    })
}

fn cross_section() -> impl Strategy<Value = CrossSection> {
    let range = || (-100.0..100.0f64, -3.0..3.0f64).prop_map(|(low, power)| (low, low + 10f64.powf(power)));
    let panel =
        (label(), 2..9usize, 2..9usize, -2.0..2.0f64).prop_map(|(label, columns, rows, size)| CrossSectionPanel {
            label,
            x: (0..columns).map(|i| i as f64).collect(),
            surface: (0..columns).map(|i| size * (i as f64).cos()).collect(),
            cylinder: (0..columns).map(|i| size * (i as f64).cos() + 0.1).collect(),
            depth: (0..rows).map(|j| j as f64).collect(),
            values: (0..columns * rows).map(|k| size * (1.7 * k as f64).sin()).collect(),
        });
    let panels = prop::collection::vec(panel, 1..6);
    (label(), label(), label(), label(), range(), range(), 1..15usize, panels).prop_map(|given| {
        let (title, x_label, y_label, name, x_range, y_range, levels, panels) = given;
        let scale = ColourScale { label: name, logarithmic: false, range: None };
        CrossSection { title, subtitle: String::new(), x_label, y_label, panels, x_range, y_range, scale, levels }
    })
}

/// Letters and heights of plots over those without options, and whether there is a heading.
fn look() -> impl Strategy<Value = (f64, f64, bool)> {
    let stretch = prop_oneof![2 => Just(1.0), 1 => 0.2..4.0f64];
    (prop_oneof![1 => Just(1.0), 1 => 0.4..1.5f64], stretch, any::<bool>())
}

/// The texts of a chart stand apart from each other, and all shapes lie inside, also on paper with a height of its own.
fn check(chart: &impl Drawing, (letters, stretch, heading): (f64, f64, bool)) -> Result<(), TestCaseError> {
    let width = 1600.0;
    let font_size = Some(0.75 * letters * font::size(chart.side_by_side()));
    let paper = Paper { width, font_size, heading, ..Paper::default() };
    let scene = chart.scene(&paper, stretch).unwrap();
    prop_assert_eq!(collisions(&scene), vec![]);
    prop_assert_eq!(outside(&scene), vec![]);
    let paper = Paper { height: Some(scene.height), ..paper };
    match fitted(chart, &paper) {
        Ok(fitted) => {
            prop_assert_eq!(fitted.height, scene.height);
            prop_assert_eq!((collisions(&fitted), outside(&fitted)), (vec![], vec![]));
        }
        // Near the ends of what plots are stretched to.
        Err(ChartError::Height { .. }) => prop_assert!(!(0.4..=2.0).contains(&stretch)),
        Err(error) => panic!("{error}"),
    }
    Ok(())
}

laws! {
    seed: 1600, cases: 128;

    fn maps_keep_their_texts_apart_and_inside(chart in map(), look in look()) {
        check(&chart, look)?;
    }

    fn charts_of_lines_keep_their_texts_apart_and_inside(chart in lines(), look in look()) {
        check(&chart, look)?;
    }

    fn surfaces_keep_their_texts_apart_and_inside(chart in surface3d(), look in look()) {
        check(&chart, look)?;
    }

    fn cross_sections_keep_their_texts_apart_and_inside(chart in cross_section(), look in look()) {
        check(&chart, look)?;
    }

    fn work_precision_charts_keep_their_texts_apart_and_inside(chart in work_precision(), look in look()) {
        check(&chart, look)?;
    }
}
