//! Numbers packed as a chunk of an HDF5 file holds them, so that any thread may pack them and HDF5 only moves bytes.
//!
//! HDF5 calls its filters shuffle and deflate: the bytes of all numbers are sorted by their significance, and the
//! result is compressed in the format of zlib. Here the library libdeflate does that, two to three times as fast.

use std::cell::RefCell;

use hdf5::Result;
use libdeflater::{CompressionLvl, Compressor, Decompressor};

/// How hard to pack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effort {
    /// Quickly, what is read again once or twice.
    Quick,
    /// Smaller by a percent, what is published.
    Small,
}

impl Effort {
    fn level(self) -> i32 {
        match self {
            Self::Quick => 1,
            Self::Small => 2,
        }
    }
}

/// Numbers of a chunk, packed.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Packed {
    /// How many numbers they are.
    pub count: usize,
    /// What HDF5 stores of them.
    pub bytes: Vec<u8>,
}

impl Packed {
    /// Packs numbers. The bytes follow from the numbers alone.
    pub(super) fn new(values: &[f64], effort: Effort) -> Self {
        thread_local! {
            static COMPRESSORS: [RefCell<Compressor>; 2] = [Effort::Quick, Effort::Small].map(|effort| {
                let level = CompressionLvl::new(effort.level()).expect("a level that libdeflate has");
                RefCell::new(Compressor::new(level))
            });
        }
        let sorted = shuffle(values);
        COMPRESSORS.with(|compressors| {
            let mut compressor = compressors[effort as usize].borrow_mut();
            let mut bytes = vec![0; compressor.zlib_compress_bound(sorted.len())];
            let length = compressor.zlib_compress(&sorted, &mut bytes).expect("the bound is large enough");
            bytes.truncate(length);
            bytes.shrink_to_fit();
            Self { count: values.len(), bytes }
        })
    }

    /// The numbers.
    ///
    /// # Errors
    /// If the bytes are not those of so many numbers.
    pub(super) fn unpack(&self) -> Result<Vec<f64>> {
        let mut sorted = vec![0; self.count * WIDTH];
        match Decompressor::new().zlib_decompress(&self.bytes, &mut sorted) {
            Ok(length) if length == sorted.len() => Ok(unshuffle(&sorted)),
            Ok(length) => Err(format!("a chunk has {length} bytes, not {}", sorted.len()).into()),
            Err(error) => Err(format!("a chunk cannot be unpacked: {error}").into()),
        }
    }
}

/// Bytes of a number.
const WIDTH: usize = size_of::<f64>();

/// The first bytes of all numbers as they stand in memory, then the second bytes, and so on.
fn shuffle(values: &[f64]) -> Vec<u8> {
    let mut sorted = vec![0; values.len() * WIDTH];
    for (i, value) in values.iter().enumerate() {
        for (plane, byte) in value.to_ne_bytes().into_iter().enumerate() {
            sorted[plane * values.len() + i] = byte;
        }
    }
    sorted
}

fn unshuffle(sorted: &[u8]) -> Vec<f64> {
    let count = sorted.len() / WIDTH;
    let number = |i: usize| f64::from_ne_bytes(std::array::from_fn(|plane| sorted[plane * count + i]));
    (0..count).map(number).collect()
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
        fn numbers_are_unpacked_bit_by_bit(bits in prop::collection::vec(any::<u64>(), 0..2000)) {
            let values: Vec<f64> = bits.iter().map(|&bits| f64::from_bits(bits)).collect();
            for effort in [Effort::Quick, Effort::Small] {
                let packed = Packed::new(&values, effort);
                let back: Vec<u64> = packed.unpack().unwrap().into_iter().map(f64::to_bits).collect();
                prop_assert_eq!(&back, &bits);
                if let Some(count) = packed.count.checked_sub(1) {
                    let shorter = Packed { count, ..packed };
                    prop_assert!(shorter.unpack().is_err());
                }
            }
        }
    }
}
