//! `stribeck material` from outside.

use std::fs;
use std::path::Path;

use serde_json::Value;
use stribeck_lab::{Measurements, Relaxation, RelaxationFit, RelaxationTerm};
use tempfile::{TempDir, tempdir};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::program::{code, err, out, paths, say};

/// A rubber with three terms, measured over seven decades to five digits.
fn with_table() -> TempDir {
    let term = |modulus, time| RelaxationTerm { modulus, time };
    let rubber = Relaxation::new(1e6, vec![term(2e8, 1e-3), term(3e7, 0.1), term(5e5, 10.0)]).expect("a material");
    let mut text = "frequency,storage,loss\n".to_owned();
    for i in -20..=50 {
        let frequency = 10_f64.powf(f64::from(i) / 10.0);
        let (storage, loss) = rubber.storage_and_loss(std::f64::consts::TAU * frequency);
        text += &format!("{frequency:.5e},{storage:.5e},{loss:.5e}\n");
    }
    let directory = tempdir().expect("a temporary directory");
    fs::write(directory.path().join("rubber.csv"), text).expect("written");
    directory
}

/// The fit that the library makes of the same table.
fn fit(directory: &Path, terms: usize) -> RelaxationFit {
    RelaxationFit::new(&Measurements::read(&directory.join("rubber.csv")).expect("a table"), terms).expect("a fit")
}

#[test]
fn json_has_the_numbers_of_the_fit() {
    let directory = with_table();
    let said = say(directory.path(), &["material", "rubber.csv", "--terms", "29", "--json"]);
    assert_eq!((code(&said), err(&said)), (0, String::new()));
    let object: Value = serde_json::from_str(&out(&said)).expect("JSON");
    let fit = fit(directory.path(), 29);
    let (relaxation, material) = (&fit.relaxation, fit.relaxation.material());
    for (key, value) in [
        ("rms_residual", fit.rms_residual),
        ("largest_residual", fit.largest_residual),
        ("instantaneous_modulus", relaxation.instantaneous_modulus()),
        ("relaxed_modulus", relaxation.relaxed_modulus()),
        ("f", material.f),
        ("retardation_time", material.retardation_time),
    ] {
        assert_eq!(object[key].as_f64(), Some(value), "{key}");
    }
    assert!(fit.rms_residual < 0.02 && (material.f / 230.5 - 1.0).abs() < 0.1, "{fit:?}");
    let length = |key: &str| object[key].as_array().expect("a list").len();
    assert_eq!((length("relaxation"), length("retardation")), (relaxation.terms().len(), relaxation.terms().len()));
    assert!((3..29).contains(&length("relaxation")), "some of the terms are dropped");
}

/// The section that is printed reads back as the very material.
#[test]
fn the_section_for_a_sweep_file_is_the_material() {
    let directory = with_table();
    let said = out(&say(directory.path(), &["material", "rubber.csv", "--terms", "9"]));
    let (_, section) = said.split_once("For a sweep file:\n\n").expect("the section");
    assert!(section.starts_with("[substrate]\nrelaxed_modulus = "), "{section}");
    let document = DeTable::parse(section).expect("TOML").into_inner();
    let substrate = document["substrate"].get_ref();
    let number = |value: &Spanned<DeValue<'_>>| -> f64 {
        value.get_ref().as_float().expect("a number with a point").as_str().parse().expect("a number")
    };
    let field = |term: &Spanned<DeValue<'_>>, key: &str| number(&term.get_ref().as_table().expect("a table")[key]);
    let substrate = substrate.as_table().expect("a table");
    let terms = substrate["relaxation"].get_ref().as_array().expect("a list").iter();
    let terms = terms.map(|term| RelaxationTerm { modulus: field(term, "modulus"), time: field(term, "time") });
    let read = Relaxation::new(number(&substrate["relaxed_modulus"]), terms.collect()).expect("a material");
    assert_eq!(read, fit(directory.path(), 9).relaxation);
}

#[test]
fn the_table_says_how_good_the_fit_is() {
    let directory = with_table();
    let said = out(&say(directory.path(), &["material", "rubber.csv", "--terms", "8"]));
    let fit = fit(directory.path(), 8);
    for line in [
        format!("71 rows from 6.28319e-2 to 6.28319e5 rad/s; {} of 8 terms kept", fit.relaxation.terms().len()),
        format!("residual, rms      {:>12}", format!("{:.5e}", fit.rms_residual)),
        format!("residual, largest  {:>12}", format!("{:.5e}", fit.largest_residual)),
        format!("f                  {:>12}", format!("{:.5e}", fit.relaxation.material().f)),
    ] {
        assert!(said.contains(&line), "{line}\n{said}");
    }
}

#[test]
fn pictures_have_a_dot_for_each_number() {
    let directory = with_table();
    for file in ["fit.svg", "fit.png"] {
        let said = say(directory.path(), &["material", "rubber.csv", "--terms", "9", "-o", file]);
        assert!(code(&said) == 0 && out(&said).ends_with(&format!("\n{file}\n")), "{}", out(&said));
    }
    let svg = fs::read_to_string(directory.path().join("fit.svg")).expect("a picture");
    let document = roxmltree::Document::parse(&svg).expect("SVG");
    let dots = document.descendants().filter(|node| node.has_tag_name("circle")).count();
    assert_eq!(dots, 2 * 71);
    for text in ["Fit to rubber", "storage E′", "loss E″", "angular frequency ω, rad/s", "modulus, Pa"] {
        assert!(svg.contains(text), "{text}");
    }
    assert!(fs::read(directory.path().join("fit.png")).expect("a picture").starts_with(b"\x89PNG"));
    let json = say(directory.path(), &["material", "rubber.csv", "--terms", "9", "-o", "fit.svg", "--json"]);
    assert!(serde_json::from_str::<Value>(&out(&json)).is_ok(), "JSON and nothing else");
}

#[test]
fn bad_tables_end_with_2_place_and_remedy() {
    let directory = tempdir().expect("a temporary directory");
    for (text, place, said) in [
        ("", "1:1", "the table is empty"),
        ("omega,storage,los\n1,2,3\n", "1:15", "a column must be called omega, frequency, storage or loss"),
        ("omega;storage;loss\n", "1:1", "found `omega;storage;loss`"),
        ("1,2,3\n4,5,6\n", "1:1", "found `1`"),
        ("omega,loss\n1,2\n", "1:1", "the column storage is missing"),
        ("storage,loss\n1,2\n", "1:1", "the column omega (or frequency) is missing"),
        ("omega,storage,loss,omega\n", "1:20", "a column must be there once, found `omega`"),
        ("omega,storage,loss,frequency\n", "1:20", "omega (rad/s) or frequency (Hz), not both"),
        ("omega,storage,loss\n1,2,3\n2,x,3\n", "3:3", "storage must be a number above 0, found `x`"),
        ("omega,storage,loss\n1,2,3\n\n 2, 4 , -3\n", "4:9", "loss must be a number from 0, found `-3`"),
        ("omega,storage,loss\n0,2,3\n", "2:1", "omega must be a number above 0, found `0`"),
        ("frequency,storage,loss\nnan,2,3\n", "2:1", "frequency must be a number above 0, found `nan`"),
        ("omega,storage,loss\n1,inf,3\n", "2:3", "storage must be a number above 0, found `inf`"),
        ("omega,storage,loss\n1,,3\n", "2:3", "storage must be a number above 0"),
        ("omega,storage,loss\n1,2\n", "2:1", "a row must have 3 values, not 2"),
        ("omega,storage,loss\n1,2,3,4\n", "2:1", "a row must have 3 values, not 4"),
        ("omega,storage,loss\n1,2,3\n", "2:5", "rows at two frequencies or more"),
        ("omega,storage,loss\n1,2,3\n1,2,3\n", "3:5", "rows at two frequencies or more"),
    ] {
        fs::write(directory.path().join("bad.csv"), text).expect("written");
        let output = say(directory.path(), &["material", "bad.csv", "--terms", "2"]);
        let words: Vec<String> =
            err(&output).split(|c: char| c.is_whitespace() || c == '│').map(str::to_owned).collect();
        let message = words.into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
        assert_eq!(code(&output), 2, "{text}\n{message}");
        assert!(message.contains(&format!("bad.csv:{place}: ")), "{text}\n{message}");
        assert!(message.contains(said) && message.contains("help: "), "{text}\n{message}");
    }
    assert_eq!(paths(directory.path()).len(), 1, "nothing is written");
}

#[test]
fn what_cannot_be_fitted_ends_with_2() {
    let directory = with_table();
    fs::write(
        directory.path().join("liquid.csv"),
        "omega,storage,loss\n0.001,1e-6,1e-3\n0.01,1e-4,1e-2\n0.1,1e-2,0.1\n",
    )
    .expect("written");
    for (arguments, said) in [
        (&["rubber.csv", "--terms", "0"][..], "error: rubber.csv: a fit has from 1 to 100 terms, not 0"),
        (&["rubber.csv", "--terms", "101"], "from 1 to 100 terms, not 101"),
        (&["rubber.csv", "--terms", "many"], "a whole number from 1 to 100, or auto"),
        (&["rubber.csv", "--shear"], "--poisson-ratio <NU>"),
        (&["rubber.csv", "--shear", "--poisson-ratio", "0.6"], "from 0 to 0.5"),
        (&["rubber.csv", "--reference-temperature", "20"], "a temperature with its unit"),
        (&["rubber.csv", "--modulus-unit", "m"], "a unit of a modulus"),
        (&["rubber.csv", "--terms", "9", "-o", "fit.pdf"], "ends in .svg or .png"),
        (&["liquid.csv", "--terms", "6"], "ask for 5 terms or fewer"),
        (&["liquid.csv", "--terms", "4"], "the best fit has no relaxed modulus"),
        (&["absent.csv", "--terms", "4"], "cannot read the table of measurements absent.csv"),
    ] {
        let output = say(directory.path(), &[&["material"], arguments].concat());
        assert_eq!(code(&output), 2, "{arguments:?}: {}", err(&output));
        assert!(err(&output).contains(said), "{arguments:?}: {}", err(&output));
    }
    assert_eq!(paths(directory.path()).len(), 2, "nothing is written");
}
