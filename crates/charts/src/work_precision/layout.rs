//! Error against run time: where everything lies, and how it is drawn.

use super::placement::{Effort, Obstacles};
use super::setting_label::SettingLabel;
use super::{MethodLine, Outcome, SettingPoint, WorkPrecision};
use crate::axes::log_axis::LogAxis;
use crate::axes::ticks::{self, Ticks};
use crate::frame::legend::{Entry, LARGE_RADIUS, SMALL_OPACITY, SMALL_RADIUS, Swatch};
use crate::frame::{MARGIN, RIGHT, Side, Style};
use crate::paint::font;
use crate::paint::marker::{self, Form};
use crate::paint::palette::{self, EXACT, FAILED, FRAME, QUIET_TEXT, TEXT, faded};
use crate::paint::scene::{Anchor, Area, Point, Scene, Shape};
use crate::paper::Paper;

/// Size of the font of the labels of settings over that of all others.
const LABEL: f64 = 0.85;
/// Height of the part between the bands by default, and where labels crowd.
const HEIGHT: f64 = 900.0;
const ROOMY: [f64; 2] = [1200.0, 1600.0];
/// The same if no error is above zero, over the default.
const EMPTY: f64 = 0.4;
/// Height of one method's row in a band, over the size of the font.
const ROW: f64 = 0.85;
/// Names of the bands.
const BANDS: [&str; 2] = ["failed", "0 (exact)"];

/// A band along the upper or lower edge, with a row for each line that has something there.
struct Band {
    area: Area,
    lines: Vec<usize>,
}

impl Band {
    /// The middle of the row of a line.
    fn row(&self, line: usize) -> f64 {
        let row = self.lines.iter().position(|other| *other == line).expect("a line with marks in a band has a row");
        self.area.top + self.area.height() * (row as f64 + 0.5) / self.lines.len() as f64
    }
}

/// Where everything lies.
struct Layout {
    style: Style,
    plot: Area,
    /// Upper and lower end of the scale of errors.
    scale: (f64, f64),
    failed: Band,
    exact: Band,
    x_axis: LogAxis,
    /// None if no error is above zero.
    y_axis: Option<LogAxis>,
    y_ticks: Ticks,
}

impl Layout {
    /// The widest plot below `top` that leaves room for its labels, with this height between the bands.
    fn new(chart: &WorkPrecision, style: Style, top: f64, height: f64) -> Self {
        let em = style.em;
        let (x_axis, y_axis) = axes(chart);
        let failing = lines_with(chart, |point| point.failures() > 0);
        let exact = lines_with(chart, |point| point.known().any(|(_, error)| error == 0.0));
        let plot_top = top + band_height(&failing, em);
        let plot_bottom = plot_top + if y_axis.is_some() { height } else { EMPTY * height };
        let bottom = plot_bottom + band_height(&exact, em);
        // Beside a band the scale ends early, so that the label of its last tick stays clear of the label of the band.
        let clear = |lines: &[usize]| if lines.is_empty() { 0.0 } else { 0.7 * em };
        let scale = (plot_top + clear(&failing), plot_bottom - clear(&exact));
        let y_ticks = y_axis.map_or_else(Ticks::default, |axis| {
            let extent = ticks::extent(|value| axis.share(value), scale.1 - scale.0, em, true);
            ticks::fitting_or_fewer(|most| axis.ticks(most), extent, 0.3 * em)
        });
        let bands = BANDS.into_iter().zip([&failing, &exact]).filter(|(_, lines)| !lines.is_empty());
        let widest = bands.map(|(name, _)| font::width(name, em)).fold(y_ticks.widest(em), f64::max);
        let left = style.plot_left(&chart.y_label, bottom - top, widest);
        // Half of the last label of the horizontal axis may stand out to the right.
        let right = RIGHT - (0.5 * x_ticks(&x_axis, RIGHT - left, em).widest(em)).max(0.6 * em);
        let plot = Area { left, top: plot_top, right, bottom: plot_bottom };
        let failed = Band { area: Area { top, bottom: plot_top, ..plot }, lines: failing };
        let exact = Band { area: Area { top: plot_bottom, bottom, ..plot }, lines: exact };
        Layout { style, plot, scale, failed, exact, x_axis, y_axis, y_ticks }
    }

    fn x(&self, seconds: f64) -> f64 {
        self.plot.left + self.plot.width() * self.x_axis.share(seconds)
    }

    /// Place of an error of a line; zero has its row in the band.
    fn y(&self, line: usize, error: f64) -> f64 {
        match self.y_axis {
            Some(axis) if error > 0.0 => {
                let (top, bottom) = self.scale;
                bottom - (bottom - top) * axis.share(error)
            }
            _ => self.exact.row(line),
        }
    }

    /// The plot with its bands.
    fn whole(&self) -> Area {
        Area { top: self.failed.area.top, bottom: self.exact.area.bottom, ..self.plot }
    }

    /// The settings of a line with medians, and the places of these.
    fn medians<'a>(&self, i: usize, line: &'a MethodLine) -> Vec<(&'a SettingPoint, Point)> {
        let place = |point: &'a SettingPoint| {
            point.medians().map(|medians| (point, (self.x(medians.seconds), self.y(i, medians.error))))
        };
        line.points.iter().filter_map(place).collect()
    }
}

fn points(chart: &WorkPrecision) -> impl Iterator<Item = &SettingPoint> {
    chart.lines.iter().flat_map(|line| &line.points)
}

/// The axes of seconds and of errors; none of errors if none is above zero.
fn axes(chart: &WorkPrecision) -> (LogAxis, Option<LogAxis>) {
    let drawn = points(chart).flat_map(|point| point.known().map(|pair| pair.0).chain(point.failed()));
    let all = points(chart).flat_map(|point| &point.cases).map(|(seconds, _)| *seconds);
    let x = LogAxis::around(drawn).or_else(|| LogAxis::around(all)).expect("the chart was checked and has a case");
    let errors = points(chart).flat_map(SettingPoint::known).map(|pair| pair.1);
    (x, LogAxis::around(errors.filter(|error| *error > 0.0)))
}

/// The lines of which some setting is of a kind.
fn lines_with(chart: &WorkPrecision, is: impl Fn(&SettingPoint) -> bool) -> Vec<usize> {
    (0..chart.lines.len()).filter(|i| chart.lines[*i].points.iter().any(&is)).collect()
}

fn band_height(lines: &[usize], em: f64) -> f64 {
    if lines.is_empty() { 0.0 } else { (lines.len() as f64 * ROW + 0.3) * em }
}

/// Ticks of a horizontal axis of this length.
fn x_ticks(axis: &LogAxis, length: f64, em: f64) -> Ticks {
    let extent = ticks::extent(|value| axis.share(value), length, em, false);
    ticks::fitting_or_fewer(|most| axis.ticks(most), extent, 0.6 * em)
}

/// How the number of cases that failed is written at a setting.
#[derive(Clone, Copy, PartialEq)]
enum Wording {
    /// "3 of 63 failed"
    Full,
    /// "(3)", which the legend explains.
    Short,
}

/// Draws the chart, which has been checked and has a case. Where labels crowd they become shorter, then the chart
/// higher if its height is free.
pub(crate) fn draw(chart: &WorkPrecision, paper: &Paper, stretch: f64) -> Scene {
    let style = Style { name_below: 1.8, ..Style::plot(paper) };
    let lay_out = |height: f64, wording| lay_out(chart, style, stretch * height, wording);
    let (full, crowded) = lay_out(HEIGHT, Wording::Full);
    if !crowded {
        return full;
    }
    let (mut short, mut crowded) = lay_out(HEIGHT, Wording::Short);
    for height in ROOMY.into_iter().filter(|_| paper.height.is_none()) {
        if crowded {
            (short, crowded) = lay_out(height, Wording::Short);
        }
    }
    short
}

/// The chart with `height` pixels between the bands, and whether its labels crowd.
fn lay_out(chart: &WorkPrecision, style: Style, height: f64, wording: Wording) -> (Scene, bool) {
    let em = style.em;
    let mut scene = Scene::default();
    let top = style.heading(&mut scene, &chart.title, &chart.subtitle);
    let layout = Layout::new(chart, style, top, height);
    draw_axes(&mut scene, &layout);
    let below = style.names(&mut scene, layout.whole(), &chart.x_label, &chart.y_label);
    if layout.y_axis.is_none() {
        let at = (layout.plot.centre().0, layout.plot.bottom - 0.5 * em);
        scene.text(at, Anchor::Middle, em, QUIET_TEXT, why_empty(chart));
    }
    draw_cases(&mut scene, chart, &layout);
    let crowded = draw_medians(&mut scene, chart, &layout, wording);
    scene.frame(layout.whole(), 3.0, FRAME);
    style.finish(&mut scene, &entries(chart, wording), (MARGIN, below));
    (scene, crowded)
}

/// Why there is no error above zero.
fn why_empty(chart: &WorkPrecision) -> &'static str {
    let has = |is: fn(&Outcome) -> bool| points(chart).any(|point| point.cases.iter().any(|(_, outcome)| is(outcome)));
    if has(|outcome| matches!(outcome, Outcome::Error(_))) {
        "no error above zero"
    } else if has(|outcome| *outcome == Outcome::Unknown) {
        "no error is known"
    } else {
        "no case was solved"
    }
}

/// Draws bands, grid and ticks with their labels.
fn draw_axes(scene: &mut Scene, layout: &Layout) {
    let style = layout.style;
    let (plot, whole) = (layout.plot, layout.whole());
    let bands = [(&layout.failed, FAILED, plot.top), (&layout.exact, EXACT, plot.bottom)];
    let bands = || bands.into_iter().zip(BANDS).filter(|((band, ..), _)| !band.lines.is_empty());
    for ((band, ink, _), name) in bands() {
        scene.rectangle(band.area, faded(ink, 0.6));
        style.label_beside(scene, (plot.left, band.area.centre().1), name);
    }
    let x_ticks = x_ticks(&layout.x_axis, plot.width(), style.em);
    let x = Side { ticks: &x_ticks, at: &|value| layout.x(value) };
    let y = Side { ticks: &layout.y_ticks, at: &|value| layout.y(0, value) };
    style.grid(scene, whole, &x, &y);
    style.ticks_below(scene, whole, &x, true);
    style.ticks_beside(scene, whole, &y, true);
    for ((_, _, edge), _) in bands() {
        scene.line((plot.left, edge), (plot.right, edge), 2.0, FRAME);
    }
}

/// Draws a small marker or a cross for each case.
fn draw_cases(scene: &mut Scene, chart: &WorkPrecision, layout: &Layout) {
    let em = layout.style.em;
    for (i, line) in chart.lines.iter().enumerate() {
        let ink = palette::line_colour(i);
        for (seconds, outcome) in line.points.iter().flat_map(|point| &point.cases) {
            let x = layout.x(*seconds);
            match outcome {
                Outcome::Error(error) => {
                    let at = (x, layout.y(i, *error));
                    marker::marker(scene, Form::of(i), at, SMALL_RADIUS * em, faded(ink, SMALL_OPACITY));
                }
                Outcome::Unknown => {}
                Outcome::Failed => marker::cross(scene, (x, layout.failed.row(i)), 0.2 * em, 0.09 * em, ink),
            }
        }
    }
}

/// The label of a setting, line by line.
fn words(point: &SettingPoint, wording: Wording) -> Vec<String> {
    let (label, failures, cases) = (&point.label, point.failures(), point.cases.len());
    match wording {
        _ if failures == 0 => vec![label.clone()],
        Wording::Short => vec![format!("{label} ({failures})")],
        Wording::Full if failures == cases => vec![label.clone(), format!("all {cases} failed")],
        Wording::Full => vec![label.clone(), format!("{failures} of {cases} failed")],
    }
}

/// Draws lines, median markers and the labels of settings. Returns whether labels crowd.
fn draw_medians(scene: &mut Scene, chart: &WorkPrecision, layout: &Layout, wording: Wording) -> bool {
    let em = layout.style.em;
    for (i, line) in chart.lines.iter().enumerate() {
        let path: Vec<Point> = layout.medians(i, line).into_iter().map(|(_, at)| at).collect();
        if path.len() > 1 {
            scene.path(path, 5.0, palette::line_colour(i));
        }
    }
    let mut obstacles = obstacles(chart, layout);
    let reach = LARGE_RADIUS * em + 8.0;
    let texts: Vec<Shape> = setting_labels(chart, layout, wording)
        .iter()
        .flat_map(|label| label.place(&mut obstacles, reach, LABEL * em, scene))
        .collect();
    for (i, line) in chart.lines.iter().enumerate() {
        for (_, at) in layout.medians(i, line) {
            marker::rimmed(scene, Form::of(i), at, LARGE_RADIUS * em, palette::line_colour(i));
        }
    }
    scene.shapes.extend(texts);
    obstacles.crowded
}

/// What the labels of settings must not cover: median markers, lines, and as few cases as possible.
fn obstacles(chart: &WorkPrecision, layout: &Layout) -> Obstacles {
    let em = layout.style.em;
    let mut bounds = layout.whole().grown(-8.0);
    bounds.top = layout.plot.top + 8.0;
    if layout.y_axis.is_none() {
        // There the chart says why it is empty.
        bounds.bottom = layout.plot.bottom - 1.5 * em;
    }
    let mut obstacles = Obstacles { bounds, solid: vec![], lines: vec![], faint: vec![], crowded: false };
    for (i, line) in chart.lines.iter().enumerate() {
        let medians = layout.medians(i, line);
        obstacles.lines.extend(medians.windows(2).map(|pair| (pair[0].1, pair[1].1)));
        obstacles.solid.extend(medians.iter().map(|(_, at)| Area::about(*at, LARGE_RADIUS * em + 4.0)));
        let cases = line.points.iter().flat_map(SettingPoint::known);
        obstacles.faint.extend(cases.map(|(seconds, error)| (layout.x(seconds), layout.y(i, error))));
    }
    obstacles
}

/// The labels of settings in the order in which they choose their places: those beside the band first, since they have
/// the fewest places; then those that must be shown.
fn setting_labels(chart: &WorkPrecision, layout: &Layout, wording: Wording) -> Vec<SettingLabel> {
    let mut labels = Vec::new();
    for (i, line) in chart.lines.iter().enumerate() {
        let ink = palette::darkened(palette::line_colour(i));
        let mut add = |point: &SettingPoint, at: Point, effort: Effort| {
            labels.push(SettingLabel { at, ink, words: words(point, wording), effort });
        };
        let medians = layout.medians(i, line);
        for (k, (point, at)) in medians.iter().enumerate() {
            let ends = k == 0 || k + 1 == medians.len();
            add(point, *at, if ends || point.failures() > 0 { Effort::Always } else { Effort::Near });
        }
        for point in line.points.iter().filter(|point| point.failures() > 0 && point.medians().is_none()) {
            let logarithms = point.failed().map(f64::log10);
            let middle =
                10f64.powf(logarithms.sum::<f64>() / point.failures() as f64).clamp(0.0_f64.next_up(), f64::MAX);
            add(point, (layout.x(middle), layout.plot.top), Effort::Far);
        }
    }
    labels.sort_by_key(|label| match label.effort {
        Effort::Far => 0,
        Effort::Always => 1,
        Effort::Near => 2,
    });
    labels
}

/// The legend: methods, and what small markers and crosses mean if there are some.
fn entries(chart: &WorkPrecision, wording: Wording) -> Vec<Entry> {
    let mut entries: Vec<Entry> = chart
        .lines
        .iter()
        .enumerate()
        .map(|(i, line)| Entry {
            swatch: Swatch::Line { form: Form::of(i), ink: palette::line_colour(i) },
            label: line.label.clone(),
        })
        .collect();
    if points(chart).any(|point| point.known().next().is_some()) {
        let label = "one case (large: median)".to_string();
        entries.push(Entry { swatch: Swatch::Small { form: Form::DISC, ink: TEXT }, label });
    }
    if points(chart).any(|point| point.failures() > 0) {
        let label = match wording {
            Wording::Full => "case that failed",
            Wording::Short => "case that failed; in brackets: how many of a setting",
        };
        entries.push(Entry { swatch: Swatch::Cross { ink: TEXT }, label: label.to_string() });
    }
    entries
}
