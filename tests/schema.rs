//! The JSON schema of sweep files beside their reader: it takes every file that the reader takes, and refuses mistakes.
//!
//! Files and mistakes go through a validator of Python (`tests/python/check_schema.py`), which shares no code with the
//! reader.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use stribeck_sweep::{SurfaceSweep, Sweep};
use tempfile::tempdir;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::in_python::{check, root, run_python};
use crate::program::{code, err, out, say};

/// What a value is replaced by, and what keys are given that are not there.
const VALUES: [&str; 27] = [
    "0",
    "-1",
    "0.5",
    "1.0",
    "201",
    "0x33",
    "1e300",
    "inf",
    "true",
    "\"text\"",
    "\"1 mm\"",
    "\"20 degC\"",
    "\"2 MPa\"",
    "\"auto\"",
    "\"relaxation\"",
    "\"none\"",
    "[]",
    "[1.0]",
    "[-1.0, 2.0]",
    "[0.0, inf]",
    "[\"1 s\", \"2 s\"]",
    "[\"c\", \"mu_v\"]",
    "[\"pressure\"]",
    "{ from = 1.0, to = 2.0, points = 3 }",
    "{ from = 0.0, to = inf, scale = \"log\" }",
    "{ law = \"arrhenius\", value = \"1 Pa s\", activation_energy = \"30 kJ/mol\", reference = 300 }",
    "[{ share = 1.0, time = 1.0 }]",
];

/// A sweep file with much of what there is.
const FULL: &str = r#"title = "All of it"
[laboratory]
radius = "10 mm"
load = [100.0, "400 N/m"]
viscosity = { law = "vogel", value = "0.1 Pa s", b = "900 K", c = 170, reference = "40 degC" }
temperature = ["20 degC", 350.0]
entrainment_speed = { from = "1 mm/s", to = "1 m/s", points = 3, scale = "log" }
slide_roll_ratio = 0.5
swap = true
roughness = "50 nm"
thickness = 3e-3
[flat]
relaxed_shear_modulus = "1 MPa"
poisson_ratio = 0.5
relaxation = [{ fraction = 0.5, time = "10 ms" }, { fraction = 0.1, time = 1 }]
shift = { law = "wlf", c1 = 17.4, c2 = "51.6 K", reference = "20 degC" }
[roller]
instantaneous_modulus = 3e6
poisson_ratio = 0.4
f = 2.0
retardation_time = "1 s"
shift = { law = "arrhenius", activation_energy = "80 kJ/mol", reference = 293.15 }
[solver]
method = "collocation"
tolerance = 1e-6
time_limit = inf
[solver.relaxation]
domain = [-3, 4.5]
points = 401
tolerance = 1e-9
acceleration = "none"
estimate = true
[output]
fields = ["pressure", "film_thickness", "shear_traction"]
x = [-1, 0.0, 1]
limits = false
cavity_shear = "streamers"
[surface]
tolerance = 1e-3
quantities = ["mu_drag", "mu_drag"]
points = 2000
seed = 7
"#;

/// Mistakes that an editor marks.
const MISTAKES: [&str; 40] = [
    "title = \"without cases\"",
    "[axes]\nf = \"text\"\nalpha = 1.0\nbeta = 1.0",
    "[axes]\nf = -1.0\nalpha = 1.0\nbeta = 1.0",
    "[axes]\nf = []\nalpha = 1.0\nbeta = 1.0",
    "[axes]\nf = 1.0\nalpha = 1.0\nbeta = inf",
    "[axes]\nf = 1.0\nalpha = 1.0\nbeta = 0.0",
    "[axes]\nf = 1.0\nalpha = true\nbeta = 1.0",
    "[axes]\nf = 1.0\nalpha = 1.0\nbeta = { from = 1.0, points = 3 }",
    "[axes]\nf = 1.0\nalpha = 1.0\nbeta = { from = 1.0, to = 2.0, points = 1 }",
    "[axes]\nf = 1.0\nalpha = 1.0\nbeta = { from = 1.0, to = 2.0, points = 3, scale = \"logarithmic\" }",
    "[axes]\nf = 1.0\nalpha = 1.0\nbeta = { from = 1.0, to = 2.0, points = 3, step = 1 }",
    "[axes]\nf = 1.0\nalpha = 1.0\nbeta = 1.0\ngamma = 1.0",
    "[axes]\nf = 1.0\nalpha = 1.0\nbeta = 1.0\nslide_roll = 2",
    "axes = 3",
    "colour = 1\n[axes]\nf = 1.0\nalpha = 1.0\nbeta = 1.0",
    "title = 1\n[axes]\nf = 1.0\nalpha = 1.0\nbeta = 1.0",
    "title = \"\"\n[axes]\nf = 1.0\nalpha = 1.0\nbeta = 1.0",
    "[laboratory]\nradius = \"large\"",
    "[laboratory]\nradius = \"5\"",
    "[laboratory]\nradius = -1",
    "[laboratory]\nlenght = 1",
    "[laboratory]\nposson_ratio = 0.5",
    "[laboratory]\npoisson_ratio = 0.6",
    "[laboratory]\npoisson_ratio = \"0.5\"",
    "[laboratory]\nslide_roll_ratio = 3",
    "[laboratory]\ntemperature = 20",
    "[laboratory]\nswap = \"yes\"",
    "[laboratory]\nviscosity = { law = \"wlf\", value = 1.0, reference = 300 }",
    "[laboratory]\nviscosity = { law = \"arrhenius\", value = 1.0, b = 1.0, reference = 300 }",
    "[laboratory]\n[flat]\nrelaxation = [{ modulus = 1.0 }]",
    "[laboratory]\n[flat]\nrelaxation = [{ modulus = 1.0, fraction = 0.5, time = 1.0 }]",
    "[laboratory]\n[flat]\nmodes = [{ share = 2.0, time = 1.0 }]",
    "[laboratory]\n[flat]\nshear_modulus = 1.0",
    "[laboratory]\n[solver]\nmethod = \"newton\"",
    "[laboratory]\n[solver]\ntolerance = 0.5",
    "[laboratory]\n[solver]\nrelaxation = { points = 400 }",
    "[laboratory]\n[solver]\nrelaxation = { domain = [1.0, 2.0] }",
    "[laboratory]\n[output]\nfields = [\"pressure\", \"pressure\"]",
    "[laboratory]\n[output]\ncavity_shear = \"half\"",
    "[laboratory]\n[surface]\nquantities = [\"error_c\"]",
];

/// True if `stribeck run` or `stribeck surface` takes a file.
fn is_taken(text: &str) -> bool {
    Sweep::parse("a", text).is_ok() || SurfaceSweep::parse("a", text).is_ok()
}

/// The places of all values of a table that stand behind an equals sign.
fn places(table: &DeTable<'_>, text: &str, found: &mut Vec<std::ops::Range<usize>>) {
    fn of_value(value: &Spanned<DeValue<'_>>, text: &str, found: &mut Vec<std::ops::Range<usize>>) {
        let is_header = value.get_ref().is_table() && !text[value.span()].starts_with('{');
        if !is_header {
            found.push(value.span());
        }
        match value.get_ref() {
            DeValue::Table(table) => places(table, text, found),
            DeValue::Array(items) => items.iter().for_each(|item| of_value(item, text, found)),
            _ => {}
        }
    }
    table.values().for_each(|value| of_value(value, text, found));
}

/// The file with each value replaced, each line left out, and keys added that its sections do not have.
fn variants(text: &str, schema: &Value) -> BTreeSet<String> {
    let mut variants = BTreeSet::new();
    let document = DeTable::parse(text).expect("valid TOML");
    let mut found = Vec::new();
    places(document.get_ref(), text, &mut found);
    for place in found {
        variants.extend(VALUES.map(|value| format!("{}{value}{}", &text[..place.start], &text[place.end..])));
    }
    for line in text.split_inclusive('\n') {
        variants.insert(text.replacen(line, "", 1));
    }
    let properties = schema["properties"].as_object().expect("keys");
    for (section, keys) in properties.iter().filter_map(|(name, it)| Some((name, it["properties"].as_object()?))) {
        let header = format!("[{section}]\n");
        let sound = if text.contains(&header) { text.to_owned() } else { format!("{text}\n{header}") };
        for key in keys.keys() {
            variants.extend(VALUES.map(|value| sound.replacen(&header, &format!("{header}{key} = {value}\n"), 1)));
        }
    }
    variants
}

/// The sweep files of the repository, and those to start from.
fn shipped() -> Vec<(String, String)> {
    let sweeps = fs::read_dir(root().join("sweeps")).expect("listed").map(|entry| entry.expect("listed").path());
    let mut files: Vec<(String, String)> = sweeps
        .filter(|path| path.extension().is_some_and(|it| it == "toml"))
        .filter(|path| !path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("study-")))
        .chain([root().join("docs/how-to/instrument-files/experiment.toml")])
        .map(|path| (path.display().to_string(), fs::read_to_string(&path).expect("read")))
        .collect();
    assert!(files.len() > 30);
    for options in [&["init"][..], &["init", "--laboratory"], &["init", "--surface"]] {
        files.push((options.join(" "), out(&say(Path::new("."), options))));
    }
    files.push(("all of it".to_owned(), FULL.to_owned()));
    files
}

#[test]
fn the_schema_takes_what_the_reader_takes_and_refuses_mistakes() {
    let directory = tempdir().expect("a temporary directory");
    let text = out(&say(directory.path(), &["schema"]));
    let schema: Value = serde_json::from_str(&text).expect("JSON");
    let mut cases = Vec::new();
    for (name, text) in shipped() {
        assert!(is_taken(&text), "{name}");
        cases.push(json!({ "name": name, "text": text, "valid": true }));
    }
    let file = "[axes]\nf = 1\nalpha = 1\nbeta = 1\n[flat]\nrelaxation = { file = \"a.csv\", modulus_unit = \"MPa\" }";
    cases.push(json!({ "name": "a file that is named", "text": file, "valid": true }));
    let mut taken = 0;
    // Quick to read: how many points there are is not the question.
    let of_sweeps = ["surface.toml", "rolling.toml", "two-modes.toml"].map(|name| {
        fs::read_to_string(root().join("sweeps").join(name)).expect("read").replace("points = 601", "points = 3")
    });
    for text in of_sweeps.iter().map(String::as_str).chain([FULL]) {
        for variant in variants(text, &schema).into_iter().filter(|variant| is_taken(variant)) {
            taken += 1;
            cases.push(json!({ "name": "a changed file", "text": variant, "valid": true }));
        }
    }
    assert!(taken > 500, "{taken}");
    for text in MISTAKES {
        assert!(!is_taken(text), "{text}");
        cases.push(json!({ "name": "a mistake", "text": text, "valid": false }));
    }
    let (of_schema, of_cases) = (directory.path().join("schema.json"), directory.path().join("cases.json"));
    fs::write(&of_schema, text).expect("written");
    fs::write(&of_cases, serde_json::to_string(&cases).expect("JSON")).expect("written");
    let paths = [&of_schema, &of_cases].map(|path| path.to_str().expect("text"));
    let said = check(&run_python("tests/python/check_schema.py", &paths));
    assert_eq!(said, format!("{} files as expected\n", cases.len()));
}

/// A study file with all that there is, and mistakes of it: what stands there, and what in its place.
const STUDY: &str = r#"title = "All"
measure = ["error", "stability"]
repeats = 2
start = "chain"
[axes]
f = [1.0]
alpha = { from = 0.1, to = 10.0, points = 3, scale = "log" }
beta = [10.0]
[[case]]
alpha = inf
beta = 100.0
f = 10.0
[substrate]
modes = [{ share = 1.0, time = 1.0 }]
[[method]]
method = "collocation"
label = "tight"
tolerance = [1e-3, 1e-5]
degree = 8
[[method]]
method = "collocation"
panels = [8, 12]
[[method]]
method = "relaxation"
points = [201, 401]
tolerance = 1e-6
acceleration = "none"
"#;

const STUDY_MISTAKES: [(&str, &str); 13] = [
    ("title = \"All\"", "title = \"\""),
    ("\"stability\"", "\"speed\""),
    ("repeats = 2", "repeats = 0"),
    ("\"chain\"", "\"chains\""),
    ("f = [1.0]", "slide_roll = [1.0]\nf = [1.0]"),
    ("beta = 100.0", "beta = 0.0"),
    ("alpha = inf\n", ""),
    ("share = 1.0", "share = 2.0"),
    ("label = \"tight\"", "lable = \"tight\""),
    ("degree = 8", "degree = 0"),
    ("[201, 401]", "[200]"),
    ("[8, 12]", "[8, 8]"),
    ("method = \"relaxation\"", "method = \"relax\""),
];

#[test]
fn the_schema_of_studies_takes_what_the_reader_takes_and_refuses_mistakes() {
    let directory = tempdir().expect("a temporary directory");
    let text = out(&say(directory.path(), &["schema", "--study"]));
    let studies = fs::read_dir(root().join("sweeps")).expect("listed").map(|entry| entry.expect("listed").path());
    let is_study =
        |path: &std::path::PathBuf| path.file_name().is_some_and(|it| it.to_string_lossy().starts_with("study-"));
    let files =
        studies.filter(is_study).map(|path| (path.display().to_string(), fs::read_to_string(&path).expect("read")));
    let mut cases: Vec<Value> = files
        .chain([("all of it".to_owned(), STUDY.to_owned())])
        .map(|(name, text)| json!({ "name": name, "text": text, "valid": true }))
        .collect();
    assert!(cases.len() > 2);
    for (good, bad) in STUDY_MISTAKES {
        assert!(STUDY.contains(good), "{good}");
        cases.push(json!({ "name": bad, "text": STUDY.replacen(good, bad, 1), "valid": false }));
    }
    // The reader agrees, file by file.
    for case in &cases {
        let file = directory.path().join("study.toml");
        fs::write(&file, case["text"].as_str().expect("text")).expect("written");
        // A directory that cannot be one ends a study that is valid, before anything is solved.
        let said = say(directory.path(), &["study", "study.toml", "-o", "study.toml"]);
        let expected = if case["valid"] == true { 4 } else { 2 };
        assert_eq!(code(&said), expected, "{}: {}", case["name"], err(&said));
    }
    let (of_schema, of_cases) = (directory.path().join("schema.json"), directory.path().join("cases.json"));
    fs::write(&of_schema, text).expect("written");
    fs::write(&of_cases, serde_json::to_string(&cases).expect("JSON")).expect("written");
    let paths = [&of_schema, &of_cases].map(|path| path.to_str().expect("text"));
    let said = check(&run_python("tests/python/check_schema.py", &paths));
    assert_eq!(said, format!("{} files as expected\n", cases.len()));
}

/// Editors show what a key means.
#[test]
fn every_key_of_the_schema_is_described() {
    fn keys(schema: &Value, path: &str) -> usize {
        let Some(properties) = schema["properties"].as_object() else { return 0 };
        let of = |(key, schema): (&String, &Value)| {
            let path = format!("{path}.{key}");
            assert!(schema["description"].as_str().is_some_and(|text| text.ends_with('.')), "{path}");
            1 + keys(schema, &path)
        };
        assert_eq!(schema["additionalProperties"], false, "{path}");
        properties.iter().map(of).sum()
    }
    assert!(keys(&stribeck_sweep::schema(), "") > 80);
}
