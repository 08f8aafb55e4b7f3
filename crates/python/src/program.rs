//! The program.

use std::ffi::OsString;
use std::process::ExitCode;

use pyo3::prelude::*;
use stribeck::commands::{execute, parse, set_command_line};

/// Runs the program with a command line, whose first word is the path that starts it, and returns the exit code.
#[pyfunction]
pub fn main(py: Python<'_>, words: Vec<OsString>) -> i32 {
    py.detach(|| {
        set_command_line(words.clone());
        let words = std::iter::once(OsString::from("stribeck")).chain(words.into_iter().skip(1));
        match parse(words) {
            Ok(cli) => code(execute(&cli, &peak_bytes)),
            Err(error) => {
                // Without a terminal to print to there is no one to tell.
                let _ = error.print();
                error.exit_code()
            }
        }
    })
}

/// The number behind an exit code, which the standard library hides: one of 256.
fn code(code: ExitCode) -> i32 {
    (0..=u8::MAX).find(|number| ExitCode::from(*number) == code).map_or(1, i32::from)
}

/// The most bytes that a piece of work has in use at once.
fn peak_bytes(work: &mut dyn FnMut()) -> u64 {
    allocation_counter::measure(work).bytes_max
}
