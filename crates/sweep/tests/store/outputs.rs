//! Cases count for a sweep if they hold all that it asks for, and no more than that is published.

use std::path::Path;

use crate::synthetic::{SWEEP, chains, entry, finished, open, output, publish, published_bytes, reference, row};
use stribeck_solver::{FieldSelection, Output, Sensitivities};
use stribeck_sweep::store::{CaseEntry, Catalog, DataSet, Inspection, Status, Store, StoreError, StoredOutput, verify};
use stribeck_sweep::{Field, FieldPrecision};
use tempfile::tempdir;

#[test]
fn only_shards_with_all_that_is_asked_for_count() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let id = row(0, 0)[0];
    let held = |wanted: &Output| Catalog::read(directory.path(), wanted, Inspection::Bytes).unwrap().holds(id);
    let pressure_only = FieldSelection { pressure: true, ..FieldSelection::default() };
    assert!(held(&Output { fields: pressure_only, ..output() }).is_some(), "more than asked for is fine");
    assert!(held(&Output { fields: FieldSelection::default(), x: [].into(), ..output() }).is_some());
    let other_x: Vec<f64> = output().x.iter().map(|x| x + 1e-15).collect();
    assert!(held(&Output { x: other_x.into(), ..output() }).is_none());

    let directory = tempdir().unwrap();
    let modest = Output { fields: pressure_only, limits: false, ..output() };
    let mut store = Store::open(directory.path(), SWEEP, &modest).unwrap();
    store.commit(&[entry(0.0, 1.0, 10.0, &modest)]).unwrap();
    drop(store);
    let held = |wanted: &Output| Catalog::read(directory.path(), wanted, Inspection::Bytes).unwrap().holds(id);
    assert!(held(&modest).is_some());
    assert!(held(&Output { limits: true, ..modest.clone() }).is_none());
    assert!(held(&Output { limits: false, ..output() }).is_none());
    let more = Output { sensitivities: true, ..modest.clone() };
    assert!(held(&more).is_none());
    Store::open(directory.path(), SWEEP, &more).unwrap().commit(&[entry(0.0, 1.0, 10.0, &more)]).unwrap();
    assert!(held(&more).is_some() && held(&modest).is_some(), "what has more is reused");
    // Once all is there, the fuller shard counts.
    open(directory.path()).commit(&[entry(0.0, 1.0, 10.0, &output())]).unwrap();
    assert!(held(&output()).is_some() && held(&modest).is_some());
}

#[test]
fn sensitivities_come_back_and_change_no_published_byte_of_a_sweep_without_them() {
    let directory = tempdir().unwrap();
    let more = Output { sensitivities: true, ..output() };
    let mut store = Store::open(directory.path(), SWEEP, &more).unwrap();
    let mut bare = entry(100.0, 1.0, 10.0, &more);
    bare.sensitivities = None;
    assert!(matches!(store.commit(&[bare]), Err(StoreError::Entry { .. })), "a converged case must have them");
    for chain in chains(&more) {
        store.commit(&chain).unwrap();
    }
    drop(store);
    let mut store = open(directory.path());
    for expected in chains(&more).into_iter().flatten() {
        let held = store.entry(expected.id).unwrap().unwrap();
        assert_eq!(held.sensitivities, expected.sensitivities);
        assert_eq!(held.sensitivity_errors, expected.sensitivity_errors);
        assert_eq!(held.sensitivities.is_some(), expected.outcome == Status::Converged);
    }
    publish(&mut store).unwrap();
    assert!(published_bytes(directory.path()) == reference());
}

/// Sensitivities to a soft roller come back too, from a shard where one case has them.
#[test]
fn sensitivities_to_the_roller_come_back() {
    let directory = tempdir().unwrap();
    let more = Output { sensitivities: true, ..output() };
    let mut cases = [10.0, 30.0].map(|beta| entry(100.0, 1.0, beta, &more));
    let row: [f64; 20] = std::array::from_fn(|place| place as f64 - 7.5);
    cases[1].sensitivities = Sensitivities::from_row(row);
    cases[1].sensitivity_errors = Sensitivities::from_row(row.map(|value| 1e-3 * value.abs()));
    let mut store = Store::open(directory.path(), SWEEP, &more).unwrap();
    store.commit(&cases).unwrap();
    drop(store);
    let store = Store::open(directory.path(), SWEEP, &more).unwrap();
    for expected in &cases {
        let held = store.entry(expected.id).unwrap().unwrap();
        assert_eq!(held.sensitivities, expected.sensitivities);
        assert_eq!(held.sensitivity_errors, expected.sensitivity_errors);
    }
}

fn rounded() -> StoredOutput {
    StoredOutput { output: output(), field_precision: FieldPrecision::Single }
}

/// Commits what is missing for an output and publishes; tells how many chains were missing.
fn publish_with(directory: &Path, wanted: &StoredOutput) -> usize {
    let mut store = Store::open(directory, SWEEP, wanted).unwrap();
    let missing = |chain: &[CaseEntry]| chain.iter().any(|entry: &CaseEntry| store.holds(entry.id).is_none());
    let missing: Vec<_> = chains(&output()).into_iter().filter(|chain| missing(chain)).collect();
    for chain in &missing {
        store.commit(chain).unwrap();
    }
    publish(&mut store).unwrap();
    assert!(verify(directory).unwrap().is_sound());
    missing.len()
}

/// Of stored fields only those of double precision serve both, and what is published does not depend on how they are
/// stored.
#[test]
fn fields_are_published_in_the_precision_that_is_asked_for() {
    let double = StoredOutput::from(&output());
    let [once_single, first_single, first_double] = [(); 3].map(|()| tempdir().unwrap());
    let chains = chains(&output()).len();
    assert_eq!(publish_with(once_single.path(), &rounded()), chains);
    let single_bytes = published_bytes(once_single.path());
    assert_eq!(publish_with(first_single.path(), &rounded()), chains);
    assert_eq!(publish_with(first_single.path(), &double), chains, "rounded fields are not published as double");
    assert!(published_bytes(first_single.path()) == reference());
    assert_eq!(publish_with(first_double.path(), &double), chains);
    assert_eq!(publish_with(first_double.path(), &rounded()), 0, "double fields are rounded");
    assert!(published_bytes(first_double.path()) == single_bytes);
    assert_eq!(publish_with(first_double.path(), &double), 0, "and are there still");
    assert!(published_bytes(first_double.path()) == reference());
    assert!(single_bytes[1] == reference()[1], "no column is rounded");
}

/// The mark of a rounded field in `results.h5`.
fn kept_bits(directory: &Path, field: Field) -> Option<i32> {
    let file = hdf5::File::open(directory.join("results.h5")).unwrap();
    let variable = file.dataset(field.name()).unwrap();
    let is_marked = variable.attr_names().unwrap().iter().any(|name| name == "quantization_nsb");
    is_marked.then(|| variable.attr("quantization_nsb").unwrap().read_scalar().unwrap())
}

#[test]
fn rounded_fields_are_marked_and_the_nearest_of_single_precision() {
    let [single, double] = [(); 2].map(|()| tempdir().unwrap());
    publish_with(single.path(), &rounded());
    drop(finished(double.path()));
    for field in Field::ALL {
        assert_eq!([&single, &double].map(|directory| kept_bits(directory.path(), field)), [Some(23), None]);
    }
    let [single_data, double_data] = [&single, &double].map(|directory| DataSet::open(directory.path()).unwrap());
    for (field, place) in Field::ALL.into_iter().flat_map(|field| (0..40).map(move |place| (field, place))) {
        let index = single_data.shape().index(place);
        let [found, exact] = [&single_data, &double_data].map(|data| data.field(field, index).unwrap());
        for (found, exact) in found.into_iter().zip(exact) {
            let is_tiny = exact.abs() < f64::from(f32::MIN_POSITIVE);
            let nearest = f64::from(exact as f32);
            assert!(nearest == found || is_tiny || exact.is_nan() && found.is_nan(), "{exact} {found}");
        }
    }
    // What the store gives back is what it keeps.
    let store = Store::open(single.path(), SWEEP, rounded()).unwrap();
    let kept = store.entry(row(1, 1)[0]).unwrap().unwrap().fields.pressure.unwrap();
    assert_eq!(kept, single_data.field(Field::Pressure, [1, 1, 0]).unwrap());
}
