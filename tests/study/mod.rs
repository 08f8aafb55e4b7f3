//! Studies: what files are taken, what the measures mean, and what comes out.

mod files;
mod laws;
mod published;

use std::num::NonZeroUsize;

use stribeck::study::{Findings, Row, Study, run};
use stribeck_solver::continuation::Interrupt;

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
