//! Which study files are taken, and what is said of the others.

use std::fs;
use std::path::Path;

use miette::Diagnostic;
use proptest::prelude::*;
use stribeck::study::{Measure, Setting, Start, Study};

use crate::study::study;

const BOX: &str = "[axes]\nf = [0.0, 10.0]\nalpha = [1.0]\nbeta = [10.0, 100.0]\n";
const METHOD: &str = "[[method]]\nmethod = \"collocation\"\ntolerance = [1e-3, 1e-5]\n";

#[test]
fn all_keys_mean_what_they_say() {
    let text = r#"
        title = "All keys"
        measure = ["stability", "error"]
        repeats = 5
        start = "chain"
        [axes]
        f = [0.0, 10.0]
        alpha = [1.0, inf]
        beta = { from = 10.0, to = 1000.0, points = 3, scale = "log" }
        [[case]]
        alpha = 0.0
        beta = 5
        f = 2.5
        [substrate]
        modes = [{ share = 0.25, time = 1.0 }, { share = 0.75, time = 10.0 }]
        [[method]]
        method = "collocation"
        tolerance = [1e-3, 1e-9]
        [[method]]
        method = "collocation"
        tolerance = 1e-4
        degree = 5
        [[method]]
        label = "fixed"
        method = "collocation"
        panels = [8, 16]
        [[method]]
        method = "relaxation"
        points = [201, 401]
        tolerance = 1e-7
        [[method]]
        method = "relaxation"
        points = 101
        acceleration = "none"
    "#;
    let study = study(text);
    assert_eq!((study.title.as_str(), study.name.as_str(), study.text.as_str()), ("All keys", "test", text));
    assert_eq!(study.measure, Measure { error: true, stability: true });
    assert_eq!((study.repeats, study.start), (5, Start::Chain));
    assert_eq!(study.cases.len(), 2 * 2 * 3 + 1);
    let places: Vec<_> = study.cases.iter().map(|case| (case.f, case.alpha, case.beta)).collect();
    assert_eq!(places[..4], [(0.0, 1.0, 10.0), (0.0, 1.0, 100.0), (0.0, 1.0, 1000.0), (0.0, f64::INFINITY, 10.0)]);
    assert_eq!(places[12], (2.5, 0.0, 5.0));
    assert!(study.cases.iter().all(|case| case.substrate.modes().len() == 2));
    assert_eq!(study.groups(), [0..3, 3..6, 6..9, 9..12, 12..13]);
    let methods = study.methods();
    assert_eq!(
        methods,
        [
            ("collocation", 0..2),
            ("collocation, degree 5", 2..3),
            ("fixed", 3..5),
            ("relaxation", 5..7),
            ("relaxation, plain", 7..8)
        ]
    );
    let words: Vec<String> = study.variants.iter().map(|variant| variant.setting.words()).collect();
    assert_eq!(words[..2], ["tolerance 1e-3", "tolerance 1e-9"]);
    assert_eq!(words[3..], ["8 panels of degree 8", "16 panels of degree 8", "201 points", "401 points", "101 points"]);
    let degree = |setting| match setting {
        Setting::Tolerance(settings) => settings.degree,
        _ => panic!("a tolerance"),
    };
    // as in a sweep, unless it is given
    assert_eq!([0, 1, 2].map(|i| degree(study.variants[i].setting)), [8, 12, 5]);
    let Setting::Grid(settings) = study.variants[5].setting else { panic!("a grid") };
    assert_eq!((settings.points, settings.tolerance), (201, 1e-7));
}

#[test]
fn little_has_to_be_said() {
    let study = study(&format!("{BOX}{METHOD}"));
    assert_eq!(study.title, "test");
    assert_eq!(study.measure, Measure { error: true, stability: false });
    assert_eq!((study.repeats, study.start), (3, Start::Alone));
    assert_eq!(study.groups(), [0..1, 1..2, 2..3, 3..4]);
}

/// Text, line of the fault, what is said of it, and the remedy.
fn bad_files() -> Vec<(String, usize, &'static str, &'static str)> {
    let with = |method: &str| format!("{BOX}[[method]]\n{method}\n");
    vec![
        (METHOD.to_owned(), 1, "needs `axes`", "[[case]]"),
        (BOX.to_owned(), 1, "needs `method`", "[[method]]"),
        (format!("repeats = 0\n{BOX}{METHOD}"), 1, "`repeats` must be a whole number from 1", "write a whole number"),
        (format!("measure = []\n{BOX}{METHOD}"), 1, "`measure` must name at least one", "stability"),
        (format!("measure = [\"eror\"]\n{BOX}{METHOD}"), 1, "must be \"error\" or \"stability\"", "did you mean"),
        (format!("measure = [\"error\", \"error\"]\n{BOX}{METHOD}"), 1, "only once", "remove one"),
        (format!("start = \"seed\"\n{BOX}{METHOD}"), 1, "\"alone\" or \"chain\"", "write"),
        (format!("tolerance = 1e-3\n{BOX}{METHOD}"), 1, "not a key of the top level", "[[method]]"),
        (
            format!("{METHOD}[[case]]\nalpha = 1.0\nbeta = 0.0\nf = 1.0\n"),
            6,
            "finite and above 0",
            "a case is written as",
        ),
        (format!("{METHOD}[[case]]\nalpha = 1.0\nbeta = 1.0\n"), 4, "needs `f`", "a case is written as"),
        (
            format!("{METHOD}[[case]]\nalpha = nan\nbeta = 1.0\nf = 1.0\n"),
            5,
            "at least 0, or inf",
            "a case is written as",
        ),
        (format!("{BOX}{METHOD}[[case]]\nalpha = 1.0\nbeta = 100.0\nf = 10.0\n"), 8, "only once", "remove it"),
        (with("method = \"multigrid\""), 6, "\"collocation\" or \"relaxation\"", "write"),
        (with("method = \"collocation\""), 5, "needs `tolerance`", "panels"),
        (with("method = \"collocation\"\ntolerance = []"), 7, "at least one value", "in brackets"),
        (with("method = \"collocation\"\ntolerance = [1e-3, 1e-3]"), 7, "only once", "remove one"),
        (with("method = \"collocation\"\ntolerance = 1e-12"), 7, "from 1e-10 to 1e-1", "relative error"),
        (with("method = \"collocation\"\ntolerance = 1e-3\npoints = 401"), 8, "collocation has no `points`", "remove"),
        (with("method = \"collocation\"\npanels = 3"), 7, "whole number from 4 to 160", "write"),
        (with("method = \"collocation\"\npanels = 8\ntolerance = 1e-3"), 8, "has no `tolerance`", "remove"),
        (with("method = \"collocation\"\npanels = 8\ndegree = 40"), 8, "whole number from 4 to 16", "write"),
        (with("method = \"relaxation\""), 5, "needs `points`", "varied by the points"),
        (with("method = \"relaxation\"\npoints = [400]"), 7, "odd number from 51", "halves the grid"),
        (with("method = \"relaxation\"\npoints = 401\ntolerance = 1.0"), 8, "from 1e-12 to 1e-2", "residual"),
        (with("method = \"relaxation\"\npoints = 401\ndegree = 4"), 8, "relaxation has no `degree`", "remove"),
        (with("method = \"relaxation\"\npoints = 401\nlabel = \"\""), 8, "one line of 1 to 40", "names the method"),
        (format!("{BOX}{METHOD}{METHOD}"), 8, "two methods have the label \"collocation\"", "another label"),
        (
            format!("[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = {{ from = 1.0, to = 2.0, points = 60000 }}\n{METHOD}"),
            5,
            "at most 100000 rows, this one has 60000 cases x 2 settings",
            "split",
        ),
    ]
}

#[test]
fn bad_files_are_refused_with_place_message_and_remedy() {
    for (text, line, message, remedy) in bad_files() {
        let error = Study::parse("bad", &text).expect_err(&text);
        let said = error.to_string();
        assert!(said.starts_with(&format!("bad.toml:{line}:")), "{said}\nshould be at line {line} of\n{text}");
        assert!(said.contains(message), "{said}\nshould say: {message}");
        let help = error.help().expect("there is always a remedy").to_string();
        assert!(help.contains(remedy), "{help}\nshould say: {remedy}");
    }
}

/// Mistakes of a file: what stands there and what in its place, each in a line of its own.
const MISTAKES: [(&str, &str); 13] = [
    ("title = \"All\"", "title = 3"),
    ("measure = [\"error\"]", "measure = [\"eror\"]"),
    ("repeats = 5", "repeats = 0"),
    ("start = \"chain\"", "strat = \"chain\""),
    ("alpha = [1.0, inf]", "alpha = [-1.0]"),
    ("beta = 5.0", "beta = 0.0"),
    ("f = 2.5", "f = \"much\""),
    ("share = 0.75", "share = 1.75"),
    ("tolerance = [1e-3, 1e-9]", "tolerence = [1e-3, 1e-9]"),
    ("label = \"fixed\"", "label = \"\""),
    ("panels = [8, 16]", "panels = [3, 16]"),
    ("points = [201, 401]", "points = [200, 401]"),
    ("acceleration = \"none\"", "acceleration = \"nones\""),
];

/// All mistakes of a file are told in one go, each at its place, and nothing else.
#[test]
fn all_mistakes_are_told_at_once() {
    let good = "title = \"All\"\nmeasure = [\"error\"]\nrepeats = 5\nstart = \"chain\"\n\
        [axes]\nf = [0.0, 10.0]\nalpha = [1.0, inf]\nbeta = [10.0]\n\
        [[case]]\nalpha = 0.0\nbeta = 5.0\nf = 2.5\n\
        [substrate]\nmodes = [{ share = 0.25, time = 1.0 }, { share = 0.75, time = 10.0 }]\n\
        [[method]]\nmethod = \"collocation\"\ntolerance = [1e-3, 1e-9]\n\
        [[method]]\nmethod = \"collocation\"\nlabel = \"fixed\"\npanels = [8, 16]\n\
        [[method]]\nmethod = \"relaxation\"\npoints = [201, 401]\nacceleration = \"none\"\n";
    study(good);
    let lines = |mistakes: &[(&str, &str)]| -> (Vec<usize>, Vec<usize>) {
        let bad = mistakes.iter().fold(good.to_owned(), |text, (good, bad)| {
            assert_eq!(text.matches(good).count(), 1, "{good}");
            text.replace(good, bad)
        });
        let error = Study::parse("bad", &bad).expect_err(&bad);
        let stribeck_input::InputError::Invalid(invalid) = &error else { panic!("{error}") };
        let line = |(_, mistake): &(&str, &str)| bad[..bad.find(mistake).expect("there")].matches('\n').count() + 1;
        (invalid.mistakes().map(|mistake| mistake.line()).collect(), mistakes.iter().map(line).collect())
    };
    for mistake in &MISTAKES {
        let (told, planted) = lines(&[*mistake]);
        assert_eq!(told, planted, "{mistake:?}");
    }
    let (mut told, mut planted) = lines(&MISTAKES);
    told.sort_unstable();
    planted.sort_unstable();
    assert_eq!(told, planted);
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let error = Study::read("no/such/study.toml").expect_err("there is none").to_string();
    assert!(error.contains("cannot read the study file no/such/study.toml"), "{error}");
}

#[test]
fn the_shipped_studies_are_valid() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("sweeps");
    let mut names = Vec::new();
    for entry in fs::read_dir(directory).expect("listed") {
        let path = entry.expect("listed").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        if name.starts_with("study-") {
            let study = Study::read(&path).unwrap_or_else(|error| panic!("{error}"));
            assert_ne!(study.title, study.name, "a shipped study has a title");
            names.push(name);
        }
    }
    names.sort();
    assert_eq!(names, ["study-accuracy", "study-quick", "study-small", "study-stability"]);
}

#[test]
fn the_examples_of_the_documentation_are_valid() {
    let page = include_str!("../../docs/reference/study-file.md");
    let blocks: Vec<&str> = page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(!blocks.is_empty());
    for block in blocks {
        study(block);
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::default()
    })]

    /// Any text is a study or an error that names a place in it; nothing panics.
    #[test]
    fn any_text_is_taken_or_refused(text in "(\\[\\[?(axes|case|method|substrate)\\]?\\]\n|(f|alpha|beta|panels|points|tolerance|method|degree|repeats|measure|start) = (\\[[0-9., ]{0,9}\\]|\"[a-z]{0,12}\"|-?[0-9]{1,4}|inf|nan|\\{\\})\n|#.*\n){0,9}") {
        match Study::parse("any", &text) {
            Ok(study) => prop_assert!(!study.cases.is_empty() && !study.variants.is_empty()),
            Err(error) => prop_assert!(error.to_string().starts_with("any.toml:"), "{}", error),
        }
    }

    /// Every case is in exactly one group, in order; within a group f and α stay and β ascends.
    #[test]
    fn groups_partition_the_cases(
        cases in prop::collection::vec((0..3_u8, 0..3_u8, 1..5_u8), 1..30),
        chain in any::<bool>(),
    ) {
        let mut text = format!("start = \"{}\"\n{METHOD}", if chain { "chain" } else { "alone" });
        let mut cases = cases;
        let mut seen = std::collections::HashSet::new();
        cases.retain(|case| seen.insert(*case));
        for (f, alpha, beta) in &cases {
            text += &format!("[[case]]\nf = {f}\nalpha = {alpha}\nbeta = {beta}\n");
        }
        let study = study(&text);
        let groups = study.groups();
        prop_assert_eq!(groups.iter().cloned().flatten().collect::<Vec<_>>(), (0..cases.len()).collect::<Vec<_>>());
        for group in groups {
            prop_assert!(chain || group.len() == 1);
            for pair in study.cases[group].windows(2) {
                prop_assert!((pair[0].f, pair[0].alpha) == (pair[1].f, pair[1].alpha) && pair[0].beta < pair[1].beta);
            }
        }
    }
}
