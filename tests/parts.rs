//! A sweep in parts: solved anywhere, in any order, interrupted or not, and merged to the bytes of a sweep that was run
//! whole.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;

use crate::program::{code, err, out, paths, say, stribeck};
use stribeck_solver::Output;
use stribeck_sweep::store::{Catalog, Inspection, Status, Store};
use stribeck_sweep::{CaseId, Column, Part, Plan, Sweep, Values};
use tempfile::{TempDir, tempdir};

/// 13 chains: the elastic row and six others have as many cases, the last chain of each being short.
const SWEEP: &str = r#"
[axes]
f = [0.0, 10.0]
alpha = [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0]
beta = { from = 10.0, to = 100.0, points = 70, scale = "log" }
[solver]
tolerance = 1e-6
[output]
fields = ["pressure"]
x = [-1.0, 0.0, 1.0]
"#;

fn with_sweep() -> TempDir {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("many parts.toml"), SWEEP).expect("written");
    directory
}

fn published(results: &Path) -> [Vec<u8>; 2] {
    ["summary.csv", "results.h5"].map(|name| fs::read(results.join(name)).expect("published"))
}

/// What a sweep that was run whole publishes.
fn whole() -> [Vec<u8>; 2] {
    static WHOLE: std::sync::OnceLock<[Vec<u8>; 2]> = std::sync::OnceLock::new();
    let run = || {
        let directory = with_sweep();
        let run = say(directory.path(), &["run", "many parts.toml", "-o", "whole", "--quiet"]);
        assert_eq!(code(&run), 0, "{}", err(&run));
        published(&directory.path().join("whole"))
    };
    WHOLE.get_or_init(run).clone()
}

fn assert_same(results: &Path) {
    let (found, expected) = (published(results), whole());
    assert!(found[0] == expected[0], "summary.csv differs");
    assert!(found[1] == expected[1], "results.h5 differs");
}

fn run_part(directory: &Path, results: &str, part: &str, threads: &str) {
    let arguments = ["run", "many parts.toml", "-o", results, "--part", part, "--threads", threads, "--quiet"];
    let run = say(directory, &arguments);
    assert_eq!(code(&run), 0, "{part}: {}", err(&run));
    assert!(out(&run).starts_with(&format!("part {part}, ")), "{}", out(&run));
    assert!(out(&run).contains("once all parts are done: stribeck merge "), "{}", out(&run));
}

fn merge(directory: &Path, arguments: &[&str]) -> String {
    let merge = say(directory, &[&["merge"], arguments].concat());
    assert_eq!(code(&merge), 0, "{}", err(&merge));
    out(&merge)
}

#[test]
fn parts_in_any_order_are_merged_to_the_bytes_of_the_whole() {
    for (of, order) in [(1, vec![1]), (3, vec![2, 3, 1]), (5, vec![5, 1, 4, 2, 3]), (20, (1..=20).rev().collect())] {
        let directory = with_sweep();
        let here = directory.path();
        for (i, number) in order.into_iter().enumerate() {
            run_part(here, "out", &format!("{number}/{of}"), if i % 2 == 0 { "1" } else { "2" });
        }
        assert!(!here.join("out/summary.csv").exists(), "parts publish nothing");
        let said = merge(here, &["out"]);
        assert!(said.contains("joined 490 cases in "), "{said}");
        assert_same(&here.join("out"));
        assert_eq!(code(&say(here, &["verify", "out"])), 0);
        // The merged directory stands without its parts.
        fs::remove_dir_all(here.join("out/parts")).expect("removed");
        assert_eq!(code(&say(here, &["verify", "out"])), 0);
        let again = say(here, &["run", "many parts.toml", "-o", "out"]);
        assert!(out(&again).contains("nothing to do"), "{}", out(&again));
    }
}

#[test]
fn parts_that_run_at_the_same_time_write_no_common_file() {
    let directory = with_sweep();
    let here = directory.path();
    let start = |part: u32| {
        let part = format!("{part}/4");
        let mut command = stribeck(here);
        // The earlier name of `--part`, as it stands in job scripts that were written before.
        command.args(["run", "many parts.toml", "-o", "out", "--quiet", "--threads", "1", "--shard", &part]);
        command.stdout(Stdio::null()).spawn().expect("started")
    };
    for mut child in (1..=4).map(start).collect::<Vec<_>>() {
        assert!(child.wait().expect("ends").success());
    }
    let outside = paths(&here.join("out")).into_iter().filter(|path| Path::new(path).is_file());
    let outside: Vec<String> = outside.filter(|path| !path.contains("/out/parts/")).collect();
    assert_eq!(outside, Vec::<String>::new(), "all that parts write is their own");
    merge(here, &["out"]);
    assert_same(&here.join("out"));
}

#[test]
fn a_part_that_is_killed_resumes_by_itself() {
    let directory = with_sweep();
    let here = directory.path();
    for part in ["1/2", "2/2"] {
        for _ in 0..3 {
            let mut command = stribeck(here);
            command.args(["run", "many parts.toml", "-o", "out", "--quiet", "--threads", "1", "--part", part]);
            let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("started");
            let home = here.join("out/parts").join(part.replace('/', "-of-"));
            let stored = || Catalog::read(&home, &Output::default(), Inspection::Bytes).map_or(0, |held| held.known());
            let before = stored();
            while stored() == before && child.try_wait().expect("asked").is_none() {
                std::thread::yield_now();
            }
            child.kill().expect("killed, or gone");
            child.wait().expect("gone");
        }
        run_part(here, "out", part, "2");
    }
    merge(here, &["out"]);
    assert_same(&here.join("out"));
}

#[test]
fn runs_on_several_machines_are_merged_into_one_directory() {
    let directory = with_sweep();
    let here = directory.path();
    run_part(here, "first", "1/3", "1");
    run_part(here, "second", "2/3", "1");
    run_part(here, "second", "3/3", "1");
    let none = say(here, &["merge", "first", "second"]);
    assert_eq!(code(&none), 2);
    assert!(err(&none).contains("give -o DIR"), "{}", err(&none));
    merge(here, &["first", "second", "-o", "third"]);
    assert_same(&here.join("third"));
    // A whole run is joined like a part; all of it is there twice.
    let said = merge(here, &["third", "first", "-o", "third"]);
    assert!(said.contains("joined 0 cases in 0 shards"), "{said}");
    assert_same(&here.join("third"));
}

#[test]
fn a_missing_part_is_named_with_the_command_that_finishes_it() {
    let directory = with_sweep();
    let here = directory.path();
    run_part(here, "out", "2/3", "2");
    run_part(here, "out", "3/3", "2");
    let incomplete = say(here, &["merge", "out"]);
    assert_eq!(code(&incomplete), 4);
    let said = err(&incomplete);
    assert!(
        said.contains("nothing is published: ") && said.contains("missing, in 1 part:\n  part 1/3 lacks "),
        "{said}"
    );
    assert!(!here.join("out/summary.csv").exists());
    let status = out(&say(here, &["status", "out"]));
    assert!(status.contains("3 parts: 2 complete, 0 running, 0 stopped, 1 not started\n  1/3 "), "{status}");

    // The command is one that a shell runs as it stands.
    let command = said.lines().find_map(|line| line.trim().strip_prefix("stribeck ")).expect("a command");
    let program = env!("CARGO_BIN_EXE_stribeck");
    let script = format!("'{program}' {command}");
    let shell = std::process::Command::new("sh").args(["-c", &script]).current_dir(here).output().expect("sh runs");
    assert_eq!(code(&shell), 0, "{script}\n{}", err(&shell));
    merge(here, &["out"]);
    assert_same(&here.join("out"));
}

#[test]
fn status_sums_over_all_parts() {
    let directory = with_sweep();
    let here = directory.path();
    let sweep = Sweep::parse("parts", SWEEP).expect("valid");
    let plan = Plan::new(&sweep);
    let cases = |part: &str| -> usize {
        let part: Part = part.parse().expect("a part");
        plan.chains_of(Some(part)).iter().map(|&index| plan.chain(index as usize).cases.len()).sum()
    };
    let mut done = 0;
    for part in ["2/4", "4/4", "1/4", "3/4"] {
        run_part(here, "out", part, "2");
        done += cases(part);
        let status = out(&say(here, &["status", "out"]));
        for line in [
            format!("converged  {done}\n"),
            format!("to do      {}\n", 490 - done),
            "planned    490 cases, at 840 places".to_owned(),
        ] {
            assert!(status.contains(&line), "{line}: {status}");
        }
        let planned = out(&say(here, &["plan", "many parts.toml", "-o", "out"]));
        assert!(planned.contains(&format!("{done} reused, {} new", 490 - done)), "{planned}");
    }
    let status = out(&say(here, &["status", "out"]));
    assert!(status.contains("4 parts: 4 complete") && status.contains("`stribeck merge` does that"), "{status}");
    let text = out(&say(here, &["explain", "out", "10,1,50"]));
    let in_one_line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(in_one_line.contains("the same numbers to the last bit") && text.contains("out/parts/"), "{text}");
}

#[test]
fn cases_of_the_whole_and_of_another_split_are_not_solved_again() {
    let directory = with_sweep();
    let here = directory.path();
    let smaller = SWEEP.replace("1.0, 10.0, 100.0", "1.0, 100.0");
    fs::write(here.join("smaller.toml"), smaller).expect("written");
    assert_eq!(code(&say(here, &["run", "smaller.toml", "-o", "out", "--quiet"])), 0);
    for part in ["1/2", "1/3", "2/3", "3/3"] {
        run_part(here, "out", part, "2");
    }
    let all: Vec<Catalog> = paths(&here.join("out/parts"))
        .into_iter()
        .filter(|path| path.contains("-of-") && Path::new(path).join("log").is_dir())
        .map(|path| Catalog::read(Path::new(&path), &Output::default(), Inspection::Bytes).expect("results"))
        .collect();
    assert_eq!(all.len(), 4);
    assert_eq!(all.iter().map(Catalog::known).sum::<u64>(), 70, "one row is new, and solved once");
    let said = merge(here, &["out"]);
    assert!(said.contains("joined 70 cases in "), "{said}");
    assert_same(&here.join("out"));
}

#[test]
fn a_run_of_the_whole_takes_over_what_parts_have_solved() {
    let directory = with_sweep();
    let here = directory.path();
    run_part(here, "out", "2/3", "2");
    let run = say(here, &["run", "many parts.toml", "-o", "out", "--quiet"]);
    assert_eq!(code(&run), 0, "{}", err(&run));
    assert!(err(&run).contains("note: took over ") && out(&run).contains(" more were there already"), "{}", err(&run));
    assert_same(&here.join("out"));
}

#[test]
fn other_sweeps_are_not_joined() {
    let directory = with_sweep();
    let here = directory.path();
    run_part(here, "first", "1/2", "2");
    fs::write(here.join("many parts.toml"), SWEEP.replace("1e-6", "1e-7")).expect("written");
    run_part(here, "second", "2/2", "2");
    let merge = say(here, &["merge", "first", "second", "-o", "third"]);
    assert_eq!(code(&merge), 2);
    let said = err(&merge);
    assert!(
        said.contains("first/parts/1-of-2/sweep.toml") && said.contains("second/parts/2-of-2/sweep.toml"),
        "{said}"
    );
    assert!(!here.join("third").exists(), "nothing is written");
    assert_eq!(code(&say(here, &["merge", "nowhere"])), 2);
}

/// A directory with one more copy of a case, whose numbers are changed; all of its chain goes with it.
fn with_other_numbers(here: &Path, name: &str, change: impl Fn(&mut Values)) -> (PathBuf, CaseId) {
    let sweep = Sweep::read(here.join("many parts.toml")).expect("valid");
    let plan = Plan::new(&sweep);
    let held = Catalog::read(&here.join("whole"), &sweep.output, Inspection::Bytes).expect("results");
    let ids = plan.ids(&plan.chain(5));
    let mut entries: Vec<_> = ids.iter().map(|id| held.entry(*id).expect("read").expect("there")).collect();
    change(&mut entries[3].values);
    let path = here.join(name);
    let mut store = Store::open(&path, SWEEP, &sweep.output).expect("opened");
    store.commit(&entries).expect("committed");
    (path, ids[3])
}

#[test]
fn a_case_that_is_there_twice_must_agree_within_the_tolerance_and_the_choice_is_fixed() {
    let directory = with_sweep();
    let here = directory.path();
    assert_eq!(code(&say(here, &["run", "many parts.toml", "-o", "whole", "--quiet"])), 0);
    // The last bits of another processor.
    with_other_numbers(here, "near", |values| values[Column::C] *= 1.0 + 1e-8);
    for (first, second, merged) in [("whole", "near", "a"), ("near", "whole", "b")] {
        merge(here, &[first, second, "-o", merged]);
    }
    assert!(published(&here.join("a")) == published(&here.join("b")), "whatever the order");
    // Of cases that were committed in other company one shard has to be chosen; the other case stays stored.
    let sweep = Sweep::read(here.join("many parts.toml")).expect("valid");
    let held = Catalog::read(&here.join("a"), &sweep.output, Inspection::Bytes).expect("results");
    assert_eq!((held.known(), held.counts().converged), (490, 490));

    let (_, id) = with_other_numbers(here, "far", |values| values[Column::C] *= 1.0 + 1e-4);
    for (first, second, merged) in [("whole", "far", "d"), ("far", "whole", "e")] {
        let merge = say(here, &["merge", first, second, "-o", merged]);
        assert_eq!(code(&merge), 4);
        let said = err(&merge);
        assert!(said.contains(&format!("case {id} is in ")), "{said}");
        assert!(said.contains(&format!("{merged}/shards/")) && said.contains(&format!("{second}/shards/")), "{said}");
        assert!(!here.join(merged).join("summary.csv").exists());
    }
    // One that failed is no agreement either.
    let failed = |values: &mut Values| *values = Values::UNKNOWN;
    let (path, _) = with_other_numbers(here, "void", failed);
    let held = Catalog::read(&path, &sweep.output, Inspection::Bytes).expect("results");
    assert_eq!(held.holds(id), Some(Status::Converged), "converged to nothing");
    assert_eq!(code(&say(here, &["merge", "whole", "void", "-o", "g"])), 4, "NaN agrees with no number");
}

#[test]
fn a_merge_that_is_killed_is_started_again() {
    let directory = with_sweep();
    let here = directory.path();
    for part in ["1/2", "2/2"] {
        run_part(here, "out", part, "2");
    }
    for pause in [0, 1, 3, 6, 10, 20] {
        let mut command = stribeck(here);
        let mut child =
            command.args(["merge", "out"]).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("started");
        std::thread::sleep(std::time::Duration::from_millis(pause));
        child.kill().expect("killed, or gone");
        child.wait().expect("gone");
    }
    merge(here, &["out"]);
    assert_same(&here.join("out"));
    assert_eq!(code(&say(here, &["verify", "out"])), 0);
}
