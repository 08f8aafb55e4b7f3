//! From a path to the text of a TOML file, and from there to a document.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use toml::Spanned;
use toml::de::DeTable;

use super::error::{Fault, InputError};
use super::extent;

/// Most bytes of a file.
const LARGEST_FILE: u64 = 8 << 20;

/// What kind of file it is, in words, as in `sweep file`.
pub type Kind = &'static str;

/// Reads a file, or the standard input if the path is `-`, and makes of its stem and text what `interpret` does.
///
/// # Errors
/// [`InputError`] if the file cannot be read, is larger than 8 MiB, is not UTF-8, or `interpret` finds a fault.
pub fn read<T>(kind: Kind, path: &Path, interpret: impl Fn(&str, &str) -> Result<T, Fault>) -> Result<T, InputError> {
    let unreadable = |cause| InputError::Unreadable { kind, path: path.to_owned(), cause };
    let mut bytes = Vec::new();
    let source: Box<dyn Read> = match path.to_str() {
        Some("-") => Box::new(io::stdin()),
        _ => Box::new(File::open(path).map_err(unreadable)?),
    };
    source.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(InputError::TooLarge { kind, path: path.to_owned(), limit: LARGEST_FILE });
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let valid_up_to = error.utf8_error().valid_up_to();
        InputError::not_text(kind, path.to_owned(), error.as_bytes(), valid_up_to)
    })?;
    let path = if path.to_str() == Some("-") { Path::new("stdin") } else { path };
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    interpret(&name, &text).map_err(|fault| fault.located(&path.display().to_string(), &text))
}

/// Makes of the text of a file called `name`.toml what `interpret` does.
///
/// # Errors
/// [`InputError::Invalid`] if `interpret` finds a fault.
pub fn parse<T>(name: &str, text: &str, interpret: impl Fn(&str, &str) -> Result<T, Fault>) -> Result<T, InputError> {
    interpret(name, text).map_err(|fault| fault.located(&format!("{name}.toml"), text))
}

/// What to do about a comma in a number.
const DECIMAL_COMMA: &str = "the decimal mark of a number is a point, as in 0.5; a text with a unit may have a comma, as in \
                             \"0,5 mm\"";

/// True for a comma between digits.
fn is_decimal_comma(text: &str, place: usize) -> bool {
    let (before, after) = text.split_at_checked(place).unwrap_or((text, ""));
    let is_digit = |c: char| c.is_ascii_digit();
    before.ends_with(is_digit) && after.strip_prefix(',').is_some_and(|rest| rest.starts_with(is_digit))
}

/// The TOML document of a text.
pub fn document(text: &str) -> Result<Spanned<DeTable<'_>>, Fault> {
    extent::check(text)?;
    DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or(text.len()..text.len());
        let usual = "TOML has lines `key = value` under headers [section]; texts stand in double quotes, lists in \
                    brackets; a key may stand only once";
        let help = if is_decimal_comma(text, span.start) { DECIMAL_COMMA } else { usual };
        Fault::new(span, format!("not valid TOML: {}", error.message()), "here", help)
    })
}
