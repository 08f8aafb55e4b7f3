//! Which numbers of a case a shard holds, in a form that is cheap to compare.

use super::StoredOutput;
use crate::{Column, Field, FieldPrecision};
use stribeck_solver::{FieldSelection, Output};

/// What a shard holds beside the columns: fields, the x they are on and their precision, and whether limits and
/// sensitivities were computed.
///
/// `cavity_shear` is not here: it changes the numbers, so it is part of the case's id.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Contents {
    /// The fields stored.
    pub fields: FieldSelection,
    /// Hash of the bits of x; 0 without fields.
    pub x: u64,
    /// How precisely the fields are kept; double without fields.
    pub field_precision: FieldPrecision,
    /// True if the limits beside the solution were computed.
    pub limits: bool,
    /// True if the sensitivities of friction were computed.
    pub sensitivities: bool,
    /// Hash of the names of the columns, which another version of the program may have others of.
    pub columns: u64,
}

impl Contents {
    /// The contents of a shard that is written for what is wanted.
    pub fn of(wanted: impl Into<StoredOutput>) -> Self {
        let StoredOutput { output, field_precision } = wanted.into();
        let Output { fields, limits, sensitivities, .. } = output;
        let (x, field_precision) = match fields.is_empty() {
            true => (0, FieldPrecision::Double),
            false => (x_key(&output.x), field_precision),
        };
        Self { fields, x, field_precision, limits, sensitivities, columns: columns_key() }
    }

    /// True if a shard with these contents holds everything that `wanted` asks for. It may hold more.
    pub fn covers(&self, wanted: &Self) -> bool {
        self.lacks(wanted).is_empty()
    }

    /// Names what `wanted` asks for and a shard with these contents does not hold.
    pub fn lacks(&self, wanted: &Self) -> Vec<&'static str> {
        let mut lacks = Vec::new();
        if self.columns != wanted.columns {
            lacks.push("the columns of this version of the program");
        }
        let both_have_fields = !wanted.fields.is_empty() && !self.fields.is_empty();
        let is_rounded = self.field_precision == FieldPrecision::Single;
        if both_have_fields && self.x != wanted.x {
            lacks.push("fields on this x");
        } else if both_have_fields && is_rounded && wanted.field_precision == FieldPrecision::Double {
            lacks.push("fields of double precision");
        } else {
            let held: Vec<Field> = Field::selected(self.fields).collect();
            lacks.extend(Field::selected(wanted.fields).filter(|field| !held.contains(field)).map(Field::name));
        }
        if wanted.limits && !self.limits {
            lacks.push("limits");
        }
        if wanted.sensitivities && !self.sensitivities {
            lacks.push("sensitivities");
        }
        lacks
    }
}

/// The names of all columns, as a shard lists them.
pub(super) fn column_names() -> String {
    Column::ALL.map(Column::name).join(" ")
}

/// The names of the selected fields, separated by spaces.
pub(super) fn field_names(selection: FieldSelection) -> String {
    Field::selected(selection).map(Field::name).collect::<Vec<_>>().join(" ")
}

/// Hash of the names of the columns of this version.
pub(super) fn columns_key() -> u64 {
    first_eight(&blake3::hash(column_names().as_bytes()))
}

fn first_eight(hash: &blake3::Hash) -> u64 {
    u64::from_le_bytes(*hash.as_bytes().first_chunk().expect("a BLAKE3 hash has 32 bytes"))
}

/// Hash of the bits of x, never 0.
pub(super) fn x_key(x: &[f64]) -> u64 {
    let mut hasher = blake3::Hasher::new();
    for value in x {
        hasher.update(&value.to_bits().to_le_bytes());
    }
    first_eight(&hasher.finalize()).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_covers_less_and_never_the_other_way() {
        let all = Contents::of(&Output::default());
        let none = Contents::of(&Output { fields: FieldSelection::default(), limits: false, ..Output::default() });
        assert!(all.covers(&all) && all.covers(&none) && none.covers(&none));
        assert!(!none.covers(&all));
        let moved = Output { x: [0.0, 1.0].into(), ..Output::default() };
        assert!(!all.covers(&Contents::of(&moved)), "fields on another x are other fields");
        let without_limits = Contents { limits: false, ..all };
        assert!(all.covers(&without_limits) && !without_limits.covers(&all));
        let with_sensitivities = Contents { sensitivities: true, ..all };
        assert!(with_sensitivities.covers(&all) && !all.covers(&with_sensitivities));
        let other_columns = Contents { columns: all.columns ^ 1, ..all };
        assert!(!all.covers(&other_columns) && !other_columns.covers(&all));
    }

    /// Fields of double precision can still be rounded; rounded ones are of no use where those are wanted.
    #[test]
    fn double_covers_single_and_never_the_other_way() {
        let output = Output::default();
        let single = |output: &Output| {
            Contents::of(&StoredOutput { output: output.clone(), field_precision: FieldPrecision::Single })
        };
        let (double, rounded) = (Contents::of(&output), single(&output));
        assert!(double.covers(&rounded) && rounded.covers(&rounded));
        assert_eq!(rounded.lacks(&double), ["fields of double precision"]);
        let bare = Output { fields: FieldSelection::default(), ..output };
        assert_eq!(single(&bare), Contents::of(&bare), "without fields there is nothing to be rounded");
        assert!(rounded.covers(&Contents::of(&bare)));
    }

    #[test]
    fn what_is_lacking_is_named() {
        let all = Contents::of(&Output::default());
        let pressure = FieldSelection { pressure: true, ..FieldSelection::default() };
        let modest = Contents::of(&Output { fields: pressure, limits: false, ..Output::default() });
        let lacks = ["film_thickness", "displacement", "shear_traction", "hysteresis_traction", "limits"];
        assert_eq!(modest.lacks(&all), lacks);
        let more = Contents::of(&Output { sensitivities: true, ..Output::default() });
        assert_eq!(all.lacks(&more), ["sensitivities"]);
        let moved = Contents::of(&Output { x: [0.0, 1.0].into(), ..Output::default() });
        assert_eq!(moved.lacks(&all), ["fields on this x"]);
        assert_eq!(all.lacks(&all), [""; 0]);
    }
}
