//! Any sweep that is taken goes through every command in bounded memory and time, however extreme its numbers are.

use std::fs;
use std::process::{Command, Output};
use std::time::{Duration, SystemTime};

use rayon::prelude::*;
use tempfile::tempdir;

use crate::program::{code, err, out, stribeck};
use crate::torture::random::Random;

/// Kilobytes of address space, and seconds, far above what these sweeps take.
const MEMORY: u64 = 3_000_000;
const PATIENCE: Duration = Duration::from_secs(60);

/// Runs the program within these limits.
fn bounded(directory: &std::path::Path, arguments: &[&str]) -> Output {
    let program = stribeck(directory);
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("ulimit -c 0; ulimit -v {MEMORY}; exec \"$0\" \"$@\"")]);
    shell.arg(program.get_program()).args(arguments).current_dir(directory);
    let output = assert_cmd::Command::from_std(shell).timeout(PATIENCE).output().expect("sh runs");
    let said = err(&output);
    assert!(output.status.code().is_some(), "{arguments:?} had no end: {said}");
    assert!([0, 2, 3, 4].contains(&code(&output)) && !said.contains("panicked"), "{arguments:?}: {said}");
    output
}

/// Some different numbers, ascending, as a list of a sweep file.
fn numbers(random: &mut Random, least: f64, most: f64) -> String {
    let ordinary = |random: &mut Random| 10_f64.powi(random.below(8) as i32 - 3);
    let mut numbers: Vec<f64> = (0..=random.below(3))
        .map(|_| match random.below(3) {
            0 => ordinary(random),
            // Any order of magnitude that there is.
            1 => f64::from_bits((random.below(2047) << 52 | random.below(1 << 52)) as u64),
            _ => [5e-324, 1e-300, 1e-50, 1e-10, 1e10, 1e50, 1e300, f64::MAX][random.below(8)],
        })
        .filter(|number| (least..=most).contains(number))
        .collect();
    numbers.push(ordinary(random).clamp(least, most));
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    format!("{numbers:?}")
}

/// A random sweep.
fn sweep(random: &mut Random) -> String {
    let method = match random.below(4) {
        0 => "method = \"relaxation\"\n[solver.relaxation]\npoints = 51\n",
        _ => "",
    };
    let fields = match random.below(3) {
        0 => "fields = []".to_owned(),
        1 => "x = { from = -3.0, to = 3.0, points = 31 }".to_owned(),
        _ => {
            let far = numbers(random, 1e-300, f64::MAX);
            format!("x = [-1.0, 0.0, {}", &far[1..])
        }
    };
    let [f, alpha, beta] =
        [numbers(random, 0.0, f64::MAX), numbers(random, 0.0, f64::MAX), numbers(random, 5e-324, f64::MAX)];
    format!("[axes]\nf = {f}\nalpha = {alpha}\nbeta = {beta}\n[solver]\ntime_limit = 1.0\n{method}[output]\n{fields}\n")
}

/// Takes a random sweep through every command; true if it was taken.
fn take(seed: u64, number: u64) -> bool {
    let text = sweep(&mut Random::new(seed, number));
    let place = tempdir().expect("a temporary directory");
    let told = |output: &Output| format!("seed {seed}, sweep {number}:\n{text}\n{}", err(output));
    fs::write(place.path().join("s.toml"), &text).expect("written");
    let plan = bounded(place.path(), &["plan", "s.toml", "-o", "d"]);
    let run = bounded(place.path(), &["run", "s.toml", "-o", "d", "-q", "--threads", "1"]);
    if code(&plan) == 2 {
        assert_eq!(code(&run), 2, "{}", told(&run));
        return false;
    }
    assert!([0, 3].contains(&code(&run)), "{}", told(&run));
    for arguments in [&["status", "d"][..], &["verify", "d"], &["report", "d"], &["merge", "d", "-o", "m"]] {
        let output = bounded(place.path(), arguments);
        assert!([0, 3].contains(&code(&output)), "{arguments:?}: {}", told(&output));
    }
    let summary = fs::read_to_string(place.path().join("d/summary.csv")).expect("published");
    let case = summary.lines().nth(1).and_then(|row| row.split(',').next()).expect("a case");
    assert_eq!(code(&bounded(place.path(), &["explain", "d", case])), 0);
    for what in ["surfaces", "maps", "curves", "profiles", "loops", "stress", "errors"] {
        // What a data set has no picture for is said, with exit code 2.
        let plot = bounded(place.path(), &["plot", "d", "--what", what, "-o", "p"]);
        assert!([0, 2].contains(&code(&plot)), "{what}: {}{}", out(&plot), told(&plot));
    }
    true
}

fn take_all(seed: u64, count: u64) {
    let taken = (0..count).into_par_iter().filter(|number| take(seed, *number)).count();
    println!("seed {seed}: {taken} of {count} sweeps were taken");
    assert!(2 * taken as u64 > count, "most of them are sweeps");
}

#[test]
fn extreme_sweeps_go_through_every_command() {
    take_all(2026, 8);
}

#[test]
#[ignore = "a hundred sweeps take a minute"]
fn extreme_sweeps_go_through_every_command_with_a_fresh_seed() {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).expect("after 1970");
    take_all(now.as_secs(), 100);
}
