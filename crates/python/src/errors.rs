//! Errors of the libraries as exceptions of the package, with the messages of the program.

use std::fmt::Display;

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use pyo3::PyErr;
use stribeck_input::InputError as FileFault;
use stribeck_lab::TableError;
use stribeck_sweep::campaign::CampaignError;

/// Exceptions of the package, which are defined in Python so that they can be pickled.
mod exceptions {
    use pyo3::import_exception;

    import_exception!(stribeck._errors, FitError);
    import_exception!(stribeck._errors, InputError);
    import_exception!(stribeck._errors, StorageError);
}

/// What the caller gave is wrong.
pub fn input(what: impl Display) -> PyErr {
    exceptions::InputError::new_err(with_keywords(&what.to_string()))
}

/// Nothing was fitted.
pub fn fit(what: impl Display) -> PyErr {
    exceptions::FitError::new_err(with_keywords(&what.to_string()))
}

/// The disk, or a file of results, is not as it should be.
pub fn storage(what: impl Display) -> PyErr {
    exceptions::StorageError::new_err(with_keywords(&what.to_string()))
}

/// A file or a text is wrong: the line is drawn, with the place and the remedy.
pub fn fault(fault: &FileFault) -> PyErr {
    exceptions::InputError::new_err(drawn(fault))
}

/// A value is wrong: what it is and what to do, in one line without a place, which a value has none of.
pub fn value(fault: &FileFault) -> PyErr {
    let text = fault.to_string();
    let what = text.splitn(4, ':').nth(3).map_or(text.as_str(), str::trim_start);
    input(fault.help().map_or_else(|| what.to_owned(), |help| format!("{what}: {help}")))
}

/// A table of a laboratory could not be read.
pub fn table(error: &TableError) -> PyErr {
    if error.is_of_disk() { storage(error) } else { input(error) }
}

/// A sweep could not be run.
pub fn campaign(error: &CampaignError) -> PyErr {
    match error {
        CampaignError::Input(cause) => fault(cause),
        CampaignError::Threads(_)
        | CampaignError::NothingToMerge
        | CampaignError::OtherSweep { .. }
        | CampaignError::NoSuchAxis { .. }
        | CampaignError::NoSuchCase { .. } => input(error),
        CampaignError::Store(_)
        | CampaignError::NotADirectory { .. }
        | CampaignError::Parts { .. }
        | CampaignError::Stopped { .. } => storage(error),
    }
}

/// A message in one line, and below it the line of the file with what to do.
fn drawn(fault: &dyn Diagnostic) -> String {
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor());
    let handler = handler.with_break_words(false).without_cause_chain().with_width(100);
    let mut text = String::new();
    // Writing to a string does not fail.
    match handler.render_report(&mut text, fault) {
        Ok(()) => text.trim().trim_start_matches("× ").to_owned(),
        Err(_) => fault.to_string(),
    }
}

/// A text of the libraries with the options of the program that it names as keywords of Python: `--columns "speed=#3"`
/// becomes `columns="speed=#3"`. What stands between backticks is a command or a name, and stays.
pub fn with_keywords(text: &str) -> String {
    let parts = text.split('`').enumerate();
    let parts = parts.map(|(i, part)| if i % 2 == 0 { outside_of_commands(part) } else { part.to_owned() });
    parts.collect::<Vec<_>>().join("`")
}

fn outside_of_commands(text: &str) -> String {
    let text = text.replace(" with -o", " with output");
    let mut pieces = text.split("--");
    let mut changed = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let end = piece.find(|c: char| !(c.is_ascii_lowercase() || c == '-')).unwrap_or(piece.len());
        let (name, rest) = piece.split_at(end);
        let value = rest.strip_prefix(' ').map_or("", argument);
        let rest = &rest[if value.is_empty() { 0 } else { 1 + value.len() }..];
        let value = match value {
            "" => "True".to_owned(),
            word if WORDS.contains(&word) => format!("\"{word}\""),
            pair if pair.contains('=') && !pair.starts_with('"') => format!("\"{pair}\""),
            value => value.to_owned(),
        };
        changed += &format!("{}={value}{rest}", name.replace('-', "_"));
    }
    changed
}

/// Arguments of options that are words in small letters.
const WORDS: [&str; 2] = ["density", "fit"];

/// The argument of an option at the beginning of a text: what is quoted, NAME=COLUMN up to a colon, a number, a word in
/// capitals or one of [`WORDS`]; else nothing.
fn argument(text: &str) -> &str {
    if let Some(quoted) = text.strip_prefix('"') {
        return &text[..quoted.find('"').map_or(text.len(), |end| end + 2)];
    }
    let end = text.find([' ', ',', ';', ':', ')']).unwrap_or(text.len());
    if text[..end].contains('=') {
        return &text[..text.find(": ").unwrap_or(end)];
    }
    let is_argument = text.starts_with(|c: char| c.is_ascii_digit() || c.is_ascii_uppercase());
    if is_argument || WORDS.contains(&&text[..end]) { &text[..end] } else { "" }
}
