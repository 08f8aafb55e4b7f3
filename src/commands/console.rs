//! Output that outlives its reader: `stribeck status DIR | head -1` ends quietly.

use std::io::{self, ErrorKind, Write};

use super::CliError;

/// Writes a text to stdout. A reader that went away wants no more of it, which is no error.
pub fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(source) if source.kind() != ErrorKind::BrokenPipe => {
            Err(CliError::System { action: "write to stdout", source })
        }
        _ => Ok(()),
    }
}

/// Writes a message to stderr. If that cannot be written to there is no one to be told so.
pub fn tell(message: &str) {
    let _ = writeln!(io::stderr(), "{message}");
}
