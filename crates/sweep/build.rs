//! Checks the version of HDF5, and tells the code of version 2, which reads chunks by another function.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(hdf5_2)");
    if std::env::var_os("DEP_HDF5_VERSION_1_10_3").is_none() {
        println!("cargo::error=this HDF5 is older than 1.10.3, the first version that hands out packed chunks");
    }
    if std::env::var_os("DEP_HDF5_VERSION_2_0_0").is_some() {
        println!("cargo::rustc-cfg=hdf5_2");
    }
}
