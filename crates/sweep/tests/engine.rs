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

use stribeck_solver::FailureKind;
use stribeck_solver::continuation::{Effort, Interrupt, Interrupted, SolvedCase};
use stribeck_sweep::MAX_CHAIN;
use stribeck_sweep::engine::{Engine, Finished, Report};

fn engine(threads: usize) -> Engine {
    Engine::new(NonZeroUsize::new(threads).expect("a number above 0")).expect("threads start")
}

fn case(chain: usize, reason: &str) -> SolvedCase {
    let effort = Effort { iterations: chain as u64, ..Effort::default() };
    SolvedCase { effort, ..SolvedCase::failed(FailureKind::Other(reason.to_owned())) }
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

/// Commits the chains of a group one by one.
fn each<E>(
    mut commit: impl FnMut(&usize, Vec<SolvedCase>) -> Result<(), E>,
) -> impl FnMut(Vec<Finished<'_, usize, SolvedCase>>) -> Result<(), E> {
    move |group: Vec<Finished<'_, usize, SolvedCase>>| {
        group.into_iter().try_for_each(|finished| commit(finished.chain, finished.cases))
    }
}

#[test]
fn each_chain_is_committed_once_with_its_own_cases_on_any_number_of_threads() {
    let chains: Vec<usize> = (0..500).collect();
    for threads in [1, 2, 8] {
        let mut committed = Vec::new();
        let report = {
            let commit = each(|&chain, cases| {
                assert_eq!(cases.len(), 1);
                assert_eq!(cases[0].effort.iterations, chain as u64);
                committed.push(chain);
                Ok::<_, Infallible>(())
            });
            engine(threads).run(&chains, &Interrupt::new(), solve, never_panicked, commit)
        };
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
    engine(1).run(&chains, &Interrupt::new(), solve, never_panicked, each(commit)).expect("nothing fails");
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
    engine(4).run(&chains, &Interrupt::new(), meet, never_panicked, each(commit)).expect("nothing fails");
    assert_eq!(writers, [thread::current().id(); 8]);
}

#[test]
fn nothing_to_do_is_done() {
    let report = engine(2).run(&[], &Interrupt::new(), solve, never_panicked, each(|_, _| Ok::<_, Infallible>(())));
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
        let report = engine(threads).run(&chains, &interrupt, quick_then_slow, never_panicked, each(commit));
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
    let report = engine(1).run(&[7, 8], &interrupt, finish, never_panicked, each(commit));
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
    let report = engine(1).run(&[7], &interrupt, solve, never_panicked, each(commit));
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
        let report = engine(threads).run(&chains, &interrupt, quick_then_slow, never_panicked, each(commit));
        assert_eq!(report, Err("the disk is full"));
        assert_eq!(calls, 4, "nothing is committed after an error");
        assert!(started.into_inner() <= 4 + threads, "no chain is started after an error");
    }
}

#[test]
fn a_writer_error_frees_solvers_that_wait_for_the_queue() {
    let chains: Vec<usize> = (0..1000).collect();
    let engine = engine(4);
    let queue_length = engine.queue_length();
    let finished = AtomicUsize::new(0);
    let counted = |chain: &usize, interrupt: &Interrupt| {
        finished.fetch_add(1, Ordering::SeqCst);
        solve(chain, interrupt)
    };
    let commit = |group: Vec<Finished<'_, usize, SolvedCase>>| {
        while finished.load(Ordering::SeqCst) < group.len() + queue_length + 4 {
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
    engine(4).run(&chains, &Interrupt::new(), solve, never_panicked, each(commit)).expect("the panic comes first");
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
                reasons.insert((case.outcome.expect_err("all fakes fail").to_string(), chain % 10 == 0 && chain > 0));
            }
            Ok::<_, Infallible>(())
        };
        let report = engine(threads).run(&chains, &Interrupt::new(), panics, panicked, each(commit));
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
        let waiting = engine.queue_length() + threads;
        let (in_flight, changed) = (Mutex::new((0, 0)), Condvar::new()); // now, and at most
        let finishes = |chain: &usize, interrupt: &Interrupt| {
            let cases = solve(chain, interrupt).map(|cases| vec![cases[0].clone(); MAX_CHAIN]);
            let mut counts = in_flight.lock().expect("no panic");
            counts.0 += 1;
            counts.1 = counts.1.max(counts.0);
            changed.notify_all();
            cases
        };
        let (mut first, mut groups) = (true, Vec::new());
        let commit = |group: Vec<Finished<'_, usize, SolvedCase>>| {
            groups.push(group.len());
            let mut counts = in_flight.lock().expect("no panic");
            if std::mem::take(&mut first) {
                // The solvers get as far as they can, and then no further however long the writer takes.
                let most = group.len() + waiting;
                counts = changed.wait_while(counts, |counts| counts.0 < most).expect("no panic");
                let patience = Duration::from_millis(100);
                counts = changed.wait_timeout_while(counts, patience, |counts| counts.0 <= most).expect("no panic").0;
            }
            counts.0 -= group.len();
            Ok::<_, Infallible>(())
        };
        engine.run(&chains, &Interrupt::new(), finishes, never_panicked, commit).expect("nothing fails");
        let (left, most) = in_flight.into_inner().expect("no panic");
        assert_eq!(left, 0);
        assert!(most <= engine.queue_length() + waiting, "{most} at once with {threads} threads");
        assert!(groups.iter().all(|&chains| (1..=engine.queue_length()).contains(&chains)), "{groups:?}");
    }
}

/// A commit waits for the disk, however little it brings there: many short chains are no many commits.
#[test]
fn short_chains_are_committed_in_few_groups() {
    let chains: Vec<usize> = (0..5000).collect();
    let mut groups = 0;
    let commit = |_: Vec<Finished<'_, usize, SolvedCase>>| {
        groups += 1;
        thread::sleep(Duration::from_millis(1));
        Ok::<_, Infallible>(())
    };
    let report = engine(2).run(&chains, &Interrupt::new(), solve, never_panicked, commit);
    assert_eq!(report, Ok(Report { failed: 5000, ..Report::default() }));
    assert!(groups <= 5000 / MAX_CHAIN, "{groups}");
}

#[test]
fn chains_that_finish_while_the_writer_is_at_work_are_committed_together() {
    let chains: Vec<usize> = (0..40).collect();
    let engine = engine(2).with_queue(10);
    let finished = AtomicUsize::new(0);
    let counted = |chain: &usize, interrupt: &Interrupt| {
        let cases = solve(chain, interrupt);
        finished.fetch_add(1, Ordering::SeqCst);
        cases
    };
    let (mut committed, mut groups) = (0, Vec::new());
    let commit = |group: Vec<Finished<'_, usize, SolvedCase>>| {
        committed += group.len();
        groups.push(group.len());
        // The disk is slow: meanwhile the queue fills up, or nothing is left.
        while finished.load(Ordering::SeqCst) < (committed + 10).min(chains.len()) {
            thread::yield_now();
        }
        Ok::<_, Infallible>(())
    };
    let report = engine.run(&chains, &Interrupt::new(), counted, never_panicked, commit);
    assert_eq!(report, Ok(Report { failed: 40, ..Report::default() }));
    assert!(groups.len() <= 5, "{groups:?}");
}

/// The wait is an hour: only its being cut short lets this test end.
#[test]
fn chains_wait_for_company_until_the_run_ends_or_is_interrupted() {
    let patient = || engine(2).with_queue(100).with_group_wait(Duration::from_secs(3600));
    let chains: Vec<usize> = (0..40).collect();
    let mut groups = Vec::new();
    let commit = |group: Vec<Finished<'_, usize, SolvedCase>>| {
        groups.push(group.len());
        Ok::<_, Infallible>(())
    };
    let report = patient().run(&chains, &Interrupt::new(), solve, never_panicked, commit);
    assert_eq!(report, Ok(Report { failed: 40, ..Report::default() }));
    assert_eq!(groups, [40], "all of it is one commit");

    let interrupt = Interrupt::new();
    let interrupting = |&chain: &usize, interrupt: &Interrupt| {
        if chain == 30 {
            interrupt.request();
        }
        solve(&chain, interrupt)
    };
    let mut committed = 0;
    let commit = |group: Vec<Finished<'_, usize, SolvedCase>>| {
        committed += group.len();
        Ok::<_, Infallible>(())
    };
    let report = patient().run(&chains, &interrupt, interrupting, never_panicked, commit).expect("nothing fails");
    assert!(report.interrupted && committed >= 30, "{committed}");
}

#[test]
fn a_finished_chain_does_not_wait_for_a_slow_one() {
    let committed = AtomicUsize::new(0);
    // The second chain ends only after the first is committed.
    let second_waits = |&chain: &usize, interrupt: &Interrupt| {
        while chain == 1 && committed.load(Ordering::SeqCst) == 0 {
            thread::yield_now();
        }
        solve(&chain, interrupt)
    };
    let commit = |group: Vec<Finished<'_, usize, SolvedCase>>| {
        committed.fetch_add(group.len(), Ordering::SeqCst);
        Ok::<_, Infallible>(())
    };
    let engine = engine(2).with_queue(10);
    engine.run(&[0, 1], &Interrupt::new(), second_waits, never_panicked, commit).expect("nothing fails");
    assert_eq!(committed.into_inner(), 2);
}
