//! Fits to measured friction: what they find of points that were made, and what they refuse.

mod ending;
mod errors;
mod invariance;
mod recovery;
mod refusals;

use stribeck_lab::{
    Experiment, FrictionFit, FrictionFitError, FrictionTask, Measured, Modulus, Motion, Roller, Unknown,
};
use stribeck_solver::{
    CavityShear, Interrupt, Method, Parameters, Settings, SolvedCase, Substrate, collocation, solve_points,
};

const TRUTH: Experiment = Experiment {
    radius: 2e-3,
    load: 119.0,
    modulus: Modulus::Relaxed(1e5),
    poisson_ratio: 0.5,
    viscosity: 5.1,
    retardation_time: 0.02,
    motion: Motion::Sliding { speed: 1e-3 },
    f: 10.0,
    roller: Roller::RIGID,
    temperature: None,
};

/// A roller that is softer at once and creeps less than the flat.
const SOFT_ROLLER: Roller =
    Roller { modulus: Modulus::Relaxed(2e5), poisson_ratio: 0.4, f: 3.0, retardation_time: 0.15 };

/// Numbers that are as good as random, from 0 to 1: a linear congruential generator (Knuth's MMIX).
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// With mean 0 and variance 1 (Box and Muller).
    fn normal(&mut self) -> f64 {
        let (radius, angle) = ((-2.0 * (1.0 - self.uniform()).ln()).sqrt(), self.uniform());
        radius * (2.0 * std::f64::consts::PI * angle).cos()
    }
}

fn unknowns(names: &[&str]) -> Vec<Unknown> {
    names.iter().map(|name| Unknown::named(name).expect(name)).collect()
}

/// Points of drag over the speed.
fn points(speeds: &[f64], friction: Vec<f64>, errors: Option<Vec<f64>>) -> Measured {
    Measured {
        files: vec!["made".into()],
        column: "mu_drag",
        places: (2..).take(speeds.len()).map(|line| (0, line)).collect(),
        friction,
        errors,
        coordinates: vec![("speed", speeds.to_vec())],
        is_averaged: false,
        is_computed: false,
        without_unit: Vec::new(),
    }
}

fn fitted(
    measured: &Measured,
    start: Experiment,
    substrate: &Substrate,
    names: &[&str],
) -> Result<FrictionFit, FrictionFitError> {
    FrictionFit::new(&FrictionTask {
        measured,
        experiment: start,
        substrate,
        roller_spectrum: substrate,
        cavity_shear: CavityShear::Full,
        unknowns: unknowns(names),
        bounds: Vec::new(),
        tolerance: 1e-7,
    })
}

fn speeds(count: u32, from: f64, to: f64) -> Vec<f64> {
    (0..count).map(|i| from * (to / from).powf(f64::from(i) / f64::from(count - 1))).collect()
}

/// Drag of the truth, which slides at these speeds.
fn exact(speeds: &[f64], truth: Experiment, substrate: &Substrate) -> Vec<f64> {
    let motions: Vec<Motion> = speeds.iter().map(|speed| Motion::Sliding { speed: *speed }).collect();
    drag(&motions, truth, substrate)
}

/// Drag of the truth: what pushes on the flat, from the pressure and the shear along it. The pressure works on the
/// slope of the flat, and the shear on the flat is P − S C the other way. Both bodies have the same spectrum.
fn drag(motions: &[Motion], truth: Experiment, substrate: &Substrate) -> Vec<f64> {
    let method = Method::Collocation(collocation::Settings::for_tolerance(1e-8));
    let settings = Settings { method, ..Settings::default() };
    let experiments: Vec<Experiment> = motions.iter().map(|motion| Experiment { motion: *motion, ..truth }).collect();
    let cases: Vec<Parameters> = experiments.iter().map(|it| it.parameters_of_both(substrate, substrate)).collect();
    let solved = solve_points(&cases, &settings, &Interrupt::new()).expect("nobody interrupts");
    let on_flat = |(case, it): (SolvedCase, &Experiment)| {
        let friction = case.outcome.expect("solved").quantities.friction;
        let shear = it.motion.slide_roll() * friction.shear() - friction.pressure;
        (friction.viscoelastic_flat() + shear) * it.scales().friction
    };
    solved.into_iter().zip(&experiments).map(on_flat).collect()
}
