//! A master curve as lines of text and as JSON.

use serde_json::{Value, json};

use crate::format::{Align, table_line};
use stribeck_lab::{MasterCurve, ShiftLaw, ShiftLawFit};

/// A temperature in degrees Celsius.
pub fn celsius(kelvins: f64) -> String {
    format!("{} degC", ((kelvins - 273.15) * 1e3).round() / 1e3 + 0.0)
}

/// Where each isotherm went, how well it lies there, and the laws that the shifts follow.
pub fn table(curve: &MasterCurve) -> String {
    let mut text = format!("master curve at {}, shifted along the rates alone\n", celsius(curve.reference));
    let columns = [Align::Right(8), Align::Right(10), Align::Right(12)];
    text += "  T/degC    log a_T    overlap/%\n";
    for shift in &curve.shifts {
        let residual = shift.residual.map_or_else(|| "-".to_owned(), |residual| format!("{:.2}", 100.0 * residual));
        let celsius = (10.0 * (shift.temperature - 273.15)).round() / 10.0 + 0.0;
        let cells = [format!("{celsius:.1}"), format!("{:.3}", shift.log_factor), residual];
        text += &table_line(&columns, &cells);
    }
    for fit in &curve.laws {
        text += &format!(
            "{}: {}, residual {:.3} decades rms, {:.3} largest\n",
            fit.law.name(),
            constants(&fit.law),
            fit.rms_residual,
            fit.largest_residual
        );
    }
    text + "\n"
}

/// A residual of a law, in decades, that is worth a word: times are wrong by a factor of 2.
const FAR: f64 = 0.3;

/// The better law as a line for a sweep file; nothing where no law was found.
pub fn law_lines(curve: &MasterCurve) -> String {
    let Some(fit) = curve.laws.first() else { return String::new() };
    let far = if fit.rms_residual > FAR {
        format!(
            "note: no law follows these shift factors: this one misses them by {:.2} decades rms; fit one to fewer \
             temperatures, those of the experiment\n\n",
            fit.rms_residual
        )
    } else {
        String::new()
    };
    format!("\nFor the same section, beside a temperature in [laboratory]:\n\n{far}shift = {}\n", fit.law.toml())
}

fn constants(law: &ShiftLaw) -> String {
    match law {
        ShiftLaw::Wlf { c1, c2, .. } => format!("c1 = {c1:.3}, c2 = {c2:.2} K"),
        ShiftLaw::Arrhenius { activation_energy, .. } => format!("{:.2} kJ/mol", activation_energy / 1e3),
    }
}

/// The same for programs; temperatures in K.
pub fn json(curve: &MasterCurve) -> Value {
    let shifts = curve.shifts.iter().map(|shift| {
        json!({ "temperature": shift.temperature, "log_shift_factor": shift.log_factor, "overlap": shift.residual })
    });
    let law = |fit: &ShiftLawFit| {
        json!({
            "toml": fit.law.toml(),
            "rms_residual": fit.rms_residual,
            "largest_residual": fit.largest_residual,
        })
    };
    json!({
        "reference": curve.reference,
        "shifts": shifts.collect::<Vec<_>>(),
        "laws": curve.laws.iter().map(law).collect::<Vec<_>>(),
    })
}
