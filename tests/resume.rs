//! The published bytes do not depend on threads, interruptions or the order of events, and nothing is solved twice.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::OnceLock;
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

use crate::program::{code, err, out, paths, say, stribeck};
use stribeck_solver::Output;
use stribeck_sweep::store::{Catalog, Inspection};
use stribeck_sweep::{Plan, Sweep};
use tempfile::{TempDir, tempdir};

/// 4 rows (the elastic one stands at 3 places) of 4 chains each; a tolerance that takes some time.
const SWEEP: &str = r#"
title = "Resumed"
[axes]
f = [0.0, 10.0]
alpha = [1.0, 10.0, 100.0]
beta = { from = 10.0, to = 100.0, points = 200, scale = "log" }
[solver]
tolerance = 1e-8
[output]
fields = ["pressure", "film_thickness"]
x = { from = -2.0, to = 2.0, points = 81 }
"#;
const CASES: u64 = 800;

/// The published files that are the same in every run.
type Bytes = [Vec<u8>; 2];

fn published(results: &Path) -> Bytes {
    ["summary.csv", "results.h5"].map(|name| fs::read(results.join(name)).expect("published"))
}

/// Whether two sets of published files are the same, without printing them if not.
fn assert_same(found: &Bytes, expected: &Bytes) {
    assert!(found[0] == expected[0], "summary.csv differs");
    assert!(found[1] == expected[1], "results.h5 differs");
}

fn with_sweep(text: &str) -> TempDir {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("sweep.toml"), text).expect("written");
    directory
}

/// Runs a sweep to its end and returns what is published.
fn run(directory: &Path, more: &[&str]) -> Bytes {
    let output = say(directory, &[&["run", "sweep.toml", "-o", "out", "--quiet"], more].concat());
    assert_eq!(code(&output), 0, "{}", err(&output));
    published(&directory.join("out"))
}

/// What an uninterrupted run on one thread publishes, and how long it takes.
fn reference() -> &'static (Bytes, Duration) {
    static REFERENCE: OnceLock<(Bytes, Duration)> = OnceLock::new();
    REFERENCE.get_or_init(|| {
        let directory = with_sweep(SWEEP);
        let start = Instant::now();
        (run(directory.path(), &["--threads", "1"]), start.elapsed())
    })
}

/// Cases that are stored; 0 where there is no results directory yet.
fn stored(results: &Path) -> u64 {
    Catalog::read(results, &Output::default(), Inspection::Bytes).map_or(0, |held| held.counts().converged)
}

/// Waits until a run has committed more cases, shard and record, or has ended.
fn wait_for_commit(run: &mut Child, results: &Path) {
    let before = stored(results);
    while stored(results) == before && run.try_wait().expect("asked").is_none() {
        sleep(Duration::from_millis(1));
    }
}

/// xorshift: the moments of the kills are the same in each run of the test.
fn next_random(state: &mut u64) -> f64 {
    for shift in [13, -7, 17] {
        *state ^= if shift > 0 { *state << shift } else { *state >> -shift };
    }
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

#[test]
fn two_threads_publish_the_bytes_of_one() {
    let directory = with_sweep(SWEEP);
    assert_same(&run(directory.path(), &["--threads", "2"]), &reference().0);
}

#[test]
fn neither_tables_nor_fields_depend_on_the_threads_of_the_relaxation_method() {
    let solver = "[solver]\nmethod = \"relaxation\"\n[solver.relaxation]\npoints = 401\n";
    let text = SWEEP.replace("points = 200", "points = 20").replace("[solver]\ntolerance = 1e-8\n", solver);
    let [one, two] = ["1", "2"].map(|threads| run(with_sweep(&text).path(), &["--threads", threads]));
    assert_same(&two, &one);
}

#[test]
fn two_modes_publish_the_same_bytes_on_any_threads_and_differ_from_one() {
    let small = SWEEP.replace("points = 200", "points = 70");
    let modes = "[substrate]\nmodes = [{ share = 0.6, time = 1.0 }, { share = 0.4, time = 0.1 }]\n[solver]";
    let text = small.replace("[solver]", modes);
    let [one, two] = ["1", "2"].map(|threads| run(with_sweep(&text).path(), &["--threads", threads]));
    assert_same(&two, &one);
    let single = run(with_sweep(&small).path(), &[]);
    // Where the substrate is elastic the modes mean nothing; elsewhere they change every row.
    let ids_and_rows = rows(&one).into_iter().zip(rows(&single)).skip(1);
    let mut differing = 0;
    for (with_two, with_one) in ids_and_rows {
        let elastic = with_two.split(',').nth(1) == Some("0.0");
        assert_eq!(with_two == with_one, elastic, "{with_two}\n{with_one}");
        differing += usize::from(!elastic);
        assert!(with_two.contains(",converged,"), "{with_two}");
    }
    assert_eq!(differing, 3 * 70);
}

#[test]
fn a_sweep_killed_ten_times_publishes_the_bytes_of_one_left_alone() {
    let (expected, duration) = reference();
    let directory = with_sweep(SWEEP);
    let results = directory.path().join("out");
    let (mut killed, mut killed_half_way, mut random) = (0, 0, 0x5eed_2026);
    for attempt in 0..10 {
        let threads = if attempt % 2 == 0 { "1" } else { "2" };
        let mut command = stribeck(directory.path());
        command.args(["run", "sweep.toml", "-o", "out", "--threads", threads]);
        let mut victim = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("started");
        let part = next_random(&mut random);
        if attempt % 5 == 4 {
            // However slow the machine is: just after a commit, and shortly later.
            wait_for_commit(&mut victim, &results);
            sleep(duration.mul_f64(part / 50.0));
        } else {
            sleep(Duration::from_millis(5) + duration.mul_f64(part / 4.0));
        }
        victim.kill().expect("killed, or gone");
        let by_itself = victim.wait().expect("gone").code().is_some();
        killed += usize::from(!by_itself);
        killed_half_way += usize::from(!by_itself && (1..CASES).contains(&stored(&results)));
    }
    assert!(killed > 0 && killed_half_way > 0, "{killed} kills came in time, {killed_half_way} half way");
    assert_same(&run(directory.path(), &[]), expected);
    assert_eq!(code(&say(directory.path(), &["verify", "out"])), 0);
}

#[test]
fn a_terminated_run_says_how_to_resume_and_that_works() {
    let home = tempdir().expect("a temporary directory");
    // A name that a shell would take apart.
    let directory = home.path().join("it's here");
    fs::create_dir(&directory).expect("made");
    fs::write(directory.join("my sweep.toml"), SWEEP).expect("written");
    let results = directory.join("out $HOME");
    let mut command = stribeck(&directory);
    command.args(["run", "my sweep.toml", "-o", "out $HOME", "--threads", "1", "--quiet"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("started");
    wait_for_commit(&mut child, &results);
    let sent = Command::new("kill").args(["-TERM", &child.id().to_string()]).status().expect("kill runs");
    assert!(sent.success(), "the run ended before the signal");
    let stopped = child.wait_with_output().expect("ends");
    let said = err(&stopped);
    assert_eq!(code(&stopped), 130, "{said}");
    assert_eq!(out(&stopped), "");
    assert!(said.starts_with("interrupted by SIGTERM: ") && said.contains(" left; resume with\n    "), "{said}");
    assert!(!results.join("summary.csv").exists(), "an unfinished sweep publishes nothing");

    let sweep = Sweep::read(results.join("sweep.toml")).expect("the sweep is there");
    let held = Catalog::read(&results, &sweep.output, Inspection::Bytes).expect("results");
    let saved = held.counts().converged + held.counts().failed;
    let left = Plan::new(&sweep).problems() as u64 - saved;
    assert!(said.contains(&format!("{saved} cases saved in out $HOME, {left} left")), "{saved} and {left}: {said}");
    let status = say(&directory, &["status", "out $HOME"]);
    for words in
        ["stopped; the same `stribeck run` command resumes it", ", interrupted", &format!("to do      {left}\n")]
    {
        assert!(out(&status).contains(words), "{words}: {}", out(&status));
    }
    let verify = say(&directory, &["verify", "out $HOME"]);
    assert_eq!(code(&verify), 0);
    assert!(out(&verify).contains(&format!("with {saved} cases")), "{}", out(&verify));

    let resume = said.lines().next_back().expect("a line").trim();
    let shell = Command::new("sh").arg("-c").arg(resume).current_dir(&directory).output().expect("sh runs");
    assert_eq!(code(&shell), 0, "{resume}\n{}", err(&shell));
    assert_same(&published(&results), &reference().0);
}

#[test]
fn a_running_sweep_is_told_from_a_stopped_one_and_is_alone() {
    let directory = with_sweep(SWEEP);
    let results = directory.path().join("out");
    let mut command = stribeck(directory.path());
    command.args(["run", "sweep.toml", "-o", "out", "--threads", "1", "--quiet"]);
    let mut child = command.stdout(Stdio::null()).spawn().expect("started");
    wait_for_commit(&mut child, &results);
    // Stopped, it keeps its lock and cannot end while it is looked at.
    let signal = |name: &str| {
        let sent = Command::new("kill").args([name, &child.id().to_string()]).status().expect("kill runs");
        assert!(sent.success());
    };
    signal("-STOP");
    let status = say(directory.path(), &["status", "out"]);
    let second = say(directory.path(), &["run", "sweep.toml", "-o", "out"]);
    signal("-CONT");
    assert!(out(&status).contains(&format!("running (process {})", child.id())), "{}", out(&status));
    assert!(out(&status).contains(", running\n"), "{}", out(&status));
    assert_eq!(code(&second), 4, "{}", err(&second));
    assert!(err(&second).contains("in use by another run") && err(&second).contains("with -o"), "{}", err(&second));
    assert!(child.wait().expect("ends").success());
    assert_same(&published(&results), &reference().0);
}

#[test]
fn a_finished_sweep_is_left_alone() {
    let directory = with_sweep(SWEEP);
    let results = directory.path().join("out");
    run(directory.path(), &[]);
    let look = || -> Vec<(String, Vec<u8>, SystemTime)> {
        let files = paths(&results).into_iter().filter(|path| Path::new(path).is_file() && !path.ends_with("/lock"));
        files
            .map(|path| {
                let modified = fs::metadata(&path).and_then(|metadata| metadata.modified()).expect("a time");
                let bytes = fs::read(&path).expect("read");
                (path, bytes, modified)
            })
            .collect()
    };
    let before = look();
    let again = say(directory.path(), &["run", "sweep.toml", "-o", "out"]);
    assert_eq!(code(&again), 0, "{}", err(&again));
    assert!(out(&again).contains("nothing to do") && err(&again).is_empty(), "{}{}", out(&again), err(&again));
    assert!(look() == before, "files changed");

    fs::remove_file(results.join("summary.csv")).expect("removed");
    assert_same(&run(directory.path(), &[]), &reference().0);
}

/// The rows of a summary.
fn rows(bytes: &Bytes) -> Vec<&str> {
    std::str::from_utf8(&bytes[0]).expect("text").lines().collect()
}

#[test]
fn values_added_to_an_axis_reuse_what_is_there() {
    let directory = with_sweep(SWEEP);
    let file = directory.path().join("sweep.toml");
    let mut before = run(directory.path(), &[]);
    let wider_alpha = SWEEP.replace("10.0, 100.0]", "10.0, 30.0, 100.0]");
    // Doubled intervals keep the old points, and cut the rows into other chains.
    let finer_beta = wider_alpha.replace("points = 200", "points = 399");
    for (text, reused, new) in [(wider_alpha, CASES, 200), (finer_beta, 1000, 5 * 199)] {
        fs::write(&file, &text).expect("written");
        let plan = out(&say(directory.path(), &["plan", "sweep.toml", "-o", "out"]));
        assert!(plan.contains(&format!("{reused} reused, {new} new, 0 failed before")), "{plan}");
        let after = run(directory.path(), &[]);
        let new_rows = rows(&after);
        assert!(rows(&before).iter().all(|row| new_rows.contains(row)), "an old row has changed");
        let places = text.matches("30.0,").count() + 3;
        let betas = if text.contains("399") { 399 } else { 200 };
        assert_eq!(new_rows.len(), 1 + 2 * places * betas);
        before = after;
    }
    assert_eq!(code(&say(directory.path(), &["verify", "out"])), 0);
}

#[test]
fn fields_asked_for_later_are_computed() {
    let fields = r#"["pressure", "film_thickness"]"#;
    let directory = with_sweep(&SWEEP.replace(fields, "[]"));
    let without = run(directory.path(), &[]);
    fs::write(directory.path().join("sweep.toml"), SWEEP).expect("written");
    let plan = out(&say(directory.path(), &["plan", "sweep.toml", "-o", "out"]));
    assert!(plan.contains("0 reused, 0 new, 800 stale, 0 failed before"), "{plan}");
    let with = run(directory.path(), &[]);
    assert_same(&with, &reference().0);
    assert!(with[0] == without[0], "fields do not change the numbers");

    // Fewer fields need no solver, only another publication.
    fs::write(directory.path().join("sweep.toml"), SWEEP.replace(fields, "[]")).expect("written");
    assert_same(&run(directory.path(), &[]), &without);
}

#[test]
fn published_files_of_an_earlier_state_stay_while_a_sweep_is_unfinished() {
    let directory = with_sweep(&SWEEP.replace("points = 200", "points = 3"));
    let results: PathBuf = directory.path().join("out");
    let before = run(directory.path(), &[]);
    fs::write(directory.path().join("sweep.toml"), SWEEP).expect("written");
    let mut command = stribeck(directory.path());
    let mut child = command
        .args(["run", "sweep.toml", "-o", "out", "--threads", "1", "--quiet"])
        .stderr(Stdio::null())
        .spawn()
        .expect("started");
    wait_for_commit(&mut child, &results);
    child.kill().expect("killed");
    assert_eq!(child.wait().expect("gone").code(), None, "killed by the signal, not ended by itself");
    assert_same(&published(&results), &before);
}
