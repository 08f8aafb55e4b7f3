//! Dimension scales: which coordinate belongs to which dimension of a data set.
//!
//! They are part of HDF5's high-level library, which the `hdf5` crate does not wrap. This file, `chunks` and
//! `hdf5_environment` are the only ones with `unsafe` code; the crate denies it elsewhere.

#![allow(unsafe_code)]

use std::ffi::{CString, c_char, c_uint};

use hdf5::{Dataset, Result, h5check};
use hdf5_sys::h5::herr_t;
use hdf5_sys::h5i::hid_t;

unsafe extern "C" {
    fn H5DSset_scale(scale: hid_t, name: *const c_char) -> herr_t;
    fn H5DSattach_scale(dataset: hid_t, scale: hid_t, dimension: c_uint) -> herr_t;
}

/// Makes a one-dimensional data set the scale of the dimension `name`.
pub(super) fn make_scale(scale: &Dataset, name: &str) -> Result<()> {
    let name = CString::new(name).map_err(|error| hdf5::Error::Internal(error.to_string()))?;
    // SAFETY: the id is that of an open data set, which outlives the call; the name ends in NUL and is only read; the
    // library is called under the lock that serialises all calls to it.
    hdf5::sync::sync(|| h5check(unsafe { H5DSset_scale(scale.id(), name.as_ptr()) }))?;
    Ok(())
}

/// Attaches a scale to a dimension (from 0) of a data set.
pub(super) fn attach(dataset: &Dataset, scale: &Dataset, dimension: u32) -> Result<()> {
    // SAFETY: both ids are those of open data sets, which outlive the call; a dimension that does not exist is an error
    // code; the library is called under the lock that serialises all calls to it.
    hdf5::sync::sync(|| h5check(unsafe { H5DSattach_scale(dataset.id(), scale.id(), dimension) }))?;
    Ok(())
}
