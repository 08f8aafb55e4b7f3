//! The kind of a failure whose text is all that was stored.

/// Words that stand in the sentence of one kind alone, and the name of that kind.
const WORDS: [(&str, &str); 22] = [
    ("is beyond what double precision can be used with", "out-of-range"),
    ("is no setting of the", "setting"),
    ("no line leads from", "no-line"),
    ("the time limit of a case", "time-limit"),
    ("the solver panicked", "panic"),
    ("the solver of its chain panicked", "panic"),
    ("panels to resolve", "too-many-panels"),
    ("lost in the rounding errors of double precision", "film-too-thin"),
    ("of itself in double precision", "tolerance-too-tight"),
    ("panels whose sizes change gradually", "too-few-panels"),
    ("Newton's method broke down", "newton-broke-down"),
    ("Newton's method did not converge", "newton-stalled"),
    ("a film under tension", "tension"),
    ("times the tolerance", "error-too-large"),
    ("does not hold the dry contact", "domain-too-narrow"),
    ("longer than the grid", "film-longer-than-grid"),
    ("the flow at mid-points is wrong", "flow-error"),
    ("its dip at the outlet is narrower than a step", "narrow-dip"),
    ("its inlet and outlet are narrower than a step", "film-thinner-than-grid"),
    ("does not conserve the flow at all", "flow-lost"),
    ("the iteration diverges", "diverged"),
    ("the iteration stalls", "stalled"),
];

/// The [name](super::FailureKind::name) of the kind of a failure whose text is all that was stored; `other` if no kind
/// has such a text.
pub fn kind_name_of_text(text: &str) -> &'static str {
    // what a panic said may be anything
    let text = text.split_once(" panicked: ").map_or(text, |(before, _)| &text[..before.len() + " panicked".len()]);
    let last = WORDS.iter().filter_map(|(words, name)| Some((text.rfind(words)?, *name))).max();
    last.map_or("other", |(_, name)| name)
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::continuation::{ErrorMeasure, Failure, FailureKind, Iterations, NoLine, Seed};
    use crate::model::{OutOfRange, Substrate};

    fn one_of_each_kind() -> Vec<FailureKind> {
        let iterations = Iterations { residual: 0.1, passes: 900, tolerance: 1e-8 };
        let message = || "the iteration stalls".to_owned();
        vec![
            OutOfRange::Alpha(1e80).into(),
            OutOfRange::Beta(0.0).into(),
            OutOfRange::Strength(-1.0).into(),
            FailureKind::Setting(Box::new(
                crate::collocation::Settings::for_tolerance(2.0).check().expect_err("large"),
            )),
            NoLine::Alpha { from: 0.0, to: 1.0 }.into(),
            NoLine::Substrates { from: Substrate::default(), to: Substrate::default() }.into(),
            FailureKind::TimeLimit(Duration::from_millis(20)),
            FailureKind::Panic { message: message() },
            FailureKind::ChainPanic { message: message() },
            FailureKind::TooManyPanels { panels: 200, most: 160 },
            FailureKind::FilmTooThin { c: 1e-12, least: 1e-11 },
            FailureKind::ToleranceTooTight { c: 1e-9, rounding: 5e-8, tolerance: 1e-9 },
            FailureKind::TooFewPanels { least: 9, panels: 4 },
            FailureKind::NewtonBrokeDown,
            FailureKind::NewtonStalled { iterations: 40, step: 0.3 },
            FailureKind::Tension { ratio: -0.1 },
            FailureKind::ErrorTooLarge { measure: ErrorMeasure::Extremes, times: 2e4, tolerance: 1e-5, panels: 20 },
            FailureKind::DomainTooNarrow { domain: [-1.0, 1.0], contact: [-1.5, 1.5] },
            FailureKind::FilmLongerThanGrid { grid: [-1.0, 1.0], certain: true },
            FailureKind::FlowError { error: 0.2 },
            FailureKind::NarrowDip { ratio: 0.5 },
            FailureKind::FilmThinnerThanGrid,
            FailureKind::FlowLost,
            FailureKind::Diverged(iterations),
            FailureKind::Stalled(iterations),
            FailureKind::Other("a reason of one's own".to_owned()),
        ]
    }

    #[test]
    fn the_name_of_each_kind_is_known_from_its_text() {
        for kind in one_of_each_kind() {
            assert_eq!(kind_name_of_text(&kind.to_string()), kind.name(), "{kind}");
        }
    }

    #[test]
    fn the_text_of_several_attempts_is_of_the_kind_of_the_last() {
        for first in one_of_each_kind() {
            for last in one_of_each_kind().into_iter().filter(|kind| kind.name() != "other") {
                // A panic ends the search: nothing follows it.
                if first.name() == "panic" {
                    continue;
                }
                let earlier = vec![Failure::from(first.clone()).seeded_by(Seed::Predictor)];
                let failure = Failure::from(last.clone()).seeded_by(Seed::March(4)).after(earlier);
                assert_eq!(kind_name_of_text(&failure.to_string()), last.name(), "{failure}");
            }
        }
    }
}
