//! How friction changes with α, β and f: the adjoint's derivatives against differences, and the laws they obey.

use rayon::prelude::*;
use stribeck_solver::collocation::Settings;
use stribeck_solver::continuation::Solution;
use stribeck_solver::{
    CavityShear, Output, Parameters, RetardationMode, Sensitivities, Substrate, viscoelastic_error_scale,
};

use crate::collocation::cases::{numbers, relative, solution, solutions, with_modes};

/// Sensitivities and no field.
fn derivatives(cavity_shear: CavityShear) -> Output {
    Output { sensitivities: true, cavity_shear, ..numbers() }
}

fn of(solution: &Solution) -> Sensitivities {
    solution.sensitivities.expect("they were asked for")
}

/// F_v of the flat, that of the roller, F_h and P.
fn forces(solution: &Solution) -> [f64; 4] {
    let friction = &solution.quantities.friction;
    [friction.viscoelastic_flat(), friction.viscoelastic_roller, friction.hydrodynamic(), friction.pressure]
}

/// Modes of flat and roller: (strength, rate) each.
type Bodies = [Vec<(f64, f64)>; 2];

/// The modes of a case with α = 1.
fn bodies(case: &Parameters) -> Bodies {
    let mut flat: Vec<(f64, f64)> =
        case.substrate.modes().iter().map(|mode| (case.f * mode.share, case.alpha / mode.time)).collect();
    let roller = flat.split_off(flat.len() - case.substrate.of_roller());
    [flat, roller]
}

fn of_bodies(beta: f64, bodies: &Bodies) -> Parameters {
    let f: f64 = bodies.iter().flatten().map(|mode| mode.0).sum();
    let modes = |body: usize| {
        let modes = bodies[body].iter();
        modes.map(|&(strength, rate)| RetardationMode { share: strength / f, time: 1.0 / rate }).collect()
    };
    let substrate = Substrate::of_two_bodies(modes(0), modes(1)).expect("parts of f add up to 1");
    Parameters { substrate, ..Parameters::new(1.0, beta, f) }
}

/// A case with one of the parameters of [`Sensitivities::PARAMETERS`] multiplied by a number.
fn scaled(case: &Parameters, theta: usize, by: f64) -> Parameters {
    let mut changed = bodies(case);
    match theta {
        0 | 3 => changed[theta / 3].iter_mut().for_each(|mode| mode.1 *= by),
        2 | 4 => changed[theta / 4].iter_mut().for_each(|mode| mode.0 *= by),
        _ => return Parameters { beta: case.beta * by, ..case.clone() },
    }
    of_bodies(case.beta, &changed)
}

/// The largest difference between the sensitivities of a case at tolerance 1e-9 and central differences of fourth order
/// of solutions at this tolerance, each on a mesh of its own, over the friction; of F_v over a thousandth of F_tot
/// where it is below that, which is what the tolerance promises.
fn error(case: &Parameters, cavity_shear: CavityShear) -> f64 {
    const STEP: f64 = 1e-2;
    let mut worst: f64 = 0.0;
    let there = bodies(case).map(|modes| !modes.is_empty());
    for theta in (0..5).filter(|&theta| theta == 1 || there[theta / 3]) {
        let line: Vec<Parameters> =
            (-2..=2).map(|steps| scaled(case, theta, (STEP * f64::from(steps)).exp())).collect();
        // one by one: along a chain they would share a mesh, and with it its errors
        let solved = line.iter().map(|case| solution(Settings::for_tolerance(1e-9), case, &derivatives(cavity_shear)));
        let solved: Vec<Solution> = solved.collect();
        let found = of(&solved[2]);
        let [a, b, here, c, d] = [0, 1, 2, 3, 4].map(|place| forces(&solved[place]));
        let of_viscoelastic = viscoelastic_error_scale(here[0] + here[1], here[0] + here[1] + here[2]);
        let scales = [of_viscoelastic, of_viscoelastic, here[2], here[3].abs()];
        let all = [found.viscoelastic_flat, found.viscoelastic_roller, found.hydrodynamic, found.pressure];
        for (force, derivatives) in all.into_iter().enumerate() {
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

/// Both bodies, and the roller alone, from thick to thin films.
#[test]
fn sensitivities_to_each_body_agree_with_differences_of_solutions() {
    let cases = [
        (0.1, [vec![(5.0, 1.0)], vec![(3.0, 4.0)]]),
        (30.0, [vec![(2.0, 1.0), (8.0, 0.05)], vec![(10.0, 0.3)]]),
        (1e3, [vec![(60.0, 0.1)], vec![(20.0, 3.0), (20.0, 100.0)]]),
        (1e4, [vec![(1.0, 30.0)], vec![(9.0, 1.0)]]),
        (100.0, [vec![], vec![(10.0, 1.0)]]),
        (1e3, [vec![], vec![(50.0, 0.1), (50.0, 10.0)]]),
    ];
    let shears = [CavityShear::Full, CavityShear::Streamers, CavityShear::None].into_iter().cycle();
    let cases: Vec<_> = cases.into_iter().zip(shears).collect();
    cases.par_iter().for_each(|((beta, bodies), cavity_shear)| {
        let case = of_bodies(*beta, bodies);
        let error = error(&case, *cavity_shear);
        assert!(error < 1e-5, "{case:?}, {cavity_shear}: {error:e}");
    });
}

/// What bodies are called does not matter: exchanged, each has the derivatives of the other, with their errors. Those of
/// the case are those of both bodies as one.
#[test]
fn exchanged_bodies_exchange_their_derivatives() {
    let [one, other] = [vec![(4.0, 1.0), (2.0, 0.1)], vec![(14.0, 5.0)]];
    let both = one.iter().chain(&other).copied().collect::<Vec<_>>();
    let solved = |bodies: Bodies| {
        solution(Settings::for_tolerance(1e-7), &of_bodies(200.0, &bodies), &derivatives(CavityShear::Full))
    };
    let [here, there, alone] = [[one.clone(), other.clone()], [other, one], [both, Vec::new()]].map(solved);
    let exchanged = |[a, b, c, d, e]: [f64; 5]| [d, b, e, a, c];
    let all = |it: Sensitivities| [it.viscoelastic_flat, it.viscoelastic_roller, it.hydrodynamic, it.pressure];
    let [flat, roller, hydrodynamic, pressure] = all(of(&there));
    for (found, expected) in all(of(&here)).iter().zip([roller, flat, hydrodynamic, pressure].map(exchanged)) {
        for (found, expected) in found.iter().zip(expected) {
            assert!(relative(*found, expected) < 1e-7, "{found} {expected}");
        }
    }
    let errors = |solution: &Solution| solution.sensitivity_errors.expect("asked for");
    assert!(all(errors(&here)).iter().flatten().all(|error| *error > 0.0 && *error < 1e-5));
    for (found, expected) in of(&here).named().iter().zip(of(&alone).named()) {
        assert!(relative(*found, expected) < 1e-7, "{found} {expected}");
    }
    let of_one = all(of(&alone)).iter().chain(&all(errors(&alone))).map(|it| [it[3], it[4]]).collect::<Vec<_>>();
    assert_eq!(of_one, [[0.0; 2]; 8], "a rigid roller has none");
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
        assert_eq!(found.viscoelastic(), [0.0; 5]);
        let [alpha, beta, f] = Sensitivities::of_case(found.hydrodynamic);
        assert_eq!([alpha, f], [0.0; 2], "{case:?}");
        assert!(beta < 0.0);
    }
    let frozen = of(&solution(settings, &Parameters::new(0.0, 50.0, 3.0), &derivatives(CavityShear::Full)));
    assert_eq!((frozen.viscoelastic(), frozen.hydrodynamic[0]), ([0.0; 5], 0.0));
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
                let force = solved.quantities.friction.hydrodynamic();
                let [_, with_beta, with_f] = Sensitivities::of_case(of(&solved).hydrodynamic);
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
    let mu_h = solved.quantities.friction.hydrodynamic();
    let of_h = Sensitivities::of_case(of(&solved).hydrodynamic).map(|derivative| derivative / mu_h);
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
    .map(|case| of(&solution(settings, &case, &derivatives(CavityShear::Full))).named());
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
