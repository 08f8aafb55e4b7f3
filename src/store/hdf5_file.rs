//! HDF5 files whose bytes depend on their content alone.

use std::path::Path;
use std::str::FromStr;

use hdf5::file::LibraryVersion;
use hdf5::plist::file_create::{AttrCreationOrder, LinkCreationOrder};
use hdf5::types::VarLenUnicode;
use hdf5::{DatasetBuilder, File, Group, Location, Result};

/// Strength of the compression of fields: more costs much time and gains little on doubles.
pub(super) const DEFLATE: u8 = 4;

/// HDF5's own locks are not used: the directory has its lock, files are written under names that no one else opens, and
/// some parallel file systems refuse such locks. They would also outlive the file in every child process.
const LOCKING: bool = false;

/// A new file. No object of it holds a clock time; the format is that of HDF5 1.8, which every reader knows; the order
/// of creation is kept, as netCDF-4 wants it.
pub(super) fn create(path: &Path) -> Result<File> {
    File::with_options()
        .with_fcpl(|file| {
            file.obj_track_times(false)
                .attr_creation_order(AttrCreationOrder::Indexed)
                .link_creation_order(LinkCreationOrder::Indexed)
        })
        .with_fapl(|access| access.libver_bounds(LibraryVersion::V18, LibraryVersion::V18).file_locking(LOCKING))
        .create(path)
}

/// An existing file, for reading.
pub(super) fn open(path: &Path) -> Result<File> {
    File::with_options().with_fapl(|access| access.file_locking(LOCKING)).open(path)
}

/// A data set to be, without clock time.
pub(super) fn dataset(group: &Group) -> DatasetBuilder {
    group.new_dataset_builder().obj_track_times(false).attr_creation_order(AttrCreationOrder::Indexed)
}

/// Writes everything to the file and closes it. Errors of a full disk show here, not in a later drop.
///
/// All data sets of the file must be dropped before.
pub(super) fn finish(file: File) -> Result<()> {
    file.flush()?;
    file.close()
}

/// Text as HDF5 stores it.
pub(super) fn text(text: &str) -> Result<VarLenUnicode> {
    VarLenUnicode::from_str(text).map_err(|error| hdf5::Error::Internal(format!("text {text:?}: {error}")))
}

/// Gives an object a text attribute of any length.
pub(super) fn set_text(object: &Location, name: &str, value: &str) -> Result<()> {
    object.new_attr::<VarLenUnicode>().create(name)?.write_scalar(&text(value)?)
}

/// The text attribute of an object.
pub(super) fn get_text(object: &Location, name: &str) -> Result<String> {
    Ok(object.attr(name)?.read_scalar::<VarLenUnicode>()?.as_str().to_owned())
}
