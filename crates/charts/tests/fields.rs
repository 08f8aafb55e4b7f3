//! Charts of fields from outside: lines of equal value on maps, sections below a surface.

use crate::chart_files::{check_formats, number, points, polygons, texts, with};
use roxmltree::{Document, Node};
use stribeck_charts::{Cell, Chart, ChartError, ColourScale, CrossSection, CrossSectionPanel, Map, Panel, Paper};

const WHITE: &str = "#FFFFFF";
const GREY: &str = "#D0D0D0";

fn powers(from: i32, count: usize) -> Vec<f64> {
    (from..).take(count).map(|power| 10f64.powi(power)).collect()
}

/// A linear map of one panel with lines of equal value.
fn map(x: Vec<f64>, y: Vec<f64>, cell: impl Fn(usize, usize) -> Cell) -> Map {
    let cells = (0..x.len() * y.len()).map(|k| cell(k % x.len(), k / x.len())).collect();
    Map {
        title: "Friction".to_string(),
        subtitle: String::new(),
        x_label: "α".to_string(),
        y_label: "β".to_string(),
        columns: vec!["f = 1".to_string()],
        rows: vec![String::new()],
        x,
        y,
        panels: vec![Panel { cells }],
        scale: ColourScale { label: "μ".to_string(), logarithmic: false, range: None },
        contours: true,
    }
}

type Line = Vec<(f64, f64)>;

/// The white lines of a map: those over cells, and those over the colour bar.
fn white_lines(document: &Document, levels: usize) -> (Vec<Line>, Vec<Line>) {
    let mut over_cells: Vec<Line> = with(document, &[("stroke", WHITE)]).map(|node| points(&node)).collect();
    let over_bar = over_cells.split_off(over_cells.len() - levels);
    (over_cells, over_bar)
}

#[test]
fn lines_of_equal_value_lie_between_the_values_of_cells() {
    let chart = map(powers(0, 4), powers(0, 3), |i, _| Cell::Value(10.0 * i as f64));
    let svg = check_formats(&chart);
    let document = Document::parse(&svg).unwrap();
    // 5, 10, …, 25: upright lines, equally far from each other, from the first to the last value of the vertical axis.
    let (lines, bar) = white_lines(&document, 5);
    assert_eq!((lines.len(), bar.len()), (5, 5));
    let x: Vec<f64> = lines.iter().map(|line| line[0].0).collect();
    assert!(lines.iter().all(|line| line.iter().all(|point| point.0 == line[0].0)));
    assert!(x.windows(2).all(|pair| (pair[1] - pair[0] - (x[4] - x[0]) / 4.0).abs() <= 1.0), "{x:?}");
    assert!(bar.iter().all(|line| line[0].1 == line[1].1));
    assert!(bar.windows(2).all(|pair| pair[0][0].1 > pair[1][0].1), "higher values stand higher on the bar");
    // A dark line under each white one.
    assert_eq!(with(&document, &[("stroke", "#222222"), ("opacity", "0.75")]).count(), 10);

    let without = Map { contours: false, ..chart };
    assert_eq!(
        with(&Document::parse(&without.svg(&Paper::default()).unwrap()).unwrap(), &[("stroke", WHITE)]).count(),
        0
    );
}

#[test]
fn lines_of_equal_value_keep_out_of_cells_without_a_value_and_of_0_and_infinity() {
    let x = [vec![0.0], powers(0, 6), vec![f64::INFINITY]].concat();
    let whole = map(x.clone(), powers(0, 7), |_, j| Cell::Value(10.0 * j as f64));
    let document = |map: &Map| map.svg(&Paper::default()).unwrap();
    let svg = document(&whole);
    let parsed = Document::parse(&svg).unwrap();
    let (lines, _) = white_lines(&parsed, 5);
    assert_eq!(lines.len(), 5);
    // The cells of 1 and of 10⁵ are the second and the last but one of the first row.
    let cells: Vec<Node> = parsed.descendants().filter(|node| node.has_tag_name("rect")).skip(1).take(8).collect();
    let centre = |cell: &Node| number(cell, "x") + 0.5 * number(cell, "width");
    for line in &lines {
        let ends = (line[0].0.min(line[line.len() - 1].0), line[0].0.max(line[line.len() - 1].0));
        assert!((ends.0 - centre(&cells[1])).abs() <= 1.0 && (ends.1 - centre(&cells[6])).abs() <= 1.0, "{ends:?}");
    }
    // A cell that failed cuts the lines beside it in two.
    for hole in [Cell::Failed, Cell::Absent, Cell::Unknown] {
        let cut =
            map(x.clone(), powers(0, 7), |i, j| if (i, j) == (3, 2) { hole } else { Cell::Value(10.0 * j as f64) });
        let svg = document(&cut);
        let parsed = Document::parse(&svg).unwrap();
        let (lines, _) = white_lines(&parsed, 5);
        assert!(lines.len() > 5, "{hole:?}");
    }
}

/// A section of a field that falls from −1 at the middle of the surface to 0.
fn cross_section(surface: f64, cylinder: f64, deepest: f64) -> CrossSection {
    let x: Vec<f64> = (0..21).map(|i| -2.0 + 0.2 * f64::from(i)).collect();
    let depth: Vec<f64> = (0..11).map(|j| 0.1 * deepest * f64::from(j)).collect();
    let value = |x: f64, d: f64| -(-x * x - d * d).exp();
    let panel = CrossSectionPanel {
        label: "α = 0.3".to_string(),
        surface: vec![surface; x.len()],
        cylinder: vec![cylinder; x.len()],
        values: depth.iter().flat_map(|d| x.iter().map(move |x| value(*x, *d))).collect(),
        x,
        depth,
    };
    CrossSection {
        title: "Normal stress".to_string(),
        subtitle: "f = 100".to_string(),
        x_label: "x (a₀)".to_string(),
        y_label: "height (a₀)".to_string(),
        panels: vec![panel],
        x_range: (-1.0, 1.0),
        y_range: (-1.0, 1.0),
        scale: ColourScale { label: "σ".to_string(), logarithmic: false, range: Some((-1.0, 0.0)) },
        levels: 5,
    }
}

/// Left, right, top and bottom of polygons.
fn bounds<'a>(polygons: impl Iterator<Item = Node<'a, 'a>>) -> [f64; 4] {
    let start = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
    polygons
        .flat_map(|polygon| points(&polygon))
        .fold(start, |[left, right, top, bottom], (x, y)| [left.min(x), right.max(x), top.min(y), bottom.max(y)])
}

#[test]
fn a_cross_section_has_its_axes_panels_and_bands() {
    let mut chart = cross_section(0.0, 0.1, 1.0);
    chart.panels.extend(
        ["α = 1", "α = 3"].map(|label| CrossSectionPanel { label: label.to_string(), ..chart.panels[0].clone() }),
    );
    let svg = check_formats(&chart);
    let document = Document::parse(&svg).unwrap();
    let texts = texts(&document);
    for wanted in
        ["Normal stress", "f = 100", "x (a0)", "height (a0)", "α = 0.3", "α = 1", "α = 3", "σ", "cylinder", "−0.2"]
    {
        assert!(texts.iter().any(|text| text == wanted), "{wanted} is not among {texts:?}");
    }
    // Boundaries at −0.8, −0.6, −0.4 and −0.2, in three panels; the whole field lies below the last band.
    let fills: std::collections::BTreeSet<&str> =
        polygons(&document).map(|polygon| polygon.attribute("fill").unwrap()).filter(|fill| *fill != GREY).collect();
    assert_eq!(fills.len(), 5);
    // The line of the last one leaves the picture at its lower edge and comes back.
    assert_eq!(with(&document, &[("stroke", WHITE), ("opacity", "0.6")]).count(), 3 * 5);
    assert_eq!(polygons(&document).filter(|polygon| polygon.attribute("fill") == Some(GREY)).count(), 3);
}

/// The cylinder fills what is above its lower side, the material what is below the surface down to the last depth; the
/// axes cut both.
#[test]
fn a_cross_section_shows_material_and_cylinder_where_they_are() {
    let both = |surface_at: f64, cylinder: f64, deepest: f64| {
        let svg = cross_section(surface_at, cylinder, deepest).svg(&Paper::default()).unwrap();
        let document = Document::parse(&svg).unwrap();
        let of = |grey: bool| bounds(polygons(&document).filter(|p| (p.attribute("fill") == Some(GREY)) == grey));
        (of(false), of(true))
    };
    // A frame of height 2 that is filled from top to bottom.
    let (whole, _) = both(1.0, 3.0, 2.0);
    let [left, right, top, bottom] = whole;
    let half = 0.5 * (bottom - top);
    let near = |found: [f64; 4], wanted: [f64; 4]| found.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= 1.5);
    let (material, cylinder) = both(0.0, 0.5, 3.0);
    assert!(near(material, [left, right, top + half, bottom]), "{material:?} in {whole:?}");
    assert!(near(cylinder, [left, right, top, top + 0.5 * half]), "{cylinder:?} in {whole:?}");
    let (material, _) = both(0.5, 3.0, 1.0);
    assert!(near(material, [left, right, top + 0.5 * half, bottom - 0.5 * half]), "{material:?} in {whole:?}");
    let (material, cylinder) = both(-5.0, -4.0, 1.0);
    assert_eq!(material[0], f64::INFINITY, "what lies outside is not drawn");
    assert!(near(cylinder, whole), "{cylinder:?} in {whole:?}");
}

#[test]
fn cross_sections_that_do_not_fit_are_refused() {
    let good = cross_section(0.0, 0.1, 1.0);
    let refused = |change: &dyn Fn(&mut CrossSection), says: &str| {
        let mut chart = good.clone();
        change(&mut chart);
        let error: ChartError = chart.png(&Paper::default()).unwrap_err();
        assert!(error.to_string().contains(says), "{error}");
    };
    refused(&|chart| chart.panels.clear(), "no panel");
    refused(&|chart| chart.levels = 0, "no band of colour");
    refused(&|chart| chart.x_range = (1.0, -1.0), "from a lower to a higher");
    refused(&|chart| chart.y_range = (0.0, f64::NAN), "from a lower to a higher");
    refused(&|chart| chart.scale.range = Some((0.0, 0.0)), "the range of \"σ\"");
    refused(&|chart| chart.panels[0].x[3] = -2.0, "increase");
    refused(&|chart| chart.panels[0].depth[0] = -1.0, "begin at the surface");
    refused(&|chart| chart.panels[0].surface.truncate(4), "has 4 heights of the surface in panel 1");
    refused(&|chart| chart.panels[0].cylinder[0] = f64::NAN, "the panel \"α = 0.3\"");
    refused(&|chart| chart.panels[0].values.truncate(7), "has 7 values in panel 1, but its axes ask for 231");
    refused(&|chart| chart.scale = ColourScale { logarithmic: true, range: None, ..chart.scale.clone() }, "above zero");
}
