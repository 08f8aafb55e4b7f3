//! HDF5 files whose bytes depend on their content alone.

use std::mem::ManuallyDrop;
use std::path::Path;
use std::str::FromStr;

use hdf5::file::LibraryVersion;
use hdf5::plist::file_create::{AttrCreationOrder, LinkCreationOrder};
use hdf5::types::VarLenUnicode;
use hdf5::{Dataset, DatasetBuilder, File, H5Type, Location, Result};
use ndarray::{ArrayView, Dimension};

use super::hdf5_environment;

/// The strength of compression that the pipeline of a field names. The program packs fields itself, see `packed`; other
/// programs that write to a copy may use it.
pub(super) const DEFLATE: u8 = 4;

/// HDF5's own locks are not used: the directory has its lock, files are written under names that no one else opens, and
/// some parallel file systems refuse such locks. They would also outlive the file in every child process.
const LOCKING: bool = false;

/// Bytes of the blocks of a data set that stay in memory while it is read, and the slots to find them: some blocks of
/// fields, so that neighbouring places are decompressed once.
const CACHE: usize = 4 << 20;
const SLOTS: usize = 521;

/// A new file that is being written.
///
/// When a write fails (a full disk), HDF5 must not be asked to close what it could not write: closing tries again,
/// fails again, frees the object, and the next call of the library runs into what was freed. So all data sets stay open
/// until one flush of the whole file has succeeded, and if there is none they are left open for good: a little memory
/// and a file descriptor, of a run that ends because of the error.
pub(super) struct NewFile {
    file: ManuallyDrop<File>,
    datasets: ManuallyDrop<Vec<Dataset>>,
}

impl NewFile {
    /// A new file. No object of it holds a clock time; the format is that of HDF5 1.8, which every reader knows; the
    /// order of creation is kept, as netCDF-4 wants it.
    pub(super) fn create(path: &Path) -> Result<Self> {
        hdf5_environment::initialise();
        let options = File::with_options()
            .with_fcpl(|file| {
                file.obj_track_times(false)
                    .attr_creation_order(AttrCreationOrder::Indexed)
                    .link_creation_order(LinkCreationOrder::Indexed)
            })
            .with_fapl(|access| access.libver_bounds(LibraryVersion::V18, LibraryVersion::V18).file_locking(LOCKING))
            .clone();
        Ok(Self { file: ManuallyDrop::new(options.create(path)?), datasets: ManuallyDrop::new(Vec::new()) })
    }

    /// A data set to be, without clock time; to be kept by [`NewFile::keep`] as soon as it is there.
    pub(super) fn dataset(&self) -> DatasetBuilder {
        self.file.new_dataset_builder().obj_track_times(false).attr_creation_order(AttrCreationOrder::Indexed)
    }

    /// Writes a whole data set.
    pub(super) fn write<'d, T, D>(&mut self, name: &str, content: impl Into<ArrayView<'d, T, D>>) -> Result<Dataset>
    where
        T: H5Type,
        D: Dimension,
    {
        let content = content.into();
        let dataset = self.dataset().empty::<T>().shape(content.shape()).create(name)?;
        let dataset = self.keep(dataset);
        dataset.write(content)?;
        Ok(dataset)
    }

    /// Keeps a data set open until the file is finished.
    pub(super) fn keep(&mut self, dataset: Dataset) -> Dataset {
        self.datasets.push(dataset.clone());
        dataset
    }

    /// Gives the file a text attribute of any length.
    pub(super) fn set_text(&self, name: &str, value: &str) -> Result<()> {
        set_text(&self.file, name, value)
    }

    /// Gives the file a number as an attribute.
    pub(super) fn set_number(&self, name: &str, value: f64) -> Result<()> {
        self.file.new_attr::<f64>().create(name)?.write_scalar(&value)
    }

    /// Writes everything to the file, closes it, opens it again and compares it with what was written. Errors of the
    /// disk show here at the latest.
    ///
    /// Only the last handle closes a file, and one that closes it unseen hides its errors. So nobody else may hold a
    /// data set of it any more.
    pub(super) fn finish(self) -> Result<()> {
        self.file.flush()?;
        let Self { file, datasets } = self;
        let (file, datasets) = (ManuallyDrop::into_inner(file), ManuallyDrop::into_inner(datasets));
        let path = file.filename();
        let written: Vec<_> = datasets.iter().map(outline).collect();
        let shared = datasets.iter().filter(|dataset| dataset.refcount() > 1).count();
        drop(datasets);
        file.close()?;
        if shared > 0 {
            return Err(format!("{shared} data sets are open when the file is closed").into());
        }
        let file = open(Path::new(&path))?;
        for outline_written in written {
            if outline(&file.dataset(&outline_written.0)?) != outline_written {
                return Err(format!("{} is not in the file as it was written", outline_written.0).into());
            }
        }
        file.close()
    }
}

/// Name, shape and bytes of a data set.
fn outline(dataset: &Dataset) -> (String, Vec<usize>, u64) {
    (dataset.name(), dataset.shape(), dataset.storage_size())
}

/// An existing file, for reading.
pub(super) fn open(path: &Path) -> Result<File> {
    hdf5_environment::initialise();
    if !path.is_file() {
        return Err("it is no file".into());
    }
    let mut options = File::with_options();
    options.with_fapl(|access| access.file_locking(LOCKING).chunk_cache(SLOTS, CACHE, 0.75));
    options.open(path)
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
