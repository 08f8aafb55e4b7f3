//! Temperature in sweeps: it shifts the times of each body and the viscosity by their own laws.

use stribeck_lab::LaboratoryQuantity;
use stribeck_sweep::{Grid, Sweep};

fn parse(temperature: &str, viscosity: &str, bodies: &str) -> Result<Sweep, String> {
    let text = format!(
        "[laboratory]\nradius = 0.01\nload = 400.0\nspeed = [0.01, 0.1]\n{temperature}viscosity = {viscosity}\n{bodies}"
    );
    Sweep::parse("temperature", &text).map_err(|error| format!("{error}; {}", error.remedy()))
}

/// α and β of every place.
fn numbers(sweep: &Sweep) -> Vec<[f64; 2]> {
    let shape = sweep.grid.shape();
    let of_place = |place| {
        let [_, alpha, beta] = sweep.grid.numbers(shape.index(place));
        [alpha, beta]
    };
    (0..shape.places()).map(of_place).collect()
}

const BODY: &str = "relaxed_modulus = 1e6\npoisson_ratio = 0.5\nrelaxation = [{ fraction = 0.5, time = 0.01 }]\n";

/// A place at another temperature is one at the reference with the times and the viscosity that the laws say.
#[test]
fn a_temperature_is_other_times_and_another_viscosity() {
    let shift = "shift = { law = \"wlf\", c1 = 10.0, c2 = \"80 K\", reference = \"20 degC\" }\n";
    let law =
        "{ law = \"arrhenius\", value = \"0.2 Pa s\", activation_energy = \"40 kJ/mol\", reference = \"20 degC\" }";
    let flat = format!("[flat]\n{BODY}{shift}");
    let sweep = parse("temperature = [\"20 degC\", \"50 degC\"]\n", law, &flat).expect("valid");
    let dimensions: Vec<String> = sweep.grid.dimensions().into_iter().map(|it| it.name).collect();
    assert_eq!(dimensions, ["f", "temperature", "speed"]);
    let found = numbers(&sweep);
    let at_reference = numbers(&parse("", "0.2", &flat).expect("valid"));
    // 30 K above the reference
    let time = 10_f64.powf(-10.0 * 30.0 / 110.0);
    let viscosity = (4e4 / 8.314462618 * (1.0 / 323.15 - 1.0 / 293.15_f64)).exp();
    for (place, reference) in at_reference.iter().enumerate() {
        assert_eq!(found[place], *reference);
        let warm = found[place + 2];
        assert!((warm[0] / (reference[0] / time) - 1.0).abs() < 1e-12, "{warm:?} {reference:?}");
        assert!((warm[1] / (reference[1] / viscosity) - 1.0).abs() < 1e-12, "{warm:?} {reference:?}");
    }
}

/// What is published at a temperature is what α and β are made of, and what is given is called that of the reference.
#[test]
fn published_times_and_viscosities_are_those_of_the_temperature() {
    let shift = "shift = { law = \"wlf\", c1 = 10.0, c2 = \"80 K\", reference = \"20 degC\" }\n";
    let law =
        "{ law = \"arrhenius\", value = \"0.2 Pa s\", activation_energy = \"40 kJ/mol\", reference = \"20 degC\" }";
    let sweep = parse("temperature = \"50 degC\"\n", law, &format!("[flat]\n{BODY}{shift}")).expect("valid");
    let Grid::Laboratory(axes) = &sweep.grid else { panic!("it has quantities of the laboratory") };
    let experiment = axes.experiment(sweep.grid.shape().index(0));
    let number = |wanted: &str| {
        let mut all = experiment.variables();
        all.find(|((name, ..), _)| *name == wanted).unwrap_or_else(|| panic!("{wanted}")).1
    };
    let (a0, radius, speed) = (number("a0"), experiment.radius, 0.01);
    let alpha = a0 / (speed * number("retardation_time_at_temperature"));
    let beta = experiment.plane_strain_modulus() * a0.powi(4)
        / (12.0 * number("viscosity_at_temperature") * speed * radius.powi(3));
    assert!((alpha / experiment.alpha() - 1.0).abs() < 1e-12 && (beta / experiment.beta() - 1.0).abs() < 1e-12);
    for quantity in [LaboratoryQuantity::Viscosity, LaboratoryQuantity::RetardationTime] {
        assert!(experiment.long_name(quantity).contains("at the reference temperature"));
    }
    let plain = parse("", "0.2", &format!("[flat]\n{BODY}")).expect("valid");
    let plain = plain.grid.experiment(plain.grid.shape().index(0)).expect("of the laboratory");
    assert_eq!(plain.variables().count(), 4);
}

/// Each body has a law of its own: what warms the roller alone changes its modes and not those of the flat.
#[test]
fn the_roller_has_a_law_of_its_own() {
    let shift = "shift = { law = \"arrhenius\", activation_energy = 8e4, reference = \"293.15 K\" }\n";
    let bodies = format!("[flat]\n{BODY}[roller]\n{BODY}{shift}");
    let speeds = |temperature: &str| {
        let sweep = parse(temperature, "0.2", &bodies).expect("valid");
        let index = sweep.grid.shape().index(0);
        let Grid::Laboratory(axes) = &sweep.grid else { panic!("it has quantities of the laboratory") };
        let mut experiment = axes.experiment(index);
        experiment.motion = stribeck_lab::Motion::Rolling { entrainment_speed: 0.01, slide_roll_ratio: 0.0 };
        experiment.parameters_of_both(&sweep.substrate, &axes.roller_spectrum)
    };
    let (cold, warm) = (speeds("temperature = \"293.15 K\"\n"), speeds("temperature = \"313.15 K\"\n"));
    assert_eq!((cold.alpha, cold.beta, cold.f), (warm.alpha, warm.beta, warm.f));
    let time = (8e4 / 8.314462618 * (1.0 / 313.15 - 1.0 / 293.15_f64)).exp();
    let times = [&cold, &warm].map(|case| case.substrate.modes().iter().map(|mode| mode.time).collect::<Vec<_>>());
    assert_eq!(times[0][0], times[1][0]);
    assert!((times[1][1] / times[0][1] / time - 1.0).abs() < 1e-12, "{times:?}");
}

/// A table of viscosities is taken between its ends, and refused beyond.
#[test]
fn what_a_law_does_not_know_is_refused() {
    let flat = format!("[flat]\n{BODY}");
    let table =
        "{ table = [{ temperature = \"40 degC\", value = 0.1 }, { temperature = \"100 degC\", value = 0.01 }] }";
    let at = |temperature: &str| parse(&format!("temperature = {temperature}\n"), table, &flat);
    let warm = numbers(&at("\"100 degC\"").expect("at the end of the table"));
    let plain = numbers(&parse("", "0.01", &flat).expect("valid"));
    assert!((warm[0][1] / plain[0][1] - 1.0).abs() < 1e-12);
    for (temperature, words) in [
        ("\"101 degC\"", "no value at 374.15 K"),
        ("20.0", "from 100 K to 2000 K"),
        ("\"20\"", "must be a temperature, a number with a unit"),
        ("\"20 m\"", "must be a temperature, in K or a unit of that kind"),
    ] {
        let error = at(temperature).expect_err(temperature);
        assert!(error.contains(words), "{error}");
    }
    let error = parse("temperature = \"20 degC\"\n", "0.1", &flat).expect_err("no law");
    assert!(error.contains("nothing changes with `laboratory.temperature`"), "{error}");
    for (law, words) in [
        ("{ law = \"vogel\", value = 0.1, b = 900.0, c = \"320 K\", reference = \"20 degC\" }", "below the reference"),
        (
            "{ law = \"vogel\", value = 0.1, activation_energy = 1.0, reference = \"20 degC\" }",
            "belongs to another law",
        ),
        ("{ law = \"arrhenius\", value = 0.1, activation_energy = \"3 K\", reference = \"20 degC\" }", "an energy"),
        ("{ table = [{ temperature = \"40 degC\", value = 0.1 }] }", "a table of viscosities has 2 to 12"),
    ] {
        let error = parse("temperature = \"20 degC\"\n", law, &flat).expect_err(law);
        assert!(error.contains(words), "{error}");
    }
}
