//! Damaged shards, wherever the damage is: never used, each named, and the cases of the others stay.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::laws::shard::{check, written};
use crate::synthetic::{chains, finished, open, output, published_bytes, reference, resume};
use proptest::prelude::*;
use proptest::sample::Index;
use stribeck_sweep::store::{Warning, verify};
use tempfile::tempdir;

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(200)
    })]

    #[test]
    fn a_shard_cut_anywhere_is_not_used(place in any::<Index>()) {
        let bytes = written();
        check(&bytes[..place.index(bytes.len())]);
    }

    #[test]
    fn a_shard_with_any_bit_flipped_is_not_used(place in any::<Index>(), bit in 0..8) {
        let mut bytes = written();
        let place = place.index(bytes.len());
        bytes[place] ^= 1_u8 << bit;
        check(&bytes);
    }

    #[test]
    fn a_shard_with_bytes_moved_added_or_overwritten_is_not_used(
        from in any::<Index>(), to in any::<Index>(), length in 1..600_usize, added in prop::collection::vec(any::<u8>(), 0..20),
    ) {
        let whole = written();
        let (from, to) = (from.index(whole.len() - length), to.index(whole.len() - length));
        let mut bytes = whole.clone();
        bytes.copy_within(from..from + length, to);
        bytes.extend(&added);
        check(&bytes);
        check(&[&added[..], &whole].concat());
    }

    #[test]
    fn other_bytes_are_not_used(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
        check(&bytes);
        check(&[b"\x89HDF\r\n\x1a\n", &bytes[..]].concat());
    }
}

fn shards(directory: &Path) -> Vec<PathBuf> {
    let mut files: Vec<_> = fs::read_dir(directory.join("shards")).unwrap().map(|file| file.unwrap().path()).collect();
    files.sort();
    files
}

/// Which shards a store warns of, and how many cases it says they had.
fn warned(warnings: &[Warning]) -> (BTreeSet<PathBuf>, usize) {
    let parts = |warning: &Warning| match warning {
        Warning::Shard { file, cases, .. } => (file.clone(), *cases),
        Warning::Record { .. } | Warning::NoLock { .. } | Warning::Unreadable { .. } => panic!("{warning}"),
    };
    let (files, cases): (_, Vec<usize>) = warnings.iter().map(parts).unzip();
    (files, cases.iter().sum())
}

proptest! {
    #![proptest_config(ProptestConfig {
        rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
        ..ProptestConfig::with_cases(12)
    })]

    /// Sound HDF5 files with sound cases, and still not what their names say.
    #[test]
    fn shards_that_changed_places_are_named_and_their_cases_solved_again(order in Just((0..8_usize).collect::<Vec<_>>()).prop_shuffle()) {
        let directory = tempdir().unwrap();
        drop(finished(directory.path()));
        let files = shards(directory.path());
        let bytes: Vec<Vec<u8>> = files.iter().map(|file| fs::read(file).unwrap()).collect();
        for (file, &other) in files.iter().zip(&order) {
            fs::write(file, &bytes[other]).unwrap();
        }
        let moved: BTreeSet<PathBuf> =
            (0..files.len()).filter(|&place| order[place] != place).map(|place| files[place].clone()).collect();

        let report = verify(directory.path()).unwrap();
        let found: BTreeSet<PathBuf> = report.problems.iter().map(|problem| problem.file.clone()).collect();
        prop_assert_eq!(&found, &moved);
        let store = open(directory.path());
        let (named, lost) = warned(store.warnings());
        prop_assert_eq!(&named, &moved);
        let missing = chains(&output()).concat().iter().filter(|entry| store.holds(entry.id).is_none()).count();
        prop_assert_eq!(missing, lost, "the cases of the others stay");
        drop(store);
        prop_assert_eq!(resume(directory.path()), moved.len());
        prop_assert!(published_bytes(directory.path()) == reference());
        prop_assert!(verify(directory.path()).unwrap().is_sound());
    }
}
