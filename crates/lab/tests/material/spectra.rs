//! One material by its relaxation and by its creep.

use proptest::prelude::*;
use stribeck_lab::{Material, MaterialError, Relaxation, RelaxationTerm};
use stribeck_solver::{RetardationMode, Substrate};

fn relaxation(relaxed_modulus: f64, terms: &[(f64, f64)]) -> Relaxation {
    let terms = terms.iter().map(|&(modulus, time)| RelaxationTerm { modulus, time }).collect();
    Relaxation::new(relaxed_modulus, terms).expect("a material")
}

/// |a/b − 1|
fn relative(a: f64, b: f64) -> f64 {
    (a / b - 1.0).abs()
}

#[test]
fn one_term_is_the_standard_solid() {
    let material = relaxation(1e6, &[(9e6, 0.5)]).material();
    assert!(relative(material.f, 9.0) < 1e-15);
    // The retardation time is longer than the relaxation time by 1 + f.
    assert!(relative(material.retardation_time, 5.0) < 1e-15);
    assert_eq!(material.substrate, Substrate::default());
    assert!(relative(material.instantaneous_modulus(), 1e7) < 1e-15);
    assert_eq!(material.relaxed_modulus, 1e6);
}

/// A chain of two Kelvin elements of compliance 1/E each, with a spring, has the relaxation function whose transform
/// is the reciprocal: here with rates that solve a quadratic equation.
#[test]
fn two_modes_follow_from_a_quadratic_equation() {
    let modes = [(0.5, 0.5), (0.5, 1.5)].map(|(share, time)| RetardationMode { share, time });
    let material = Material {
        relaxed_modulus: 1.0,
        f: 2.0,
        retardation_time: 1.0,
        substrate: Substrate::new(modes.to_vec()).expect("a substrate"),
    };
    // 1 + 1/(1 − r/2) + 1/(1 − 3r/2) = 0 is 3r²/4 − 4r + 3 = 0.
    let rates = [(4.0 + 7_f64.sqrt()) / 1.5, (4.0 - 7_f64.sqrt()) / 1.5];
    let relaxation = material.relaxation();
    for (term, rate) in relaxation.terms().iter().zip(rates) {
        assert!(relative(term.time, 1.0 / rate) < 1e-14, "{term:?}, rate {rate}");
    }
    assert!(relative(relaxation.instantaneous_modulus(), 3.0) < 1e-14);
}

#[test]
fn terms_of_equal_times_are_one() {
    let one = relaxation(2.0, &[(5.0, 3.0), (1.0, 40.0)]).material();
    let two = relaxation(2.0, &[(2.0, 3.0), (1.0, 40.0), (3.0, 3.0)]).material();
    assert_eq!(one.substrate.modes().len(), 2);
    assert_eq!(two.substrate.modes().len(), 2);
    assert!(relative(one.retardation_time, two.retardation_time) < 1e-14);
}

#[test]
fn what_is_no_material_is_told() {
    let term = |modulus, time| RelaxationTerm { modulus, time };
    for (relaxed_modulus, terms, said) in [
        (1.0, vec![], "at least one relaxation term"),
        (0.0, vec![term(1.0, 1.0)], "is a liquid"),
        (-1.0, vec![term(1.0, 1.0)], "not -1: a material that relaxes to nothing"),
        (f64::NAN, vec![term(1.0, 1.0)], "from 1e-50 to 1e50, not NaN"),
        (1.0, vec![term(1.0, 1.0), term(0.0, 1.0)], "relaxation term 2: the modulus must be a number of pascals"),
        (1.0, vec![term(f64::INFINITY, 1.0)], "relaxation term 1: the modulus"),
        (1.0, vec![term(1.0, -2.0)], "the time must be a number of seconds from 1e-50 to 1e50, not -2"),
    ] {
        let error = Relaxation::new(relaxed_modulus, terms).expect_err("no material");
        assert!(error.to_string().contains(said), "{error}");
    }
    assert_eq!(Relaxation::new(1.0, vec![]), Err(MaterialError::Empty));
}

/// The smallest relative difference of two times.
fn least_gap(relaxation: &Relaxation) -> f64 {
    let mut times: Vec<f64> = relaxation.terms().iter().map(|term| term.time).collect();
    times.sort_by(f64::total_cmp);
    times.windows(2).map(|pair| pair[1] / pair[0] - 1.0).fold(f64::INFINITY, f64::min)
}

/// One to twelve terms with moduli and times over many decades.
fn materials() -> impl Strategy<Value = Relaxation> {
    let term = (-6.0..6.0_f64, -8.0..8.0_f64).prop_map(|(modulus, time)| (10_f64.powf(modulus), 10_f64.powf(time)));
    (prop::collection::vec(term, 1..13), -3.0..3.0_f64)
        .prop_map(|(terms, relaxed_modulus)| relaxation(10_f64.powf(relaxed_modulus), &terms))
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(400)
    })]

    #[test]
    fn both_forms_answer_alike(relaxation in materials(), exponent in -10.0..10.0_f64) {
        let material = relaxation.material();
        let omega = 10_f64.powf(exponent);
        let (storage, loss) = relaxation.storage_and_loss(omega);
        let (by_creep, lost) = material.storage_and_loss(omega);
        let size = storage.hypot(loss);
        let difference = (storage - by_creep).hypot(loss - lost);
        prop_assert!(difference < 1e-12 * size, "({storage}, {loss}), ({by_creep}, {lost})");
    }

    #[test]
    fn strengths_add_up_and_times_interlace(relaxation in materials()) {
        let material = relaxation.material();
        // E₀/E∞ − 1, without the difference.
        let f = relaxation.terms().iter().map(|term| term.modulus / relaxation.relaxed_modulus()).sum::<f64>();
        prop_assert!(relative(material.f, f) < 1e-12, "{} is not {f}", material.f);
        let shares: f64 = material.substrate.modes().iter().map(|mode| mode.share).sum();
        prop_assert!((shares - 1.0).abs() < 1e-13);
        let mean: f64 = material.substrate.modes().iter().map(|mode| mode.share * mode.time).sum();
        prop_assert!((mean - 1.0).abs() < 1e-13);
        let mut times: Vec<f64> = relaxation.terms().iter().map(|term| term.time).collect();
        times.sort_by(f64::total_cmp);
        let retardation: Vec<f64> = material.retardation().map(|(_, time)| time).collect();
        prop_assert_eq!(retardation.len(), times.len());
        for (i, time) in retardation.iter().enumerate() {
            // A weak term shifts its time by less than a double tells.
            prop_assert!(*time >= times[i] * (1.0 - 1e-15));
            prop_assert!(times.get(i + 1).is_none_or(|next| *time <= next * (1.0 + 1e-15)));
        }
    }

    /// As far as the creep form, in double precision, holds it: of two times that are next to each other, it holds the
    /// difference to rounding error only.
    #[test]
    fn there_and_back_is_the_same(relaxation in materials(), exponent in -10.0..10.0_f64) {
        let back = relaxation.material().relaxation();
        let held = 1e-12 + 1e-15 / least_gap(&relaxation);
        prop_assert!(relative(back.instantaneous_modulus(), relaxation.instantaneous_modulus()) < held);
        let omega = 10_f64.powf(exponent);
        let ((storage, loss), (stored, lost)) = (relaxation.storage_and_loss(omega), back.storage_and_loss(omega));
        prop_assert!((storage - stored).hypot(loss - lost) < held * storage.hypot(loss));
    }

    /// The unit of the moduli and that of the times mean nothing.
    #[test]
    fn units_scale(relaxation in materials()) {
        let terms = relaxation.terms().iter().map(|term| (term.modulus * 1024.0, term.time / 64.0)).collect::<Vec<_>>();
        let scaled = self::relaxation(relaxation.relaxed_modulus() * 1024.0, &terms).material();
        let material = relaxation.material();
        prop_assert!(relative(scaled.f, material.f) < 1e-13);
        prop_assert!(relative(scaled.retardation_time * 64.0, material.retardation_time) < 1e-12);
    }

    /// Whatever moduli and times are allowed.
    #[test]
    fn no_magnitude_breaks_it(
        terms in prop::collection::vec((-50.0..=50.0_f64, -50.0..=50.0_f64), 1..8),
        relaxed_modulus in -50.0..=50.0_f64,
    ) {
        let power = |exponent: f64| 10_f64.powf(exponent).clamp(1e-50, 1e50);
        let terms: Vec<_> = terms.iter().map(|&(modulus, time)| (power(modulus), power(time))).collect();
        let relaxation = relaxation(power(relaxed_modulus), &terms);
        let back = relaxation.material().relaxation();
        prop_assert!(relative(back.instantaneous_modulus(), relaxation.instantaneous_modulus()) < 1e-12);
    }
}
