//! How many terms a fit needs, and what it does not tell.

use super::{decay, oscillation, rubber, solid};
use stribeck_lab::{Doubt, Measurement, Measurements, RelaxationFit, RelaxationFitError, TermChoice};

fn measurements(rows: Vec<Measurement>) -> Measurements {
    Measurements::new(rows).expect("many rates")
}

/// Loss and storage of a fractional Maxwell liquid, E* = E (iωτ)^a / (1 + (iωτ)^a), for a near 1.
fn liquid(exponent: f64, from: i32, to: i32) -> Measurements {
    let (modulus, time) = (2e4, 0.1);
    measurements(
        super::decades(from, to)
            .map(|omega| {
                let size = (omega * time).powf(exponent);
                let (real, imaginary) = (exponent * std::f64::consts::FRAC_PI_2).sin_cos();
                let (stored, lost) = (size * imaginary, size * real);
                let below = (1.0 + stored).powi(2) + lost * lost;
                let storage = modulus * (stored * (1.0 + stored) + lost * lost) / below;
                Measurement::Oscillation { omega, storage, loss: modulus * lost / below }
            })
            .collect(),
    )
}

/// With noise of a per cent that no spectrum follows, the number of terms stops growing with what is offered.
#[test]
fn as_many_terms_are_chosen_as_the_residuals_ask_for() {
    let noisy = |rows: Vec<Measurement>, size: f64| {
        let wave = |i: usize| 1.0 + size * (12.9898 * (i * i) as f64).sin();
        measurements(rows.into_iter().enumerate().map(|(i, row)| row.stiffer(wave(i))).collect())
    };
    let rows = || oscillation(&rubber(), -3, 6);
    let clean = TermChoice::new(&measurements(rows())).expect("a fit");
    assert!(clean.is_good_enough() && clean.fit.rms_residual <= TermChoice::GOOD_ENOUGH, "{clean:?}");
    let rough = TermChoice::new(&noisy(rows(), 0.01)).expect("a fit");
    assert!(!rough.is_good_enough() && rough.offered <= clean.offered, "{} {}", rough.offered, clean.offered);
    for choice in [&clean, &rough] {
        assert!(choice.offered <= choice.most && choice.least_at <= choice.most);
        assert!(choice.fit.rms_residual >= choice.least_residual);
    }
    assert!(rough.fit.rms_residual <= 1.1 * rough.least_residual);
    // one fewer is worse than that
    let fewer = RelaxationFit::new(&noisy(rows(), 0.01), rough.offered - 1).expect("a fit");
    assert!(fewer.rms_residual > 1.1 * rough.least_residual);
}

#[test]
fn a_choice_has_a_reason_where_there_is_no_material() {
    let flat = |omega| Measurement::Oscillation { omega, storage: 100.0, loss: 0.0 };
    let elastic = measurements(vec![flat(1.0), flat(10.0), flat(100.0)]);
    assert_eq!(TermChoice::new(&elastic), Err(RelaxationFitError::Elastic));
}

/// Of what flows no relaxed modulus is told without a word, whatever the number of terms.
#[test]
fn a_liquid_is_doubted_at_each_number_of_terms() {
    for exponent in [0.8, 0.9, 1.0] {
        let liquid = liquid(exponent, 0, 3);
        for terms in 1..=20 {
            match RelaxationFit::new(&liquid, terms) {
                Ok(fit) => match Doubt::about(&fit.relaxation, &liquid) {
                    Some(Doubt::Flows { omega, ratio }) => assert!(omega == 1.0 && ratio > 1.0),
                    doubt => panic!("{exponent}, {terms} terms: {doubt:?}"),
                },
                Err(error) => assert_eq!(error, RelaxationFitError::Liquid, "{exponent}, {terms} terms"),
            }
        }
    }
}

/// A solid that was measured down to its plateau is not doubted; one that was not is.
#[test]
fn a_plateau_that_was_not_reached_is_told() {
    let doubt = |rows: Vec<Measurement>| {
        let measured = measurements(rows);
        let fit = RelaxationFit::new(&measured, 9).expect("a fit");
        Doubt::about(&fit.relaxation, &measured)
    };
    assert_eq!(doubt(oscillation(&rubber(), -4, 6)), None);
    assert_eq!(doubt(decay(&rubber(), -6, 4)), None);
    // the slowest term is slower than what was measured
    let slow = solid(1e5, &[(1e7, 1e-2), (2e6, 1.0), (9e5, 30.0)]);
    for (rows, modulus, remedy) in [
        (oscillation(&slow, -1, 3), "the storage modulus still falls by", "lower frequencies"),
        (decay(&slow, -3, 1), "the relaxation modulus still falls by", "longer times"),
        // almost all of the modulus is gone at the end
        (oscillation(&solid(1e5, &[(1e7, 1e-2), (2e6, 1.0)]), 0, 3), "lowest storage modulus", "lower frequencies"),
        (decay(&solid(1e5, &[(1e7, 1e-2), (2e6, 1.0)]), -3, 0), "lowest relaxation modulus", "longer times"),
    ] {
        let said = doubt(rows).expect("a doubt").to_string();
        assert!(said.contains(modulus) && said.contains(remedy), "{said}");
    }
}
