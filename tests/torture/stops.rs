//! Runs that are killed, or asked to stop, at a random moment from their start to their end.

use std::thread::sleep;
use std::time::Duration;

use crate::torture::place::{Place, Run};
use crate::torture::random::Random;
use crate::torture::witness::{assert_ended, assert_kept, assert_resumable};

/// The word for a run that had ended when it was to be stopped.
pub const TOO_LATE: &str = "too late";

/// `kill -9`.
pub fn kill(place: &Place, moment: Moment, random: &mut Random) -> &'static str {
    let (before, commits) = (place.cases(), place.commits());
    let mut run = place.start(random.threads());
    moment.wait(place, &mut run);
    run.kill();
    let end = run.end();
    assert_kept(&before, &place.cases());
    if end.code.is_some() {
        assert_ended(place, &end);
        return TOO_LATE;
    }
    part_of_run(place, commits)
}

/// SIGINT, SIGTERM or SIGHUP asks a run to stop: it stores what is finished, says how to go on, and ends with 130.
pub fn signal(place: &Place, moment: Moment, random: &mut Random) -> &'static str {
    let (before, commits, starts) = (place.cases(), place.commits(), place.stored().starts.len());
    let threads = random.threads();
    let mut run = place.start(threads);
    moment.wait(place, &mut run);
    let name = random.pick(&["INT", "TERM", "HUP"]);
    let in_time = run.signal(name);
    let end = run.end();
    assert_kept(&before, &place.cases());
    match end.code {
        Some(130) => {
            assert!(end.err.contains(&format!("interrupted by SIG{name}: ")), "{}", end.err);
            assert_resumable(place, &end, threads);
            let last = place.stored().starts.pop().expect("a start");
            assert_eq!(last.ending.as_deref(), Some("interrupted"));
        }
        // Publishing is not interrupted.
        Some(_) => {
            assert_ended(place, &end);
            return if in_time { "while publishing, which it completes" } else { TOO_LATE };
        }
        // Before it watches for signals they end it as they end any program.
        None => assert_eq!(place.stored().starts.len(), starts, "a run that has begun answers to signals"),
    }
    part_of_run(place, commits)
}

/// A second signal ends a run at once.
pub fn two_signals(place: &Place, moment: Moment, random: &mut Random) -> &'static str {
    let (before, commits, starts) = (place.cases(), place.commits(), place.stored().starts.len());
    let mut run = place.start(random.threads());
    moment.wait(place, &mut run);
    for _ in 0..2 {
        run.signal(random.pick::<&str>(&["INT", "TERM"]));
        sleep(Duration::from_micros(random.below(2000) as u64));
    }
    let end = run.end();
    assert_kept(&before, &place.cases());
    match end.code {
        Some(130) => part_of_run(place, commits),
        Some(_) => {
            assert_ended(place, &end);
            TOO_LATE
        }
        None => {
            assert_eq!(place.stored().starts.len(), starts, "a run that has begun answers to signals");
            part_of_run(place, commits)
        }
    }
}

/// A moment of a run. Parts are of the time that a whole run takes; no check depends on how long that is.
#[derive(Clone, Copy, Debug)]
pub enum Moment {
    /// So long after its start.
    Start { later: f64 },
    /// So long after so many commits.
    Commits { number: usize, later: f64 },
    /// So long after it began to publish.
    Publishing { later: f64 },
}

impl Moment {
    /// Any moment, those where something is written more often.
    pub fn any(random: &mut Random) -> Self {
        match random.below(3) {
            // The square: more of them early, where a run starts up.
            0 => Self::Start { later: 1.1 * random.part().powi(2) },
            1 => Self::Commits { number: 1 + random.below(2), later: random.part() / 10.0 },
            _ => Self::Publishing { later: random.part() / 8.0 },
        }
    }

    /// Waits for it, or for the end of the run.
    fn wait(self, place: &Place, run: &mut Run) {
        let later = match self {
            Self::Start { later } => later,
            Self::Commits { number, later } => {
                run.wait_for_commits(place, number);
                later
            }
            Self::Publishing { later } => {
                let file = place.results().join(".results.h5.stribeck-part");
                run.wait_until(|| file.exists());
                later
            }
        };
        sleep(place.sweep.undisturbed().duration.mul_f64(later));
    }
}

/// Where a run was when it was stopped.
fn part_of_run(place: &Place, commits_before: usize) -> &'static str {
    match place.commits() - commits_before {
        _ if place.is_solved() => "while publishing",
        0 => "before the first commit",
        _ => "between commits",
    }
}
