//! `stribeck plot` from outside: what is drawn is what was published, and what cannot be drawn is said.

use std::collections::HashMap;
use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

use crate::program::{code, err, out, say, with_results};
use roxmltree::Document;
use stribeck_sweep::store::DataSet;
use stribeck_sweep::{Column, Field};
use tempfile::tempdir;

const SMALL: &str = r#"
title = "A small <sweep> & its pictures"
[axes]
f = [0.0, 10.0]
alpha = [0.1, 1.0, 10.0, inf]
beta = [10.0, 30.0, 100.0]
[output]
fields = ["pressure", "film_thickness", "displacement"]
x = { from = -2.0, to = 3.0, points = 2001 }
"#;

fn plot(directory: &Path, arguments: &[&str]) -> Vec<PathBuf> {
    let run = say(directory, &[&["plot", "results/small"], arguments].concat());
    assert_eq!(code(&run), 0, "{arguments:?}: {}", err(&run));
    assert_eq!(err(&run), "");
    let said = out(&run);
    let mut lines: Vec<&str> = said.lines().collect();
    let last = lines.pop().expect("a last line");
    assert!(last.contains(&format!("{} picture", lines.len())), "{said}");
    lines.into_iter().map(|line| directory.join(line)).collect()
}

/// The rows of a CSV file, by the names of its header.
fn rows(path: &Path) -> Vec<HashMap<String, String>> {
    let mut reader = csv::Reader::from_path(path).expect("a CSV file");
    reader.deserialize().map(|row| row.expect("a row")).collect()
}

fn number(row: &HashMap<String, String>, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name} of {row:?} is a number"))
}

fn only(pictures: &[PathBuf]) -> PathBuf {
    let [picture] = pictures else { panic!("one picture, not {pictures:?}") };
    picture.with_extension("csv")
}

/// Estimated errors are bars where they can be seen, and a word where they cannot.
#[test]
fn errors_are_bars_where_they_can_be_seen() {
    let axes = "[axes]\nf = [10.0]\nalpha = [1.0]\nbeta = [10.0, 30.0, 100.0]\n";
    let coarse = "[solver]\nmethod = \"relaxation\"\n[solver.relaxation]\npoints = 201\nestimate = true\n";
    for (solver, has_bars) in [(coarse, true), ("[solver]\ntolerance = 1e-5\n", false)] {
        let directory = with_results(&format!("{axes}{solver}[output]\nfields = []\n"));
        let run = say(directory.path(), &["plot", "results/small", "--what", "curves", "--of", "mu_h", "--bare"]);
        let said = out(&run);
        let largest = said.rsplit_once("estimated errors of curves are at most ").expect(&said).1;
        let largest: f64 = largest.split(' ').next().unwrap().parse().expect(largest);
        assert!(if has_bars { largest > 1e-4 } else { largest <= 1e-5 }, "{said}");
        let data = DataSet::open(&directory.path().join("results/small")).expect("published");
        let (values, errors) = (data.column(Column::MuH).unwrap(), data.column(Column::ErrorMuH).unwrap());
        let table = rows(&directory.path().join("results/small/figures/mu_h-along-beta.csv"));
        let bars: Vec<_> = table.iter().filter(|row| row["kind"] == "estimated error").collect();
        assert_eq!(!bars.is_empty(), has_bars, "{errors:?}");
        for bar in bars {
            let place = [10.0, 30.0, 100.0].iter().position(|beta| *beta == number(bar, "beta")).unwrap();
            assert_eq!(number(bar, "value"), values[place] * errors[place]);
        }
    }
}

#[test]
fn without_options_every_kind_is_drawn_in_each_format_with_its_numbers() {
    let directory = with_results(SMALL);
    let pictures = plot(directory.path(), &[]);
    let names: Vec<&str> = pictures.iter().map(|path| path.file_stem().unwrap().to_str().unwrap()).collect();
    for name in [
        "surface-mu_tot",
        "surface-mu_v",
        "map-mu_h",
        "mu_tot-along-f",
        "mu_v-along-alpha",
        "c-along-beta",
        "profile-pressure",
        "profile-film_thickness",
        "profile-displacement",
        "loop",
        "stress",
        "map-errors",
        "cost",
    ] {
        assert!(names.contains(&name), "{name} is not among {names:?}");
    }
    assert!(!names.contains(&"map-status"), "no case failed");
    for path in &pictures {
        let svg = fs::read_to_string(path).unwrap();
        let document = Document::parse(&svg).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert_eq!(document.root_element().attribute("width"), Some("700"));
        let texts: String =
            document.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect();
        assert!(texts.contains("A small <sweep> & its pictures"), "{}: {texts}", path.display());
        assert!(!svg.contains("NaN"), "{}", path.display());
        assert!(rows(&path.with_extension("csv")).len() > 1, "{}", path.display());
    }
    let first: Vec<Vec<u8>> = pictures.iter().map(|path| fs::read(path).unwrap()).collect();
    let again: Vec<Vec<u8>> = plot(directory.path(), &[]).iter().map(|path| fs::read(path).unwrap()).collect();
    assert!(first == again, "the same data are the same bytes");
    for path in plot(directory.path(), &["--format", "png"]) {
        let bytes = fs::read(&path).unwrap();
        assert!(bytes.starts_with(b"\x89PNG") && bytes[16..20] == 1600_u32.to_be_bytes(), "{}", path.display());
    }
    for path in plot(directory.path(), &["--format", "pdf", "--what", "curves,maps,stress"]) {
        assert!(fs::read(&path).unwrap().starts_with(b"%PDF-"), "{}", path.display());
    }
}

#[test]
fn the_numbers_of_curves_are_those_of_the_summary() {
    let directory = with_results(SMALL);
    let summary = rows(&directory.path().join("results/small/summary.csv"));
    for column in ["mu_tot", "film_min", "error_c"] {
        let picture = only(&plot(
            directory.path(),
            &["--what", "curves", "--of", column, "--along", "beta", "--f", "10", "--bare"],
        ));
        let drawn = rows(&picture);
        // f = 10 with four α and three β.
        assert_eq!(drawn.len(), 12);
        for row in drawn {
            let same = |other: &&HashMap<String, String>| {
                ["f", "alpha", "beta"].iter().all(|name| number(other, name) == number(&row, name))
            };
            let published = summary.iter().find(same).expect("a case of the summary");
            assert_eq!(number(published, column), number(&row, "value"), "{row:?}");
        }
    }
}

#[test]
fn the_numbers_of_profiles_are_those_of_the_fields() {
    let directory = with_results(SMALL);
    let data = DataSet::open(&directory.path().join("results/small")).unwrap();
    let options =
        ["--what", "profiles", "--of", "film_thickness", "--alpha", "0.1", "--beta", "10,100", "--f", "10", "--x=-1,1"];
    let drawn = rows(&only(&plot(directory.path(), &options)));
    let solved: Vec<_> = drawn.iter().filter(|row| row["kind"] == "solution").collect();
    assert_eq!(solved.len(), 2 * data.x.iter().filter(|x| x.abs() <= 1.0).count());
    for row in solved {
        let beta = data.dimensions[2].values.iter().position(|beta| *beta == number(row, "beta")).unwrap();
        let x = data.x.iter().position(|x| *x == number(row, "x")).unwrap();
        assert_eq!(data.field(Field::FilmThickness, [1, 0, beta]).unwrap()[x], number(row, "film_thickness"));
    }
    // The c of Eq. 49 is 40 % off at α = 0.1, and 2 % at α = 1 and β = 30.
    assert!(!drawn.iter().any(|row| row["kind"] == "large-β approximation"));
    let near = ["--what", "profiles", "--of", "film_thickness", "--alpha", "1", "--beta", "30", "--f", "10"];
    assert!(rows(&only(&plot(directory.path(), &near))).iter().any(|row| row["kind"] == "large-β approximation"));
    let elastic = ["--what", "profiles", "--of", "film_thickness", "--alpha", "1", "--beta", "10,100", "--f", "0"];
    let drawn = rows(&only(&plot(directory.path(), &elastic)));
    let approximate: Vec<f64> =
        drawn.iter().filter(|row| row["kind"] == "Eq. 36 of the paper").map(|row| number(row, "beta")).collect();
    assert!(!approximate.is_empty() && approximate.iter().all(|beta| *beta == 100.0), "{approximate:?}");
}

/// F_v = (2/π) ∫ p dw (Eq. 22): the area of the loop drawn, 0 for an elastic substrate.
#[test]
fn the_area_of_a_loop_is_the_viscoelastic_friction() {
    let directory = with_results(SMALL);
    let data = DataSet::open(&directory.path().join("results/small")).unwrap();
    let friction = data.column(Column::MuV).unwrap();
    for (i_f, f) in [(0, "0"), (1, "10")] {
        let options = ["--what", "loops", "--alpha", "1", "--beta", "100", "--f", f, "--bare"];
        let drawn = rows(&only(&plot(directory.path(), &options)));
        let area: f64 = drawn
            .windows(2)
            .map(|pair| {
                let [p0, p1] = [&pair[0], &pair[1]].map(|row| number(row, "pressure"));
                0.5 * (p0 + p1) * (number(&pair[1], "height") - number(&pair[0], "height"))
            })
            .sum::<f64>()
            * 2.0
            / PI;
        let wanted = friction[data.place([i_f, 1, 2])];
        assert!((area - wanted).abs() < 1e-3, "f = {f}: area {area}, friction {wanted}");
    }
}

/// Every plane below the surface carries the load π/2 (T4).
#[test]
fn the_stress_drawn_carries_the_load() {
    let directory = with_results(SMALL);
    let options = ["--what", "stress", "--alpha", "1", "--beta", "100", "--f", "10", "--x=-2,3"];
    let drawn = rows(&only(&plot(directory.path(), &options)));
    let shallow =
        drawn.iter().map(|row| number(row, "depth")).filter(|depth| *depth > 0.02).fold(f64::INFINITY, f64::min);
    let plane: Vec<_> = drawn.iter().filter(|row| number(row, "depth") == shallow).collect();
    let load: f64 = plane
        .windows(2)
        .map(|pair| {
            let [one, other] = [pair[0], pair[1]].map(|row| number(row, "stress"));
            -0.5 * (one + other) * (number(pair[1], "x") - number(pair[0], "x"))
        })
        .sum();
    assert!((load / (0.5 * PI) - 1.0).abs() < 0.01, "{load}");
}

#[test]
fn sweeps_of_any_shape_have_pictures() {
    let axes = |f: &str, alpha: &str, beta: &str, output: &str| {
        format!("[axes]\nf = [{f}]\nalpha = [{alpha}]\nbeta = [{beta}]\n[output]\n{output}\n")
    };
    // One case without fields has nothing to show but its cost; a failed one (β too large for doubles) not
    // even errors.
    for (sweep, wanted, missing) in [
        (axes("10.0", "1.0", "10.0, 20.0, 40.0", "fields = []"), "mu_tot-along-beta", "profile"),
        (axes("10.0", "1.0", "10.0, 20.0", ""), "profile-pressure", "map"),
        (axes("0.0", "1.0", "10.0", ""), "profile-film_thickness", "along"),
        (axes("10.0", "1.0", "10.0", "fields = []"), "cost", "curve"),
        (axes("10.0", "1.0", "1e60, 1e61", ""), "cost", "profile"),
        (axes("10.0", "0.0, 1.0, inf", "10.0, 20.0", "limits = false"), "map-errors", "surface"),
        (axes("10.0", "1.0, 2.0", "10.0, 1e60", "fields = []"), "map-status", "profile"),
    ] {
        let directory = with_results(&sweep);
        let names: Vec<String> = plot(directory.path(), &[])
            .iter()
            .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
            .collect();
        assert!(names.iter().any(|name| name == wanted), "{sweep}: {names:?}");
        assert!(!names.iter().any(|name| name.contains(missing)), "{sweep}: {names:?}");
    }
}

#[test]
fn what_cannot_be_drawn_is_said_and_nothing_is_written() {
    let directory = with_results(&SMALL.replace("\"pressure\", \"film_thickness\", \"displacement\"", "\"pressure\""));
    for (arguments, expected) in [
        (&["--of", "mu_q"][..], "--of mu_q: there is no such column or field here; give some of mu_v, mu_h"),
        (&["--of", "displacement"], "no such column or field"),
        (&["--beta", "5000"], "--beta 5000: the sweep has beta from 10 to 100"),
        (&["--alpha=-1"], "--alpha -1: the sweep has alpha from 0.1 to inf"),
        (&["--f", "nan"], "--f NaN"),
        (&["--what", "loops"], "no field film_thickness; add it to fields below [output]"),
        (&["--what", "stress"], "no field film_thickness"),
        (&["--what", "curves", "--along", "beta", "--beta", "10"], "beta has one value here, and a curve needs two"),
        (&["--what", "surfaces", "--alpha", "1"], "alpha has 1 value here"),
        (&["--what", "maps", "--beta", "30"], "beta has one value here, and a map needs two"),
        (&["--what", "profiles", "--x=5,6"], "--x 5,6 holds 0 of the x of this sweep, from -2 to 3"),
        (&["--what", "profiles", "--alpha", "1,10", "--beta", "10,30"], "give several values of one axis only"),
        (&["--what", "curves", "--of", "mu_v,c", "--together"], "mu_v and c have different units"),
        (&["--x", "2,1"], "the first below the second"),
        (&["--what", "pies"], "invalid value 'pies'"),
        (&["--width", "3 miles"], "a length from 0.5 to 40 inches, as in 85mm"),
        (&["--height", "15mm"], "a picture this wide cannot be 15 mm (57 pixels) high; give at least"),
        (&["--width", "85mm", "--font-size", "20"], "letters of 20 points do not fit the width of the picture"),
        (&["--title", "a", "--no-title"], "cannot be used with"),
    ] {
        let run = say(directory.path(), &[&["plot", "results/small"], arguments].concat());
        assert_eq!(code(&run), 2, "{arguments:?}");
        assert!(err(&run).contains(expected), "{arguments:?}: {}", err(&run));
        assert!(!directory.path().join("results/small/figures").exists(), "{arguments:?}");
    }
}

#[test]
fn a_directory_that_is_not_as_it_was_published_is_refused() {
    let directory = with_results(SMALL);
    let results = directory.path().join("results/small/results.h5");
    let sound = fs::read(&results).unwrap();
    let refused = |expected: &str| {
        let run = say(directory.path(), &["plot", "results/small"]);
        assert_eq!(code(&run), 4);
        assert!(err(&run).contains(expected), "{}", err(&run));
        assert!(!directory.path().join("results/small/figures").exists());
    };
    let mut damaged = sound.clone();
    let middle = damaged.len() / 2;
    damaged[middle] ^= 1;
    fs::write(&results, damaged).unwrap();
    refused("is not as it was published: its checksum is not the one of its record; run `stribeck run");
    fs::remove_file(&results).unwrap();
    refused("has no results.h5: nothing is published yet; run `stribeck run");
    let run = say(directory.path(), &["plot", "nowhere"]);
    assert_eq!((code(&run), err(&run).contains("there is no such directory")), (4, true), "{}", err(&run));
}

/// Title, width and letters are those asked for.
#[test]
fn a_picture_is_as_its_user_wants_it() {
    let directory = with_results(SMALL);
    let svg = |options: &[&str]| {
        let curves = ["--what", "curves", "--of", "mu_v", "--along", "alpha"];
        let pictures = plot(directory.path(), &[&curves, options].concat());
        fs::read_to_string(&pictures[0]).unwrap()
    };
    let letters = |text: &str| -> f64 {
        let document = Document::parse(text).unwrap();
        let root = document.root_element();
        let scale = root.attribute("width").unwrap().parse::<f64>().unwrap() / 1600.0;
        let tick =
            document.descendants().find(|node| node.text().is_some_and(|text| text.starts_with("10"))).expect("a tick");
        scale * tick.attribute("font-size").unwrap().parse::<f64>().unwrap() * 72.0 / 96.0
    };
    let plain = svg(&[]);
    assert!(plain.contains("A small &lt;sweep&gt;") && plain.contains("width=\"700\""));
    let column = svg(&["--width", "85mm", "--font-size", "8", "--title", "glass T_{g}"]);
    assert!((letters(&column) - 8.0).abs() < 0.02, "{}", letters(&column));
    assert!(column.contains("width=\"321.3\"") && !column.contains("A small"));
    // The subscript stands in a part of its own.
    assert!(column.contains("glass T<tspan") && column.contains(">g</tspan>"));
    let low = svg(&["--width", "85mm", "--height", "50mm", "--font-size", "7"]);
    assert!(low.contains("width=\"321.3\" height=\"188.9\""), "{}", &low[..200]);
    let bare = svg(&["--no-title"]);
    assert!(!bare.contains("A small") && !bare.contains("f = "), "{bare}");
}

/// What was drawn with options stays where `plot` runs without any, whatever the format; other options replace it.
#[test]
fn a_picture_made_by_options_is_kept() {
    let directory = with_results(SMALL);
    let made = plot(directory.path(), &["--what", "curves", "--of", "mu_v", "--along", "alpha", "--scale", "log"]);
    let [svg, csv] = [made[0].clone(), made[0].with_extension("csv")];
    let before = [&svg, &csv].map(|file| fs::read(file).unwrap());
    for format in ["svg", "png"] {
        let run = say(directory.path(), &["plot", "results/small", "--format", format]);
        let kept = "mu_v-along-alpha.svg stays, which was drawn with --scale: remove it with its .csv";
        assert!(code(&run) == 0 && err(&run).contains(kept), "{}", err(&run));
        assert_eq!([&svg, &csv].map(|file| fs::read(file).unwrap()), before);
        assert!(!svg.with_extension("png").exists());
    }
    plot(directory.path(), &["--what", "curves", "--of", "mu_v", "--along", "alpha", "--bare"]);
    assert_ne!(fs::read(&svg).unwrap(), before[0]);
    [&svg, &csv].iter().for_each(|file| fs::remove_file(file).unwrap());
    plot(directory.path(), &[]);
    assert!(svg.exists());
}

/// Published files are passed on without logs and shards.
#[test]
fn published_files_alone_are_enough() {
    let directory = with_results(SMALL);
    let alone = directory.path().join("alone");
    fs::create_dir(&alone).unwrap();
    fs::copy(directory.path().join("results/small/results.h5"), alone.join("results.h5")).unwrap();
    let run = say(directory.path(), &["plot", "alone", "-o", "pictures"]);
    assert_eq!(code(&run), 0, "{}", err(&run));
    assert!(directory.path().join("pictures/surface-mu_tot.svg").is_file());
    // Seconds are in timings.csv, which was not passed on.
    assert!(!directory.path().join("pictures/cost.svg").exists());
    let run = say(directory.path(), &["plot", "alone", "--what", "cost"]);
    assert_eq!((code(&run), err(&run).contains("no timings.csv")), (2, true), "{}", err(&run));
}

/// Each line of `scripts/figures`: its sweep is one of `sweeps/`, its options make the picture that it names, and that
/// picture is shown in docs/explanation/paper-figures.md.
#[test]
#[ignore = "slow: solves the sweeps of all figures"]
fn the_figures_of_the_paper_can_be_drawn() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let script = fs::read_to_string(root.join("scripts/figures")).unwrap();
    let docs = fs::read_to_string(root.join("docs/explanation/paper-figures.md")).unwrap();
    let table = script.split("figures='\n").nth(1).unwrap().split("\n'\n").next().unwrap();
    let directory = tempdir().expect("a temporary directory");
    let mut figures = 0;
    for line in table.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [name, sweep, picture, options @ ..] = &words[..] else { panic!("{line}") };
        let file = root.join(format!("sweeps/{sweep}.toml"));
        let run = say(directory.path(), &["run", file.to_str().unwrap(), "--quiet"]);
        assert_eq!(code(&run), 0, "{sweep}: {}", err(&run));
        let run = say(directory.path(), &[&["plot", &format!("results/{sweep}")], options].concat());
        assert_eq!(code(&run), 0, "{line}: {}", err(&run));
        let extension = if options.contains(&"png") { "png" } else { "svg" };
        let drawn = directory.path().join(format!("results/{sweep}/figures/{picture}.{extension}"));
        assert!(drawn.is_file(), "{}", drawn.display());
        assert!(root.join(format!("docs/figures/{name}.{extension}")).is_file(), "{name}");
        assert!(docs.contains(&format!("](../figures/{name}.{extension})")), "{name} is not shown");
        figures += 1;
    }
    assert_eq!(figures, 21);
}
