//! Spectra of creep and relaxation.

use proptest::prelude::*;
use stribeck_solver::exact::{Line, Spectrum};

fn spectrum(lines: &[(f64, f64)]) -> Spectrum {
    Spectrum::new(lines.iter().map(|&(strength, place)| Line { strength, place }))
}

/// A line of strength s at 3 beside one of strength 1 at 1: 1 − 1/(x − 1) = s/(x/3 − 1) has a root at 3(1 + 2s); at
/// 6/5, where the left side is −4, at 6/5 (1 − s/4).
#[test]
fn the_distance_from_a_weak_line_has_all_its_digits() {
    for strength in [1e-17, 1e-40, 1e-150, 1e-290] {
        let after = spectrum(&[(1.0, 1.0), (strength, 3.0)]).conjugate();
        assert!((after.distances[1][1] / (2.0 * strength) - 1.0).abs() < 1e-15, "{after:?}");
        assert!((after.spectrum.lines()[0].place - 2.0).abs() < 1e-15);
        let before = spectrum(&[(1.0, 1.0), (strength, 1.2)]).conjugate();
        assert!((before.distances[0][1] / (-0.25 * strength) - 1.0).abs() < 1e-14, "{before:?}");
        assert!((before.spectrum.lines()[1].place - 2.0).abs() < 1e-15);
    }
}

#[test]
fn lines_at_one_place_are_one() {
    assert_eq!(spectrum(&[(1.0, 5.0), (4.0, 2.0), (2.0, 5.0)]), spectrum(&[(4.0, 2.0), (3.0, 5.0)]));
    assert_eq!(spectrum(&[(1.0, 1.0), (3.0, 1.0 + 4e-11)]).lines().len(), 1);
    assert_eq!(spectrum(&[(1.0, 1.0), (3.0, 1.0 + 4e-10)]).lines().len(), 2);
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(300)
    })]

    /// (T42) is an orthogonal matrix only if places, distances and strengths all fit.
    #[test]
    fn the_exchange_is_orthogonal(
        lines in prop::collection::vec((-8.0..8.0_f64, -8.0..8.0_f64), 1..12),
    ) {
        let lines: Vec<_> = lines.iter().map(|&(s, p)| (10_f64.powf(s), 10_f64.powf(p))).collect();
        let spectrum = spectrum(&lines);
        let conjugate = spectrum.conjugate();
        let (from, to) = (spectrum.lines(), conjugate.spectrum.lines());
        prop_assert!((conjugate.spectrum.total() / spectrum.total() - 1.0).abs() < 1e-12);
        let u = |j: usize, m: usize| {
            let ratio = from[j].strength / (1.0 + spectrum.total()) * (to[m].place / from[j].place);
            ratio.sqrt() * to[m].strength.sqrt() / conjugate.distances[m][j]
        };
        for m in 0..to.len() {
            prop_assert!(from[m].place <= to[m].place && from.get(m + 1).is_none_or(|next| to[m].place <= next.place));
            for k in 0..to.len() {
                let product: f64 = (0..from.len()).map(|j| u(j, m) * u(j, k)).sum();
                let unity = if m == k { 1.0 } else { 0.0 };
                prop_assert!((product - unity).abs() < 1e-12, "columns {m} and {k}: {product}");
            }
        }
    }
}
