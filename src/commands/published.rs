//! The published data set of a results directory, for commands that show it.

use std::path::{Path, PathBuf};

use super::{CliError, console};
use stribeck_input::{printable, shown};
use stribeck_sweep::store::DataSet;

/// The results directory that a user names: itself, or by the data set or the surface in it.
pub fn directory(named: &Path) -> PathBuf {
    match (named.file_name(), named.parent()) {
        (Some(name), Some(parent)) if (name == "results.h5" || name == "surface.json") && named.is_file() => {
            if parent.as_os_str().is_empty() { PathBuf::from(".") } else { parent.to_owned() }
        }
        _ => named.to_owned(),
    }
}

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
    if let Some(partial) = &data.partial {
        console::tell(&format!(
            "warning: {} is partial: {}, and are shown as failed",
            shown(&directory.join("results.h5")),
            printable(partial)
        ));
    }
    Ok(data)
}
