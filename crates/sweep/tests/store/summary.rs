//! The tables of text that a sweep publishes.

use std::fs;
use std::path::Path;

use crate::synthetic::{ALPHA, BETA, F, entry, finished, output};
use stribeck_sweep::Column;
use tempfile::tempdir;

#[test]
fn the_summary_keeps_the_contract() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let text = fs::read_to_string(directory.path().join("summary.csv")).unwrap();
    let header = "case,f,alpha,beta,status,reason,mu_v,mu_h,mu_tot,mu_drag,mu_h_cavity,c,film_min,p_max,x_outlet,\
                  error_mu_v,error_mu_h,error_c,load_residual,dry_mu_v,approx_mu_h,mu_pressure,mu_shear,mu_v_flat,\
                  mu_v_roller,mu_torque,energy_residual,error_mu_drag";
    assert_eq!(text.lines().next(), Some(header));
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let mut places =
        F.iter().flat_map(|f| ALPHA.iter().flat_map(move |alpha| BETA.iter().map(move |beta| (f, alpha, beta))));
    for row in reader.records() {
        let row = row.unwrap();
        let (&f, &alpha, &beta) = places.next().expect("no more rows than places");
        let expected = entry(f, if f == 0.0 { f64::INFINITY } else { alpha }, beta, &output());
        let expected = if alpha == f64::INFINITY { entry(0.0, alpha, beta, &output()) } else { expected };
        assert_eq!(row[0], expected.id.to_string());
        for (cell, value) in row.iter().skip(1).take(3).zip([f, alpha, beta]) {
            assert_eq!(cell.parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
        assert_eq!((&row[4], &row[5]), (expected.outcome.name(), expected.reason.as_str()));
        for (cell, column) in row.iter().skip(6).zip(Column::summary()) {
            let value = expected.values[column];
            match cell {
                "" => assert!(value.is_nan()),
                number => assert_eq!(number.parse::<f64>().unwrap().to_bits(), value.to_bits()),
            }
        }
    }
    assert_eq!(places.next(), None);
    let timings = fs::read_to_string(directory.path().join("timings.csv")).unwrap();
    assert_eq!(timings.lines().next(), Some("case,f,alpha,beta,seconds,iterations,factorisations,seed,status"));
    assert_eq!(timings.lines().count(), text.lines().count());
    assert!(timings.lines().nth(1).unwrap().ends_with(",300,0,neighbour,converged"));
}

#[test]
fn the_documentation_has_the_header_of_the_summary() {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/output.md")).unwrap();
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let summary = fs::read_to_string(directory.path().join("summary.csv")).unwrap();
    assert!(text.contains(summary.lines().next().unwrap()));
}
