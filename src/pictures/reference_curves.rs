//! What is known beside a solution: limits and approximations of the same quantity.

use std::f64::consts::{FRAC_PI_2, PI};

use stribeck_charts::Stroke;
use stribeck_solver::Parameters;
use stribeck_solver::exact::{DryContact, LargeBeta, approx_elastic_film, fitted_c};
use stribeck_sweep::{Column, Field};

/// A curve that is known without solving anything.
#[derive(Clone, Copy)]
pub struct ReferenceCurve {
    /// Name in the legend.
    pub label: &'static str,
    /// How it is drawn.
    pub stroke: Stroke,
    /// Where its values come from.
    pub values: Values,
}

/// Where known values come from.
#[derive(Clone, Copy)]
pub enum Values {
    /// The sum of columns of the data set, where the case is one for them.
    Columns(&'static [Column]),
    /// A formula; `None` where it does not hold.
    Formula(fn(&Parameters) -> Option<f64>),
}

impl ReferenceCurve {
    /// True if its columns mean something for a case.
    pub fn holds(&self, case: &Parameters) -> bool {
        let is_approximate = matches!(self.values, Values::Columns(columns) if columns.contains(&Column::ApproxMuH));
        !is_approximate || is_large_beta(case)
    }
}

/// True where the large-β approximation is one: its c (Eq. 49) differs by less than a fifth from the formula for c
/// (T34), which holds for any β. The windows are those of `docs/explanation/approximations.md`.
pub fn is_large_beta(case: &Parameters) -> bool {
    const NEAR: f64 = 0.2;
    let formula = Some(case).filter(|case| case.beta.is_finite() && case.f.is_finite()).and_then(fitted_c);
    let approximation = LargeBeta::new(case).zip(formula);
    approximation.is_some_and(|(approximation, c)| (approximation.approx_c() / c - 1.0).abs() < NEAR)
}

/// c of the elastic film for β → ∞ ((T35) of `docs/explanation/theory.md`), with the modulus that counts.
fn elastic_asymptote(case: &Parameters) -> Option<f64> {
    let compliance = if case.f == 0.0 || case.alpha == f64::INFINITY {
        1.0
    } else if case.alpha == 0.0 {
        1.0 / (1.0 + case.f)
    } else {
        return None;
    };
    Some(compliance * 0.44583 * (compliance * case.beta).powf(-0.6))
}

/// What is known of a column.
pub fn of_column(column: Column) -> &'static [ReferenceCurve] {
    const DRY: &str = "dry limit";
    match column {
        Column::MuV => {
            &[ReferenceCurve { label: DRY, stroke: Stroke::Dashed, values: Values::Columns(&[Column::DryMuV]) }]
        }
        Column::MuH => &[ReferenceCurve {
            label: "large-β approximation",
            stroke: Stroke::Dashed,
            values: Values::Columns(&[Column::ApproxMuH]),
        }],
        Column::MuTot => &[ReferenceCurve {
            label: "dry limit of μᵥ + approximation of μₕ",
            stroke: Stroke::Dashed,
            values: Values::Columns(&[Column::DryMuV, Column::ApproxMuH]),
        }],
        Column::C => &[
            ReferenceCurve {
                label: "Eqs. 34 and 49 of the paper",
                stroke: Stroke::Dashed,
                values: Values::Formula(|case| Some(LargeBeta::new(case)?.approx_c())),
            },
            ReferenceCurve {
                label: "0.4458 β^(−3/5)",
                stroke: Stroke::Dotted,
                values: Values::Formula(elastic_asymptote),
            },
        ],
        Column::PMax => &[ReferenceCurve {
            label: DRY,
            stroke: Stroke::Dashed,
            values: Values::Formula(|case| Some(DryContact::of(case)?.max_pressure())),
        }],
        Column::XOutlet => &[ReferenceCurve {
            label: DRY,
            stroke: Stroke::Dashed,
            values: Values::Formula(|case| Some(DryContact::of(case)?.trailing_edge())),
        }],
        _ => &[],
    }
}

/// What is known of a field in the contact: its name, and (x, value) on points of its own.
pub fn of_field(field: Field, case: &Parameters) -> Option<(&'static str, Vec<(f64, f64)>)> {
    match field {
        Field::Pressure => {
            let (x, pressure) = dry_pressure(&DryContact::of(case)?);
            Some(("dry limit", x.into_iter().zip(pressure).collect()))
        }
        Field::FilmThickness if !is_large_beta(case) => None,
        Field::FilmThickness if case.f == 0.0 => {
            let x = contact_points(&DryContact::of(case)?);
            let film = |x: f64| (x, approx_elastic_film(case.beta, x));
            Some(("Eq. 36 of the paper", x.into_iter().map(film).collect()))
        }
        Field::FilmThickness => {
            let approximation = LargeBeta::new(case)?;
            let film = |x: f64| Some((x, approximation.approx_film(x)?));
            let x = contact_points(approximation.contact());
            Some(("large-β approximation", x.into_iter().filter_map(film).collect()))
        }
        // In the contact the surface follows the cylinder: w′ = x.
        Field::HysteresisTraction => {
            let (x, pressure) = dry_pressure(&DryContact::of(case)?);
            Some(("dry limit", x.into_iter().zip(pressure).map(|(x, p)| (x, p * x / FRAC_PI_2)).collect()))
        }
        Field::Displacement | Field::ShearTraction => None,
    }
}

/// The pressure of a dry contact on points of its own.
pub fn dry_pressure(contact: &DryContact) -> (Vec<f64>, Vec<f64>) {
    let x = contact_points(contact);
    let pressure = contact.pressure_on(&x);
    (x, pressure)
}

/// Ascending x over a dry contact, its edges included: dense at both edges, and down to a millionth of the contact at
/// the leading one, where the pressure of a retarded substrate has a peak in a layer as narrow as 1/((1+f)α).
fn contact_points(contact: &DryContact) -> Vec<f64> {
    const EVEN: usize = 240;
    const LAYER: usize = 120;
    let ahead = |share: f64| contact.leading_edge() - 2.0 * contact.half_width() * share;
    let even = (0..=EVEN).map(|i| 0.5 * (1.0 - (PI * i as f64 / EVEN as f64).cos()));
    let layer = (0..LAYER).map(|i| 10_f64.powf(-6.0 + 5.0 * i as f64 / LAYER as f64));
    let mut x: Vec<f64> = even.chain(layer).map(ahead).collect();
    x.sort_by(f64::total_cmp);
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck_solver::Substrate;

    /// Rows of the tables of `docs/explanation/approximations.md`: where c is good to 20 %.
    #[test]
    fn the_approximation_is_one_where_beta_is_large() {
        for (f, alpha, from, to) in [
            (0.0, 1.0, 16.0, 1.4e4),
            (100.0, 1e-3, 4.5e4, 2e6),
            (100.0, 0.1, 3200.0, 6.3e4),
            (100.0, 1.0, 250.0, 710.0),
            (100.0, 1000.0, 16.0, 1.3e4),
        ] {
            let at = |beta: f64| is_large_beta(&Parameters { alpha, beta, f, substrate: Substrate::default() });
            assert!(at(1.4 * from) && at(to / 1.4), "f = {f}, α = {alpha}");
            assert!(!at(from / 1.6) && !at(1.6 * to), "f = {f}, α = {alpha}");
        }
    }
}
