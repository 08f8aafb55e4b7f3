//! How far a fit is, and when its time is up.

use std::cell::Cell;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle as BarStyle};

use super::console;
use crate::format::count;
use stribeck_lab::{Unknown, Watch};
use stribeck_solver::Interrupt;
use stribeck_sweep::engine::ProgressStyle;

/// Time before the first line, where lines are printed; it doubles up to a minute.
const FIRST_LINE: Duration = Duration::from_secs(2);
const LONGEST: Duration = Duration::from_secs(60);

/// Does some work that is ended when the time is up, and shows how far it is: on a terminal while it goes on, elsewhere
/// in a line now and then.
pub fn watched<T>(unknowns: &[Unknown], limit: Option<Duration>, work: impl FnOnce(&Watch<'_>) -> T) -> T {
    let interrupt = Interrupt::new();
    let spinner = match ProgressStyle::detect(false) {
        ProgressStyle::Bar => Some(spinner()),
        ProgressStyle::Lines | ProgressStyle::Quiet => None,
    };
    let (started, next) = (Instant::now(), Cell::new(FIRST_LINE));
    let evaluated = |evaluations: usize, best: &[f64]| {
        let values = unknowns.iter().zip(best).map(|(unknown, value)| format!("{} = {value:.3e}", unknown.name()));
        let line = format!("solved {}, {}", count(evaluations as u64, "time"), values.collect::<Vec<_>>().join(", "));
        match &spinner {
            Some(spinner) => spinner.set_message(line),
            None if started.elapsed() >= next.get() => {
                console::tell(&line);
                next.set(started.elapsed() + next.get().min(LONGEST));
            }
            None => {}
        }
    };
    let result = thread::scope(|scope| {
        let (done, ended) = channel::<()>();
        if let Some(limit) = limit {
            let interrupt = &interrupt;
            scope.spawn(move || {
                if ended.recv_timeout(limit) == Err(RecvTimeoutError::Timeout) {
                    interrupt.request();
                }
            });
        }
        let result = work(&Watch { interrupt: &interrupt, evaluated: &evaluated });
        drop(done);
        result
    });
    if let Some(spinner) = spinner {
        spinner.finish_and_clear();
    }
    result
}

fn spinner() -> ProgressBar {
    let style = BarStyle::with_template("{spinner} {elapsed} {msg}").expect("the template is valid");
    let spinner = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr()).with_style(style);
    spinner.enable_steady_tick(Duration::from_millis(250));
    spinner
}

/// A time as in `90`, `90s`, `10m` or `1.5h`.
pub fn time_limit(text: &str) -> Result<Duration, String> {
    let text = text.trim();
    let end = text.find(|c: char| c.is_alphabetic()).unwrap_or(text.len());
    let seconds = match text[end..].trim() {
        "" | "s" => 1.0,
        "m" | "min" => 60.0,
        "h" => 3600.0,
        _ => f64::NAN,
    } * text[..end].trim().parse::<f64>().unwrap_or(f64::NAN);
    match Duration::try_from_secs_f64(seconds) {
        Ok(limit) if seconds > 0.0 => Ok(limit),
        _ => Err("write a time as in 90s, 10m or 1.5h".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_units_or_are_seconds() {
        for (text, seconds) in [("90", 90.0), ("90s", 90.0), ("10m", 600.0), ("10 min", 600.0), ("1.5h", 5400.0)] {
            assert_eq!(time_limit(text), Ok(Duration::from_secs_f64(seconds)), "{text}");
        }
        assert!(["", "0", "-1s", "nan", "10 d", "s", "1e300h"].into_iter().all(|text| time_limit(text).is_err()));
    }

    #[test]
    fn work_ends_when_its_time_is_up() {
        let limit = Some(Duration::from_millis(10));
        let ended = watched(&[], limit, |watch| {
            while !watch.interrupt.requested() {
                thread::yield_now();
            }
            true
        });
        assert!(ended && watched(&[], None, |watch| !watch.interrupt.requested()));
    }
}
