//! What comes out: the program from outside.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use stribeck::pictures::Format;
use stribeck::study::{csv, markdown, pictures};
use tempfile::tempdir;

use crate::program::{code, err, out, say, stribeck};
use crate::study::{findings, study};

/// Converges everywhere, quickly.
const GOOD: &str = "title = \"Two cases\"\nmeasure = [\"error\", \"stability\"]\nrepeats = 2\n\
    [axes]\nf = [10.0]\nalpha = [1.0]\nbeta = [10.0, 100.0]\n\
    [[method]]\nmethod = \"collocation\"\ntolerance = [1e-2, 1e-4]\n[[method]]\nmethod = \"relaxation\"\npoints = [101, 201]\n";

/// One of both methods fails.
const BAD: &str = "title = \"A film too thin\"\nrepeats = 1\n[[case]]\nalpha = 1.0\nbeta = 1e4\nf = 100.0\n\
    [[method]]\nmethod = \"collocation\"\ntolerance = [1e-2]\n[[method]]\nmethod = \"relaxation\"\npoints = [51]\n";

/// The rows of a CSV file by column.
fn table(path: &Path) -> Vec<HashMap<String, String>> {
    let mut reader = ::csv::Reader::from_path(path).expect("there");
    reader.deserialize().collect::<Result<_, _>>().expect("a table")
}

#[test]
fn a_study_writes_tables_and_pictures() {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("two.toml"), GOOD).expect("written");
    let output = say(directory.path(), &["study", "two.toml", "--quiet"]);
    assert_eq!((code(&output), err(&output).as_str()), (0, ""));
    assert!(out(&output).contains("2 cases with 4 settings: 8 converged, 0 failed"), "{}", out(&output));
    let results = directory.path().join("results/two");
    let rows = table(&results.join("study.csv"));
    assert_eq!(rows.len(), 8);
    for row in &rows {
        assert_eq!((row["status"].as_str(), row["reason"].as_str()), ("converged", ""));
        for column in ["seconds", "unknowns", "iterations", "error_mu_h", "error_c"] {
            let number: f64 = row[column].parse().unwrap_or_else(|_| panic!("{column}: {row:?}"));
            assert!(number >= 0.0 && number.is_finite(), "{column}: {number}");
        }
        assert!(["collocation", "relaxation"].contains(&row["method"].as_str()));
    }
    // the program counts its memory; a grid of twice the points takes about twice as much
    let peak = |setting: &str| -> f64 {
        let row = rows.iter().find(|row| row["setting"] == setting).expect("there");
        row["peak_bytes"].parse().expect("a number")
    };
    let growth = peak("201 points") / peak("101 points");
    assert!((1.2..3.5).contains(&growth), "{growth}");

    let text = fs::read_to_string(results.join("study.md")).expect("written");
    for part in ["# Two cases", "## Error against run time", "## Stability", "| relaxation | 201 points | 2 of 2 |"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    assert!(!text.contains("Failures"));
    // every picture of the text is there in both formats, and no other
    let shown: Vec<&str> = text.split("](").skip(1).filter_map(|rest| rest.split(".svg").next()).collect();
    assert!(shown.contains(&"error_c") && shown.contains(&"map_condition"), "{shown:?}");
    for name in &shown {
        let svg = fs::read_to_string(results.join(format!("{name}.svg"))).expect("there");
        roxmltree::Document::parse(&svg).expect("well-formed");
        assert!(svg.contains("Two cases"));
        assert!(fs::read(results.join(format!("{name}.png"))).expect("there").starts_with(b"\x89PNG"));
    }
    let files = fs::read_dir(&results).expect("listed").count();
    assert_eq!(files, 2 * shown.len() + 3);
    assert_eq!(fs::read_to_string(results.join("study.toml")).expect("there"), GOOD);

    // again: replaced
    let output = say(directory.path(), &["study", "two.toml", "--quiet"]);
    assert_eq!((code(&output), err(&output).as_str()), (0, ""));
    assert_eq!(fs::read_dir(&results).expect("listed").count(), files);
    // with less to measure: a note, and no picture of what is not measured any more
    fs::write(directory.path().join("two.toml"), GOOD.replace(", \"stability\"", "")).expect("written");
    fs::write(results.join("mine.svg"), "mine").expect("written");
    let output = say(directory.path(), &["study", "two.toml", "--quiet"]);
    assert_eq!(code(&output), 0);
    assert!(err(&output).contains("another study file"), "{}", err(&output));
    assert!(!results.join("map_condition.svg").exists() && results.join("error_c.svg").exists());
    assert!(results.join("mine.svg").exists());
}

#[test]
fn failures_are_shown_as_failures() {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("thin.toml"), BAD).expect("written");
    let output = say(directory.path(), &["study", "thin.toml", "-o", "there", "--quiet"]);
    assert_eq!(code(&output), 3, "{}", err(&output));
    assert!(out(&output).contains("1 converged, 1 failed"), "{}", out(&output));
    let results = directory.path().join("there");
    let failed: Vec<_> =
        table(&results.join("study.csv")).into_iter().filter(|row| row["status"] == "failed").collect();
    assert_eq!(failed.len(), 1);
    assert!(!failed[0]["reason"].is_empty() && failed[0]["error_c"].is_empty() && !failed[0]["seconds"].is_empty());
    let text = fs::read_to_string(results.join("study.md")).expect("written");
    assert!(text.contains("| relaxation | 51 points | 0 of 1 |"), "{text}");
    assert!(text.contains("## Failures") && text.contains(&failed[0]["reason"]), "{text}");
    let svg = fs::read_to_string(results.join("error_c.svg")).expect("there");
    assert!(svg.contains("failed"));
}

/// What is not of a study is never replaced, and bad input writes nothing.
#[test]
fn nothing_is_lost() {
    let directory = tempdir().expect("a temporary directory");
    let path = directory.path();
    fs::write(path.join("two.toml"), GOOD).expect("written");
    fs::write(path.join("bad.toml"), GOOD.replace("points", "point")).expect("written");
    fs::write(path.join("file"), "mine").expect("written");
    fs::create_dir(path.join("taken")).expect("made");
    fs::write(path.join("taken/study.csv"), "mine").expect("written");
    fs::create_dir(path.join("sweep")).expect("made");
    fs::write(path.join("sweep/sweep.toml"), "mine").expect("written");
    fs::create_dir(path.join("drawn")).expect("made");
    fs::write(path.join("drawn/map_error_2.png"), "mine").expect("written");
    for (arguments, expected, said) in [
        (vec!["study", "bad.toml"], 2, "`point` is not a key of"),
        (vec!["study", "missing.toml"], 2, "cannot read the study file"),
        (vec!["study", "two.toml", "-o", "file"], 4, "is a file"),
        (vec!["study", "two.toml", "-o", "taken"], 4, "which `stribeck study` has not written"),
        (vec!["study", "two.toml", "-o", "sweep"], 4, "which `stribeck study` has not written"),
        (vec!["study", "two.toml", "-o", "drawn"], 4, "which `stribeck study` has not written"),
        (vec!["study", "two.toml", "-o", "file/below"], 4, "cannot create file: not a directory; check the path"),
        (vec!["study", "two.toml", "--threads", "0"], 2, "from 1 to"),
    ] {
        let output = say(path, &arguments);
        assert_eq!(code(&output), expected, "{arguments:?}: {}", err(&output));
        assert!(err(&output).contains(said), "{arguments:?}: {}", err(&output));
    }
    assert!(!path.join("results").exists());
    for file in ["file", "taken/study.csv", "sweep/sweep.toml", "drawn/map_error_2.png"] {
        assert_eq!(fs::read_to_string(path.join(file)).expect("there"), "mine");
    }
}

/// Ctrl-C before the first case is done changes no table of before.
#[cfg(unix)]
#[test]
fn an_interrupted_study_loses_nothing() {
    use std::io::{BufRead, BufReader};
    use std::process::Stdio;

    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("long.toml"), GOOD).expect("written");
    assert_eq!(code(&say(directory.path(), &["study", "long.toml", "--quiet"])), 0);
    let table = directory.path().join("results/long/study.csv");
    let before = fs::read_to_string(&table).expect("written");

    // hours, if nobody stopped it
    fs::write(
        directory.path().join("long.toml"),
        GOOD.replace("repeats = 2", "repeats = 1000").replace("101, 201", "1601"),
    )
    .expect("written");
    let mut command = stribeck(directory.path());
    let mut child = command.args(["study", "long.toml"]).stderr(Stdio::piped()).spawn().expect("started");
    let mut lines = BufReader::new(child.stderr.take().expect("piped")).lines().map_while(Result::ok);
    // the first line of progress: it is at work, and its handlers are in place
    assert!(lines.by_ref().any(|line| line.contains("0 of 6 rows")));
    let id = i32::try_from(child.id()).expect("a process id");
    assert!(std::process::Command::new("kill").args(["-INT", &id.to_string()]).status().expect("sent").success());
    let rest: Vec<String> = lines.collect();
    assert_eq!(child.wait().expect("ended").code(), Some(130), "{rest:?}");
    let said = "interrupted by SIGINT: none of 6 rows was finished, and no table is changed in results/long";
    assert!(rest.iter().any(|line| line.contains(said)), "{rest:?}");
    assert_eq!(fs::read_to_string(table).expect("still there"), before);
}

/// Pictures take the options of `plot`; those of other formats that were there before go away.
#[test]
fn pictures_of_a_study_have_the_format_and_the_size_asked_for() {
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("two.toml"), GOOD).expect("written");
    let drawn = |options: &[&str]| {
        let output = say(directory.path(), &[&["study", "two.toml", "--quiet"], options].concat());
        assert_eq!((code(&output), err(&output).as_str()), (0, ""));
        let files = fs::read_dir(directory.path().join("results/two")).expect("listed");
        let names = files.map(|file| file.expect("listed").file_name().into_string().expect("a name"));
        (names.filter(|name| !name.starts_with("study")).collect::<Vec<_>>(), out(&output))
    };
    let (plain, _) = drawn(&[]);
    let (pages, said) = drawn(&["--format", "pdf", "--no-title"]);
    assert_eq!(2 * pages.len(), plain.len());
    assert!(pages.iter().all(|name| name.ends_with(".pdf")) && said.contains("pictures as PDF"), "{pages:?} {said}");
    let sized = ["--format", "svg", "--width", "120mm", "--height", "100mm", "--font-size", "8", "--title", "Glass"];
    let (pictures, _) = drawn(&sized);
    for name in &pictures {
        let svg = fs::read_to_string(directory.path().join("results/two").join(name)).expect("there");
        let document = roxmltree::Document::parse(&svg).expect("well-formed");
        let size = ["width", "height"].map(|name| document.root_element().attribute(name));
        assert_eq!(size.map(|length| length.and_then(|length| length.split('.').next())), [Some("453"), Some("377")]);
        assert!(svg.contains("Glass") && !svg.contains("Two cases"));
    }
    assert_eq!(pictures.len(), pages.len());
    let output = say(directory.path(), &["study", "two.toml", "--width", "85mm", "--font-size", "30"]);
    assert!(code(&output) != 0 && err(&output).contains("letters of 30 points"), "{}", err(&output));
}

/// A table reads back what was found, to the last bit.
#[test]
fn numbers_read_back_as_they_were() {
    let study = study(GOOD);
    let rows = findings(&study).rows;
    let bytes = csv(&study, &rows).expect("written");
    let mut reader = ::csv::Reader::from_reader(bytes.as_slice());
    let read: Vec<HashMap<String, String>> = reader.deserialize().collect::<Result<_, _>>().expect("a table");
    for (row, read) in rows.iter().zip(&read) {
        let case = &study.cases[row.case];
        let number = |column: &str| read[column].parse::<f64>().expect("a number");
        assert_eq!([number("f"), number("alpha"), number("beta")], [case.f, case.alpha, case.beta]);
        assert_eq!(read["error_c"].parse().ok(), row.errors[2]);
        assert_eq!(Some(number("condition")), row.stability.as_ref().expect("examined").condition);
        assert_eq!(read["seed"], row.seed);
    }
}

/// No rows at all, as after an early interruption: empty tables, no picture, no panic.
#[test]
fn nothing_found_is_nothing_shown() {
    let study = study(GOOD);
    assert_eq!(csv(&study, &[]).expect("written").iter().filter(|byte| **byte == b'\n').count(), 1);
    assert!(markdown(&study, &[], (&[], Format::Svg)).starts_with("# Two cases\n\n0 cases"));
    assert!(pictures(&study, &[]).iter().all(|picture| picture.name.starts_with("map_")));
}
