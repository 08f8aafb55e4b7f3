//! How the friction of a case changes with its parameters, for people to read.

use crate::format::{Align, table_line};
use stribeck_solver::Sensitivities;

/// A table of dμ/d ln θ and d ln μ/d ln θ for θ = α, β and f; a dash where μ = 0.
pub fn table(sensitivities: &Sensitivities, mu_v: f64, mu_h: f64) -> String {
    let mut text = String::new();
    let columns = [Align::Left(13), Align::Right(13), Align::Right(13), Align::Right(13), Align::Left(0)];
    let mut row = |symbol: &str, [alpha, beta, f]: [String; 3], unit: &str| {
        text += &table_line(&columns, &[symbol, &alpha, &beta, &f, unit]);
    };
    row("derivative of", ["ln(alpha)", "ln(beta)", "ln(f)"].map(|over| format!("by {over}")), "unit");
    let Sensitivities { viscoelastic, hydrodynamic } = *sensitivities;
    let absolute = [("mu_v", viscoelastic), ("mu_h", hydrodynamic), ("mu_tot", sensitivities.total())];
    for (symbol, values) in absolute {
        row(symbol, values.map(|value| format!("{value:.6e}")), "a0/R");
    }
    let shown = |value: f64| if value.is_nan() { "-".to_owned() } else { format!("{value:.6}") };
    let relative = sensitivities.logarithmic(mu_v, mu_h);
    for (symbol, values) in ["ln(mu_v)", "ln(mu_h)", "ln(mu_tot)"].into_iter().zip(relative) {
        row(symbol, values.map(shown), "1");
    }
    text
}
