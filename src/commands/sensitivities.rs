//! How the friction of a case changes with its parameters, for people to read.

use crate::format::{Align, table_line};
use stribeck_solver::Sensitivities;
use stribeck_sweep::store::errors_of_derivatives;
use stribeck_sweep::{Column, Values};

/// A table of dμ/d ln θ with their errors, where they are known, and of d ln μ/d ln θ, for θ = α, β and f at the
/// slide-to-roll ratio S; a dash where μ = 0.
pub fn table(
    sensitivities: &Sensitivities,
    errors: Option<&Sensitivities>,
    values: &Values,
    slide_roll: f64,
) -> String {
    let mut text = String::new();
    let columns = [Align::Left(15), Align::Right(13), Align::Right(13), Align::Right(13), Align::Left(0)];
    let mut row = |symbol: &str, [alpha, beta, f]: [String; 3], unit: &str| {
        text += &table_line(&columns, &[symbol, &alpha, &beta, &f, unit]);
    };
    row("derivative of", ["ln(alpha)", "ln(beta)", "ln(f)"].map(|over| format!("by {over}")), "unit");
    let derivatives = [
        (Column::MuV, sensitivities.viscoelastic()),
        (Column::MuH, sensitivities.hydrodynamic_at(slide_roll)),
        (Column::MuTot, sensitivities.total_at(slide_roll)),
        (Column::MuDrag, sensitivities.drag_at(slide_roll)),
        (Column::MuPressure, sensitivities.pressure),
        (Column::MuShear, sensitivities.shear()),
    ];
    let derivatives = derivatives.map(|(column, derivatives)| (column, Sensitivities::of_case(derivatives)));
    for (column, derivatives) in derivatives {
        row(column.name(), derivatives.map(|value| format!("{value:.6e}")), "a0/R");
        if let Some(errors) = errors {
            let errors = Sensitivities::of_case(errors_of_derivatives(errors, column, slide_roll));
            row("  its error", errors.map(|error| format!("{error:.0e}")), "a0/R");
        }
    }
    for (column, derivatives) in derivatives.into_iter().take(4) {
        let mu = values[column];
        let shown = |value: f64| if mu == 0.0 { "-".to_owned() } else { format!("{:.6}", value / mu) };
        row(&format!("ln({})", column.name()), derivatives.map(shown), "1");
    }
    text
}
