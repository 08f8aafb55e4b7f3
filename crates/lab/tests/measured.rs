//! Measured points: what is read of tables as people and instruments write them, and what is said of them.

use std::path::Path;

use stribeck_lab::{ColumnChoice, Measured, TableError};

/// The points in a text, and what was understood of it.
fn points(text: &str, columns: &str) -> Result<(Measured, String), String> {
    let choices = if columns.is_empty() { Vec::new() } else { ColumnChoice::list(columns)? };
    match Measured::of(Path::new("points.csv"), text.as_bytes(), &choices, None) {
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

/// What a hint suggests is the column that may hold the quantity, by its unit and name, and not the first one.
#[test]
fn hints_name_the_column_that_may_be_meant() {
    for (header, expected) in [
        ("Time (s),V (mm/s),Traction (-)", "--columns \"speed=V (mm/s)\""),
        ("Time (s),Force ratio,V (mm/s)", "--columns \"mu=NAME\""),
        ("Time (s),Load cell (N),V (mm/s),mu", "--columns \"speed=V (mm/s)\""),
    ] {
        let row = vec!["1"; header.split(',').count()].join(",");
        let said = read(&format!("{header}\n{row}\n")).expect_err(header);
        assert!(said.contains(expected), "{header}: {said}");
    }
}

/// Speeds whose unit nobody named are known as such.
#[test]
fn columns_without_a_unit_are_remembered() {
    let of = |text: &str| read(text).expect("valid").without_unit;
    assert_eq!(of("speed,load (N/m),mu\n1,2,0.5\n"), [("speed", "speed".to_owned())]);
    assert_eq!(of("speed (mm/s),mu\n1,0.5\n"), []);
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
            "points.csv: its column `speed (parrot)` is in `parrot`, no unit that is known here; write (m/s or rad/s), or a unit of \
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
    let missing = Measured::read(Path::new("nowhere.csv"), &[], None).unwrap_err();
    assert!(matches!(missing, TableError::Unreadable { .. }) && missing.to_string().contains("nowhere.csv"));
}

/// Exports of a machine: two steps of readings, rolling and sliding, in the tests' own numbers.
#[test]
fn steps_of_readings_are_points_with_their_errors() {
    let bytes = include_bytes!("findings/table/steps-of-readings.txt");
    let (found, understood) = Measured::of(Path::new("steps.txt"), bytes, &[], None).expect("steps");
    assert_eq!(found.friction.len(), 2);
    // 0.1, 0.101 and 0.099 scatter by 1 %, 0.2 ± 0.001 by 0.5 %: together by √((1² + 0.5²)/2) %
    assert!((found.friction[0] - 0.1).abs() < 1e-15 && (found.friction[1] - 0.2).abs() < 1e-15);
    let errors = found.errors.as_ref().expect("they scatter");
    let of_mean = 0.01 * 0.625_f64.sqrt() / 3.0_f64.sqrt();
    assert!((errors[0] / (0.1 * of_mean) - 1.0).abs() < 1e-9, "{errors:?}");
    assert!((errors[1] / (0.2 * of_mean) - 1.0).abs() < 1e-9, "{errors:?}");
    let near = |name: &str, expected: [f64; 2]| {
        let values = found.coordinate(name).unwrap_or_else(|| panic!("{name}"));
        assert!(
            values.iter().zip(expected).all(|(value, expected)| (value / expected - 1.0).abs() < 1e-9),
            "{values:?}"
        );
    };
    near("entrainment_speed", [0.2002, 0.1002]);
    near("slide_roll_ratio", [0.502, 0.502]);
    near("temperature", [294.35, 294.35]);
    assert_eq!(found.coordinates.len(), 3);
    let said = understood.to_string();
    for words in [
        "separated by tabs, decimal points; 6 rows",
        "`SRR (%)` as slide_roll_ratio, in %",
        "`Ball Load (N)` (is in N: a force; a load is per length",
        "`Sliding Speed (mm/s)` (follows from the entrainment speed and the slide-to-roll ratio)",
        "`Traction Coeff (-)` (the same numbers as in column 2)",
        "2 steps; 2 points",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
}

/// What stands for what, with or without a unit that the file gives.
#[test]
fn names_of_the_field_are_known() {
    let text = "COF (-);Rolling Speed [mm/s];Sliding speed (mm/s);Std. Dev.;Normal load (mN/mm);operator\n\
                0,1;200;100;0,01;3;x\n0,2;100;-50;0,01;3;y\n";
    let (found, said) = points(text, "").expect("a table");
    assert_eq!((found.column, &found.friction[..]), ("mu_drag", &[0.1, 0.2][..]));
    assert_eq!(found.errors.as_deref(), Some(&[0.01, 0.01][..]));
    assert_eq!(found.coordinate("entrainment_speed"), Some(&[0.2, 0.1][..]));
    assert_eq!(found.coordinate("slide_roll_ratio"), Some(&[0.5, -0.5][..]));
    assert_eq!(found.coordinate("load"), Some(&[3.0, 3.0][..]));
    assert!(said.contains("semicolons, decimal commas; 2 rows") && said.contains("left out: `operator`"), "{said}");
}

/// What names do not tell is said by choices; what is not there is told with what there is.
#[test]
fn choices_say_what_columns_hold() {
    let text = "My V (mm/s),F,a,F\n1,0.5,2,9\n2,0.4,3,9\n";
    let (found, _) = points("My V (mm/s),F\n1,0.5\n2,0.4\n", "speed=My V (mm/s),mu=F").expect("chosen");
    assert_eq!((found.coordinate("speed"), &found.friction[..]), (Some(&[1e-3, 2e-3][..]), &[0.5, 0.4][..]));
    let (found, _) = points("V,F\n1,0.5\n2,0.4\n", "speed=V (mm/s),mu_v=#2").expect("chosen");
    assert_eq!((found.coordinate("speed"), found.column), (Some(&[1e-3, 2e-3][..]), "mu_v"));
    let (found, _) = points("speed,mu,mu_v\n1,0.5,0.3\n", "mu_v=mu_v").expect("chosen");
    assert_eq!((found.column, &found.friction[..]), ("mu_v", &[0.3][..]));
    for (text, columns, expected) in [
        (text, "speed=V,mu=G", "there is no column V, but `My V (mm/s)`, `F`, `a`, `F`"),
        ("V,F\n1,2\n", "velocities=V", "--columns velocities=…: there are mu, mu_drag"),
        ("V,F\n1,2\n", "speed=#3,mu=F", "there is no column #3"),
        ("V (N),F\n1,2\n", "speed=V,mu=F", "its column `V (N)` is in N: a force, not a speed"),
        ("V,F\n1,2\n", "speed", "write quantity=column"),
    ] {
        let error = points(text, columns).unwrap_err();
        assert!(error.contains(expected), "{columns}: {error}");
    }
}

/// What the program writes is read back: drag of converged cases, where it was computed.
#[test]
fn results_of_the_program_are_measured_points() {
    let text = "case,f,alpha,beta,status,reason,mu_v,mu_h,mu_drag,error_mu_v\n\
                a,1,2,10,converged,,0.1,0.2,0.35,1e-6\nb,1,2,20,failed,no film,,,,\nc,1,2,30,converged,,0.1,0.2,0.3,1e-6\n";
    let (found, said) = points(text, "").expect("a summary");
    assert_eq!((found.column, &found.friction[..], found.is_computed), ("mu_drag", &[0.35, 0.3][..], true));
    assert_eq!(found.coordinate("beta"), Some(&[10.0, 30.0][..]));
    assert!(said.contains("1 line left out (3): no value of mu_drag"), "{said}");
    let curve = "status,reason,f,alpha,beta,radius,speed,mu_v,mu_drag\nconverged,,1,2,10,0.01,0.1,0.1,0.35\n";
    let (found, _) = points(curve, "").expect("a curve");
    assert_eq!((found.coordinate("alpha"), found.coordinate("speed")), (None, Some(&[0.1][..])));
    let fit = "line,radius,speed,f,alpha,beta,measured,error,fitted,residual\n2,0.01,0.1,1,2,3,0.5,0.01,0.51,1\n";
    let (found, _) = points(fit, "").expect("a fit");
    assert_eq!((&found.friction[..], found.errors.as_deref()), (&[0.5][..], Some(&[0.01][..])));
}

/// Readings at one place are one point where all places have three, and none has an error of its own.
#[test]
fn repeated_readings_are_one_point() {
    let rows: String = (0..30).map(|i| format!("{},{}\n", 1 + i % 3, 0.5 + 0.01 * f64::from(i / 3))).collect();
    let (found, said) = points(&format!("speed,mu\n{rows}"), "").expect("readings");
    assert_eq!((found.coordinate("speed"), found.friction.len()), (Some(&[1.0, 2.0, 3.0][..]), 3));
    // the scatter of ten equidistant numbers h apart is h √(n(n + 1)/12)
    let expected = 0.01 * (10.0_f64 * 11.0 / 12.0).sqrt() / 10.0_f64.sqrt();
    assert!(found.errors.expect("they scatter").iter().all(|error| (error / expected - 1.0).abs() < 1e-9));
    assert!(said.contains("30 readings at 3 places"), "{said}");
    assert_eq!(read(&format!("speed,mu\n{rows}9,0.5\n")).expect("one is alone").friction.len(), 31);
    assert_eq!(read("speed,mu\n1,0.5\n1,0.5\n1,0.5\n").expect("none scatters").errors, None);
    let with_errors: String = rows.lines().map(|row| format!("{row},0.1\n")).collect();
    assert_eq!(read(&format!("speed,mu,error\n{with_errors}")).expect("readings").friction.len(), 30);
}

/// Readings at 20 and at 24 °C by thermostats that waver are two places, and so are those at 20 and 60 °C; where few
/// readings drift by some kelvins they are one.
#[test]
fn temperatures_that_step_are_places_of_their_own() {
    let places = |celsius: &[f64]| {
        let row = |(i, celsius): (usize, &f64)| format!("{celsius},1,{}\n", 0.5 + 0.01 * (i % 3) as f64);
        let rows: String = celsius.iter().enumerate().map(row).collect();
        let found = read(&format!("temperature (degC),speed,mu\n{rows}")).expect("readings");
        found.coordinate("temperature").expect("a column").iter().map(|it| (it - 273.15).round()).collect::<Vec<_>>()
    };
    assert_eq!(places(&[20.1, 24.2, 19.9, 24.0, 20.0, 23.8]), [20.0, 24.0]);
    assert_eq!(places(&[59.4, 60.1, 60.4, 20.0, 20.4, 19.6]), [60.0, 20.0]);
    assert_eq!(places(&[20.0, 21.5, 23.0, 24.5]), [22.0]);
    assert_eq!(places(&[20.0, 21.5, 23.0, 24.5, 60.0]).len(), 5);
}

#[test]
fn files_are_joined_where_they_hold_the_same() {
    let part = |name: &str, text: &str| Measured::of(Path::new(name), text.as_bytes(), &[], None).expect("points").0;
    let [one, two] = [part("a.csv", "speed,mu\n1,0.5\n"), part("b.csv", "mu;speed (mm/s)\n0,4;3\n")];
    let whole = Measured::join([one.clone(), two]).expect("alike");
    assert_eq!((whole.coordinate("speed"), &whole.friction[..]), (Some(&[1.0, 3e-3][..]), &[0.5, 0.4][..]));
    assert_eq!((whole.place(0), whole.place(1)), ("line 2 of a.csv".to_owned(), "line 2 of b.csv".to_owned()));
    for (text, expected) in [
        ("speed,load,mu\n1,2,0.5\n", "a.csv and b.csv have other columns (speed; speed, load)"),
        ("speed,mu,error\n1,0.5,0.1\n", "have standard errors in one of them alone"),
        ("speed,mu_v\n1,0.5\n", "hold mu_drag and mu_v"),
    ] {
        let error = Measured::join([one.clone(), part("b.csv", text)]).unwrap_err();
        assert!(error.contains(expected), "{error}");
    }
}

/// The first sheet with a table is read, below its title and right of an empty column.
#[test]
fn a_workbook_is_read_as_a_table() {
    let bytes = include_bytes!("findings/table/two-sheets.xlsx");
    let (found, said) = Measured::of(Path::new("a.xlsx"), bytes, &[], None).expect("a workbook");
    assert_eq!((found.coordinate("speed"), &found.friction[..]), (Some(&[1e-3, 2.5e-3][..]), &[0.5, 0.25][..]));
    assert_eq!(found.places, [(0, 4), (0, 5)]);
    assert!(said.to_string().starts_with("a.xlsx: workbook, sheet Friction; 2 rows\n"), "{said}");
    assert!(!said.to_string().contains("not read"), "{said}");
    // those behind it are named, but for empty ones
    let bytes = include_bytes!("findings/table/sheets-behind.xlsx");
    let (found, said) = Measured::of(Path::new("a.xlsx"), bytes, &[], None).expect("a workbook");
    assert_eq!(found.friction, [0.5, 0.25]);
    assert!(
        said.to_string().contains("sheet 20 °C; 2 rows") && said.to_string().contains("not read: 40 °C; "),
        "{said}"
    );
    for (bytes, expected) in [(&b"PK\x03\x04 no archive"[..], "no workbook"), (b"\xd0\xcf\x11\xe0", "of the old kind")]
    {
        let error = Measured::of(Path::new("a.xlsx"), bytes, &[], None).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
}

/// A cylinder of 10 mm that turns sixty times a minute moves at 2π cm/s; whose radius it is must be known.
#[test]
fn turns_are_speeds_by_the_radius() {
    use std::f64::consts::TAU;
    let of = |text: &str, radius: Option<f64>| Measured::of(Path::new("a.csv"), text.as_bytes(), &[], radius);
    let speeds = |text: &str, radius: Option<f64>, name: &str| {
        let (points, said) = of(text, radius).unwrap_or_else(|error| panic!("{error}"));
        (points.coordinate(name).expect(name).to_vec(), said.to_string())
    };
    for (text, name) in [
        ("speed (rpm),mu\n60,0.5\n", "speed"),
        ("Geschwindigkeit [U/min];Reibwert\n60;0,5\n", "speed"),
        ("speed (1/min),mu\n60,0.5\n", "speed"),
        ("speed (rad/s),mu\n6.283185307179586,0.5\n", "speed"),
        ("roller_speed (rpm),flat_speed,mu\n60,0.1,0.5\n", "roller_speed"),
    ] {
        let (found, said) = speeds(text, Some(0.01), name);
        assert!((found[0] / (0.01 * TAU) - 1.0).abs() < 1e-14, "{text}: {found:?}");
        assert!(said.contains("speeds in turns are multiplied by 0.01 m, the radius of the cylinder"), "{said}");
        let error = of(text, None).unwrap_err().to_string();
        assert!(
            error.contains("is in turns, not a speed") && error.contains("give [laboratory] one radius"),
            "{error}"
        );
    }
    // a radius in the file goes before the other one
    let (found, _) = speeds("radius (mm),speed (rpm),mu\n10,60,0.5\n20,60,0.4\n", Some(1.0), "speed");
    assert!((found[0] / (0.01 * TAU) - 1.0).abs() < 1e-14 && (found[1] / found[0] - 2.0).abs() < 1e-14, "{found:?}");
    // turns of a flat, or of both, are about another axis
    for name in ["flat_speed", "entrainment_speed"] {
        let error = of(&format!("{name} (rpm),slide_roll_ratio,mu\n60,1,0.5\n"), Some(0.01)).unwrap_err().to_string();
        assert!(error.contains("turns, not a speed"), "{error}");
    }
}

/// What German instruments and people write.
#[test]
fn german_names_are_known() {
    let text = "Geschwindigkeit (mm/s);Schlupf (%);Linienlast (N/mm);Temperatur (°C);Reibungszahl;Standardabweichung\n\
                10;100;0,5;20;0,25;0,01\n";
    let (points, said) = Measured::of(Path::new("a.csv"), text.as_bytes(), &[], None).expect("points");
    let at = |name: &str| points.coordinate(name).unwrap_or_else(|| panic!("{name}\n{said}"))[0];
    let found = ["speed", "slide_roll_ratio", "load", "temperature"].map(at);
    assert_eq!((found, points.friction[0]), ([0.01, 1.0, 500.0, 293.15], 0.25));
    assert_eq!(points.errors.as_deref(), Some(&[0.01][..]));
    let text = "Gleitgeschwindigkeit [m/s]\tNormalkraft [N]\tReibwert\n0,1\t20\t0,3\n";
    let (points, said) = Measured::of(Path::new("a.csv"), text.as_bytes(), &[], None).expect("points");
    assert_eq!((points.coordinate("speed"), &points.friction[..]), (Some(&[0.1][..]), &[0.3][..]));
    assert!(said.to_string().contains("a force; a load is per length"), "{said}");
}
