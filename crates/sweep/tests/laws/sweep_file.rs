//! Any bytes as a sweep file: they are a sweep with a plan, or refused with a place and a remedy.

use std::collections::HashSet;

use miette::{GraphicalReportHandler, GraphicalTheme};
use stribeck_input::InputError;
use stribeck_sweep::{Axes, CaseId, MAX_CHAIN, Plan, Sweep};

/// Up to this many cases a plan is gone through case by case.
const FEW: usize = 2000;

/// What the program shows of an error, without colours.
pub fn drawn(error: &InputError) -> String {
    let mut drawing = String::new();
    GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor())
        .render_report(&mut drawing, error)
        .expect("a diagnostic can always be drawn");
    drawing
}

/// Panics if a law is broken. Bytes that are no text have no law but that of the reader of files.
pub fn check(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Sweep::parse("any", text) {
        Ok(sweep) => taken(&sweep, text),
        Err(error) => refused(&error, text),
    }
}

fn refused(error: &InputError, text: &str) {
    let InputError::Invalid(invalid) = error else { panic!("{error}") };
    let (line, column) = (invalid.line(), invalid.column());
    let found = text.split('\n').nth(line - 1).expect("the line is in the text");
    assert!((1..=found.chars().count() + 1).contains(&column), "column {column} of {found:?}");
    let message = error.to_string();
    assert!(message.starts_with(&format!("any.toml:{line}:{column}: ")), "{message}");
    assert!(!message.chars().any(char::is_control), "one line that leaves the terminal alone: {message:?}");
    assert!(!error.remedy().is_empty());
    let drawing = drawn(error);
    assert!(!drawing.chars().any(|c| c.is_control() && c != '\n'), "{drawing:?}");
    let told = invalid.mistakes().count();
    assert!(drawing.len() <= 20_000 * told, "{told} mistakes of {} bytes", drawing.len());
}

fn taken(sweep: &Sweep, text: &str) {
    assert_eq!(sweep.text, text);
    let Some(Axes { f, alpha, beta, .. }) = sweep.grid.axes() else { return };
    for axis in [f, alpha, beta] {
        assert!(!axis.is_empty() && axis.is_sorted_by(|left, right| left < right), "{axis:?}");
    }
    assert!(f[0] >= 0.0 && alpha[0] >= 0.0 && beta[0] > 0.0);
    assert!(f.iter().chain(beta).all(|value| value.is_finite()));
    assert_eq!(Sweep::parse(&sweep.name, text).as_ref().ok(), Some(sweep), "the same again");
    planned(sweep, &Plan::new(sweep));
}

fn planned(sweep: &Sweep, plan: &Plan) {
    let Some(Axes { f, alpha, beta, .. }) = sweep.grid.axes() else { return };
    assert_eq!(plan.cases(), f.len() * alpha.len() * beta.len());
    assert!((1..=plan.cases()).contains(&plan.problems()));
    if plan.cases() > FEW {
        return;
    }
    let mut solved = HashSet::new();
    for chain in plan.chains() {
        assert!((1..=MAX_CHAIN).contains(&chain.cases.len()) && chain.cases.end <= beta.len());
        assert!(plan.ids(&chain).into_iter().all(|id| solved.insert(id)), "a case is solved twice");
    }
    assert_eq!(solved.len(), plan.problems());
    let shape = sweep.grid.shape();
    assert_eq!(shape.lengths(), [f.len(), alpha.len(), beta.len()]);
    let wanted: HashSet<CaseId> = (0..shape.places()).map(|place| plan.case_at(shape.index(place))).collect();
    assert_eq!(solved, wanted, "what is solved is what the sweep asks for");
}
