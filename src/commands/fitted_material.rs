//! A fitted material as a table, as JSON, as lines for a sweep file and as a chart.

use serde_json::{Value, json};

use super::material_text::{self, digits, number_line};
use super::shifted;
use crate::format::{count, filled};
use crate::pictures::Chart;
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_input::printable;
use stribeck_lab::{Doubt, MasterCurve, Measurement, Measurements, RelaxationFit, TermChoice};
use stribeck_solver::shortest;

/// Points of a curve of the fit.
const POINTS: u32 = 300;

/// A fit and the measurements that it was made from.
pub struct FittedMaterial<'a> {
    /// Name of the table.
    pub name: &'a str,
    pub measurements: &'a Measurements,
    pub fit: &'a RelaxationFit,
    /// The number of terms offered to the fit.
    pub offered: usize,
    /// Why it is that number, if nobody asked for it.
    pub choice: Option<&'a TermChoice>,
    /// How the measurements came to one temperature.
    pub master_curve: Option<&'a MasterCurve>,
}

impl FittedMaterial<'_> {
    /// How good the fit is, the numbers of the material, its two spectra, and the lines for a sweep file.
    pub fn table(&self) -> String {
        let relaxation = &self.fit.relaxation;
        let mut text = self.master_curve.map(shifted::table).unwrap_or_default();
        let (from, to, unit) = self.range();
        text += &format!(
            "{} from {} to {} {unit}; {} of {} kept\n",
            count(self.measurements.rows().len() as u64, "row"),
            digits(from),
            digits(to),
            relaxation.terms().len(),
            count(self.offered as u64, "term"),
        );
        text += &self.choice.map(|choice| filled(&reason(choice), "  ") + "\n").unwrap_or_default();
        let size = if self.is_oscillation() { "of |E*|" } else { "of E(t)" };
        text += &number_line("residual, rms", self.fit.rms_residual, size);
        text += &number_line("residual, largest", self.fit.largest_residual, size);
        text += &material_text::numbers(relaxation, true);
        text += &self.doubt().map(|doubt| filled(&format!("note: {doubt}"), "      ") + "\n").unwrap_or_default();
        text += &material_text::spectra(relaxation, true);
        text += &format!("\nFor a sweep file:\n\n{}", material_text::toml(&material_text::series(relaxation)));
        text + &self.master_curve.map(shifted::law_lines).unwrap_or_default()
    }

    /// All numbers, and the lines for a sweep file.
    pub fn json(&self) -> String {
        let relaxation = &self.fit.relaxation;
        let mut object = material_text::json(relaxation, true);
        let more = [
            ("rows", json!(self.measurements.rows().len())),
            ("offered_terms", json!(self.offered)),
            ("reason_for_terms", self.choice.map_or(Value::Null, |choice| json!(reason(choice)))),
            ("rms_residual", json!(self.fit.rms_residual)),
            ("largest_residual", json!(self.fit.largest_residual)),
            ("doubt", self.doubt().map_or(Value::Null, |doubt| json!(doubt.to_string()))),
            ("master_curve", self.master_curve.map_or(Value::Null, shifted::json)),
            ("toml", json!(material_text::toml(&material_text::series(relaxation)))),
        ];
        object.extend(more.map(|(key, value)| (key.to_owned(), value)));
        serde_json::to_string_pretty(&object).expect("strings and numbers can be written") + "\n"
    }

    /// What the measurements do not tell.
    fn doubt(&self) -> Option<Doubt> {
        Doubt::about(&self.fit.relaxation, self.measurements)
    }

    /// Measured moduli as points and those of the fit as lines, over the angular frequency or the time.
    pub fn chart(&self) -> Chart {
        let relaxation = &self.fit.relaxation;
        let (slow, fast) = self.measurements.rates();
        let rate = |i: u32| slow * (fast / slow).powf(f64::from(i) / f64::from(POINTS));
        let first = self.measurements.rows()[0];
        let at = |i: u32| relaxation.answer(&first.faster(rate(i) / first.rate()));
        let fitted: Vec<Measurement> = (0..=POINTS).map(at).collect();
        let curves = |kind: usize, label: &str| {
            let curve = |label: &str, rows: &[Measurement], stroke| Curve {
                label: label.to_owned(),
                points: rows.iter().map(|row| (place(row), row.moduli()[kind])).filter(|point| point.1 > 0.0).collect(),
                failed: Vec::new(),
                stroke,
                colour: Colour::Kind(kind),
                mark: Some(kind).filter(|_| stroke == Stroke::Points),
            };
            [curve("", self.measurements.rows(), Stroke::Points), curve(label, &fitted, Stroke::Solid)]
        };
        let (x, curves) = if self.is_oscillation() {
            ("angular frequency ω  (rad/s)", [curves(0, "storage E′"), curves(1, "loss E″")].concat())
        } else {
            ("time t  (s)", curves(0, "relaxation modulus E(t)").into())
        };
        let axis = |label: &str| LineAxis { label: label.to_owned(), logarithmic: true, range: None };
        let at_one = self.master_curve.map(|curve| format!(" at {}", shifted::celsius(curve.reference)));
        Chart::Lines(Lines {
            title: format!("Fit to {}{}", printable(self.name), at_one.unwrap_or_default()),
            subtitle: format!(
                "marks: measured; lines: {}, {} % rms",
                count(relaxation.terms().len() as u64, "relaxation term"),
                shortest((1e4 * self.fit.rms_residual).round() / 100.0)
            ),
            x: axis(x),
            y: axis("modulus  (Pa)"),
            curves,
        })
    }

    fn is_oscillation(&self) -> bool {
        matches!(self.measurements.rows()[0], Measurement::Oscillation { .. })
    }

    /// The lowest and the highest ω or t, with the unit.
    fn range(&self) -> (f64, f64, &'static str) {
        let rows = self.measurements.rows();
        let (slow, fast) = (place(&rows[0]), place(&rows[rows.len() - 1]));
        if self.is_oscillation() { (slow, fast, "rad/s") } else { (fast, slow, "s") }
    }
}

/// ω or t.
fn place(row: &Measurement) -> f64 {
    match *row {
        Measurement::Oscillation { omega, .. } => omega,
        Measurement::Relaxation { time, .. } => time,
    }
}

/// Why a number of terms was chosen.
fn reason(choice: &TermChoice) -> String {
    let TermChoice { offered, most, least_residual, least_at, .. } = choice;
    if choice.is_good_enough() {
        return format!("terms auto: {offered}, the fewest with a residual below {:e}", TermChoice::GOOD_ENOUGH);
    }
    format!(
        "terms auto: {offered}, the fewest with a residual within a tenth of the least, {least_residual:.3e} with \
         {least_at}; up to {most} were tried"
    )
}
