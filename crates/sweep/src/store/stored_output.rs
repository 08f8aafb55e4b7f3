//! What a store keeps of each case.

use crate::{FieldPrecision, Sweep};
use stribeck_solver::Output;

/// What a store keeps of each case: what is solved for, and how precisely fields are kept.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredOutput {
    /// What is solved for.
    pub output: Output,
    /// How precisely fields are kept.
    pub field_precision: FieldPrecision,
}

/// As it is solved.
impl From<&Output> for StoredOutput {
    fn from(output: &Output) -> Self {
        Self { output: output.clone(), field_precision: FieldPrecision::Double }
    }
}

/// As the sweep wants it.
impl From<&Sweep> for StoredOutput {
    fn from(sweep: &Sweep) -> Self {
        Self { output: sweep.output.clone(), field_precision: sweep.field_precision }
    }
}

impl From<&Self> for StoredOutput {
    fn from(wanted: &Self) -> Self {
        wanted.clone()
    }
}
