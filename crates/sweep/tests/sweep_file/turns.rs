//! Speeds of the cylinder in turns: by the radius they are those in m/s.

use crate::bad_sweeps::with_laboratory;
use std::f64::consts::TAU;
use stribeck_lab::LaboratoryQuantity;
use stribeck_sweep::{Grid, Sweep};

/// The values of a quantity of a sweep.
fn values(text: &str, quantity: LaboratoryQuantity) -> Vec<f64> {
    let Grid::Laboratory(axes) = Sweep::parse("turns", text).unwrap_or_else(|error| panic!("{error}")).grid else {
        panic!("quantities of the laboratory");
    };
    axes.given.into_iter().find(|given| given.quantity == quantity).expect("it is given").values
}

/// A cylinder of 2 mm that turns n times a minute moves at 2 mm times 2πn/60 a second, however that is written.
#[test]
fn turns_are_speeds_by_the_radius() {
    let second = 0.002 * TAU;
    for (radius, speed, expected) in [
        ("0.002", "\"60 rpm\"", vec![second]),
        ("\"2 mm\"", "[\"6 U/min\", \"60 1/min\"]", vec![0.1 * second, second]),
        (
            "[\"2 mm\"]",
            "{ from = \"0,6 rpm\", to = \"60 rpm\", points = 3, scale = \"log\" }",
            vec![0.01 * second, 0.1 * second, second],
        ),
        ("0.002", "[\"1 mm/s\", \"1 rad/s\"]", vec![0.001, 0.002]),
    ] {
        let text = with_laboratory("radius", radius).replace("[0.01, 0.1]", speed);
        let found = values(&text, LaboratoryQuantity::Speed);
        assert_eq!(found.len(), expected.len());
        assert!(found.iter().zip(&expected).all(|(found, of)| (found / of - 1.0).abs() < 1e-14), "{speed}: {found:?}");
    }
    let surfaces = with_laboratory("speed", "V").replace("speed = V", "roller_speed = \"60 rpm\"\nflat_speed = 0.1");
    assert!((values(&surfaces, LaboratoryQuantity::RollerSpeed)[0] / second - 1.0).abs() < 1e-14);
}
