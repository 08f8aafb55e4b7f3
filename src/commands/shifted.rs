//! A master curve as lines of text, as JSON and as charts.

use serde_json::{Value, json};

use crate::format::{Align, table_line};
use crate::pictures::Chart;
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_lab::{MasterCurve, Shift, ShiftLaw, ShiftLawFit, VerticalShift};

/// A temperature in degrees Celsius.
pub fn celsius(kelvins: f64) -> String {
    format!("{} degC", ((kelvins - 273.15) * 1e3).round() / 1e3 + 0.0)
}

/// Where each isotherm went, how well it lies there, and the laws that the shifts follow.
pub fn table(curve: &MasterCurve) -> String {
    let of_moduli = match curve.vertical {
        VerticalShift::None => "shifted along the rates alone".to_owned(),
        VerticalShift::Overlap => "shifted along rates and moduli; moduli at T are multiplied by b_T".to_owned(),
        VerticalShift::Density { expansion } => {
            format!("moduli at T are multiplied by b_T = rho_0 T_0/(rho T), with an expansion of {expansion}/K")
        }
    };
    let mut text = format!("master curve at {}, {of_moduli}\n", celsius(curve.reference));
    let has_levels = curve.vertical != VerticalShift::None;
    let names = ["T/degC", "log a_T", "b_T", "overlap/%"].map(str::to_owned);
    let columns = [Align::Right(8), Align::Right(10), Align::Right(8), Align::Right(12)];
    let line = |cells: [String; 4]| {
        let is_shown = |i: &usize| has_levels || *i != 2;
        let of = |i: usize| (columns[i], cells[i].as_str());
        let (columns, cells): (Vec<Align>, Vec<&str>) = (0..4).filter(is_shown).map(of).unzip();
        table_line(&columns, &cells)
    };
    text += &line(names);
    for shift in &curve.shifts {
        let residual = shift.residual.map_or_else(|| "-".to_owned(), |residual| format!("{:.2}", 100.0 * residual));
        let celsius = (10.0 * (shift.temperature - 273.15)).round() / 10.0 + 0.0;
        let level = format!("{:.4}", 10_f64.powf(shift.log_vertical));
        text += &line([
            format!("{celsius:.1}"),
            format!("{:.3}", (1e3 * shift.log_factor).round() / 1e3 + 0.0),
            level,
            residual,
        ]);
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

/// Steps of the line of a law.
const STEPS: u32 = 200;

/// log a_T over the temperature, and the laws that were fitted to it.
pub fn factor_chart(curve: &MasterCurve) -> Chart {
    let factors = curve.shifts.iter().map(|shift| (shift.temperature - 273.15, shift.log_factor)).collect();
    let temperatures = || curve.shifts.iter().map(|shift| shift.temperature);
    let (from, to) = (temperatures().fold(f64::INFINITY, f64::min), temperatures().fold(0.0, f64::max));
    let line = |law: &ShiftLaw| {
        let at = |step: u32| from + (to - from) * f64::from(step) / f64::from(STEPS);
        let point = |step: u32| Some((at(step) - 273.15, law.log_shift_factor(at(step))?));
        (0..=STEPS).filter_map(point).collect()
    };
    let laws = curve.laws.iter().enumerate().map(|(kind, fit)| {
        let label = format!("{}: {}", fit.law.name(), constants(&fit.law));
        drawn(label, line(&fit.law), (STROKES[kind], Colour::Kind(kind)))
    });
    let curves = laws.chain([drawn("found".to_owned(), factors, (Stroke::Points, Colour::Black))]);
    chart(curve, "Shift factors", "log₁₀ a_{T}", curves.collect())
}

/// What each law misses log a_T by, over the temperature.
pub fn residual_chart(curve: &MasterCurve) -> Chart {
    let laws = curve.laws.iter().enumerate().map(|(kind, fit)| {
        let miss = |shift: &Shift| {
            Some((shift.temperature - 273.15, shift.log_factor - fit.law.log_shift_factor(shift.temperature)?))
        };
        let label = format!("{}: {:.3} decades rms", fit.law.name(), fit.rms_residual);
        let points = curve.shifts.iter().filter_map(miss).collect();
        Curve { mark: Some(kind), ..drawn(label, points, (STROKES[kind], Colour::Kind(kind))) }
    });
    let ends = [curve.shifts.first(), curve.shifts.last()].into_iter().flatten();
    let zero = ends.map(|shift| (shift.temperature - 273.15, 0.0)).collect();
    let curves = laws.chain([drawn(String::new(), zero, (Stroke::Dotted, Colour::Black))]);
    chart(
        curve,
        "What the laws miss the shift factors by",
        "log₁₀ a_{T} − that of the law  (decades)",
        curves.collect(),
    )
}

/// The strokes of the laws, the better one first.
const STROKES: [Stroke; 2] = [Stroke::Solid, Stroke::Dashed];

fn drawn(label: String, points: Vec<(f64, f64)>, (stroke, colour): (Stroke, Colour)) -> Curve {
    Curve { label, points, failed: Vec::new(), stroke, colour, mark: Some(0).filter(|_| stroke == Stroke::Points) }
}

fn chart(curve: &MasterCurve, title: &str, y: &str, curves: Vec<Curve>) -> Chart {
    let axis = |label: &str| LineAxis { label: label.to_owned(), logarithmic: false, range: None };
    let subtitle = format!("a_{{T}} = 1 at {}", celsius(curve.reference));
    Chart::Lines(Lines { title: title.to_owned(), subtitle, x: axis("temperature  (°C)"), y: axis(y), curves })
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
        json!({
            "temperature": shift.temperature,
            "log_shift_factor": shift.log_factor,
            "vertical_shift_factor": 10_f64.powf(shift.log_vertical),
            "overlap": shift.residual,
        })
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
