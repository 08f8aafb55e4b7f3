//! Chunks of HDF5 data sets as they stand in the file: bytes that are packed already, past the filters of the library.
//!
//! The `hdf5` crate does not wrap these calls, so this file has `unsafe` code.

#![allow(unsafe_code)]

use hdf5::{Dataset, Result, h5check};
use hdf5_sys::h5::{herr_t, hsize_t};
use hdf5_sys::h5d::{H5Dread_chunk, H5Dwrite_chunk};
use hdf5_sys::h5i::hid_t;
use hdf5_sys::h5p::H5P_DEFAULT;

use super::packed::Packed;

unsafe extern "C" {
    fn H5Dget_chunk_storage_size(dataset: hid_t, offset: *const hsize_t, bytes: *mut hsize_t) -> herr_t;
}

/// The chunks of a data set of doubles with the filters shuffle and deflate.
pub(super) struct Chunks {
    dataset: Dataset,
    dimensions: usize,
    /// Numbers of a chunk.
    numbers: usize,
}

impl Chunks {
    /// Those of an open data set.
    pub(super) fn new(dataset: Dataset) -> Self {
        let numbers = dataset.chunk().unwrap_or_default().iter().product();
        Self { dimensions: dataset.ndim(), numbers, dataset }
    }

    /// Writes a chunk. `at` is the index of its first number.
    ///
    /// # Errors
    /// If the numbers do not fill a chunk, or the file cannot be written.
    pub(super) fn write(&self, at: &[usize], packed: &Packed) -> Result<()> {
        let offset = self.offset(at)?;
        if packed.count != self.numbers {
            return Err(format!("{} numbers are no chunk of {}", packed.count, self.dataset.name()).into());
        }
        let (length, bytes) = (packed.bytes.len(), packed.bytes.as_ptr().cast());
        // SAFETY: the id is that of an open data set; the offset has as many numbers as the data set has dimensions;
        // the bytes are as many as is said and only read; the library is called under the lock that serialises all
        // calls.
        let write = || unsafe { H5Dwrite_chunk(self.dataset.id(), H5P_DEFAULT, 0, offset.as_ptr(), length, bytes) };
        hdf5::sync::sync(|| h5check(write()))?;
        Ok(())
    }

    /// Reads a chunk.
    ///
    /// # Errors
    /// If there is no such chunk, its filters were left out, or the file cannot be read.
    pub(super) fn read(&self, at: &[usize]) -> Result<Packed> {
        let offset = self.offset(at)?;
        let (mut length, mut left_out) = (0, 0);
        // SAFETY: the id is that of an open data set; the offset has as many numbers as the data set has dimensions;
        // the library writes one number to `length`, and is called under the lock that serialises all calls.
        let size = &raw mut length;
        let ask = || unsafe { H5Dget_chunk_storage_size(self.dataset.id(), offset.as_ptr(), size) };
        hdf5::sync::sync(|| h5check(ask()))?;
        let length = usize::try_from(length).map_err(|error| hdf5::Error::Internal(error.to_string()))?;
        let mut bytes = vec![0_u8; length];
        let (id, to, mask) = (self.dataset.id(), bytes.as_mut_ptr().cast(), &raw mut left_out);
        // SAFETY: as above; the buffer has as many bytes as the library has just said that the chunk has, and a file
        // that is read is written by no one.
        #[cfg(hdf5_2)]
        let read = || {
            let mut room = length;
            unsafe { H5Dread_chunk(id, H5P_DEFAULT, offset.as_ptr(), mask, to, &raw mut room) }
        };
        // SAFETY: as above.
        #[cfg(not(hdf5_2))]
        let read = || unsafe { H5Dread_chunk(id, H5P_DEFAULT, offset.as_ptr(), mask, to) };
        hdf5::sync::sync(|| h5check(read()))?;
        if length == 0 || left_out != 0 {
            return Err(format!("{} has no packed chunk at {at:?}", self.dataset.name()).into());
        }
        Ok(Packed { count: self.numbers, bytes })
    }

    fn offset(&self, at: &[usize]) -> Result<Vec<hsize_t>> {
        if at.len() != self.dimensions {
            return Err(format!("{at:?} is no place of {}", self.dataset.name()).into());
        }
        Ok(at.iter().map(|&index| index as hsize_t).collect())
    }
}
