//! The published data set of a results directory, for commands that show it.

use std::path::Path;

use super::{CliError, console};
use stribeck_input::shown;
use stribeck_sweep::store::DataSet;

/// Opens it, and warns if cases were stored after it was published.
///
/// # Errors
/// As [`DataSet::open`].
pub fn open(directory: &Path) -> Result<DataSet, CliError> {
    let data = DataSet::open(directory)?;
    if data.outdated {
        console::tell(&format!(
            "warning: cases were solved after {} was published, and are not shown; run the sweep to its end",
            shown(&directory.join("results.h5"))
        ));
    }
    Ok(data)
}
