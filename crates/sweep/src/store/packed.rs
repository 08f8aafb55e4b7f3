//! Numbers packed as a chunk of an HDF5 file holds them, so that any thread may pack them and HDF5 only moves bytes.
//!
//! HDF5 calls its filters shuffle and deflate: the bytes of all numbers are sorted by their significance, and the
//! result is compressed in the format of zlib. Here the library libdeflate does that, two to three times as fast. The
//! last digits of numbers are as good as random: where the least significant bytes are, they are stored as they are,
//! which the format allows, and only the others are compressed.

use std::array::from_fn;
use std::cell::RefCell;

use hdf5::Result;
use libdeflater::{CompressionLvl, Compressor, Decompressor, adler32};

/// How hard to pack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effort {
    /// Quickly, what is read again once or twice.
    Quick,
    /// Smaller, what is published.
    Small,
}

impl Effort {
    fn level(self) -> i32 {
        match self {
            Self::Quick => 1,
            Self::Small => 5,
        }
    }

    /// Random planes that are compressed nevertheless. In a block of neighbouring fields the last one repeats itself,
    /// though each of its bytes is as frequent as any other.
    fn compressed(self) -> usize {
        match self {
            Self::Quick => 0,
            Self::Small => 1,
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
        let random = sorted.chunks_exact(values.len().max(1)).take_while(|plane| is_random(plane)).count();
        let (stored, rest) = sorted.split_at(random.saturating_sub(effort.compressed()) * values.len());
        let mut bytes = ZLIB.to_vec();
        for block in stored.chunks(usize::from(u16::MAX)) {
            store(block, &mut bytes);
        }
        COMPRESSORS.with(|compressors| {
            let mut compressor = compressors[effort as usize].borrow_mut();
            let start = bytes.len();
            bytes.resize(start + compressor.deflate_compress_bound(rest.len()), 0);
            let length = compressor.deflate_compress(rest, &mut bytes[start..]).expect("the bound is large enough");
            bytes.truncate(start + length);
        });
        bytes.extend(adler32(&sorted).to_be_bytes());
        bytes.shrink_to_fit();
        Self { count: values.len(), bytes }
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

/// The header of zlib: deflate with a window of 32 kB.
const ZLIB: [u8; 2] = [0x78, 0x01];

/// Appends at most 65535 bytes as a block of deflate that is stored and not the last one (RFC 1951, 3.2.4). It begins
/// and ends at whole bytes.
fn store(block: &[u8], bytes: &mut Vec<u8>) {
    let length = u16::try_from(block.len()).expect("a stored block has at most 65535 bytes");
    bytes.push(0);
    bytes.extend(length.to_le_bytes());
    bytes.extend((!length).to_le_bytes());
    bytes.extend(block);
}

/// Two bytes of a plane are the same so much more often than two random ones, at most, if it is stored as it is: a code
/// for single bytes would save at most a hundredth of it.
const MOST_EQUAL: f64 = 1.1;

/// True if it is not worth while to compress these bytes.
fn is_random(plane: &[u8]) -> bool {
    // Four counts of each byte, as a count that follows another one of the same byte waits for it.
    let mut counts = [[0_u32; 256]; 4];
    let (fours, rest) = plane.as_chunks::<4>();
    for four in fours {
        for (counts, byte) in counts.iter_mut().zip(four) {
            counts[usize::from(*byte)] += 1;
        }
    }
    for byte in rest {
        counts[0][usize::from(*byte)] += 1;
    }
    let pairs = |count: f64| count * (count - 1.0);
    let equal: f64 = (0..256).map(|byte| pairs(counts.iter().map(|counts| f64::from(counts[byte])).sum())).sum();
    256.0 * equal < MOST_EQUAL * pairs(plane.len() as f64)
}

/// Bytes of a number.
const WIDTH: usize = size_of::<f64>();

/// The first bytes of all numbers as they stand in memory, then the second bytes, and so on.
fn shuffle(values: &[f64]) -> Vec<u8> {
    let mut sorted = vec![0; values.len() * WIDTH];
    let mut rest = &mut sorted[..];
    let mut planes: [&mut [u8]; WIDTH] =
        from_fn(|_| rest.split_off_mut(..values.len()).expect("there is a plane left"));
    let (blocks, last) = values.as_chunks::<WIDTH>();
    for (block, values) in blocks.iter().enumerate() {
        let rows = transposed(values.map(f64::to_ne_bytes));
        for (plane, row) in planes.iter_mut().zip(rows) {
            plane[block * WIDTH..][..WIDTH].copy_from_slice(&row);
        }
    }
    for (i, value) in (blocks.len() * WIDTH..).zip(last) {
        for (plane, byte) in planes.iter_mut().zip(value.to_ne_bytes()) {
            plane[i] = byte;
        }
    }
    sorted
}

fn unshuffle(sorted: &[u8]) -> Vec<f64> {
    let count = sorted.len() / WIDTH;
    let plane = |of: usize| &sorted[of * count..][..count];
    let planes: [&[u8]; WIDTH] = from_fn(plane);
    let mut values = vec![0.0; count];
    let (blocks, last) = values.as_chunks_mut::<WIDTH>();
    for (block, values) in blocks.iter_mut().enumerate() {
        let rows = planes.map(|plane| from_fn(|i| plane[block * WIDTH + i]));
        *values = transposed(rows).map(f64::from_ne_bytes);
    }
    for (i, value) in (count / WIDTH * WIDTH..).zip(last) {
        *value = f64::from_ne_bytes(planes.map(|plane| plane[i]));
    }
    values
}

/// Rows and columns exchanged: in three steps, each of which exchanges halves of squares of bytes in whole registers.
fn transposed(rows: [[u8; WIDTH]; WIDTH]) -> [[u8; WIDTH]; WIDTH] {
    let mut rows = rows.map(u64::from_le_bytes);
    for (half, low) in [(4, 0x0000_0000_ffff_ffff), (2, 0x0000_ffff_0000_ffff), (1, 0x00ff_00ff_00ff_00ff_u64)] {
        for upper in (0..WIDTH).filter(|row| row & half == 0) {
            let (above, below) = (rows[upper], rows[upper + half]);
            rows[upper] = above & low | (below & low) << (8 * half);
            rows[upper + half] = above >> (8 * half) & low | below & !low;
        }
    }
    rows.map(u64::to_le_bytes)
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

        /// Whatever of the bytes is stored as it is.
        #[test]
        fn numbers_are_unpacked_bit_by_bit(bits in prop::collection::vec(any::<u64>(), 0..2000), random in 0_u32..=64) {
            let bits: Vec<u64> = bits.iter().map(|&bits| bits & (1_u64 << random.min(63)).wrapping_sub(1)).collect();
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
