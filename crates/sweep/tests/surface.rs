//! Laws of surfaces that are made: they agree with solutions, do not depend on threads or interruptions, and reach the
//! limits that their axes say.

use std::num::NonZeroUsize;
use std::path::Path;

use stribeck_solver::{Parameters, Settings, collocation, solve};
use stribeck_sweep::SurfaceSweep;
use stribeck_sweep::surface::{SurfaceBuildError, SurfaceOptions, SurfaceReport, build};

fn make(text: &str, directory: &Path, threads: usize) -> SurfaceReport {
    let sweep = SurfaceSweep::parse("test", text).expect("valid");
    let options = SurfaceOptions { threads: NonZeroUsize::new(threads).expect("above 0"), ..SurfaceOptions::default() };
    build(&sweep, directory, &options, &mut |_| {}).expect("made")
}

/// Solved by the solver alone: no store, no chain, no map.
fn solution(parameters: &Parameters) -> [f64; 5] {
    let method = stribeck_solver::Method::Collocation(collocation::Settings::for_tolerance(1e-8));
    let solution = solve(parameters, &Settings { method, ..Settings::default() }).expect("solved");
    let (friction, quantities) = (&solution.quantities.friction, &solution.quantities);
    [friction.drag, friction.viscoelastic, friction.hydrodynamic(), quantities.c, quantities.x_outlet]
}

#[test]
fn quantities_of_the_laboratory_are_in_si_units() {
    let text = "[laboratory]\nradius = \"2 mm\"\nload = \"100 N/m\"\nrelaxed_modulus = \"100 kPa\"\npoisson_ratio = 0.5\n\
                viscosity = \"1 Pa s\"\nretardation_time = \"20 ms\"\nf = 10.0\n\
                speed = { from = \"10 mm/s\", to = \"100 mm/s\", scale = \"log\" }\n[surface]\ntolerance = 1e-4\n\
                quantities = [\"mu_v\", \"film_min\"]\n";
    let directory = tempfile::tempdir().expect("a directory");
    let report = make(text, directory.path(), 2);
    let quantities: Vec<&str> = report.surface.quantities().collect();
    assert_eq!(quantities, ["mu_drag", "mu_v", "film_min"], "parts need the drag");
    let sweep = stribeck_sweep::Sweep::parse(
        "one",
        &text.replace("speed = { from = \"10 mm/s\", to = \"100 mm/s\", scale = \"log\" }", "speed = \"33 mm/s\""),
    )
    .expect("valid");
    let experiment = sweep.grid.experiment([0, 0, 0].into()).expect("a laboratory");
    let expected = solution(&experiment.parameters(&sweep.substrate));
    let mut evaluator = report.surface.evaluator();
    let values = evaluator.values(&[0.033]).expect("inside");
    let scale = experiment.scales().friction;
    for (value, expected) in values.iter().zip([expected[0] * scale, expected[1] * scale]) {
        assert!((value / expected - 1.0).abs() < 1e-4, "{value} {expected}");
    }
    let units: Vec<&str> = report.surface.file().quantities.iter().map(|it| it.units.as_str()).collect();
    assert_eq!(units, ["1", "1", "m"]);
}

#[test]
fn a_quantity_that_has_no_logarithm_is_named() {
    let text =
        "[axes]\nslide_roll = [-0.9]\nalpha = { from = 1.0, to = 10.0, scale = \"log\" }\nbeta = [10.0]\nf = [1.0]\n";
    let sweep = SurfaceSweep::parse("test", text).expect("valid");
    let directory = tempfile::tempdir().expect("a directory");
    let error = build(&sweep, directory.path(), &SurfaceOptions::default(), &mut |_| {}).expect_err("refused");
    assert!(matches!(error, SurfaceBuildError::NoNumber { quantity: "mu_drag", .. }), "{error}");
}
