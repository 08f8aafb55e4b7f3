//! Laws of the results directory: what is committed comes back bit for bit, what is published does not depend on how it
//! came about, and damage is found, named and repaired by the next run.

use std::fs;
use std::path::{Path, PathBuf};

use crate::synthetic::{
    ALPHA, BETA, F, SWEEP, chains, entry, finished, open, output, publish, publish_as, published_bytes, reference,
    resume, row,
};
use stribeck_solver::{FieldSelection, Fields, Output, Sensitivities};
use stribeck_sweep::store::{Catalog, DataSet, Ending, Inspection, Status, Store, StoreError, Warning, verify};
use stribeck_sweep::{CaseId, Column, Field};
use tempfile::tempdir;

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

fn shards(directory: &Path) -> Vec<PathBuf> {
    let mut files: Vec<_> = fs::read_dir(directory.join("shards")).unwrap().map(|file| file.unwrap().path()).collect();
    files.sort();
    files
}

fn log(directory: &Path, number: u32) -> PathBuf {
    directory.join(format!("log/{number:04}.jsonl"))
}

#[test]
fn what_is_committed_comes_back_bit_for_bit() {
    let directory = tempdir().unwrap();
    let output = output();
    let mut chain: Vec<_> = BETA.iter().map(|&beta| entry(100.0, 1.0, beta, &output)).collect();
    chain[0].values.0[0] = f64::INFINITY;
    chain[0].values.0[1] = -0.0;
    chain[0].values.0[2] = f64::from_bits(0x7ff8_0000_dead_beef);
    chain[1].fields.pressure.as_mut().unwrap()[3] = f64::NAN;
    chain[1].fields.pressure.as_mut().unwrap()[4] = f64::NEG_INFINITY;
    chain[2] = entry(100.0, 0.1, 1000.0, &output);
    assert_eq!(chain[2].outcome, Status::Failed);
    chain[2].reason = "a reason with ünïcode, \"quotes\", commas".into();
    open(directory.path()).commit(&chain).unwrap();

    let held = Catalog::read(directory.path(), &output, Inspection::Bytes).unwrap();
    assert_eq!(held.warnings(), []);
    for entry in &chain {
        assert_eq!(held.holds(entry.id), Some(entry.outcome));
        let back = held.entry(entry.id).unwrap().unwrap();
        assert_eq!(bits(&back.values.0), bits(&entry.values.0));
        assert_eq!((&back.reason, back.outcome, &back.timing), (&entry.reason, entry.outcome, &entry.timing));
        for (back, field) in [
            (&back.fields.pressure, &entry.fields.pressure),
            (&back.fields.film_thickness, &entry.fields.film_thickness),
            (&back.fields.displacement, &entry.fields.displacement),
        ] {
            assert_eq!(back.as_deref().map(bits), field.as_deref().map(bits));
        }
    }
    assert_eq!(held.holds(CaseId(1)), None);
    assert!(held.entry(CaseId(1)).unwrap().is_none());
}

#[test]
fn published_bytes_do_not_depend_on_order_or_number_of_starts() {
    let reference = reference();
    for rotation in [1, 3, 6] {
        let directory = tempdir().unwrap();
        let mut order = chains(&output());
        order.rotate_left(rotation);
        order.reverse();
        for (i, part) in order.chunks(3).enumerate() {
            let mut store = open(directory.path());
            store.begin("synthetic", 20, i as u64).unwrap();
            for chain in part {
                store.commit(chain).unwrap();
            }
            store.end(Ending::Interrupted).unwrap();
        }
        publish(&mut open(directory.path())).unwrap();
        assert!(published_bytes(directory.path()) == reference, "rotation {rotation}");
    }
}

#[test]
fn shards_are_the_same_files_in_every_run() {
    let [first, second] = [(); 2].map(|()| {
        let directory = tempdir().unwrap();
        finished(directory.path());
        let read = |path: PathBuf| (path.file_name().unwrap().to_owned(), fs::read(path).unwrap());
        shards(directory.path()).into_iter().map(read).collect::<Vec<_>>()
    });
    assert_eq!(first.len(), 8);
    assert!(first == second);
}

#[test]
fn a_run_again_has_nothing_to_do_and_writes_nothing() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let logs = || fs::read_dir(directory.path().join("log")).unwrap().count();
    let before = (logs(), fs::metadata(directory.path().join("results.h5")).unwrap().modified().unwrap());
    let mut store = open(directory.path());
    assert!(!publish(&mut store).unwrap().rewritten);
    assert_eq!(before, (logs(), fs::metadata(directory.path().join("results.h5")).unwrap().modified().unwrap()));
    fs::remove_file(directory.path().join("summary.csv")).unwrap();
    assert!(publish(&mut store).unwrap().rewritten, "a published file that was removed comes back");
    assert!(published_bytes(directory.path()) == reference());
}

#[test]
fn what_a_killed_run_leaves_is_recovered() {
    let reference = reference();
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    store.begin("synthetic", 20, 2).unwrap();
    for chain in &chains(&output())[..5] {
        store.commit(chain).unwrap();
    }
    drop(store);
    // Killed while writing a shard, the published files and a log line; and after renaming a shard, before its record.
    fs::write(directory.path().join("shards/.shard.stribeck-part"), b"half").unwrap();
    fs::write(directory.path().join("shards/.draft.stribeck-part"), b"a user's").unwrap();
    fs::write(directory.path().join(".results.h5.stribeck-part"), b"half").unwrap();
    let text = fs::read(log(directory.path(), 1)).unwrap();
    fs::write(log(directory.path(), 1), &text[..text.len() - 40]).unwrap();

    let store = open(directory.path());
    assert_eq!(store.warnings().len(), 1, "{:?}", store.warnings());
    assert!(matches!(&store.warnings()[0], Warning::Record { line: 6, .. }));
    drop(store);
    assert!(!directory.path().join("shards/.shard.stribeck-part").exists());
    assert!(directory.path().join("shards/.draft.stribeck-part").exists(), "no file of ours has that name");
    assert!(!directory.path().join(".results.h5.stribeck-part").exists());
    assert_eq!(resume(directory.path()), 4, "three chains never committed and the one whose record is torn");
    assert!(published_bytes(directory.path()) == reference);
    assert!(verify(directory.path()).unwrap().is_sound());
}

#[test]
fn a_damaged_line_costs_its_own_cases_only() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let mut text = fs::read(log(directory.path(), 1)).unwrap();
    let third_line = text.iter().enumerate().filter(|(_, byte)| **byte == b'\n').nth(1).unwrap().0 + 1;
    text[third_line + 60] ^= 1;
    fs::write(log(directory.path(), 1), &text).unwrap();

    let store = open(directory.path());
    let lost = chains(&output()).iter().flatten().filter(|entry| store.holds(entry.id).is_none()).count();
    assert_eq!(lost, 2, "the second chain has two cases");
    assert!(matches!(&store.warnings(), [Warning::Record { line: 3, .. }]));
    drop(store);
    let report = verify(directory.path()).unwrap();
    assert_eq!((report.warnings.len(), report.unreferenced.len(), report.shards), (1, 1, 7));
    assert_eq!(resume(directory.path()), 1);
    assert!(published_bytes(directory.path()) == reference());
    assert_eq!(verify(directory.path()).unwrap().unreferenced, Vec::<PathBuf>::new());
}

#[test]
fn damaged_shards_are_found_named_and_solved_again() {
    let truncate = |path: &Path| {
        let bytes = fs::read(path).unwrap();
        fs::write(path, &bytes[..bytes.len() / 2]).unwrap();
    };
    let flip = |path: &Path| {
        let mut bytes = fs::read(path).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 0x10;
        fs::write(path, bytes).unwrap();
    };
    let delete = |path: &Path| fs::remove_file(path).unwrap();
    type Damage<'a> = (&'a str, &'a dyn Fn(&Path));
    let damages: [Damage<'_>; 3] = [("bytes", &truncate), ("checksum", &flip), ("missing", &delete)];
    let reference = reference();
    for (what, damage) in damages {
        let directory = tempdir().unwrap();
        drop(finished(directory.path()));
        let victim = shards(directory.path())[4].clone();
        damage(&victim);

        let report = verify(directory.path()).unwrap();
        assert!(!report.is_sound());
        assert_eq!(report.problems.len(), 1);
        assert_eq!(report.problems[0].file, victim);
        assert!(report.problems[0].what.contains(what), "{}", report.problems[0]);

        let store = open(directory.path());
        assert!(matches!(store.warnings(), [Warning::Shard { file, .. }] if *file == victim), "{:?}", store.warnings());
        drop(store);
        assert_eq!(resume(directory.path()), 1);
        assert!(verify(directory.path()).unwrap().is_sound());
        assert!(published_bytes(directory.path()) == reference);
    }
}

#[test]
fn a_damaged_shard_is_of_no_concern_once_others_hold_its_cases() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let victim = shards(directory.path())[4].clone();
    let held: Vec<_> = chains(&output()).concat();
    fs::write(&victim, "damaged").unwrap();

    let mut store = open(directory.path());
    let lost: Vec<_> = held.iter().filter(|entry| store.holds(entry.id).is_none()).cloned().collect();
    let told = |store: &Store| store.warnings().iter().map(ToString::to_string).collect::<String>();
    assert!(told(&store).contains(&format!("its {} cases are not used", lost.len())), "{}", told(&store));
    // Some of them are solved again, in other company than before.
    store.commit(&lost[..1]).unwrap();
    drop(store);
    let mut store = open(directory.path());
    assert!(told(&store).contains(&format!("its {} cases are not used", lost.len() - 1)), "{}", told(&store));
    assert!(!verify(directory.path()).unwrap().is_sound());
    // Now all; but a shard without the fields is no replacement.
    let bare = Output { fields: FieldSelection::default(), ..output() };
    drop(store);
    let mut other = Store::open(directory.path(), SWEEP, &bare).unwrap();
    other.commit(&lost[1..]).unwrap();
    drop(other);
    assert!(!verify(directory.path()).unwrap().is_sound());
    store = open(directory.path());
    store.commit(&lost[1..]).unwrap();
    drop(store);

    let report = verify(directory.path()).unwrap();
    assert!(report.is_sound());
    assert_eq!((report.replaced, report.unreferenced), (vec![victim], Vec::new()));
    let mut store = open(directory.path());
    assert_eq!(told(&store), "");
    publish(&mut store).unwrap();
    assert!(published_bytes(directory.path()) == reference());
}

#[test]
fn chains_committed_in_any_company_publish_the_same_bytes() {
    let reference = reference();
    for (size, reversed) in [(1, true), (2, false), (3, true), (8, false)] {
        let directory = tempdir().unwrap();
        let mut store = open(directory.path());
        let mut chains = chains(&output());
        if reversed {
            chains.reverse();
        }
        for group in chains.chunks(size) {
            store.commit(&group.concat()).unwrap();
        }
        publish(&mut store).unwrap();
        assert_eq!(shards(directory.path()).len(), 8_usize.div_ceil(size));
        assert!(published_bytes(directory.path()) == reference, "groups of {size}");
    }
}

#[test]
fn a_changed_published_file_is_found() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    assert_eq!(verify(directory.path()).unwrap().published, 3);
    let summary = directory.path().join("summary.csv");
    let text = fs::read_to_string(&summary).unwrap();
    fs::write(&summary, text.replacen('1', "2", 1)).unwrap();
    let report = verify(directory.path()).unwrap();
    assert_eq!((report.published, report.problems.len()), (2, 1));
    assert_eq!(report.problems[0].file, summary);
}

#[test]
fn an_unfinished_sweep_is_not_published() {
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    for chain in &chains(&output())[1..] {
        store.commit(chain).unwrap();
    }
    // The first chain holds three elastic cases: they stand in all four rows of f = 0 and in the row α = ∞ of f = 100.
    let error = publish(&mut store).unwrap_err();
    assert!(matches!(error, StoreError::Unfinished { missing: 15, places: 40 }), "{error}");
    assert!(!directory.path().join("results.h5").exists() && !directory.path().join("summary.csv").exists());
    store.commit(&chains(&output())[0]).unwrap();
    let published = publish(&mut store).unwrap();
    assert_eq!((published.converged, published.failed), (39, 1));
}

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

#[test]
fn a_second_opener_is_told_who_holds_the_directory() {
    let directory = tempdir().unwrap();
    let first = open(directory.path());
    let error = Store::open(directory.path(), SWEEP, &output()).unwrap_err();
    assert!(matches!(error, StoreError::Locked { .. }));
    assert!(error.to_string().contains(&std::process::id().to_string()), "{error}");
    Catalog::read(directory.path(), &output(), Inspection::Bytes).expect("reading needs no lock");
    drop(first);
    open(directory.path());
}

#[test]
fn a_refused_chain_leaves_no_trace() {
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    let good = entry(100.0, 1.0, 10.0, &output());
    let refused = |change: &dyn Fn(&mut stribeck_sweep::store::CaseEntry)| {
        let mut bad = good.clone();
        change(&mut bad);
        bad
    };
    let chains = [
        vec![good.clone(), good.clone()],
        vec![refused(&|bad| bad.timing.seconds = f64::NAN)],
        vec![refused(&|bad| bad.timing.seconds = -1.0)],
        vec![refused(&|bad| bad.reason = "two\nlines".into())],
        vec![refused(&|bad| bad.fields.pressure = None)],
        vec![refused(&|bad| bad.fields.pressure.as_mut().unwrap().truncate(40))],
        vec![refused(&|bad| bad.outcome = Status::Failed)],
        vec![refused(&|bad| {
            bad.sensitivities = Sensitivities::from_row([0.0; 20]);
            (bad.outcome, bad.fields) = (Status::Failed, Fields::default());
        })],
    ];
    for chain in &chains {
        assert!(matches!(store.commit(chain), Err(StoreError::Entry { .. })), "{chain:?}");
    }
    assert_eq!(shards(directory.path()), Vec::<PathBuf>::new());
    store.commit(&[good]).unwrap();
}

#[test]
fn a_disk_that_fails_is_an_error_and_the_store_goes_on() {
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    let all = chains(&output());
    store.commit(&all[0]).unwrap();
    let (shard_directory, away) = (directory.path().join("shards"), directory.path().join("away"));
    fs::rename(&shard_directory, &away).unwrap();
    let error = store.commit(&all[1]).unwrap_err();
    assert!(error.to_string().contains("shards"), "{error}");
    assert!(!error.to_string().contains("free some space"), "{error}");
    assert_eq!(store.holds(all[1][0].id), None);
    fs::rename(&away, &shard_directory).unwrap();
    store.commit(&all[1]).unwrap();
    drop(store);
    let held = Catalog::read(directory.path(), &output(), Inspection::Bytes).unwrap();
    assert_eq!((held.counts().converged, held.warnings().len()), (5, 0));
}

#[test]
fn a_path_without_results_is_refused() {
    let directory = tempdir().unwrap();
    for path in [directory.path().to_owned(), directory.path().join("nowhere")] {
        assert!(matches!(Catalog::read(&path, &output(), Inspection::Bytes), Err(StoreError::NotResults { .. })));
        assert!(matches!(verify(&path), Err(StoreError::NotResults { .. })));
    }
    assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 0, "reading writes nothing");
}

#[test]
fn the_history_tells_of_every_start() {
    let directory = tempdir().unwrap();
    let mut store = open(directory.path());
    let all = chains(&output());
    store.begin("synthetic", 20, 2).unwrap();
    for chain in &all[..3] {
        store.commit(chain).unwrap();
    }
    store.end(Ending::Interrupted).unwrap();
    drop(store);
    let mut store = open(directory.path());
    store.begin("synthetic", 12, 1).unwrap();
    for chain in &all[3..] {
        store.commit(chain).unwrap();
    }
    let live = store.history().clone();
    drop(store);

    let held = Catalog::read(directory.path(), &output(), Inspection::Bytes).unwrap();
    assert_eq!(&live, held.history(), "the running store and a reader tell the same");
    let starts: Vec<_> = held.history().starts().map(|(_, start)| start.clone()).collect();
    assert_eq!(starts.iter().map(|start| start.ending).collect::<Vec<_>>(), [Some(Ending::Interrupted), None]);
    assert_eq!(starts.iter().map(|start| (start.converged, start.failed)).collect::<Vec<_>>(), [(8, 0), (11, 1)]);
    let expected: f64 = all.iter().flatten().map(|entry| entry.timing.seconds).sum();
    let seconds: f64 = starts.iter().map(|start| start.case_seconds).sum();
    assert!((seconds / expected - 1.0).abs() < 1e-12);
    let mut failures = Vec::new();
    held.visit_failures(|id, kind, reason| failures.push((id, Some(kind.to_owned()), reason.to_owned()))).unwrap();
    let failed = entry(100.0, 0.1, 1000.0, &output());
    assert_eq!(failures, [(failed.id, failed.failure_kind, failed.reason)]);
}

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
fn a_row_of_the_wrong_length_is_refused() {
    let directory = tempdir().unwrap();
    let mut store = finished(directory.path());
    let short = |i_f: usize, i_alpha: usize| row(i_f, i_alpha)[1..].to_vec();
    let published = publish_as(&mut store, ["", ""], [&F, &ALPHA, &BETA], &short);
    assert!(matches!(published, Err(StoreError::Publication { .. })));
}

#[test]
fn the_sweep_file_is_kept_as_it_was_run() {
    let directory = tempdir().unwrap();
    drop(open(directory.path()));
    assert_eq!(fs::read_to_string(directory.path().join("sweep.toml")).unwrap(), SWEEP);
    drop(Store::open(directory.path(), "title = \"other\"\n", &output()).unwrap());
    assert_eq!(fs::read_to_string(directory.path().join("sweep.toml")).unwrap(), "title = \"other\"\n");
}

#[test]
fn a_published_file_that_was_changed_is_written_again() {
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    for name in ["results.h5", "summary.csv", "timings.csv"] {
        let path = directory.path().join(name);
        let whole = fs::read(&path).unwrap();
        let mut bytes = whole.clone();
        *bytes.last_mut().unwrap() ^= 1;
        fs::write(&path, &bytes).unwrap();
        let mut store = open(directory.path());
        assert!(publish(&mut store).unwrap().rewritten, "{name}");
        assert!(fs::read(&path).unwrap() == whole, "{name}");
        assert!(!publish(&mut store).unwrap().rewritten, "{name}");
    }
}

#[test]
fn limits_that_are_not_asked_for_are_not_published() {
    let published = |outputs: &[&Output]| {
        let directory = tempdir().unwrap();
        for &output in outputs {
            let mut store = Store::open(directory.path(), SWEEP, output).unwrap();
            for chain in chains(output) {
                if store.holds(chain[0].id).is_none() {
                    store.commit(&chain).unwrap();
                }
            }
            publish(&mut store).unwrap();
        }
        let mut reader = csv::Reader::from_path(directory.path().join("summary.csv")).unwrap();
        let header = reader.headers().unwrap().clone();
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        let column = |name: &str| {
            let place = header.iter().position(|column| column == name).unwrap();
            rows.iter().filter(|row| !row[place].is_empty()).count()
        };
        (column("dry_mu_v"), column("approx_mu_h"), column("mu_v"))
    };
    let [with, without] = [true, false].map(|limits| Output { limits, ..output() });
    assert_eq!(published(&[&with]), (39, 39, 39));
    assert_eq!(published(&[&with, &without]), (0, 0, 39));
    assert_eq!(published(&[&with, &without, &with]), (39, 39, 39), "they are still in the shards");
}

#[test]
fn the_files_of_others_are_left_alone() {
    for name in ["sweep.toml", "results.h5", "summary.csv", "timings.csv"] {
        let directory = tempdir().unwrap();
        fs::write(directory.path().join(name), "not ours").unwrap();
        let refused = |there: usize| {
            let error = Store::open(directory.path(), SWEEP, &output()).unwrap_err();
            assert!(matches!(error, StoreError::Occupied { .. }), "{error}");
            assert!(error.to_string().contains(&format!("it has {name} but no log")), "{error}");
            assert_eq!(fs::read_to_string(directory.path().join(name)).unwrap(), "not ours");
            assert_eq!(fs::read_dir(directory.path()).unwrap().count(), there, "nothing is added");
        };
        refused(1);
        fs::create_dir(directory.path().join("log")).unwrap();
        fs::write(directory.path().join("log/today.txt"), "").unwrap();
        refused(2);
    }
    let directory = tempdir().unwrap();
    fs::write(directory.path().join("notes.txt"), "").unwrap();
    finished(directory.path());
    assert!(published_bytes(directory.path()) == reference(), "files of other names do not matter");
}

#[test]
fn a_first_start_killed_before_its_first_record_is_resumed() {
    let reference = reference();
    let directories = ["log", "shards"];
    for killed_after in 0..=directories.len() {
        let directory = tempdir().unwrap();
        for name in &directories[..killed_after] {
            fs::create_dir(directory.path().join(name)).unwrap();
        }
        assert_eq!(resume(directory.path()), 8);
        assert!(published_bytes(directory.path()) == reference);
    }
    let directory = tempdir().unwrap();
    drop(open(directory.path()));
    assert_eq!(fs::read_dir(directory.path().join("log")).unwrap().count(), 0, "no record yet");
    assert_eq!(fs::read_to_string(directory.path().join("sweep.toml")).unwrap(), SWEEP);
    assert_eq!(resume(directory.path()), 8);
    assert!(published_bytes(directory.path()) == reference);
}

#[test]
fn the_documentation_lists_every_column_field_and_header() {
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/output.md")).unwrap();
    for column in Column::ALL {
        let shown = if column.in_summary() { "yes" } else { "no" };
        let row = format!("| `{}` | {} | {shown} |", column.name(), column.units());
        assert!(text.contains(&row), "docs/reference/output.md has no row {row}");
    }
    for field in Field::ALL {
        let row = format!("\n| `{}` | {} |", field.name(), field.units());
        assert!(text.contains(&row), "docs/reference/output.md has no row {row}");
    }
    let directory = tempdir().unwrap();
    drop(finished(directory.path()));
    let summary = fs::read_to_string(directory.path().join("summary.csv")).unwrap();
    assert!(text.contains(summary.lines().next().unwrap()));
}

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

/// Other bytes of the same cases, and the bytes of a damaged shard, come into files of their own.
#[test]
fn no_shard_is_ever_replaced() {
    let directory = tempdir().unwrap();
    let chain = &chains(&output())[2];
    open(directory.path()).commit(chain).unwrap();
    let [first] = &shards(directory.path())[..] else { panic!("one shard") };
    let before = fs::read(first).unwrap();

    // The same cases as another processor rounds them.
    let mut other = chain.clone();
    other[0].values.0[0] += 1e-9;
    open(directory.path()).commit(&other).unwrap();
    assert_eq!(shards(directory.path()).len(), 2);
    assert_eq!(fs::read(first).unwrap(), before);

    // The same bytes again are the same file; where that is damaged, the damage stays beside them.
    open(directory.path()).commit(chain).unwrap();
    assert_eq!(shards(directory.path()).len(), 2);
    fs::write(first, b"damaged").unwrap();
    open(directory.path()).commit(chain).unwrap();
    let found = shards(directory.path());
    assert_eq!((found.len(), fs::read(first).unwrap()), (3, b"damaged".to_vec()));
    assert!(found.iter().any(|shard| fs::read(shard).unwrap() == before));
    assert!(verify(directory.path()).unwrap().is_sound());
}
