//! All mistakes of a sweep file are told in one go, each at its place, and nothing else.

use proptest::prelude::*;
use proptest::sample::subsequence;
use stribeck_input::InputError;
use stribeck_sweep::{SurfaceSweep, Sweep};

use super::drawn;

/// A sweep over α, β and f with every section.
const DIMENSIONLESS: &str = r#"title = "a surface"
[axes]
slide_roll = [0.5, 1.0]
alpha = { from = 1e-2, to = 1e2, points = 5, scale = "log" }
beta = [10.0, 100.0]
f = [10.0]
[substrate]
modes = [{ share = 0.7, time = 1.0 }, { share = 0.3, time = 100.0 }]
[solver]
method = "collocation"
tolerance = 1e-5
time_limit = 60.0
[solver.relaxation]
points = 401
acceleration = "anderson"
[output]
fields = ["pressure", "film_thickness"]
x = { from = -3.0, to = 3.0, points = 11 }
limits = true
[surface]
seed = 1
"#;

/// Mistakes of it: what stands there, and what in its place. No two of them share a line.
const OF_DIMENSIONLESS: [(&str, &str); 17] = [
    ("title = \"a surface\"", "title = 3"),
    ("slide_roll = [0.5, 1.0]", "slide_roll = [0.5, 2.0]"),
    ("from = 1e-2", "from = -1e-2"),
    ("beta = [10.0, 100.0]", "beta = [100.0, 10.0]"),
    ("f = [10.0]", "f = []"),
    ("share = 0.7", "share = 1.7"),
    ("method = \"collocation\"", "method = \"colocation\""),
    ("tolerance = 1e-5", "tolernce = 1e-5"),
    ("time_limit = 60.0", "time_limit = 0.0"),
    ("points = 401", "points = 400"),
    ("acceleration = \"anderson\"", "acceleration = true"),
    ("[output]", "[outptu]"),
    ("\"pressure\"", "\"presure\""),
    ("points = 11", "points = 1"),
    ("limits = true", "limits = \"yes\""),
    ("[surface]", "[surface]\nqwertyuiop = 1"),
    ("seed = 1", "seed = -1"),
];

/// An experiment with both bodies.
const LABORATORY: &str = r#"[laboratory]
radius = "2 mm"
load = ["100 N/m", "200 N/m"]
viscosity = { law = "arrhenius", value = "0.1 Pa s", activation_energy = "30 kJ/mol", reference = "40 degC" }
temperature = "30 degC"
entrainment_speed = { from = "1 mm/s", to = "1 m/s", points = 5, scale = "log" }
slide_roll_ratio = [0.0, 0.5]
swap = true
roughness = "50 nm"
[flat]
relaxed_modulus = "1 MPa"
poisson_ratio = 0.5
f = 10.0
retardation_time = "20 ms"
shift = { law = "wlf", c1 = 17.4, c2 = "51.6 K", reference = "20 degC" }
[roller]
relaxed_modulus = "2 MPa"
poisson_ratio = 0.4
[output]
fields = []
"#;

const OF_LABORATORY: [(&str, &str); 18] = [
    ("radius = \"2 mm\"", "radius = \"2 parrots\""),
    ("\"200 N/m\"", "\"50 N/m\""),
    ("activation_energy = \"30 kJ/mol\"", "activation_energy = \"30 kg\""),
    ("temperature = \"30 degC\"", "temperature = \"30\""),
    ("from = \"1 mm/s\"", "from = \"2 m/s\""),
    ("slide_roll_ratio = [0.0, 0.5]", "slide_rol_ratio = [0.0, 0.5]"),
    ("swap = true", "swap = 1"),
    ("roughness = \"50 nm\"", "roughness = \"-50 nm\""),
    ("relaxed_modulus = \"1 MPa\"", "modulus = \"1 MPa\""),
    ("poisson_ratio = 0.5", "poisson_ratio = 0.6"),
    ("f = 10.0", "f = -10.0"),
    ("retardation_time = \"20 ms\"", "retardation_time = \"20 mm\""),
    ("c1 = 17.4", "c1 = 0.0"),
    ("[roller]\n", "[roler]\n"),
    ("relaxed_modulus = \"2 MPa\"\n", ""),
    ("poisson_ratio = 0.4", "poisson_ratio = true"),
    ("[output]\n", "[output]\nlimits = 0\n"),
    ("fields = []", "fields = {}"),
];

/// The text with some mistakes in it, and the lines that they stand in, in order; what is left out is told at the
/// beginning of its section.
fn planted(base: &str, mistakes: &[(&str, &str)]) -> (String, Vec<usize>) {
    let text = mistakes.iter().fold(base.to_owned(), |text, (good, bad)| {
        assert_eq!(text.matches(good).count(), 1, "{good}");
        text.replace(good, bad)
    });
    let line = |(good, bad): &(&str, &str)| {
        let place = match bad.lines().last() {
            Some(last) => text.find(last).expect("it was put there"),
            None => {
                let section = base[..base.find(good).expect("it is there")].rfind("\n[").expect("it has a header");
                let header = base[section + 1..].lines().next().expect("a line");
                text.find(header).or_else(|| text.find(&header.replace("ll", "l"))).expect("it is there")
            }
        };
        text[..place].matches('\n').count() + 1
    };
    let mut lines: Vec<usize> = mistakes.iter().map(line).collect();
    lines.sort_unstable();
    (text, lines)
}

/// The lines of the mistakes that are told, with what is said of each.
fn told(error: &InputError) -> Vec<(usize, String)> {
    let InputError::Invalid(invalid) = error else { panic!("{error}") };
    invalid.mistakes().map(|mistake| (mistake.line(), mistake.to_string())).collect()
}

fn check(base: &str, mistakes: &[(&str, &str)]) {
    let (text, lines) = planted(base, mistakes);
    let error = Sweep::parse("bad", &text).expect_err(&text);
    let told = told(&error);
    let mut found: Vec<usize> = told.iter().map(|(line, _)| *line).collect();
    let there: Vec<usize> = told.iter().filter(|(_, said)| !said.contains("missing")).map(|(line, _)| *line).collect();
    assert!(there.is_sorted(), "in the order of the file: {told:#?}\n{text}");
    found.sort_unstable();
    assert_eq!(found, lines, "{told:#?}\n{text}");
    let drawing = drawn(&error);
    for (line, said) in &told {
        assert!(said.starts_with(&format!("bad.toml:{line}:")), "{said}");
        let offending = text.lines().nth(line - 1).expect("the line is in the text");
        assert!(drawing.contains(offending) && drawing.contains(&format!("[bad.toml:{line}:")), "{drawing}");
    }
}

#[test]
fn the_files_without_mistakes_are_taken() {
    for base in [DIMENSIONLESS, LABORATORY] {
        Sweep::parse("good", base).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn each_mistake_is_told_alone_and_all_are_told_together() {
    for (base, mistakes) in [(DIMENSIONLESS, &OF_DIMENSIONLESS[..]), (LABORATORY, &OF_LABORATORY[..])] {
        mistakes.iter().for_each(|mistake| check(base, &[*mistake]));
        check(base, mistakes);
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 200,
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn k_mistakes_give_k_reports(
        of_dimensionless in subsequence(&OF_DIMENSIONLESS, 2..=6),
        of_laboratory in subsequence(&OF_LABORATORY, 2..=6),
    ) {
        check(DIMENSIONLESS, &of_dimensionless);
        check(LABORATORY, &of_laboratory);
    }
}

/// (text, the place `line:column` of each mistake)
const TOGETHER: [(&str, &[&str]); 8] = [
    // Two mistakes of one range, and two of one list.
    (
        "[axes]\nf = [1.0, -1.0, nan]\nalpha = { from = -1.0, to = \"a\", points = 1 }\nbeta = [10.0]\n",
        &["2:11", "2:17", "3:18", "3:29", "3:43"],
    ),
    // What is missing, and what is there beside.
    ("[axes]\nalpha = [1.0]\n[solver]\nmethod = 1\n", &["1:1", "1:1", "4:10"]),
    // A misspelt section and its content; it is not told as missing.
    ("[laboratry]\nradius = 0\nspeed = [1.0]\n[flat]\nrigid = 1\n", &["1:2", "2:10", "1:1", "1:1", "5:9"]),
    // A key that stands in another section is not missing in its own.
    ("beta = [10.0]\n[axes]\nalpha = [1.0]\nf = [-1.0]\n", &["1:1", "4:6"]),
    // Both forms of motion, with a value that is wrong too.
    (
        "[laboratory]\nradius = 1.0\nload = 1.0\nrelaxed_modulus = 1.0\npoisson_ratio = 0.5\nviscosity = 1.0\nf = 0.0\n\
         speed = [-1.0]\nflat_speed = 1.0\n",
        &["8:10", "9:14"],
    ),
    // A flat with a fault: what [laboratory] would take from it is not told as missing.
    (
        "[laboratory]\nradius = 1.0\nload = 1.0\nviscosity = -1.0\nspeed = [1.0]\n[flat]\nrelaxed_modulus = \"1 mm\"\n\
         poisson_ratio = 0.5\n",
        &["4:13", "7:19"],
    ),
    // Two moduli, of which one may be one of the other two.
    (
        "[laboratory]\nradius = 1.0\nload = 1.0\nviscosity = 1.0\nspeed = [1.0]\nyoung_modulus = 1.0\nf = 0.0\nnu = 0.5\n\
      poisson_ratio = 0.5\n",
        &["6:17", "8:1"],
    ),
    // No follow-up of a method that is unknown.
    (
        "[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [0.0]\n[solver]\nmethod = \"relax\"\n[output]\nsensitivities = true\n",
        &["4:9", "6:10"],
    ),
];

#[test]
fn mistakes_are_told_without_what_follows_from_them() {
    let mut wrong = Vec::new();
    for (text, places) in TOGETHER {
        let error = Sweep::parse("bad", text).expect_err(text);
        let told: Vec<String> = told(&error).into_iter().map(|(_, said)| said).collect();
        let found: Vec<&str> = told.iter().map(|said| &said["bad.toml:".len()..]).collect();
        let agrees = found.len() == places.len()
            && found.iter().zip(places).all(|(said, place)| said.starts_with(&format!("{place}: ")));
        if !agrees {
            wrong.push(format!("{told:#?}\n{places:?}\n{text}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_mistakes_of_a_surface_are_told_together() {
    let text = "[axes]\nalpha = [1.0, 2.0]\nbeta = { from = 1.0, scale = \"log\" }\nf = { from = -1.0, to = 1.0 }\n\
                [surface]\ntolerance = 1.0\n";
    let error = SurfaceSweep::parse("bad", text).expect_err(text);
    let lines: Vec<usize> = told(&error).into_iter().map(|(line, _)| line).collect();
    assert_eq!(lines, [2, 3, 4, 6], "{error}");
}

#[test]
fn very_many_mistakes_are_counted() {
    let keys: String = (0..50).map(|number| format!("qwertyuiop{number} = 1\n")).collect();
    let error =
        Sweep::parse("bad", &format!("{keys}[axes]\nf = [1.0]\nalpha = [1.0]\nbeta = [1.0]\n")).expect_err("bad");
    assert!(error.to_string().ends_with("(the first of 50 mistakes, 20 of which are told)"), "{error}");
    assert_eq!(told(&error).len(), 20);
}
