//! Errors of the libraries as exceptions of the package, with the messages of the program.

use std::fmt::Display;

use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme};
use pyo3::PyErr;
use stribeck_input::InputError as FileFault;
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
    exceptions::InputError::new_err(what.to_string())
}

/// Nothing was fitted.
pub fn fit(what: impl Display) -> PyErr {
    exceptions::FitError::new_err(what.to_string())
}

/// The disk, or a file of results, is not as it should be.
pub fn storage(what: impl Display) -> PyErr {
    exceptions::StorageError::new_err(what.to_string())
}

/// A file or a text is wrong: the line is drawn, with the place and the remedy.
pub fn fault(fault: &FileFault) -> PyErr {
    input(drawn(fault))
}

/// A value is wrong: what it is and what to do, in one line without a place, which a value has none of.
pub fn value(fault: &FileFault) -> PyErr {
    let text = fault.to_string();
    let what = text.splitn(4, ':').nth(3).map_or(text.as_str(), str::trim_start);
    input(fault.help().map_or_else(|| what.to_owned(), |help| format!("{what}: {help}")))
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
