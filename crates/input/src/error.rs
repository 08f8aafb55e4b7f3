//! Why a file was not taken.

use std::collections::HashSet;
use std::fmt;
use std::io;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};

use crate::sanitize::{is_printable, printable, shown};

/// Longest line that a report draws. If one is longer (a list of a million values), the message alone is shown.
const LONGEST_LINE: usize = 2000;

/// Longest piece of the file quoted in a message, in characters.
const LONGEST_QUOTE: usize = 60;

/// Most mistakes of a file that are told at once.
const MOST_TOLD: usize = 20;

/// Why a file was not taken. As a [`miette::Diagnostic`] it draws the line with a caret and the remedy below, for each
/// mistake of the file.
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

/// What is wrong in a file: one mistake, or several in the order of the file.
#[derive(Debug)]
pub struct Invalid {
    first: Mistake,
    others: Vec<Mistake>,
    untold: usize,
}

/// A place in a file that is not valid, what is allowed there and how to mend it.
#[derive(Debug)]
pub struct Mistake {
    file: Arc<str>,
    line: usize,
    column: usize,
    message: String,
    label: String,
    help: String,
    source: Arc<NamedSource<String>>,
    span: Range<usize>,
    drawable: bool,
}

impl Invalid {
    /// Every mistake that is told, in the order of the file.
    pub fn mistakes(&self) -> impl Iterator<Item = &Mistake> {
        std::iter::once(&self.first).chain(&self.others)
    }

    /// Line of the first one, from 1.
    pub fn line(&self) -> usize {
        self.first.line
    }

    /// Column of the first one in characters, from 1.
    pub fn column(&self) -> usize {
        self.first.column
    }
}

impl fmt::Display for Invalid {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (1 + self.others.len() + self.untold, self.untold) {
            (1, _) => write!(formatter, "{}", self.first),
            (all, 0) => write!(formatter, "{} (the first of {all} mistakes)", self.first),
            (all, _) => {
                let told = 1 + self.others.len();
                write!(formatter, "{} (the first of {all} mistakes, {told} of which are told)", self.first)
            }
        }
    }
}

impl std::error::Error for Invalid {}

impl Mistake {
    /// Line of the offending text, from 1.
    pub fn line(&self) -> usize {
        self.line
    }

    /// Column of the offending text in characters, from 1.
    pub fn column(&self) -> usize {
        self.column
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}:{}:{}: {}", self.file, self.line, self.column, self.message)
    }
}

impl std::error::Error for Mistake {}

impl Diagnostic for Mistake {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(&self.help))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.drawable.then_some(&*self.source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let label = self.drawable.then(|| LabeledSpan::at(self.span.clone(), self.label.as_str()));
        label.map(|label| Box::new(std::iter::once(label)) as Box<dyn Iterator<Item = LabeledSpan>>)
    }
}

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
                io::ErrorKind::NotFound if *kind == "sweep file" => {
                    "check the path; `stribeck init -o sweep.toml` writes a sweep file to start from"
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
            InputError::Invalid(invalid) => &invalid.first.help,
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
            InputError::Invalid(invalid) => invalid.first.source_code(),
            _ => None,
        }
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        match self {
            InputError::Invalid(invalid) => invalid.first.labels(),
            _ => None,
        }
    }

    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn Diagnostic> + 'a>> {
        match self {
            InputError::Invalid(invalid) if !invalid.others.is_empty() => {
                Some(Box::new(invalid.others.iter().map(|mistake| mistake as &dyn Diagnostic)))
            }
            _ => None,
        }
    }
}

/// What is wrong in a text, before the file's name is put to it: one mistake, or several that do not follow from each
/// other.
#[derive(Clone, Debug)]
pub struct Fault {
    first: Box<Place>,
    others: Vec<Place>,
}

/// What is wrong at one place of the text.
#[derive(Clone, Debug)]
struct Place {
    span: Range<usize>,
    /// Behind which byte of the text it is told.
    order: usize,
    what: String,
    label: String,
    help: String,
    quoted: bool,
}

impl Fault {
    /// The text at `span` is not allowed: `what` says what is, and the message goes on to quote what was found.
    pub fn new(span: Range<usize>, what: impl Into<String>, label: impl Into<String>, help: impl Into<String>) -> Self {
        let order = span.start;
        let first = Place { span, order, what: what.into(), label: label.into(), help: help.into(), quoted: true };
        Self { first: Box::new(first), others: Vec::new() }
    }

    /// The same for `what` that says it all, with nothing to quote.
    pub fn unquoted(mut self) -> Self {
        self.first.quoted = false;
        self
    }

    /// The same, told behind what is wrong before this byte of the text: as what is missing behind what is there.
    pub fn told_behind(mut self, byte: usize) -> Self {
        self.first.order = byte;
        self
    }

    /// Both faults.
    pub fn and(mut self, other: Fault) -> Self {
        self.others.push(*other.first);
        self.others.extend(other.others);
        self
    }

    /// All of these faults; `None` if there is none.
    pub fn of_all(faults: impl IntoIterator<Item = Fault>) -> Option<Self> {
        faults.into_iter().reduce(Fault::and)
    }

    /// What is wrong outside of these places; `None` if that is nothing.
    pub fn outside(self, places: &[Range<usize>]) -> Option<Self> {
        let is_inside =
            |it: &Place| places.iter().any(|place| place.start <= it.span.start && it.span.end <= place.end);
        let mut left = std::iter::once(*self.first).chain(self.others).filter(|it| !is_inside(it));
        let first = Box::new(left.next()?);
        Some(Self { first, others: left.collect() })
    }

    /// The error to show, with the name and the text of the file.
    pub fn located(self, file: &str, text: &str) -> InputError {
        let mut places: Vec<Place> = std::iter::once(*self.first).chain(self.others).collect();
        places.sort_by_key(|place| place.order);
        let mut told = HashSet::new();
        places.retain(|place| told.insert((place.span.clone(), place.what.clone())));
        let untold = places.len().saturating_sub(MOST_TOLD);
        let file: Arc<str> = printable(file).into();
        let source = Arc::new(NamedSource::new(&file, text.to_owned()).with_language("toml"));
        let mut mistakes = places.into_iter().take(MOST_TOLD).map(|place| place.located(&file, &source));
        let first = mistakes.next().expect("a fault has a place");
        InputError::Invalid(Box::new(Invalid { first, others: mistakes.collect(), untold }))
    }
}

impl Place {
    fn located(self, file: &Arc<str>, source: &Arc<NamedSource<String>>) -> Mistake {
        let text = source.inner();
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
        Mistake {
            file: Arc::clone(file),
            line,
            column,
            message,
            label: self.label,
            help: self.help,
            source: Arc::clone(source),
            span: start..end,
            drawable,
        }
    }
}

/// Readings that do not need each other, as a tuple.
pub trait Readings {
    /// What they give.
    type Values;

    /// What all of them give.
    ///
    /// # Errors
    /// [`Fault`] with the faults of all that have one.
    fn all(self) -> Result<Self::Values, Fault>;
}

macro_rules! readings {
    ($($reading:ident $value:ident),+) => {
        impl<$($value),+> Readings for ($(Result<$value, Fault>,)+) {
            type Values = ($($value,)+);

            fn all(self) -> Result<Self::Values, Fault> {
                match self {
                    ($(Ok($reading),)+) => Ok(($($reading,)+)),
                    ($($reading,)+) => {
                        let faults = [$($reading.err()),+].into_iter().flatten();
                        Err(Fault::of_all(faults).expect("one of them has a fault"))
                    }
                }
            }
        }
    };
}

readings!(a A, b B);
readings!(a A, b B, c C);
readings!(a A, b B, c C, d D);
readings!(a A, b B, c C, d D, e E);
readings!(a A, b B, c C, d D, e E, f F);
readings!(a A, b B, c C, d D, e E, f F, g G);
readings!(a A, b B, c C, d D, e E, f F, g G, h H);

/// What all readings of a list give.
///
/// # Errors
/// [`Fault`] with the faults of the readings that have one; a long list is left behind many faults.
pub fn each<T>(readings: impl IntoIterator<Item = Result<T, Fault>>) -> Result<Vec<T>, Fault> {
    let (mut values, mut faults) = (Vec::new(), Vec::new());
    for reading in readings {
        match reading {
            Ok(value) => values.push(value),
            Err(fault) => faults.push(fault),
        }
        if faults.len() > MOST_TOLD {
            break;
        }
    }
    Fault::of_all(faults).map_or(Ok(values), Err)
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
