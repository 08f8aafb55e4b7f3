//! Friction that was measured at several temperatures, fitted with the laws of the material and of the fluid.

use std::fs;
use std::path::Path;

use crate::program::{code, err, out, say};
use serde_json::Value;
use tempfile::tempdir;

const SHIFT: &str = "shift = { law = \"wlf\", c1 = 8.0, c2 = \"120 K\", reference = \"20 degC\" }\n";
/// The viscosity at 20 °C (Pa s), and the mean retardation time there (s).
const VISCOSITY: f64 = 0.2;
const TIME: f64 = 5e-3;
/// Standard errors over the friction.
const NOISE: f64 = 0.01;

/// An experiment with a viscosity and a time at 20 °C; without a temperature both have no law.
fn sweep(viscosity: f64, time: f64, has_temperature: bool) -> String {
    let (temperature, law, shift) = match has_temperature {
        true => (
            "temperature = [\"10 degC\", \"20 degC\", \"40 degC\"]\n",
            format!(
                "{{ law = \"vogel\", value = {viscosity}, b = \"900 K\", c = \"160 K\", reference = \"20 degC\" }}"
            ),
            SHIFT,
        ),
        false => ("", viscosity.to_string(), ""),
    };
    format!(
        "[laboratory]\nradius = \"10 mm\"\nload = \"400 N/m\"\nviscosity = {law}\n{temperature}\
         entrainment_speed = {{ from = \"5 mm/s\", to = \"0.5 m/s\", points = 6, scale = \"log\" }}\n\
         slide_roll_ratio = 1.0\n[flat]\nrelaxed_modulus = \"1 MPa\"\npoisson_ratio = 0.5\nf = 3.0\n\
         retardation_time = {time}\n{shift}"
    )
}

/// Writes the drag at each temperature with one percent of noise, and its standard error.
fn write_points(directory: &Path) {
    fs::write(directory.join("truth.toml"), sweep(VISCOSITY, TIME, true)).expect("written");
    let mut text = "Temp (°C);Rolling Speed (mm/s);COF;sd\n".to_owned();
    let noise = [0.3, -1.2, 0.8, 1.1, -0.5, -0.9, 1.4, 0.2, -1.6, 0.7, -0.1, 0.9, -0.8, 1.3, -0.4, 0.1, -1.0, 0.6];
    let mut noise = noise.into_iter();
    for celsius in [10, 20, 40] {
        let at = format!("temperature={celsius} degC");
        let said = say(directory, &["curve", "truth.toml", "--at", &at, "--csv", "curve.csv"]);
        assert_eq!(code(&said), 0, "{}", err(&said));
        let mut rows = csv::Reader::from_path(directory.join("curve.csv")).expect("a table");
        let place = |name: &str| rows.headers().expect("names").iter().position(|it| it == name).expect(name);
        let [speed, drag] = ["entrainment_speed", "mu_drag"].map(place);
        for row in rows.records().map(|row| row.expect("a row")) {
            let number = |place: usize| row[place].parse::<f64>().expect("a number");
            let measured = number(drag) * (1.0 + NOISE * noise.next().expect("one for each point"));
            text += &format!("{celsius};{:.4};{measured:.6};{:.6}\n", 1e3 * number(speed), NOISE * number(drag));
        }
    }
    fs::write(directory.join("points.csv"), text).expect("written");
}

fn fit(directory: &Path, start: &str) -> (Value, String) {
    fs::write(directory.join("start.toml"), start).expect("written");
    let unknown = "viscosity,retardation_time";
    let said = say(directory, &["fit", "points.csv", "start.toml", "--unknown", unknown, "--profile", "--json"]);
    assert_eq!(code(&said), 0, "{}", err(&said));
    (serde_json::from_str(&out(&said)).expect("JSON"), err(&said))
}

/// Viscosity and time at the reference come back within their errors from points at three temperatures; without the
/// laws nothing fits them, and a note says that temperatures are mixed.
#[test]
fn laws_of_temperature_bring_points_together() {
    let directory = tempdir().expect("a temporary directory");
    write_points(directory.path());
    let (found, said) = fit(directory.path(), &sweep(0.4, 2e-3, true));
    assert!(said.contains("as temperature, in °C") && !said.contains("note: the points are from"), "{said}");
    for (place, truth) in [VISCOSITY, TIME].into_iter().enumerate() {
        let number = |key: &str| found["estimates"][place][key].as_f64().unwrap_or_else(|| panic!("{key} in {found}"));
        let (value, error) = (number("value"), number("standard_error"));
        assert!((value - truth).abs() < 2.0 * error && error < 0.03 * truth, "{value} ± {error}, not {truth}");
    }
    let chi_squared = |found: &Value| found["reduced_chi_squared"].as_f64().expect("a number");
    assert!((0.3..2.0).contains(&chi_squared(&found)), "{found}");
    let (mixed, said) = fit(directory.path(), &sweep(0.2, 5e-3, false));
    assert!(said.contains("note: the points are from 10.0 to 40.0 degC, and the sweep has no temperature"), "{said}");
    assert!(chi_squared(&mixed) > 20.0, "{mixed}");
}
