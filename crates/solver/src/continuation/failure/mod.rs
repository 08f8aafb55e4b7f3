//! Why a case has no solution: a kind with its numbers, and how the search for a solution went.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `kind.rs` | [`FailureKind`]: what happened, with its sentence |
//! | `text.rs` | the kind of a failure whose text is all that was stored |
//! | `waypoint.rs` | [`Waypoint`]: where on the way to a case it happened |

use std::fmt;

use super::Seed;
use crate::model::{OutOfRange, Parameters};

mod kind;
mod text;
mod waypoint;

pub use kind::{ErrorMeasure, FailureKind, Iterations};
pub use text::kind_name_of_text;
pub use waypoint::Waypoint;

/// Why a case has no solution. Failing is a result, not an error of the run.
///
/// Its text is one line for a person, with all attempts in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// What happened; of several attempts, in the last one.
    pub kind: FailureKind,
    /// Where that was, if it was not at the case itself.
    pub waypoint: Option<Box<Waypoint>>,
    /// The seed that the attempt began from, if the failure belongs to one: [`Seed::None`] if there was no first guess.
    pub seed: Option<Seed>,
    /// The attempts before this one, in their order.
    pub earlier: Vec<Failure>,
}

impl Failure {
    /// The same failure at a point on the way to a case.
    #[must_use]
    pub(super) fn at(self, here: &Parameters, case: &Parameters) -> Self {
        let waypoint = Waypoint::between(here, case);
        let waypoint = if waypoint == Waypoint::default() { self.waypoint } else { Some(Box::new(waypoint)) };
        Self { waypoint, ..self }
    }

    /// The same failure as that of an attempt from a seed.
    #[must_use]
    pub(super) fn seeded_by(self, seed: Seed) -> Self {
        Self { seed: Some(seed), ..self }
    }

    /// The same failure after other attempts.
    #[must_use]
    pub(super) fn after(self, earlier: Vec<Failure>) -> Self {
        Self { earlier, ..self }
    }
}

impl From<FailureKind> for Failure {
    fn from(kind: FailureKind) -> Self {
        Self { kind, waypoint: None, seed: None, earlier: Vec::new() }
    }
}

impl From<OutOfRange> for Failure {
    fn from(out_of_range: OutOfRange) -> Self {
        FailureKind::from(out_of_range).into()
    }
}

impl std::error::Error for Failure {}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for failure in &self.earlier {
            write!(formatter, "{failure}; ")?;
        }
        match &self.seed {
            Some(Seed::None) => formatter.write_str("no first guess: ")?,
            Some(seed) => write!(formatter, "from {seed}: ")?,
            None => {}
        }
        if let Some(waypoint) = &self.waypoint {
            write!(formatter, "at {waypoint}: ")?;
        }
        self.kind.fmt(formatter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_tells_seeds_and_waypoints() {
        let (case, here) = (Parameters::new(1.0, 100.0, 10.0), Parameters::new(1.0, 5.0, 10.0));
        let first = Failure::from(FailureKind::NewtonBrokeDown).seeded_by(Seed::None);
        let last = Failure::from(FailureKind::FlowLost).at(&here, &case).seeded_by(Seed::March(2)).after(vec![first]);
        let expected = "no first guess: Newton's method broke down: a step is not finite; \
                        from march-2: at beta = 5.0000e0: the iteration ends in a state that does not conserve the flow at all; use more points";
        assert_eq!(last.to_string(), expected);
    }
}
