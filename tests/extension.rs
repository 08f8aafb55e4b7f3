//! A sweep that is changed after it was run: what is solved is used again where it can be, byte for byte; what cannot
//! be is told with its reason; and what is new agrees with a run of the changed sweep from scratch.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::program::{code, err, out, say};
use stribeck_solver::Output;
use stribeck_solver::collocation::RESULTS_VERSION;
use stribeck_sweep::CaseId;
use stribeck_sweep::store::{CaseEntry, Catalog, Inspection, Status, Store, Timing};
use stribeck_sweep::{Fingerprint, Plan, Recipe, SolverRecipe, Sweep};
use tempfile::{TempDir, tempdir};

/// The tolerance of [`BASE`].
const TOLERANCE: f64 = 1e-6;

/// A sweep file of which each part can be changed.
#[derive(Clone)]
struct Text {
    f: &'static str,
    alpha: &'static str,
    beta: &'static str,
    solver: &'static str,
    output: &'static str,
}

const BASE: Text = Text {
    f: "[0.0, 10.0, 100.0]",
    alpha: "[0.1, 1.0, 10.0]",
    beta: "[10.0, 20.0, 40.0, 80.0, 160.0]",
    solver: "tolerance = 1e-6",
    output: "fields = [\"pressure\"]\nx = [-1.0, 0.0, 1.0]\nlimits = false",
};

impl Text {
    fn write(&self, directory: &Path) {
        let Self { f, alpha, beta, solver, output } = self;
        let text = format!("[axes]\nf = {f}\nalpha = {alpha}\nbeta = {beta}\n[solver]\n{solver}\n[output]\n{output}\n");
        fs::write(directory.join("sweep.toml"), text).expect("written");
    }
}

/// Rows of the summary by (f, α, β), as text.
type Rows = BTreeMap<String, Vec<String>>;

fn rows(results: &Path) -> Rows {
    let text = fs::read_to_string(results.join("summary.csv")).expect("published");
    let row = |line: &str| {
        let cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        (cells[1..4].join(","), cells)
    };
    text.lines().map(row).collect()
}

/// The state line of `plan`, and its other lines.
fn plan(directory: &Path) -> (String, String) {
    let plan = say(directory, &["plan", "sweep.toml", "-o", "out"]);
    assert_eq!(code(&plan), 0, "{}", err(&plan));
    let text = out(&plan);
    let state = text.lines().find_map(|line| line.strip_prefix("state      ")).expect("a state").to_owned();
    (state, text)
}

fn run(directory: &Path, text: &Text) -> Rows {
    text.write(directory);
    let run = say(directory, &["run", "sweep.toml", "-o", "out", "--quiet"]);
    assert_eq!(code(&run), 0, "{}", err(&run));
    rows(&directory.join("out"))
}

fn ran(text: &Text) -> (TempDir, Rows) {
    let directory = tempdir().expect("a temporary directory");
    let rows = run(directory.path(), text);
    (directory, rows)
}

/// New rows agree with those of a run from scratch within the tolerance, reused ones have the bytes they had.
fn compare(before: &Rows, after: &Rows, fresh: &Rows, tolerance: f64) {
    assert_eq!(after.keys().collect::<Vec<_>>(), fresh.keys().collect::<Vec<_>>());
    let header = &after["f,alpha,beta"];
    let column = |name: &str| header.iter().position(|cell| cell == name).expect("a column");
    for (place, row) in after.iter().filter(|(place, _)| *place != "f,alpha,beta") {
        if let Some(old) = before.get(place) {
            assert_eq!(old, row, "a reused row keeps its bytes");
            continue;
        }
        for name in ["mu_v", "mu_h", "c"] {
            let number = |row: &[String], name: &str| row[column(name)].parse::<f64>().expect("a number");
            let (here, there) = (number(row, name), number(&fresh[place], name));
            // The error of mu_v is relative to a thousandth of mu_tot where that is larger.
            let scale = if name == "mu_v" { there.abs().max(1e-3 * number(row, "mu_tot")) } else { there.abs() };
            assert!((here - there).abs() <= tolerance * scale, "{place}: {name} {here:e} and {there:e}");
        }
    }
}

#[test]
fn values_added_to_any_axis_reuse_all_that_is_there() {
    // Elastic cases (f = 0) are solved once for all α: 5; the others stand at 2 f and 3 α.
    let changes = [
        (Text { f: "[0.0, 10.0, 30.0, 100.0]", ..BASE }, "35 reused, 15 new"),
        (Text { alpha: "[0.1, 1.0, 3.0, 10.0]", ..BASE }, "35 reused, 10 new"),
        (Text { alpha: "[0.1, 1.0, 10.0, inf]", ..BASE }, "35 reused, 0 new"),
        (Text { beta: "[5.0, 10.0, 20.0, 30.0, 40.0, 80.0, 160.0, 320.0]", ..BASE }, "35 reused, 21 new"),
        (Text { f: "[10.0, 50.0]", alpha: "[1.0, 2.0]", beta: "[20.0, 25.0]", ..BASE }, "1 reused, 7 new"),
    ];
    for (changed, expected) in changes {
        let (directory, before) = ran(&BASE);
        changed.write(directory.path());
        let (state, text) = plan(directory.path());
        assert_eq!(state, format!("{expected}, 0 failed before"), "{text}");
        let after = run(directory.path(), &changed);
        compare(&before, &after, &ran(&changed).1, TOLERANCE);
        assert_eq!(code(&say(directory.path(), &["verify", "out"])), 0);
    }
}

#[test]
fn values_taken_from_any_axis_take_their_rows_and_give_them_back() {
    for (smaller, left, others) in [
        (Text { f: "[0.0, 100.0]", ..BASE }, 20, 15),
        (Text { alpha: "[1.0]", ..BASE }, 15, 20),
        (Text { beta: "[20.0, 160.0]", ..BASE }, 14, 21),
    ] {
        let (directory, before) = ran(&BASE);
        smaller.write(directory.path());
        let (state, text) = plan(directory.path());
        assert_eq!(state, format!("{left} reused, 0 new, 0 failed before"), "{text}");
        assert!(text.contains(&format!("others     {others} cases stored have no place in this sweep")), "{text}");
        let after = run(directory.path(), &smaller);
        assert!(after.len() < before.len() && after.iter().all(|(place, row)| before[place] == *row));
        BASE.write(directory.path());
        assert_eq!(plan(directory.path()).0, "35 reused, 0 new, 0 failed before");
        assert!(run(directory.path(), &BASE) == before);
    }
}

#[test]
fn only_missing_cases_are_solved() {
    let (directory, _) = ran(&BASE);
    run(directory.path(), &Text { beta: "[10.0, 20.0, 30.0, 40.0, 80.0, 160.0]", ..BASE });
    // A record of a log for each commit, with the cases of it.
    let mut committed = 0;
    for log in fs::read_dir(directory.path().join("out/log")).expect("listed") {
        let text = fs::read_to_string(log.expect("listed").path()).expect("read");
        for line in text.lines() {
            let line: serde_json::Value = serde_json::from_str(line).expect("JSON");
            committed += line["record"]["cases"].as_array().map_or(0, Vec::len);
        }
    }
    assert_eq!(committed, 35 + 7);
}

#[test]
fn another_tolerance_makes_cases_stale_and_the_old_one_finds_its_own_again() {
    let (directory, before) = ran(&BASE);
    let finer = Text { solver: "tolerance = 1e-7", ..BASE };
    finer.write(directory.path());
    let (state, text) = plan(directory.path());
    assert_eq!(state, "0 reused, 0 new, 35 stale, 0 failed before");
    assert!(text.contains("stale      35: solved with tolerance 1e-6, now 1e-7\n"), "{text}");
    assert!(!text.contains("others"), "{text}");
    let status = out(&say(directory.path(), &["status", "out"]));
    assert!(status.contains("to do      0\n"), "the directory still has the sweep that was run: {status}");
    let after = run(directory.path(), &finer);
    assert!(after.iter().all(|(place, row)| place == "f,alpha,beta" || before[place][0] != row[0]), "other ids");
    compare(&Rows::new(), &after, &ran(&finer).1, 1e-7);
    BASE.write(directory.path());
    assert_eq!(plan(directory.path()).0, "35 reused, 0 new, 0 failed before");
    // Some of both: what is stale is told from what is new.
    Text { solver: "tolerance = 1e-8", alpha: "[1.0, 2.0]", ..BASE }.write(directory.path());
    let (state, text) = plan(directory.path());
    assert_eq!(state, "0 reused, 10 new, 15 stale, 0 failed before", "{text}");
}

#[test]
fn what_was_stored_without_a_field_or_limit_is_stale_and_says_so() {
    let x = "x = [-1.0, 0.0, 1.0]";
    let wanted = |fields: &str, x: &str, limits: bool| -> Text {
        let output = format!("fields = {fields}\n{x}\nlimits = {limits}");
        Text { output: Box::leak(output.into_boxed_str()), ..BASE }
    };
    for (changed, lacks) in [
        (wanted(r#"["pressure", "displacement"]"#, x, false), "displacement"),
        (wanted(r#"["pressure", "film_thickness", "displacement"]"#, x, true), "film_thickness, displacement, limits"),
        (wanted(r#"["pressure"]"#, "x = [-1.0, 1.0]", false), "fields on this x"),
        (wanted(r#"["pressure"]"#, x, true), "limits"),
    ] {
        let (directory, before) = ran(&BASE);
        changed.write(directory.path());
        let (state, text) = plan(directory.path());
        assert_eq!(state, "0 reused, 0 new, 35 stale, 0 failed before");
        assert!(text.contains(&format!("stale      35: stored without {lacks}\n")), "{lacks}: {text}");
        let told = say(directory.path(), &["run", "sweep.toml", "-o", "out", "--quiet"]);
        assert!(err(&told).contains(&format!("35 stale (stored without {lacks})")), "{}", err(&told));
        let after = rows(&directory.path().join("out"));
        let ids = |rows: &Rows| rows.values().map(|row| row[0].clone()).collect::<BTreeSet<_>>();
        assert_eq!(ids(&before), ids(&after), "the same cases");
        compare(&Rows::new(), &after, &ran(&changed).1, TOLERANCE);
    }
}

/// What an earlier version of the program, whose results had another version, left of a sweep.
fn stored_by_an_earlier_version(directory: &Path, sweep: &Sweep) -> usize {
    let now = Plan::new(sweep);
    let Recipe { solver: SolverRecipe::Collocation { version, tolerance, degree }, cavity_shear } = *now.recipe()
    else {
        panic!("the sweep is solved by collocation")
    };
    let solver = SolverRecipe::Collocation { version: version - 1, tolerance, degree };
    let earlier = Recipe { solver, cavity_shear };
    let (fingerprint, output) = (Fingerprint::new(&earlier), Output { limits: false, ..sweep.output.clone() });
    let recipe = serde_json::to_value(earlier).expect("words and numbers");
    let mut store = Store::open(directory, &sweep.text, &output).expect("opened").solving_with(recipe);
    let failed = |id: CaseId| CaseEntry {
        id,
        outcome: Status::Failed,
        reason: "an earlier version".to_owned(),
        failure_kind: None,
        values: stribeck_sweep::Values::UNKNOWN,
        fields: stribeck_solver::Fields::default(),
        sensitivities: None,
        sensitivity_errors: None,
        timing: Timing::default(),
    };
    let mut cases = 0;
    for chain in now.chains() {
        let entries: Vec<_> = now.parameters(&chain).iter().map(|case| failed(fingerprint.id(case))).collect();
        cases += entries.len();
        store.commit(&entries).expect("committed");
    }
    cases
}

#[test]
fn results_of_an_earlier_version_are_stale_and_never_used() {
    let directory = tempdir().expect("a temporary directory");
    BASE.write(directory.path());
    let sweep = Sweep::read(directory.path().join("sweep.toml")).expect("valid");
    let cases = stored_by_an_earlier_version(&directory.path().join("out"), &sweep);
    assert_eq!(cases, 35);
    let (state, text) = plan(directory.path());
    assert_eq!(state, "0 reused, 0 new, 35 stale, 0 failed before");
    let (before, now) = (RESULTS_VERSION - 1, RESULTS_VERSION);
    let why = format!("stale      35: solved with version of the results {before}, now {now}\n");
    assert!(text.contains(&why), "{text}");
    let after = run(directory.path(), &BASE);
    assert!(after == ran(&BASE).1, "as if the earlier version had never been");
    assert_eq!(plan(directory.path()).0, "35 reused, 0 new, 0 failed before");
}

#[test]
fn cases_whose_recipe_is_not_known_are_others() {
    let directory = tempdir().expect("a temporary directory");
    BASE.write(directory.path());
    let sweep = Sweep::read(directory.path().join("sweep.toml")).expect("valid");
    let results = directory.path().join("out");
    stored_by_an_earlier_version(&results, &sweep);
    // The log of a version that wrote no recipe, or one with a method that this version does not know.
    let log = results.join("log/0001.jsonl");
    let text = fs::read_to_string(&log).expect("read");
    let reframed = |change: &dyn Fn(&mut serde_json::Value)| -> String {
        let mut lines = String::new();
        for line in text.lines() {
            let mut record = serde_json::from_str::<serde_json::Value>(line).expect("JSON")["record"].take();
            change(&mut record);
            // Shards are recognised by their first key.
            let mut body = record.to_string();
            let rest = body.replacen("\"kind\":\"shard\",", "", 1);
            body = format!("{{\"kind\":\"shard\",{}", &rest[1..]);
            lines += &format!("{{\"crc\":\"{:08x}\",\"record\":{body}}}\n", crc32fast::hash(body.as_bytes()));
        }
        lines
    };
    type Change = fn(&mut serde_json::Value);
    let changes: [Change; 2] = [
        |record| drop(record.as_object_mut().expect("an object").remove("recipe")),
        |record| record["recipe"]["method"] = "telepathy".into(),
    ];
    for change in changes {
        fs::write(&log, reframed(&change)).expect("written");
        let (state, text) = plan(directory.path());
        assert_eq!(state, "0 reused, 35 new, 0 failed before", "{text}");
        assert!(text.contains("others     35 cases stored have no place in this sweep; they stay\n"), "{text}");
    }
    assert!(run(directory.path(), &BASE) == ran(&BASE).1);
}

#[test]
fn a_case_given_up_at_its_time_limit_is_tried_again_with_a_larger_one_only() {
    // So short that no machine is fast enough: the first look at the clock ends each case.
    let hasty = Text { solver: "tolerance = 1e-6\ntime_limit = 1e-9", ..BASE };
    let directory = tempdir().expect("a temporary directory");
    let here = directory.path();
    hasty.write(here);
    let command = ["run", "sweep.toml", "-o", "out", "--quiet"];
    let first = say(here, &command);
    assert_eq!(code(&first), 3, "{}", err(&first));
    assert!(out(&first).contains("not solved within 1e-9 s, the time limit of a case"), "{}", out(&first));
    let again = say(here, &command);
    assert_eq!(code(&again), 3);
    assert!(out(&again).contains("nothing to do"), "the same limit is no reason to try again: {}", out(&again));
    let hastier = Text { solver: "tolerance = 1e-6\ntime_limit = 1e-10", ..BASE };
    hastier.write(here);
    assert_eq!(plan(here).0, "0 reused, 0 new, 35 failed before");

    // A little more is not enough either, and the new failure counts from then on.
    let less_hasty = Text { solver: "tolerance = 1e-6\ntime_limit = 2e-9", ..BASE };
    less_hasty.write(here);
    let (state, text) = plan(here);
    assert_eq!(state, "0 reused, 0 new, 35 stale, 0 failed before");
    assert!(text.contains("stale      35: given up at the time limit of 1e-9 s, now 2e-9\n"), "{text}");
    assert_eq!(code(&say(here, &command)), 3);
    assert_eq!(plan(here).0, "0 reused, 0 new, 35 failed before");

    BASE.write(here);
    assert_eq!(plan(here).0, "0 reused, 0 new, 35 stale, 0 failed before");
    assert!(run(here, &BASE) == ran(&BASE).1, "a time limit changes no number");
    hasty.write(here);
    assert_eq!(plan(here).0, "35 reused, 0 new, 0 failed before", "what is solved is solved");
}

#[test]
fn an_extension_that_is_killed_and_resumed_loses_nothing() {
    let wider = Text { beta: "{ from = 10.0, to = 160.0, points = 161 }", alpha: "[0.1, 0.5, 1.0, 10.0]", ..BASE };
    let (directory, before) = ran(&BASE);
    let results = directory.path().join("out");
    wider.write(directory.path());
    let held = |results: &Path| {
        Catalog::read(results, &Output::default(), Inspection::Bytes).expect("results").counts().converged
    };
    let had = held(&results);
    for _ in 0..3 {
        let mut child = crate::program::stribeck(directory.path())
            .args(["run", "sweep.toml", "-o", "out", "--quiet", "--threads", "1"])
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::null())
            .spawn()
            .expect("started");
        let there = held(&results);
        while held(&results) == there && child.try_wait().expect("asked").is_none() {
            std::thread::yield_now();
        }
        child.kill().expect("killed, or gone");
        child.wait().expect("gone");
    }
    assert!(held(&results) > had);
    let after = run(directory.path(), &wider);
    let (_, undisturbed) = {
        let (directory, _) = ran(&BASE);
        let rows = run(directory.path(), &wider);
        (directory, rows)
    };
    assert!(after == undisturbed, "an interrupted extension ends as one that was left alone");
    compare(&before, &after, &ran(&wider).1, TOLERANCE);
}
