//! Nothing is lost, and nothing is silently wrong, whatever happens to the processes, the disk and the files of a
//! sweep.
//!
//! Real processes of the program work on real directories. After each fault an independent reader of the log and the
//! shards says what must be there; `status` and `plan` must say the same; one more run must complete the sweep, and
//! publish the bytes of an undisturbed run.

mod clock;
mod company;
mod copies;
mod damage;
mod disk;
mod faults;
pub(crate) mod place;
pub(crate) mod random;
mod room;
mod rounds;
mod stops;
pub(crate) mod stored;
mod sweep;
mod witness;

use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::ops::ControlFlow;

use clock::CLOCKS;
use company::First;
use disk::{Disk, Room};
use faults::Fault;
use place::Place;
use random::Random;
use rounds::{table, torture};
use stops::Moment;
use stored::logs;
use sweep::Sweep;
use witness::{assert_completes, assert_told};

/// Far more than it takes until a fault came out in all its ways.
const MOST_STRIKES: usize = 30;

/// A sweep that was killed after some commits.
fn half_done(sweep: Sweep) -> Place {
    let place = Place::fresh(sweep);
    let mut run = place.start(1);
    run.wait_for_commits(&place, 2);
    run.kill();
    run.end();
    place
}

/// A sweep that is solved and published.
fn finished(sweep: Sweep) -> Place {
    let place = Place::fresh(sweep);
    assert_completes(&place, 2);
    place
}

/// Strikes at a place until it came out in each of these ways. Each time the sweep is completed.
fn strike(fault: Fault, mut place: Place, ways: &[&str]) {
    let mut random = Random::new(2026, fault as u64);
    let mut missing = BTreeSet::from_iter(ways);
    for _ in 0..MOST_STRIKES {
        if missing.is_empty() {
            break;
        }
        missing.remove(&fault.strike(&mut place, &mut random));
        assert_completes(&place, 2);
    }
    assert!(missing.is_empty(), "{missing:?} did not come up");
}

/// Stops runs of a sweep at each kind of moment, the first one in its midst, and completes it.
fn stop(sweep: Sweep, stop: impl Fn(&Place, Moment, &mut Random) -> &'static str) {
    // On a busy machine a run may be over before it is stopped.
    let in_its_midst = |seed: usize| {
        let (place, mut random) = (Place::fresh(sweep), Random::new(2026, seed as u64));
        let first = stop(&place, Moment::Commits { number: 1, later: 0.0 }, &mut random);
        (first == "between commits").then_some((place, random))
    };
    let (place, mut random) = (0..3).find_map(in_its_midst).expect("a run is stopped between commits");
    assert_told(&place);
    let (start, publishing) = (Moment::Start { later: 0.01 }, Moment::Publishing { later: 0.0 });
    for moment in [start, Moment::Commits { number: 1, later: 0.05 }, publishing] {
        stop(&place, moment, &mut random);
        assert_told(&place);
    }
    assert_completes(&place, 2);
}

#[test]
fn a_run_killed_at_any_moment_loses_no_committed_case() {
    stop(Sweep::Converging, stops::kill);
}

#[test]
fn a_signal_stops_a_run_which_says_what_is_saved_and_how_to_go_on() {
    stop(Sweep::Failing, stops::signal);
}

#[test]
fn a_second_signal_ends_a_run_at_once_and_loses_no_committed_case() {
    stop(Sweep::Converging, stops::two_signals);
}

#[test]
fn of_two_runs_at_once_one_works() {
    company::at_once(&Place::fresh(Sweep::Converging), [1, 2]);
}

#[test]
fn a_second_run_is_refused_and_told_who_works_there() {
    let way = company::refused(&Place::fresh(Sweep::Failing), [1, 2], First::Completes);
    assert_ne!(way, stops::TOO_LATE);
}

#[test]
fn the_lock_of_a_dead_owner_needs_no_unlocking() {
    let place = Place::fresh(Sweep::Converging);
    let way = company::refused(&place, [1, 1], First::IsKilled);
    assert_ne!(way, stops::TOO_LATE);
    assert_completes(&place, 2);
}

/// Runs a sweep on ever larger disks, each from the beginning, until there is room enough. Each time it is completed
/// when there is more room. Returns the kinds of writes that found no room.
fn on_ever_larger_disks(room: impl Fn(u64) -> Room, prepare: impl Fn(&Disk) -> Place) -> BTreeSet<&'static str> {
    let mut kinds = BTreeSet::new();
    for number in 0.. {
        let disk = Disk::new();
        let place = prepare(&disk);
        match room::fill_and_run(&place, &disk, room(number), 1) {
            ControlFlow::Break(kind) => kinds.insert(kind),
            ControlFlow::Continue(()) => break,
        };
        assert_told(&place);
        assert_completes(&place, 2);
    }
    println!("no room for: {kinds:?}");
    kinds
}

fn kinds<const N: usize>(kinds: [&'static str; N]) -> BTreeSet<&'static str> {
    kinds.into()
}

#[test]
fn a_disk_may_be_full_at_any_write() {
    let contents = kinds(["lock", "sweep.toml", "first record", "shard", "record of a shard"]);
    let published = kinds(["results.h5", "summary.csv", "timings.csv"]);
    let mut found = BTreeSet::new();
    // How many shards a run writes depends on its time, and with it at which size of the disk their records do.
    for _ in 0..3 {
        found.extend(on_ever_larger_disks(Room::Pages, |disk| Place::fresh_in(disk.path(), Sweep::Small)));
        if found.is_superset(&contents) && found.is_superset(&published) {
            return;
        }
    }
    panic!("{found:?}");
}

#[test]
fn a_disk_may_take_no_more_files_at_any_write() {
    let fresh = |disk: &Disk| Place::fresh_in(disk.path(), Sweep::Small);
    let found = on_ever_larger_disks(Room::Files, fresh);
    let names = ["directory log", "directory shards", "lock", "sweep.toml", "new log", "shard"];
    let published = ["results.h5", "summary.csv", "timings.csv"];
    assert!(found.is_superset(&kinds(names)) && found.is_superset(&kinds(published)), "{found:?}");
}

#[test]
fn a_disk_may_be_full_when_the_publication_is_recorded() {
    // Solved and not published: the record of the publication is the first of its log, and needs a page.
    let solved = finished(Sweep::Small);
    for name in ["results.h5", "summary.csv", "timings.csv"] {
        fs::remove_file(solved.results().join(name)).expect("removed");
    }
    let found = on_ever_larger_disks(Room::Pages, |disk| solved.copy_to(disk.path()));
    assert!(found.contains("record of the publication"), "{found:?}");
}

#[test]
fn a_limit_to_the_size_of_files_is_an_error_as_a_full_disk_is() {
    let mut found = BTreeSet::new();
    for blocks in [0, 1, 2, 4, 8, 16, 32, 64, 128, 1000] {
        let place = Place::fresh(Sweep::Small);
        if let ControlFlow::Break(kind) = room::limited(&place, blocks, 1) {
            found.insert(kind);
        }
        assert_completes(&place, 2);
    }
    println!("too large: {found:?}");
    assert!(found.is_superset(&kinds(["lock", "shard", "results.h5"])), "{found:?}");
}

#[test]
fn a_read_only_directory_is_left_alone_and_told_of() {
    let mut random = Random::new(2026, 0);
    for place in [Place::fresh(Sweep::Small), half_done(Sweep::Converging), finished(Sweep::Small)] {
        room::read_only(&place, &mut random);
    }
}

#[test]
fn clocks_do_not_matter() {
    let place = Place::fresh(Sweep::Converging);
    for (clock, _) in CLOCKS {
        clock::run_by(&place, clock, 1, true);
        assert_told(&place);
    }
    assert_completes(&place, 2);
}

#[test]
fn a_copied_directory_goes_on_where_it_was() {
    let mut place = half_done(Sweep::Failing);
    let snapshot = copies::snapshot(&place, &mut Random::new(2026, 0));
    for copy in [snapshot, place.copy()] {
        copies::go_on_elsewhere(&mut place, copy);
        assert_told(&place);
        assert_completes(&place, 2);
    }
}

#[test]
fn a_truncated_shard_costs_its_cases_and_no_others() {
    strike(Fault::TruncatedShard, finished(Sweep::Converging), &["some of them"]);
}

#[test]
fn a_flipped_byte_costs_the_cases_of_its_shard_and_no_others() {
    strike(Fault::FlippedByte, half_done(Sweep::Converging), &["some of them"]);
}

#[test]
fn a_deleted_shard_costs_its_cases_and_no_others() {
    strike(Fault::DeletedShard, finished(Sweep::Failing), &["some of them"]);
}

#[test]
fn a_shard_that_comes_back_as_it_was_counts_as_published() {
    // A single shard: it comes back under its name, with its bytes.
    let place = finished(Sweep::Small);
    for shard in place.stored().sound_files() {
        fs::remove_file(place.results().join("shards").join(shard)).expect("removed");
    }
    assert_completes(&place, 1);
}

#[test]
fn a_shard_of_another_sweep_is_never_used() {
    let place = finished(Sweep::Failing);
    let mut random = Random::new(2026, 0);
    for with_record in [false, true] {
        damage::beside(&place, &mut random, with_record);
        assert_told(&place);
        assert_completes(&place, 1);
    }
    damage::to_shards(&place, &mut random, damage::replace);
    assert_told(&place);
    assert_completes(&place, 2);
}

#[test]
fn a_torn_line_of_the_log_costs_its_cases_and_no_others() {
    strike(Fault::TornLine, half_done(Sweep::Converging), &["of a shard"]);
}

#[test]
fn a_damaged_line_of_the_log_costs_its_cases_and_no_others() {
    strike(Fault::DamagedLine, finished(Sweep::Failing), &["of a shard", "of no shard"]);
}

#[test]
fn damaged_lines_that_follow_each_other_are_told_together_and_others_apart() {
    let place = finished(Sweep::Failing);
    let (_, log) = logs(&place.results()).remove(0);
    let sound = fs::read_to_string(&log).expect("read");
    let lines: Vec<&str> = sound.lines().collect();
    assert!(lines.len() >= 4, "a start, shards, an end and a publication");
    // Which lines are harmed, and in how many warnings that is told.
    for (harmed, warnings) in [(&[0, 1][..], 1), (&[1, 2, 3], 1), (&[0, 2, 3], 2), (&[0, 2], 2)] {
        let harm =
            |(i, line): (usize, &&str)| if harmed.contains(&i) { line.to_uppercase() } else { (*line).to_owned() };
        let content: Vec<String> = lines.iter().enumerate().map(harm).collect();
        fs::write(&log, content.join("\n") + "\n").expect("written");
        assert_eq!(assert_told(&place).damaged.len(), harmed.len());
        let status = place.say(&["status", "out"]);
        assert_eq!(crate::program::err(&status).lines().count(), warnings, "{}", crate::program::err(&status));
    }
    assert_completes(&place, 1);
}

#[test]
fn some_faults_after_another_do_no_more_harm() {
    torture(4, 2026, |line| println!("{line}"));
}

/// The long form. `scripts/torture` says how many rounds, and from which seed.
#[test]
#[ignore = "slow: rounds of faults, 10 or as many as STRIBECK_TORTURE_ROUNDS says"]
fn any_faults_after_another_do_no_more_harm() {
    let number = |name: &str, otherwise| match env::var(name) {
        Ok(text) => text.parse().unwrap_or_else(|_| panic!("{name} is not a number: {text}")),
        Err(_) => otherwise,
    };
    let (rounds, seed) = (number("STRIBECK_TORTURE_ROUNDS", 10), number("STRIBECK_TORTURE_SEED", 1));
    assert!(rounds > 0, "no round tests nothing");
    println!("{rounds} rounds, seed {seed}");
    let counts = torture(rounds, seed, |line| println!("{line}"));
    println!("\nall {rounds} rounds passed, seed {seed}\n\n{}", table(&counts));
}
