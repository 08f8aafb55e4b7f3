//! `stribeck material` from outside.

use std::fs;
use std::path::Path;

use serde_json::Value;
use stribeck_lab::{MaterialData, MaterialFile, MaterialOptions, Relaxation, RelaxationFit, RelaxationTerm, ShiftLaw};
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
    let file = MaterialFile::read(&directory.join("rubber.csv"), &MaterialOptions::default()).expect("a table");
    let MaterialData::Moduli(measurements) = file.data else { panic!("{file:?}") };
    RelaxationFit::new(&measurements, terms).expect("a fit")
}

#[test]
fn json_has_the_numbers_of_the_fit() {
    let directory = with_table();
    let said = say(directory.path(), &["material", "rubber.csv", "--terms", "29", "--json"]);
    assert_eq!(code(&said), 0);
    assert!(err(&said).starts_with("rubber.csv: UTF-8, separated by commas"), "{}", err(&said));
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
    for text in ["Fit to rubber", "storage E′", "loss E″", "angular frequency ω (rad/s)", "modulus (Pa)"] {
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
        ("", "bad.csv: ", "it holds no table"),
        ("omega,storage,los\n1,2,3\n", "bad.csv: ", "--columns \"loss=los\": `los` (not known here)"),
        ("1,2,3\n4,5,6\n", "bad.csv: ", "--columns \"omega=#1,storage=#2,loss=#3\""),
        ("omega,loss\n1,2\n", "bad.csv: ", "no columns of a material; these are storage and loss (Pa)"),
        ("storage,loss\n1,2\n", "bad.csv: ", "It has storage, loss"),
        ("time,modulus\n1,2\n2,1\n", "bad.csv: ", "a relaxation modulus over time or the terms of a series"),
        ("omega,storage,loss,omega\n1,2,3,4\n", "bad.csv: ", "two columns of omega"),
        ("omega (mm),storage,loss\n1,2,3\n", "bad.csv: ", "a length, not an angular frequency"),
        ("omega,storage,loss\n1,2,3\n2,0,3\n", "bad.csv:3: storage = \"0\" ", "storage is a number above 0"),
        ("omega,storage,loss\n1,2,3\n\n 2, 4 , -3\n", "bad.csv:4: loss = \"-3\" ", "a number from 0"),
        ("omega,storage,loss\n0,2,3\n", "bad.csv:2: omega = \"0\" ", "a number above 0"),
        ("omega,storage,loss\n1,2,3\n", "bad.csv: ", "rows at two frequencies or times"),
        ("omega,storage,loss\n1,2,3\n1,2,3\n", "bad.csv: ", "rows at two frequencies or times"),
        ("omega,G',G\"\n1,2,3\n2,3,4\n", "bad.csv: ", "shear moduli, and a substrate has Young's modulus"),
        ("omega,|E*|,delta\n1,2,30\n2,3,40\n", "bad.csv:2: delta = \"30\" ", "write the unit, as in delta (deg)"),
        ("omega,storage,loss,T\n1,2,3,20\n2,3,4,20\n", "bad.csv:2: T = \"20\" ", "above 100 K; write the unit"),
        ("*viscoelastic, time=prony\n.1,,x\n", "bad.csv:2:5: ", "must be a number, found `x`"),
        ("*viscoelastic, time=prony\n.6,,1\n.4,,2\n", "bad.csv: ", "the fractions add up to 1.0000"),
    ] {
        fs::write(directory.path().join("bad.csv"), text).expect("written");
        let output = say(directory.path(), &["material", "bad.csv"]);
        let words: Vec<String> =
            err(&output).split(|c: char| c.is_whitespace() || c == '│').map(str::to_owned).collect();
        let message = words.into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
        assert_eq!(code(&output), 2, "{text}\n{message}");
        assert!(message.contains(place) && message.contains(said), "{text}\n{message}");
    }
    assert_eq!(paths(directory.path()).len(), 1, "nothing is written");
}

/// Isotherms of a material that follows the law of Arrhenius; a file without a reference is refused, not mixed.
#[test]
fn isotherms_need_a_reference_and_give_a_law() {
    let directory = tempdir().expect("a temporary directory");
    let term = |modulus, time| RelaxationTerm { modulus, time };
    let terms = [(2e8, 1e-3), (9e7, 1e-2), (3e7, 0.1), (8e6, 1.0), (2e6, 10.0), (5e5, 100.0)];
    let rubber = Relaxation::new(1e6, terms.map(|(modulus, time)| term(modulus, time)).to_vec()).expect("a material");
    let law = ShiftLaw::Arrhenius { activation_energy: 1.2e5, reference: 293.15 };
    let mut text = "\u{feff}f;E_stor;E_loss;T;Set\nHz;MPa;MPa;°C;-\n".to_owned();
    for set in 0..7 {
        let celsius = 10.0 * f64::from(set) - 10.0;
        let factor = law.shift_factor(celsius + 273.15).expect("above absolute zero");
        for i in -8..=16 {
            let frequency = 10_f64.powf(f64::from(i) / 8.0);
            let (storage, loss) = rubber.storage_and_loss(std::f64::consts::TAU * frequency * factor);
            text += &format!("{frequency:.6};{:.6};{:.6};{celsius:.1};{set}\n", storage / 1e6, loss / 1e6)
                .replace('.', ",");
        }
    }
    fs::write(directory.path().join("isotherms.csv"), text).expect("written");
    let refused = say(directory.path(), &["material", "isotherms.csv"]);
    assert_eq!(code(&refused), 2);
    assert!(err(&refused).contains("at temperatures from -10.0 to 50.0 degC and no one material"), "{}", err(&refused));
    let asked = ["material", "isotherms.csv", "--reference-temperature", "20 degC", "-o", "curve.svg"];
    let said = say(directory.path(), &asked);
    assert_eq!(code(&said), 0, "{}", err(&said));
    let said = out(&said);
    assert!(said.starts_with("master curve at 20 degC") && said.contains("\narrhenius: 1"), "{said}");
    assert!(said.contains("\nshift = { law = \"arrhenius\", activation_energy = \"1"), "{said}");
    assert!(fs::read_to_string(directory.path().join("curve.svg")).expect("a picture").contains("at 20 degC"));
    let energy = |said: &str| -> f64 {
        let (_, rest) = said.split_once("arrhenius: ").expect("the law");
        rest.split_whitespace().next().expect("a number").parse().expect("a number")
    };
    assert!((energy(&said) / 120.0 - 1.0).abs() < 0.02, "{said}");
    // the factors of the law itself, as a file
    let factors: String = (-12..=52)
        .map(|celsius| {
            let log = law.log_shift_factor(f64::from(celsius) + 273.15).expect("above absolute zero");
            format!("{celsius},{log:.6}\n")
        })
        .collect();
    fs::write(directory.path().join("factors.csv"), format!("T,log_aT\nC,-\n{factors}")).expect("written");
    let given = say(directory.path(), &["material", "isotherms.csv", "--shift-factors", "factors.csv"]);
    assert_eq!(code(&given), 0, "{}", err(&given));
    assert!((energy(&out(&given)) / 120.0 - 1.0).abs() < 1e-4, "{}", out(&given));
    fs::write(directory.path().join("bare.csv"), factors).expect("written");
    let given = ["material", "isotherms.csv", "--shift-factors", "bare.csv", "--shift-columns"];
    let said = say(directory.path(), &[&given[..], &["temperature=#1 (degC),log_shift_factor=#2"]].concat());
    assert!(code(&said) == 0 && (energy(&out(&said)) / 120.0 - 1.0).abs() < 1e-4, "{}", err(&said));
}

/// Isotherms whose moduli grow with the temperature as those of a rubber do, and the pictures of their shifts.
#[test]
fn moduli_are_shifted_if_asked_and_shifts_are_drawn() {
    let directory = tempdir().expect("a temporary directory");
    let isotherms = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/how-to/instrument-files/isotherms.csv");
    let asked = ["material", isotherms, "--reference-temperature", "20 degC"];
    let run = |options: &[&str]| say(directory.path(), &[&asked[..], options].concat());
    assert!(!out(&run(&[])).contains("b_T"));
    for (how, words) in [
        (&["--vertical-shift", "fit"][..], "shifted along rates and moduli"),
        (&["--vertical-shift", "density", "--expansion", "6e-4"], "with an expansion of 0.0006/K"),
    ] {
        let said = run(how);
        assert!(code(&said) == 0 && out(&said).contains(words), "{}{}", out(&said), err(&said));
        assert!(out(&said).contains("b_T") && out(&said).contains(" 1.0000 "), "{}", out(&said));
    }
    let said = run(&["--shift-picture", "shifts.svg"]);
    assert!(out(&said).ends_with("\nshifts.svg\n\nshifts-residuals.svg\n"), "{}", out(&said));
    for (name, words) in [("shifts.svg", "Shift factors"), ("shifts-residuals.svg", "miss the shift factors by")] {
        let picture = fs::read_to_string(directory.path().join(name)).expect("a picture");
        assert!(picture.contains(words) && picture.contains(" = 1 at 20 degC"), "{picture}");
    }
    fs::write(directory.path().join("series.csv"), "tau,fraction\n1,0.5\n").expect("written");
    let refused = say(directory.path(), &["material", "series.csv", "--shift-picture", "more.svg"]);
    assert!(code(&refused) == 2 && err(&refused).contains("nothing was shifted"), "{}", err(&refused));
}

/// A liquid is told whatever the number of terms, and a series of shear moduli is 2(1+ν) times as stiff.
#[test]
fn doubts_and_factors_are_told() {
    let directory = with_table();
    let moduli = |arguments: &[&str]| -> f64 {
        let said = say(directory.path(), &[&["material", "rubber.csv", "--json"], arguments].concat());
        let object: Value = serde_json::from_str(&out(&said)).expect("JSON");
        assert_eq!(object["doubt"], Value::Null);
        object["instantaneous_modulus"].as_f64().expect("a number")
    };
    let shear = ["--terms", "9", "--shear", "--poisson-ratio", "0.5"];
    assert!((moduli(&shear) / moduli(&shear[..2]) / 3.0 - 1.0).abs() < 1e-12);
    let liquid = "omega,storage,loss\n1,100,300\n3,500,800\n10,2000,1500\n30,4000,1200\n100,5000,500\n";
    fs::write(directory.path().join("liquid.csv"), liquid).expect("written");
    for terms in ["2", "3", "5", "auto"] {
        let output = say(directory.path(), &["material", "liquid.csv", "--terms", terms]);
        assert!((out(&output) + &err(&output)).contains("liquid"), "{terms}: {}", out(&output));
    }
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
        (&["rubber.csv", "--terms", "9", "-o", "fit.jpg"], "ends in .svg, .png or .pdf"),
        (&["liquid.csv", "--terms", "6"], "ask for 5 terms or fewer"),
        (&["liquid.csv", "--terms", "4"], "the best fit has no relaxed modulus"),
        (&["absent.csv", "--terms", "4"], "cannot read the file of a material absent.csv"),
    ] {
        let output = say(directory.path(), &[&["material"], arguments].concat());
        assert_eq!(code(&output), 2, "{arguments:?}: {}", err(&output));
        assert!(err(&output).contains(said), "{arguments:?}: {}", err(&output));
    }
    assert_eq!(paths(directory.path()).len(), 2, "nothing is written");
}

/// Each option that says nothing of a file is refused with what to do, whatever the file is.
#[test]
fn no_option_is_left_out_in_silence() {
    let directory = with_table();
    let files = [
        ("fractions.csv", "tau,fraction\n1,0.25\n10,0.5\n"),
        ("series.csv", "E0 = 2 MPa\ntau,fraction\n1,0.25\n10,0.5\n"),
        ("abaqus.inp", "*ELASTIC\n2.0, 0.5\n*VISCOELASTIC, TIME=PRONY\n0.25, 0., 1.\n"),
        ("bare.inp", "*VISCOELASTIC, TIME=PRONY\n0.25, 0., 1.\n"),
        ("shear.csv", "omega,G' (kPa),G'' (kPa)\n1,100,10\n10,120,20\n100,150,30\n"),
        ("one.csv", "omega,storage (Pa),loss (Pa),T (degC)\n1,100,10,20\n10,120,20,20\n100,150,30,20\n"),
        ("factors.csv", "temperature (degC),log_shift_factor\n0,1.5\n20,0\n40,-1.2\n"),
    ];
    for (name, text) in files {
        fs::write(directory.path().join(name), text).expect("written");
    }
    for (arguments, said) in [
        (&["fractions.csv", "--terms", "4"][..], "--terms would change nothing: a Prony series is converted"),
        (&["fractions.csv", "--shear", "--poisson-ratio", "0.5"], "those of shear and of Young's moduli are the same"),
        (
            &["series.csv", "--poisson-ratio", "0.5"],
            "--poisson-ratio would change nothing: moduli are taken for Young's",
        ),
        (&["fractions.csv", "--modulus-unit", "MPa"], "it holds no modulus without a unit; leave out --modulus-unit"),
        (&["series.csv", "--modulus-unit", "MPa"], "it holds no modulus without a unit; leave out --modulus-unit"),
        (&["shear.csv", "--modulus-unit", "MPa", "--poisson-ratio", "0.5"], "it holds no modulus without a unit"),
        (&["fractions.csv", "--reference-temperature", "20 degC"], "a Prony series is at one temperature"),
        (&["fractions.csv", "--vertical-shift", "fit"], "there are no isotherms here whose moduli could be shifted"),
        (&["rubber.csv", "--vertical-shift", "fit"], "there are no isotherms here whose moduli could be shifted"),
        (&["one.csv", "--vertical-shift", "density"], "there are no isotherms here whose moduli could be shifted"),
        (&["rubber.csv", "--expansion", "6e-4"], "--expansion would change nothing: no density is known"),
        (&["rubber.csv", "--poisson-ratio", "0.5"], "add --shear if they are shear moduli"),
        (&["rubber.csv", "--reference-temperature", "20 degC"], "no column has a temperature"),
        (&["rubber.csv", "--title", "Rubber"], "--title would change nothing: no picture is drawn; add -o FILE"),
        (&["rubber.csv", "--shift-columns", "temperature=#1"], "--shift-factors <FILE>"),
        (&["abaqus.inp", "--shear", "--poisson-ratio", "0.5"], "the modulus in an input file of Abaqus is Young's"),
        (&["abaqus.inp", "--columns", "tau=#1"], "an input file of Abaqus has no columns"),
        (&["bare.inp", "--modulus-unit", "MPa"], "this input file of Abaqus holds no modulus"),
    ] {
        let output = say(directory.path(), &[&["material"], arguments].concat());
        assert_eq!(code(&output), 2, "{arguments:?}: {}{}", out(&output), err(&output));
        assert!(err(&output).contains(said), "{arguments:?}: {}", err(&output));
    }
}

/// Shift factors beside a Prony series give the law of its times, in print, in JSON and as a picture.
#[test]
fn shift_factors_beside_a_series_give_its_law() {
    let directory = tempdir().expect("a temporary directory");
    let law = ShiftLaw::Arrhenius { activation_energy: 9e4, reference: 293.15 };
    let factors: String = (0..=8)
        .map(|step| {
            let celsius = 10.0 * f64::from(step) - 20.0;
            let log = law.log_shift_factor(celsius + 273.15).expect("above absolute zero");
            format!("{celsius};{log:.6}\n")
        })
        .collect();
    fs::write(directory.path().join("factors.csv"), format!("T (°C);log_aT\n{factors}")).expect("written");
    fs::write(directory.path().join("series.csv"), "# E0 = 2\ntau,fraction\n1,0.25\n10,0.5\n").expect("written");
    let given = ["material", "series.csv", "--shift-factors", "factors.csv", "--modulus-unit", "MPa"];
    let said = say(directory.path(), &[&given[..], &["--shift-picture", "shifts.svg"]].concat());
    assert_eq!(code(&said), 0, "{}", err(&said));
    let text = out(&said);
    assert!(text.starts_with("master curve at 20 degC") && text.contains("2.00000e6  Pa, instantaneous"), "{text}");
    assert!(text.contains("shift = { law = \"arrhenius\", activation_energy = \"9"), "{text}");
    assert!(directory.path().join("shifts.svg").exists());
    let said = say(directory.path(), &[&given[..], &["--json", "--reference-temperature", "30 degC"]].concat());
    let found: Value = serde_json::from_str(&out(&said)).expect("JSON");
    assert_eq!(found["master_curve"]["reference"].as_f64(), Some(303.15), "{found}");
    let bare = say(directory.path(), &given[..4]);
    assert!(err(&bare).contains("has no unit there and is left out; give the unit of moduli"), "{}", err(&bare));
}
