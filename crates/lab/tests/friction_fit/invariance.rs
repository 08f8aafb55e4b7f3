//! What changes no fit: units, the order of points, a common factor of their errors.

use super::{Noise, TRUTH, exact, fitted, points, speeds};
use stribeck_lab::{Experiment, FrictionFit};
use stribeck_solver::Substrate;

/// A fit in other units, of points in another order, is the same fit.
#[test]
fn order_and_units_do_not_matter() {
    let (speeds, substrate) = (speeds(12, 1e-3, 0.3), Substrate::default());
    let mut noise = Noise(7);
    let friction: Vec<f64> =
        exact(&speeds, TRUTH, &substrate).iter().map(|mu| mu * (1.0 + 0.01 * noise.normal())).collect();
    let names = ["viscosity", "retardation_time"];
    let one = fitted(&points(&speeds, friction.clone(), None), TRUTH, &substrate, &names).unwrap();
    let reversed = |values: &[f64]| values.iter().rev().copied().collect::<Vec<f64>>();
    let other = fitted(&points(&reversed(&speeds), reversed(&friction), None), TRUTH, &substrate, &names).unwrap();
    // All lengths ten times, all times three times: the same α, β and a₀/R.
    let (length, time) = (10.0, 3.0);
    let scaled = Experiment {
        radius: TRUTH.radius * length,
        load: TRUTH.load * length,
        viscosity: TRUTH.viscosity * time,
        retardation_time: TRUTH.retardation_time * time,
        ..TRUTH
    };
    let faster: Vec<f64> = speeds.iter().map(|speed| speed * length / time).collect();
    let third = fitted(&points(&faster, friction, None), scaled, &substrate, &names).unwrap();
    for i in 0..2 {
        let relative = |fit: &FrictionFit, unit: f64| (fit.estimates[i].value / unit, fit.estimates[i].error / unit);
        let (value, error) = relative(&one, 1.0);
        for (other_value, other_error) in [relative(&other, 1.0), relative(&third, time)] {
            assert!((other_value / value - 1.0).abs() < 1e-5 && (other_error / error - 1.0).abs() < 1e-3);
        }
    }
}

/// A common factor of all standard errors changes no minimum, however small the errors are.
#[test]
fn a_common_factor_of_errors_changes_no_minimum() {
    let speeds = speeds(6, 1e-3, 0.3);
    let mut noise = Noise(11);
    let friction: Vec<f64> =
        exact(&speeds, TRUTH, &Substrate::default()).iter().map(|mu| mu * (1.0 + 0.05 * noise.normal())).collect();
    let start = Experiment { viscosity: 1.0, ..TRUTH };
    let fit = |factor: f64| {
        let errors = Some(friction.iter().map(|mu| factor * mu).collect());
        let fit =
            fitted(&points(&speeds, friction.clone(), errors), start, &Substrate::default(), &["viscosity"]).unwrap();
        (fit.estimates[0].value, fit.estimates[0].error / factor)
    };
    let (value, error) = fit(0.05);
    for factor in [1e-6, 1e-10, 1e-100] {
        let (other, other_error) = fit(factor);
        assert!((other / value - 1.0).abs() < 1e-5 && (other_error / error - 1.0).abs() < 1e-3, "{factor}: {other}");
    }
}
