//! Where a search ends: at a bound, at no minimum, or told to stop.

use super::{TRUTH, exact, fitted, points, speeds, unknowns};
use stribeck_lab::{Bounds, Experiment, FrictionFit, FrictionFitError, FrictionTask, Unknown, Watch};
use stribeck_solver::{CavityShear, Interrupt, Substrate};

/// Bounds hold the search between them: a minimum inside is the same, and one outside is found at the bound.
#[test]
fn bounds_are_kept() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let measured = points(&speeds, exact(&speeds, TRUTH, &substrate), None);
    let start = Experiment { viscosity: 4.0, f: 8.0, ..TRUTH };
    let fit = |least, most| {
        let bounds = vec![Bounds { unknown: Unknown::Strength, least, most }];
        FrictionFit::new(&FrictionTask {
            measured: &measured,
            experiment: start,
            substrate: &substrate,
            roller_spectrum: &substrate,
            cavity_shear: CavityShear::Full,
            unknowns: unknowns(&["viscosity", "f"]),
            bounds,
            tolerance: 1e-7,
        })
    };
    for (least, most) in [(None, Some(100.0)), (Some(0.0), Some(100.0)), (Some(1.0), None), (Some(9.9), None)] {
        let start_is_inside = least.is_none_or(|least| least < 8.0);
        let Ok(fit) = fit(least, most) else {
            assert!(!start_is_inside);
            continue;
        };
        assert!(start_is_inside && (fit.estimates[1].value / 10.0 - 1.0).abs() < 1e-4, "{:?}", fit.estimates);
        assert!(!fit.estimates[1].at_bound && fit.estimates[1].error.is_finite());
    }
    let held = fit(Some(7.0), Some(9.0)).expect("a minimum at the bound");
    let [viscosity, strength] = held.estimates[..] else { panic!("two") };
    assert!(strength.at_bound && strength.error.is_nan() && (strength.value / 9.0 - 1.0).abs() < 1e-2, "{strength:?}");
    assert!(!viscosity.at_bound && viscosity.error > 0.0);
}

/// Friction that no f can make: the search runs after it, and says that there is no minimum.
#[test]
fn a_search_that_runs_away_is_no_fit() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let friction: Vec<f64> = exact(&speeds, TRUTH, &substrate).iter().map(|mu| 50.0 * mu).collect();
    let error = fitted(&points(&speeds, friction, None), TRUTH, &substrate, &["f"]).unwrap_err();
    assert!(matches!(error, FrictionFitError::NoMinimum { .. }), "{error}");
}

/// Told to stop before it has begun, a fit has nothing; told to stop in between, it has the best values so far, and says
/// that they are no more.
#[test]
fn a_fit_that_is_told_to_stop_says_so() {
    let (speeds, substrate) = (speeds(8, 1e-3, 0.3), Substrate::default());
    let exact = exact(&speeds, TRUTH, &substrate);
    let errors = Some(exact.iter().map(|mu| 0.01 * mu).collect());
    let measured = points(&speeds, exact, errors);
    let task = FrictionTask {
        measured: &measured,
        experiment: TRUTH,
        substrate: &substrate,
        roller_spectrum: &substrate,
        cavity_shear: CavityShear::Full,
        unknowns: unknowns(&["viscosity"]),
        bounds: Vec::new(),
        tolerance: 1e-7,
    };
    let interrupt = Interrupt::new();
    interrupt.request();
    let error = FrictionFit::watched(&task, &Watch { interrupt: &interrupt, evaluated: &|_, _| {} }).unwrap_err();
    assert_eq!(error, FrictionFitError::TimeLimit);
    let interrupt = Interrupt::new();
    let told = std::cell::RefCell::new(Vec::new());
    let evaluated = |evaluations: usize, best: &[f64]| {
        told.replace(best.to_vec());
        if evaluations == 2 {
            interrupt.request();
        }
    };
    let mut far = task.clone();
    far.experiment.viscosity *= 3.0;
    let fit = FrictionFit::watched(&far, &Watch { interrupt: &interrupt, evaluated: &evaluated }).expect("the best");
    let [viscosity] = &fit.estimates[..] else { panic!("{:?}", fit.estimates) };
    assert!(!fit.is_minimum && viscosity.error.is_nan() && viscosity.value == told.borrow()[0], "{viscosity:?}");
    assert!(fit.points.iter().all(|point| point.fitted.is_finite()) && fit.reduced_chi_squared > 1.0);
}
