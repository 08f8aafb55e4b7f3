//! What the first and the second signal do, each in a process of its own: handlers last as long as a process.

use std::env;
use std::process::{Command, Output};
use std::sync::Arc;
use std::time::{Duration, Instant};

use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::low_level::raise;
use stribeck_solver::continuation::Interrupt;
use stribeck_sweep::engine::{Signals, StopSignal};

/// Tells a test that it is the process to be watched, and which signals it shall raise.
const RAISE: &str = "STRIBECK_TEST_RAISE";

/// What the watched process does. A signal raised is noted before `raise` returns, and requests the interruption soon
/// after, which the process waits for.
fn raise_all(names: &str) {
    let interrupt = Arc::new(Interrupt::new());
    let signals = Signals::watch(&interrupt).expect("handlers are installed");
    println!("before: {:?}, requested: {}", signals.received(), interrupt.requested());
    for name in names.split(',') {
        let number = match name {
            "SIGINT" => SIGINT,
            "SIGTERM" => SIGTERM,
            _ => SIGHUP,
        };
        raise(number).expect("a signal is raised");
        let patience = Instant::now() + Duration::from_secs(60);
        while !interrupt.requested() && Instant::now() < patience {
            std::thread::yield_now();
        }
        println!("after {name}: {:?}, requested: {}", signals.received(), interrupt.requested());
    }
}

/// Runs the test of this name again, in a process that raises signals; its exit code and output.
fn process_that_raises(names: &str, test: &str) -> (Option<i32>, String) {
    let program = env::current_exe().expect("the test knows its program");
    let arguments = ["--exact", test, "--nocapture", "--test-threads=1"];
    let Output { status, stdout, stderr } =
        Command::new(program).args(arguments).env(RAISE, names).output().expect("the process starts");
    assert!(stderr.is_empty(), "handlers print nothing: {}", String::from_utf8_lossy(&stderr));
    (status.code(), String::from_utf8(stdout).expect("text"))
}

#[test]
fn the_first_signal_requests_the_interruption_and_is_remembered() {
    if let Ok(names) = env::var(RAISE) {
        return raise_all(&names);
    }
    let signals =
        [("SIGINT", StopSignal::Interrupt), ("SIGTERM", StopSignal::Terminate), ("SIGHUP", StopSignal::HangUp)];
    for (name, signal) in signals {
        assert_eq!(signal.to_string(), name);
        let (code, output) =
            process_that_raises(name, "signals::the_first_signal_requests_the_interruption_and_is_remembered");
        assert_eq!(code, Some(0), "{output}");
        assert!(output.contains("before: None, requested: false"), "{output}");
        assert!(output.contains(&format!("after {name}: Some({signal:?}), requested: true")), "{output}");
    }
}

#[test]
fn the_second_signal_ends_the_program_at_once_with_130() {
    if let Ok(names) = env::var(RAISE) {
        return raise_all(&names);
    }
    for names in ["SIGINT,SIGINT", "SIGTERM,SIGTERM", "SIGINT,SIGTERM", "SIGTERM,SIGINT", "SIGHUP,SIGTERM"] {
        let (code, output) = process_that_raises(names, "signals::the_second_signal_ends_the_program_at_once_with_130");
        assert_eq!(code, Some(130), "{output}");
        assert_eq!(output.matches("after").count(), 1, "it went on after the second signal: {output}");
    }
}

/// The kernel tells of a terminal that closed, and then its shell does.
#[test]
fn a_second_hang_up_changes_nothing() {
    if let Ok(names) = env::var(RAISE) {
        return raise_all(&names);
    }
    let (code, output) = process_that_raises("SIGHUP,SIGHUP", "signals::a_second_hang_up_changes_nothing");
    assert_eq!(code, Some(0), "{output}");
    assert_eq!(output.matches("after SIGHUP: Some(HangUp), requested: true").count(), 2, "{output}");
}
