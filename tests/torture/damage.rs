//! Files that are not what they were.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::torture::place::Place;
use crate::torture::random::Random;
use crate::torture::stored::{Commit, Line, logs};

/// The word for a fault that found nothing to harm.
const NOTHING: &str = "nothing there";

/// Harms some of the shards. Exactly the cases are lost that no sound shard holds.
pub fn to_shards(place: &Place, random: &mut Random, harm: impl Fn(&Place, &Path, &mut Random)) -> &'static str {
    let stored = place.stored();
    // What another sweep left here is not solved again by this one.
    let of_the_sweep = |commit: &&Commit| commit.sound && !place.of_the_sweep(commit.cases.clone()).is_empty();
    let files: BTreeSet<&String> = stored.commits.iter().filter(of_the_sweep).map(|commit| &commit.file).collect();
    if files.is_empty() {
        return NOTHING;
    }
    let (all, harmed) = (files.len(), random.some(files.into_iter().collect()));
    let contents = &place.sweep.undisturbed().contents;
    let left = place.of_the_sweep(stored.cases_without(contents, |commit| harmed.contains(&&commit.file)));
    for file in &harmed {
        harm(place, &place.results().join("shards").join(file), random);
    }
    assert_eq!(place.cases(), left);
    if harmed.len() == all { "all of them" } else { "some of them" }
}

pub fn truncate(_: &Place, shard: &Path, random: &mut Random) {
    let mut bytes = fs::read(shard).expect("a shard");
    bytes.truncate(random.below(bytes.len()));
    fs::write(shard, bytes).expect("written");
}

pub fn flip(_: &Place, shard: &Path, random: &mut Random) {
    let mut bytes = fs::read(shard).expect("a shard");
    let place = random.below(bytes.len());
    bytes[place] ^= 1 << random.below(8);
    fs::write(shard, bytes).expect("written");
}

pub fn delete(_: &Place, shard: &Path, _: &mut Random) {
    fs::remove_file(shard).expect("removed");
}

/// Puts a shard of another sweep in place of this one.
pub fn replace(place: &Place, shard: &Path, random: &mut Random) {
    let (_, foreign, _) = random.pick(&place.sweep.other().undisturbed().shards);
    fs::write(shard, foreign).expect("written");
}

/// A shard of another sweep, in place of one that is there, or beside them, alone or with its record.
pub fn by_a_foreign_shard(place: &Place, random: &mut Random) -> &'static str {
    match random.below(3) {
        0 => {
            to_shards(place, random, replace);
            "in place of others"
        }
        1 => beside(place, random, false),
        _ => beside(place, random, true),
    }
}

/// Puts a shard of another sweep beside those that are there. Nothing is lost and nothing is won.
pub fn beside(place: &Place, random: &mut Random, with_record: bool) -> &'static str {
    let results = place.results();
    let (name, bytes, line) = random.pick(&place.sweep.other().undisturbed().shards);
    if !results.join("shards").is_dir() {
        return NOTHING;
    }
    let before = place.cases();
    fs::write(results.join("shards").join(name), bytes).expect("written");
    if with_record {
        let number = logs(&results).last().map_or(1, |(last, _)| last + 1);
        fs::write(results.join(format!("log/{number:04}.jsonl")), format!("{line}\n")).expect("written");
    }
    assert_eq!(place.cases(), before);
    if with_record { "beside them, with its record" } else { "beside them" }
}

/// Cuts the last line of a log short, as a crash of the machine does.
pub fn tear_last_line(place: &Place, random: &mut Random) -> &'static str {
    to_a_line(place, random, true, |content, start, end, random| {
        content.truncate(start + 1 + random.below(end - start - 1));
    })
}

/// Changes a bit in any line of a log.
pub fn flip_in_a_line(place: &Place, random: &mut Random) -> &'static str {
    to_a_line(place, random, false, |content, start, end, random| {
        // The lower bits: the upper ones may make a capital of a hexadecimal digit, which means the same.
        content[start + random.below(end - start)] ^= 1 << random.below(5);
    })
}

/// Harms a line of a log. Exactly the cases of its record are lost, if no other shard holds them.
fn to_a_line(
    place: &Place,
    random: &mut Random,
    last: bool,
    harm: impl Fn(&mut Vec<u8>, usize, usize, &mut Random),
) -> &'static str {
    let stored = place.stored();
    let logs: Vec<_> =
        logs(&place.results()).into_iter().map(|(log, path)| (log, fs::read(&path).unwrap(), path)).collect();
    let logs: Vec<_> = logs.into_iter().filter(|(_, content, _)| content.len() > 2).collect();
    if logs.is_empty() {
        return NOTHING;
    }
    let (log, mut content, path) = random.pick(&logs).clone();
    let mut starts = vec![0];
    let inner = &content[..content.len() - 1];
    starts.extend(inner.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(place, _)| place + 1));
    let line = if last { starts.len() } else { 1 + random.below(starts.len()) };
    let start = starts[line - 1];
    let length = content[start..].iter().position(|&byte| byte == b'\n');
    let end = length.map_or(content.len(), |length| start + length);
    harm(&mut content, start, end, random);
    fs::write(path, content).expect("written");

    let harmed = Line { log, line };
    let recorded = stored.commits.iter().any(|commit| commit.place == harmed);
    let contents = &place.sweep.undisturbed().contents;
    let left = place.of_the_sweep(stored.cases_without(contents, |commit| commit.place == harmed));
    assert!(place.stored().damaged.contains(&harmed), "line {line} of log {log} is no record any more");
    assert_eq!(place.cases(), left);
    if recorded { "of a shard" } else { "of no shard" }
}
