//! Rolling, two bodies and notes, from the sweep file to what is published.

use std::collections::BTreeMap;
use std::path::Path;

use crate::program::{code, err, out, say, with_results};
use stribeck_sweep::store::DataSet;
use stribeck_sweep::{Column, Note};

const RATIOS: &str = "\
[axes]
slide_roll = [-0.5, 0.5, 1.0]
f = [10.0]
alpha = [1.0]
beta = [30.0, 100.0]
[output]
fields = [\"film_thickness\", \"shear_traction\"]
x = { from = -2.0, to = 2.0, points = 41 }
";

/// A rubber on a rubber, with rough surfaces.
const SWAPPED: &str = "\
[laboratory]
radius = \"10 mm\"
load = \"400 N/m\"
viscosity = \"80 mPa s\"
entrainment_speed = [\"5 mm/s\", \"0.5 m/s\"]
slide_roll_ratio = 0.5
swap = true
roughness = \"2 um\"
[flat]
relaxed_modulus = \"1.5 MPa\"
poisson_ratio = 0.5
relaxation = [{ fraction = 0.5, time = \"10 ms\" }]
[roller]
relaxed_modulus = \"3 MPa\"
poisson_ratio = 0.5
f = 1.0
retardation_time = \"2 ms\"
[output]
fields = []
";

type Row = BTreeMap<String, String>;

fn table(path: &Path) -> (Vec<String>, Vec<Row>) {
    let mut reader = csv::Reader::from_path(path).expect("a table");
    let header = reader.headers().expect("a header").iter().map(str::to_owned).collect();
    (header, reader.into_deserialize().map(|row| row.expect("a row")).collect())
}

fn number(row: &Row, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name} = {:?}", row[name]))
}

#[test]
fn a_slide_to_roll_ratio_is_the_first_dimension() {
    let directory = with_results(RATIOS);
    let results = directory.path().join("results/small");
    let (header, rows) = table(&results.join("summary.csv"));
    assert_eq!(header[..5], ["case", "slide_roll", "f", "alpha", "beta"]);
    assert_eq!(table(&results.join("timings.csv")).0[..5], header[..5]);
    let data = DataSet::open(&results).expect("published");
    assert_eq!(data.dimensions[0].name, "slide_roll");
    assert_eq!(data.shape().lengths(), [3, 1, 2]);
    assert_eq!(data.numbers().expect("numbers"), [[10.0, 1.0, 30.0], [10.0, 1.0, 100.0]].repeat(3));
    let drag = data.column(Column::MuDrag).expect("a column");
    for (place, row) in rows.iter().enumerate() {
        assert_eq!(number(row, "slide_roll"), [-0.5, 0.5, 1.0][place / 2]);
        assert_eq!(number(row, "mu_drag"), drag[place]);
        assert_eq!(row["case"], rows[place % 2]["case"], "one problem for all ratios");
        let made =
            number(row, "mu_v") - number(row, "mu_pressure") + number(row, "slide_roll") * number(row, "mu_shear");
        assert!((drag[place] / made - 1.0).abs() < 1e-8, "{} {made}", drag[place]);
    }
    let again = say(directory.path(), &["run", "small.toml", "--quiet"]);
    assert!(out(&again).contains("nothing to do"), "{}", out(&again));
}

#[test]
fn curves_run_along_the_ratio_and_a_case_has_its_command() {
    let directory = with_results(RATIOS);
    let plot = ["plot", "results/small", "--what", "curves", "--of", "mu_drag", "--along", "slide_roll"];
    let plotted = say(directory.path(), &plot);
    assert_eq!(code(&plotted), 0, "{}", err(&plotted));
    let (_, rows) = table(&directory.path().join("results/small/figures/mu_drag-along-slide_roll.csv"));
    assert_eq!(rows.len(), 6);
    let explained = say(directory.path(), &["explain", "results/small", &rows_case(directory.path())]);
    assert!(out(&explained).contains("--slide-roll -0.5"), "{}", out(&explained));
}

/// The id of the first case.
fn rows_case(directory: &Path) -> String {
    table(&directory.join("results/small/summary.csv")).1[0]["case"].clone()
}

#[test]
fn both_runs_and_their_averages_are_published_with_notes() {
    let directory = with_results(SWAPPED);
    let results = directory.path().join("results/small");
    let (header, rows) = table(&results.join("summary.csv"));
    assert_eq!(header[header.len() - 2..], ["mu_sliding", "mu_rolling"]);
    let [slower, faster] = [&rows[..2], &rows[2..]];
    for (slower, faster) in slower.iter().zip(faster) {
        assert_eq!((number(slower, "slide_roll_ratio"), number(faster, "slide_roll_ratio")), (-0.5, 0.5));
        assert_ne!(slower["case"], faster["case"], "the bodies creep at other rates");
        let [minus, plus] = [slower, faster].map(|row| number(row, "mu_drag"));
        for row in [slower, faster] {
            assert!((number(row, "mu_sliding") - 0.5 * (plus - minus)).abs() < 1e-15);
            assert!((number(row, "mu_rolling") - 0.5 * (plus + minus)).abs() < 1e-15);
            assert!(number(row, "mu_v_flat") > 0.0 && number(row, "mu_v_roller") > 0.0);
        }
    }
    let notes = DataSet::open(&results).expect("published").notes().expect("read").expect("there");
    for (row, notes) in rows.iter().zip(&notes) {
        let is_rough = number(row, "film_min") < 6e-6;
        assert_eq!(notes & Note::FilmRough.mask() != 0, is_rough, "{row:?}");
    }
    let rough = notes.iter().filter(|notes| *notes & Note::FilmRough.mask() != 0).count();
    assert!(rough == 2, "one speed has a thin film: {notes:?}");
    for command in [&["status", "results/small"][..], &["run", "small.toml", "--quiet"]] {
        let told = say(directory.path(), command);
        assert!(out(&told).contains("note: film_rough at 2 of 4 places: "), "{}", out(&told));
    }
    let (plan, curve) =
        (say(directory.path(), &["plan", "small.toml"]), ["curve", "small.toml", "--at", "slide_roll_ratio=0.5"]);
    assert!(out(&plan).contains("\ncavity     full: ") && out(&plan).contains("p_max"), "{}", out(&plan));
    let curve = say(directory.path(), &curve);
    assert!(
        out(&curve).contains("solved: p_max ") && out(&curve).contains("note: film_rough at 1 of 2"),
        "{}",
        out(&curve)
    );
}

/// `solve` reaches a case of two bodies with the command that a sweep names it by.
#[test]
fn the_command_of_a_case_of_two_bodies_has_its_id() {
    let directory = with_results(SWAPPED);
    let id = rows_case(directory.path());
    let explained = out(&say(directory.path(), &["explain", "results/small", &id]));
    let command = explained.lines().find_map(|line| line.trim().strip_prefix("alone")).expect("a command");
    assert!(command.contains("--roller-modes"), "{command}");
    let arguments: Vec<&str> = command.trim().strip_prefix("stribeck ").expect("a command").split(' ').collect();
    let solved = say(directory.path(), &arguments);
    assert!(out(&solved).contains(&format!("case {id},")), "{}", out(&solved));
}

/// Published derivatives against differences of fourth order of the results themselves, for inputs of both bodies and for
/// their speeds.
#[test]
fn sensitivities_to_both_bodies_are_the_derivatives_of_what_is_published() {
    const STEP: f64 = 0.02;
    // each key once in the file: those of the roller end in 1
    let inputs = [
        ("relaxed_modulus", 1.5e6),
        ("f", 2.0),
        ("retardation_time", 0.01),
        ("entrainment_speed", 0.05),
        ("slide_roll_ratio", 0.6),
        ("roller_instantaneous_modulus", 6e6),
        ("roller_f", 3.0),
        ("roller_retardation_time", 0.004),
    ];
    for (varied, value) in inputs {
        let rows: Vec<Row> = (-2..=2)
            .map(|i| {
                let of = |name: &str| {
                    let (_, value) = inputs.iter().find(|(input, _)| *input == name).expect(name);
                    if name == varied { value * (STEP * f64::from(i)).exp() } else { *value }
                };
                let line = |name: &str| format!("{} = {:?}\n", name.trim_start_matches("roller_"), of(name));
                let flat: String = inputs[..5].iter().map(|(name, _)| line(name)).collect();
                let roller: String = inputs[5..].iter().map(|(name, _)| line(name)).collect();
                let sweep = format!(
                    "[laboratory]\nradius = 0.01\nload = 400.0\nviscosity = 0.08\npoisson_ratio = 0.5\n{flat}[roller]\n\
                     poisson_ratio = 0.4\n{roller}[solver]\ntolerance = 1e-9\n[output]\nfields = []\n\
                     sensitivities = true\n"
                );
                table(&with_results(&sweep).path().join("results/small/summary.csv")).1.remove(0)
            })
            .collect();
        let value = format!("{varied} = {value}");
        for mu in ["mu_v", "mu_h", "mu_tot", "mu_drag", "mu_pressure", "mu_shear"] {
            let at = |i: usize| number(&rows[i], mu).abs().ln();
            let difference = (8.0 * (at(3) - at(1)) - (at(4) - at(0))) / (12.0 * STEP);
            let stated = number(&rows[2], &format!("dln_{mu}_dln_{varied}"));
            assert!((stated - difference).abs() < 1e-5, "{mu} by {value}: {stated} {difference}");
            let error = number(&rows[2], &format!("error_dln_{mu}_dln_{varied}"));
            assert!((0.0..1e-4).contains(&error), "{mu} by {value}: {error:e}");
        }
    }
}

/// α and f of a dimensionless sweep are those of both bodies, of a roller that is at rest and has relaxed as well.
#[test]
fn sensitivities_to_alpha_and_f_are_the_derivatives_of_what_is_published() {
    const STEP: f64 = 0.02;
    let axis = |value: f64, moves: bool| {
        let steps = if moves { 0..=4 } else { 2..=2 };
        let values: Vec<f64> = steps.map(|i| value * (STEP * (f64::from(i) - 2.0)).exp()).collect();
        format!("{values:?}")
    };
    for (varied, moves) in [("alpha", [true, false]), ("f", [false, true])] {
        let (alpha, f) = (axis(0.5, moves[0]), axis(8.0, moves[1]));
        let sweep = format!(
            "[axes]\nslide_roll = [-0.5, 0.3, 1.0]\nalpha = {alpha}\nbeta = [100.0]\nf = {f}\n[flat]\nmodes = [{{ \
             share = 0.4, time = 1.0 }}]\n[roller]\nmodes = [{{ share = 0.6, time = 0.5 }}]\n[solver]\ntolerance = \
             1e-9\n[output]\nfields = []\nsensitivities = true\n"
        );
        let rows = table(&with_results(&sweep).path().join("results/small/summary.csv")).1;
        assert_eq!(rows.len(), 15);
        for rows in rows.chunks(5) {
            for mu in ["mu_v", "mu_h", "mu_tot", "mu_drag", "mu_pressure", "mu_shear"] {
                let at = |i: usize| number(&rows[i], mu).abs().ln();
                let difference = (8.0 * (at(3) - at(1)) - (at(4) - at(0))) / (12.0 * STEP);
                let stated = number(&rows[2], &format!("dln_{mu}_dln_{varied}"));
                let place = format!("{mu} by {varied} at S = {}", rows[2]["slide_roll"]);
                assert!((stated - difference).abs() < 1e-5, "{place}: {stated} {difference}");
            }
        }
    }
}

/// The relaxation method publishes the hysteresis of each body, that of collocation to what its grid leaves.
#[test]
fn both_methods_publish_the_hysteresis_of_each_body() {
    let rows = |method: &str| {
        let sweep = SWAPPED.replace("swap = true\n", "") + &format!("[solver]\nmethod = \"{method}\"\n");
        table(&with_results(&sweep.replace("\"5 mm/s\", ", "")).path().join("results/small/summary.csv")).1
    };
    for (relaxed, collocated) in rows("relaxation").iter().zip(rows("collocation")) {
        for column in ["mu_v_flat", "mu_v_roller", "mu_torque", "mu_drag"] {
            let (found, expected) = (number(relaxed, column), number(&collocated, column));
            let drag = number(&collocated, "mu_drag");
            assert!((found - expected).abs() < 3e-3 * drag, "{column}: {found} {expected}");
        }
    }
}
