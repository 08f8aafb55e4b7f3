//! Generated sweep files: valid ones read back, damaged ones are judged.

use proptest::prelude::*;
use stribeck_solver::relaxation::{Acceleration, Domain, Settings};
use stribeck_solver::{CavityShear, FieldSelection, Output, RetardationMode, Substrate};
use stribeck_sweep::{Axes, Field, FieldPrecision, Method, SolverSettings, Sweep};

use crate::sweep_file::with_beta;

/// Strictly ascending values of an axis.
fn ascending(value: impl Strategy<Value = f64>) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(value, 1..6).prop_map(|mut values| {
        values.iter_mut().for_each(|value| *value += 0.0);
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    })
}

fn at_least_zero() -> impl Strategy<Value = f64> {
    prop_oneof![4 => (-300.0..300.0f64).prop_map(|power| 10f64.powf(power)), 1 => Just(0.0)]
}

fn substrate() -> impl Strategy<Value = Substrate> {
    prop::collection::vec((0.01..1.0f64, 1e-6..1e6f64), 1..5).prop_map(|parts| {
        let sum: f64 = parts.iter().map(|(part, _)| part).sum();
        let modes = parts.iter().map(|&(part, time)| RetardationMode { share: part / sum, time }).collect();
        Substrate::new(modes).expect("scaled shares add up to 1")
    })
}

fn solver() -> impl Strategy<Value = SolverSettings> {
    let domain = prop_oneof![
        Just(Domain::Auto),
        (-100.0..-1.001f64, 1.001..100.0f64).prop_map(|(x_min, x_max)| Domain::Fixed { x_min, x_max }),
    ];
    let acceleration = prop_oneof![Just(Acceleration::Anderson), Just(Acceleration::None)];
    let method = prop_oneof![Just(Method::Collocation), Just(Method::Relaxation)];
    let tolerance = (-10.0..-1.0f64).prop_map(|power| 10f64.powf(power));
    let time_limit = prop_oneof![1e-3..1e9f64, Just(f64::INFINITY)];
    (domain, 25usize..=10_000, 1e-12..1e-2f64, acceleration, any::<bool>(), method, tolerance, time_limit).prop_map(
        |(domain, half, residual, acceleration, estimate, method, tolerance, time_limit)| SolverSettings {
            method,
            tolerance,
            time_limit,
            relaxation: Settings {
                domain,
                points: 2 * half + 1,
                tolerance: residual,
                acceleration,
                estimate: estimate && half >= 100,
            },
        },
    )
}

fn output() -> impl Strategy<Value = Output> {
    let shear = prop_oneof![Just(CavityShear::Full), Just(CavityShear::Streamers), Just(CavityShear::None)];
    (any::<[bool; 5]>(), ascending(-1e3..1e3f64), any::<bool>(), shear, any::<bool>()).prop_map(
        |([pressure, film_thickness, displacement, shear, hysteresis], x, limits, cavity_shear, sensitivities)| {
            Output {
                fields: FieldSelection {
                    pressure,
                    film_thickness,
                    displacement,
                    shear_traction: shear,
                    hysteresis_traction: hysteresis,
                },
                x: x.into(),
                limits,
                cavity_shear,
                sensitivities,
            }
        },
    )
}

/// Valid sweeps with the text that says them.
fn sweeps() -> impl Strategy<Value = Sweep> {
    let alpha = ascending(prop_oneof![9 => at_least_zero(), 1 => Just(f64::INFINITY)]);
    let beta = ascending((-300.0..300.0f64).prop_map(|power| 10f64.powf(power)));
    let title = "[a-zA-Zα-ω0-9\"\\\\,= \\[\\]#]{0,30}[a-z]";
    (title, ascending(at_least_zero()), alpha, beta, substrate(), solver(), output(), any::<bool>()).prop_map(
        |(title, f, alpha, beta, substrate, solver, mut output, single)| {
            // the other method has none
            output.sensitivities &= solver.method == Method::Collocation;
            let axes = Axes { slide_roll: None, f, alpha, beta };
            let is_coarse = solver.method == Method::Relaxation || solver.tolerance >= 1e-7;
            let field_precision = if single && is_coarse { FieldPrecision::Single } else { FieldPrecision::Double };
            let (grid, text, name) = (axes.into(), String::new(), "made".into());
            let mut sweep = Sweep { title, grid, substrate, solver, output, field_precision, text, name };
            sweep.text = written(&sweep);
            sweep
        },
    )
}

/// A sweep in TOML, apart from the program's own way of reading it.
fn written(sweep: &Sweep) -> String {
    let Sweep { title, grid, substrate, solver, output, field_precision, .. } = sweep;
    let axes = grid.axes().expect("a dimensionless sweep");
    let title = title.replace('\\', "\\\\").replace('"', "\\\"");
    let modes: Vec<String> = substrate
        .modes()
        .iter()
        .map(|mode| format!("{{ share = {:?}, time = {:?} }}", mode.share, mode.time))
        .collect();
    let relaxation = &solver.relaxation;
    let domain = match relaxation.domain {
        Domain::Auto => "\"auto\"".to_owned(),
        Domain::Fixed { x_min, x_max } => format!("[{x_min:?}, {x_max:?}]"),
    };
    let acceleration = match relaxation.acceleration {
        Acceleration::Anderson => "anderson",
        Acceleration::None => "none",
    };
    format!(
        "title = \"{title}\"\n[axes]\nbeta = {:?}\nf = {:?}\nalpha = {:?}\n[substrate]\nmodes = [{}]\n[output]\n\
         fields = {:?}\nx = {:?}\nfield_precision = \"{}\"\nlimits = {}\ncavity_shear = \"{}\"\nsensitivities = {}\n[solver]\nmethod = \"{}\"\ntolerance = {:?}\ntime_limit = {:?}\n\
         [solver.relaxation]\ndomain = {domain}\npoints = {}\ntolerance = {:?}\nacceleration = \"{acceleration}\"\n\
         estimate = {}\n",
        axes.beta,
        axes.f,
        axes.alpha,
        modes.join(", "),
        Field::selected(output.fields).map(Field::name).collect::<Vec<_>>(),
        output.x,
        if *field_precision == FieldPrecision::Single { "single" } else { "double" },
        output.limits,
        output.cavity_shear,
        output.sensitivities,
        solver.method,
        solver.tolerance,
        solver.time_limit,
        relaxation.points,
        relaxation.tolerance,
        relaxation.estimate,
    )
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::default()
    })]

    #[test]
    fn a_written_sweep_reads_back(sweep in sweeps()) {
        let read = Sweep::parse("made", &sweep.text);
        prop_assert_eq!(read.map_err(|error| error.to_string()), Ok(sweep));
    }

    #[test]
    fn any_text_is_judged_without_panic(text in "\\PC*|\\PC{0,30}[\\x00-\\x1f\\x7f-\\x9f]\\PC{0,30}|[\\[\\]{}=\"'.,#0-9a-z_ \n\r\t-]{0,80}") {
        crate::laws::sweep_file::check(text.as_bytes());
    }

    #[test]
    fn a_damaged_sweep_is_judged_without_panic(
        sweep in sweeps(),
        damages in prop::collection::vec((any::<prop::sample::Index>(), 0usize..4, "[\\[\\]{}=\"'.,#0-9a-zτ_ \n-]{0,3}"), 1..4),
    ) {
        let mut text: Vec<char> = sweep.text.chars().collect();
        for (place, removed, inserted) in damages {
            let start = place.index(text.len());
            let end = (start + removed).min(text.len());
            text.splice(start..end, inserted.chars());
            text.push('\n');
        }
        let text: String = text.into_iter().collect();
        crate::laws::sweep_file::check(text.as_bytes());
    }

    #[test]
    fn ranges_ascend_between_exact_ends(
        from in 1e-9..1e9f64, ratio in 1.001..1e9f64, points in 2usize..400, log in any::<bool>(),
    ) {
        let (to, scale) = (from * ratio, if log { "log" } else { "linear" });
        let read = |points: usize| {
            let range = format!("{{ from = {from:?}, to = {to:?}, points = {points}, scale = \"{scale}\" }}");
            Sweep::parse("range", &with_beta(&range)).expect("valid").grid.axes().expect("dimensionless").beta.clone()
        };
        let values = read(points);
        prop_assert_eq!(values.len(), points);
        prop_assert_eq!((values[0], values[points - 1]), (from, to));
        prop_assert!(values.is_sorted_by(|left, right| left < right));

        // Evenly spaced in its scale.
        let place = |value: f64| if log { value.ln() } else { value };
        let width = place(to) - place(from);
        for (i, &value) in values.iter().enumerate() {
            let expected = place(from) + width * i as f64 / (points - 1) as f64;
            prop_assert!((place(value) - expected).abs() <= 1e-13 * (width.abs() + place(from).abs()));
        }

        // A refined range keeps the points it had, to the last bit.
        for refinement in [2, 3] {
            let finer = read(refinement * (points - 1) + 1);
            prop_assert!(values.iter().enumerate().all(|(i, value)| finer[refinement * i] == *value));
        }
    }
}
