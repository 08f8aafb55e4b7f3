//! What is known of extreme cases beforehand: rigid, dry and elastic limits, scaling, and the balance of forces.

use std::f64::consts::FRAC_PI_2;

use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, Solution, solve_chain};
use stribeck_solver::exact::{DryContact, RigidFilm};
use stribeck_solver::{
    CavityShear, Output, Parameters, Quantities, RetardationMode, Substrate, viscoelastic_error_scale,
};

use super::measure::true_error;
use crate::extremes::cases::outcome;

const TOLERANCE: f64 = 1e-6;

fn quantities(case: &Parameters) -> Quantities {
    let solved = outcome(Settings::for_tolerance(TOLERANCE), case);
    solved.outcome.unwrap_or_else(|why| panic!("{case:?}: {why}")).quantities
}

fn relative(a: f64, b: f64) -> f64 {
    (a / b - 1.0).abs()
}

/// β → 0: flow, outlet and shear of the rigid film, whatever the substrate; what it yields is of the order of β, for w
/// changes by about 1 and the film is 0.26/β thick.
#[test]
fn thick_films_are_those_of_a_rigid_plane() {
    for (alpha, f) in [(f64::INFINITY, 0.0), (1.0, 1e6), (1e-8, 10.0), (1e8, 1e3)] {
        for beta in [1e-4, 1e-6, 1e-12] {
            let (film, found) = (RigidFilm::new(beta), quantities(&Parameters::new(alpha, beta, f)));
            let shear = film.friction(CavityShear::Full).hydrodynamic();
            let pairs = [(found.c, film.c()), (found.x_outlet, film.outlet()), (found.friction.hydrodynamic(), shear)];
            for (found, exact) in pairs {
                assert!(
                    relative(found, exact) < 10.0 * beta + 3.0 * TOLERANCE,
                    "α = {alpha}, β = {beta}: {found} {exact}"
                );
            }
        }
    }
}

/// β → ∞: F_v is that of dry sliding, also where (1 + f)α is 10¹⁰; what the film adds falls as its thickness.
#[test]
fn thin_films_have_the_friction_of_dry_sliding() {
    for (alpha, f) in [(1e-4, 1e6), (1e-2, 1e6), (1.0, 1e6), (100.0, 1e6), (1e4, 1e6), (1.0, 1e4), (1e-6, 10.0)] {
        let dry = DryContact::new(alpha, f).friction();
        let distance = |beta: f64| {
            let friction = quantities(&Parameters::new(alpha, beta, f)).friction;
            (friction.viscoelastic - dry).abs() / viscoelastic_error_scale(dry, friction.total())
        };
        let (thin, thinner) = (distance(1e6), distance(1e9));
        assert!(thinner < 1e-3, "α = {alpha}, f = {f}: {thinner:e}");
        assert!(thinner < 0.1 * thin + TOLERANCE, "α = {alpha}, f = {f}: {thin:e} {thinner:e}");
    }
}

/// c β^{3/5} → 0.4458 on an elastic substrate, and u_min/c → 0.796.
#[test]
fn elastic_films_keep_to_their_power_law() {
    for beta in [1e10, 1e12, 1e14] {
        let solved = outcome(Settings::default(), &Parameters::elastic(beta)).outcome.expect("elastic films are easy");
        let Quantities { c, film_min, .. } = solved.quantities;
        assert!(relative(c * beta.powf(0.6), 0.4458) < 2e-3, "β = {beta}: {}", c * beta.powf(0.6));
        assert!(relative(film_min / c, 0.796) < 2e-3, "β = {beta}: {}", film_min / c);
    }
}

/// α = 0 is the elastic film at β/(1 + f), films divided by 1 + f: forces on them by √(1 + f).
#[test]
fn frozen_substrates_are_elastic_ones_rescaled() {
    for f in [1e3, 1e6, 1e10] {
        for beta in [1e-2, 10.0, 1e6, 1e9] {
            let frozen = quantities(&Parameters::new(0.0, beta, f));
            let elastic = quantities(&Parameters::elastic(beta / (1.0 + f)));
            let pairs = [
                (frozen.c * (1.0 + f), elastic.c),
                (frozen.friction.hydrodynamic() * (1.0 + f).sqrt(), elastic.friction.hydrodynamic()),
                (frozen.p_max / (1.0 + f).sqrt(), elastic.p_max),
            ];
            for (frozen, elastic) in pairs {
                assert!(relative(frozen, elastic) < 10.0 * TOLERANCE, "f = {f}, β = {beta}: {frozen} {elastic}");
            }
            assert_eq!(frozen.friction.viscoelastic, 0.0);
        }
    }
}

/// α → 0 and α → ∞ join the elastic limits, in proportion to α or 1/α.
#[test]
fn ends_of_alpha_join_the_elastic_limits() {
    for f in [10.0, 1e3] {
        for beta in [1.0, 1e3, 1e6] {
            for (alpha, limit) in [(1e-8, 0.0), (1e8, f64::INFINITY)] {
                let near = quantities(&Parameters::new(alpha, beta, f));
                let at = quantities(&Parameters::new(limit, beta, f));
                let pairs = [(near.c, at.c), (near.friction.hydrodynamic(), at.friction.hydrodynamic())];
                for (near, at) in pairs {
                    assert!(relative(near, at) < 1e-5, "α = {alpha}, f = {f}, β = {beta}: {near} {at}");
                }
                let (lost, numerical) = (near.friction.viscoelastic, 1e-3 * TOLERANCE * near.friction.total());
                assert!(lost.abs() < 30.0 * f * alpha.min(1.0 / alpha) + numerical, "f = {f}, β = {beta}: {lost:e}");
            }
        }
    }
}

/// Only α over the times counts; and a mode may be split into any number of modes of the same time.
#[test]
fn modes_have_no_unit_and_no_number() {
    let case = |alpha: f64, modes: &[(f64, f64)]| {
        let modes = modes.iter().map(|&(share, time)| RetardationMode { share, time }).collect();
        Parameters { substrate: Substrate::new(modes).expect("modes"), ..Parameters::new(alpha, 1e5, 1e4) }
    };
    let plain = quantities(&case(1e-2, &[(0.5, 1e-3), (0.5, 1e3)]));
    let later = quantities(&case(10.0, &[(0.5, 1.0), (0.5, 1e6)]));
    let split = quantities(&case(1e-2, &[(0.25, 1e-3), (0.25, 1e-3), (0.2, 1e3), (0.3, 1e3)]));
    for other in [later, split] {
        assert!(true_error(&other, &plain) < 2.0 * TOLERANCE, "{plain:?} {other:?}");
    }
}

/// A chain of one case with its pressure and film at some places.
fn fields(case: &Parameters, x: Vec<f64>) -> Solution {
    let output = Output { x: x.into(), limits: false, ..Output::default() };
    let solver = CollocationSolver::new(Settings::for_tolerance(1e-5));
    let mut solved =
        solve_chain(&solver, std::slice::from_ref(case), &output, &Interrupt::new()).expect("nobody interrupts");
    solved.remove(0).outcome.unwrap_or_else(|why| panic!("{case:?}: {why}"))
}

/// Places from the outlet on: more and more where pressure or film change much from one to the next.
fn places(case: &Parameters) -> Vec<f64> {
    const PARTS: usize = 4;
    let Quantities { x_outlet, x_p_max, friction, .. } = fields(case, vec![0.0]).quantities;
    let width = f64::max(x_p_max - x_outlet, 1.0);
    let distances = (-200..100).map(|i| width * 10_f64.powf(0.05 * f64::from(i)));
    let mut x: Vec<f64> = distances.map(|far| x_outlet + far).collect();
    x.insert(0, x_outlet);
    x.dedup();
    for _ in 0..12 {
        let Solution { fields, .. } = fields(case, x.clone());
        let (p, u) = (fields.pressure.expect("asked for"), fields.film_thickness.expect("asked for"));
        let is_long = |i: usize| ((p[i + 1] - p[i]) * (u[i + 1] - u[i])).abs() > 1e-6 * friction.drag;
        let mut finer = vec![x[0]];
        for (i, ends) in x.windows(2).enumerate() {
            let parts = if is_long(i) { PARTS } else { 1 };
            finer.extend((1..=parts).map(|k| ends[0] + (ends[1] - ends[0]) * k as f64 / parts as f64));
        }
        finer.dedup();
        if finer.len() == x.len() {
            break;
        }
        x = finer;
    }
    x
}

/// The pressure on the cylinder pulls it back by (2/π) ∫ p x dx; the same must come out of the substrate's friction and
/// the published fields, F_v − (2/π) ∫ u dp: work done on the substrate and by the flow (T27).
#[test]
fn forces_on_cylinder_and_substrate_balance() {
    for (alpha, beta, f) in
        [(1.0, 1e8, 1e6), (1e-2, 1e6, 1e6), (1e-4, 1e4, 1e4), (100.0, 1e8, 1e6), (1.0, 1e-3, 1e6), (1e-8, 1e3, 10.0)]
    {
        let case = Parameters::new(alpha, beta, f);
        let Solution { quantities, fields, .. } = fields(&case, places(&case));
        let (p, u) = (fields.pressure.expect("asked for"), fields.film_thickness.expect("asked for"));
        let flow: f64 = p.windows(2).zip(u.windows(2)).map(|(p, u)| 0.5 * (u[0] + u[1]) * (p[1] - p[0])).sum();
        let other = quantities.friction.viscoelastic - flow / FRAC_PI_2;
        let off = (quantities.centroid - other).abs() / quantities.friction.drag;
        assert!(off < 3e-5, "{case:?}: {} {other}", quantities.centroid);
    }
}
