//! A small plot of characters, for a look at the terminal.

use textplots::{Chart, LabelBuilder, LabelFormat, Plot, Shape};

/// Size in dots; a character holds 2 × 4 of them.
const WIDTH: u32 = 120;
const HEIGHT: u32 = 48;

/// One axis: its numbers, and whether equal ratios are equal lengths.
#[derive(Clone, Copy)]
pub struct TextAxis {
    /// True for a logarithmic one.
    pub logarithmic: bool,
}

/// A line and points over one another; numbers without a place are left out.
pub fn plot(line: &[(f64, f64)], points: &[(f64, f64)], x: TextAxis, y: TextAxis) -> String {
    let place = |axis: TextAxis, value: f64| if axis.logarithmic { value.log10() } else { value };
    let placed = |values: &[(f64, f64)]| -> Vec<(f32, f32)> {
        let at = values.iter().map(|(a, b)| (place(x, *a) as f32, place(y, *b) as f32));
        at.filter(|(a, b)| a.is_finite() && b.is_finite()).collect()
    };
    let (line, points) = (placed(line), placed(points));
    let ends = |of: fn(&(f32, f32)) -> f32| {
        let values = || line.iter().chain(&points).map(of);
        let (low, high) = (values().fold(f32::INFINITY, f32::min), values().fold(f32::NEG_INFINITY, f32::max));
        let room = if high > low { 0.02 * (high - low) } else { 0.5 };
        (low - room, high + room)
    };
    if line.is_empty() && points.is_empty() {
        return String::new();
    }
    let ((left, right), (bottom, top)) = (ends(|at| at.0), ends(|at| at.1));
    // What is nowhere negative begins at 0, not a little below.
    let is_positive = !y.logarithmic && line.iter().chain(&points).all(|at| at.1 >= 0.0);
    let bottom = if is_positive && bottom < 0.2 * top { 0.0 } else { bottom };
    let label = |axis: TextAxis| {
        LabelFormat::Custom(Box::new(move |at| {
            let value = f64::from(at);
            short(if axis.logarithmic { 10_f64.powf(value) } else { value })
        }))
    };
    let (joined, marks) = (Shape::Lines(&line), marks(&points, (right - left, top - bottom)));
    let marks = Shape::Points(&marks);
    let mut chart = Chart::new_with_y_range(WIDTH, HEIGHT, left, right, bottom, top);
    let chart = chart.lineplot(&joined).lineplot(&marks).x_label_format(label(x)).y_label_format(label(y));
    chart.borders();
    chart.figures();
    chart.to_string()
}

/// A small cross of dots for each point, which stands out from a line.
fn marks(points: &[(f32, f32)], (width, height): (f32, f32)) -> Vec<(f32, f32)> {
    let (across, up) = (width / WIDTH as f32, height / HEIGHT as f32);
    let cross = [(0.0, 0.0), (1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
    points.iter().flat_map(|(x, y)| cross.map(|(i, j)| (x + i * across, y + j * up))).collect()
}

/// A number with three digits.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().expect("{:e} writes a number");
    if rounded != 0.0 && !(1e-3..1e5).contains(&rounded.abs()) { format!("{rounded:e}") } else { format!("{rounded}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_has_its_numbers_at_its_ends() {
        let line: Vec<(f64, f64)> =
            (0..=30).map(|i| 10_f64.powf(-3.0 + 0.1 * f64::from(i))).map(|v| (v, v * v)).collect();
        let text = plot(&line, &[(0.01, 1e-4)], TextAxis { logarithmic: true }, TextAxis { logarithmic: true });
        assert!(text.lines().count() >= 12, "{text}");
        assert!(text.contains('⡠') || text.contains('⠔') || text.contains('⠊'), "a rising line: {text}");
        assert!(text.contains("1.15e-6") || text.contains("e-7"), "{text}");
        assert_eq!(plot(&[(f64::NAN, 1.0)], &[], TextAxis { logarithmic: true }, TextAxis { logarithmic: false }), "");
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.012345, 1234.5, 1e-5, 0.0, 123456.0].map(short), ["0.0123", "1230", "1e-5", "0", "1.23e5"]);
    }
}
