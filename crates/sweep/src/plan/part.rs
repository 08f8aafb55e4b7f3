//! Parts of a plan, for several machines to solve.

use std::cmp::Reverse;
use std::fmt;
use std::str::FromStr;

use super::chain::Chain;
use super::sweep_plan::Plan;

/// The I-th of N parts of a plan, written `I/N`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Part {
    // N first, so that the parts of one split are neighbours when sorted.
    of: u32,
    number: u32,
}

/// A text that names no part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("give I/N, the I-th of N parts, with I from 1 to N and N at most {}, as in 3/8", Part::MOST)]
pub struct NotAPart;

impl Part {
    /// The most parts that a plan may have.
    pub const MOST: u32 = 1_000_000;

    /// Part `number` (from 1) of `of`; `None` if there is none.
    pub fn new(number: u32, of: u32) -> Option<Self> {
        ((1..=of).contains(&number) && of <= Self::MOST).then_some(Self { of, number })
    }

    /// The number of the part, from 1.
    pub fn number(self) -> u32 {
        self.number
    }

    /// The number of parts.
    pub fn of(self) -> u32 {
        self.of
    }

    /// All parts of a split into `of`.
    pub fn all(of: u32) -> impl Iterator<Item = Self> {
        (1..=of).map(move |number| Self { of, number })
    }

    /// The name of its directory: `3-of-8`.
    pub fn name(self) -> String {
        format!("{}-of-{}", self.number, self.of)
    }

    /// The part whose directory has this name.
    pub fn named(name: &str) -> Option<Self> {
        let part = name.split_once("-of-").and_then(|(number, of)| Self::new(number.parse().ok()?, of.parse().ok()?));
        part.filter(|part| part.name() == name)
    }
}

impl fmt::Display for Part {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}/{}", self.number, self.of)
    }
}

impl FromStr for Part {
    type Err = NotAPart;

    fn from_str(text: &str) -> Result<Self, NotAPart> {
        let part = text.split_once('/').and_then(|(number, of)| Self::new(number.parse().ok()?, of.parse().ok()?));
        part.ok_or(NotAPart)
    }
}

/// What the first case of a chain costs beside its others, for each decade of β that it is reached over, in cases;
/// measured.
const DECADE: f64 = 5.0;
/// β from which the first case of a chain is reached.
const THICK: f64 = 0.01;
/// What an elastic case costs, in cases of others.
const ELASTIC: f64 = 0.6;

impl Plan {
    /// Which part of a split into `of` each chain is in, in the order of [`Plan::chains`]. That depends on the plan
    /// alone.
    ///
    /// The chains are dealt like cards, the dearest first, there and back again: the parts differ by about one chain.
    ///
    /// # Panics
    /// If there are no such parts.
    pub fn split(&self, of: u32) -> Vec<Part> {
        let first = Part::new(1, of).expect("a split has from 1 to Part::MOST parts");
        let count = u32::try_from(self.chain_count()).expect("a sweep has at most 10^9 cases");
        let mut deck: Vec<u32> = (0..count).collect();
        // Costs are above 0, so that they are in the order of their bits. The sort is stable.
        deck.sort_by_cached_key(|&index| Reverse(self.expected_cost(&self.chain(index as usize)).to_bits()));
        let mut parts = vec![first; deck.len()];
        for (round, cards) in deck.chunks(of as usize).enumerate() {
            for (number, &index) in (1..).zip(cards) {
                let number = if round.is_multiple_of(2) { number } else { of + 1 - number };
                parts[index as usize] = Part { of, number };
            }
        }
        parts
    }

    /// The chains of a part, by their places in [`Plan::chains`]; all of them if there are no parts.
    pub fn chains_of(&self, part: Option<Part>) -> Vec<u32> {
        let Some(part) = part else { return (0..).take(self.chain_count()).collect() };
        (0..).zip(self.split(part.of)).filter(|(_, of)| *of == part).map(|(index, _)| index).collect()
    }

    /// What a chain costs, in cases that have a neighbour. It need only be right beside that of other chains.
    fn expected_cost(&self, chain: &Chain) -> f64 {
        let first = self.parameters_at(self.place(chain.row, chain.cases.start));
        let of_one = if first.retardation().is_empty() { ELASTIC } else { 1.0 };
        let decades = (first.beta / THICK).log10().clamp(0.0, 20.0);
        of_one * (chain.cases.len() as f64 + DECADE * decades)
    }
}
