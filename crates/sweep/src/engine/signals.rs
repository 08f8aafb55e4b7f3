//! Ctrl-C and SIGTERM: the first asks the run to stop, the second ends the program at once.

use std::fmt;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use signal_hook::consts::{SIGINT, SIGTERM};
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
}

impl StopSignal {
    const ALL: [Self; 2] = [Self::Interrupt, Self::Terminate];

    fn number(self) -> i32 {
        match self {
            Self::Interrupt => SIGINT,
            Self::Terminate => SIGTERM,
        }
    }

    /// A number for an atomic; 0 is left for "none".
    fn code(self) -> usize {
        match self {
            Self::Interrupt => 1,
            Self::Terminate => 2,
        }
    }
}

impl fmt::Display for StopSignal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Interrupt => "SIGINT",
            Self::Terminate => "SIGTERM",
        })
    }
}

/// Watches for signals that ask the program to stop, from [`Signals::watch`] to the end of the program.
#[derive(Clone, Debug)]
pub struct Signals {
    received: Arc<AtomicUsize>,
}

impl Signals {
    /// From now on the first SIGINT or SIGTERM requests `interrupt` (a moment later, from a thread), and the next one
    /// ends the program at once with exit code 130. Nothing is printed by either. Call it once in a program.
    ///
    /// A file that grows beyond the limit of the process (`ulimit -f`) is from now on an error of that write, as on a
    /// full disk: by default the system ends the program there, before it can say what is saved.
    ///
    /// # Errors
    /// What the system says if it refuses a handler, or the thread that passes the request on.
    pub fn watch(interrupt: &Arc<Interrupt>) -> io::Result<Self> {
        let received = Arc::new(AtomicUsize::new(0));
        let armed = Arc::new(AtomicBool::new(false));
        for signal in StopSignal::ALL {
            // Actions run in the order of their registration: a first signal finds the shutdown unarmed, then arms it.
            flag::register_conditional_shutdown(signal.number(), ABORTED, Arc::clone(&armed))?;
            flag::register(signal.number(), Arc::clone(&armed))?;
            flag::register_usize(signal.number(), Arc::clone(&received), signal.code())?;
        }
        #[cfg(unix)]
        flag::register(signal_hook::consts::SIGXFSZ, Arc::new(AtomicBool::new(false)))?;
        // The interruption is requested by a thread, not by a handler: that needs no promise about what a handler may
        // do.
        let mut arriving = iterator::Signals::new(StopSignal::ALL.map(StopSignal::number))?;
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
