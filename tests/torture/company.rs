//! Two runs in one directory: one of them works.

use std::fs;

use crate::torture::place::{Place, Run};
use crate::torture::random::Random;
use crate::torture::stops::TOO_LATE;
use crate::torture::witness::{
    assert_complete, assert_ended, assert_kept, assert_refused, assert_told, assert_told_of,
};

/// A second run at the same moment as the first, or while the first is at work.
pub fn second_run(place: &Place, random: &mut Random) -> &'static str {
    let before = place.cases();
    let threads = [(); 2].map(|()| random.threads());
    let how = match random.below(3) {
        0 => at_once(place, threads),
        1 => refused(place, threads, First::Completes),
        _ => refused(place, threads, First::IsKilled),
    };
    assert_kept(&before, &place.cases());
    how
}

/// Two runs start at the same moment: one works, the other is refused or comes when all is done.
pub fn at_once(place: &Place, threads: [usize; 2]) -> &'static str {
    let mut runs = threads.map(|threads| place.start(threads));
    let ids = runs.each_mut().map(Run::id);
    let ends = runs.map(Run::end);
    let how = match ends.iter().position(|end| end.code == Some(4)) {
        Some(loser) => {
            assert_refused(&ends[loser], ids[1 - loser]);
            assert_ended(place, &ends[1 - loser]);
            "at once, one refused"
        }
        None => {
            ends.iter().for_each(|end| assert_ended(place, end));
            "at once, one after the other"
        }
    };
    assert_complete(place);
    how
}

/// What becomes of a first run after it has refused a second one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum First {
    Completes,
    IsKilled,
}

/// A second run is refused by a first one, which then completes or is killed.
pub fn refused(place: &Place, threads: [usize; 2], then: First) -> &'static str {
    let mut first = place.start(threads[0]);
    first.wait_for_commits(place, 1);
    // It keeps its lock and cannot end while it is looked at.
    if !first.halt() {
        assert_ended(place, &first.end());
        return TOO_LATE;
    }
    let owner = first.id();
    assert_refused(&place.run(threads[1]), owner);
    assert_told_of(place, Some(owner));
    match then {
        First::Completes => {
            first.go_on();
            assert_ended(place, &first.end());
            assert_complete(place);
            "refused, the owner completes"
        }
        First::IsKilled => {
            first.kill();
            first.end();
            let lock = fs::read_to_string(place.results().join("lock")).expect("a lock");
            assert_eq!(lock, format!("process {owner}\n"), "it still names its dead owner");
            assert_told(place);
            "refused, the owner is killed"
        }
    }
}
