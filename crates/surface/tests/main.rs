//! Laws of surfaces: known functions come back, with their derivatives, and whatever is wrong is refused.

use stribeck_surface::{
    Axis, Certificate, CheckPoint, FORMAT, NumberKind, Outside, QuantityRecord, Spread, Surface, SurfaceError,
    SurfaceFile, Transform, encode,
};

fn axis(name: &str, spread: Spread, from: f64, to: f64) -> Axis {
    Axis { name: name.into(), units: "1".into(), long_name: name.into(), spread, from, to }
}

/// A quantity whose series is a sum of two products of polynomials of one axis each.
fn quantity(name: &str, transform: Transform, degrees: [usize; 3], number: fn(usize) -> f64) -> QuantityRecord {
    let encoded = |count: usize, first: usize| {
        let numbers: Vec<f64> = (first..first + count).map(number).collect();
        encode(NumberKind::Float64, &numbers)
    };
    QuantityRecord {
        name: name.into(),
        units: "1".into(),
        scale: Some("a0/R".into()),
        long_name: name.into(),
        transform,
        shape: degrees.map(|degrees| [degrees, 2]).to_vec(),
        numbers: NumberKind::Float64,
        factors: degrees.iter().enumerate().map(|(place, degrees)| encoded(2 * degrees, 100 * place)).collect(),
        core: encoded(8, 500),
    }
}

fn number(place: usize) -> f64 {
    0.3 * (place as f64 * 0.7).sin()
}

fn file() -> SurfaceFile {
    let part = Transform::Sinh { of: "drag".into(), share: 1e-3 };
    SurfaceFile {
        format: FORMAT.into(),
        title: "made up".into(),
        program: "a test".into(),
        results_version: 1,
        tolerance: 1e-4,
        axes: vec![
            axis("alpha", Spread::Compact { center: 0.01 }, 0.0, f64::INFINITY),
            axis("beta", Spread::Log, 1.0, 1e8),
            axis("f", Spread::Compact { center: 1.0 }, 0.0, 1e4),
        ],
        quantities: vec![
            quantity("drag", Transform::Exp, [9, 6, 4], number),
            quantity("mu_v", part, [7, 5, 6], number),
            quantity("x", Transform::Identity, [3, 2, 5], number),
            quantity("loss", Transform::Root { of: "drag".into(), share: 1e-3, offset: 0.04 }, [5, 8, 3], number),
        ],
        certificate: Certificate { points: 0, seed: 0, solver_tolerance: 1e-6, cases: 0, errors: Vec::new() },
        checks: Vec::new(),
        sweep: String::new(),
    }
}

const POINTS: [[f64; 3]; 6] = [
    [0.5, 100.0, 10.0],
    [1e-7, 3.0, 9e3],
    [1e9, 7e7, 0.01],
    [0.0, 1.0, 0.0],
    [f64::INFINITY, 1e8, 1e4],
    [0.01, 2.0, 1.0],
];

/// The series as the sum that it stands for, by cosines: no recurrence, no order of contraction.
fn direct(record: &QuantityRecord, axes: &[Axis], point: &[f64]) -> f64 {
    let numbers = |text: &str| -> Vec<f64> {
        use base64::Engine;
        let bytes = base64::engine::general_purpose::STANDARD.decode(text).expect("base64");
        bytes.chunks(8).map(|bytes| f64::from_le_bytes(bytes.try_into().expect("eight"))).collect()
    };
    let core = numbers(&record.core);
    let weights: Vec<Vec<f64>> = (0..3)
        .map(|m| {
            let angle = axes[m].forward(point[m]).acos();
            let factor = numbers(&record.factors[m]);
            (0..2)
                .map(|r| factor.chunks(2).enumerate().map(|(k, row)| row[r] * (k as f64 * angle).cos()).sum())
                .collect()
        })
        .collect();
    let terms = (0..8).map(|i| core[i] * weights[0][i / 4] * weights[1][i / 2 % 2] * weights[2][i % 2]);
    terms.sum()
}

#[test]
fn values_are_the_sums_that_the_file_says() {
    let file = file();
    let surface = Surface::new(file.clone()).expect("valid");
    let mut evaluator = surface.evaluator();
    for point in POINTS {
        let [drag, mu_v, x, loss] = [0, 1, 2, 3].map(|q| direct(&file.quantities[q], &file.axes, &point));
        let part = |y: f64| 1e-3 * drag.exp() * y;
        let expected = [drag.exp(), part(mu_v.sinh()), x, part(((loss / 2.0).exp() - 0.8).powi(2) - 0.04)];
        let values = evaluator.values(&point).expect("inside");
        for (value, expected) in values.iter().zip(expected) {
            assert!((value - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{point:?}: {value} {expected}");
        }
        let values = values.to_vec();
        assert_eq!(evaluator.derivatives(&point).expect("inside").0, values);
    }
}

#[test]
fn derivatives_are_limits_of_differences() {
    let surface = Surface::new(file()).expect("valid");
    let mut evaluator = surface.evaluator();
    for point in [POINTS[0], POINTS[1], POINTS[2], POINTS[5]] {
        let (_, derivatives) = evaluator.derivatives(&point).expect("inside");
        let derivatives = derivatives.to_vec();
        for axis in 0..3 {
            let step = 1e-5 * point[axis];
            let mut at = |by: f64| {
                let mut point = point;
                point[axis] += by;
                evaluator.values(&point).expect("inside").to_vec()
            };
            let (far_below, below, above, far_above) = (at(-2.0 * step), at(-step), at(step), at(2.0 * step));
            for q in 0..4 {
                let difference = (8.0 * (above[q] - below[q]) - (far_above[q] - far_below[q])) / (12.0 * step);
                let derivative = derivatives[q * 3 + axis];
                let scale = derivative.abs().max(1e-5 * above[q].abs() / step * 1e-5);
                assert!(
                    (derivative - difference).abs() < 1e-6 * scale + 1e-10 * above[q].abs() / step,
                    "{point:?} {axis} {q}"
                );
            }
        }
    }
    let (_, at_zero) = evaluator.derivatives(&POINTS[3]).expect("inside");
    assert!(at_zero[0].is_nan() && at_zero[1].is_finite(), "dmu/dalpha at alpha = 0 is not known");
    let (_, at_infinity) = evaluator.derivatives(&POINTS[4]).expect("inside");
    assert_eq!(at_infinity[0], 0.0);
}

#[test]
fn a_line_is_the_surface_with_the_other_coordinates_fixed() {
    let surface = Surface::new(file()).expect("valid");
    let mut evaluator = surface.evaluator();
    for point in POINTS {
        for axis in 0..3 {
            let mut line = evaluator.line(axis, &point).expect("inside");
            let along = line.values(point[axis]).expect("inside").to_vec();
            let values = evaluator.values(&point).expect("inside");
            for (along, value) in along.iter().zip(values) {
                assert!((along - value).abs() <= 1e-13 * (1.0 + value.abs()));
            }
        }
    }
}

#[test]
fn a_point_takes_no_memory() {
    let surface = Surface::new(file()).expect("valid");
    let mut evaluator = surface.evaluator();
    let mut line = evaluator.line(1, &POINTS[0]).expect("inside");
    let used = allocation_counter::measure(|| {
        for point in POINTS {
            evaluator.values(&point).expect("inside");
            evaluator.derivatives(&point).expect("inside");
            line.values(point[1]).expect("inside");
        }
    });
    assert_eq!(used.count_total, 0);
}

#[test]
fn what_is_outside_is_an_error_that_names_the_domain() {
    let surface = Surface::new(file()).expect("valid");
    let mut evaluator = surface.evaluator();
    let error = evaluator.values(&[1.0, 0.5, 1.0]).unwrap_err();
    assert_eq!(error.to_string(), "beta = 0.5 is outside the surface, which has beta from 1 to 100000000");
    for point in [[1.0, f64::NAN, 1.0], [-1.0, 1.0, 1.0], [1.0, 1.0, 1.0001e4]] {
        assert!(matches!(evaluator.values(&point), Err(Outside::Axis { .. })), "{point:?}");
        assert!(evaluator.derivatives(&point).is_err());
    }
    let error = evaluator.values(&[1.0, 2.0]).unwrap_err();
    assert_eq!(error.to_string(), "a point of this surface has 3 coordinates (alpha, beta, f), and 2 were given");
    assert!(evaluator.line(1, &[1.0, f64::NAN, 1.0]).is_ok(), "the coordinate along the line does not count");
    assert!(evaluator.line(1, &[-1.0, 2.0, 1.0]).is_err());
}

/// The text of the file with its check points.
fn text() -> String {
    let mut file = file();
    let surface = Surface::new(file.clone()).expect("valid");
    let mut evaluator = surface.evaluator();
    let check = |point: [f64; 3]| {
        let values = evaluator.values(&point).expect("inside").to_vec();
        CheckPoint { point: point.to_vec(), values }
    };
    file.checks = [POINTS[0], POINTS[1], POINTS[2], POINTS[5]].map(check).to_vec();
    serde_json::to_string(&file).expect("written")
}

#[test]
fn a_file_comes_back_and_damage_is_found() {
    let text = text();
    let surface = Surface::parse(&text).expect("valid");
    assert_eq!(serde_json::to_string(surface.file()).expect("written"), text);
    assert_eq!(surface.axes()[0].to, f64::INFINITY);

    let other_version = text.replace("stribeck surface 1", "stribeck surface 9");
    assert!(matches!(Surface::parse(&other_version), Err(SurfaceError::Format { .. })));
    assert!(matches!(Surface::parse("{}"), Err(SurfaceError::NotASurface(_))));
    let core = &surface.file().quantities[0].core;
    let shorter = text.replace(core.as_str(), &core[..core.len() - 16]);
    assert!(matches!(Surface::parse(&shorter), Err(SurfaceError::Damaged { .. })));
    let other_numbers = encode(NumberKind::Float64, &[0.1; 8]);
    let changed = text.replace(core.as_str(), &other_numbers);
    assert!(matches!(Surface::parse(&changed), Err(SurfaceError::CheckPoint { number: 1, .. })));
    let no_range = text.replace("\"to\":100000000.0", "\"to\":1.0");
    assert!(matches!(Surface::parse(&no_range), Err(SurfaceError::Damaged { .. })));
}
