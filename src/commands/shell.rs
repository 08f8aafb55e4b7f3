//! Commands that can be pasted into a shell.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::PathBuf;
use std::sync::OnceLock;

use stribeck_input::is_printable;

/// The command line, where it is not that of the process.
static COMMAND_LINE: OnceLock<Vec<OsString>> = OnceLock::new();

/// Says what the command line is where another program, such as Python, runs this one: its first word is a path that
/// starts the program. The first call counts.
pub fn set_command_line(words: Vec<OsString>) {
    COMMAND_LINE.get_or_init(|| words);
}

/// The command line, as it was typed, quoted for a shell.
pub fn own_command() -> String {
    let words = COMMAND_LINE.get().cloned().unwrap_or_else(|| std::env::args_os().collect());
    words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ")
}

/// The path of the program.
///
/// # Errors
/// What the system says if it does not tell.
pub fn own_path() -> io::Result<PathBuf> {
    match COMMAND_LINE.get().and_then(|words| words.first()) {
        Some(program) => std::path::absolute(program),
        None => std::env::current_exe(),
    }
}

/// A word as a POSIX shell needs it to read the same word, in one line. Bytes that are no text, or no one should see
/// raw on a terminal, are written as `$'\xff'`, which bash, zsh and ksh read.
pub fn quoted(word: &OsStr) -> String {
    let plain = |byte: &u8| byte.is_ascii_alphanumeric() || b"_-./=:,+@%".contains(byte);
    let bytes = word.as_encoded_bytes();
    match word.to_str() {
        Some(text) if !text.is_empty() && bytes.iter().all(plain) => text.to_owned(),
        Some(text) if is_printable(text) => format!("'{}'", text.replace('\'', r"'\''")),
        _ => {
            let escaped = bytes.iter().map(|byte| match byte {
                byte if plain(byte) => char::from(*byte).to_string(),
                byte => format!("\\x{byte:02x}"),
            });
            format!("$'{}'", escaped.collect::<String>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn a_shell_reads_the_word_that_was_quoted() {
        use std::os::unix::ffi::OsStrExt;
        let words: [&[u8]; 10] = [
            b"plain-1.0_/x=y",
            b"",
            b"two words",
            b"it's",
            b"$HOME `id` \"q\" \\ ! * ~ # & ; < > ( ) { }",
            "τ μ".as_bytes(),
            b"line\nfeed\ttab",
            b"-o",
            b"not text \xff'1",
            b"\x1b[31mred\x7f'",
        ];
        for word in words.map(OsStr::from_bytes) {
            let script = format!("printf %s {}", quoted(word));
            let read = std::process::Command::new("bash").arg("-c").arg(&script).output().expect("bash runs");
            assert_eq!(OsStr::from_bytes(&read.stdout), word, "{script}");
            assert!(is_printable(&script), "{script:?}");
        }
    }
}
