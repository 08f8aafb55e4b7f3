//! Where on the way to a case an attempt failed.

use std::fmt;

use crate::model::Parameters;

/// A point on the way to a case: the coordinates in which it differs from the case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Waypoint {
    /// α there.
    pub alpha: Option<f64>,
    /// β there.
    pub beta: Option<f64>,
    /// f there.
    pub f: Option<f64>,
}

impl Waypoint {
    pub(super) fn between(here: &Parameters, case: &Parameters) -> Self {
        let other = |here: f64, case: f64| (here != case).then_some(here);
        Self { alpha: other(here.alpha, case.alpha), beta: other(here.beta, case.beta), f: other(here.f, case.f) }
    }
}

impl fmt::Display for Waypoint {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let coordinates = [("alpha", self.alpha), ("beta", self.beta), ("f", self.f)];
        let texts = coordinates.into_iter().filter_map(|(name, value)| Some(format!("{name} = {:.4e}", value?)));
        formatter.write_str(&texts.collect::<Vec<_>>().join(", "))
    }
}
