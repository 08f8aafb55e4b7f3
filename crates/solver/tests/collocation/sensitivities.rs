//! How friction changes with α, β and f: the adjoint's derivatives against differences, and the laws they obey.

use rayon::prelude::*;
use stribeck_solver::collocation::Settings;
use stribeck_solver::continuation::Solution;
use stribeck_solver::{CavityShear, Output, Parameters, Sensitivities, viscoelastic_error_scale};

use crate::collocation::cases::{numbers, relative, solution, solutions, with_modes};

/// Sensitivities and no field.
fn derivatives(cavity_shear: CavityShear) -> Output {
    Output { sensitivities: true, cavity_shear, ..numbers() }
}

fn of(solution: &Solution) -> Sensitivities {
    solution.sensitivities.expect("they were asked for")
}

/// F_v and F_h.
fn forces(solution: &Solution) -> [f64; 2] {
    let friction = &solution.quantities.friction;
    [friction.viscoelastic, friction.hydrodynamic()]
}

/// A case with one of α, β and f multiplied by a number.
fn scaled(case: &Parameters, theta: usize, by: f64) -> Parameters {
    let factor = |of: usize| if of == theta { by } else { 1.0 };
    let (alpha, beta, f) = (case.alpha * factor(0), case.beta * factor(1), case.f * factor(2));
    Parameters { alpha, beta, f, ..case.clone() }
}

/// The largest difference between the sensitivities of a case at tolerance 1e-9 and central differences of fourth order
/// of solutions at this tolerance, each on a mesh of its own, over the friction; of F_v over a thousandth of F_tot
/// where it is below that, which is what the tolerance promises.
fn error(case: &Parameters, cavity_shear: CavityShear) -> f64 {
    const STEP: f64 = 1e-2;
    let mut worst: f64 = 0.0;
    for theta in 0..3 {
        let line: Vec<Parameters> =
            (-2..=2).map(|steps| scaled(case, theta, (STEP * f64::from(steps)).exp())).collect();
        // one by one: along a chain they would share a mesh, and with it its errors
        let solved = line.iter().map(|case| solution(Settings::for_tolerance(1e-9), case, &derivatives(cavity_shear)));
        let solved: Vec<Solution> = solved.collect();
        let found = of(&solved[2]);
        let [a, b, here, c, d] = [0, 1, 2, 3, 4].map(|place| forces(&solved[place]));
        let scales = [viscoelastic_error_scale(here[0], here[0] + here[1]), here[1]];
        for (force, derivatives) in [found.viscoelastic, found.hydrodynamic].into_iter().enumerate() {
            let difference = (8.0 * (c[force] - b[force]) - (d[force] - a[force])) / (12.0 * STEP);
            worst = worst.max((derivatives[theta] - difference).abs() / scales[force]);
        }
    }
    worst
}

/// From thick to thin films, from nearly frozen to nearly relaxed, one mode to three, each way to fill the cavity.
fn spread() -> Vec<(Parameters, CavityShear)> {
    let three = [(0.5, 0.1), (0.3, 1.0), (0.2, 30.0)];
    let one = |alpha, beta, f| Parameters::new(alpha, beta, f);
    let cases = [
        one(1.0, 0.1, 10.0),
        one(1.0, 100.0, 10.0),
        one(0.1, 1e3, 100.0),
        with_modes(1.0, 10.0, 30.0, &[(0.7, 1.0), (0.3, 100.0)]),
        one(1e-3, 1e3, 100.0),
        one(1e3, 1e3, 100.0),
        one(10.0, 1e5, 0.5),
        with_modes(0.3, 300.0, 100.0, &three),
        one(30.0, 1e4, 1e3),
        one(0.01, 1.0, 1e3),
    ];
    let shears = [CavityShear::Full, CavityShear::Streamers, CavityShear::None];
    cases.into_iter().zip(shears.into_iter().cycle()).collect()
}

#[test]
fn sensitivities_agree_with_differences_of_solutions() {
    spread().par_iter().for_each(|(case, cavity_shear)| {
        let error = error(case, *cavity_shear);
        assert!(error < 1e-5, "{case:?}, {cavity_shear}: {error:e}");
    });
}

/// A grid of 96 cases; prints the largest error and the median.
#[test]
#[ignore = "slow: 1440 solutions at tolerance 1e-9"]
fn sensitivities_agree_with_differences_everywhere() {
    let shears = [CavityShear::Full, CavityShear::Streamers, CavityShear::None];
    let mut cases = Vec::new();
    for alpha in [1e-3, 0.1, 1.0, 1e3] {
        for beta in [0.1, 10.0, 1e3, 1e5] {
            for f in [0.5, 30.0, 1e3] {
                cases.push(Parameters::new(alpha, beta, f));
                cases.push(with_modes(alpha, beta, f, &[(0.6, 0.1), (0.4, 10.0)]));
            }
        }
    }
    let mut errors: Vec<(f64, String)> = cases
        .par_iter()
        .enumerate()
        .map(|(place, case)| (error(case, shears[place % 3]), format!("{case:?}")))
        .collect();
    errors.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (error, case) in errors.iter().rev().take(8) {
        println!("{error:.1e} {case}");
    }
    let ((largest, _), (median, _)) = (&errors[errors.len() - 1], &errors[errors.len() / 2]);
    println!("largest {largest:.1e}, median {median:.1e}");
    assert!(*largest < 1e-5 && *median < 1e-7);
}

/// An elastic substrate has no viscoelastic friction, and what describes its creep means nothing.
#[test]
fn elastic_cases_depend_on_what_they_know() {
    let settings = Settings::for_tolerance(1e-6);
    for case in [Parameters::elastic(50.0), Parameters::new(2.0, 50.0, 0.0), Parameters::new(f64::INFINITY, 50.0, 3.0)]
    {
        let found = of(&solution(settings, &case, &derivatives(CavityShear::Full)));
        assert_eq!(found.viscoelastic, [0.0; 3]);
        let [alpha, beta, f] = found.hydrodynamic;
        assert_eq!([alpha, f], [0.0; 2], "{case:?}");
        assert!(beta < 0.0);
    }
    let frozen = of(&solution(settings, &Parameters::new(0.0, 50.0, 3.0), &derivatives(CavityShear::Full)));
    assert_eq!((frozen.viscoelastic, frozen.hydrodynamic[0]), ([0.0; 3], 0.0));
}

/// At α = 0, F_h(β, f) = (1+f)^{−1/2} H(β/(1+f)), so that ∂F_h/∂ln f = −f/(1+f) (F_h/2 + ∂F_h/∂ln β). A very small α is
/// close to it.
#[test]
fn a_frozen_substrate_ties_f_to_beta() {
    for cavity_shear in [CavityShear::Full, CavityShear::Streamers, CavityShear::None] {
        for (alpha, allowed) in [(0.0, 1e-7), (1e-9, 1e-5)] {
            for (beta, f) in [(1.0, 0.5), (100.0, 10.0), (1e5, 100.0)] {
                let case = Parameters::new(alpha, beta, f);
                let solved = solution(Settings::for_tolerance(1e-9), &case, &derivatives(cavity_shear));
                let force = forces(&solved)[1];
                let [_, with_beta, with_f] = of(&solved).hydrodynamic;
                let expected = -f / (1.0 + f) * (0.5 * force + with_beta);
                assert!((with_f - expected).abs() < allowed * force, "{case:?}: {with_f} {expected}");
            }
        }
    }
}

/// Under a rigid film F_h falls as β^{−1/2}, and does not know the substrate.
#[test]
fn a_rigid_film_has_its_power() {
    let case = Parameters::new(1.0, 1e-7, 10.0);
    let solved = solution(Settings::for_tolerance(1e-9), &case, &derivatives(CavityShear::Full));
    let [_, mu_h] = forces(&solved);
    let of_h = of(&solved).hydrodynamic.map(|derivative| derivative / mu_h);
    for (found, expected) in of_h.into_iter().zip([0.0, -0.5, 0.0]) {
        assert!((found - expected).abs() < 1e-5, "{of_h:?}");
    }
}

/// A mode may be written as two with the same time, and its time may be told by α.
#[test]
fn the_same_substrate_in_other_words_has_the_same_sensitivities() {
    let settings = Settings::for_tolerance(1e-9);
    let rows = [
        Parameters::new(2.0, 200.0, 20.0),
        with_modes(2.0, 200.0, 20.0, &[(0.4, 1.0), (0.6, 1.0)]),
        with_modes(6.0, 200.0, 20.0, &[(1.0, 3.0)]),
    ]
    .map(|case| of(&solution(settings, &case, &derivatives(CavityShear::Full))).row());
    for row in &rows[1..] {
        for (value, expected) in row.iter().zip(&rows[0]) {
            assert!(relative(*value, *expected) < 1e-7, "{row:?} {:?}", rows[0]);
        }
    }
}

/// They are an output: no number of a solution depends on whether they are asked for.
#[test]
fn asking_changes_no_other_number() {
    let cases: Vec<Parameters> = [30.0, 60.0, 120.0].map(|beta| Parameters::new(1.0, beta, 50.0)).into();
    let settings = Settings::default();
    let with = solutions(settings, &cases, &derivatives(CavityShear::Full));
    let without = solutions(settings, &cases, &numbers());
    for (with, without) in with.iter().zip(&without) {
        assert_eq!((with.quantities, with.errors), (without.quantities, without.errors));
        assert!(with.sensitivities.is_some() && without.sensitivities.is_none());
    }
}
