//! A small plot of characters, for a look at the terminal.

use textcanvas::TextCanvas;

/// Size in characters; one holds 2 × 4 dots.
const COLUMNS: i32 = 60;
const ROWS: i32 = 14;

/// One axis.
#[derive(Clone, Copy)]
pub struct TextAxis {
    /// True if equal ratios are equal lengths.
    pub logarithmic: bool,
}

impl TextAxis {
    fn place(self, value: f64) -> f64 {
        if self.logarithmic { value.log10() } else { value }
    }

    /// The number at a place, with three digits.
    fn label(self, place: f64) -> String {
        let value = if self.logarithmic { 10_f64.powf(place) } else { place };
        let rounded: f64 = format!("{value:.2e}").parse().expect("{:e} writes a number");
        if rounded != 0.0 && !(1e-3..1e5).contains(&rounded.abs()) {
            format!("{rounded:e}")
        } else {
            format!("{rounded}")
        }
    }
}

/// A line, and points as crosses over it; numbers without a place are left out. Empty if there is nothing to draw.
pub fn plot(line: &[(f64, f64)], points: &[(f64, f64)], x: TextAxis, y: TextAxis) -> String {
    let placed = |values: &[(f64, f64)]| -> Vec<(f64, f64)> {
        let at = values.iter().map(|(a, b)| (x.place(*a), y.place(*b)));
        at.filter(|(a, b)| a.is_finite() && b.is_finite()).collect()
    };
    let (line, points) = (placed(line), placed(points));
    if line.is_empty() && points.is_empty() {
        return String::new();
    }
    let ends = |of: fn(&(f64, f64)) -> f64| {
        let values = || line.iter().chain(&points).map(of);
        let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        let room = if high > low { 0.02 * (high - low) } else { 0.5 };
        (low - room, high + room)
    };
    let ((left, right), (bottom, top)) = (ends(|at| at.0), ends(|at| at.1));
    // What is nowhere negative begins at 0, not a little below.
    let is_positive = !y.logarithmic && line.iter().chain(&points).all(|at| at.1 >= 0.0);
    let bottom = if is_positive && bottom < 0.2 * top { 0.0 } else { bottom };

    let mut canvas = TextCanvas::new(COLUMNS, ROWS);
    let (width, height) = (2 * COLUMNS, 4 * ROWS);
    let dot = |(a, b): (f64, f64)| {
        let (across, up) = ((a - left) / (right - left), (b - bottom) / (top - bottom));
        ((across * f64::from(width - 1)).round() as i32, ((1.0 - up) * f64::from(height - 1)).round() as i32)
    };
    canvas.stroke_rect(0, 0, width, height);
    for pair in line.windows(2) {
        let (from, to) = (dot(pair[0]), dot(pair[1]));
        canvas.stroke_line(from.0, from.1, to.0, to.1);
    }
    for point in points {
        let (across, down) = dot(point);
        canvas.draw_text("×", across / 2, down / 4);
    }
    let drawn = canvas.to_string();
    let mut rows: Vec<String> = drawn.lines().map(|row| row.trim_end_matches(['\r', '\n']).to_owned()).collect();
    let (first, last) = (y.label(top), y.label(bottom));
    rows[0] += &format!(" {first}");
    rows[ROWS as usize - 1] += &format!(" {last}");
    let (first, last) = (x.label(left), x.label(right));
    rows.push(format!("{first}{last:>width$}", width = COLUMNS as usize - first.chars().count()));
    rows.join("\n") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOGARITHMIC: TextAxis = TextAxis { logarithmic: true };
    const LINEAR: TextAxis = TextAxis { logarithmic: false };

    #[test]
    fn a_plot_has_its_numbers_at_its_ends() {
        let line: Vec<(f64, f64)> = (0..=30).map(|i| 10_f64.powf(-3.0 + 0.1 * f64::from(i))).map(|v| (v, v)).collect();
        let text = plot(&line, &[(0.0316, 0.0316), (0.0, 1.0)], LOGARITHMIC, LOGARITHMIC);
        let rows: Vec<&str> = text.lines().collect();
        assert_eq!(rows.len(), ROWS as usize + 1, "{text}");
        assert!(rows[0].ends_with(" 1.15") && rows[13].ends_with(" 8.71e-4"), "{text}");
        assert!(rows[14].starts_with("8.71e-4 ") && rows[14].ends_with(" 1.15"), "{text}");
        // the point in the middle, the one without a logarithm nowhere
        assert_eq!(text.matches('×').count(), 1);
        assert!(rows[6].contains('×') || rows[7].contains('×'), "{text}");
        assert_eq!(plot(&[(f64::NAN, 1.0)], &[], LOGARITHMIC, LINEAR), "");
    }

    #[test]
    fn what_is_positive_begins_at_zero() {
        let text = plot(&[(1.0, 0.01), (2.0, 1.0)], &[], LINEAR, LINEAR);
        assert!(text.lines().nth(13).is_some_and(|row| row.ends_with(" 0")), "{text}");
        let text = plot(&[(1.0, -1.0), (2.0, 1.0)], &[], LINEAR, LINEAR);
        assert!(text.lines().nth(13).is_some_and(|row| row.ends_with(" -1.04")), "{text}");
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [0.012345, 1234.5, 1e-5, 0.0, 123456.0].map(|value| LINEAR.label(value)),
            ["0.0123", "1230", "1e-5", "0", "1.23e5"]
        );
    }
}
