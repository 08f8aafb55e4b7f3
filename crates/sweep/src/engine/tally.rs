//! How far a run is, in words.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::HumanDuration;

/// Counts of cases, shared between the threads that count and the one that shows.
#[derive(Debug)]
pub(super) struct Tally {
    total: u64,
    noun: &'static str,
    converged: AtomicU64,
    failed: AtomicU64,
    start: Instant,
}

impl Tally {
    /// Of `total` cases, or whatever else `noun` says in the plural, none is done.
    pub(super) fn new(total: u64, noun: &'static str) -> Self {
        Self { total, noun, converged: AtomicU64::new(0), failed: AtomicU64::new(0), start: Instant::now() }
    }

    /// Adds one case.
    pub(super) fn count(&self, converged: bool) {
        let counter = if converged { &self.converged } else { &self.failed };
        counter.fetch_add(1, Ordering::Relaxed);
    }

    /// What to show now, for instance `12 of 100 cases, 1 failed, 2.4 per second, 37 seconds left`.
    pub(super) fn line(&self) -> String {
        let (converged, failed) = (self.converged.load(Ordering::Relaxed), self.failed.load(Ordering::Relaxed));
        line(self.total, self.noun, converged, failed, self.start.elapsed())
    }
}

fn line(total: u64, noun: &str, converged: u64, failed: u64, elapsed: Duration) -> String {
    let done = converged + failed;
    let mut text = format!("{done} of {total} {noun}");
    if failed > 0 {
        text += &format!(", {failed} failed");
    }
    if done > 0 && !elapsed.is_zero() {
        // The mean over the whole run: chains finish in lumps, a rate of the last seconds would jump about.
        let per_second = done as f64 / elapsed.as_secs_f64();
        text += &format!(", {}", rate(per_second));
        if done < total {
            let left = Duration::try_from_secs_f64((total - done) as f64 / per_second).unwrap_or(Duration::MAX);
            text += &format!(", {} left", HumanDuration(left));
        }
    }
    text
}

/// A rate in the unit in which it is about 1 or more: `2.4 per second`, `3.0 per minute`.
pub fn rate(per_second: f64) -> String {
    let units = [(1.0, "second"), (60.0, "minute")];
    match units.into_iter().find(|(seconds, _)| per_second * seconds >= 1.0) {
        Some((seconds, unit)) => format!("{:.1} per {unit}", per_second * seconds),
        None => format!("{:.1} per hour", per_second * 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_done_promises_nothing() {
        assert_eq!(line(100, "cases", 0, 0, Duration::from_secs(10)), "0 of 100 cases");
        assert_eq!(line(100, "cases", 3, 0, Duration::ZERO), "3 of 100 cases");
    }

    #[test]
    fn failures_count_as_done() {
        assert_eq!(
            line(100, "cases", 15, 5, Duration::from_secs(10)),
            "20 of 100 cases, 5 failed, 2.0 per second, 40 seconds left"
        );
    }

    #[test]
    fn a_finished_run_has_no_time_left() {
        assert_eq!(line(20, "rows", 20, 0, Duration::from_secs(10)), "20 of 20 rows, 2.0 per second");
    }

    #[test]
    fn slow_rates_are_told_in_minutes_and_hours() {
        assert_eq!(rate(0.05), "3.0 per minute");
        assert_eq!(rate(0.001), "3.6 per hour");
    }
}
