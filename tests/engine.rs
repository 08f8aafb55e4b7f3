//! The engine with fake solvers and writers: what is committed, what stops it, and how much it keeps in memory.
//!
//! A fake chain is a number; its one case carries that number back as its iterations.

use std::collections::BTreeSet;
use std::convert::Infallible;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Barrier, Condvar, Mutex};
use std::thread::{self, ThreadId};
use std::time::Duration;

use stribeck::continuation::{Effort, Interrupt, Interrupted, Path, Seed, SolvedCase};
use stribeck::engine::{Engine, Report};
use stribeck::model::{Failure, Limits};

fn engine(threads: usize) -> Engine {
    Engine::new(NonZeroUsize::new(threads).expect("a number above 0")).expect("threads start")
}

fn case(chain: usize, reason: &str) -> SolvedCase {
    SolvedCase {
        outcome: Err(Failure::new(reason.to_owned())),
        limits: Limits::UNKNOWN,
        seed: Seed::Elastic,
        path: Path::default(),
        effort: Effort { iterations: chain as u64, ..Effort::default() },
    }
}

fn solve(&chain: &usize, _: &Interrupt) -> Result<Vec<SolvedCase>, Interrupted> {
    Ok(vec![case(chain, "fake")])
}

/// A solver that works until it is interrupted.
fn solve_for_ever(_: &usize, interrupt: &Interrupt) -> Result<Vec<SolvedCase>, Interrupted> {
    while !interrupt.requested() {
        thread::yield_now();
    }
    Err(Interrupted)
}

fn panicked(&chain: &usize, message: &str) -> Vec<SolvedCase> {
    vec![case(chain, message), case(chain, message)]
}

fn never_panicked(_: &usize, message: &str) -> Vec<SolvedCase> {
    panic!("no solver of this test panics, but one did: {message}")
}

#[test]
fn each_chain_is_committed_once_with_its_own_cases_on_any_number_of_threads() {
    let chains: Vec<usize> = (0..500).collect();
    for threads in [1, 2, 8] {
        let mut committed = Vec::new();
        let report = engine(threads).run(&chains, &Interrupt::new(), solve, never_panicked, |&chain, cases| {
            assert_eq!(cases.len(), 1);
            assert_eq!(cases[0].effort.iterations, chain as u64);
            committed.push(chain);
            Ok::<_, Infallible>(())
        });
        assert_eq!(report, Ok(Report { failed: 500, ..Report::default() }));
        committed.sort_unstable();
        assert_eq!(committed, chains, "with {threads} threads");
    }
}

#[test]
fn one_thread_commits_in_the_order_of_the_plan() {
    let chains = [5, 3, 9, 1];
    let mut committed = Vec::new();
    let commit = |&chain: &usize, _| {
        committed.push(chain);
        Ok::<_, Infallible>(())
    };
    engine(1).run(&chains, &Interrupt::new(), solve, never_panicked, commit).expect("nothing fails");
    assert_eq!(committed, chains);
}

#[test]
fn chains_run_in_parallel_and_are_committed_on_the_calling_thread() {
    let together = Barrier::new(4);
    let meet = |chain: &usize, interrupt: &Interrupt| {
        together.wait(); // Passed only if four chains are at work at once.
        solve(chain, interrupt)
    };
    let mut writers: Vec<ThreadId> = Vec::new();
    let commit = |_: &usize, _| {
        writers.push(thread::current().id());
        Ok::<_, Infallible>(())
    };
    let chains: Vec<usize> = (0..8).collect();
    engine(4).run(&chains, &Interrupt::new(), meet, never_panicked, commit).expect("nothing fails");
    assert_eq!(writers, [thread::current().id(); 8]);
}

#[test]
fn nothing_to_do_is_done() {
    let report = engine(2).run(&[], &Interrupt::new(), solve, never_panicked, |_, _| Ok::<_, Infallible>(()));
    assert_eq!(report, Ok(Report::default()));
}

#[test]
fn an_interrupted_run_commits_what_is_finished_and_no_more() {
    // Chains below 5 are quick, all others last until the interruption, which comes with the fifth commit.
    let chains: Vec<usize> = (0..100).collect();
    for threads in [1, 2, 8] {
        let interrupt = Interrupt::new();
        let started = Mutex::new(BTreeSet::new());
        let quick_then_slow = |chain: &usize, interrupt: &Interrupt| {
            started.lock().expect("no panic").insert(*chain);
            if *chain < 5 { solve(chain, interrupt) } else { solve_for_ever(chain, interrupt) }
        };
        let mut committed = BTreeSet::new();
        let commit = |&chain: &usize, _| {
            committed.insert(chain);
            if committed.len() == 5 {
                interrupt.request();
            }
            Ok::<_, Infallible>(())
        };
        let report = engine(threads).run(&chains, &interrupt, quick_then_slow, never_panicked, commit);
        assert_eq!(report, Ok(Report { failed: 5, interrupted: true, ..Report::default() }));
        assert_eq!(committed, (0..5).collect());
        assert!(started.into_inner().expect("no panic").len() <= 5 + threads, "no chain is started after it");
    }
}

#[test]
fn a_chain_finished_in_spite_of_the_interruption_is_committed() {
    let interrupt = Interrupt::new();
    let finish = |chain: &usize, interrupt: &Interrupt| {
        interrupt.request();
        solve(chain, interrupt)
    };
    let mut committed = Vec::new();
    let commit = |&chain: &usize, _| {
        committed.push(chain);
        Ok::<_, Infallible>(())
    };
    let report = engine(1).run(&[7, 8], &interrupt, finish, never_panicked, commit);
    assert_eq!(report, Ok(Report { failed: 1, interrupted: true, ..Report::default() }));
    assert_eq!(committed, [7]);
}

#[test]
fn an_interruption_that_comes_when_all_is_committed_leaves_a_complete_run() {
    let interrupt = Interrupt::new();
    let commit = |_: &usize, _| {
        interrupt.request();
        Ok::<_, Infallible>(())
    };
    let report = engine(1).run(&[7], &interrupt, solve, never_panicked, commit);
    assert_eq!(report, Ok(Report { failed: 1, ..Report::default() }));
}

#[test]
fn an_error_of_the_writer_ends_the_run_and_is_returned() {
    let chains: Vec<usize> = (0..1000).collect();
    for threads in [1, 2, 8] {
        let interrupt = Interrupt::new();
        let started = AtomicUsize::new(0);
        // Chain 3 is the last that ends by itself: without an interruption of solvers at work this test would hang.
        let quick_then_slow = |chain: &usize, interrupt: &Interrupt| {
            started.fetch_add(1, Ordering::SeqCst);
            if *chain <= 3 { solve(chain, interrupt) } else { solve_for_ever(chain, interrupt) }
        };
        let mut calls = 0;
        let commit = |_: &usize, _| {
            calls += 1;
            if calls == 4 { Err("the disk is full") } else { Ok(()) }
        };
        let report = engine(threads).run(&chains, &interrupt, quick_then_slow, never_panicked, commit);
        assert_eq!(report, Err("the disk is full"));
        assert_eq!(calls, 4, "nothing is committed after an error");
        assert!(started.into_inner() <= 4 + threads, "no chain is started after an error");
    }
}

#[test]
fn a_writer_error_frees_solvers_that_wait_for_the_queue() {
    let chains: Vec<usize> = (0..1000).collect();
    let engine = engine(4);
    let in_flight = engine.queue_length() + 4 + 1;
    let finished = AtomicUsize::new(0);
    let counted = |chain: &usize, interrupt: &Interrupt| {
        finished.fetch_add(1, Ordering::SeqCst);
        solve(chain, interrupt)
    };
    let commit = |_: &usize, _| {
        while finished.load(Ordering::SeqCst) < in_flight {
            thread::yield_now();
        }
        Err("the disk is full")
    };
    assert_eq!(engine.run(&chains, &Interrupt::new(), counted, never_panicked, commit), Err("the disk is full"));
}

#[test]
#[should_panic(expected = "the writer is broken")]
fn a_panic_of_the_writer_reaches_the_caller_and_frees_the_solvers() {
    let chains: Vec<usize> = (0..1000).collect();
    let commit = |_: &usize, _| -> Result<(), Infallible> { panic!("the writer is broken") };
    engine(4).run(&chains, &Interrupt::new(), solve, never_panicked, commit).expect("the panic comes first");
}

#[test]
fn a_panic_fails_its_own_chain_only_and_its_message_is_kept() {
    let chains: Vec<usize> = (0..50).collect();
    for threads in [1, 4] {
        let panics = |chain: &usize, interrupt: &Interrupt| match chain {
            10 => panic!("a text"),
            20 => panic!("chain {chain}"),
            30 => std::panic::panic_any(3.5),
            _ => solve(chain, interrupt),
        };
        let mut committed = BTreeSet::new();
        let mut reasons = BTreeSet::new();
        let commit = |&chain: &usize, cases: Vec<SolvedCase>| {
            committed.insert(chain);
            for case in cases {
                assert_eq!(case.effort.iterations, chain as u64);
                reasons.insert((case.outcome.expect_err("all fakes fail").reason, chain % 10 == 0 && chain > 0));
            }
            Ok::<_, Infallible>(())
        };
        let report = engine(threads).run(&chains, &Interrupt::new(), panics, panicked, commit);
        assert_eq!(report, Ok(Report { failed: 47 + 3 * 2, panicked_chains: 3, ..Report::default() }));
        assert_eq!(committed, (0..50).collect());
        for reason in ["a text", "chain 20", "a panic without a message"] {
            assert!(reasons.contains(&(reason.to_owned(), true)), "{reason}: {reasons:?}");
        }
    }
}

#[test]
fn a_slow_writer_holds_the_solvers_back() {
    let chains: Vec<usize> = (0..300).collect();
    for threads in [1, 2, 8] {
        let engine = engine(threads);
        let most = engine.queue_length() + threads + 1;
        let (in_flight, changed) = (Mutex::new((0, 0)), Condvar::new()); // now, and at most
        let finishes = |chain: &usize, interrupt: &Interrupt| {
            let cases = solve(chain, interrupt);
            let mut counts = in_flight.lock().expect("no panic");
            counts.0 += 1;
            counts.1 = counts.1.max(counts.0);
            changed.notify_all();
            cases
        };
        let mut first = true;
        let commit = |_: &usize, _| {
            let mut counts = in_flight.lock().expect("no panic");
            if std::mem::take(&mut first) {
                // The solvers get as far as they can, and then no further however long the writer takes.
                counts = changed.wait_while(counts, |counts| counts.0 < most).expect("no panic");
                let patience = Duration::from_millis(100);
                counts = changed.wait_timeout_while(counts, patience, |counts| counts.0 <= most).expect("no panic").0;
            }
            counts.0 -= 1;
            Ok::<_, Infallible>(())
        };
        engine.run(&chains, &Interrupt::new(), finishes, never_panicked, commit).expect("nothing fails");
        assert_eq!(in_flight.into_inner().expect("no panic"), (0, most), "with {threads} threads");
    }
}
