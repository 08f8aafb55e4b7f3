//! `stribeck explain`: what it says of a case is what is stored, what it does again leads to the same bits, and the
//! command it gives solves the same case.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::program::{code, err, out, paths, say, with_results};
use tempfile::{TempDir, tempdir};

const SMALL: &str = r#"
[axes]
f = [0.0, 10.0]
alpha = [1.0, 100.0]
beta = { from = 10.0, to = 100.0, points = 12, scale = "log" }
[output]
fields = []
"#;

/// A directory with a finished sweep in `out`.
fn finished(text: &str) -> TempDir {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("sweep.toml"), text).expect("written");
    let run = say(directory.path(), &["run", "sweep.toml", "-o", "out", "--quiet"]);
    assert!([0, 3].contains(&code(&run)), "{}", err(&run));
    directory
}

fn explain(directory: &Path, case: &str, more: &[&str]) -> String {
    let said = say(directory, &[&["explain", "out", case], more].concat());
    assert_eq!(code(&said), 0, "{case}: {}", err(&said));
    out(&said)
}

/// A text without its line ends, which follow from its width.
fn in_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The rows of the summary, by cells; no cell of these has a comma.
fn rows(directory: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(directory.join("out/summary.csv")).expect("published");
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn every_case_is_explained_with_the_numbers_that_are_stored_and_reached_again_to_the_last_bit() {
    let directory = finished(SMALL);
    let here = directory.path();
    let before = paths(here);
    for row in rows(here).iter().step_by(5) {
        let [case, f, alpha, beta] = [&row[0], &row[1], &row[2], &row[3]];
        let text = explain(here, case, &[]);
        assert!(text.starts_with(&format!("case {case}: converged\n")), "{text}");
        assert!(in_one_line(&text).contains("the same numbers to the last bit"), "{text}");
        for (symbol, cell) in [("mu_v", 6), ("mu_h", 7), ("c", 11)] {
            let number: f64 = row[cell].parse().expect("a number");
            assert!(text.contains(&format!("\n{symbol:<15} {:>14} ", format!("{number:.6e}"))), "{symbol}: {text}");
        }
        for words in ["\nseed ", "\ncost ", "iteration ", "step over solution ", "of the tolerance\n", "  accepted\n"] {
            assert!(text.contains(words), "{words}: {text}");
        }
        // By its place it is the same case, also by numbers that are only near.
        let near = |number: &str| number.parse::<f64>().expect("a number") * 1.01;
        let place = format!("{},{},{}", near(f), near(alpha), near(beta));
        assert_eq!(explain(here, &place, &["--stored"]).lines().next(), text.lines().next());
    }
    assert_eq!(paths(here), before, "explain writes nothing");
}

/// Runs a line as a shell does, with the program on the path.
fn shell(directory: &Path, line: &str) -> serde_json::Value {
    let program = Path::new(env!("CARGO_BIN_EXE_stribeck")).parent().expect("a directory");
    let path = std::env::var("PATH").expect("a path");
    let run = Command::new("sh")
        .args(["-c", &format!("{line} --json")])
        .env("PATH", format!("{}:{path}", program.display()))
        .current_dir(directory)
        .output()
        .expect("sh runs");
    serde_json::from_slice(&run.stdout).unwrap_or_else(|error| panic!("{line}: {error}: {}", err(&run)))
}

#[test]
fn the_command_that_repeats_a_case_solves_the_same_case() {
    let modes = "[substrate]\nmodes = [{ share = 0.7, time = 1.0 }, { share = 0.3, time = 12.5 }]\n";
    let relaxation = "[solver]\nmethod = \"relaxation\"\n[solver.relaxation]\npoints = 201\n";
    let sweeps = [
        SMALL.replace("points = 12", "points = 2").replace("[1.0, 100.0]", "[0.0, 1.0, inf]"),
        format!(
            "{modes}{}",
            SMALL.replace("points = 12", "points = 2").replace("[]", "[]\ncavity_shear = \"streamers\"")
        ),
        format!("{}{relaxation}domain = [-3.5, 4.25]\ntolerance = 1e-7\n", SMALL.replace("points = 12", "points = 2")),
        format!("{}{relaxation}estimate = true\n", SMALL.replace("points = 12", "points = 2")),
    ];
    for sweep in sweeps {
        let directory = finished(&sweep);
        for row in rows(directory.path()) {
            let text = explain(directory.path(), &row[0], &["--stored"]);
            let command = text.lines().find_map(|line| line.strip_prefix("  alone          ")).expect("a command");
            let solved = shell(directory.path(), command);
            assert_eq!(solved["case"].as_str(), Some(row[0].as_str()), "{command}");
            assert_eq!(solved["status"].as_str(), Some(row[4].as_str()), "{command}");
        }
    }
}

#[test]
fn a_failed_case_has_its_reason_and_the_attempts_behind_it() {
    // Too thin a film for so few points.
    let text = SMALL.replace("to = 100.0, points = 12", "to = 1e7, points = 4")
        + "[solver]\nmethod = \"relaxation\"\n[solver.relaxation]\npoints = 101\n";
    let directory = finished(&text);
    let summary = fs::read_to_string(directory.path().join("out/summary.csv")).expect("published");
    let failed = summary.lines().find(|line| line.contains(",failed,")).expect("one fails");
    let text = explain(directory.path(), &failed[..16], &[]);
    assert!(text.contains(": failed\n") && text.contains("\nreason "), "{text}");
    let reason = text.lines().find_map(|line| line.strip_prefix("reason     ")).expect("a reason");
    assert!(summary.contains(reason), "{reason}");
    assert!(text.contains("it fails again\n"), "{text}");
    assert!(text.contains("  not accepted: "), "{text}");
}

#[test]
fn what_is_not_solved_or_not_known_is_said() {
    let directory = finished(SMALL);
    let here = directory.path();
    fs::write(here.join("out/sweep.toml"), SMALL.replace("[1.0, 100.0]", "[1.0, 10.0]")).expect("written");
    let pending = explain(here, "10,10,10", &[]);
    assert!(pending.contains(": not solved yet\n") && pending.contains("`stribeck run` solves it"), "{pending}");
    fs::write(here.join("out/sweep.toml"), format!("{SMALL}[solver]\ntolerance = 1e-6\n")).expect("written");
    let stale = explain(here, "10,1,10", &[]);
    assert!(stale.contains("stale      it is stored, but solved with tolerance 1e-5, now 1e-6\n"), "{stale}");
    // A case of an earlier sweep is told as far as it is known.
    let other = &rows(here)[0][0];
    let text = explain(here, other, &[]);
    assert!(text.contains("has no place in the present sweep.toml") && text.contains("\nseed "), "{text}");
    assert!(!text.contains("solved again"), "{text}");
    let absent = say(here, &["explain", "out", "0123456789abcdef"]);
    assert_eq!(code(&absent), 2);
    assert!(err(&absent).contains("ids stand in the column `case` of summary.csv"), "{}", err(&absent));
}

#[test]
fn a_case_is_named_by_the_values_of_axes_and_the_nearest_one_says_so() {
    const LABORATORY: &str = "\
[laboratory]
radius = \"10 mm\"
load = [300.0, 600.0]
relaxed_modulus = \"1.5 MPa\"
poisson_ratio = 0.5
viscosity = \"80 mPa s\"
retardation_time = \"5 ms\"
speed = [0.01, 0.1]
f = 3.0
[output]
fields = []
";
    let results = with_results(LABORATORY);
    let explained = |case: &str| say(results.path(), &["explain", "results/small", case, "--stored"]);
    let exact = explained("speed=0.1,load=600");
    assert_eq!(code(&exact), 0, "{}", err(&exact));
    assert!(out(&exact).contains("load = 600 N/m") && !out(&exact).contains("the nearest one"), "{}", out(&exact));
    let near = explained("load=580,speed=0.02");
    assert!(out(&near).contains("the nearest one to load = 580, speed = 0.02, which is no place of the sweep"));
    assert!(out(&near).contains("load = 600 N/m") && out(&near).contains("speed = 0.01 m/s"), "{}", out(&near));
    let end = explained("speed=0,load=600");
    assert!(out(&end).contains("load = 600 N/m"), "an end that is far from all hides nothing: {}", out(&end));
    assert_eq!(code(&explained("speed=nan")), 2);
    let unknown = explained("colour=1");
    assert_eq!(code(&unknown), 2, "{}", err(&unknown));
    assert!(err(&unknown).contains("the sweep has no axis \"colour\""), "{}", err(&unknown));
}
