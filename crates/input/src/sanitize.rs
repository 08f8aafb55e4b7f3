//! Foreign text in messages: names of files, and pieces of what is in them.

use std::borrow::Cow;
use std::path::Path;

/// A text in one line that leaves the terminal as it is: control characters, and those that reorder what stands around
/// them, are written as in `\n` and `\u{1b}`.
pub fn printable(text: &str) -> Cow<'_, str> {
    if is_printable(text) {
        return text.into();
    }
    let escaped = |c: char| if acts(c) { c.escape_default().to_string() } else { c.to_string() };
    text.chars().map(escaped).collect()
}

/// True if [`printable`] has nothing to do.
pub fn is_printable(text: &str) -> bool {
    !text.chars().any(acts)
}

/// A path in one line, likewise.
pub fn shown(path: &Path) -> String {
    printable(&path.to_string_lossy()).into_owned()
}

/// True for a character that does something instead of being seen.
fn acts(c: char) -> bool {
    let line_or_paragraph = matches!(c, '\u{2028}' | '\u{2029}');
    let direction =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || line_or_paragraph || direction
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_seen_stays_and_what_acts_is_escaped() {
        for plain in ["", "results/quick.toml", "a b 'c' \"d\" \\ τ é 日本 🙂"] {
            assert!(matches!(printable(plain), Cow::Borrowed(same) if same == plain));
        }
        assert_eq!(printable("a\nb\tc\r\u{1b}[31m\0\u{7f}\u{9b}τ"), r"a\nb\tc\r\u{1b}[31m\u{0}\u{7f}\u{9b}τ");
        assert_eq!(printable("\u{202e}lmot.\u{2028}"), r"\u{202e}lmot.\u{2028}");
    }

    #[cfg(unix)]
    #[test]
    fn a_path_that_is_no_text_is_shown_in_one_line() {
        use std::os::unix::ffi::OsStrExt;
        let path = Path::new(std::ffi::OsStr::from_bytes(b"a\xff\n"));
        assert_eq!(shown(path), "a\u{fffd}\\n");
    }
}
