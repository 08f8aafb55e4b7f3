//! Fits to moduli that are known.

use std::path::Path;

use super::{decades, decay, oscillation, rubber, solid};
use proptest::prelude::*;
use stribeck_lab::{
    MaterialData, MaterialFile, MaterialOptions, Measurements, Relaxation, RelaxationFit, RelaxationFitError,
    RelaxationTerm,
};

/// The table of a material at these angular frequencies.
fn table(relaxation: &Relaxation, omegas: impl IntoIterator<Item = f64>) -> String {
    let mut text = "omega,storage,loss\n".to_owned();
    for omega in omegas {
        let (storage, loss) = relaxation.storage_and_loss(omega);
        text += &format!("{omega:?},{storage:?},{loss:?}\n");
    }
    text
}

fn measurements(text: &str) -> Measurements {
    let options = MaterialOptions::default();
    match MaterialFile::of(Path::new("data.csv"), text.as_bytes(), &options).expect("a table").data {
        MaterialData::Moduli(measurements) => measurements,
        other => panic!("{other:?}"),
    }
}

/// Offered its own times, a fit finds the material and drops the others.
#[test]
fn a_material_is_found_again() {
    let material = solid(1e6, &[(3e8, 1e-3), (2e7, 1e-1), (5e5, 1e2)]);
    let fit = RelaxationFit::new(&measurements(&table(&material, decades(-3, 4))), 8).expect("a fit");
    assert!(fit.largest_residual < 1e-10 && fit.rms_residual <= fit.largest_residual, "{fit:?}");
    assert!((fit.relaxation.relaxed_modulus() / 1e6 - 1.0).abs() < 1e-9);
    for term in fit.relaxation.terms() {
        let near = material.terms().iter().find(|exact| (term.time / exact.time - 1.0).abs() < 1e-9);
        match near {
            Some(exact) => assert!((term.modulus / exact.modulus - 1.0).abs() < 1e-9, "{term:?}"),
            None => assert!(term.modulus < 1e-3, "{term:?} is of rounding"),
        }
    }
}

/// Times between those offered are made up by their neighbours, the better the closer these are.
#[test]
fn more_terms_fit_better() {
    let material = solid(2e6, &[(1e8, 3e-4), (4e7, 0.07), (3e6, 20.0)]);
    let measurements = measurements(&table(&material, decades(-3, 5)));
    let residuals = [5, 9, 17, 33].map(|terms| RelaxationFit::new(&measurements, terms).expect("a fit").rms_residual);
    assert!(residuals[3] < 0.02 && residuals.windows(2).all(|pair| pair[1] < 0.7 * pair[0]), "{residuals:?}");
}

/// The residual is what is minimized: no change of a modulus makes it smaller.
#[test]
fn no_neighbour_is_better() {
    let material = solid(2e6, &[(1e8, 3e-4), (4e7, 0.07), (3e6, 20.0)]);
    let measurements = measurements(&table(&material, decades(-3, 5)));
    let fit = RelaxationFit::new(&measurements, 7).expect("a fit");
    let residual = |relaxation: &Relaxation| -> f64 {
        let square = |row: &stribeck_lab::Measurement| {
            let [storage, loss] = row.moduli();
            let (fitted, lost) = relaxation.storage_and_loss(row.rate());
            ((fitted - storage).powi(2) + (lost - loss).powi(2)) / (storage.powi(2) + loss.powi(2))
        };
        let rows = measurements.rows();
        (rows.iter().map(square).sum::<f64>() / rows.len() as f64).sqrt()
    };
    assert!((residual(&fit.relaxation) / fit.rms_residual - 1.0).abs() < 1e-12);
    let (relaxed_modulus, terms) = (fit.relaxation.relaxed_modulus(), fit.relaxation.terms());
    for factor in [0.999, 1.001] {
        assert!(
            residual(&solid(
                relaxed_modulus * factor,
                &terms.iter().map(|term| (term.modulus, term.time)).collect::<Vec<_>>()
            )) > fit.rms_residual
        );
        for i in 0..terms.len() {
            let changed = |(j, term): (usize, &RelaxationTerm)| {
                (if i == j { factor * term.modulus } else { term.modulus }, term.time)
            };
            let changed: Vec<_> = terms.iter().enumerate().map(changed).collect();
            assert!(residual(&solid(relaxed_modulus, &changed)) > fit.rms_residual, "term {i}");
        }
    }
}

/// Moduli in oscillation and after a step of strain are two views of one material: offered its own times, both fits find
/// its terms.
#[test]
fn a_decay_gives_the_terms_that_an_oscillation_gives() {
    let material = rubber();
    // ten times, of which the outermost are those of the material
    let [waves, steps] = [oscillation(&material, -3, 6), decay(&material, -6, 3)]
        .map(|rows| RelaxationFit::new(&Measurements::new(rows).expect("many rates"), 10).expect("a fit").relaxation);
    for fit in [&waves, &steps] {
        assert!((fit.relaxed_modulus() / material.relaxed_modulus() - 1.0).abs() < 1e-6, "{fit:?}");
        assert_eq!(fit.terms().len(), 10);
        for (term, exact) in fit.terms().iter().zip(material.terms()) {
            assert!((term.time / exact.time - 1.0).abs() < 1e-9, "{term:?}");
            assert!((term.modulus / exact.modulus - 1.0).abs() < 1e-6, "{term:?}, not {exact:?}");
        }
    }
}

#[test]
fn frequencies_and_order_of_columns_and_rows_are_free() {
    let material = solid(1e6, &[(3e8, 1e-3), (2e7, 1e-1)]);
    let plain = table(&material, decades(-2, 4));
    let mut rows: Vec<&str> = plain.lines().skip(1).collect();
    rows.reverse();
    let columns = |row: &&str| {
        let numbers: Vec<&str> = row.split(',').collect();
        let omega: f64 = numbers[0].parse().expect("a number");
        format!("{} , {:?},{}\r\n", numbers[2], omega / std::f64::consts::TAU, numbers[1])
    };
    let other = format!("\u{feff}loss, frequency,storage\r\n\n{}", rows.iter().map(columns).collect::<String>());
    let (plain, other) = (measurements(&plain), measurements(&other));
    for (a, b) in plain.rows().iter().zip(other.rows()) {
        assert!((a.rate() / b.rate() - 1.0).abs() < 1e-15);
        assert_eq!(a.moduli(), b.moduli());
    }
    assert_eq!(plain.rows().len(), other.rows().len());
}

#[test]
fn what_no_material_fits_is_told() {
    let rows = measurements("omega,storage,loss\n1,100,10\n2,110,12\n");
    for (terms, error) in [
        (0, RelaxationFitError::Terms { terms: 0 }),
        (4, RelaxationFitError::TooFewNumbers { terms: 4, numbers: 4 }),
        (101, RelaxationFitError::Terms { terms: 101 }),
    ] {
        assert_eq!(RelaxationFit::new(&rows, terms), Err(error));
    }
    assert_eq!(RelaxationFit::MOST_TERMS, 100);
    assert!(RelaxationFit::new(&rows, 3).is_ok());
    // A Maxwell liquid: E″ falls in proportion to ω, E′ to its square.
    let liquid: String = decades(-3, 0).map(|omega| format!("{omega:?},{:?},{omega:?}\n", omega * omega)).collect();
    assert_eq!(
        RelaxationFit::new(&measurements(&format!("omega,storage,loss\n{liquid}")), 6),
        Err(RelaxationFitError::Liquid)
    );
    let elastic = measurements("omega,storage,loss\n1,100,0\n10,100,0\n100,100,0\n");
    assert_eq!(RelaxationFit::new(&elastic, 3), Err(RelaxationFitError::Elastic));
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(100)
    })]

    /// Noise, few rows, many terms: a fit ends, with a material or a reason.
    #[test]
    fn any_table_has_an_answer(
        rows in prop::collection::vec((-3.0..6.0_f64, 3.0..9.0_f64, 0.0..9.0_f64), 2..40),
        terms in 1..40_usize,
    ) {
        let text: String = rows.iter().map(|(omega, storage, loss)| {
            format!("{:?},{:?},{:?}\n", 10_f64.powf(*omega), 10_f64.powf(*storage), 10_f64.powf(*loss))
        }).collect();
        if let Ok(fit) = RelaxationFit::new(&measurements(&format!("omega,storage,loss\n{text}")), terms) {
            prop_assert!(fit.rms_residual <= fit.largest_residual && fit.rms_residual <= 1.0);
            prop_assert!(fit.relaxation.terms().len() <= terms);
            prop_assert!(fit.relaxation.material().f > 0.0);
        }
    }
}
