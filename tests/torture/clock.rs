//! Clocks that are wrong, by Debian's libfaketime.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;
use std::time::SystemTime;

use tempfile::NamedTempFile;

use crate::torture::place::{Place, Run};
use crate::torture::random::Random;
use crate::torture::witness::{assert_ended, assert_kept};

/// Seconds.
const YEAR: u64 = 365 * 86_400;

/// What a clock does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// It is off by years: what comes after or before it has another one.
    Off(&'static str),
    /// It is set back by years while the run is at work.
    SetBack,
}

/// Clocks, and how to call them.
pub const CLOCKS: [(Clock, &str); 4] = [
    (Clock::SetBack, "set back at work"),
    (Clock::Off("+3y"), "years ahead"),
    (Clock::Off("-3y"), "years behind"),
    (Clock::Off("-70y"), "before 1970"),
];

/// Runs the sweep by a wrong clock.
pub fn wrong(place: &Place, random: &mut Random) -> &'static str {
    let (clock, name) = *random.pick(&CLOCKS);
    let (threads, killed) = (random.threads(), random.below(2) == 0);
    run_by(place, clock, threads, killed);
    name
}

/// Runs the sweep by this clock, to its end or until it is killed.
pub fn run_by(place: &Place, clock: Clock, threads: usize, killed: bool) {
    let (before, starts) = (place.cases(), place.stored().starts.len());
    let mut command = place.command(threads);
    let file = NamedTempFile::with_prefix("stribeck-clock-").expect("a temporary file");
    match clock {
        Clock::Off(time) => drop(by(&mut command).env("FAKETIME", time)),
        Clock::SetBack => {
            set(file.path(), "+0");
            by(&mut command).env("FAKETIME_TIMESTAMP_FILE", file.path()).env("FAKETIME_NO_CACHE", "1");
        }
    }
    let mut run = Run::start(command);
    if clock == Clock::SetBack {
        run.wait_for_commits(place, 1);
        set(file.path(), "-3y");
    }
    // The next commit may have looked at the clock before it was set, the one after it has not.
    let in_time = killed && run.wait_for_commits(place, 2);
    if killed {
        run.kill();
        run.end();
    } else {
        assert_ended(place, &run.end());
    }
    assert_kept(&before, &place.cases());
    if let Some(start) = place.stored().starts.get(starts) {
        let (first, last) = (start.times[0], start.times[start.times.len() - 1]);
        let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).expect("after 1970").as_secs();
        match clock {
            Clock::Off(_) => assert!(now.abs_diff(first) > YEAR, "it ran by another clock: {first}, {now}"),
            Clock::SetBack => assert!(!in_time || last + YEAR < first, "its clock was set back: {first}, {last}"),
        }
    }
}

fn set(file: &Path, time: &str) {
    fs::write(file, time).expect("written");
}

/// Lets a command have another time of day. Spans of time are measured as ever: that clock cannot be set.
fn by(command: &mut Command) -> &mut Command {
    command.env("LD_PRELOAD", library()).env("DONT_FAKE_MONOTONIC", "1")
}

/// The library, as the command `faketime` loads it.
fn library() -> &'static str {
    static LIBRARY: OnceLock<String> = OnceLock::new();
    LIBRARY.get_or_init(|| {
        let asked = Command::new("faketime").args(["-f", "+0", "sh", "-c", "printf %s \"$LD_PRELOAD\""]).output();
        let asked = asked.expect("`faketime` runs; `scripts/prerequisites --tests` installs it");
        String::from_utf8(asked.stdout).expect("text")
    })
}
