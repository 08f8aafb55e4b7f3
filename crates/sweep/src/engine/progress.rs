//! What a user sees while a sweep runs: a bar on a terminal, now and then a line elsewhere. All of it on stderr.

use std::io::{self, IsTerminal, Write};
use std::iter;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, SyncSender, sync_channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle as BarStyle};

use super::tally::Tally;

/// How progress is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProgressStyle {
    /// A bar with rate, failures and time left.
    Bar,
    /// A line now and then: after 2 s, then after ever longer times up to 30 s, and a last one.
    Lines,
    /// Nothing.
    Quiet,
}

impl ProgressStyle {
    /// A bar if stderr is a terminal, lines if not; nothing if `quiet`.
    pub fn detect(quiet: bool) -> Self {
        match (quiet, io::stderr().is_terminal()) {
            (true, _) => Self::Quiet,
            (false, true) => Self::Bar,
            (false, false) => Self::Lines,
        }
    }
}

/// Counts cases and shows how far the run is, from [`Progress::start`] until it is dropped.
#[derive(Debug)]
pub struct Progress {
    tally: Arc<Tally>,
    display: Display,
}

#[derive(Debug)]
enum Display {
    Bar(ProgressBar),
    // Held for its `Drop`, which prints the last line.
    Lines { _lines: Lines },
    Quiet,
}

impl Progress {
    /// Starts to show the progress of a run of `total` cases, or whatever else `noun` says in the plural.
    ///
    /// # Errors
    /// What the system says if it refuses the thread that prints lines.
    pub fn start(total: u64, noun: &'static str, style: ProgressStyle) -> io::Result<Self> {
        let tally = Arc::new(Tally::new(total, noun));
        let display = match style {
            ProgressStyle::Bar => Display::Bar(bar(total, Arc::clone(&tally))),
            ProgressStyle::Lines => {
                Display::Lines { _lines: Lines::start(Arc::clone(&tally), io::stderr(), intervals())? }
            }
            ProgressStyle::Quiet => Display::Quiet,
        };
        Ok(Self { tally, display })
    }

    /// Counts one case as done. Any thread may call it.
    pub fn count_case(&self, converged: bool) {
        self.tally.count(converged);
        if let Display::Bar(bar) = &self.display {
            bar.inc(1);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Display::Bar(bar) = &self.display {
            bar.abandon(); // Leaves the bar on the screen as it is, also where the run was cut short.
            // What comes next begins a line of its own. A stderr that takes no line feed has no reader.
            let _ = writeln!(io::stderr());
        }
    }
}

fn bar(total: u64, tally: Arc<Tally>) -> ProgressBar {
    let style = BarStyle::with_template("{bar:30} {tally}")
        .expect("the template is valid")
        .with_key("tally", move |_: &indicatif::ProgressState, out: &mut dyn std::fmt::Write| {
            out.write_str(&tally.line()).expect("the line is written to memory");
        })
        .progress_chars("=> ");
    let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr()).with_style(style);
    bar.enable_steady_tick(Duration::from_millis(250));
    bar
}

/// Times between lines: 2 s, then doubling up to 30 s.
fn intervals() -> impl Iterator<Item = Duration> + Send {
    let longest = Duration::from_secs(30);
    iter::successors(Some(Duration::from_secs(2)), move |&last| Some((2 * last).min(longest)))
}

/// A thread that prints lines until dropped.
#[derive(Debug)]
struct Lines {
    /// Dropped to end the thread.
    stop: Option<SyncSender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Lines {
    fn start(
        tally: Arc<Tally>,
        mut out: impl Write + Send + 'static,
        intervals: impl Iterator<Item = Duration> + Send + 'static,
    ) -> io::Result<Self> {
        let (stop, stopped) = sync_channel::<()>(0);
        let print = move || {
            for interval in intervals {
                let end = stopped.recv_timeout(interval) == Err(RecvTimeoutError::Disconnected);
                if writeln!(out, "{}", tally.line()).is_err() || end {
                    return; // A stderr that takes no more lines has no reader, and is no reason to end the run.
                }
            }
        };
        let thread = thread::Builder::new().name("progress".to_owned()).spawn(print)?;
        Ok(Self { stop: Some(stop), thread: Some(thread) })
    }
}

impl Drop for Lines {
    fn drop(&mut self) {
        drop(self.stop.take());
        if let Some(thread) = self.thread.take() {
            // It can only have panicked while printing; the panic was reported when it happened.
            drop(thread.join());
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc::{Sender, channel};

    use super::*;

    struct Channel(Sender<u8>);

    impl Write for Channel {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            for &byte in bytes {
                self.0.send(byte).map_err(io::Error::other)?;
            }
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn lines_come_after_two_seconds_then_ever_later_up_to_thirty() {
        let times: Vec<_> = intervals().take(10).collect();
        assert_eq!(times[0], Duration::from_secs(2));
        assert_eq!(times[9], Duration::from_secs(30));
        assert!(times.windows(2).all(|pair| pair[0] < pair[1] || pair[1] == Duration::from_secs(30)));
    }

    #[test]
    fn a_last_line_tells_the_final_counts() {
        let tally = Arc::new(Tally::new(3, "cases"));
        let (sender, written) = channel();
        let lines = Lines::start(Arc::clone(&tally), Channel(sender), intervals()).expect("a thread starts");
        tally.count(true);
        tally.count(false);
        drop(lines);
        let text = String::from_utf8(written.iter().collect()).expect("text");
        let last = text.lines().last().expect("a line");
        assert!(last.starts_with("2 of 3 cases, 1 failed, "), "{text}");
    }

    #[test]
    fn lines_are_printed_while_nothing_finishes() {
        let (sender, written) = channel();
        let often = iter::repeat(Duration::from_millis(1));
        let lines = Lines::start(Arc::new(Tally::new(7, "cases")), Channel(sender), often).expect("a thread starts");
        let text: Vec<u8> = written.iter().take(3 * "0 of 7 cases\n".len()).collect();
        assert_eq!(text, "0 of 7 cases\n".repeat(3).as_bytes());
        drop(lines);
    }

    #[test]
    fn a_reader_that_went_away_does_not_end_the_run() {
        let (sender, written) = channel();
        drop(written);
        let often = iter::repeat(Duration::from_millis(1));
        drop(Lines::start(Arc::new(Tally::new(7, "cases")), Channel(sender), often).expect("a thread starts"));
    }
}
