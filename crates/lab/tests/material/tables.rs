//! One material in every form in which tables describe it.

use std::path::Path;

use super::{decay, oscillation, rubber};
use proptest::prelude::*;
use stribeck_lab::{
    ColumnChoice, MaterialData, MaterialFile, MaterialOptions, Measurement, Measurements, RelaxationFit, ShiftFactors,
};
use tempfile::tempdir;

fn read(text: &str, options: &MaterialOptions) -> MaterialFile {
    MaterialFile::of(Path::new("table"), text.as_bytes(), options).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn moduli(text: &str, options: &MaterialOptions) -> Measurements {
    match read(text, options).data {
        MaterialData::Moduli(measurements) => measurements,
        MaterialData::Isotherms(isotherms) if isotherms.all().len() == 1 => isotherms.all()[0].measurements.clone(),
        other => panic!("{other:?}"),
    }
}

/// A table with these names, and the numbers that a row of each measurement has.
fn table(names: &str, rows: &[Measurement], numbers: impl Fn(f64, [f64; 2]) -> Vec<f64>) -> String {
    let line = |row: &Measurement| {
        let numbers = numbers(row.rate(), row.moduli());
        numbers.iter().map(|number| format!("{number:e}")).collect::<Vec<_>>().join("\t") + "\n"
    };
    format!("{names}\n{}", rows.iter().map(line).collect::<String>())
}

fn assert_near(found: &Measurements, exact: &[Measurement], what: &str) {
    assert_eq!(found.rows().len(), exact.len(), "{what}");
    for (row, exact) in found.rows().iter().zip(exact) {
        assert!((row.rate() / exact.rate() - 1.0).abs() < 1e-12, "{what}: {row:?}, not {exact:?}");
        let ([a, b], [c, d]) = (row.moduli(), exact.moduli());
        assert!((a - c).hypot(b - d) < 1e-12 * c.hypot(d), "{what}: {row:?}, not {exact:?}");
    }
}

/// Frequency or ω, storage and loss or tan δ or |E*| and δ, in any unit, of Young's modulus or of shear.
#[test]
fn all_forms_of_moduli_are_the_same_material() {
    use std::f64::consts::TAU;
    let rows = oscillation(&rubber(), -2, 3);
    let plain = MaterialOptions::default();
    let shear = MaterialOptions { poisson_ratio: Some(0.5), ..MaterialOptions::default() };
    let said = MaterialOptions { is_shear: true, ..shear.clone() };
    let unit = MaterialOptions { modulus_unit: Some(1e6), ..MaterialOptions::default() };
    type Numbers = fn(f64, [f64; 2]) -> Vec<f64>;
    let forms: [(&str, &MaterialOptions, Numbers); 10] = [
        ("omega\tstorage\tloss", &plain, |rate, [a, b]| vec![rate, a, b]),
        ("Angular frequency\tStorage modulus\tLoss modulus\nrad/s\tMPa\tMPa", &plain, |rate, [a, b]| {
            vec![rate, a / 1e6, b / 1e6]
        }),
        ("freq_hz\tE'' (GPa)\tE' (GPa)\tnote", &plain, |rate, [a, b]| vec![rate / TAU, b / 1e9, a / 1e9, 7.0]),
        ("Freq\tG'\tG\"\tTemp\nrad/s\tPa\tPa\t°C", &shear, |rate, [a, b]| vec![rate, a / 3.0, b / 3.0, 25.0]),
        ("f [Hz]\tE′ [kPa]\ttan(delta) [-]", &plain, |rate, [a, b]| vec![rate / TAU, a / 1e3, b / a]),
        ("frequency\t|E*| (Pa)\tphase angle (deg)", &plain, |rate, [a, b]| {
            vec![rate / TAU, a.hypot(b), (b / a).atan().to_degrees()]
        }),
        ("omega\t|G*|\tdelta / rad\ttime", &shear, |rate, [a, b]| vec![rate, a.hypot(b) / 3.0, (b / a).atan(), 1.0]),
        ("omega\tstorage\tloss", &said, |rate, [a, b]| vec![rate, a / 3.0, b / 3.0]),
        ("omega\tE_stor\tE_loss", &unit, |rate, [a, b]| vec![rate, a / 1e6, b / 1e6]),
        ("f\tE_stor\tE_loss\tE_abs\tt\nHz\tPa\tPa\tPa\ts", &plain, |rate, [a, b]| vec![rate / TAU, a, b, 1.0, 2.0]),
    ];
    for (names, options, numbers) in forms {
        assert_near(&moduli(&table(names, &rows, numbers), options), &rows, names);
    }
    let chosen = MaterialOptions {
        columns: ColumnChoice::list("omega=#1,storage=#3 (kPa),loss=#2 (kPa)").expect("choices"),
        ..MaterialOptions::default()
    };
    let bare = table("", &rows, |rate, [a, b]| vec![rate, b / 1e3, a / 1e3]);
    assert_near(&moduli(bare.trim_start(), &chosen), &rows, "chosen");
}

/// E(t), from the first time or from the last.
#[test]
fn a_relaxation_test_is_read_and_fitted() {
    let mut rows = decay(&rubber(), -6, 3);
    rows.reverse();
    for (names, factor) in
        [("t\tE_relax\ns\tMPa", 1e6), ("Time (s)\tRelaxation modulus (Pa)", 1.0), ("time\tE(t)", 1.0)]
    {
        let text = table(names, &rows, |rate, [modulus, _]| vec![1.0 / rate, modulus / factor]);
        assert_near(&moduli(&text, &MaterialOptions::default()), &rows, names);
    }
    let text = table("t\tG(t)\ns\tPa", &rows, |rate, [modulus, _]| vec![1.0 / rate, modulus / 3.0]);
    let shear = MaterialOptions { poisson_ratio: Some(0.5), ..MaterialOptions::default() };
    let fit = RelaxationFit::new(&moduli(&text, &shear), 10).expect("a fit");
    assert!((fit.relaxation.relaxed_modulus() / rubber().relaxed_modulus() - 1.0).abs() < 1e-6);
}

/// T is the temperature and t the time, by their units or, without, by the letter; what is not read is told.
#[test]
fn temperatures_are_told_from_times_and_kept() {
    for names in ["t,E_relax,T\ns,MPa,C\n", "t,E_relax,T (degC)\n", "t (s),E_relax,temperature_C\n"] {
        let text = format!("{names}1,3,20\n10,2,20.1\n1,2.5,30\n10,1.5,30.2\n");
        let MaterialData::Isotherms(isotherms) = read(&text, &MaterialOptions::default()).data else {
            panic!("{names}")
        };
        let found: Vec<f64> = isotherms.all().iter().map(|one| one.temperature - 273.15).collect();
        assert!((found[0] - 20.05).abs() < 1e-9 && (found[1] - 30.1).abs() < 1e-9, "{found:?}");
    }
    let file = read("omega,storage,loss,torque\n1,2,3,4\n2,,4,4\n3,4,5,4\n", &MaterialOptions::default());
    for said in ["2 rows", "`torque` (not known here)", "1 line left out (3): no value of storage"] {
        assert!(file.understood.contains(said), "{said}\n{}", file.understood);
    }
}

/// Steps at two temperatures below a header, and an interval whose names stand behind a word.
#[test]
fn text_tables_of_rheometers_are_read() {
    let names = "Angular frequency\tStorage modulus\tLoss modulus\tTan(delta)\tTemperature\nrad/s\tPa\tPa\t\t°C\n";
    let steps = format!(
        "Filename\tmade up\n[step]\nFrequency sweep - 1\n{names}0.1\t100\t10\t0.1\t25.0\n1\t120\t15\t0.125\t25.1\n\
         [step]\nFrequency sweep - 2\n{names}0.1\t90\t9\t0.1\t35.0\n1\t105\t12\t0.114\t35.0\n"
    );
    let file = read(&steps, &MaterialOptions::default());
    assert!(file.understood.contains("taken for Young's moduli"), "{}", file.understood);
    let MaterialData::Isotherms(isotherms) = file.data else { panic!("{}", file.understood) };
    assert_eq!(isotherms.all().iter().map(|one| one.measurements.rows().len()).collect::<Vec<_>>(), [2, 2]);
    let interval = "Project:\tmade up\nInterval and data points:\t1\t2\n\
                    Interval data:\tPoint No.\tAngular Frequency\tStorage Modulus\tLoss Modulus\n\
                    \t\t[rad/s]\t[kPa]\t[kPa]\n\t1\t0.1\t1\t0.1\n\t2\t1\t1.2\t0.15\n";
    let said = MaterialOptions { is_shear: true, poisson_ratio: Some(0.5), ..MaterialOptions::default() };
    let file = read(interval, &said);
    assert!(!file.understood.contains("taken for Young's moduli"), "{}", file.understood);
    let MaterialData::Moduli(moduli) = file.data else { panic!("{}", file.understood) };
    assert_eq!(moduli.rows()[1].moduli().map(f64::round), [3600.0, 450.0]);
}

/// RepTate's own files: settings in the first line, then ω, G′ and G″ without names, and what else there is behind.
#[test]
fn files_of_reptate_have_their_columns_by_place() {
    let shear = MaterialOptions { poisson_ratio: Some(0.5), ..MaterialOptions::default() };
    let rows = oscillation(&rubber(), -2, 3);
    type Numbers = fn(f64, [f64; 2]) -> Vec<f64>;
    let plain: Numbers = |rate, [a, b]| vec![rate, a / 3.0, b / 3.0];
    let more: Numbers = |rate, [a, b]| vec![rate, a / 3.0, b / 3.0, -9.99, 0.0];
    for (name, above, numbers, separator) in [
        ("plain.tts", "T=-35;Mw=33.6;chem=PI;", plain, "\t"),
        ("more.TTS", "C1=8.7;T=25;isof=true;", more, "  "),
        ("commented.tts", "T=40;\n#\n# Frequency\tG' \tG\" of a star\t\t", plain, " "),
        ("named.tts", "Mw=634;T=25;\n#w  G'(w)  G\"(w) eta(w) T", more, " "),
    ] {
        let text = table(above, &rows, numbers).replace('\t', separator);
        let file = MaterialFile::of(Path::new(name), text.as_bytes(), &shear);
        let file = file.unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert!(file.understood.contains("a file of RepTate"), "{}", file.understood);
        let MaterialData::Moduli(found) = file.data else { panic!("{text}") };
        assert_near(&found, &rows, name);
    }
}

/// Names in German, with decimal commas.
#[test]
fn german_names_are_known() {
    let names = [
        "Kreisfrequenz (rad/s)\tSpeichermodul (Pa)\tVerlustmodul (Pa)",
        "Kreisfrequenz [1/s]\tSpeichermodul E' [Pa]\tVerlustfaktor",
    ];
    let rows = oscillation(&rubber(), -2, 3);
    for (place, names) in names.into_iter().enumerate() {
        let text = table(names, &rows, |rate, [a, b]| vec![rate, a, if place == 0 { b } else { b / a }]);
        assert_near(&moduli(&text.replace('.', ","), &MaterialOptions::default()), &rows, names);
    }
    let mut rows = decay(&rubber(), -6, 3);
    rows.reverse();
    let text = table("Zeit (s)\tRelaxationsmodul (Pa)", &rows, |rate, [modulus, _]| vec![1.0 / rate, modulus]);
    assert_near(&moduli(&text, &MaterialOptions::default()), &rows, "decay");
}

#[test]
fn shift_factors_are_read_in_two_forms() {
    let directory = tempdir().expect("a temporary directory");
    let path = directory.path().join("factors.csv");
    let factors = |text: &str| {
        std::fs::write(&path, text).expect("written");
        ShiftFactors::read(&path, &[]).map(|(factors, _)| factors)
    };
    let one = factors("\u{feff}T,log_aT\nC, -\n40,-2\n20,0\n0,3\n").expect("factors");
    let other = factors("temperature (K);a_T\n273,15;1000\n293,15;1\n313,15;0,01\n").expect("factors");
    assert_eq!(one, other);
    assert_eq!(one.reference(), Some(293.15));
    std::fs::write(&path, "theta,x,y\n40,7,-2\n20,7,0\n0,7,3\n").expect("written");
    let choices = ColumnChoice::list("temperature=theta (degC),log_shift_factor=#3").expect("choices");
    assert_eq!(ShiftFactors::read(&path, &choices).expect("chosen").0, one);
    for (text, said) in [
        ("T,b\nC,-\n0,1\n", "it has no shift factors"),
        ("T,log_aT\nC,-\n0,-2\n20,0\n", "some print its reciprocal"),
        ("T,aT\nC,-\n0,-2\n20,0\n", "a number above 0"),
        ("T,log_aT\n0,3\n20,0\n", "above 100 K; write the unit"),
    ] {
        let error = factors(text).expect_err("no factors").to_string();
        assert!(error.contains(said), "{error}");
    }
}

/// What materials are described with, to be strung together at random.
const PIECES: [&str; 34] = [
    "omega",
    "storage",
    "loss",
    "frequency",
    "T",
    "tau",
    "fraction",
    "modulus",
    "time",
    "E(t)",
    "G'",
    "|E*|",
    "delta",
    "*viscoelastic, time=prony",
    "*elastic",
    "tb,prony,1,1,2,shear",
    "tbdata,1",
    "mp,ex,1",
    "\n",
    "\n",
    "\n",
    "\t",
    ",",
    ",",
    ",",
    ";",
    "1",
    "2.5",
    "0,5",
    "-3",
    "1e9",
    "MPa",
    "nan",
    "# E0 = 1 MPa\n",
];

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(1000)
    })]

    /// A file is a material or refused with a reason, whatever is in it.
    #[test]
    fn any_file_is_judged(pieces in prop::collection::vec(prop::sample::select(PIECES.to_vec()), 0..40)) {
        let options = MaterialOptions { poisson_ratio: Some(0.5), ..MaterialOptions::default() };
        match MaterialFile::of(Path::new("any"), pieces.concat().as_bytes(), &options) {
            Ok(file) => match file.data {
                MaterialData::Series(series) => {
                    prop_assert!(series.terms.iter().all(|term| term.0 > 0.0 && term.1 > 0.0));
                }
                MaterialData::Moduli(moduli) => prop_assert!(moduli.rates().0 < moduli.rates().1),
                MaterialData::Isotherms(isotherms) => prop_assert!(!isotherms.all().is_empty()),
            },
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
    }
}
