//! A Prony series that was read, as a table, as JSON, as lines for a sweep file and as a chart.

use serde_json::{Value, json};

use super::{material_text, shifted};
use crate::format::count;
use crate::pictures::Chart;
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_input::printable;
use stribeck_lab::{MasterCurve, PronySeries, Relaxation};

/// Points of a curve.
const POINTS: u32 = 300;

/// E∞/E₀ below which the sum of the terms, as it is printed, hardly differs from 1.
const HARDLY_SOLID: f64 = 1e-4;

/// A series and the material that it is.
pub struct PronyMaterial<'a> {
    /// Name of the file.
    pub name: &'a str,
    pub series: &'a PronySeries,
    /// Over E₀ if the modulus is not known.
    pub relaxation: &'a Relaxation,
    /// The shift factors beside it.
    pub master_curve: Option<&'a MasterCurve>,
}

impl PronyMaterial<'_> {
    /// The numbers of the material, its two spectra, and the lines for a sweep file.
    pub fn table(&self) -> String {
        let known = self.series.modulus.is_some();
        let mut text = self.master_curve.map(shifted::table).unwrap_or_default();
        text += &format!("{}, as they stand there\n", count(self.series.terms.len() as u64, "term"));
        text += &material_text::numbers(self.relaxation, known);
        let left = self.relaxation.relaxed_modulus() / self.relaxation.instantaneous_modulus();
        if left < HARDLY_SOLID {
            text += &format!(
                "note: after a long time {left:.1e} of the modulus is left, what rounding of the terms leaves perhaps: \
                 hardly a solid, and f is not known\n"
            );
        }
        text += &material_text::spectra(self.relaxation, known);
        text += &format!("\nFor a sweep file:\n\n{}", self.toml());
        text + &self.master_curve.map(shifted::law_lines).unwrap_or_default()
    }

    fn toml(&self) -> String {
        material_text::toml(self.series)
    }

    /// All numbers, and the lines for a sweep file.
    pub fn json(&self) -> String {
        let mut object = material_text::json(self.relaxation, self.series.modulus.is_some());
        object.insert("master_curve".to_owned(), self.master_curve.map_or(Value::Null, shifted::json));
        object.insert("toml".to_owned(), json!(self.toml()));
        serde_json::to_string_pretty(&object).expect("strings and numbers can be written") + "\n"
    }

    /// Storage and loss modulus over the angular frequency, from a decade below the slowest term to one above the
    /// fastest.
    pub fn chart(&self) -> Chart {
        let times = || self.relaxation.terms().iter().map(|term| term.time);
        let (slow, fast) = (0.1 / times().fold(0.0, f64::max), 10.0 / times().fold(f64::INFINITY, f64::min));
        let omega = |i: u32| slow * (fast / slow).powf(f64::from(i) / f64::from(POINTS));
        let moduli = |omega: f64| <[f64; 2]>::from(self.relaxation.storage_and_loss(omega));
        let curve = |kind: usize, label: &str| Curve {
            label: label.to_owned(),
            points: (0..=POINTS).map(|i| (omega(i), moduli(omega(i))[kind])).collect(),
            failed: Vec::new(),
            stroke: Stroke::Solid,
            colour: Colour::Kind(kind),
            mark: None,
        };
        let axis = |label: &str| LineAxis { label: label.to_owned(), logarithmic: true, range: None };
        let known = self.series.modulus.is_some();
        Chart::Lines(Lines {
            title: format!("Series of {}", printable(self.name)),
            subtitle: count(self.series.terms.len() as u64, "relaxation term"),
            x: axis("angular frequency ω  (rad/s)"),
            y: axis(if known { "modulus  (Pa)" } else { "modulus over E₀" }),
            curves: vec![curve(0, "storage E′"), curve(1, "loss E″")],
        })
    }
}
