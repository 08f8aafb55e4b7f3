//! Python with the packages of `scripts/requirements.txt`, for tests of what users do with the published files.

#![allow(dead_code)]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

pub const REMEDY: &str = "run ./scripts/prerequisites --tests, or name a Python that has the packages of \
                          scripts/requirements.txt in STRIBECK_PYTHON";

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The Python to use, with its packages; looked for once in a test program, as importing them takes seconds.
pub fn python() -> &'static Path {
    static PYTHON: OnceLock<PathBuf> = OnceLock::new();
    PYTHON.get_or_init(|| {
        let python = std::env::var_os("STRIBECK_PYTHON").map_or_else(|| root().join(".venv/bin/python"), PathBuf::from);
        let imports =
            Command::new(&python).args(["-c", "import h5netcdf, netCDF4, xarray, pandas, matplotlib"]).output();
        match imports {
            Ok(output) if output.status.success() => python,
            Ok(output) => panic!("{}: {}; {REMEDY}", python.display(), String::from_utf8_lossy(&output.stderr)),
            Err(error) => panic!("{}: {error}; {REMEDY}", python.display()),
        }
    })
}

/// What a command printed; it must have succeeded.
pub fn check(output: &Output) -> String {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(output.status.success(), "{}\n{}", text(&output.stdout), text(&output.stderr));
    text(&output.stdout)
}

/// A command that runs a file of Python, named from the root of the repository.
pub fn file_of_python(name: &str) -> Command {
    let mut command = Command::new(python());
    // Without a display, as on a server; the messages are the same everywhere then.
    command.arg(root().join(name)).env("MPLBACKEND", "agg").env_remove("PYTHONPATH");
    command
}
