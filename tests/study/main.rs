//! Studies: what files are taken, what the measures mean, and what comes out.

mod files;
mod laws;
#[path = "../program/mod.rs"]
mod program;
mod published;

use std::num::NonZeroUsize;

use stribeck::continuation::Interrupt;
use stribeck::study::{Findings, Row, Study, run};

/// The study of a text.
fn study(text: &str) -> Study {
    Study::parse("test", text).unwrap_or_else(|error| panic!("{error}"))
}

/// Runs a study on one thread; memory is not measured.
fn findings(study: &Study) -> Findings {
    let no_meter = |work: &mut dyn FnMut()| {
        work();
        0
    };
    run(study, NonZeroUsize::MIN, &no_meter, &Interrupt::new(), |_| {}).expect("one thread is to be had")
}

/// The rows of one variant.
fn of(rows: &[Row], variant: usize) -> Vec<&Row> {
    rows.iter().filter(|row| row.variant == variant).collect()
}
