//! Faults of all kinds, one after the other, on directories that have seen others before.

use std::collections::BTreeMap;

use crate::torture::damage;
use crate::torture::faults::Fault;
use crate::torture::place::Place;
use crate::torture::random::Random;
use crate::torture::sweep::Sweep;
use crate::torture::witness::assert_completes;

/// How often each fault came out in each way.
pub type Counts = BTreeMap<(Fault, &'static str), usize>;

/// Most faults in a round.
const MOST_FAULTS: usize = 3;

/// Names the round that failed.
struct Announcement {
    seed: u64,
    round: u64,
    faults: Vec<Fault>,
}

impl Drop for Announcement {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let Self { seed, round, faults } = self;
            eprintln!("failed: seed {seed}, round {round}, {faults:?}");
        }
    }
}

/// So many rounds. Each has one to three faults, each followed by the checks; then the sweep is completed and compared
/// with the undisturbed run. `tell` gets a line for each round.
pub fn torture(rounds: u64, seed: u64, tell: impl Fn(String)) -> Counts {
    let mut counts = Counts::new();
    let mut used = None;
    for round in 1..=rounds {
        let mut random = Random::new(seed, round);
        let sweep = *random.pick(&[Sweep::Converging, Sweep::Failing]);
        let fresh = random.below(2) == 0 || round == 1;
        let mut place = used.take().filter(|_| !fresh).unwrap_or_else(|| Place::fresh(sweep));
        let faults = choose(&mut random, fresh);
        let announcement = Announcement { seed, round, faults };
        let mut words = Vec::new();
        for &fault in &announcement.faults {
            if Fault::OF_RUNS.contains(&fault) && place.is_solved() {
                // So that the run has something to do.
                damage::to_shards(&place, &mut random, damage::delete);
            }
            let how = fault.strike(&mut place, &mut random);
            *counts.entry((fault, how)).or_default() += 1;
            words.push(format!("{fault} {how}"));
        }
        assert_completes(&place, random.threads());
        let state = if fresh { "fresh" } else { "used" };
        tell(format!("round {round:>4}  {state:<5}  {:<10}  {}", format!("{:?}", place.sweep), words.join("; ")));
        used = Some(place);
    }
    counts
}

/// The first fault of a fresh directory leaves its work half done, the first of a finished one makes some anew.
fn choose(random: &mut Random, fresh: bool) -> Vec<Fault> {
    let first = if fresh { *random.pick(&Fault::OF_RUNS) } else { *random.pick(&Fault::OF_FILES) };
    let more = random.below(MOST_FAULTS);
    let all: Vec<_> = Fault::OF_RUNS.into_iter().chain(Fault::OF_FILES).collect();
    std::iter::once(first).chain((0..more).map(|_| *random.pick(&all))).collect()
}

/// The counts as a table.
pub fn table(counts: &Counts) -> String {
    let mut text = String::new();
    let mut last = None;
    for ((fault, how), count) in counts {
        if last != Some(fault) {
            let all: usize = counts.iter().filter(|((other, _), _)| other == fault).map(|(_, count)| count).sum();
            text += &format!("{fault:<16} {all:>4}\n");
            last = Some(fault);
        }
        text += &format!("    {count:>4}  {how}\n");
    }
    text
}
