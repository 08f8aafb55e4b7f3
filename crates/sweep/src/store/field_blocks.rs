//! The fields of `results.h5`, written in blocks of neighbouring places.
//!
//! A block is what is compressed together, and what a reader has to read for one number of it. Blocks lie along the
//! last dimension and have about a megabyte: many more and smaller ones cost those who go through a data set in pieces
//! far more time than its bytes do.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvError, TryRecvError, channel};
use std::thread;
use std::time::Duration;

use hdf5::Result;

use super::StoredOutput;
use super::chunks::Chunks;
use super::packed::{Effort, Packed};
use super::placed::Placing;
use crate::grid_index::indices;
use crate::{Field, FieldPrecision};

/// About so many bytes has a block.
const BYTES: usize = 1 << 20;

/// Most places of a block: each takes some memory until its block is written, however few its values are.
const MOST_PLACES: usize = 1 << 13;

/// So many places of a row make a block: rows are cut evenly.
pub(super) fn places_in_block(length: usize, width: usize) -> usize {
    let most = (BYTES / (size_of::<f64>() * width.max(1))).clamp(1, MOST_PLACES);
    length.div_ceil(length.div_ceil(most).max(1)).max(1)
}

/// Values of the blocks that are unpacked and packed again together, in parallel, while as many others are read.
const AT_ONCE: usize = 1 << 21;

/// A place that waits takes about the memory of so many values beside its own.
const OF_PLACE: usize = 32;

/// The fields of a publication while they are written, place after place.
pub(super) struct FieldBlocks {
    /// The fields, with their chunks, which are the blocks.
    fields: Vec<(Field, Chunks)>,
    /// Lengths of the dimensions, without x.
    shape: Vec<usize>,
    /// Where the fields are given.
    x: Arc<[f64]>,
    /// How precisely they are published.
    precision: FieldPrecision,
    /// Places of a block.
    places: usize,
    /// The blocks that wait; the last one may not be whole.
    waiting: Vec<Block>,
    /// Those that were before them.
    packing: Packing,
}

/// Blocks at work: of each, its first place, and which of the fields it has.
#[derive(Default)]
struct Packing {
    blocks: Vec<(usize, usize)>,
    /// The packed ones, each with its number, as they come.
    packed: Option<Receiver<(usize, Result<Packed>)>>,
}

/// A block of neighbouring places, with what is there of their fields.
struct Block {
    first: usize,
    /// Of each place that has fields: the place, and each field in the order of the publication.
    sources: Vec<(usize, Vec<FieldSource>)>,
}

/// A stored field, and what makes it the one of its place.
pub(super) struct FieldSource {
    /// As the shard has it.
    pub stored: Packed,
    /// What is done with it.
    pub placing: Placing,
}

impl FieldBlocks {
    /// Fields without values yet.
    pub(super) fn new(fields: Vec<(Field, Chunks)>, shape: &[usize], wanted: &StoredOutput) -> Self {
        let StoredOutput { output, field_precision } = wanted;
        let places = places_in_block(shape.last().copied().unwrap_or(1), output.x.len());
        let (x, precision) = (Arc::clone(&output.x), *field_precision);
        Self { fields, shape: shape.to_vec(), x, precision, places, waiting: Vec::new(), packing: Packing::default() }
    }

    /// The fields.
    pub(super) fn fields(&self) -> impl Iterator<Item = Field> {
        self.fields.iter().map(|(field, _)| *field)
    }

    /// Takes the fields of a place, in the order of [`FieldBlocks::fields`]; places come in their order, the last
    /// dimension fastest. Those left out are NaN.
    pub(super) fn write(&mut self, place: usize, sources: Vec<FieldSource>) -> Result<()> {
        if sources.len() != self.fields.len() {
            return Err(format!("a place has {} fields, not {}", sources.len(), self.fields.len()).into());
        }
        let length = self.shape.last().copied().unwrap_or(1);
        let first = place - place % length % self.places;
        if self.waiting.last().is_none_or(|block| block.first != first) {
            let values = self.places * (self.x.len() + OF_PLACE) * self.fields.len();
            if self.waiting.len() * values >= AT_ONCE {
                self.flush()?;
            }
            self.waiting.push(Block { first, sources: Vec::new() });
        }
        if let Some(block) = self.waiting.last_mut() {
            block.sources.push((place, sources));
        }
        Ok(())
    }

    /// Writes all that is left to the file.
    pub(super) fn finish(&mut self) -> Result<()> {
        self.flush()?;
        let last = std::mem::take(&mut self.packing);
        self.write_blocks(last)
    }

    /// Has the blocks that wait packed by the threads at hand, whose number does not matter for their bytes. Writes
    /// those that were packed before.
    fn flush(&mut self) -> Result<()> {
        let (sender, receiver) = channel();
        let mut blocks = Vec::new();
        for block in std::mem::take(&mut self.waiting) {
            let block = Arc::new(block);
            for field in 0..self.fields.len() {
                let (block, sender, number) = (Arc::clone(&block), sender.clone(), blocks.len());
                let (places, x, precision) = (self.places, Arc::clone(&self.x), self.precision);
                blocks.push((block.first, field));
                rayon::spawn_fifo(move || {
                    let packed = block.values(field, places, &x, precision);
                    // Nobody waits for it where another block could not be written.
                    let _ = sender.send((number, packed.map(|values| Packed::new(&values, Effort::Small))));
                });
            }
        }
        let before = std::mem::replace(&mut self.packing, Packing { blocks, packed: Some(receiver) });
        self.write_blocks(before)
    }

    /// Writes blocks in their order, which the bytes of the file depend on.
    fn write_blocks(&self, Packing { blocks, packed }: Packing) -> Result<()> {
        let Some(receiver) = packed else { return Ok(()) };
        let mut packed = vec![None; blocks.len()];
        for ((first, field), number) in blocks.into_iter().zip(0..) {
            while packed[number].is_none() {
                let (number, block) = next(&receiver).map_err(|error| hdf5::Error::Internal(error.to_string()))?;
                packed[number] = Some(block?);
            }
            let mut at = indices(self.shape.iter().copied(), first);
            at.push(0);
            if let Some(packed) = packed[number].take() {
                self.fields[field].1.write(&at, &packed)?;
            }
        }
        Ok(())
    }
}

/// Waits for what another thread sends. A thread of a pool works with the others meanwhile: it may be the only one.
fn next<T>(receiver: &Receiver<T>) -> std::result::Result<T, RecvError> {
    loop {
        match receiver.try_recv() {
            Ok(sent) => return Ok(sent),
            Err(TryRecvError::Disconnected) => return Err(RecvError),
            Err(TryRecvError::Empty) => match rayon::yield_now() {
                Some(rayon::Yield::Executed) => {}
                Some(rayon::Yield::Idle) => thread::sleep(Duration::from_micros(100)),
                None => return receiver.recv(),
            },
        }
    }
}

impl Block {
    /// A field of so many places from the first one on. What is beyond the end of the last dimension is NaN as well.
    fn values(&self, field: usize, places: usize, x: &[f64], precision: FieldPrecision) -> Result<Vec<f64>> {
        let mut values = vec![f64::NAN; places * x.len()];
        for (place, sources) in &self.sources {
            let FieldSource { stored, placing } = &sources[field];
            let mut stored = stored.unpack()?;
            // Before it is placed too: what is published does not depend on how precisely it is stored.
            precision.round(&mut stored);
            placing.apply(x, &mut stored);
            precision.round(&mut stored);
            values[(place - self.first) * x.len()..][..x.len()].copy_from_slice(&stored);
        }
        Ok(values)
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
            let is_full = 2 * bytes + width * size_of::<f64>() * 2 >= BYTES || 2 * places + 2 >= MOST_PLACES;
            prop_assert!(places == 1 || places == length || is_full);
        }
    }
}
