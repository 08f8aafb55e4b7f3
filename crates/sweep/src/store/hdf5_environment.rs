//! The HDF5 library without the settings of the environment.
//!
//! A cluster sets `HDF5_DRIVER`, `HDF5_VOL_CONNECTOR`, `HDF5_PLUGIN_PATH` and others for programs with an HDF5 library
//! of their own. To this one they name drivers and plug-ins that it has not, or that write other bytes.

#![allow(unsafe_code)]

use std::env;
use std::ffi::OsString;
use std::sync::Once;

/// How the names of the library's variables begin.
const PREFIX: &str = "HDF5_";

static INITIALISED: Once = Once::new();

/// Initialises the HDF5 library as if the environment had no variable of it. The environment is afterwards as before.
///
/// Every use of the library here does so. A program calls it first thing, while it has only one thread: reading the
/// environment in another thread meanwhile is not safe.
pub fn initialise() {
    INITIALISED.call_once(|| {
        let is_of_library = |(name, _): &(OsString, OsString)| name.to_string_lossy().starts_with(PREFIX);
        let variables: Vec<_> = env::vars_os().filter(is_of_library).collect();
        // SAFETY: the standard library serialises its own accesses to the environment. Nothing here reads it in any
        // other way but the HDF5 library, under its lock, and a program calls this while it has only one thread.
        variables.iter().for_each(|(name, _)| unsafe { env::remove_var(name) });
        hdf5::sync::sync(|| ());
        // SAFETY: as above.
        variables.iter().for_each(|(name, value)| unsafe { env::set_var(name, value) });
    });
}
