//! Ctrl-C, SIGTERM and the end of the terminal: the first asks the run to stop, the second ends the program at once.

use std::fmt;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::{flag, iterator};

use stribeck_solver::continuation::Interrupt;

/// Exit code of a program ended by the second signal, the same as that of an interrupted run.
const ABORTED: i32 = 130;

/// A signal that asks the program to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopSignal {
    /// SIGINT, as Ctrl-C sends it.
    Interrupt,
    /// SIGTERM, as `kill` and batch systems send it.
    Terminate,
    /// SIGHUP, as a terminal sends it that closes.
    HangUp,
}

impl StopSignal {
    const ALL: [Self; 3] = [Self::Interrupt, Self::Terminate, Self::HangUp];

    fn number(self) -> i32 {
        match self {
            Self::Interrupt => SIGINT,
            Self::Terminate => SIGTERM,
            Self::HangUp => SIGHUP,
        }
    }

    /// True if the program was started to ignore a hang-up.
    fn is_ignored(self) -> bool {
        self == Self::HangUp && hang_up_is_ignored()
    }

    /// A number for an atomic; 0 is left for "none".
    fn code(self) -> usize {
        match self {
            Self::Interrupt => 1,
            Self::Terminate => 2,
            Self::HangUp => 3,
        }
    }
}

impl fmt::Display for StopSignal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Interrupt => "SIGINT",
            Self::Terminate => "SIGTERM",
            Self::HangUp => "SIGHUP",
        })
    }
}

/// What Linux says that the process ignores. Elsewhere a hang-up always stops a run.
fn hang_up_is_ignored() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask & (1 << (SIGHUP - 1)) != 0)
}

/// Watches for signals that ask the program to stop, from [`Signals::watch`] to the end of the program.
#[derive(Clone, Debug)]
pub struct Signals {
    received: Arc<AtomicUsize>,
}

impl Signals {
    /// From now on the first SIGINT, SIGTERM or SIGHUP requests `interrupt` (a moment later, from a thread), and the
    /// next SIGINT or SIGTERM ends the program at once with exit code 130. Nothing is printed by either. Call it once in
    /// a program. One that was started to ignore SIGHUP (`nohup`) goes on ignoring it.
    ///
    /// A file that grows beyond the limit of the process (`ulimit -f`) is from now on an error of that write, as on a
    /// full disk: by default the system ends the program there, before it can say what is saved.
    ///
    /// # Errors
    /// What the system says if it refuses a handler, or the thread that passes the request on.
    pub fn watch(interrupt: &Arc<Interrupt>) -> io::Result<Self> {
        let received = Arc::new(AtomicUsize::new(0));
        let armed = Arc::new(AtomicBool::new(false));
        let stopping = StopSignal::ALL.into_iter().filter(|signal| !signal.is_ignored());
        let stopping: Vec<StopSignal> = stopping.collect();
        for signal in &stopping {
            // Actions run in the order of their registration: a first signal finds the shutdown unarmed, then arms it.
            // A terminal that closes may tell twice, once itself and once by its shell.
            if *signal != StopSignal::HangUp {
                flag::register_conditional_shutdown(signal.number(), ABORTED, Arc::clone(&armed))?;
            }
            flag::register(signal.number(), Arc::clone(&armed))?;
            flag::register_usize(signal.number(), Arc::clone(&received), signal.code())?;
        }
        #[cfg(unix)]
        flag::register(signal_hook::consts::SIGXFSZ, Arc::new(AtomicBool::new(false)))?;
        // The interruption is requested by a thread, not by a handler: that needs no promise about what a handler may
        // do.
        let mut arriving = iterator::Signals::new(stopping.into_iter().map(StopSignal::number))?;
        let interrupt = Arc::clone(interrupt);
        let request = move || arriving.forever().for_each(|_| interrupt.request());
        thread::Builder::new().name("signals".to_owned()).spawn(request)?;
        Ok(Self { received })
    }

    /// The signal that came, if one did.
    pub fn received(&self) -> Option<StopSignal> {
        let code = self.received.load(Ordering::SeqCst);
        StopSignal::ALL.into_iter().find(|signal| signal.code() == code)
    }
}
