//! Python with the packages of `scripts/requirements.txt`, for tests of what users do with the published files.

#![allow(dead_code)]

use std::io::{BufRead, BufReader, Write};
use std::os::unix::net::UnixStream;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Output, Stdio};
use std::sync::OnceLock;

pub const REMEDY: &str = "run ./scripts/prerequisites --tests, or name a Python that has the packages of \
                          scripts/requirements.txt in STRIBECK_PYTHON";

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The Python to use; that it has its packages is checked once in a test program.
pub fn python() -> &'static Path {
    static PYTHON: OnceLock<PathBuf> = OnceLock::new();
    PYTHON.get_or_init(|| {
        let python = std::env::var_os("STRIBECK_PYTHON").map_or_else(|| root().join(".venv/bin/python"), PathBuf::from);
        // Importing them would take seconds.
        let find =
            "import sys, importlib.util as u; assert all(map(u.find_spec, sys.argv[1:])), 'packages are missing'";
        let packages = ["h5netcdf", "netCDF4", "xarray", "pandas", "matplotlib"];
        match Command::new(&python).args(["-c", find]).args(packages).output() {
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

/// A command that runs a file of Python, named from the root of the repository, in an interpreter of its own.
pub fn file_of_python(name: &str) -> Command {
    let mut command = Command::new(python());
    // Without a display, as on a server; the messages are the same everywhere then.
    command.arg(root().join(name)).env("MPLBACKEND", "agg").env_remove("PYTHONPATH");
    command
}

/// Runs a file of Python in a process that has imported the packages already, which takes seconds: a fork of one server
/// for the whole test program (`tests/python/run_scripts.py`).
pub fn run_python(name: &str, arguments: &[&str]) -> Output {
    static SERVER: OnceLock<(Child, PathBuf)> = OnceLock::new();
    let (_, socket) = SERVER.get_or_init(start_server);
    let mut request = vec![root().join(name).display().to_string()];
    request.extend(arguments.iter().map(|argument| argument.to_string()));
    let mut stream = UnixStream::connect(socket).unwrap();
    writeln!(stream, "{}", serde_json::to_string(&request).unwrap()).unwrap();
    let answer: serde_json::Value = serde_json::from_reader(stream).unwrap();
    let bytes = |name: &str| answer[name].as_str().unwrap().as_bytes().to_vec();
    let code = i32::try_from(answer["code"].as_i64().unwrap()).unwrap();
    Output { status: ExitStatus::from_raw(code << 8), stdout: bytes("stdout"), stderr: bytes("stderr") }
}

/// The server and the path of its socket.
fn start_server() -> (Child, PathBuf) {
    let mut server = file_of_python("tests/python/run_scripts.py").stdout(Stdio::piped()).spawn().unwrap();
    let mut socket = String::new();
    BufReader::new(server.stdout.take().unwrap()).read_line(&mut socket).unwrap();
    assert!(socket.ends_with('\n'), "the server of Python has ended: see above; {REMEDY}");
    (server, socket.trim_end().into())
}
