//! Why a file was not taken.

use std::fmt;
use std::io;
use std::ops::Range;
use std::path::PathBuf;

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};

use crate::sanitize::{is_printable, printable, shown};

/// Longest line that a report draws. If one is longer (a list of a million values), the message alone is shown.
const LONGEST_LINE: usize = 2000;

/// Longest piece of the file quoted in a message, in characters.
const LONGEST_QUOTE: usize = 60;

/// Why a file was not taken. As a [`miette::Diagnostic`] it draws the line with a caret and the remedy below.
#[derive(Debug, thiserror::Error)]
pub enum InputError {
    /// The operating system did not give the file.
    #[error("cannot read the {kind} {}: {cause}", shown(path))]
    Unreadable {
        /// What kind of file it should be.
        kind: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system said.
        #[source]
        cause: io::Error,
    },
    /// The file is too large.
    #[error("the {kind} {} is larger than {} MiB, the most that is read", shown(path), limit >> 20)]
    TooLarge {
        /// What kind of file it should be.
        kind: &'static str,
        /// The file.
        path: PathBuf,
        /// Most bytes that are read.
        limit: u64,
    },
    /// The file is not UTF-8.
    #[error("{}:{line}:{column}: the byte 0x{byte:02x} is not UTF-8; a {kind} is UTF-8 text", shown(path))]
    NotText {
        /// What kind of file it should be.
        kind: &'static str,
        /// The file.
        path: PathBuf,
        /// Line of the first byte that does not fit, from 1.
        line: usize,
        /// Column of that byte, from 1.
        column: usize,
        /// The byte.
        byte: u8,
    },
    /// The text is not valid.
    #[error(transparent)]
    Invalid(Box<Invalid>),
}

/// A place in a file that is not valid, what is allowed there and how to mend it.
#[derive(Debug)]
pub struct Invalid {
    file: String,
    line: usize,
    column: usize,
    message: String,
    label: String,
    help: String,
    source: NamedSource<String>,
    span: Range<usize>,
    drawable: bool,
}

impl Invalid {
    /// Line of the offending text, from 1.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Column of the offending text in characters, from 1.
    pub fn column(&self) -> usize {
        self.column
    }
}

impl fmt::Display for Invalid {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}:{}:{}: {}", self.file, self.line, self.column, self.message)
    }
}

impl std::error::Error for Invalid {}

/// True for an error of the disk or the system; false for one of the path that was given.
pub fn is_of_disk(error: &io::Error) -> bool {
    use io::ErrorKind::{InvalidFilename, IsADirectory, NotADirectory, NotFound, PermissionDenied};
    !matches!(error.kind(), NotFound | PermissionDenied | IsADirectory | NotADirectory | InvalidFilename)
}

impl InputError {
    /// True if the disk or the system did not give the file; false if the path or the file is wrong.
    pub fn is_of_disk(&self) -> bool {
        matches!(self, InputError::Unreadable { cause, .. } if is_of_disk(cause))
    }

    /// The remedy, in words.
    pub fn remedy(&self) -> &str {
        match self {
            InputError::Unreadable { kind, cause, .. } => match cause.kind() {
                io::ErrorKind::NotFound if kind.ends_with("file") => {
                    "check the path; the sweeps that come with the program are in `sweeps/`"
                }
                io::ErrorKind::NotFound => "check the path",
                io::ErrorKind::PermissionDenied => "make the file readable for you, or copy it to a place of yours",
                io::ErrorKind::IsADirectory => "name the file in that directory",
                _ => "check the disk and the path, then try again",
            },
            InputError::TooLarge { .. } => {
                "is it the right file? Long lists of values can be written as { from, to, points, scale }"
            }
            InputError::NotText { .. } => "is it the right file? If so, save it as UTF-8 in your editor",
            InputError::Invalid(invalid) => &invalid.help,
        }
    }

    /// A file that is not UTF-8 from byte `valid_up_to` on.
    pub fn not_text(kind: &'static str, path: PathBuf, bytes: &[u8], valid_up_to: usize) -> Self {
        let before = String::from_utf8_lossy(&bytes[..valid_up_to]);
        let (line, column) = line_and_column(&before, before.len());
        InputError::NotText { kind, path, line, column, byte: bytes[valid_up_to] }
    }
}

impl Diagnostic for InputError {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.remedy()))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        match self {
            InputError::Invalid(invalid) if invalid.drawable => Some(&invalid.source),
            _ => None,
        }
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        match self {
            InputError::Invalid(invalid) if invalid.drawable => {
                let label = LabeledSpan::at(invalid.span.clone(), invalid.label.as_str());
                Some(Box::new(std::iter::once(label)))
            }
            _ => None,
        }
    }
}

/// What is wrong at one place of the text, before the file's name is put to it.
#[derive(Debug)]
pub struct Fault {
    span: Range<usize>,
    what: String,
    label: String,
    help: String,
    quoted: bool,
}

impl Fault {
    /// The text at `span` is not allowed: `what` says what is, and the message goes on to quote what was found.
    pub fn new(span: Range<usize>, what: impl Into<String>, label: impl Into<String>, help: impl Into<String>) -> Self {
        Self { span, what: what.into(), label: label.into(), help: help.into(), quoted: true }
    }

    /// The same for `what` that says it all, with nothing to quote.
    pub fn unquoted(mut self) -> Self {
        self.quoted = false;
        self
    }

    /// The error to show, with the name and the text of the file.
    pub fn located(self, file: &str, text: &str) -> InputError {
        let (start, end) = visible(text, &self.span);
        let (line, column) = line_and_column(text, start);
        let quote = text[start..end].trim();
        let message = match self.quoted && !self.span.is_empty() && !quote.is_empty() {
            true => format!("{}, found `{}`", self.what, printable(&shortened(quote))),
            false => self.what,
        };
        let drawable =
            drawn_lines(text, start).all(|line| line.len() <= LONGEST_LINE && is_printable(&line.replace('\t', "")));
        let end = text[start..end].find('\n').map_or(end, |newline| start + newline);
        let file = printable(file);
        InputError::Invalid(Box::new(Invalid {
            file: file.to_string(),
            line,
            column,
            message,
            label: self.label,
            help: self.help,
            source: NamedSource::new(&file, text.to_owned()).with_language("toml"),
            span: start..end,
            drawable,
        }))
    }
}

/// Line and column (in characters) of a byte offset, both from 1.
fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = &text[..offset];
    (before.matches('\n').count() + 1, before[line_begin(before)..].chars().count() + 1)
}

/// Where the last line of a text begins.
fn line_begin(text: &str) -> usize {
    text.rfind('\n').map_or(0, |newline| newline + 1)
}

/// The lines that a report of this place may draw: its own, the one before and the one after, and one more on either
/// side where miette takes a line for none (an empty one behind a `\r\n`).
fn drawn_lines(text: &str, place: usize) -> impl Iterator<Item = &str> {
    let (before, from) = text.split_at(line_begin(&text[..place]));
    let lines = before.split_inclusive('\n').rev().take(2).chain(from.split_inclusive('\n').take(3));
    lines.map(|line| line.strip_suffix("\r\n").or(line.strip_suffix('\n')).unwrap_or(line))
}

/// The span on character boundaries; one that is empty or past the end takes in the character at it or, at the end of
/// a line, before it, so that a caret has something to stand under.
fn visible(text: &str, span: &Range<usize>) -> (usize, usize) {
    let (mut start, mut end) = (span.start.min(text.len()), span.end.min(text.len()));
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    while !text.is_char_boundary(end) {
        end += 1;
    }
    end = end.max(start);
    if start == end {
        let width = |character: Option<char>| character.filter(|c| !matches!(c, '\n' | '\r')).map(char::len_utf8);
        match width(text[start..].chars().next()) {
            Some(width) => end += width,
            None => start -= width(text[..start].chars().next_back()).unwrap_or(0),
        }
    }
    (start, end)
}

/// The first line of a piece of the file, cut where it gets long.
fn shortened(quote: &str) -> String {
    let first = quote.lines().next().unwrap_or_default();
    let short: String = first.chars().take(LONGEST_QUOTE).collect();
    if short.len() < quote.len() { format!("{short} …") } else { short }
}
