//! A published data set is read back as it was written, and refused if its parts do not fit.

use std::fs;

use super::bits;
use crate::synthetic::{ALPHA, BETA, F, SWEEP, entry, finished, output};
use stribeck_sweep::store::{DataSet, StoreError};
use stribeck_sweep::{Column, Field};
use tempfile::tempdir;

/// What was published is read back, to the last bit.
#[test]
fn a_data_set_is_read_back_as_it_was_published() {
    let directory = tempdir().unwrap();
    let mut store = finished(directory.path());
    let data = DataSet::open(directory.path()).unwrap();
    assert_eq!((data.title.as_str(), data.sweep_text.as_str()), ("synthetic, β from 10", SWEEP));
    let axes: Vec<(&str, &[f64])> = data.dimensions.iter().map(|it| (it.name.as_str(), &it.values[..])).collect();
    assert_eq!(axes, [("f", &F[..]), ("alpha", &ALPHA[..]), ("beta", &BETA[..])]);
    assert_eq!((data.x.as_slice(), data.outdated), (&*output().x, false));
    let (statuses, reasons, cases) = (data.statuses().unwrap(), data.reasons().unwrap(), data.cases().unwrap());
    let costs = data.costs().unwrap().unwrap();
    let columns = Column::ALL.map(|column| data.column(column).unwrap());
    for (i_f, f) in F.into_iter().enumerate() {
        for (i_alpha, alpha) in ALPHA.into_iter().enumerate() {
            for (i_beta, beta) in BETA.into_iter().enumerate() {
                // Elastic cases are stored once.
                let alpha = if f == 0.0 { f64::INFINITY } else { alpha };
                let f = if alpha == f64::INFINITY { 0.0 } else { f };
                let wanted = entry(f, alpha, beta, &output());
                let place = data.place([i_f, i_alpha, i_beta]);
                assert_eq!((statuses[place], &reasons[place]), (wanted.outcome, &wanted.reason));
                assert_eq!((&cases[place], &costs[place].case), (&wanted.id.to_string(), &wanted.id.to_string()));
                assert_eq!(costs[place].seconds, wanted.timing.seconds);
                let values: Vec<f64> = columns.iter().map(|column| column[place]).collect();
                assert_eq!(bits(&values), bits(&wanted.values.0));
                let film = data.field(Field::FilmThickness, [i_f, i_alpha, i_beta]).unwrap();
                match wanted.fields.film_thickness {
                    Some(field) => assert_eq!(bits(&film), bits(&field)),
                    None => assert!(film.iter().all(|value| value.is_nan())),
                }
            }
        }
    }
    assert!(data.variable("mu_q").is_err());

    // Cases that come later are not in it.
    store.commit(&[entry(7.0, 1.0, 10.0, &output())]).unwrap();
    assert!(DataSet::open(directory.path()).unwrap().outdated);
    // Timings of other cases are not taken for its own.
    let timings = directory.path().join("timings.csv");
    let text = fs::read_to_string(&timings).unwrap();
    fs::write(&timings, text.lines().take(5).collect::<Vec<_>>().join("\n")).unwrap();
    let error = data.costs().unwrap_err();
    assert!(matches!(&error, StoreError::Altered { .. }), "{error}");
}

/// A file that was passed on without its log may be anyone's: what does not fit its axes is refused, not indexed.
#[test]
fn a_data_set_whose_parts_do_not_fit_is_refused() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    for (name, expected) in [("mu_v", "mu_v has 3 values, its axes ask for 40"), ("status", "its axes ask for 40")] {
        let alone = tempdir().unwrap();
        let copy = alone.path().join("results.h5");
        fs::copy(directory.path().join("results.h5"), &copy).unwrap();
        let file = hdf5::File::open_rw(&copy).unwrap();
        file.unlink(name).unwrap();
        match name {
            "status" => file.new_dataset_builder().with_data(&[0_i8; 3]).create(name).unwrap(),
            _ => file.new_dataset_builder().with_data(&[1.0_f64; 3]).create(name).unwrap(),
        };
        file.close().unwrap();
        let data = DataSet::open(alone.path()).unwrap();
        let error = if name == "status" { data.statuses().unwrap_err() } else { data.variable(name).unwrap_err() };
        assert!(matches!(&error, StoreError::Altered { .. }) && error.to_string().contains(expected), "{error}");
        assert_eq!(data.column(Column::MuH).unwrap().len(), 40);
    }
}
