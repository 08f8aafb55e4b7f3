//! A validated study: cases, methods, and what is measured.

use super::Variant;
use stribeck_solver::Parameters;
use stribeck_sweep::Axes;

/// A study: every method at every setting solves every case.
///
/// [`Study::read`] and [`Study::parse`] only give studies with at least one case, one variant and one thing to measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// Title of tables and pictures.
    pub title: String,
    /// The axes of a box, if the study has one.
    pub axes: Option<Axes>,
    /// The cases in the order of the tables: those of the box (f, then α, then β), then single ones.
    pub cases: Vec<Parameters>,
    /// The methods at their settings; those of one method follow one another.
    pub variants: Vec<Variant>,
    /// What is measured.
    pub measure: Measure,
    /// How often each case is timed.
    pub repeats: usize,
    /// What a case starts from.
    pub start: Start,
    /// The study file as it was read.
    pub text: String,
    /// Stem of the file's name.
    pub name: String,
}

/// What is measured; at least one of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Measure {
    /// Error against run time.
    pub error: bool,
    /// Where a method is stable, and how stable.
    pub stability: bool,
}

/// What a case starts from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// Nothing: the whole way to each case is its own.
    #[default]
    Alone,
    /// The cases of smaller β with the same α and f, as in a sweep.
    Chain,
}

impl Study {
    /// Most cases times settings.
    pub const MOST_ROWS: usize = 100_000;

    /// The cases that are solved one after the other, as ranges of `cases`.
    pub fn groups(&self) -> Vec<std::ops::Range<usize>> {
        let mut groups: Vec<std::ops::Range<usize>> = Vec::new();
        for (i, case) in self.cases.iter().enumerate() {
            let follows = i.checked_sub(1).map(|before| &self.cases[before]).is_some_and(|before| {
                self.start == Start::Chain
                    && (before.f, before.alpha) == (case.f, case.alpha)
                    && before.beta < case.beta
            });
            match groups.last_mut() {
                Some(group) if follows => group.end = i + 1,
                _ => groups.push(i..i + 1),
            }
        }
        groups
    }

    /// The methods, each with the range of its settings in `variants`.
    pub fn methods(&self) -> Vec<(&str, std::ops::Range<usize>)> {
        let mut methods: Vec<(&str, std::ops::Range<usize>)> = Vec::new();
        for (i, variant) in self.variants.iter().enumerate() {
            match methods.last_mut() {
                Some((method, range)) if *method == variant.method => range.end = i + 1,
                _ => methods.push((&variant.method, i..i + 1)),
            }
        }
        methods
    }
}
