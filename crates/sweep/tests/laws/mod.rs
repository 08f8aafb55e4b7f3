//! Laws that hold for any bytes; fuzz targets and tests share them.

pub mod log;
pub mod shard;
pub mod sweep_file;
