//! Measured points: what is read of tables as people and instruments write them, and what is said of them.

use std::path::Path;

use stribeck_lab::{ColumnChoice, Measured, TableError};

/// The points in a text, and what was understood of it.
fn points(text: &str, columns: &str) -> Result<(Measured, String), String> {
    let choices = if columns.is_empty() { Vec::new() } else { ColumnChoice::list(columns)? };
    match Measured::of(Path::new("points.csv"), text.as_bytes(), &choices) {
        Ok((measured, understood)) => Ok((measured, understood.to_string())),
        Err(error) => Err(error.to_string()),
    }
}

fn read(text: &str) -> Result<Measured, String> {
    points(text, "").map(|(measured, _)| measured)
}

#[test]
fn points_are_read_in_si_units() {
    let text = "# friction of a gel\nspeed (mm/s), mu, error,load\n1,0.5,0.01,100\n\n2.5, 0.25, 0.02, 100\n";
    let found = read(text).expect("valid");
    assert_eq!(found.column, "mu_drag");
    assert_eq!(found.friction, [0.5, 0.25]);
    assert_eq!(found.errors.as_deref(), Some(&[0.01, 0.02][..]));
    assert_eq!(found.coordinate("speed"), Some(&[1e-3, 2.5e-3][..]));
    assert_eq!(found.coordinate("load"), Some(&[100.0, 100.0][..]));
    assert_eq!(found.coordinate("radius"), None);
    assert_eq!(found.places, [(0, 3), (0, 5)]);
}

#[test]
fn what_is_wrong_is_named_with_its_place() {
    for (text, expected) in [
        ("speed\n1\n", "points.csv: it has no column of friction; call it `mu`"),
        ("mu\n1\n", "points.csv: no column says where the points were measured; add `speed`, in m/s"),
        ("speed,mu\n", "points.csv: it has no points below its header"),
        ("speed,mu\n1,fast\n", "points.csv:2: mu = \"fast\" is not allowed: a friction coefficient is a number"),
        ("speed,mu\n0,1\n", "points.csv:2: speed = \"0\" is not allowed: it is a number above 0"),
        ("speed,mu\n1,nan\n", "points.csv:2: mu = \"nan\" is not allowed: a friction coefficient is a number"),
        ("speed,mu,error\n1,1,0\n", "points.csv:2: error = \"0\" is not allowed: a standard error is a number above 0"),
        (
            "speed,mu\n1,1,2\n",
            "points.csv: it is no table: line 2 has 3 values for 2 columns; commas that are decimal marks need another \
             separator, semicolons or tabs",
        ),
        ("speed,mu,mu_v\n1,1,1\n", "points.csv: it has two columns of friction; keep one (`mu_v`)"),
        (
            "speed,speed,mu\n1,1,1\n",
            "points.csv: it has two columns of speed, `speed` and `speed`; remove one, or choose with --columns \
             \"speed=#1\"",
        ),
        (
            "relaxed_modulus,instantaneous_modulus,mu\n1,1,1\n",
            "points.csv: it has a column twice, or both moduli; remove one (`instantaneous_modulus`)",
        ),
        ("speed (Pa),mu\n1,1\n", "points.csv: its column `speed (Pa)` is in Pa: a modulus, not a speed"),
        (
            "speed (parrot),mu\n1,1\n",
            "points.csv: its column `speed (parrot)` is in `parrot`, no unit that is known here; write (m/s), or a unit of \
             that kind",
        ),
        (
            "load (N),mu\n1,1\n",
            "points.csv: its column `load (N)` is in N: a force; a load is per length: divide it by the length of the \
             cylinder",
        ),
        ("speed,mu (N)\n1,1\n", "points.csv: its column `mu (N)` has no unit; leave it out"),
        (
            "speed;mu\n1;0,5\n2;0.5\n3;0,7\n",
            "points.csv:3: mu = \"0.5\" is not allowed: it has decimal points, and the table decimal commas; give all \
             numbers the same",
        ),
        (
            "gone,mu\n1,1\n",
            "points.csv: no column says where the points were measured; add `speed`, in m/s, or say which \
          of these it is, as in --columns \"speed=gone\": `gone` (not known here)",
        ),
    ] {
        assert_eq!(read(text).unwrap_err(), expected, "{text}");
    }
    let missing = Measured::read(Path::new("nowhere.csv"), &[]).unwrap_err();
    assert!(matches!(missing, TableError::Unreadable { .. }) && missing.to_string().contains("nowhere.csv"));
}
