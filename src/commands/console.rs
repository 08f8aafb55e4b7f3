//! Output that outlives its reader (`stribeck status DIR | head -1` ends quietly) and leaves the terminal as it is,
//! whatever stands in the files that it tells of.

use std::io::{self, ErrorKind, Write};

use super::CliError;
use stribeck_input::printable;

/// Writes a text to stdout. A reader that went away wants no more of it, which is no error.
pub fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    let text = harmless(text);
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(source) if source.kind() != ErrorKind::BrokenPipe => {
            Err(CliError::System { action: "write to stdout", source })
        }
        _ => Ok(()),
    }
}

/// Writes a message to stderr. If that cannot be written to there is no one to be told so.
pub fn tell(message: &str) {
    tell_coloured(&harmless(message));
}

/// The same for a message that is harmless, and may have colours.
pub fn tell_coloured(message: &str) {
    let _ = writeln!(io::stderr(), "{message}");
}

/// The text with its lines, and without what else acts on a terminal.
pub fn harmless(text: &str) -> String {
    text.split('\n').map(printable).collect::<Vec<_>>().join("\n")
}
