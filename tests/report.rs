//! `stribeck report` from outside: the page holds what was published, says what it leaves out, and works in a browser.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::in_python::{check, file_of_python};
use crate::program::{code, err, out, say, with_results};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::Value;
use stribeck::report::page;
use stribeck_solver::continuation::Seed;
use stribeck_solver::{FieldSelection, Fields, Output};
use stribeck_sweep::store::{CaseEntry, DataSet, Status, Store, Timing};
use stribeck_sweep::{CaseId, Column, Field, Values};
use tempfile::{TempDir, tempdir};

/// All that is awkward: no dissipation, infinite α, cases that fail, a title that looks like a page.
const ODD: &str = r#"
title = "Odd </script><script>window.broken = 1</script> <!-- {{sweep}} & \"more\""
[axes]
f = [0.0, 10.0, 100.0]
alpha = [0.1, 1.0, 10.0, inf]
beta = [10.0, 100.0, 1000.0, 1e60]
[output]
x = { from = -2.0, to = 3.0, points = 201 }
"#;

/// Makes the page of the results and returns what the program prints.
fn report(directory: &Path) -> String {
    let run = say(directory, &["report", "results/small"]);
    assert_eq!((code(&run), err(&run).as_str()), (0, ""));
    out(&run)
}

/// The numbers of a page.
fn contents(html: &str) -> Value {
    let (_, rest) = html.split_once("<script type=\"application/json\" id=\"contents\">").expect("the numbers");
    serde_json::from_str(rest.split_once("</script>").expect("their end").0).expect("JSON")
}

fn bytes(text: &Value) -> Vec<u8> {
    STANDARD.decode(text.as_str().expect("a text")).expect("base64")
}

fn floats(text: &Value) -> Vec<f64> {
    bytes(text).as_chunks().0.iter().map(|four| f64::from(f32::from_le_bytes(*four))).collect()
}

fn integers(text: &Value) -> Vec<i32> {
    bytes(text).as_chunks().0.iter().map(|four| i32::from_le_bytes(*four)).collect()
}

fn shorts(text: &Value) -> Vec<usize> {
    bytes(text).as_chunks().0.iter().map(|two| usize::from(u16::from_le_bytes(*two))).collect()
}

/// A published sweep of made-up cases; one in `failing` fails, none if it is 0.
fn made_up(directory: &Path, shape: [usize; 3], output: &Output, failing: usize) -> DataSet {
    let axis = |count: usize, from: f64| -> Vec<f64> { (0..count).map(|i| from * 1.07_f64.powi(i as i32)).collect() };
    let (f, alpha, beta) = (axis(shape[0], 1.0), axis(shape[1], 0.01), axis(shape[2], 10.0));
    let place = |i_f: usize, i_alpha: usize, i_beta: usize| (i_f * shape[1] + i_alpha) * shape[2] + i_beta;
    let id = |place: usize| CaseId(0x9E37_79B9_7F4A_7C15_u64.wrapping_mul(place as u64 + 1));
    let entry = |place: usize| {
        let failed = failing > 0 && place.is_multiple_of(failing);
        let size = 1.0 + (place as f64 * 0.37).sin() / 2.0;
        // Without the last 36 bits, which would only keep the store busy with compressing them.
        let short = |value: f64| f64::from_bits(value.to_bits() & !0 << 36);
        let field = |wanted: bool, shape: &dyn Fn(f64) -> f64| {
            (!failed && wanted).then(|| output.x.iter().map(|x| short(shape(*x))).collect::<Vec<f64>>())
        };
        CaseEntry {
            id: id(place),
            outcome: if failed { Status::Failed } else { Status::Converged },
            reason: if failed { format!("stalled after {place} passes, residual 1e-3") } else { String::new() },
            failure_kind: failed.then(|| "stalled".to_owned()),
            values: match failed {
                true => Values::UNKNOWN,
                false => Values(std::array::from_fn(|i| size * 10_f64.powi(i as i32 - 12) / 3.0)),
            },
            fields: Fields {
                pressure: field(output.fields.pressure, &|x| {
                    (1.0 - (x / size).powi(2)).max(0.0).sqrt() + 0.4 * (-((x + 0.9) / 0.03).powi(2)).exp()
                }),
                film_thickness: field(output.fields.film_thickness, &|x| {
                    1e-4 * size + (x.abs() - size).max(0.0).powi(2)
                }),
                displacement: field(output.fields.displacement, &|x| -0.3 * size * (-x * x).exp()),
                shear_traction: field(output.fields.shear_traction, &|x| 0.1 / (1e-2 + x * x)),
                hysteresis_traction: field(output.fields.hysteresis_traction, &|x| x * (-x * x / size).exp()),
            },
            sensitivities: None,
            sensitivity_errors: None,
            timing: Timing {
                seconds: 1e-3 * size,
                iterations: 5,
                factorisations: 2,
                seed: Some(Seed::Predictor),
                time_limit: None,
            },
        }
    };
    let mut store = Store::open(directory, "", output).unwrap();
    store.begin("made-up", 0, 1).unwrap();
    for i_f in 0..shape[0] {
        for i_alpha in 0..shape[1] {
            let chain: Vec<CaseEntry> = (0..shape[2]).map(|i_beta| entry(place(i_f, i_alpha, i_beta))).collect();
            store.commit(&chain).unwrap();
        }
    }
    let cases = |i_f: usize, i_alpha: usize| (0..shape[2]).map(|i_beta| id(place(i_f, i_alpha, i_beta))).collect();
    crate::grids::publish(&mut store, ["made up", "# none\n"], [&f, &alpha, &beta], &cases).unwrap();
    drop(store);
    DataSet::open(directory).unwrap()
}

fn points(count: usize) -> Output {
    let x = (0..count).map(|i| -3.0 + 6.0 * i as f64 / (count as f64 - 1.0)).collect();
    Output { x, ..Output::default() }
}

/// Seven digits of every number, and every field as near as the page says.
#[test]
fn a_page_of_61_by_41_by_3_cases_with_fields_is_small_and_holds_their_numbers() {
    let directory = tempdir().unwrap();
    let data = made_up(directory.path(), [3, 61, 41], &points(601), 0);
    let page = page(&data, None, None).unwrap();
    assert!(page.html.len() < 14_000_000, "{} bytes", page.html.len());
    let note = page.notes.iter().find(|note| note.starts_with("Fields are shown at")).expect("fields are thinned");
    let (_, rest) = note.split_once("off by at most ").expect("how far lines are off");
    let promised: f64 = rest.split_once(" %").expect("in percent").0.parse::<f64>().expect("a number") / 100.0;
    assert!(promised > 0.0 && promised < 0.05, "{note}");

    let contents = contents(&page.html);
    let written = contents["columns"].as_array().unwrap();
    assert!(written.len() >= 18);
    for written in written {
        let column = Column::named(written["name"].as_str().unwrap()).expect("a column");
        for (written, value) in floats(&written["values"]).iter().zip(data.column(column).unwrap()) {
            assert!((written / value - 1.0).abs() < 1e-7, "{}: {written}, {value}", column.name());
        }
    }

    let fields = &contents["fields"];
    let (x, slots, indices) = (floats(&fields["x"]), integers(&fields["slots"]), shorts(&fields["indices"]));
    let kept = fields["points"].as_u64().unwrap() as usize;
    assert!(kept >= 48 && slots.iter().all(|slot| *slot >= 0), "every case has its fields, at {kept} points");
    for field in Field::ALL {
        let part = &fields["fields"][field.name()];
        let (low, high, steps) = (floats(&part["low"]), floats(&part["high"]), shorts(&part["steps"]));
        for place in (0..slots.len()).step_by(97) {
            let slot = slots[place] as usize;
            let own = slot * kept..(slot + 1) * kept;
            let logarithmic = part["logarithmic"][slot] == 1;
            let span = high[slot] - low[slot];
            let shown: Vec<f64> =
                steps[own.clone()].iter().map(|step| low[slot] + span * *step as f64 / 65535.0).collect();
            let indices_on = [place / (61 * 41), place / 41 % 61, place % 41];
            let whole = data.field(field, indices_on).unwrap();
            let chosen = &indices[own];
            assert_eq!((chosen[0], chosen[kept - 1]), (0, x.len() - 1));
            for (pair, values) in chosen.windows(2).zip(shown.windows(2)) {
                for (i, value) in whole.iter().enumerate().take(pair[1] + 1).skip(pair[0]) {
                    let share = (i - pair[0]) as f64 / (pair[1] - pair[0]) as f64;
                    let drawn = values[0] + share * (values[1] - values[0]);
                    let true_value = if logarithmic { value.log10() } else { *value };
                    // Half a unit of the last digit of the promise, half a step of the range, and seven digits.
                    let allowed = (promised + 0.0005 + 0.5 / 65535.0) * span + 2e-7 * true_value.abs();
                    assert!(
                        (drawn - true_value).abs() <= allowed,
                        "{field:?} of {place} at {i}: {drawn}, {true_value}"
                    );
                }
            }
        }
    }
}

/// 60 000 places, of which 30 000 are shown, as many as a page has at most; every tenth failed for a reason of its own.
/// Their fields take all the room that fields may take.
#[test]
fn a_large_grid_is_thinned_to_fewer_than_14_megabytes_and_the_page_says_so() {
    let directory = tempdir().unwrap();
    let fields = FieldSelection { pressure: true, ..FieldSelection::default() };
    let data = made_up(directory.path(), [3, 100, 200], &Output { fields, ..points(101) }, 10);
    let page = page(&data, None, None).unwrap();
    assert!((11_000_000..14_000_000).contains(&page.html.len()), "{} bytes", page.html.len());
    let said = |words: &str| assert!(page.notes.iter().any(|note| note.contains(words)), "{words}: {:?}", page.notes);
    said("Of the 3 × 100 × 200 places of the sweep");
    said("one in ");
    said("Of 6000 failed places the first 1000 are listed");
    let contents = contents(&page.html);
    assert_eq!(contents["shape"], serde_json::json!([3, 100, 200]));
    let axes = contents["axes"].as_array().unwrap();
    for (axis, values) in axes.iter().zip(data.dimensions.iter().map(|dimension| &dimension.values)) {
        let shown: Vec<f64> = axis.as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect();
        assert_eq!((shown.first(), shown.last()), (values.first(), values.last()), "both ends are there");
        assert!(shown.iter().all(|value| values.contains(value)));
    }
    let kinds = contents["failures"]["kinds"].as_array().unwrap();
    assert_eq!((kinds.len(), kinds[0]["count"].as_u64(), &kinds[0]["varied"]), (1, Some(6000), &Value::Bool(true)));
    let (reasons, reason_of) = (&contents["failures"]["reasons"], integers(&contents["failures"]["reason_of"]));
    let status = integers(&contents["status"]);
    assert_eq!(reason_of.len(), status.len());
    for (reason, status) in reason_of.iter().zip(&status) {
        assert_eq!(*reason >= 0, *status == 1, "a failed place has its reason");
    }
    let different: BTreeSet<&str> = reasons.as_array().unwrap().iter().map(|reason| reason.as_str().unwrap()).collect();
    assert_eq!(different.len(), status.iter().sum::<i32>() as usize);
}

#[test]
fn the_same_results_give_the_same_page_and_nothing_else_is_replaced() {
    let directory = with_results(ODD);
    let here = directory.path();
    let said = report(here);
    assert!(said.starts_with("results/small/report.html: "), "{said}");
    assert!(said.contains("note: Numbers are shown to at most seven digits"), "{said}");
    let file = here.join("results/small/report.html");
    let first = fs::read(&file).unwrap();
    report(here);
    assert!(fs::read(&file).unwrap() == first, "the same bytes");
    let verify = say(here, &["verify", "results/small"]);
    assert_eq!(code(&verify), 0, "a page beside the results is no damage: {}", out(&verify));

    let run = say(here, &["report", "results/small", "-o", "page.html"]);
    assert_eq!((code(&run), out(&run).lines().next().unwrap().starts_with("page.html: ")), (0, true));
    assert!(fs::read(here.join("page.html")).unwrap() == first);

    for foreign in ["<!DOCTYPE html>\n<p>mine</p>, and long enough to hold a beginning", "short", ""] {
        fs::write(&file, foreign).unwrap();
        let run = say(here, &["report", "results/small"]);
        assert_eq!(code(&run), 4);
        let expected =
            "report.html is there, which `stribeck report` has not written; move it away, or choose another place";
        assert!(err(&run).contains(expected), "{}", err(&run));
        assert_eq!(fs::read_to_string(&file).unwrap(), foreign);
    }
}

#[test]
fn what_has_no_page_is_said() {
    let directory = with_results(ODD);
    let here = directory.path();
    for (arguments, expected) in [
        (&["report", "nowhere"][..], "there is no such directory"),
        (&["report", "."], "has no results.h5"),
        (&["report", "results/small", "-o", "none/page.html"], "cannot write none/"),
        (&["report", "results/small", "-o", "results"], "cannot write results: is a directory"),
        (&["report", "results/small", "-o", "none/.."], "cannot write none/..: "),
    ] {
        let run = say(here, arguments);
        assert_eq!(code(&run), 4, "{arguments:?}: {}", err(&run));
        assert!(err(&run).contains(expected), "{arguments:?}: {}", err(&run));
    }
    assert_eq!(code(&say(here, &["report"])), 2);
    assert!(!here.join("results/small/report.html").exists());
}

/// Cases are solved, and the run ends before it publishes them.
#[test]
fn a_page_of_outdated_results_says_so() {
    let directory = tempdir().unwrap();
    let data = made_up(directory.path(), [1, 2, 2], &points(11), 0);
    assert!(!data.outdated);
    drop(data);
    let mut store = Store::open(directory.path(), "", &points(11)).unwrap();
    store.begin("made-up", 1, 1).unwrap();
    let late = CaseEntry {
        id: CaseId(7),
        outcome: Status::Failed,
        reason: "late".into(),
        failure_kind: None,
        values: Values::UNKNOWN,
        fields: Fields::default(),
        sensitivities: None,
        sensitivity_errors: None,
        timing: Timing::default(),
    };
    store.commit(&[late]).unwrap();
    drop(store);
    let run = say(directory.path(), &["report", "."]);
    assert_eq!(code(&run), 0);
    assert!(err(&run).contains("warning: cases were solved after") && err(&run).contains("run the sweep to its end"));
    let html = fs::read_to_string(directory.path().join("report.html")).unwrap();
    assert_eq!(contents(&html)["outdated"], true);
}

#[test]
#[ignore = "slow: a browser draws surfaces without a graphics processor"]
fn a_reader_finds_in_the_page_what_was_published() {
    for sweep in [ODD, &ODD.replace(", 1e60", "").replace("Odd", "Whole")] {
        let directory = with_results(sweep);
        report(directory.path());
        let results = directory.path().join("results/small");
        let mut command = file_of_python("tests/python/browse_report.py");
        let said = check(&command.arg(results.join("report.html")).arg(&results).output().unwrap());
        assert!(said.contains("the page does what it says"), "{said}");
    }
}

/// The picture that a page begins with stands in it, before its numbers and the drawing library: the map of a sweep over
/// two axes, with a cell for each case, and else the friction curve. Where every case failed there is none.
#[test]
fn a_page_holds_its_first_picture() {
    let line = "[axes]\nf = [10.0]\nalpha = [1.0]\nbeta = [10.0, 20.0, 40.0]\n[output]\nfields = []\n";
    for (sweep, section, hidden, cells) in
        [(ODD, "plane", "friction-section", 16), (line, "friction-section", "plane", 0)]
    {
        let directory = with_results(sweep);
        report(directory.path());
        let html = fs::read_to_string(directory.path().join("results/small/report.html")).unwrap();
        let at = |words: &str| html.find(words).unwrap_or_else(|| panic!("{words}"));
        let (own, picture) = (at(&format!("<section id=\"{section}\"")), at("<div class=\"first\""));
        assert!(own < picture && picture < at("id=\"contents\"") && at("id=\"contents\"") < at("id=\"plotly\""));
        assert!(!html[own..picture].contains("</section>") && !html[own..own + 90].contains(" hidden>"));
        assert!(html[at(&format!("<section id=\"{hidden}\""))..][..90].contains(" hidden>"));
        let first = html[picture..].split_once("</svg>").expect("an element").0;
        assert!(first.contains("var(--ink-text, #222222)") && !first.contains("fill=\"#222222\""));
        let crosses = first.matches("<rect").count();
        assert!(if cells > 0 { crosses >= cells } else { first.matches("<polygon").count() >= 3 }, "{first}");
    }
    let failed = with_results(&line.replace("[10.0, 20.0, 40.0]", "[1e60, 1e61]"));
    say(failed.path(), &["report", "results/small"]);
    let html = fs::read_to_string(failed.path().join("results/small/report.html")).unwrap();
    assert!(!html.contains("<div class=\"first\""));
}

/// In a browser it is seen before the live picture, in its place, and without any script.
#[test]
#[ignore = "slow: a browser draws pictures without a graphics processor"]
fn the_first_picture_is_seen_before_the_drawing_library_starts() {
    let directories = [ODD, ROLLING].map(with_results);
    let mut command = file_of_python("tests/python/first_picture.py");
    for directory in &directories {
        report(directory.path());
        command.arg(directory.path().join("results/small/report.html"));
    }
    let said = check(&command.output().unwrap());
    assert_eq!(said.matches("first picture after").count(), directories.len(), "{said}");
}

/// An experiment with two soft bodies that roll and slide.
const ROLLING: &str = r#"
[flat]
relaxed_modulus = "1.2 MPa"
poisson_ratio = 0.5
relaxation = [{ modulus = "1607.1 kPa", time = "1 s" }, { modulus = "228.6 kPa", time = "10 s" }]
[roller]
relaxed_modulus = "3 MPa"
poisson_ratio = 0.5
relaxation = [{ modulus = "3 MPa", time = "0.1 s" }]
[laboratory]
radius = "5 mm"
load = "200 N/m"
viscosity = "1 Pa s"
entrainment_speed = { from = "1 um/s", to = "1 m/s", points = 19, scale = "log" }
slide_roll_ratio = 0.5
[output]
fields = ["pressure"]
x = { from = -2.0, to = 2.0, points = 51 }
"#;

/// One of an experiment, and one whose errors are large enough for bars.
#[test]
#[ignore = "slow: a browser draws pictures without a graphics processor"]
fn sweeps_with_one_axis_begin_with_a_friction_curve_that_adds_up() {
    // Next to the same case three times, so that the error of a coarse grid is seen beside what they differ by.
    let rough = r#"
[axes]
f = [1.0]
alpha = [1.0]
beta = [10.0, 10.1, 10.2]
[solver]
method = "relaxation"
[solver.relaxation]
points = 201
estimate = true
[output]
fields = []
"#;
    let mut command = file_of_python("tests/python/browse_friction.py");
    let directories = [ROLLING, rough].map(with_results);
    for directory in &directories {
        report(directory.path());
        let results = directory.path().join("results/small");
        command.arg(results.join("report.html")).arg(results);
    }
    let said = check(&command.output().unwrap());
    assert!(said.contains("every friction curve is the sum of its parts"), "{said}");
}

/// Whatever is missing is said in words, and nothing is drawn empty.
#[test]
#[ignore = "slow: a browser draws surfaces without a graphics processor"]
fn pages_of_sweeps_of_any_shape_say_what_they_lack() {
    let axes = |f: &str, alpha: &str, beta: &str, output: &str| {
        format!("[axes]\nf = [{f}]\nalpha = [{alpha}]\nbeta = [{beta}]\n[output]\n{output}\n")
    };
    let two_loads = "[laboratory]\nradius = 0.005\nload = [200.0, 500.0]\nrelaxed_modulus = 1e6\npoisson_ratio = 0.5\n\
                     viscosity = 1.0\nretardation_time = 1.0\nf = 1.0\nspeed = [0.001, 0.01]\n";
    let sweeps: [(String, &[&str]); 9] = [
        (two_loads.into(), &["μ_drag = μᵥ + μ_shear − μ_pressure, at f = 1, N = "]),
        (
            axes("10.0", "1.0", "10.0, 20.0, 40.0", "fields = []"),
            &["μ_drag = μᵥ + μ_shear − μ_pressure, at f = 10, α = 1.", "The sweep has no fields."],
        ),
        (axes("0.0", "1.0, inf", "10.0", ""), &["μ_drag = μᵥ + μ_shear − μ_pressure, at f = 0, β = 10."]),
        (axes("1.0, 10.0", "1.0", "10.0", ""), &["μ_drag = μᵥ + μ_shear − μ_pressure, at α = 1, β = 10."]),
        (axes("10.0", "1.0", "10.0", ""), &["f = 10, α = 1, β = 10: converged, μₜₒₜ = "]),
        (axes("10.0, 1e60", "1.0, 2.0", "10.0, 20.0", ""), &["At this f no case has this number", "4 failed"]),
        (
            axes("10.0", "1.0, 2.0", "1e60, 1e61", ""),
            &["Every case failed; the reasons are below.", "A failed case has no fields.", "4 places: beta = 1e60"],
        ),
        (
            axes("1.0, 2.0, 5.0, 10.0, 20.0", "0.0, 1.0, inf", "10.0, 20.0", "fields = [\"pressure\"]\nlimits = false"),
            &[
                "Not among the fields of this sweep: film thickness, displacement, shear traction, hysteresis traction.",
                "None: every case converged.",
            ],
        ),
        (
            axes("10.0", "1.0, 2.0", "10.0, 20.0", "fields = []")
                + "[solver]\nmethod = \"relaxation\"\n[solver.relaxation]\npoints = 201\n",
            &["No case has an estimated error above zero.", "estimate = true"],
        ),
    ];
    let mut pages: Vec<(TempDir, &[&str])> =
        sweeps.iter().map(|(sweep, words)| (with_results(sweep), *words)).collect();
    let untimed = with_results(ODD);
    fs::remove_file(untimed.path().join("results/small/timings.csv")).unwrap();
    pages.push((untimed, &["There is no timings.csv beside the data set, so nothing is known of seconds."]));
    // One browser for all.
    let mut command = file_of_python("tests/python/browse_any_report.py");
    for (directory, words) in &pages {
        report(directory.path());
        command.arg("--page").arg(directory.path().join("results/small/report.html")).args(*words);
    }
    let said = check(&command.output().unwrap());
    assert_eq!(said.matches("every picture shown is drawn").count(), pages.len(), "{said}");
}
