//! A fitted material as a table, as JSON, as lines for a sweep file and as a chart.

use serde_json::json;

use crate::format::{Align, count, table_line};
use crate::pictures::Chart;
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_input::printable;
use stribeck_lab::{Measurement, Measurements, RelaxationFit, RelaxationTerm};
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
}

impl FittedMaterial<'_> {
    /// How good the fit is, the numbers of the material, its two spectra, and the lines for a sweep file.
    pub fn table(&self) -> String {
        let (relaxation, material) = (&self.fit.relaxation, self.fit.relaxation.material());
        let (from, to) = self.range();
        let mut text = format!(
            "{} from {} to {} rad/s; {} of {} kept\n",
            count(self.measurements.rows().len() as u64, "row"),
            digits(from),
            digits(to),
            relaxation.terms().len(),
            count(self.offered as u64, "term"),
        );
        let rows = [
            ("residual, rms", self.fit.rms_residual, "of |E*|"),
            ("residual, largest", self.fit.largest_residual, "of |E*|"),
            ("E0", relaxation.instantaneous_modulus(), "Pa, instantaneous modulus"),
            ("Einf", relaxation.relaxed_modulus(), "Pa, relaxed modulus"),
            ("f", material.f, "E0/Einf - 1"),
            ("retardation time", material.retardation_time, "s, mean weighted by shares"),
        ];
        for (name, value, meaning) in rows {
            text += &table_line(&[Align::Left(18), Align::Right(11), Align::Left(0)], &[name, &digits(value), meaning]);
        }
        text += "\nrelaxation   modulus/Pa       time/s      retardation        share       time/s\n";
        let columns = [23, 11, 28, 11].map(Align::Right);
        // One line for each term: the retardation time above a relaxation time and below the next.
        for (term, (strength, time)) in self.terms().iter().zip(material.retardation()) {
            text += &table_line(&columns, &[term.modulus, term.time, strength / material.f, time].map(digits));
        }
        text + "\nFor a sweep file:\n\n" + &self.toml()
    }

    /// The relaxation terms in ascending order of their times.
    fn terms(&self) -> Vec<RelaxationTerm> {
        let mut terms = self.fit.relaxation.terms().to_vec();
        terms.sort_by(|a, b| a.time.total_cmp(&b.time));
        terms
    }

    /// The section `[substrate]` of a sweep file with this material.
    fn toml(&self) -> String {
        let modulus = format!("{:?}", self.fit.relaxation.relaxed_modulus());
        let mut text = format!("[substrate]\nrelaxed_modulus = {modulus:<16}  # Pa\nrelaxation = [\n");
        for RelaxationTerm { modulus, time } in self.terms() {
            text += &format!("    {{ modulus = {modulus:?}, time = {time:?} }},\n");
        }
        text + "]\n"
    }

    /// All numbers, and the lines for a sweep file.
    pub fn json(&self) -> String {
        let (relaxation, material) = (&self.fit.relaxation, self.fit.relaxation.material());
        let term = |term: &RelaxationTerm| json!({ "modulus": term.modulus, "time": term.time });
        let mode = |(strength, time): (f64, f64)| json!({ "share": strength / material.f, "time": time });
        let object = json!({
            "rows": self.measurements.rows().len(),
            "offered_terms": self.offered,
            "rms_residual": self.fit.rms_residual,
            "largest_residual": self.fit.largest_residual,
            "instantaneous_modulus": relaxation.instantaneous_modulus(),
            "relaxed_modulus": relaxation.relaxed_modulus(),
            "f": material.f,
            "retardation_time": material.retardation_time,
            "relaxation": self.terms().iter().map(term).collect::<Vec<_>>(),
            "retardation": material.retardation().map(mode).collect::<Vec<_>>(),
            "toml": self.toml(),
        });
        serde_json::to_string_pretty(&object).expect("strings and numbers can be written") + "\n"
    }

    /// Measured moduli as points and those of the fit as lines, over the angular frequency.
    pub fn chart(&self) -> Chart {
        let relaxation = &self.fit.relaxation;
        let fit = |omega: f64| {
            let (storage, loss) = relaxation.storage_and_loss(omega);
            Measurement { omega, storage, loss }
        };
        let (from, to) = self.range();
        let omega = |i: u32| from * (to / from).powf(f64::from(i) / f64::from(POINTS));
        let fitted: Vec<Measurement> = (0..=POINTS).map(|i| fit(omega(i))).collect();
        let curves = |kind: usize, label: &str, modulus: fn(&Measurement) -> f64| {
            let curve = |label: &str, rows: &[Measurement], stroke| Curve {
                label: label.to_owned(),
                points: rows.iter().map(|row| (row.omega, modulus(row))).collect(),
                failed: Vec::new(),
                stroke,
                colour: Colour::Kind(kind),
                marked: stroke == Stroke::Points,
            };
            [curve("", self.measurements.rows(), Stroke::Points), curve(label, &fitted, Stroke::Solid)]
        };
        let axis = |label: &str| LineAxis { label: label.to_owned(), logarithmic: true, range: None };
        Chart::Lines(Lines {
            title: format!("Fit to {}", printable(self.name)),
            subtitle: format!(
                "dots: measured; lines: {}, {} % rms",
                count(relaxation.terms().len() as u64, "relaxation term"),
                shortest((1e4 * self.fit.rms_residual).round() / 100.0)
            ),
            x: axis("angular frequency ω, rad/s"),
            y: axis("modulus, Pa"),
            curves: [curves(0, "storage E′", |row| row.storage), curves(1, "loss E″", |row| row.loss)].concat(),
        })
    }

    /// The lowest and the highest ω.
    fn range(&self) -> (f64, f64) {
        let rows = self.measurements.rows();
        (rows[0].omega, rows[rows.len() - 1].omega)
    }
}

/// Six digits.
fn digits(value: f64) -> String {
    format!("{value:.5e}")
}
