//! Error against run time: the layout.

use super::legend::{self, Entry, LARGE_RADIUS, SMALL_OPACITY, SMALL_RADIUS, Swatch};
use super::log_axis::LogAxis;
use super::marker::{self, Form};
use super::paint::WIDTH;
use super::palette::{self, EXACT, FAILED, FRAME, GRID, QUIET_TEXT, TEXT, faded};
use super::placement::{Effort, Obstacles};
use super::scene::{Anchor, Area, Point, Scene, Shape};
use super::setting_label::SettingLabel;
use super::ticks::{self, Tick, Ticks};
use super::work_precision::{Outcome, SettingPoint, WorkPrecision};
use super::{font, scene};

/// Size of the font of ticks: 6 points when the picture is 8.5 cm wide.
const EM: f64 = 40.0;
/// Size of the font of the labels of settings.
const LABEL_EM: f64 = 34.0;
/// Height of the part between the bands if no error is above zero.
const EMPTY_HEIGHT: f64 = 360.0;
/// Height of one method's row in a band.
const ROW: f64 = 0.85 * EM;
const MARGIN: f64 = 30.0;

/// A band along the upper or lower edge, with a row for each line that has something there.
struct Band {
    area: Area,
    lines: Vec<usize>,
}

impl Band {
    fn row(&self, line: usize) -> f64 {
        let row = self.lines.iter().position(|other| *other == line).expect("a line with marks in a band has a row");
        self.area.top + self.area.height() * (row as f64 + 0.5) / self.lines.len() as f64
    }
}

/// Where everything lies.
struct Layout {
    plot: Area,
    /// Upper and lower end of the scale of errors.
    scale: (f64, f64),
    failed: Band,
    exact: Band,
    x_axis: LogAxis,
    /// None if no error is above zero.
    y_axis: Option<LogAxis>,
}

impl Layout {
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

    fn whole(&self) -> Area {
        Area { top: self.failed.area.top, bottom: self.exact.area.bottom, ..self.plot }
    }
}

/// How the number of cases that failed is written at a setting.
#[derive(Clone, Copy, PartialEq)]
enum Wording {
    /// "3 of 63 failed"
    Full,
    /// "(3)", which the legend explains.
    Short,
}

/// The chart; it has been checked and has at least one case. Where labels crowd they become shorter, then the chart higher.
pub(super) fn draw(chart: &WorkPrecision) -> Scene {
    let roomy = [(900.0, Wording::Full), (900.0, Wording::Short), (1200.0, Wording::Short)];
    let scenes = roomy.into_iter().map(|(height, wording)| lay_out(chart, height, wording));
    let found = scenes.into_iter().find(|(_, crowded)| !crowded);
    found.unwrap_or_else(|| lay_out(chart, 1600.0, Wording::Short)).0
}

/// The chart with `height` pixels between the bands, and whether its labels crowd.
fn lay_out(chart: &WorkPrecision, height: f64, wording: Wording) -> (Scene, bool) {
    let mut scene = Scene::default();
    let right = f64::from(WIDTH) - MARGIN;
    let top = scene.heading(1.12 * EM, MARGIN, right - MARGIN, &chart.title, &chart.subtitle) + 0.5 * EM;

    let points = || chart.lines.iter().flat_map(|line| &line.points);
    let drawn = points().flat_map(|point| point.known().map(|pair| pair.0).chain(point.failed()));
    let all = points().flat_map(|point| &point.cases).map(|(seconds, _)| *seconds);
    let x_axis = LogAxis::around(drawn).or_else(|| LogAxis::around(all)).expect("the chart was checked and has a case");
    let y_axis = LogAxis::around(points().flat_map(SettingPoint::known).map(|pair| pair.1).filter(|e| *e > 0.0));
    let lines_with = |mark: &dyn Fn(&SettingPoint) -> bool| -> Vec<usize> {
        (0..chart.lines.len()).filter(|i| chart.lines[*i].points.iter().any(mark)).collect()
    };
    let failing = lines_with(&|point| point.failures() > 0);
    let exact = lines_with(&|point| point.known().any(|(_, error)| error == 0.0));

    let band = |lines: &[usize]| if lines.is_empty() { 0.0 } else { lines.len() as f64 * ROW + 0.3 * EM };
    let plot_top = top + band(&failing);
    let plot_height = if y_axis.is_some() { height } else { EMPTY_HEIGHT };
    let plot_bottom = plot_top + plot_height;
    // Beside a band the scale ends early, so that the label of its last tick stays clear of the label of the band.
    let clear = |lines: &[usize]| if lines.is_empty() { 0.0 } else { 0.7 * EM };
    let (scale_top, scale_bottom) = (plot_top + clear(&failing), plot_bottom - clear(&exact));
    let y_ticks = y_axis.map_or_else(Ticks::default, |axis| {
        let place = |value: f64| scale_bottom - (scale_bottom - scale_top) * axis.share(value);
        ticks::fitting(
            |most| axis.ticks(most),
            |tick| (place(tick.value) - 0.6 * EM, place(tick.value) + 0.6 * EM),
            0.3 * EM,
        )
    });
    let mut names: Vec<&str> = y_ticks.major.iter().map(|tick| tick.label.as_str()).collect();
    names.extend((!failing.is_empty()).then_some("failed"));
    names.extend((!exact.is_empty()).then_some("0 (exact)"));
    let widest = names.iter().map(|name| font::width(name, EM)).fold(0.0, f64::max);
    let whole_height = band(&failing) + plot_height + band(&exact);
    let label_width = scene::thickness(&chart.y_label, 1.1 * EM, whole_height);
    let left = MARGIN + label_width + 0.3 * EM + widest + 0.4 * EM;
    // Half of the last label of the horizontal axis may stand out to the right.
    let labels = x_ticks(&x_axis, left, right).major;
    let half_label = labels.iter().map(|tick| 0.5 * font::width(&tick.label, EM));
    let plot = Area { left, top: plot_top, right: right - half_label.fold(0.6 * EM, f64::max), bottom: plot_bottom };
    let layout = Layout {
        plot,
        scale: (scale_top, scale_bottom),
        failed: Band { area: Area { top, bottom: plot.top, ..plot }, lines: failing },
        exact: Band { area: Area { top: plot.bottom, bottom: plot.bottom + band(&exact), ..plot }, lines: exact },
        x_axis,
        y_axis,
    };
    scene.upright((MARGIN, layout.whole().centre().1), 1.1 * EM, TEXT, whole_height, &chart.y_label);
    let ticks_bottom = draw_axes(&mut scene, &layout, &y_ticks);
    let x_bottom = scene.paragraph(
        (plot.centre().0, ticks_bottom + 0.1 * EM),
        Anchor::Middle,
        1.1 * EM,
        TEXT,
        plot.width(),
        &chart.x_label,
    );
    if y_axis.is_none() {
        let has = |is: fn(&Outcome) -> bool| points().any(|point| point.cases.iter().any(|(_, outcome)| is(outcome)));
        let words = if has(|outcome| matches!(outcome, Outcome::Error(_))) {
            "no error above zero"
        } else if has(|outcome| *outcome == Outcome::Unknown) {
            "no error is known"
        } else {
            "no case was solved"
        };
        scene.text((plot.centre().0, plot.bottom - 0.5 * EM), Anchor::Middle, EM, QUIET_TEXT, words);
    }
    draw_cases(&mut scene, chart, &layout);
    let crowded = draw_medians(&mut scene, chart, &layout, wording);
    scene.frame(layout.whole(), 3.0, FRAME);

    let bottom = legend::draw(&mut scene, &entries(chart, wording), (MARGIN, x_bottom + 0.5 * EM), right, EM);
    scene.height = (bottom + 0.6 * EM).ceil();
    (scene, crowded)
}

/// Ticks of the horizontal axis from `left` to `right`.
fn x_ticks(axis: &LogAxis, left: f64, right: f64) -> Ticks {
    let extent = |tick: &Tick| {
        let (middle, half) = ((right - left) * axis.share(tick.value), 0.5 * font::width(&tick.label, EM));
        (middle - half, middle + half)
    };
    ticks::fitting(|most| axis.ticks(most), extent, 0.6 * EM)
}

/// Bands, grid, ticks and their labels; returns where the labels of the horizontal axis end.
fn draw_axes(scene: &mut Scene, layout: &Layout, y_ticks: &Ticks) -> f64 {
    let (plot, whole) = (layout.plot, layout.whole());
    let x_ticks = x_ticks(&layout.x_axis, plot.left, plot.right);
    for (band, ink, name) in [(&layout.failed, FAILED, "failed"), (&layout.exact, EXACT, "0 (exact)")] {
        if !band.lines.is_empty() {
            scene.rectangle(band.area, faded(ink, 0.6));
            scene.text((plot.left - 0.4 * EM, band.area.centre().1 + 0.36 * EM), Anchor::End, EM, TEXT, name);
        }
    }
    for tick in &x_ticks.major {
        scene.line((layout.x(tick.value), whole.top), (layout.x(tick.value), whole.bottom), 2.0, GRID);
    }
    let y = |value: f64| layout.y(0, value);
    for tick in &y_ticks.major {
        scene.line((plot.left, y(tick.value)), (plot.right, y(tick.value)), 2.0, GRID);
        scene.line((plot.left - 12.0, y(tick.value)), (plot.left, y(tick.value)), 3.0, FRAME);
        scene.text((plot.left - 0.4 * EM, y(tick.value) + 0.36 * EM), Anchor::End, EM, TEXT, tick.label.as_str());
    }
    for value in &y_ticks.minor {
        scene.line((plot.left - 6.0, y(*value)), (plot.left, y(*value)), 2.0, FRAME);
    }
    for tick in &x_ticks.major {
        let x = layout.x(tick.value);
        scene.line((x, whole.bottom), (x, whole.bottom + 12.0), 3.0, FRAME);
        scene.text((x, whole.bottom + 1.4 * EM), Anchor::Middle, EM, TEXT, tick.label.as_str());
    }
    for value in &x_ticks.minor {
        scene.line((layout.x(*value), whole.bottom), (layout.x(*value), whole.bottom + 6.0), 2.0, FRAME);
    }
    for band in [&layout.failed, &layout.exact].into_iter().filter(|band| !band.lines.is_empty()) {
        let edge = if band.area.top < plot.top { plot.top } else { plot.bottom };
        scene.line((plot.left, edge), (plot.right, edge), 2.0, FRAME);
    }
    whole.bottom + 1.7 * EM
}

fn draw_cases(scene: &mut Scene, chart: &WorkPrecision, layout: &Layout) {
    for (i, line) in chart.lines.iter().enumerate() {
        let ink = palette::line_colour(i);
        for (seconds, outcome) in line.points.iter().flat_map(|point| &point.cases) {
            let x = layout.x(*seconds);
            match outcome {
                Outcome::Error(error) => {
                    let at = (x, layout.y(i, *error));
                    marker::marker(scene, Form::of(i), at, SMALL_RADIUS * EM, faded(ink, SMALL_OPACITY));
                }
                Outcome::Unknown => {}
                Outcome::Failed => marker::cross(scene, (x, layout.failed.row(i)), 0.2 * EM, 3.5, ink),
            }
        }
    }
}

/// The lines of the label of a setting.
fn words(point: &SettingPoint, wording: Wording) -> Vec<String> {
    let (label, failures, cases) = (&point.label, point.failures(), point.cases.len());
    match wording {
        _ if failures == 0 => vec![label.clone()],
        Wording::Short => vec![format!("{label} ({failures})")],
        Wording::Full if failures == cases => vec![label.clone(), format!("all {cases} failed")],
        Wording::Full => vec![label.clone(), format!("{failures} of {cases} failed")],
    }
}

/// Lines, median markers and the labels of settings; returns whether labels crowd.
fn draw_medians(scene: &mut Scene, chart: &WorkPrecision, layout: &Layout, wording: Wording) -> bool {
    let mut wanted = Vec::new();
    let mut obstacles =
        Obstacles { bounds: layout.whole().grown(-8.0), solid: vec![], lines: vec![], faint: vec![], crowded: false };
    obstacles.bounds.top = layout.plot.top + 8.0;
    if layout.y_axis.is_none() {
        // There the chart says why it is empty.
        obstacles.bounds.bottom = layout.plot.bottom - 1.5 * EM;
    }
    let mut markers = Vec::new();
    for (i, line) in chart.lines.iter().enumerate() {
        let ink = palette::line_colour(i);
        let text_ink = palette::darkened(ink);
        let medians: Vec<(&SettingPoint, Point)> = line
            .points
            .iter()
            .filter_map(|point| point.medians().map(|m| (point, (layout.x(m.seconds), layout.y(i, m.error)))))
            .collect();
        let path: Vec<Point> = medians.iter().map(|(_, at)| *at).collect();
        obstacles.lines.extend(path.windows(2).map(|pair| (pair[0], pair[1])));
        if path.len() > 1 {
            scene.path(path, 5.0, ink);
        }
        for (k, (point, at)) in medians.iter().enumerate() {
            markers.push((i, *at));
            let failures = point.failures();
            let words = words(point, wording);
            let ends = k == 0 || k + 1 == medians.len();
            let effort = if ends || failures > 0 { Effort::Always } else { Effort::Near };
            wanted.push(SettingLabel { at: *at, ink: text_ink, words, effort });
        }
        for point in line.points.iter().filter(|point| point.failures() > 0 && point.medians().is_none()) {
            let logarithms = point.failed().map(f64::log10);
            let middle = 10f64.powf(logarithms.sum::<f64>() / point.failures() as f64);
            let words = words(point, wording);
            wanted.push(SettingLabel {
                at: (layout.x(middle), layout.plot.top),
                ink: text_ink,
                words,
                effort: Effort::Far,
            });
        }
        let cases = line.points.iter().flat_map(SettingPoint::known);
        obstacles.faint.extend(cases.map(|(seconds, error)| (layout.x(seconds), layout.y(i, error))));
    }
    obstacles.solid = markers.iter().map(|(_, at)| Area::about(*at, LARGE_RADIUS * EM + 4.0)).collect();

    // Those beside the band choose first, since they have the fewest places; then those that must be shown.
    wanted.sort_by_key(|label| match label.effort {
        Effort::Far => 0,
        Effort::Always => 1,
        Effort::Near => 2,
    });
    let reach = LARGE_RADIUS * EM + 8.0;
    let texts: Vec<Shape> =
        wanted.iter().flat_map(|label| label.place(&mut obstacles, reach, LABEL_EM, scene)).collect();
    for (line, at) in markers {
        marker::rimmed(scene, Form::of(line), at, LARGE_RADIUS * EM, palette::line_colour(line));
    }
    scene.shapes.extend(texts);
    obstacles.crowded
}

fn entries(chart: &WorkPrecision, wording: Wording) -> Vec<Entry> {
    let points = || chart.lines.iter().flat_map(|line| &line.points);
    let mut entries: Vec<Entry> = chart
        .lines
        .iter()
        .enumerate()
        .map(|(i, line)| Entry {
            swatch: Swatch::Line { form: Form::of(i), ink: palette::line_colour(i) },
            label: line.label.clone(),
        })
        .collect();
    if points().any(|point| point.known().next().is_some()) {
        let label = "one case (large: median)".to_string();
        entries.push(Entry { swatch: Swatch::Small { form: Form::Disc, ink: TEXT }, label });
    }
    if points().any(|point| point.failures() > 0) {
        let label = match wording {
            Wording::Full => "case that failed",
            Wording::Short => "case that failed; in brackets: how many of a setting",
        };
        entries.push(Entry { swatch: Swatch::Cross { ink: TEXT }, label: label.to_string() });
    }
    entries
}
