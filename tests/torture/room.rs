//! Disks that take no more: full ones, read-only ones, and a limit to the size of files.

use std::fs;
use std::ops::ControlFlow;
use std::process::Command;

use crate::torture::disk::{Disk, Room};
use crate::torture::place::{End, Place, Run};
use crate::torture::random::Random;
use crate::torture::sweep::SAME_IN_EVERY_RUN;
use crate::torture::witness::{
    assert_complete, assert_completes, assert_ended, assert_kept, assert_resumable, assert_told,
};

/// How it comes out where nothing was short.
const ENOUGH: &str = "there was room enough";

/// The place is brought to a disk that has only so much room left, is run there, and again when there is room.
pub fn full_disk(place: &mut Place, random: &mut Random) -> &'static str {
    let disk = Disk::new();
    let there = place.copy_to(disk.path());
    // Up to more than the sweep takes, and as often little as much.
    let room = if random.below(4) == 0 { Room::Files(random.octave(4.0)) } else { Room::Pages(random.octave(10.5)) };
    let how = fill_and_run(&there, &disk, room, random.threads());
    // From here it goes on in the directory that ran out of room.
    *place = there.copy();
    assert_completes(&there, random.threads());
    match how {
        ControlFlow::Break(file) => file,
        ControlFlow::Continue(()) => ENOUGH,
    }
}

/// Runs the sweep on a disk with only so much room left, and makes room again.
pub fn fill_and_run(place: &Place, disk: &Disk, room: Room, threads: usize) -> ControlFlow<&'static str> {
    disk.leave(room);
    let how = without_room(place, place.start(threads), threads, "o space left on ");
    disk.make_room();
    how
}

/// No file may be larger than some number of blocks.
pub fn file_size_limit(place: &Place, random: &mut Random) -> &'static str {
    match limited(place, random.octave(12.0), random.threads()) {
        ControlFlow::Break(file) => file,
        ControlFlow::Continue(()) => ENOUGH,
    }
}

/// Runs the sweep with no file larger than so many blocks of 512 bytes.
pub fn limited(place: &Place, blocks: u64, threads: usize) -> ControlFlow<&'static str> {
    let run = place.command(threads);
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("ulimit -f {blocks}; exec \"$0\" \"$@\"")]).arg(run.get_program());
    shell.args(run.get_args()).current_dir(run.get_current_dir().expect("given"));
    without_room(place, Run::start(shell), threads, "ile too large")
}

/// The place is brought to a disk, which is then read-only.
pub fn read_only(place: &Place, random: &mut Random) -> &'static str {
    let mut disk = Disk::new();
    let there = place.copy_to(disk.path());
    disk.set_read_only(true);
    let before = there.cases();
    let end = there.run(random.threads());
    assert_eq!(end.code, Some(4), "{}{}", end.out, end.err);
    assert!(end.err.starts_with("error: cannot ") && end.err.contains(" out"), "{}", end.err);
    let remedy = "Read-only file system (os error 30); check who may write there, or choose another directory with -o";
    assert!(end.err.contains(remedy), "{}", end.err);
    assert_told(&there);
    assert_eq!(there.cases(), before);
    disk.set_read_only(false);
    assert_completes(&there, random.threads());
    if before.is_empty() { "of nothing" } else { "of stored cases" }
}

/// Lets a run go that may find no room. If it does, it says which file it could not write and why, what is saved and
/// what is not, and how to go on; returns what kind of write it was.
fn without_room(place: &Place, run: Run, threads: usize, why: &str) -> ControlFlow<&'static str> {
    let before = place.cases();
    let end = run.end();
    assert_kept(&before, &place.cases());
    if end.code != Some(4) {
        assert_ended(place, &end);
        assert_complete(place);
        return ControlFlow::Continue(());
    }
    assert!(end.err.contains(why), "{why}: {}", end.err);
    assert_told(place);
    let kind = kind_of_write(place, &end);
    if OPENING.contains(&kind) {
        // What is there has not been looked at yet.
        let kept = "run the same command again: all that was committed is kept";
        assert!(end.err.contains(kept), "{}", end.err);
    } else {
        assert_resumable(place, &end, threads);
    }
    ControlFlow::Break(kind)
}

/// Writes that take a directory for a run, before anything else.
const OPENING: [&str; 5] = ["directory", "directory log", "directory shards", "lock", "sweep.toml"];

/// Which kind of write failed, by the file that the error names.
fn kind_of_write(place: &Place, end: &End) -> &'static str {
    let words = end.err.lines().find_map(|line| line.strip_prefix("error: cannot ")).expect("an error");
    if words.starts_with("create out: ") {
        return "directory";
    }
    let (action, file) = words.split_once(" out/").unwrap_or_else(|| panic!("a file of the results: {words}"));
    let file = file.split(": ").next().expect("a file").trim_start_matches('.').trim_end_matches(".stribeck-part");
    match (file.split_once('/'), file) {
        (_, "log") => "directory log",
        (_, "shards") => "directory shards",
        (_, "lock") => "lock",
        (_, "sweep.toml") => "sweep.toml",
        (_, "results.h5") => "results.h5",
        (_, "summary.csv") => "summary.csv",
        (_, "timings.csv") => "timings.csv",
        (Some(("shards", _)), _) => "shard",
        (Some(("log", _)), _) => kind_of_record(place, action),
        _ => panic!("no file of the results: {words}"),
    }
}

/// Which record could not be written, by what is there: a log is made with its first record.
fn kind_of_record(place: &Place, action: &str) -> &'static str {
    let stored = place.stored();
    let results = place.results();
    let published = SAME_IN_EVERY_RUN.into_iter().zip(&place.sweep.undisturbed().bytes);
    let shards = fs::read_dir(results.join("shards")).expect("listed").count();
    if place.is_solved() {
        let mut published =
            published.map(|(name, bytes)| fs::read(results.join(name)).is_ok_and(|held| held == *bytes));
        return if published.all(|same| same) { "record of the publication" } else { "record of the end" };
    }
    match stored.starts.last() {
        _ if action == "create" => "new log",
        Some(start) if start.beginning.is_none() => "first record",
        _ if shards > stored.sound_files().len() => "record of a shard",
        _ => "record of the end",
    }
}
