//! A results directory that is copied, and resumed elsewhere.

use std::fs;

use crate::torture::place::Place;
use crate::torture::random::Random;
use crate::torture::stored::logs;
use crate::torture::witness::assert_kept;

/// The place becomes a copy of itself, made while a run is at work there or not.
pub fn copied(place: &mut Place, random: &mut Random) -> &'static str {
    if random.below(2) == 0 {
        go_on_elsewhere(place, place.copy());
        "of a directory at rest"
    } else {
        go_on_elsewhere(place, snapshot(place, random));
        "of a directory at work"
    }
}

/// The place becomes the copy, with a lock that names a process of another machine. What is not to be changed cannot be
/// changed there.
pub fn go_on_elsewhere(place: &mut Place, copy: Place) {
    let results = copy.results();
    if results.is_dir() {
        fs::write(results.join("lock"), "process 1\n").expect("written");
    }
    for (_, log) in logs(&results) {
        make_read_only(&log);
    }
    for shard in copy.stored().sound_files() {
        make_read_only(&results.join("shards").join(shard));
    }
    *place = copy;
}

/// A copy of a directory in which a run is at work: all that was committed before it is in it.
pub fn snapshot(place: &Place, random: &mut Random) -> Place {
    let mut run = place.start(random.threads());
    run.wait_for_commits(place, 1 + random.below(3));
    let before = place.cases();
    let copy = place.copy();
    run.kill();
    run.end();
    assert_kept(&before, &copy.cases());
    copy
}

fn make_read_only(path: &std::path::Path) {
    let mut permissions = fs::metadata(path).expect("there").permissions();
    permissions.set_readonly(true);
    fs::set_permissions(path, permissions).expect("set");
}
