//! One case of a finished chain, as the store keeps it.

use crate::{CaseId, Values};
use stribeck_solver::continuation::Seed;
use stribeck_solver::{Fields, Sensitivities};

/// What became of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Solved to the tolerance asked for.
    Converged,
    /// No solution; the reason says why.
    Failed,
}

impl Status {
    /// What it is, in words.
    pub const LONG_NAME: &'static str = "what became of the case";
    /// What the reason beside it is, in words.
    pub const REASON_LONG_NAME: &'static str = "why the case failed; empty if it converged";

    /// Both statuses, in the order of their codes.
    pub const ALL: [Self; 2] = [Self::Converged, Self::Failed];

    /// The flag value in HDF5 files.
    pub fn code(self) -> i8 {
        match self {
            Self::Converged => 0,
            Self::Failed => 1,
        }
    }

    /// The status with the given flag value.
    pub fn from_code(code: i8) -> Option<Self> {
        Self::ALL.into_iter().find(|status| status.code() == code)
    }

    /// The word in `summary.csv`, and the flag meaning in HDF5 files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Failed => "failed",
        }
    }
}

/// What a case cost; differs from run to run, so it is kept in the log and never in a shard.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timing {
    /// Wall-clock seconds; finite, not negative.
    pub seconds: f64,
    /// Passes or Newton iterations, failed attempts included.
    pub iterations: u64,
    /// Matrix factorisations.
    pub factorisations: u64,
    /// The seed that led to the outcome; `None` if another version of the program recorded a seed that this one has
    /// not.
    pub seed: Option<Seed>,
    /// The time limit in seconds at which the case was given up, if that is why it failed; above 0.
    pub time_limit: Option<f64>,
}

/// One case of a finished chain.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseEntry {
    /// Which problem this is.
    pub id: CaseId,
    /// What became of it.
    pub outcome: Status,
    /// Why it failed, one line; empty if it converged.
    pub reason: String,
    /// The [name](stribeck_solver::FailureKind::name) of the kind of its failure; `None` if it converged.
    pub failure_kind: Option<String>,
    /// Its numbers; NaN where there is none.
    pub values: Values,
    /// The fields of the store's output; all `None` for a failed case.
    pub fields: Fields,
    /// How friction changes with the parameters, if the store's output asks for it; `None` for a failed case.
    pub sensitivities: Option<Sensitivities>,
    /// Their estimated errors; `None` also where shards of earlier versions have none.
    pub sensitivity_errors: Option<Sensitivities>,
    /// What it cost.
    pub timing: Timing,
}
