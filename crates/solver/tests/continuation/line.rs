//! Straight lines in (ln α, ln β, ln(1+f)).

use proptest::prelude::*;
use stribeck_solver::continuation::{Line, NoLine, distance, secant};
use stribeck_solver::{Parameters, RetardationMode, Substrate};

fn case() -> impl Strategy<Value = Parameters> {
    let decades = -6.0..6.0_f64;
    let f = prop_oneof![Just(0.0), (-6.0..6.0_f64).prop_map(|decades| 10_f64.powf(decades))];
    (decades.clone(), decades, f).prop_map(|(alpha, beta, f)| Parameters::new(10_f64.powf(alpha), 10_f64.powf(beta), f))
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::default()
    })]

    #[test]
    fn both_ends_are_the_cases_bit_for_bit(from in case(), to in case()) {
        let line = Line::new(&from, &to).unwrap();
        prop_assert_eq!(&line.at(0.0), &from);
        prop_assert_eq!(&line.at(1.0), &to);
    }

    /// Distances along a line are parts of its length, from either end.
    #[test]
    fn a_line_is_straight_and_even(from in case(), to in case(), t in 0.0..1.0_f64) {
        let line = Line::new(&from, &to).unwrap();
        let here = line.at(t);
        let rounding = 1e-13 * (1.0 + line.length()) + 1e-9 * f64::from(from.f != to.f);
        prop_assert!((distance(&from, &here) - t * line.length()).abs() <= rounding);
        prop_assert!((distance(&here, &to) - (1.0 - t) * line.length()).abs() <= rounding);
        let back = Line::new(&to, &from).unwrap().at(1.0 - t);
        prop_assert!(distance(&here, &back) <= rounding);
    }

    #[test]
    fn what_the_ends_have_in_common_stays(from in case(), to in case(), t in 0.0..1.0_f64) {
        let extremes = [(0.0, 0.0), (f64::INFINITY, 0.0), (0.0, from.f), (f64::INFINITY, from.f), (from.alpha, 0.0)];
        for (alpha, f) in extremes.into_iter().chain([(from.alpha, from.f)]) {
            let [from, to] = [&from, &to].map(|end| Parameters { alpha, f, ..end.clone() });
            let here = Line::new(&from, &to).unwrap().at(t);
            prop_assert_eq!((here.alpha, here.f), (alpha, f));
            prop_assert!(here.beta >= from.beta.min(to.beta) * (1.0 - 1e-14));
            prop_assert!(here.beta <= from.beta.max(to.beta) * (1.0 + 1e-14));
        }
        let to = Parameters { beta: from.beta, ..to };
        prop_assert_eq!(Line::new(&from, &to).unwrap().at(t).beta, from.beta);
    }

    /// Whatever is linear in the logarithms is extrapolated exactly.
    #[test]
    fn the_secant_is_exact_on_its_line(from in case(), to in case(), part in 0.1..0.9_f64) {
        prop_assume!(distance(&from, &to) > 0.1);
        let near = Line::new(&from, &to).unwrap().at(part);
        let t = secant(&from, &near, &to);
        prop_assert!((t * part / (1.0 - part) - 1.0).abs() < 1e-6, "{}", t);
    }

    #[test]
    fn distance_is_a_distance(a in case(), b in case(), c in case()) {
        prop_assert_eq!(distance(&a, &a), 0.0);
        prop_assert_eq!(distance(&a, &b), distance(&b, &a));
        prop_assert!(distance(&a, &c) <= distance(&a, &b) + distance(&b, &c) + 1e-12);
    }
}

#[test]
fn steps_are_factors() {
    let (from, to) = (Parameters::new(0.01, 1.0, 3.0), Parameters::new(100.0, 10.0, 15.0));
    let half = Line::new(&from, &to).unwrap().at(0.5);
    assert!((half.alpha - 1.0).abs() < 1e-14 && (half.beta - 10_f64.sqrt()).abs() < 1e-14);
    assert!((half.f - 7.0).abs() < 1e-13, "1 + f goes from 4 by way of 8 to 16");
    assert!((distance(&from, &to) - 1e4_f64.ln()).abs() < 1e-14, "α has the longest way");
}

#[test]
fn nothing_is_extrapolated_from_one_place() {
    let (here, there) = (Parameters::new(1.0, 10.0, 1.0), Parameters::new(1.0, 20.0, 1.0));
    assert_eq!(secant(&here, &here, &there), 0.0);
    assert_eq!(secant(&Parameters::new(0.0, 10.0, 1.0), &here, &there), 0.0);
}

#[test]
fn the_elastic_limits_of_alpha_are_at_no_finite_distance() {
    for (from, to) in [(0.0, 1.0), (1.0, 0.0), (f64::INFINITY, 1.0), (1.0, f64::INFINITY), (0.0, f64::INFINITY)] {
        let cases = [from, to].map(|alpha| Parameters::new(alpha, 10.0, 1.0));
        assert_eq!(Line::new(&cases[0], &cases[1]), Err(NoLine::Alpha { from, to }));
        assert_eq!(distance(&cases[0], &cases[1]), f64::INFINITY);
    }
}

#[test]
fn no_line_changes_the_substrate() {
    let one = Parameters::new(1.0, 10.0, 1.0);
    let modes = [1.0, 5.0].map(|time| RetardationMode { share: 0.5, time });
    let two = Parameters { substrate: Substrate::new(modes.to_vec()).unwrap(), ..one.clone() };
    let reason = Line::new(&one, &two).unwrap_err();
    assert!(matches!(reason, NoLine::Substrates { .. }) && reason.to_string().contains("retardation modes"));
}
