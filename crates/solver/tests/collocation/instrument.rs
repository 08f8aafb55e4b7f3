//! What an instrument reads: drag and torque of rolling and sliding, of two bodies, and tractions along the surface.

use std::f64::consts::PI;

use rayon::prelude::*;
use stribeck_solver::exact::RigidFilm;
use stribeck_solver::{CavityShear, Lubricant, Parameters, Quantities, RetardationMode, Substrate, shear_traction};

use crate::collocation::cases::{EXACTLY, ROWS, numbers, relative, settings, solution};
use crate::collocation::forces::{Sampled, cases};
use crate::collocation::measure::EXACT;

/// Slide-to-roll ratios from a roller that does not turn to a flat that does not move.
const RATIOS: [f64; 5] = [1.0, 0.5, 0.0, -0.5, -1.0];

/// The same pressure and film with other parts of the modes on the roller: all of them, or a third.
fn on_roller(case: &Parameters, part: f64) -> Parameters {
    let of = |part: f64| -> Vec<RetardationMode> {
        let modes = case.substrate.modes().iter();
        modes
            .map(|mode| RetardationMode { share: mode.share * part, ..*mode })
            .filter(|mode| mode.share > 0.0)
            .collect()
    };
    let substrate = Substrate::of_two_bodies(of(1.0 - part), of(part)).expect("the same shares");
    Parameters { substrate, ..case.clone() }
}

/// Power in is power out, for every slide-to-roll ratio and whichever body is soft (T56). The pressure-driven flow is
/// dissipation by itself, (β/π) ∫ u³p′² dx; drag and torque come from the centroid of the pressure.
#[test]
fn power_is_balanced() {
    assert_eq!(ROWS.len(), 84);
    let check = |case: &Parameters, quantities: &Quantities| {
        for slide_roll in RATIOS {
            let residual = quantities.energy_residual(slide_roll);
            assert!(residual < 1e-8, "{case:?}, S = {slide_roll}: {residual:.1e}");
        }
    };
    ROWS.par_iter().zip(&*EXACTLY).for_each(|(case, exactly)| {
        check(case, exactly);
        // both bodies, and the roller alone
        for part in [1.0 / 3.0, 1.0] {
            let case = on_roller(case, part);
            let found = solution(EXACT, &case, &numbers()).quantities;
            check(&case, &found);
            let (friction, before) = (&found.friction, &exactly.friction);
            let slack = 1e-8 * before.drag;
            assert!((friction.viscoelastic_roller - part * before.viscoelastic).abs() < slack, "{case:?}");
            assert!((friction.drag - before.drag + part * before.viscoelastic).abs() < slack, "{case:?}");
        }
    });
}

/// The parts of friction are made of three integrals, and the balance of forces (T54) holds for each ratio.
#[test]
fn drag_and_torque_are_made_of_their_parts() {
    for exactly in &*EXACTLY {
        let friction = &exactly.friction;
        let (p, c) = (friction.pressure, friction.shear());
        assert!(p < 0.0 && c > 0.0, "{friction:?}");
        for slide_roll in RATIOS {
            let drag = friction.viscoelastic - p + slide_roll * c;
            assert!((friction.drag_at(slide_roll) - drag).abs() < 1e-8 * friction.drag, "{friction:?}");
            let torque = friction.drag_at(slide_roll) - exactly.centroid;
            assert!((friction.torque_at(slide_roll) - torque).abs() < 1e-12 * friction.drag, "{friction:?}");
        }
        assert_eq!(friction.drag_at(1.0), friction.drag);
    }
}

/// Two bodies of one material that roll on each other are one body of twice the compliance, and each does half of the
/// hysteresis.
#[test]
fn equal_bodies_that_roll_share_the_hysteresis() {
    for (alpha, beta, f) in [(1.0, 100.0, 10.0), (0.1, 10.0, 100.0), (10.0, 1e4, 3.0)] {
        let one = Parameters::new(alpha, beta, f);
        let [one, two] =
            [one.clone(), on_roller(&one, 0.5)].map(|case| solution(settings(1e-8), &case, &numbers()).quantities);
        assert!(relative(two.friction.viscoelastic, one.friction.viscoelastic) < 1e-8);
        assert!(relative(two.friction.viscoelastic_roller, 0.5 * one.friction.viscoelastic) < 1e-8);
        // neither is driven by the other: the torque is the drag with the other sign
        let (drag, torque) = (two.friction.drag_at(0.0), two.friction.torque_at(0.0));
        assert!((drag + torque).abs() < 1e-7 * drag, "{drag} {torque}");
    }
}

/// Under thick films at any ratio: the closed form of Martin's film with ∫ p′u dx and ∫ dx/u by quadrature here.
#[test]
fn thick_films_have_the_drag_of_a_rigid_film() {
    let beta = 1e-5;
    let film = RigidFilm::new(beta);
    let (c, outlet, width) = (film.c(), film.outlet(), (2.0 * film.separation()).sqrt());
    // x = √(2h₀) tan φ, in which all integrands are smooth
    let over = |from: f64, to: f64, of: &dyn Fn(f64) -> f64| -> f64 {
        let panels = 20;
        let step = (to - from) / f64::from(panels);
        let panel = |i: i32| {
            let start = from + step * f64::from(i);
            stribeck_solver::gauss::integrate(start, start + step, |phi| {
                of(width * phi.tan()) * width / phi.cos().powi(2)
            })
        };
        (0..panels).map(panel).sum()
    };
    let start = (outlet / width).atan();
    let gap = |x: f64| film.separation() + 0.5 * x * x;
    let pressure = over(start, PI / 2.0, &|x| (c - gap(x)) / (beta * gap(x).powi(2))) / PI;
    let shear = over(-PI / 2.0, PI / 2.0, &|x| 1.0 / gap(x)) / (3.0 * PI * beta);
    let friction = solution(settings(1e-7), &Parameters::new(1.0, beta, 10.0), &numbers()).quantities.friction;
    for slide_roll in RATIOS {
        let exact = -pressure + slide_roll * shear;
        assert!((friction.drag_at(slide_roll) - exact).abs() < 1e-4 * shear, "{slide_roll}: {friction:?} {exact}");
    }
}

/// Tractions are friction, place by place: their integrals are F_h,film and F_v, to what the panels here leave out.
#[test]
fn tractions_add_up_to_friction() {
    cases().par_iter().for_each(|case| {
        let sampled = Sampled::new(settings(1e-8), case);
        let (end, beta, friction) = (sampled.x[sampled.x.len() - 1], case.beta, &sampled.quantities.friction);
        // beyond, where u = x²/2
        let shear = sampled.integral(|i| sampled.shear_traction[i]) - 4.0 / (3.0 * PI * beta * end);
        assert!(relative(shear, friction.hydrodynamic_film) < 3e-8, "{case:?}: {shear} {friction:?}");
        let hysteresis = sampled.integral(|i| sampled.hysteresis_traction[i]);
        let error = (hysteresis - friction.viscoelastic).abs() / friction.drag;
        // w′ is a derivative of the film's polynomials, which is not known as well as they are
        assert!(error < 3e-6, "{case:?}: {hysteresis} {friction:?}, {error:.1e}");
    });
}

/// What is behind the outlet is F_h,cavity, and far away shear falls as x⁻² and hysteresis as x⁻⁴.
#[test]
fn tractions_have_their_tails() {
    let case = Parameters::new(1.0, 100.0, 10.0);
    for (cavity_shear, theta) in [(CavityShear::Full, 1.0), (CavityShear::None, 0.0)] {
        let mut output = crate::collocation::cases::fields_at([-2e4, -1e4, 1e4, 2e4]);
        output.cavity_shear = cavity_shear;
        let fields = solution(settings(1e-7), &case, &output).fields;
        let (shear, hysteresis) = (fields.shear_traction.unwrap(), fields.hysteresis_traction.unwrap());
        // 1/(3πβu) with u = x²/2 behind; ahead −1/(πβu) more
        let unit = 2.0 / (3.0 * PI * case.beta * 1e8);
        for (found, expected) in shear.iter().zip([theta / 4.0, theta, -2.0, -0.5]) {
            assert!((found / unit - expected).abs() < 2e-3, "{shear:?} over {unit}");
        }
        assert_eq!(hysteresis[..2], [0.0; 2]);
        assert!((hysteresis[2] / hysteresis[3] - 16.0).abs() < 1.0, "{hysteresis:?}");
    }
}

/// The fluid of the cavity flows on at the speed that it left the film with.
#[test]
fn streamers_shear_less_than_a_full_gap() {
    let at = |cavity_shear, slide_roll| {
        let lubricant = Lubricant { beta: 10.0, c: 0.5, outlet: -1.0, cavity_shear };
        shear_traction(&lubricant, -2.0, 1.0, slide_roll)
    };
    let full = at(CavityShear::Full, 1.0);
    assert_eq!(at(CavityShear::Streamers, 1.0), 0.5 * full);
    assert_eq!(at(CavityShear::Full, -0.5), -0.5 * full);
}
