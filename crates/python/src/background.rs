//! Work on threads of its own while Python looks for Ctrl-C.

use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;
use stribeck_solver::Interrupt;
use stribeck_sweep::campaign::available_threads;

use crate::errors;

/// Time between two looks for a signal.
const LOOK: Duration = Duration::from_millis(50);

/// Most threads: far more than cores, and far fewer than what would use up the memory of a machine with stacks alone.
const MOST_THREADS: usize = 1024;

/// Does some work on a thread of its own, without the interpreter's lock. Ctrl-C, or what else a handler of signals
/// raises, requests the interrupt; when the work has ended, what was raised is returned.
///
/// `messages` of the work are told to `heard`, with the interpreter's lock, on the calling thread.
///
/// # Errors
/// What a handler of signals raises, or `heard`.
pub fn watched<T: Send, M: Send>(
    py: Python<'_>,
    interrupt: &Interrupt,
    work: impl FnOnce(&dyn Fn(M)) -> T + Send,
    mut heard: impl FnMut(Python<'_>, M) -> PyResult<()> + Send,
) -> PyResult<T> {
    py.detach(|| {
        thread::scope(|scope| {
            let (tell, messages) = channel();
            // It is dropped with the work, which ends the loop below.
            let worker = scope.spawn(move || {
                let tell = tell;
                work(&|message| {
                    // The other end is there until all is told.
                    let _ = tell.send(message);
                })
            });
            let mut raised = None;
            loop {
                let message = match messages.recv_timeout(LOOK) {
                    Ok(message) => Some(message),
                    Err(RecvTimeoutError::Timeout) => None,
                    Err(RecvTimeoutError::Disconnected) => break,
                };
                if raised.is_some() {
                    continue;
                }
                let looked = Python::attach(|py| {
                    if let Some(message) = message {
                        heard(py, message)?;
                    }
                    py.check_signals()
                });
                if let Err(error) = looked {
                    interrupt.request();
                    raised = Some(error);
                }
            }
            let result = worker.join().unwrap_or_else(|panic| resume_unwind(panic));
            raised.map_or(Ok(result), Err)
        })
    })
}

/// A number of threads that was asked for, else one for each core.
///
/// # Errors
/// `InputError` if it is not from 1 to 1024.
pub fn threads(asked: Option<i64>) -> PyResult<NonZeroUsize> {
    let Some(asked) = asked else { return Ok(available_threads()) };
    let number = usize::try_from(asked).ok().and_then(NonZeroUsize::new);
    number.filter(|number| number.get() <= MOST_THREADS).ok_or_else(|| {
        errors::input(format!(
            "threads must be a whole number from 1 to {MOST_THREADS}, or None for all cores, not {asked}"
        ))
    })
}
