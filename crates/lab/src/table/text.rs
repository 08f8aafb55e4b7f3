//! From the bytes of a file to its text, whatever its encoding.

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

/// Bytes that are looked at for the zeros of UTF-16 without a mark.
const LOOKED_AT: usize = 4096;

/// A text and the name of the encoding that it was in.
#[derive(Clone, Debug, PartialEq)]
pub struct Decoded {
    /// The text, without a byte order mark.
    pub text: String,
    /// The encoding, in words.
    pub encoding: &'static str,
}

/// The text of a file: UTF-8 or UTF-16 by its byte order mark or as it is, else Windows-1252, which holds Latin-1.
///
/// # Errors
/// What is wrong, for bytes that are no text.
pub fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let (encoding, mark) = Encoding::for_bom(bytes).unwrap_or_else(|| (guess(bytes), 0));
    let name = match (encoding, mark) {
        (encoding, 0) if encoding == UTF_8 => "UTF-8",
        (encoding, _) if encoding == UTF_8 => "UTF-8 with a byte order mark",
        (encoding, _) if encoding == WINDOWS_1252 => "Latin-1 (Windows-1252)",
        (encoding, _) => encoding.name(),
    };
    let text = encoding
        .decode_without_bom_handling_and_without_replacement(&bytes[mark..])
        .ok_or_else(|| format!("it is no text in {name}, as which it begins; save it as UTF-8"))?;
    let text = text.trim_end_matches('\u{1a}');
    match text.find('\0') {
        Some(place) => Err(format!("line {} holds a zero byte: it is no text; save it as CSV", line_of(text, place))),
        None => Ok(Decoded { text: text.to_owned(), encoding: name }),
    }
}

/// The encoding of bytes without a mark: text in UTF-16 is half zeros, and what is no UTF-8 is taken for Latin-1.
fn guess(bytes: &[u8]) -> &'static Encoding {
    let beginning = &bytes[..bytes.len().min(LOOKED_AT)];
    let zeros = |parity: usize| beginning.iter().skip(parity).step_by(2).filter(|byte| **byte == 0).count();
    let most = |count: usize| beginning.len() >= 4 && 5 * count > 2 * beginning.len().div_ceil(2);
    match (zeros(0), zeros(1)) {
        (0, odd) if most(odd) => UTF_16LE,
        (even, 0) if most(even) => UTF_16BE,
        _ if std::str::from_utf8(bytes).is_ok() => UTF_8,
        _ => WINDOWS_1252,
    }
}

/// The line of a place in a text, from 1.
fn line_of(text: &str, place: usize) -> usize {
    let before = &text.as_bytes()[..place];
    let ends = |(i, byte): (usize, &u8)| *byte == b'\n' || (*byte == b'\r' && before.get(i + 1) != Some(&b'\n'));
    before.iter().enumerate().filter(|it| ends(*it)).count() + 1
}

/// A line of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Line<'t> {
    /// Its number, from 1.
    pub(super) number: u64,
    /// The byte at which it begins.
    pub(super) start: usize,
    pub(super) text: &'t str,
}

/// The lines of a text, ended by CR, LF or both.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> + Clone {
    let mut next = Some(0);
    let mut number = 0;
    std::iter::from_fn(move || {
        let start = next?;
        number += 1;
        let rest = &text[start..];
        let end = rest.find(['\r', '\n']);
        next = end.map(|end| start + end + if rest[end..].starts_with("\r\n") { 2 } else { 1 });
        Some(Line { number, start, text: &rest[..end.unwrap_or(rest.len())] })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_known_in_every_encoding() {
        let text = "Öl (µm/s);µ\r\n1;0,5\r\n";
        let wide = |to: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(to).collect::<Vec<u8>>();
        let marked = |mark: &[u8], bytes: &[u8]| [mark, bytes].concat();
        let latin: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1")).collect();
        for (bytes, encoding) in [
            (text.as_bytes().to_vec(), "UTF-8"),
            (marked(b"\xef\xbb\xbf", text.as_bytes()), "UTF-8 with a byte order mark"),
            (marked(b"\xff\xfe", &wide(u16::to_le_bytes)), "UTF-16LE"),
            (marked(b"\xfe\xff", &wide(u16::to_be_bytes)), "UTF-16BE"),
            (wide(u16::to_le_bytes), "UTF-16LE"),
            (wide(u16::to_be_bytes), "UTF-16BE"),
            (latin, "Latin-1 (Windows-1252)"),
        ] {
            assert_eq!(decode(&bytes), Ok(Decoded { text: text.to_owned(), encoding }));
        }
        assert!(decode(b"a\r\n\0b").unwrap_err().starts_with("line 2 holds a zero byte"));
        assert!(decode(b"\xff\xfea").unwrap_err().contains("no text in UTF-16LE"));
    }

    #[test]
    fn lines_end_in_three_ways() {
        let found: Vec<(u64, &str)> = lines("a\rb\nc\r\n\r\nd").map(|line| (line.number, line.text)).collect();
        assert_eq!(found, [(1, "a"), (2, "b"), (3, "c"), (4, ""), (5, "d")]);
    }
}
