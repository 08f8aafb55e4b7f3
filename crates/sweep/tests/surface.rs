//! Laws of surfaces that are made: they agree with solutions, do not depend on threads or interruptions, and reach the
//! limits that their axes say.

use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::Arc;

use stribeck_solver::{Parameters, Settings, collocation, solve};
use stribeck_surface::Surface;
use stribeck_sweep::SurfaceSweep;
use stribeck_sweep::surface::{Progress, SurfaceBuildError, SurfaceOptions, SurfaceReport, build, compare_surface};

/// α up to the relaxed limit and f down to the elastic one, at one β.
const LIMITS: &str = "[axes]\nalpha = { from = 1.0, to = inf }\nbeta = [100.0]\nf = { from = 0.0, to = 3.0, scale = \"log\" }\n\
                      [surface]\ntolerance = 1e-3\nquantities = [\"mu_drag\", \"mu_v\", \"mu_h\", \"c\", \"x_outlet\"]\n";

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
fn a_surface_agrees_with_solutions_up_to_its_limits() {
    let directory = tempfile::tempdir().expect("a directory");
    let report = make(LIMITS, directory.path(), 2);
    assert!(report.holds);
    let surface = Surface::read(report.file).expect("readable");
    let certificate = &surface.file().certificate;
    assert_eq!(certificate.points, 1000);
    // The limits cost little: their axes resolve where friction begins to change.
    assert!(certificate.cases < 2000, "{} cases", certificate.cases);
    let mut evaluator = surface.evaluator();
    for (alpha, f) in [(1.0, 0.0), (1.0, 3.0), (f64::INFINITY, 3.0), (f64::INFINITY, 0.0), (2.5, 1.3), (40.0, 0.02)] {
        let values = evaluator.values(&[alpha, f]).expect("inside");
        let expected = solution(&Parameters::new(alpha, 100.0, f));
        let least = [0.0, 1e-3 * expected[0], 0.0, 0.0, 1.0];
        for ((value, expected), least) in values.iter().zip(expected).zip(least) {
            let error = (value - expected).abs() / expected.abs().max(least);
            assert!(error < 1.5e-3, "alpha {alpha}, f {f}: {value} {expected}");
        }
    }
    // 200 points of a seed that nothing was chosen by
    let sweep = SurfaceSweep::parse("test", LIMITS).expect("valid");
    let errors = compare_surface(&sweep, &surface, 200, 77, &SurfaceOptions::default()).expect("compared");
    assert!(errors.iter().all(|errors| errors.largest < 1.5e-3 && errors.median < 5e-4), "{errors:?}");
}

/// A jump is no polynomial. The work on it ends, and what is made says how far it came.
#[test]
fn a_tolerance_that_cannot_be_reached_ends_the_work() {
    let jump = "[axes]\nalpha = { from = 0.01, to = 100.0, scale = \"log\" }\nbeta = [100.0]\nf = [100.0]\n\
                [surface]\ntolerance = 1e-3\nquantities = [\"x_p_max\"]\n";
    let directory = tempfile::tempdir().expect("a directory");
    let report = make(jump, directory.path(), 2);
    assert!(!report.holds);
    let surface = Surface::read(report.file).expect("readable");
    let certificate = &surface.file().certificate;
    assert!(certificate.errors[0].largest > 1e-2, "{certificate:?}");
    assert!(certificate.cases < 4000, "{} cases", certificate.cases);
}

#[test]
fn neither_threads_nor_an_interruption_change_a_byte() {
    let directories = [(); 3].map(|()| tempfile::tempdir().expect("a directory"));
    let bytes = |report: &SurfaceReport| std::fs::read(&report.file).expect("read");
    let first = make(LIMITS, directories[0].path(), 1);
    let second = make(LIMITS, directories[1].path(), 2);
    assert_eq!(bytes(&first), bytes(&second));
    assert!(first.solved > 1000);

    let sweep = SurfaceSweep::parse("test", LIMITS).expect("valid");
    let options = SurfaceOptions::default();
    let interrupt = Arc::clone(&options.interrupt);
    let stopped = build(&sweep, directories[2].path(), &options, &mut |progress| {
        if matches!(progress, Progress::Round { number: 2, .. }) {
            interrupt.request();
        }
    });
    assert!(matches!(stopped, Err(SurfaceBuildError::Interrupted)));
    let resumed = make(LIMITS, directories[2].path(), 2);
    assert_eq!(bytes(&first), bytes(&resumed));
    assert!(resumed.solved < first.solved, "what was solved before the interruption is used");
    let again = make(LIMITS, directories[2].path(), 2);
    assert_eq!((again.solved, bytes(&again)), (0, bytes(&first)));
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
