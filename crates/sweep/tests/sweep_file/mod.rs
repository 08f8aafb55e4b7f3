//! Sweep files: what is taken, what is refused, and how the refusal reads.

mod documents;
mod moduli;
mod named_series;
mod refused;
mod round_trip;
mod together;
mod turns;

use std::fs;
use std::path::Path;

use crate::bad_sweeps::{AXES, with_axes, with_beta, with_f};
use crate::laws::sweep_file::drawn;
use stribeck_input::InputError;
use stribeck_solver::collocation;
use stribeck_solver::relaxation::{Acceleration, Domain, Settings};
use stribeck_solver::{CavityShear, FieldSelection, Output, RetardationMode, Substrate};
use stribeck_sweep::{Axes, FieldPrecision, Method, Plan, SolverSettings, SurfaceSweep, Sweep};

#[test]
fn what_is_left_out_has_its_default() {
    let sweep = Sweep::parse("small", AXES).expect("a sweep needs its axes only");
    let expected = Sweep {
        title: "small".into(),
        grid: Axes { slide_roll: None, f: vec![100.0], alpha: vec![1.0], beta: vec![10.0] }.into(),
        substrate: Substrate::default(),
        solver: SolverSettings { method: Method::Collocation, tolerance: 1e-5, ..SolverSettings::default() },
        output: Output::default(),
        field_precision: FieldPrecision::Double,
        text: AXES.into(),
        name: "small".into(),
    };
    assert_eq!(sweep, expected);
    let empty_sections = with_axes("[substrate]\n[solver]\n[solver.relaxation]\n[output]\n");
    assert_eq!(Sweep::parse("small", &empty_sections).expect("sections may be empty").output, expected.output);
}

#[test]
fn every_key_reaches_its_place() {
    let text = r#"
title = "Everything"
[axes]
alpha = [0, 0.5, 1_000, inf]
beta = { from = 10, to = 1000, points = 3, scale = "log" }
f = { from = 0.0, to = 0x64, points = 3 }
[substrate]
modes = [{ share = 0.7, time = 1 }, { share = 0.3, time = 100.0 }]
[solver]
method = "relaxation"
tolerance = 1e-3
time_limit = 90
[solver.relaxation]
domain = [-2, 4.5]
points = 401
tolerance = 1e-6
acceleration = "none"
estimate = true
[output]
fields = ["displacement", "pressure"]
x = [-1, 0.0, 2.5]
limits = false
cavity_shear = "streamers"
sensitivities = false
field_precision = "single"
"#;
    let sweep = Sweep::parse("all", text).expect("valid");
    let modes = vec![RetardationMode { share: 0.7, time: 1.0 }, RetardationMode { share: 0.3, time: 100.0 }];
    let relaxation = Settings {
        domain: Domain::Fixed { x_min: -2.0, x_max: 4.5 },
        points: 401,
        tolerance: 1e-6,
        acceleration: Acceleration::None,
        estimate: true,
    };
    let output = Output {
        fields: FieldSelection { pressure: true, displacement: true, ..FieldSelection::default() },
        x: vec![-1.0, 0.0, 2.5].into(),
        limits: false,
        cavity_shear: CavityShear::Streamers,
        sensitivities: false,
    };
    let axes = Axes {
        slide_roll: None,
        f: vec![0.0, 50.0, 100.0],
        alpha: vec![0.0, 0.5, 1000.0, f64::INFINITY],
        beta: vec![10.0, 100.0, 1000.0],
    };
    let expected = Sweep {
        title: "Everything".into(),
        grid: axes.into(),
        substrate: Substrate::new(modes).expect("valid"),
        solver: SolverSettings { method: Method::Relaxation, tolerance: 1e-3, relaxation, time_limit: 90.0 },
        output,
        field_precision: FieldPrecision::Single,
        text: text.into(),
        name: "all".into(),
    };
    assert_eq!(sweep, expected);
}

#[test]
fn both_methods_have_a_name_and_keep_their_settings_apart() {
    for (method, text) in [(Method::Collocation, "collocation"), (Method::Relaxation, "relaxation")] {
        assert_eq!(method.to_string(), text);
        let rest = format!("[solver]\nmethod = \"{text}\"\ntolerance = 1e-7\n[solver.relaxation]\ntolerance = 1e-9\n");
        let solver = Sweep::parse("method", &with_axes(&rest)).expect("valid").solver;
        assert_eq!((solver.method, solver.tolerance, solver.relaxation.tolerance), (method, 1e-7, 1e-9));
        assert_eq!(solver.collocation(), collocation::Settings { tolerance: 1e-7, ..collocation::Settings::default() });
    }
}

#[test]
fn the_ends_of_the_range_of_tolerances_are_allowed() {
    let (least, most) = collocation::Settings::TOLERANCE.into_inner();
    for tolerance in [least, 1e-5, most] {
        let sweep = Sweep::parse("end", &with_axes(&format!("[solver]\ntolerance = {tolerance:e}\n")));
        assert_eq!(sweep.expect("valid").solver.tolerance, tolerance);
    }
    for tolerance in [least.next_down(), most.next_up(), -1e-5, f64::INFINITY] {
        let sweep = Sweep::parse("beyond", &with_axes(&format!("[solver]\ntolerance = {tolerance:?}\n")));
        assert!(sweep.expect_err("out of range").to_string().contains("must be from 1e-10 to 1e-1"), "{tolerance}");
    }
}

#[test]
fn minus_zero_is_zero() {
    for text in [with_f("[-0.0, 1.0]"), with_f("[-0, 1.0]"), with_f("{ from = -0.0, to = 1.0, points = 2 }")] {
        let sweep = Sweep::parse("zero", &text).expect("valid");
        assert!(sweep.grid.axes().expect("dimensionless").f[0].is_sign_positive(), "{text}");
    }
}

#[test]
fn the_default_x_written_out_is_the_default_x() {
    let text = with_axes("[output]\nx = { from = -3.0, to = 3.0, points = 601 }\n");
    assert_eq!(Sweep::parse("x", &text).expect("valid").output.x, Output::default().x);
}

#[test]
fn log_ranges_hit_whole_decades() {
    let text = with_beta("{ from = 1e-6, to = 1e6, points = 121, scale = \"log\" }");
    let decades = Sweep::parse("decades", &text).expect("valid");
    let beta = &decades.grid.axes().expect("dimensionless").beta;
    let decades = ["1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1", "1e0", "1e1", "1e2", "1e3", "1e4", "1e5", "1e6"];
    for (i, decade) in decades.iter().enumerate() {
        assert_eq!(beta[10 * i], decade.parse::<f64>().expect("a number"));
    }
}

#[test]
fn files_that_are_no_sweep_files() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let path = |name: &str| directory.path().join(name);

    let missing = Sweep::read(path("missing.toml")).expect_err("missing");
    assert!(
        matches!(missing, InputError::Unreadable { .. }) && missing.to_string().contains("missing.toml"),
        "{missing}"
    );
    assert!(missing.remedy().contains("check the path"));

    let no_file = Sweep::read(directory.path()).expect_err("a directory");
    assert!(
        matches!(no_file, InputError::Unreadable { .. }) && no_file.remedy().contains("in that directory"),
        "{no_file} {}",
        no_file.remedy()
    );

    fs::write(path("latin.toml"), b"[axes]\n# \xc3\xa9t\xe9\n").expect("written");
    let latin = Sweep::read(path("latin.toml")).expect_err("not UTF-8");
    assert!(latin.to_string().contains("latin.toml:2:5: the byte 0xe9 is not UTF-8"), "{latin}");
    assert!(!matches!(latin, InputError::Unreadable { .. }) && latin.remedy().contains("UTF-8"));

    let large = path("large.toml");
    fs::write(&large, AXES.to_owned() + &"#\n".repeat(4 << 20)).expect("written");
    let too_large = Sweep::read(&large).expect_err("too large");
    assert!(too_large.to_string().contains("larger than 8 MiB"), "{too_large}");
    assert!(!matches!(too_large, InputError::Unreadable { .. }) && too_large.remedy().contains("{ from"));
    fs::write(&large, AXES.to_owned() + &"#".repeat((8 << 20) - AXES.len())).expect("written");
    assert!(Sweep::read(&large).is_ok(), "8 MiB are allowed");
}

#[test]
fn a_file_gives_name_and_text_and_is_named_in_errors() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let path = directory.path().join("my sweep.v2.toml");
    fs::write(&path, AXES).expect("written");
    let sweep = Sweep::read(&path).expect("valid");
    assert_eq!((sweep.name.as_str(), sweep.title.as_str(), sweep.text.as_str()), ("my sweep.v2", "my sweep.v2", AXES));

    fs::write(&path, with_axes("[output]\nlimits = 1\n")).expect("written");
    let error = Sweep::read(&path).expect_err("wrong type");
    assert!(error.to_string().starts_with(&format!("{}:6:10: ", path.display())), "{error}");
    let InputError::Invalid(invalid) = &error else { panic!("{error}") };
    assert_eq!((invalid.line(), invalid.column()), (6, 10));
}

#[test]
fn windows_lines_and_byte_order_marks_are_taken() {
    let text = format!("\u{feff}{}", AXES.replace('\n', "\r\n"));
    assert_eq!(Sweep::parse("windows", &text).expect("valid").grid.axes().expect("dimensionless").beta, [10.0]);
    let error = Sweep::parse("windows", &(text + "[output]\r\nlimits = 1\r\n")).expect_err("wrong type");
    assert!(error.to_string().starts_with("windows.toml:6:10: "), "{error}");
}

#[test]
fn columns_count_characters_not_bytes() {
    let text = with_axes("[substrate]\nmodes = [{ share = 1.0, time = 1.0, 'Zeit_τ' = 2 }]\n");
    let error = Sweep::parse("greek", &text).expect_err("unknown key");
    assert!(error.to_string().starts_with("greek.toml:6:37: `Zeit_τ`"), "{error}");
    let text = with_axes("[output]\nfields = [\"ττττ\", 5]\n");
    let error = Sweep::parse("greek", &text.replace("\"ττττ\", ", "\"pressure\", # τττ\n")).expect_err("wrong type");
    assert!(error.to_string().starts_with("greek.toml:7:1: "), "{error}");
}

#[test]
fn the_shipped_sweeps_are_valid() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps");
    let mut names = Vec::new();
    for entry in fs::read_dir(&directory).expect("the sweeps are there") {
        let path = entry.expect("readable").path();
        if path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("study-")) {
            continue; // a study file, which tests/study reads
        }
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue; // points at which cases are solved
        }
        if path.ends_with("universe.toml") {
            let surface = SurfaceSweep::read(&path).unwrap_or_else(|error| panic!("{}", drawn(&error)));
            assert_ne!(surface.sweep.title, surface.sweep.name, "a shipped sweep has a title");
            continue; // a surface whose axes no sweep can have
        }
        let sweep = Sweep::read(&path).unwrap_or_else(|error| panic!("{}", drawn(&error)));
        let plan = Plan::new(&sweep);
        let solved: usize = plan.chains().map(|chain| plan.ids(&chain).len()).sum();
        assert_eq!(solved, plan.problems());
        assert_ne!(sweep.title, sweep.name, "a shipped sweep has a title");
        if sweep.name == "quick" {
            assert!(plan.problems() >= 100 && sweep.output.fields == FieldSelection::ALL);
        }
        names.push(sweep.name);
    }
    names.sort();
    assert_eq!(
        names,
        [
            "extreme-alpha",
            "extreme-beta",
            "extreme-f",
            "extreme-stiffness",
            "fig04",
            "fig05",
            "fig07a",
            "fig07b",
            "fig07c",
            "fig08a",
            "fig08b",
            "fig09",
            "fig10a",
            "fig10b",
            "fig11",
            "fig12",
            "fig13",
            "fig14a",
            "fig14b",
            "fig15a",
            "fig15b",
            "fig16",
            "film",
            "gel",
            "hundred-thousand",
            "paper-range",
            "quick",
            "rolling",
            "rubber",
            "six-decades",
            "surface",
            "surface-of-paper",
            "tight-tolerance",
            "two-modes"
        ]
    );
}

#[test]
fn the_worked_example_of_the_documentation_is_valid() {
    let page = include_str!("../../../../docs/reference/sweep-file.md");
    let blocks: Vec<&str> = page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(!blocks.is_empty());
    for block in blocks.into_iter().filter(|block| block.contains("[axes]")) {
        Sweep::parse("documentation", block).unwrap_or_else(|error| panic!("{}", drawn(&error)));
    }
}
