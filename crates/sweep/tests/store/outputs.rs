//! Cases count for a sweep if they hold all that it asks for, and no more than that is published.

use crate::synthetic::{SWEEP, chains, entry, finished, open, output, publish, published_bytes, reference, row};
use stribeck_solver::{FieldSelection, Output, Sensitivities};
use stribeck_sweep::store::{Catalog, Inspection, Status, Store, StoreError};
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
