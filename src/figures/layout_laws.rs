//! What holds for the layout of any chart: no text covers another one, all lies inside the picture.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use super::font::{self, DESCENT};
use super::scene::{Anchor, Area, Point, Scene, Shape, Text};
use super::{Cell, ColourScale, Map, MethodLine, Outcome, Panel, SettingPoint, WIDTH, WorkPrecision};

/// The rectangle of a text, from the top of its capitals to the descenders.
fn bounds(text: &Text) -> Area {
    const CAPITALS: f64 = 0.73;
    let width = font::width(&text.words, text.em);
    let before = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5 * width,
        Anchor::End => width,
    };
    let (x, y) = text.at;
    if text.turned {
        let bottom = y + before;
        Area { left: x - CAPITALS * text.em, top: bottom - width, right: x + DESCENT * text.em, bottom }
    } else {
        let left = x - before;
        Area { left, top: y - CAPITALS * text.em, right: left + width, bottom: y + DESCENT * text.em }
    }
}

fn texts(scene: &Scene) -> Vec<&Text> {
    scene.shapes.iter().filter_map(|shape| if let Shape::Text(text) = shape { Some(text) } else { None }).collect()
}

/// Texts that cover each other.
fn collisions(scene: &Scene) -> Vec<(String, String)> {
    let texts: Vec<(&Text, Area)> = texts(scene).into_iter().map(|text| (text, bounds(text).grown(-0.5))).collect();
    let mut found = vec![];
    for (i, (one, area)) in texts.iter().enumerate() {
        let over = texts[..i].iter().filter(|(_, other)| other.overlaps(area));
        found.extend(over.map(|(other, _)| (other.words.clone(), one.words.clone())));
    }
    found
}

/// Points of shapes that lie outside the picture.
fn outside(scene: &Scene) -> Vec<Point> {
    let picture = Area { left: 0.0, top: 0.0, right: f64::from(WIDTH), bottom: scene.height };
    let corners = |area: &Area| vec![(area.left, area.top), (area.right, area.bottom)];
    let points = |shape: &Shape| match shape {
        Shape::Rectangle { area, .. } => corners(area),
        Shape::Path { points, .. } => points.clone(),
        Shape::Polygon { corners, .. } => corners.clone(),
        Shape::Disc { centre, radius, .. } => corners(&Area::about(*centre, *radius)),
        Shape::Text(text) => corners(&bounds(text)),
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
    (label(), labels(7), labels(4), axis(), axis(), scale).prop_map(|(title, columns, rows, x, y, scale)| {
        let cell = |i: usize| match i % 11 {
            3 => Cell::Failed,
            5 => Cell::Absent,
            7 => Cell::Unknown,
            _ => Cell::Value(1e-8 * 1.3f64.powi((i % 97) as i32)),
        };
        let panel = |p: usize| Panel { cells: (0..x.len() * y.len()).map(|i| cell(i + p)).collect() };
        let panels = (0..rows.len() * columns.len()).map(panel).collect();
        let (x_label, y_label) = ("α".to_string(), "β".to_string());
        Map { title, subtitle: "below the title".to_string(), x_label, y_label, columns, rows, panels, x, y, scale }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, rng_seed: RngSeed::Fixed(1600), ..ProptestConfig::default() })]

    #[test]
    fn maps_keep_their_texts_apart_and_inside(map in map()) {
        let scene = map.scene().unwrap();
        prop_assert_eq!(collisions(&scene), vec![]);
        prop_assert_eq!(outside(&scene), vec![]);
    }

    #[test]
    fn work_precision_charts_keep_their_texts_apart_and_inside(chart in work_precision()) {
        let scene = chart.scene().unwrap();
        prop_assert_eq!(collisions(&scene), vec![]);
        prop_assert_eq!(outside(&scene), vec![]);
    }
}
