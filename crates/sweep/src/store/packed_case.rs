//! One case of a finished chain, ready to be written: with its fields packed.

use super::packed::{Effort, Packed};
use super::{CaseEntry, Contents};
use crate::Field;
use stribeck_solver::Fields;

/// A case as the store commits it. To pack its fields is most of the work of storing it, and may be done by the thread
/// that solved it.
#[derive(Clone, Debug, PartialEq)]
pub struct PackedCase {
    /// The case without its fields.
    entry: CaseEntry,
    /// In the order of [`Field::ALL`].
    fields: [Option<Packed>; Field::ALL.len()],
}

impl PackedCase {
    /// Packs the fields of a case that a store has, as precisely as it has them; others are left out.
    pub fn new(entry: CaseEntry, contents: &Contents) -> Self {
        let mut fields = [const { None }; Field::ALL.len()];
        for field in Field::selected(contents.fields) {
            fields[field as usize] = field.of(&entry.fields).map(|values| {
                let mut values = values.to_vec();
                contents.field_precision.round(&mut values);
                Packed::new(&values, Effort::Quick)
            });
        }
        Self { entry: CaseEntry { fields: Fields::default(), ..entry }, fields }
    }

    /// The case without its fields.
    pub fn entry(&self) -> &CaseEntry {
        &self.entry
    }

    /// One of its fields.
    pub(super) fn field(&self, field: Field) -> Option<&Packed> {
        self.fields[field as usize].as_ref()
    }
}
