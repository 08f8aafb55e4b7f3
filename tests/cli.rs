//! The program from outside: help, exit codes, messages, and what each command says and leaves alone.

use std::fs;
use std::path::Path;
use std::process::Stdio;

use crate::program::{code, err, out, paths, say, stribeck};
use stribeck_solver::collocation::{self, CollocationSolver};
use stribeck_solver::continuation::{CaseSolver, Interrupt, solve_chain};
use stribeck_solver::relaxation::{RelaxationSolver, Settings};
use stribeck_solver::{Output, Parameters, Sensitivities};
use stribeck_sweep::{Column, Values};
use tempfile::{TempDir, tempdir};

/// Three rows, the elastic one at two places.
const SMALL: &str = r#"
[axes]
f = [0.0, 10.0]
alpha = [1.0, 100.0]
beta = [10.0, 20.0, 40.0]
[output]
fields = ["pressure"]
x = { from = -2.0, to = 2.0, points = 41 }
"#;

/// The words of a message, however it is broken into lines and framed.
fn words(message: &str) -> String {
    message
        .split(|c: char| c.is_whitespace() || "│×╰─▶".contains(c))
        .filter(|word| !word.is_empty())
        .collect::<Vec<_>>()
        .join(" ")
}

/// A directory with a sweep file in it.
fn with_sweep(text: &str) -> TempDir {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("small.toml"), text).expect("written");
    directory
}

/// A directory with a finished sweep in `results/small`.
fn finished() -> TempDir {
    let directory = with_sweep(SMALL);
    let run = say(directory.path(), &["run", "small.toml", "--quiet"]);
    assert_eq!(code(&run), 0, "{}", err(&run));
    assert_eq!(err(&run), "", "--quiet is quiet");
    directory
}

#[test]
fn every_help_text_has_an_example() {
    let directory = tempdir().expect("a temporary directory");
    for command in stribeck::commands::GROUPS.iter().flat_map(|(_, names)| *names).copied() {
        let help = say(directory.path(), &[command, "--help"]);
        assert_eq!(code(&help), 0);
        assert!(out(&help).contains(&format!("\n  stribeck {command} ")), "{}", out(&help));
        assert_eq!(out(&say(directory.path(), &["help", command])), out(&help));
    }
    let help = out(&say(directory.path(), &["--help"]));
    for line in ["  stribeck run mine.toml", "Exit codes: 0 all cases converged", "130 interrupted"] {
        assert!(help.contains(line), "{help}");
    }
}

#[test]
fn bad_sweep_files_end_with_2_place_and_remedy_and_write_nothing() {
    let directory = tempdir().expect("a temporary directory");
    let table = crate::bad_sweeps::bad_files();
    assert!(table.len() >= 25);
    for (text, place, message, remedy) in table {
        fs::write(directory.path().join("bad.toml"), &text).expect("written");
        for command in ["run", "plan"] {
            let output = say(directory.path(), &[command, "bad.toml", "-o", "out"]);
            let said = words(&err(&output));
            assert_eq!(code(&output), 2, "{text}\n{said}");
            assert!(said.contains(&format!("bad.toml:{place}: ")), "{text}\n{said}");
            assert!(said.contains(&words(message)) && said.contains(&words(remedy)), "{text}\n{said}");
            assert_eq!(out(&output), "");
        }
        assert_eq!(paths(directory.path()), [directory.path().join("bad.toml").display().to_string()], "{text}");
    }
}

#[test]
fn bad_command_lines_end_with_2_and_say_what_is_allowed() {
    let directory = with_sweep(SMALL);
    let case = |more: &'static str| [vec!["solve", "--f", "10"], more.split(' ').collect()].concat();
    let rows = [
        (vec![], "Usage"),
        (vec!["guess"], "unrecognized subcommand"),
        (vec!["run", "small.toml", "--part", "9/8"], "give I/N, the I-th of N parts"),
        (vec!["run", "small.toml", "--part", "3"], "give I/N, the I-th of N parts"),
        (vec!["merge"], "<DIR>"),
        (vec!["merge", "one", "two"], "give -o DIR"),
        (vec!["slurm", "small.toml"], "--tasks <N>"),
        (vec!["slurm", "small.toml", "--tasks", "0"], "0 is not in 1..=1000000"),
        (vec!["slurm", "small.toml", "--tasks", "2", "--cpus", "0"], "invalid value '0'"),
        (vec!["slurm", "small.toml", "--tasks", "2", "--time", "2h"], "hours:minutes:seconds or days-hours"),
        (vec!["slurm", "small.toml", "--tasks", "2", "--time", "4"], "leaves a part no time to work"),
        (vec!["slurm", "small.toml", "--tasks", "2", "--sbatch", "hold"], "an option of sbatch"),
        (
            vec!["slurm", "small.toml", "--tasks", "2", "--sbatch=--array=1-9%2"],
            "--array is set by `stribeck slurm` itself",
        ),
        (vec!["slurm", "small.toml", "--tasks", "2", "--sbatch", "--no-requeue"], "--no-requeue is set by"),
        (vec!["slurm", "small.toml", "--tasks", "2", "--sbatch=-dafter:7"], "-d is set by"),
        (vec!["slurm", "small.toml", "--tasks", "2", "--sbatch=-t4"], "-t is set by"),
        (vec!["slurm", "small.toml", "--tasks", "2", "--sbatch=--time=4"], "--time is set by"),
        (vec!["slurm", "small.toml", "--tasks", "2", "--setup", "a\nb"], "one line"),
        (vec!["slurm", "small.toml", "--tasks", "2", "-o", "10%"], "cannot write logs below"),
        (vec!["slurm", "absent.toml", "--tasks", "2"], "check the path"),
        (vec!["explain", "results"], "<CASE>"),
        (vec!["explain", "results", "100,1"], "as in 100,1,1000"),
        (vec!["explain", "results", "-1,1,10"], "as in 100,1,1000"),
        (vec!["explain", "results", "12ab"], "16 hexadecimal digits"),
        (vec!["run"], "<SWEEP>"),
        (vec!["run", "absent.toml"], "check the path"),
        (vec!["run", "small.toml", "--threads", "0"], "from 1 to 1024"),
        (vec!["run", "small.toml", "--threads", "100000"], "from 1 to 1024"),
        (vec!["plan", "small.toml", "--threads", "two"], "from 1 to 1024"),
        (case("--alpha -1 --beta 10"), "at least 0, or inf"),
        (case("--alpha nan --beta 10"), "at least 0, or inf"),
        (case("--alpha 1 --beta 0"), "finite number above 0"),
        (case("--alpha 1 --beta inf"), "finite number above 0"),
        (case("--alpha 1 --beta ten"), "finite number above 0"),
        (case("--alpha 1 --beta 10 --points 800"), "odd whole number"),
        (case("--alpha 1 --beta 10 --points 49"), "odd whole number from 51"),
        (case("--alpha 1 --beta 10 --tolerance 0"), "a number above 0"),
        (case("--alpha 1 --beta 10 --tolerance nan"), "a number above 0"),
        (
            case("--alpha 1 --beta 10 --tolerance 1e-11"),
            "relative error wanted in mu_v, mu_h and c; give a number from",
        ),
        (case("--alpha 1 --beta 10 --tolerance 0.2"), "from 1e-10 to 1e-1, not 0.2"),
        (case("--alpha 1 --beta 10 --method relaxation --tolerance 0.02"), "the residual at which"),
        (case("--alpha 1 --beta 10 --method relaxation --tolerance 1e-13"), "from 1e-12 to 1e-2"),
        (case("--alpha 1 --beta 10 --method newton"), "collocation or relaxation"),
        (case("--alpha 1 --beta 10 --points 801"), "--points is an option of the relaxation method; leave it out"),
        (case("--alpha 1 --beta 10 --acceleration none"), "--acceleration is an option of the relaxation method"),
        (case("--alpha 1 --beta 10 --estimate true"), "or add --method relaxation"),
        (case("--alpha 1 --beta 10 --method relaxation --acceleration fast"), "anderson or none"),
        (case("--alpha 1 --beta 10 --method relaxation --points 199 --estimate true"), "or --estimate false"),
        (case("--alpha 1 --beta 10 --method relaxation --estimate maybe"), "true, false"),
        (case("--alpha 1 --beta 10 --domain -3,4"), "--domain is an option of the relaxation method"),
        (case("--alpha 1 --beta 10 --method relaxation --domain 3,4"), "on both sides of 0, from -100 to 100"),
        (case("--alpha 1 --beta 10 --modes 1"), "SHARE:TIME"),
        (case("--alpha 1 --beta 10 --modes 0.5:1,0.4:2"), "add up to 1, not 0.9"),
        (case("--alpha 1 --beta 10 --modes 1:nan"), "finite number above 0"),
        (case("--alpha 1 --beta 10 --cavity-shear half"), "full, streamers or none"),
        (case("--alpha 1 --beta 10 --method relaxation --sensitivities"), "has no derivatives of friction"),
        (case("--alpha 1 --beta 10 --time-limit 0"), "above 0, or inf"),
        (vec!["solve", "--alpha", "1", "--beta", "10", "--f", "inf"], "at least 0; 0 is an elastic"),
        (vec!["solve", "--alpha", "1", "--beta", "10"], "--f <F>"),
    ];
    for (arguments, remedy) in rows {
        let output = say(directory.path(), &arguments);
        assert_eq!(code(&output), 2, "{arguments:?}\n{}", err(&output));
        assert!(err(&output).contains(remedy), "{arguments:?}\n{}", err(&output));
    }
    assert_eq!(paths(directory.path()).len(), 1, "nothing is written");
}

#[test]
fn what_is_wrong_with_a_directory_ends_with_4_and_says_what_to_do() {
    let directory = with_sweep(SMALL);
    fs::write(directory.path().join("file"), "").expect("written");
    fs::create_dir(directory.path().join("theirs")).expect("created");
    fs::write(directory.path().join("theirs/summary.csv"), "").expect("written");
    let rows = [
        (vec!["run", "small.toml", "-o", "file"], "choose another place with -o"),
        (vec!["plan", "small.toml", "-o", "file"], "choose another place with -o"),
        (vec!["run", "small.toml", "-o", "/proc/results"], "check"),
        (vec!["run", "small.toml", "-o", "file/below"], "check"),
        (vec!["run", "small.toml", "-o", "theirs"], "choose another directory with -o"),
        (vec!["plan", "small.toml", "-o", "theirs"], "choose another directory with -o"),
        (vec!["run", "small.toml", "-o", "theirs", "--part", "1/2"], "choose another directory with -o"),
        (vec!["slurm", "small.toml", "-o", "theirs", "--tasks", "2"], "choose another directory with -o"),
        (vec!["status", "absent"], "give the directory that `stribeck run` wrote"),
        (vec!["status", "file"], "give the directory that `stribeck run` wrote"),
        (vec!["verify", "."], "give the directory that `stribeck run` wrote"),
    ];
    for (arguments, remedy) in rows {
        let output = say(directory.path(), &arguments);
        assert_eq!(code(&output), 4, "{arguments:?}\n{}", err(&output));
        assert!(err(&output).starts_with("error: ") && err(&output).contains(remedy), "{}", err(&output));
    }
}

#[test]
fn a_finished_sweep_from_plan_to_verify() {
    let directory = with_sweep(SMALL);
    let here = directory.path();
    let before = paths(here);
    let plan = say(here, &["plan", "small.toml", "--threads", "2"]);
    assert_eq!(code(&plan), 0, "{}", err(&plan));
    assert!(out(&plan).contains("12 = 2 f x 2 alpha x 3 beta"), "{}", out(&plan));
    assert!(out(&plan).contains("9 distinct, in 3 chains"), "{}", out(&plan));
    assert!(out(&plan).contains("0 reused, 9 new, 0 failed before"), "{}", out(&plan));
    assert_eq!(paths(here), before, "plan writes nothing");

    let run = say(here, &["run", "small.toml"]);
    assert_eq!(code(&run), 0, "{}", err(&run));
    assert!(out(&run).starts_with("12 cases: 12 converged, 0 failed\nsolved 9 cases in "), "{}", out(&run));
    assert!(out(&run).contains("results in results/small: results.h5, summary.csv, timings.csv"), "{}", out(&run));
    assert!(err(&run).contains("9 of 9 cases"), "progress ends with a line: {}", err(&run));
    let summary = fs::read_to_string(here.join("results/small/summary.csv")).expect("published");
    assert_eq!(summary.lines().count(), 13);

    let after = paths(here);
    let plan = say(here, &["plan", "small.toml"]);
    assert!(out(&plan).contains("9 reused, 0 new, 0 failed before"), "{}", out(&plan));
    let status = say(here, &["status", "results/small"]);
    assert_eq!(code(&status), 0, "{}", err(&status));
    for line in [
        "planned    9 cases, at 12 places",
        "converged  9\n",
        "failed     0\n",
        "to do      0\n",
        "all cases were tried",
        "9 of 9 cases in",
        ", completed\n",
    ] {
        assert!(out(&status).contains(line), "{line}\n{}", out(&status));
    }
    assert!(!out(&status).contains("not yet published") && !out(&status).contains("0.00 s"), "{}", out(&status));
    let (there, away) = (here.join("results/small/summary.csv"), here.join("away.csv"));
    fs::rename(&there, &away).expect("moved");
    let unpublished = out(&say(here, &["status", "results/small"]));
    assert!(unpublished.contains("all cases were tried, but not yet published; run it again"), "{unpublished}");
    fs::rename(&away, &there).expect("moved back");
    let verify = say(here, &["verify", "results/small"]);
    assert_eq!(code(&verify), 0, "{}", out(&verify));
    let shards = paths(here).iter().filter(|path| path.contains("/shards/")).count();
    let shards = if shards == 1 { "1 shard".to_owned() } else { format!("{shards} shards") };
    assert!(out(&verify).starts_with(&format!("read {shards} with 9 cases, ")), "{}", out(&verify));
    assert!(out(&verify).ends_with("3 published files as written\nsound\n"), "{}", out(&verify));
    assert_eq!(paths(here), after, "plan, status and verify write nothing");
}

#[test]
fn a_flipped_byte_is_found_and_repaired_by_the_next_run() {
    let directory = finished();
    let results = directory.path().join("results/small");
    let published = fs::read(results.join("results.h5")).expect("published");
    for name in paths(&results).into_iter().filter(|name| name.ends_with(".h5")) {
        let whole = fs::read(&name).expect("read");
        let mut bytes = whole.clone();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        fs::write(&name, &bytes).expect("written");
        let verify = say(directory.path(), &["verify", "results/small"]);
        assert_eq!(code(&verify), 4, "{}", out(&verify));
        assert!(
            out(&verify).contains(&format!("{}: its checksum", name.rsplit_once("results/small/").expect("below").1)),
            "{}",
            out(&verify)
        );
        let remedy = match name.contains("shards") {
            true => "run the sweep that its cases are of again: they are solved anew",
            false => "run the sweep again: it is rebuilt from the shards",
        };
        assert!(out(&verify).contains(remedy) && out(&verify).contains("1 problem found"), "{}", out(&verify));
        // What is told of a directory is what the next run will find; a quick look sees sizes alone.
        let told = |command: &[&str]| out(&say(directory.path(), command));
        let (status, plan) = (told(&["status", "results/small"]), told(&["plan", "small.toml"]));
        if name.contains("shards") {
            assert!(!status.contains("\nto do      0\n") && !plan.contains(" 0 new"), "{status}{plan}");
        } else {
            assert!(status.contains("not yet published"), "{status}");
        }
        let quick = [told(&["status", "--quick", "results/small"]), told(&["plan", "--quick", "small.toml"])];
        assert!(quick[0].contains("stopped, all cases were tried\n"), "{}", quick[0]);
        assert!(quick[1].contains("9 reused, 0 new"), "{}", quick[1]);
        if name.contains("shards") {
            let run = say(directory.path(), &["run", "small.toml", "--quiet"]);
            assert_eq!(code(&run), 0, "{}", err(&run));
            assert!(err(&run).contains("warning: ") && err(&run).contains(" cases are not used"), "{}", err(&run));
        } else {
            let run = say(directory.path(), &["run", "small.toml", "--quiet"]);
            assert!(out(&run).contains("nothing to solve; published again"), "{}", out(&run));
        }
        // Cases solved again may be stored in other company, which leaves the damaged shard as it is, of no use.
        let verify = say(directory.path(), &["verify", "results/small"]);
        assert_eq!(code(&verify), 0, "{}", out(&verify));
        let below = name.rsplit_once("results/small/").expect("below").1;
        let replaced = out(&verify).contains(&format!("{below}: damaged, and its cases solved again"));
        assert!(replaced != (fs::read(&name).expect("read") == whole), "{}", out(&verify));
        let run = say(directory.path(), &["run", "small.toml", "--quiet"]);
        assert!(out(&run).contains("nothing to do") && err(&run).is_empty(), "{}{}", out(&run), err(&run));
    }
    assert!(fs::read(results.join("results.h5")).expect("published") == published);
}

#[test]
fn cases_that_fail_end_with_3_and_are_told() {
    // The uniform grid neither holds the wide contact nor resolves the thin film.
    let solver =
        "[solver]\nmethod = \"relaxation\"\n[solver.relaxation]\npoints = 101\ndomain = [-3.0, 1.05]\n[output]";
    let text = SMALL.replace("[output]", solver).replace("[0.0, 10.0]", "[0.0, 1e-3]");
    let text = text.replace("beta = [10.0, 20.0, 40.0]", "beta = [10.0, 3e9]");
    let directory = with_sweep(&text);
    let here = directory.path();
    let run = say(here, &["run", "small.toml", "--quiet"]);
    assert_eq!(code(&run), 3, "{}\n{}", out(&run), err(&run));
    assert!(out(&run).contains("f = 0, beta = 3000000000: "), "{}", out(&run));
    assert!(out(&run).contains("results/small/summary.csv, columns `status` and `reason`"), "{}", out(&run));
    let summary = fs::read_to_string(here.join("results/small/summary.csv")).expect("published");
    let failed = summary.lines().filter(|row| row.contains(",failed,")).count();
    assert!(failed > 0 && out(&run).contains(&format!(" {failed} failed\n")), "{}", out(&run));

    let again = say(here, &["run", "small.toml", "--quiet"]);
    assert_eq!(code(&again), 3, "nothing to do, and still not all converged");
    assert!(out(&again).contains("nothing to do"), "{}", out(&again));
    let plan = out(&say(here, &["plan", "small.toml"]));
    assert!(plan.contains("0 new") && !plan.contains("0 failed before"), "{plan}");
    let status = out(&say(here, &["status", "results/small"]));
    assert!(status.contains("failures by region") && status.contains("beta 1e9 to 1e10: "), "{status}");
}

#[test]
fn another_sweep_in_the_same_directory_is_told() {
    let directory = finished();
    fs::write(directory.path().join("other.toml"), SMALL.replace("40.0]", "40.0, 80.0]")).expect("written");
    let plan = out(&say(directory.path(), &["plan", "other.toml", "-o", "results/small"]));
    assert!(plan.contains("last run with another sweep file") && plan.contains("9 reused, 3 new"), "{plan}");
    let run = say(directory.path(), &["run", "other.toml", "-o", "results/small", "--quiet"]);
    assert_eq!(code(&run), 0, "{}", err(&run));
    assert!(err(&run).contains("Of the 12 cases of this one 9 are there and used again, 3 are new"), "{}", err(&run));
    let again = say(directory.path(), &["run", "other.toml", "-o", "results/small", "--quiet"]);
    assert_eq!(err(&again), "");
}

/// Seconds, iterations and factorisations of each row of `timings.csv`.
fn timings(results: &Path) -> Vec<[f64; 3]> {
    let table = fs::read_to_string(results.join("timings.csv")).expect("published");
    let mut lines = table.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let places = ["seconds", "iterations", "factorisations"]
        .map(|name| header.iter().position(|column| *column == name).expect("a column"));
    let row = |line: &str| {
        let values: Vec<&str> = line.split(',').collect();
        places.map(|place| values[place].parse().expect("a number"))
    };
    lines.map(row).collect()
}

#[test]
fn errors_and_effort_of_every_case_are_published() {
    let directory = with_sweep(&SMALL.replace("[output]", "[solver]\ntolerance = 1e-6\n[output]"));
    let here = directory.path();
    assert_eq!(code(&say(here, &["run", "small.toml", "--quiet"])), 0);
    let summary = fs::read_to_string(here.join("results/small/summary.csv")).expect("published");
    let mut lines = summary.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let errors: Vec<usize> = (0..header.len()).filter(|&i| header[i].starts_with("error_")).collect();
    assert_eq!(errors.len(), 4);
    for line in lines {
        for &place in &errors {
            let error: f64 = line.split(',').nth(place).and_then(|text| text.parse().ok()).expect("an estimate");
            assert!((0.0..=1e-6).contains(&error), "{line}");
        }
    }
    for [seconds, iterations, factorisations] in timings(&here.join("results/small")) {
        assert!(seconds > 0.0 && iterations >= 1.0);
        // At least one of the estimate; a chord step needs none of its own, and an estimate is no iteration.
        assert!(factorisations >= 1.0, "{iterations} iterations, {factorisations} factorisations");
    }
}

#[test]
fn what_is_expected_is_about_what_comes() {
    let text = SMALL
        .replace("points = 41", "points = 301")
        .replace("[10.0, 20.0, 40.0]", "{ from = 10.0, to = 100.0, points = 30 }");
    let directory = with_sweep(&text);
    // Other programs may be at work now and not then, which a median feels less than a mean.
    let median = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let plans: Vec<String> = (0..5).map(|_| out(&say(directory.path(), &["plan", "small.toml"]))).collect();
    let plan = &plans[0];
    let line = plan.lines().find(|line| line.starts_with("disk ")).expect("plan tells bytes");
    let sizes: Vec<f64> = line
        .split_once("about ")
        .expect("sizes")
        .1
        .split(", ")
        .map(|part| {
            let mut words = part.split(' ');
            let number: f64 = words.next().and_then(|word| word.parse().ok()).expect("a number");
            number
                * match words.next() {
                    Some("kB") => 1e3,
                    Some("MB") => 1e6,
                    unit => panic!("{unit:?} in {line}"),
                }
        })
        .collect();
    assert_eq!(code(&say(directory.path(), &["run", "small.toml", "--quiet"])), 0);
    let results = directory.path().join("results/small");
    let per_case = |plan: &String| -> f64 {
        let time = plan.lines().find(|line| line.starts_with("time ")).expect("plan tells time");
        let number = time.split_once("; ").and_then(|(_, rest)| rest.split_once(" ms per case")).expect("of a case").0;
        number.parse().expect("a number")
    };
    let expected = median(plans.iter().map(per_case).collect());
    let took = 1e3 * median(timings(&results).iter().map(|row| row[0]).collect());
    assert!((expected / took).ln().abs() < 8_f64.ln(), "expected {expected} ms a case, took {took}");
    let size = |place: &str| -> f64 {
        let path = results.join(place);
        let files = if path.is_dir() { paths(&path) } else { vec![path.display().to_string()] };
        files.iter().map(|file| fs::metadata(file).expect("there").len() as f64).sum()
    };
    let stored = size("shards") + size("log");
    let published = size("results.h5") + size("summary.csv") + size("timings.csv");
    for (expected, real) in [(sizes[0], stored), (sizes[1], published)] {
        assert!((expected / real).ln().abs() < 0.25, "expected {expected}, came {real}; {line}");
    }
}

/// The object that `solve --json` prints.
fn solved_json(arguments: &str) -> serde_json::Value {
    let directory = tempdir().expect("a temporary directory");
    let arguments: Vec<&str> = ["solve"].into_iter().chain(arguments.split_whitespace()).chain(["--json"]).collect();
    let solve = say(directory.path(), &arguments);
    assert_eq!(code(&solve), 0, "{}", err(&solve));
    serde_json::from_str(&out(&solve)).expect("JSON")
}

/// Whether an object of `solve --json` says what the library gives for the same case.
fn assert_is_of_the_library<S: CaseSolver>(object: &serde_json::Value, solver: &S, parameters: Parameters) {
    let limits = stribeck_solver::exact::limits(&parameters);
    let solved = solve_chain(solver, &[parameters], &stribeck_solver::Output::default(), &Interrupt::new());
    let case = solved.expect("not interrupted").remove(0);
    let solution = case.outcome.expect("converged");
    let values = Values::converged(&solution.quantities, &solution.errors, &limits);
    for column in Column::summary() {
        let (name, value) = (column.name(), values[column]);
        assert_eq!(object[name].as_f64().map(f64::to_bits), Some(value.to_bits()), "{name}");
    }
    assert_eq!(object["seed"], case.seed.to_string());
    assert_eq!(object["iterations"], case.effort.iterations);
    assert_eq!(object["factorisations"], case.effort.factorisations);
    assert_eq!(object["unknowns"], case.effort.unknowns);
    assert!(object["seconds"].as_f64().is_some_and(|seconds| seconds > 0.0));
    assert_eq!((&object["status"], &object["reason"]), (&"converged".into(), &serde_json::Value::Null));
    let path = object["path"].as_array().expect("an array");
    assert_eq!(path.len(), case.path.points.len());
    for (shown, point) in path.iter().zip(&case.path.points) {
        let numbers = ["alpha", "beta", "f"].map(|name| shown[name].as_f64().map(f64::to_bits));
        assert_eq!(numbers, [point.alpha, point.beta, point.f].map(|value| Some(value.to_bits())));
        assert_eq!((&shown["iterations"], &shown["accepted"]), (&point.iterations.into(), &point.accepted.into()));
    }
    let keys: Vec<&str> = object.as_object().expect("an object").keys().map(String::as_str).collect();
    let mut header: Vec<&str> =
        "case,f,alpha,beta,status,reason,mu_v,mu_h,mu_tot,mu_drag,mu_h_cavity,c,film_min,p_max,x_outlet,\
         error_mu_v,error_mu_h,error_c,load_residual,dry_mu_v,approx_mu_h,mu_pressure,mu_shear,mu_v_flat,mu_v_roller,\
         mu_torque,energy_residual,error_mu_drag,slide_roll,seed,path,iterations,factorisations,unknowns,seconds"
            .split(',')
            .collect();
    header.sort_unstable();
    assert_eq!(keys, header);
}

#[test]
fn one_case_is_what_the_library_solves() {
    let parameters = || Parameters::new(2.0, 50.0, 10.0);
    let by_collocation = solved_json("--alpha 2 --beta 50 --f 10 --tolerance 1e-6");
    let settings = collocation::Settings { tolerance: 1e-6, ..collocation::Settings::default() };
    assert_is_of_the_library(&by_collocation, &CollocationSolver::new(settings), parameters());
    assert!(
        by_collocation["path"].as_array().expect("an array").is_empty(),
        "the table leads to a single case at once"
    );

    let by_relaxation = solved_json("--alpha 2 --beta 50 --f 10 --method relaxation --points 201");
    let settings = Settings { points: 201, estimate: true, ..Settings::default() };
    assert_is_of_the_library(&by_relaxation, &RelaxationSolver::new(settings), parameters());

    // The two discretise the same problem: they agree within what each says of itself.
    for (name, error) in [("mu_v", "error_mu_v"), ("mu_h", "error_mu_h"), ("c", "error_c")] {
        let value = |object: &serde_json::Value, name: &str| object[name].as_f64().expect("a number");
        let (exact, coarse) = (value(&by_collocation, name), value(&by_relaxation, name));
        let allowed = 3.0 * (value(&by_relaxation, error) + value(&by_collocation, error));
        assert!((coarse / exact - 1.0).abs() < allowed, "{name}: {coarse} and {exact}, {allowed:.1e}");
    }
}

#[test]
fn sensitivities_are_shown_where_they_are_asked_for() {
    let case = "--alpha 1 --beta 300 --f 100";
    let object = solved_json(&format!("{case} --sensitivities"));
    let plain = solved_json(case);
    let output = Output { sensitivities: true, ..Output::default() };
    let solver = CollocationSolver::new(collocation::Settings::default());
    let solved = solve_chain(&solver, &[Parameters::new(1.0, 300.0, 100.0)], &output, &Interrupt::new());
    let solution = solved.expect("not interrupted").remove(0).outcome.expect("solved");
    let known = solution.sensitivities.expect("asked for");
    for (name, value) in Sensitivities::NAMES.into_iter().zip(known.named()) {
        assert_eq!(object[name].as_f64(), Some(value), "{name}");
        assert!(plain.get(name).is_none());
    }
    let errors = solution.sensitivity_errors.expect("asked for");
    for (name, error) in Sensitivities::NAMES.into_iter().zip(errors.named()) {
        assert_eq!(object["sensitivity_errors"][name].as_f64(), Some(error), "{name}");
    }
    let directory = tempdir().expect("a temporary directory");
    let arguments = format!("solve {case} --sensitivities");
    let table = out(&say(directory.path(), &arguments.split_whitespace().collect::<Vec<_>>()));
    let shown = [known.viscoelastic(), known.hydrodynamic, known.total_at(1.0), known.drag_at(1.0)];
    for value in shown.map(Sensitivities::of_case).into_iter().flatten() {
        assert!(table.contains(&format!("{value:.6e}")), "{table}");
    }
}

#[test]
fn the_tolerance_asked_for_bounds_the_errors_shown() {
    for tolerance in ["1e-3", "1e-5", "1e-8"] {
        let object = solved_json(&format!("--alpha 1 --beta 300 --f 100 --tolerance {tolerance}"));
        let most: f64 = tolerance.parse().expect("a number");
        for error in ["error_mu_v", "error_mu_h", "error_c"] {
            let error = object[error].as_f64().expect("collocation estimates its errors");
            assert!((0.0..=most).contains(&error), "{tolerance}: {error:e}");
        }
    }
}

#[test]
fn one_case_as_a_table_has_the_same_numbers_and_no_estimate_is_null() {
    let directory = tempdir().expect("a temporary directory");
    let case = "--alpha inf --beta 50 --f 10";
    let of_relaxation = "--method relaxation --points 201";
    let rows: [(&str, &str, bool, &[&str]); 2] = [
        (
            "",
            "",
            true,
            &["collocation, tolerance 1e-5", "seed table", " iterations, ", " factorisation, ", " unknowns\n"],
        ),
        (of_relaxation, " --estimate false", false, &["relaxation, 201 points", "seed hertz, ", " passes, "]),
    ];
    for (more, for_json, estimated, words) in rows {
        let arguments = format!("solve {case} {more}");
        let table = out(&say(directory.path(), &arguments.split_whitespace().collect::<Vec<_>>()));
        let object = solved_json(&format!("{case} {more}{for_json}"));
        assert_eq!(object["alpha"], "inf");
        assert_eq!(object["error_c"].is_number(), estimated);
        for (symbol, limit) in [("mu_h", Some("approx_mu_h")), ("c", None), ("p_max", None)] {
            let row = table.lines().find(|line| line.starts_with(&format!("{symbol} "))).expect("a row");
            let shown = |name: &str| format!("{:.6e}", object[name].as_f64().expect("a number"));
            assert!(row.contains(&shown(symbol)), "{table}");
            assert!(limit.is_none_or(|limit| row.contains(&shown(limit))), "{table}");
        }
        for word in words.iter().chain(&["elastic: depends on beta alone", "estimated relative error"]) {
            assert!(table.contains(word), "{word}: {table}");
        }
        // A line for each point that was solved on the way.
        let points = object["path"].as_array().expect("an array").len();
        let shown = table.lines().skip_while(|line| !line.starts_with("by way of")).skip(1);
        assert_eq!(shown.take_while(|line| !line.is_empty()).count(), points, "{table}");
    }
}

#[test]
fn a_case_that_fails_ends_with_3_and_has_its_reason() {
    let directory = tempdir().expect("a temporary directory");
    let case = ["solve", "--alpha", "1", "--beta", "3e9", "--f", "10", "--method", "relaxation", "--points", "51"];
    let table = say(directory.path(), &case);
    assert_eq!(code(&table), 3, "{}", out(&table));
    assert!(err(&table).contains("no errors are estimated; that takes 201 points"), "{}", err(&table));
    for (name, shown) in [("dry_mu_v ", true), ("approx_mu_h ", true), ("p_max ", false)] {
        assert_eq!(out(&table).contains(&format!("\n{name}")), shown, "{name}: {}", out(&table));
    }
    assert!(out(&table).starts_with("f = 10, alpha = 1, beta = 3000000000: failed\n"), "{}", out(&table));
    let json = say(directory.path(), &[&case[..], &["--json"]].concat());
    assert_eq!(code(&json), 3);
    let object: serde_json::Value = serde_json::from_str(&out(&json)).expect("JSON");
    assert_eq!(object["status"], "failed");
    assert!(object["mu_v"].is_null() && object["dry_mu_v"].is_number());
    assert!(object["reason"].as_str().is_some_and(|reason| words(&out(&table)).contains(&words(reason))));
}

#[cfg(unix)]
#[test]
fn a_disk_that_takes_no_more_ends_with_4_and_the_command_that_resumes() {
    let text = SMALL.replace("points = 41", "points = 6001");
    let directory = with_sweep(&text);
    // At most 50 kB a file: enough for the log, too little for a shard.
    let limited = std::process::Command::new("sh")
        .args(["-c", "trap '' XFSZ; ulimit -f 100; exec \"$0\" run small.toml --quiet"])
        .arg(env!("CARGO_BIN_EXE_stribeck"))
        .current_dir(directory.path())
        .output()
        .expect("sh runs");
    assert_eq!(code(&limited), 4, "{}", err(&limited));
    assert!(err(&limited).starts_with("error: cannot write results/small/shards/"), "{}", err(&limited));
    assert!(err(&limited).contains("0 cases saved in results/small, 9 left; resume with\n    "), "{}", err(&limited));
    let resume = err(&limited).lines().next_back().expect("a line").trim().to_owned();
    let shell = std::process::Command::new("sh").args(["-c", &resume]).current_dir(directory.path()).output();
    assert_eq!(code(&shell.expect("sh runs")), 0, "{resume}");
}

#[test]
fn a_sweep_of_a_billion_cases_is_planned_at_once() {
    let axis = "{ from = 1.0, to = 2.0, points = 1000 }";
    let directory = with_sweep(&format!("[axes]\nf = {axis}\nalpha = {axis}\nbeta = {axis}\n"));
    let plan = say(directory.path(), &["plan", "small.toml"]);
    assert!(out(&plan).contains("0 reused, 1000000000 new, 0 failed before"), "{}", out(&plan));
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let directory = finished();
    for arguments in [
        vec!["status", "results/small"],
        vec!["verify", "results/small"],
        vec!["run", "small.toml"],
        vec!["plan", "small.toml"],
    ] {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let command = stribeck(directory.path()).args(&arguments).stdout(Stdio::from(writer)).output();
        let output = command.expect("the program starts");
        assert_eq!(code(&output), 0, "{arguments:?}: {}", err(&output));
        assert_eq!(err(&output), "", "{arguments:?}");
    }
}

#[test]
fn status_without_its_sweep_file_counts_what_is_stored() {
    let directory = finished();
    let sweep = directory.path().join("results/small/sweep.toml");
    fs::remove_file(&sweep).expect("removed");
    let status = say(directory.path(), &["status", "results/small"]);
    assert_eq!(code(&status), 0, "{}", err(&status));
    assert!(out(&status).contains("9 converged, 0 failed"), "{}", out(&status));
    assert!(err(&status).contains("how many cases were planned is not known"), "{}", err(&status));
}

#[test]
fn slurm_writes_its_scripts_and_says_how_to_submit_them() {
    let directory = with_sweep(SMALL);
    let here = directory.path();
    let many =
        say(here, &["slurm", "small.toml", "-o", "my out", "--tasks", "2001", "--time", "01:00:00", "--cpus", "2"]);
    assert_eq!(code(&many), 0, "{}", err(&many));
    assert!(err(&many).contains("the sweep has 3 chains; 1998 of the tasks have nothing to do"), "{}", err(&many));
    let home = fs::canonicalize(here).expect("there").join("my out/slurm");
    let part = home.join("part.sh").display().to_string();
    for line in [
        format!("    sbatch --array=1-1000 '{part}'\n"),
        format!("    sbatch --array=1-1000 '{part}' 1000\n"),
        format!("    sbatch --array=1-1 '{part}' 2000\n"),
        format!("    sbatch --dependency=afterany:JOB:JOB:… '{}'\n", home.join("merge.sh").display()),
    ] {
        assert!(out(&many).contains(&line), "{line}{}", out(&many));
    }
    // The sweep is kept as it is now, and the directory is still free for a run.
    assert_eq!(fs::read_to_string(home.join("small.toml")).expect("kept"), SMALL);
    for name in ["part.sh", "merge.sh"] {
        let checked = std::process::Command::new("bash").arg("-n").arg(home.join(name)).output().expect("bash runs");
        assert!(checked.status.success(), "{}", err(&checked));
    }
    let run = say(here, &["run", "small.toml", "-o", "my out", "--quiet"]);
    assert_eq!(code(&run), 0, "{}", err(&run));
}

#[test]
fn slurm_replaces_its_own_scripts_and_no_others() {
    let directory = with_sweep(SMALL);
    let here = directory.path();
    let write = |tasks| say(here, &["slurm", "small.toml", "-o", "out", "--tasks", tasks]);
    fs::create_dir_all(here.join("out/slurm")).expect("created");
    for name in ["part.sh", "merge.sh", "small.toml"] {
        let file = here.join("out/slurm").join(name);
        fs::write(&file, "#!/bin/bash\n# mine\n").expect("written");
        let before = paths(here);
        let refused = write("2");
        assert_eq!(code(&refused), 4, "{name}");
        let said = err(&refused);
        assert!(said.contains(&format!("out/slurm/{name} is there, which `stribeck slurm` has not written")), "{said}");
        assert_eq!(
            (fs::read_to_string(&file).expect("kept"), paths(here)),
            ("#!/bin/bash\n# mine\n".to_owned(), before)
        );
        fs::remove_file(file).expect("removed");
    }
    for tasks in ["2", "3"] {
        assert_eq!(code(&write(tasks)), 0);
        let part = fs::read_to_string(here.join("out/slurm/part.sh")).expect("written");
        assert!(part.contains(&format!("--part \"$part/{tasks}\"")), "{part}");
    }
}

#[test]
fn what_is_in_the_queue_already_is_told_when_slurm_takes_no_more() {
    use std::os::unix::fs::PermissionsExt;
    let directory = with_sweep(SMALL);
    let here = directory.path();
    // A Slurm with arrays of two tasks, which takes two jobs.
    let programs = [
        ("scontrol", "echo 'MaxArraySize = 3'"),
        (
            "sbatch",
            "echo \"$@\" >> asked; n=$(wc -l < asked); [ $n -le 2 ] && echo \"4$n;hal\" || { echo 'too many jobs' >&2; exit 1; }",
        ),
    ];
    for (name, text) in programs {
        let file = here.join(name);
        fs::write(&file, format!("#!/bin/sh\n{text}\n")).expect("written");
        fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).expect("made executable");
    }
    let path = format!("{}:{}", here.display(), std::env::var("PATH").expect("a path"));
    let submit = |tasks: &str| {
        let _ = fs::remove_file(here.join("asked"));
        let mut command = stribeck(here);
        command.args(["slurm", "small.toml", "-o", "out", "--tasks", tasks, "--submit"]).env("PATH", &path);
        command.output().expect("the program starts")
    };
    let submitted = submit("2");
    assert_eq!(code(&submitted), 0, "{}", err(&submitted));
    assert!(
        out(&submitted).contains("submitted 2 parts as job 41\nsubmitted the merge as job 42\n"),
        "{}",
        out(&submitted)
    );
    let asked = fs::read_to_string(here.join("asked")).expect("asked");
    assert!(asked.contains("--parsable --dependency=afterany:41 "), "{asked}");
    for tasks in ["3", "6"] {
        let refused = submit(tasks);
        assert_eq!(code(&refused), 4);
        let said = err(&refused);
        assert!(said.contains("`sbatch` did not work: too many jobs; ") && said.contains("`scancel 41 42`"), "{said}");
    }
}

#[test]
fn a_cluster_without_slurm_is_told_and_the_scripts_stay() {
    let directory = with_sweep(SMALL);
    let mut command = stribeck(directory.path());
    command.args(["slurm", "small.toml", "-o", "out", "--tasks", "2", "--submit"]).env("PATH", "");
    let output = command.output().expect("the program starts");
    assert_eq!(code(&output), 4);
    assert!(err(&output).contains("`scontrol` did not work: there is no such program"), "{}", err(&output));
    assert!(directory.path().join("out/slurm/part.sh").exists());
}
