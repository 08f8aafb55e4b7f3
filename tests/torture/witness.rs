//! The checks: nothing is lost, the program tells the truth, and what is published in the end is what it always is.

use std::collections::BTreeSet;
use std::fs;

use crate::program::{code, err, out};
use crate::torture::place::{End, Place};
use crate::torture::stored::{Cases, Line, Start, Stored};
use crate::torture::sweep::SAME_IN_EVERY_RUN;

/// Starts that `status` lists.
const LISTED_STARTS: usize = 10;

/// Each case of `before` is in `after`, with the same status.
pub fn assert_kept(before: &Cases, after: &Cases) {
    let lost: Vec<_> = before.iter().filter(|&(case, status)| after.get(case) != Some(status)).collect();
    assert!(lost.is_empty(), "{} of {} committed cases are lost: {lost:?}", lost.len(), before.len());
}

/// `status` and `plan` say of a directory in which no run is at work what the log and the shards say.
pub fn assert_told(place: &Place) -> Stored {
    assert_told_of(place, None)
}

/// The same of a directory in which the process `owner` is at work.
pub fn assert_told_of(place: &Place, owner: Option<u32>) -> Stored {
    let stored = place.stored();
    let cases = place.cases_of(&stored);
    let expected = &place.sweep.undisturbed().cases;
    for (case, status) in &cases {
        assert_eq!(Some(status), expected.get(case), "case {case}");
    }
    let converged = cases.values().filter(|status| *status == "converged").count();
    let numbers = [converged, cases.len() - converged, expected.len() - cases.len()];
    assert_plan(place, &stored, numbers);
    assert_status(place, &stored, numbers, owner);
    stored
}

fn assert_plan(place: &Place, stored: &Stored, [converged, failed, left]: [usize; 3]) {
    let plan = place.say(&["plan", "sweep.toml", "-o", "out"]);
    assert_eq!(code(&plan), 0, "{}", err(&plan));
    let stale = stale(place, stored);
    let (new, stale) = (left - stale, if stale > 0 { format!(", {stale} stale") } else { String::new() });
    let state = format!("\nstate      {converged} reused, {new} new{stale}, {failed} failed before\n");
    assert!(out(&plan).contains(&state), "{state}{}", out(&plan));
}

/// How many cases of the sweep are there only as the other sweep has solved them, at the same place by another recipe.
fn stale(place: &Place, stored: &Stored) -> usize {
    let [these, others] = [place.sweep, place.sweep.other()].map(|sweep| &sweep.undisturbed().places);
    let all = stored.sound_cases();
    let there_is = |case: &String| all.contains_key(case);
    let stale = these.iter().filter(|(at, case)| !there_is(case) && others.get(*at).is_some_and(there_is));
    stale.map(|(_, case)| case).collect::<BTreeSet<_>>().len()
}

fn assert_status(place: &Place, stored: &Stored, [converged, failed, left]: [usize; 3], owner: Option<u32>) {
    let results = place.results();
    let status = place.say(&["status", "out"]);
    let (said, warned) = (out(&status), err(&status));
    if !(results.join("log").is_dir() && results.join("shards").is_dir()) {
        assert_eq!(code(&status), 4, "{said}{warned}");
        assert!(warned.contains("out is not a results directory"), "{warned}");
        return;
    }
    assert_eq!(code(&status), 0, "{said}{warned}");
    let says = |line: &str| assert!(said.contains(&format!("\n{line}\n")), "{line}\n{said}");
    match fs::read_to_string(results.join("sweep.toml")) {
        Ok(sweep) => {
            assert_eq!(sweep, place.sweep.text(), "the sweep file is there whole or not at all");
            let all = place.sweep.undisturbed();
            says(&match owner {
                Some(process) => format!("running (process {process})"),
                None if left > 0 => "stopped; the same `stribeck run` command resumes it".to_owned(),
                None if stored.published => "stopped, all cases were tried".to_owned(),
                None => "stopped, all cases were tried, but not yet published; run it again".to_owned(),
            });
            says(&format!("planned    {} cases, at {} places of the sweep", all.cases.len(), all.places.len()));
            says(&format!("converged  {converged}"));
            says(&format!("failed     {failed}"));
            says(&format!("to do      {left}"));
            assert_warnings(&warned, stored, owner.is_some());
        }
        Err(_) => {
            assert!(said.starts_with("cases      0 converged, 0 failed\n"), "it precedes all cases: {said}");
            assert!(warned.contains("how many cases were planned is not known"), "{warned}");
        }
    }
    assert_starts(&said, &stored.starts, owner.is_some());
    assert_rate(&said);
}

/// Every damage is told, and nothing else.
fn assert_warnings(warned: &str, stored: &Stored, running: bool) {
    // Damaged lines that follow each other are told together.
    let neighbours = |a: &Line, b: &Line| a.log == b.log && a.line + 1 == b.line;
    let lines = stored.damaged.chunk_by(neighbours).map(|run| match run {
        [one] => format!("log/{:04}.jsonl, line {}: ", one.log, one.line),
        [first, .., last] => format!("log/{:04}.jsonl, lines {} to {}: ", first.log, first.line, last.line),
        [] => unreachable!("runs have a first line"),
    });
    // The last line may be half written while a run works, so that lines are not complained of then.
    let mut expected: Vec<_> = lines.filter(|_| !running).map(|line| (line, String::new())).collect();
    let shards = stored.lossy().into_iter();
    expected.extend(shards.map(|(file, lost)| (format!("shards/{file}: "), format!("its {lost} cases are not used"))));
    let warnings: Vec<_> = warned.lines().collect();
    for (place, what) in &expected {
        let told = warnings.iter().filter(|warning| warning.contains(place) && warning.contains(what)).count();
        assert_eq!(told, 1, "{place}{what}\n{warned}");
    }
    assert_eq!(warnings.len(), expected.len(), "{warned}");
}

/// The list of starts is that of the logs, and no clock makes its times absurd.
fn assert_starts(said: &str, starts: &[Start], running: bool) {
    let begun: Vec<_> = starts.iter().filter_map(|start| Some((start, start.beginning?))).collect();
    let lines: Vec<_> = said.lines().skip_while(|line| *line != "starts (UTC)").skip(1).collect();
    let lines: Vec<_> = lines.into_iter().take_while(|line| line.starts_with(' ')).collect();
    let skipped = begun.len().saturating_sub(LISTED_STARTS);
    let listed = if skipped > 0 { &lines[1..] } else { &lines[..] };
    assert_eq!(listed.len(), begun.len() - skipped, "{said}");
    for (place, (start, [asked, threads])) in begun.iter().enumerate().skip(skipped) {
        let line = listed[place - skipped];
        let ending = match &start.ending {
            Some(ending) => ending,
            None if running && place + 1 == begun.len() => "running",
            None => "killed",
        };
        let threads = if *threads == 1 { "1 thread".to_owned() } else { format!("{threads} threads") };
        let (number, end) = (format!("{:>4} ", start.log), format!(", {ending}"));
        let told = line.strip_prefix(&number).unwrap_or_else(|| panic!("{line}"));
        let (when, work) = (&told[..19], &told[20..]);
        let work = work.strip_suffix(&end).unwrap_or_else(|| panic!("{line} does not end with {ending}"));
        let took = work.strip_prefix(&format!("{threads}, {} of {asked} cases in ", start.done));
        let took = took.unwrap_or_else(|| panic!("{} of {asked} cases, {threads}: {line}", start.done));
        let year: i32 = when[..4].parse().expect("a year");
        assert!((1970..2200).contains(&year), "{line}");
        assert!(took.ends_with(" s") && !took.contains(['-', 'h', 'd']) || took == "under 1 s", "{line}");
    }
}

/// A rate is a number that makes sense, if one is told.
fn assert_rate(said: &str) {
    let Some(rate) = said.lines().find_map(|line| line.strip_prefix("rate")) else { return };
    let number: f64 = rate.split_whitespace().next().and_then(|word| word.parse().ok()).expect("a number");
    assert!(number > 0.0 && number < 1e6 && !rate.contains('-'), "{rate}");
}

/// The message of a run that stopped before its end: what is saved, what is not, and how to go on.
pub fn assert_resumable(place: &Place, end: &End, threads: usize) {
    let all = place.sweep.undisturbed().cases.len();
    let saved = place.cases().len();
    let counts = format!("{saved} cases saved in out, {} left", all - saved);
    assert!(end.err.contains(&counts), "{counts}\n{}", end.err);
    let command = place.typed(threads);
    assert_eq!(end.err.lines().next_back().map(str::trim), Some(&*command), "{}", end.err);
}

/// A run that was let go to its end says what the undisturbed one says.
pub fn assert_ended(place: &Place, end: &End) {
    assert_eq!(end.code, Some(place.sweep.undisturbed().code), "{}{}", end.out, end.err);
}

/// One more run completes the sweep, its published bytes are those of the undisturbed run, and all that is said of it
/// is that all is well.
pub fn assert_completes(place: &Place, threads: usize) {
    assert_ended(place, &place.run(threads));
    assert_complete(place);
}

/// The sweep is complete, and published as by the undisturbed run.
pub fn assert_complete(place: &Place) {
    let (results, undisturbed) = (place.results(), place.sweep.undisturbed());
    for (name, expected) in SAME_IN_EVERY_RUN.into_iter().zip(&undisturbed.bytes) {
        assert!(fs::read(results.join(name)).expect("published") == *expected, "{name} is not that of other runs");
    }
    let verify = place.say(&["verify", "out"]);
    assert_eq!(code(&verify), 0, "{}{}", out(&verify), err(&verify));
    let stored = assert_told(place);
    assert!(place.cases_of(&stored) == undisturbed.cases && stored.published, "all is stored and published");
    for directory in [results.clone(), results.join("shards")] {
        let names = fs::read_dir(directory).expect("listed").map(|entry| entry.expect("listed").file_name());
        let left: Vec<_> = names.filter(|name| name.to_string_lossy().ends_with("-part")).collect();
        assert!(left.is_empty(), "half written files are left: {left:?}");
    }
    let again = place.run(1);
    assert_ended(place, &again);
    assert!(again.out.contains("nothing to do: all of it is solved and published"), "{}{}", again.out, again.err);
}

/// A run that starts while `owner` is at work is refused, and says who is.
pub fn assert_refused(second: &End, owner: u32) {
    assert_eq!(second.code, Some(4), "{}{}", second.out, second.err);
    let named = format!("out is in use by another run (process {owner}); wait until it ends or stop it");
    assert!(second.err.contains(&named), "{named}: {}", second.err);
}
