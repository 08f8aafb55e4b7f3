//! Dry sliding with several retardation times.

use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;
use stribeck_solver::exact::{ChainLimits, DryContact, DrySliding, contact_bounds, limits};
use stribeck_solver::kernel::retarded_log_integral;
use stribeck_solver::{Parameters, Retardation, RetardationMode, Substrate};

/// A case with these modes: strengths f_j and rates α_j.
fn case(modes: &[(f64, f64)]) -> Parameters {
    let f: f64 = modes.iter().map(|mode| mode.0).sum();
    let mode = |&(strength, rate): &(f64, f64)| RetardationMode { share: strength / f, time: 1.0 / rate };
    let substrate = Substrate::new(modes.iter().map(mode).collect()).expect("shares add up to 1");
    Parameters { substrate, ..Parameters::new(1.0, 100.0, f) }
}

fn sliding(modes: &[(f64, f64)]) -> DrySliding {
    DrySliding::of(&case(modes))
}

/// Half width, centre and friction.
fn numbers(contact: &DrySliding) -> [f64; 3] {
    [contact.half_width(), contact.centre(), contact.friction()]
}

/// The same of the closed form.
fn closed_form(alpha: f64, f: f64) -> [f64; 3] {
    let contact = DryContact::new(alpha, f);
    [contact.half_width(), contact.centre(), contact.friction()]
}

/// The largest relative difference of three numbers.
fn difference(found: [f64; 3], exact: [f64; 3]) -> f64 {
    let pairs = found.into_iter().zip(exact);
    pairs
        .map(|(a, b)| if a == b { 0.0 } else { (a / b - 1.0).abs() })
        .fold(0.0, |a, b| if b.is_nan() { b } else { a.max(b) })
}

#[test]
fn width_centre_and_friction_keep_fourteen_digits() {
    let table = include_str!("../reference/dry_modes.csv");
    let mut rows = 0;
    for line in table.lines().skip(1) {
        let columns: Vec<&str> = line.split(',').collect();
        let list = |text: &str| text.split(' ').map(|number| number.parse().unwrap()).collect::<Vec<f64>>();
        let modes: Vec<(f64, f64)> = list(columns[0]).into_iter().zip(list(columns[1])).collect();
        let exact = [2, 3, 4].map(|column| columns[column].parse().unwrap());
        let found = numbers(&sliding(&modes));
        let error = difference(found, exact);
        assert!(error < 1e-14, "{modes:?}: {found:?} is not {exact:?}, {error:.1e}");
        rows += 1;
    }
    assert!(rows >= 45);
}

#[test]
fn one_mode_is_the_closed_form() {
    for i in -12..=12 {
        for j in -6..=12 {
            let (alpha, f) = (10_f64.powf(f64::from(i) / 2.0), 10_f64.powf(f64::from(j) / 2.0));
            let exact = closed_form(alpha, f);
            let error = difference(numbers(&DrySliding::of(&Parameters::new(alpha, 1.0, f))), exact);
            assert!(error < 1e-11, "alpha={alpha}, f={f}: {error:.1e}");
            for parts in [&[0.5, 0.5][..], &[0.1, 0.2, 0.7]] {
                let equal: Vec<_> = parts.iter().map(|part| (part * f, alpha)).collect();
                let error = difference(numbers(&sliding(&equal)), exact);
                assert!(error < 1e-11, "alpha={alpha}, f={f} in {parts:?}: {error:.1e}");
            }
        }
    }
}

/// What tends to one mode does so in proportion to what is left of the way.
fn tends_to(what: &str, exact: [f64; 3], left: [f64; 3], at: impl Fn(f64) -> DrySliding) {
    let errors = left.map(|left| difference(numbers(&at(left)), exact));
    assert!(errors[0] < 0.3 && errors[2] < 1e-5, "{what}: {errors:?}");
    for pair in errors.windows(2) {
        assert!(pair[1] < 0.2 * pair[0] || pair[1] < 1e-13, "{what}: {errors:?}");
    }
}

#[test]
fn a_mode_without_strength_is_none() {
    for (alpha, f, other) in [(1.0, 10.0, 30.0), (0.01, 1e3, 1.0), (1e3, 0.1, 1e-3), (1.0, 1e5, 1.000_001)] {
        let part = |left: f64| sliding(&[(f * (1.0 - left), alpha), (f * left, other)]);
        tends_to("share", closed_form(alpha, f), [1e-3, 1e-5, 1e-7].map(|left| left / (1.0 + f)), part);
        let nothing = difference(numbers(&part(1e-200)), closed_form(alpha, f));
        assert!(nothing < 1e-11, "alpha={alpha}, f={f}: {nothing:.1e}");
    }
}

/// Also where others make its place in the spectrum smaller than a double.
#[test]
fn a_mode_of_next_to_no_strength_is_none_beside_any_others() {
    let others = [(1e45, 1e59), (1.0, 1e-50)];
    let with = sliding(&[others[0], others[1], (1e-194, 1e-55)]);
    assert_eq!(numbers(&with), numbers(&sliding(&others)));
}

/// A mode that is always relaxed lowers the modulus at once: E₀/(1+f₂) in place of E₀, so that f₁/(1+f₂) is left of f₁.
#[test]
fn a_fast_mode_is_a_lower_modulus_at_once() {
    for (alpha, f, fast) in [(1.0, 10.0, 3.0), (0.01, 1e3, 1.0), (30.0, 0.1, 1.0), (1.0, 1.0, 100.0)] {
        let exact = closed_form(alpha, f / (1.0 + fast));
        tends_to("fast", exact, [1e-5, 1e-7, 1e-9], |left| sliding(&[(f, alpha), (fast, alpha / left)]));
    }
}

/// A mode that never creeps leaves the relaxed modulus at E₀/(1+f₁): larger than E∞ by r = (1+f₁+f₂)/(1+f₁), so that
/// the contact length is a₀/√r, and α = a₀/(Vτ) and all lengths with it.
#[test]
fn a_slow_mode_is_a_higher_relaxed_modulus() {
    for (alpha, f, slow) in [(1.0, 10.0, 3.0), (0.1, 1e2, 1.0), (30.0, 1.0, 1.0), (1.0, 1.0, 10.0)] {
        let length = ((1.0_f64 + f) / (1.0 + f + slow)).sqrt();
        let exact = closed_form(alpha * length, f).map(|number| number * length);
        tends_to("slow", exact, [1e-6, 1e-8, 1e-10], |left| sliding(&[(f, alpha), (slow, alpha * left)]));
    }
}

#[test]
fn elastic_limits_are_hertz() {
    let modes = [(0.25, 1.0), (0.75, 30.0)].map(|(share, time)| RetardationMode { share, time });
    let substrate = Substrate::new(modes.to_vec()).unwrap();
    for (alpha, f, half_width) in [(0.0, 3.0, 0.5), (f64::INFINITY, 3.0, 1.0), (2.0, 0.0, 1.0)] {
        let contact = DrySliding::of(&Parameters { substrate: substrate.clone(), ..Parameters::new(alpha, 1.0, f) });
        assert_eq!(numbers(&contact), [half_width, 0.0, 0.0]);
        assert_eq!((contact.trailing_edge(), contact.leading_edge()), (-half_width, half_width));
    }
    for (alpha, half_width) in [(1e-200, 0.5), (1e-14, 0.5), (1e22, 1.0), (1e200, 1.0)] {
        let contact = DrySliding::of(&Parameters { substrate: substrate.clone(), ..Parameters::new(alpha, 1.0, 3.0) });
        assert!((contact.half_width() - half_width).abs() < 1e-11, "alpha={alpha}: {contact:?}");
        assert!(contact.friction().abs() < 1e-11 && contact.centre().abs() < 1e-11, "alpha={alpha}: {contact:?}");
    }
}

/// The slope at x for a pressure that is 1 at the middle one of three places and 0 at the others, piecewise linear:
/// (T10) with the antiderivatives of (T11), apart from the solution.
fn slope_of_hat(modes: &[Retardation], compliance: f64, hat: [f64; 3], x: f64) -> f64 {
    let integral = |z: f64| {
        let part = |mode: &Retardation| mode.strength / mode.rate * retarded_log_integral(mode.rate * z);
        z * z.abs().ln() - z + compliance * modes.iter().map(part).sum::<f64>()
    };
    let [left, middle, right] = hat;
    let (rise, fall) = (1.0 / (middle - left), 1.0 / (right - middle));
    (rise * (integral(x - left) - integral(x - middle)) - fall * (integral(x - middle) - integral(x - right))) / PI
}

/// The solution of a linear system, of whose rows each ends with its right side: by elimination with pivots.
fn by_elimination(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs())).expect("a row");
        rows.swap(k, pivot);
        let (above, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] / above[k][k];
            row[k..].iter_mut().zip(&above[k][k..]).for_each(|(to, from)| *to -= factor * from);
        }
    }
    let mut solution = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * solution[j]).sum();
        solution[k] = (rows[k][n] - known) / rows[k][k];
    }
    solution
}

/// In the contact w′ = x. For a half width, that is a linear system for the pressure, zero at both ends, and the
/// centre; the load must then come out as π/2 and the moment as the friction.
#[test]
fn the_surface_follows_the_cylinder() {
    for modes in [
        &[(1.0, 1.0), (1.0, 0.1)][..],
        &[(5.0, 3.0), (20.0, 0.3)],
        &[(0.5, 10.0), (3.0, 1.0), (10.0, 0.03)],
        &[(100.0, 0.02), (1.0, 2.0)],
        &[(2.0, 30.0), (2.0, 3.0), (2.0, 0.3), (2.0, 0.03)],
    ] {
        let case = case(modes);
        let contact = DrySliding::of(&case);
        let (retardation, compliance) = (case.retardation(), case.instantaneous_compliance());
        let cells = 500;
        let place = |i: usize| -contact.half_width() * (PI * i as f64 / cells as f64).cos();
        let middle = |i: usize| 0.5 * (place(i) + place(i + 1));
        // The last unknown is the centre: w′ − b = x − b.
        let coefficient = |i: usize, k: usize| {
            let hat = || [place(k), place(k + 1), place(k + 2)];
            if k + 1 == cells { -1.0 } else { slope_of_hat(&retardation, compliance, hat(), middle(i)) }
        };
        let row = |i: usize| (0..cells).map(|k| coefficient(i, k)).chain([middle(i)]).collect();
        let solution = by_elimination((0..cells).map(row).collect());
        let centre = solution[cells - 1];
        let share = |k: usize| solution[k] * 0.5 * (place(k + 2) - place(k));
        let load: f64 = (0..cells - 1).map(share).sum();
        // The mean place of a hat is that of its three places.
        let place_of = |k: usize| centre + (place(k) + place(k + 1) + place(k + 2)) / 3.0;
        let friction: f64 = 2.0 / PI * (0..cells - 1).map(|k| share(k) * place_of(k)).sum::<f64>();
        assert!((load / FRAC_PI_2 - 1.0).abs() < 1e-4, "{modes:?}: load {load}");
        assert!((centre / contact.centre() - 1.0).abs() < 1e-3, "{modes:?}: {centre} is not {}", contact.centre());
        assert!((friction / contact.friction() - 1.0).abs() < 1e-3, "{modes:?}: {friction}, {}", contact.friction());
    }
}

#[test]
fn it_is_published_as_a_limit() {
    let modes = [(3.0, 1.0), (7.0, 0.1)];
    let case = case(&modes);
    let contact = sliding(&modes);
    assert_eq!(limits(&case).dry_mu_v, contact.friction());
    assert!(limits(&case).approx_mu_h.is_nan());
    let mut chain = ChainLimits::default();
    for beta in [1.0, 1e3] {
        assert_eq!(chain.of(&Parameters { beta, ..case.clone() }).dry_mu_v, contact.friction());
    }
}

/// Two to five modes, f_j and α_j over decades.
fn modes() -> impl Strategy<Value = Vec<(f64, f64)>> {
    let mode = (-3.0..6.0_f64, -6.0..6.0_f64).prop_map(|(f, alpha)| (10_f64.powf(f), 10_f64.powf(alpha)));
    prop::collection::vec(mode, 2..6)
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(200)
    })]

    #[test]
    fn bounds_hold(modes in modes()) {
        let (contact, f) = (sliding(&modes), case(&modes).f);
        let half_width = contact.half_width();
        prop_assert!(half_width <= 1.0 && half_width * half_width * (1.0 + f) >= 1.0 - 1e-14);
        // The pressure is in the contact, and more of it towards the leading edge.
        prop_assert!(contact.centre() > 0.0 && contact.friction() > contact.centre());
        prop_assert!(contact.friction() < contact.leading_edge());
        // The hull of the contacts of each mode alone is no wrong place to look.
        let (trailing, leading, _) = contact_bounds(&case(&modes));
        prop_assert!(trailing <= contact.trailing_edge() + 1e-12 && contact.leading_edge() <= leading + 1e-12);
    }

    #[test]
    fn modes_have_no_order_and_can_be_split(modes in modes(), part in 0.01..0.99_f64) {
        let contact = numbers(&sliding(&modes));
        let reversed: Vec<_> = modes.iter().rev().copied().collect();
        prop_assert!(difference(numbers(&sliding(&reversed)), contact) < 1e-12);
        let mut split = modes.clone();
        split[0].0 *= part;
        split.push((modes[0].0 * (1.0 - part), modes[0].1));
        prop_assert!(difference(numbers(&sliding(&split)), contact) < 1e-12);
    }

    /// Also where two modes become one.
    #[test]
    fn little_changes_change_little(modes in modes(), exponent in -15.0..-3.0_f64) {
        let little = 10_f64.powf(exponent);
        let mut nearby = modes.clone();
        nearby.push((modes[0].0 * 0.5, modes[0].1 * (1.0 + little)));
        nearby[0].0 *= 0.5;
        let change = difference(numbers(&sliding(&nearby)), numbers(&sliding(&modes)));
        prop_assert!(change < little + 1e-11, "{change:.1e} from {little:.1e}");
    }

    /// Numbers as far as cases are computed at all, and beyond.
    #[test]
    fn no_magnitude_breaks_it(modes in prop::collection::vec((-200.0..50.0_f64, -60.0..60.0_f64), 1..5)) {
        let modes: Vec<_> = modes.iter().map(|&(f, alpha)| (10_f64.powf(f), 10_f64.powf(alpha))).collect();
        let (contact, f) = (sliding(&modes), case(&modes).f);
        let half_width = contact.half_width();
        prop_assert!(half_width <= 1.0 && half_width * half_width * (1.0 + f) >= 1.0 - 1e-13, "{contact:?}");
        prop_assert!(contact.centre() >= 0.0 && contact.friction() >= contact.centre(), "{contact:?}");
        prop_assert!(contact.friction() < 1.0 + half_width, "{contact:?}");
    }
}
