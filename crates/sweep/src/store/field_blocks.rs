//! A field of `results.h5`, written in blocks of neighbouring places.
//!
//! A block is what is compressed together, and what a reader has to read for one number of it. Blocks lie along the last
//! dimension and have about a megabyte: many more and smaller ones cost those who go through a data set in pieces far
//! more time than its bytes do.

use hdf5::{Dataset, Hyperslab, Result, SliceOrIndex};
use ndarray::ArrayView2;

use crate::grid_index::indices;

/// About so many bytes has a block.
const BYTES: usize = 1 << 20;

/// So many places of a row make a block: rows are cut evenly.
pub(super) fn places_in_block(length: usize, width: usize) -> usize {
    let most = (BYTES / (size_of::<f64>() * width.max(1))).max(1);
    length.div_ceil(length.div_ceil(most).max(1)).max(1)
}

/// A field while it is written, place after place.
pub(super) struct FieldBlocks {
    variable: Dataset,
    /// Lengths of the dimensions, without x.
    shape: Vec<usize>,
    /// Values of a place.
    width: usize,
    /// Places of a block.
    places: usize,
    /// The block at work: its first place, and its values.
    block: Option<(usize, Vec<f64>)>,
}

impl FieldBlocks {
    /// A field without values yet.
    pub(super) fn new(variable: Dataset, shape: &[usize], width: usize) -> Self {
        let length = shape.last().copied().unwrap_or(1);
        let places = places_in_block(length, width);
        Self { variable, shape: shape.to_vec(), width, places, block: None }
    }

    /// Takes the values of a place; places come in their order, the last dimension fastest. Those left out are NaN.
    pub(super) fn write(&mut self, place: usize, values: &[f64]) -> Result<()> {
        let length = self.shape.last().copied().unwrap_or(1);
        let along = place % length;
        let first = place - along % self.places;
        if self.block.as_ref().is_none_or(|(at, _)| *at != first) {
            self.flush()?;
            let places = self.places.min(length - along / self.places * self.places);
            self.block = Some((first, vec![f64::NAN; places * self.width]));
        }
        if let Some((_, block)) = &mut self.block {
            block[(place - first) * self.width..][..self.width].copy_from_slice(values);
        }
        Ok(())
    }

    /// Writes the block at work to the file.
    pub(super) fn flush(&mut self) -> Result<()> {
        let Some((first, values)) = self.block.take() else { return Ok(()) };
        let rows = values.len() / self.width;
        let mut selection: Vec<SliceOrIndex> =
            indices(self.shape.iter().copied(), first).into_iter().map(SliceOrIndex::Index).collect();
        if let Some(SliceOrIndex::Index(start)) = selection.pop() {
            selection.push(SliceOrIndex::SliceCount { start, step: 1, count: rows, block: 1 });
        }
        selection.push(SliceOrIndex::SliceCount { start: 0, step: 1, count: self.width, block: 1 });
        self.variable.write_slice(ArrayView2::from_shape((rows, self.width), &values)?, Hyperslab::from(selection))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        #[test]
        fn blocks_have_about_a_megabyte_and_cut_a_row_evenly(length in 1_usize..5000, width in 1_usize..300_000) {
            let places = places_in_block(length, width);
            let bytes = places * width * size_of::<f64>();
            prop_assert!((1..=length).contains(&places) && (places == 1 || bytes <= BYTES));
            let blocks = length.div_ceil(places);
            // The last block is no scrap, and there are not twice as many as there must be.
            prop_assert!(blocks * places - length < blocks);
            prop_assert!(places == 1 || places == length || 2 * bytes + width * size_of::<f64>() * 2 >= BYTES);
        }
    }
}
