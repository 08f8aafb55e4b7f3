//! Which numbers of a case a shard holds, in a form that is cheap to compare.

use crate::model::{FieldSelection, Fields, Output};

/// What a shard holds beside the columns: fields, the x they are on, and whether the limits were computed.
///
/// `cavity_shear` is not here: it changes the numbers, so it is part of the case's id.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Contents {
    /// The fields stored.
    pub fields: FieldSelection,
    /// Hash of the bits of x; 0 without fields.
    pub x: u64,
    /// True if the limits beside the solution were computed.
    pub limits: bool,
}

impl Contents {
    /// What a shard holds that was written for `output`.
    pub fn of(output: &Output) -> Self {
        let x = if output.fields.is_empty() { 0 } else { x_key(&output.x) };
        Self { fields: output.fields, x, limits: output.limits }
    }

    /// True if a shard with these contents has all that `wanted` asks for; it may hold more.
    pub fn covers(&self, wanted: &Self) -> bool {
        let fields = wanted.fields.is_empty() || (self.x == wanted.x && self.fields.covers(&wanted.fields));
        fields && (self.limits || !wanted.limits)
    }
}

/// Hash of the bits of x, never 0.
pub(super) fn x_key(x: &[f64]) -> u64 {
    let mut hasher = blake3::Hasher::new();
    for value in x {
        hasher.update(&value.to_bits().to_le_bytes());
    }
    let mut first = [0; 8];
    hasher.finalize_xof().fill(&mut first);
    u64::from_le_bytes(first).max(1)
}

/// A field as the files name it.
pub(super) struct FieldName {
    pub name: &'static str,
    pub units: &'static str,
    pub long_name: &'static str,
}

/// The fields in the order of [`FieldSelection::names`].
pub(super) const FIELDS: [FieldName; 3] = [
    FieldName { name: "pressure", units: "2N/(pi a0)", long_name: "pressure in the film" },
    FieldName { name: "film_thickness", units: "a0^2/R", long_name: "film thickness" },
    FieldName { name: "displacement", units: "a0^2/R", long_name: "normal displacement of the surface" },
];

/// The field at a place in [`FIELDS`].
pub(super) fn field(fields: &Fields, place: usize) -> Option<&Vec<f64>> {
    [&fields.pressure, &fields.film_thickness, &fields.displacement][place].as_ref()
}

/// The same, to be filled.
pub(super) fn field_mut(fields: &mut Fields, place: usize) -> &mut Option<Vec<f64>> {
    match place {
        0 => &mut fields.pressure,
        1 => &mut fields.film_thickness,
        _ => &mut fields.displacement,
    }
}

/// Whether the field at a place in [`FIELDS`] is selected.
pub(super) fn selected(selection: &FieldSelection, place: usize) -> bool {
    [selection.pressure, selection.film_thickness, selection.displacement][place]
}

/// The places in [`FIELDS`] that are selected.
pub(super) fn places(selection: FieldSelection) -> impl Iterator<Item = usize> {
    (0..FIELDS.len()).filter(move |&place| selected(&selection, place))
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
    }

    #[test]
    fn the_places_of_fields_agree_with_their_names() {
        for bits in 0..8 {
            let selection =
                FieldSelection { pressure: bits & 1 != 0, film_thickness: bits & 2 != 0, displacement: bits & 4 != 0 };
            let names: Vec<_> = places(selection).map(|place| FIELDS[place].name).collect();
            assert_eq!(names, selection.names());
        }
    }
}
