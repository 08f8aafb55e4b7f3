//! Why a case has no solution: a kind with its numbers, and how the search for a solution went.

use std::fmt;
use std::time::Duration;

use super::{NoLine, Seed};
use crate::model::{OutOfRange, Parameters, SettingOutOfRange, shortest};

/// Why a case has no solution. Failing is a result, not an error of the run.
///
/// Its text is one line for a person, with all attempts in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// What happened; of several attempts, in the last one.
    pub kind: FailureKind,
    /// Where that was, if it was not at the case itself.
    pub waypoint: Option<Box<Waypoint>>,
    /// The seed that the attempt began from, if the failure belongs to one: [`Seed::None`] if there was no first guess.
    pub seed: Option<Seed>,
    /// The attempts before this one, in their order.
    pub earlier: Vec<Failure>,
}

impl Failure {
    /// The same failure at a point on the way to a case.
    #[must_use]
    pub(super) fn at(self, here: &Parameters, case: &Parameters) -> Self {
        let waypoint = Waypoint::between(here, case);
        let waypoint = if waypoint == Waypoint::default() { self.waypoint } else { Some(Box::new(waypoint)) };
        Self { waypoint, ..self }
    }

    /// The same failure as that of an attempt from a seed.
    #[must_use]
    pub(super) fn seeded_by(self, seed: Seed) -> Self {
        Self { seed: Some(seed), ..self }
    }

    /// The same failure after other attempts.
    #[must_use]
    pub(super) fn after(self, earlier: Vec<Failure>) -> Self {
        Self { earlier, ..self }
    }
}

impl From<FailureKind> for Failure {
    fn from(kind: FailureKind) -> Self {
        Self { kind, waypoint: None, seed: None, earlier: Vec::new() }
    }
}

impl From<OutOfRange> for Failure {
    fn from(out_of_range: OutOfRange) -> Self {
        FailureKind::from(out_of_range).into()
    }
}

impl std::error::Error for Failure {}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for failure in &self.earlier {
            write!(formatter, "{failure}; ")?;
        }
        match &self.seed {
            Some(Seed::None) => formatter.write_str("no first guess: ")?,
            Some(seed) => write!(formatter, "from {seed}: ")?,
            None => {}
        }
        if let Some(waypoint) = &self.waypoint {
            write!(formatter, "at {waypoint}: ")?;
        }
        self.kind.fmt(formatter)
    }
}

/// A point on the way to a case: the coordinates in which it differs from the case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Waypoint {
    /// α there.
    pub alpha: Option<f64>,
    /// β there.
    pub beta: Option<f64>,
    /// f there.
    pub f: Option<f64>,
}

impl Waypoint {
    fn between(here: &Parameters, case: &Parameters) -> Self {
        let other = |here: f64, case: f64| (here != case).then_some(here);
        Self { alpha: other(here.alpha, case.alpha), beta: other(here.beta, case.beta), f: other(here.f, case.f) }
    }
}

impl fmt::Display for Waypoint {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let coordinates = [("alpha", self.alpha), ("beta", self.beta), ("f", self.f)];
        let texts = coordinates.into_iter().filter_map(|(name, value)| Some(format!("{name} = {:.4e}", value?)));
        formatter.write_str(&texts.collect::<Vec<_>>().join(", "))
    }
}

/// What an error estimate of the collocation method found too large.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorMeasure {
    /// The estimated error of μ_v, μ_h or c.
    Estimate,
    /// The change of the largest pressure, the smallest film, the outlet or the friction behind it on richer panels.
    Extremes,
    /// The square of the last coefficients of the pressure's polynomials.
    Coarseness,
}

impl fmt::Display for ErrorMeasure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Estimate => "the estimated error",
            Self::Extremes => "what richer panels change in the largest pressure, the smallest film or the outlet",
            Self::Coarseness => "the square of what is left of the pressure's polynomials",
        })
    }
}

/// What happened in a failed case. Its text is the sentence that results show.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FailureKind {
    /// A parameter is beyond what double precision can be used with.
    #[error(transparent)]
    OutOfRange(#[from] OutOfRange),
    /// A setting is beyond what the method can be used with: no case is tried.
    #[error(transparent)]
    Setting(Box<SettingOutOfRange>),
    /// No line leads from a neighbour to the case.
    #[error(transparent)]
    NoLine(#[from] NoLine),
    /// The case took longer than it may. The only failure that depends on the machine.
    #[error(
        "not solved within {} s, the time limit of a case; raise `time_limit` in [solver] to try it again",
        shortest(.0.as_secs_f64())
    )]
    TimeLimit(Duration),
    /// The solver panicked.
    #[error("the solver panicked: {message}")]
    Panic {
        /// What it said, in one line.
        message: String,
    },
    /// The thread of the case's chain panicked outside of the solver.
    #[error("the solver of its chain panicked: {message}")]
    ChainPanic {
        /// What it said, in one line.
        message: String,
    },
    /// The film would take more panels than a mesh may have.
    #[error("the film would take {panels} panels to resolve, more than the {most} there may be")]
    TooManyPanels {
        /// The panels it would take.
        panels: usize,
        /// The panels there may be.
        most: usize,
    },
    /// The film is so thin that rounding errors are as large.
    #[error(
        "the film carries a flow of c = {c:.1e}; below {least:e} it is lost in the rounding errors of double precision"
    )]
    FilmTooThin {
        /// The flow.
        c: f64,
        /// The least flow that can be told from rounding errors.
        least: f64,
    },
    /// Rounding errors are larger than the tolerance.
    #[error(
        "a flow of c = {c:.1e} is known to {rounding:.0e} of itself in double precision, not to the tolerance \
         {tolerance:e}; ask for a larger tolerance"
    )]
    ToleranceTooTight {
        /// The flow.
        c: f64,
        /// Its relative rounding error.
        rounding: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// A fixed number of panels is too small.
    #[error("panels whose sizes change gradually are {least} at least, not {panels}; ask for more panels")]
    TooFewPanels {
        /// The least number of panels.
        least: usize,
        /// The fixed number.
        panels: usize,
    },
    /// Newton's method gave a step that is not finite.
    #[error("Newton's method broke down: a step is not finite")]
    NewtonBrokeDown,
    /// Newton's method did not converge.
    #[error(
        "Newton's method did not converge in {iterations} iterations: the last step changed the film by {step:.1e} \
         of itself"
    )]
    NewtonStalled {
        /// The iterations done.
        iterations: u64,
        /// The last step over the solution.
        step: f64,
    },
    /// The pressure of the solution is negative somewhere.
    #[error(
        "Newton's method found a film under tension, {ratio:.1e} of the largest pressure: \
         not a solution with cavitation"
    )]
    Tension {
        /// The smallest pressure over the largest.
        ratio: f64,
    },
    /// No mesh brings the error below the tolerance.
    #[error(
        "{measure} is still {} times the tolerance {tolerance:e} with {panels} panels; ask for a larger tolerance",
        if *times < 1e4 { format!("{times:.1}") } else { format!("{times:.0e}") }
    )]
    ErrorTooLarge {
        /// What is too large.
        measure: ErrorMeasure,
        /// It, over the tolerance.
        times: f64,
        /// The tolerance.
        tolerance: f64,
        /// The panels of the last mesh.
        panels: usize,
    },
    /// The fixed domain of the grid does not hold the dry contact.
    #[error(
        "the domain [{}, {}] does not hold the dry contact [{:.3}, {:.3}]; widen it or use domain = \"auto\"",
        domain[0], domain[1], contact[0], contact[1]
    )]
    DomainTooNarrow {
        /// The ends of the domain.
        domain: [f64; 2],
        /// The ends of the dry contact.
        contact: [f64; 2],
    },
    /// The film under pressure reaches an end of the grid.
    #[error(
        "the film under pressure is longer than the grid, [{:.3}, {:.3}]; set a wider domain = [x_min, x_max] in \
         [solver.relaxation]",
        grid[0], grid[1]
    )]
    FilmLongerThanGrid {
        /// The ends of the grid.
        grid: [f64; 2],
        /// True if no film is shorter; false if the film of one attempt was that long.
        certain: bool,
    },
    /// The flow of a converged state is not conserved between the points of the grid.
    #[error(
        "the grid does not resolve the film: the flow at mid-points is wrong by {:.0} % of it; use more points",
        100.0 * error
    )]
    FlowError {
        /// The error over the flow.
        error: f64,
    },
    /// The dip of the film at the outlet falls between two points.
    #[error(
        "the grid does not resolve the film: its dip at the outlet is narrower than a step \
         (smallest film {ratio:.2} c); use more points"
    )]
    NarrowDip {
        /// The smallest film over c.
        ratio: f64,
    },
    /// The film is much too thin for the grid.
    #[error("the grid does not resolve the film: its inlet and outlet are narrower than a step; use more points")]
    FilmThinnerThanGrid,
    /// The iteration ended in a state that is no film at all.
    #[error("the iteration ends in a state that does not conserve the flow at all; use more points")]
    FlowLost,
    /// The iteration ran away with every relaxation factor.
    #[error(
        "the iteration diverges with every relaxation factor tried: residual {:.1e} after {} passes, tolerance {:.1e}",
        .0.residual, .0.passes, .0.tolerance
    )]
    Diverged(Iterations),
    /// The iteration made no progress any more.
    #[error(
        "the iteration stalls: residual {:.1e} after {} passes, tolerance {:.1e}",
        .0.residual, .0.passes, .0.tolerance
    )]
    Stalled(Iterations),
    /// What a caller, or a solver that is not of this crate, says.
    #[error("{0}")]
    Other(String),
}

/// How far an iteration came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iterations {
    /// The least residual it reached.
    pub residual: f64,
    /// Passes done.
    pub passes: u64,
    /// The residual wanted.
    pub tolerance: f64,
}

impl FailureKind {
    /// True if no other first guess would lead elsewhere: the search for the case ends.
    pub fn is_conclusive(&self) -> bool {
        match self {
            Self::OutOfRange(_)
            | Self::Setting(_)
            | Self::TimeLimit(_)
            | Self::FilmTooThin { .. }
            | Self::ToleranceTooTight { .. }
            | Self::TooFewPanels { .. }
            | Self::FlowError { .. }
            | Self::NarrowDip { .. }
            | Self::FilmThinnerThanGrid => true,
            Self::FilmLongerThanGrid { certain, .. } => *certain,
            _ => false,
        }
    }

    /// A short name that stays the same whatever the sentence says; failures are grouped by it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::OutOfRange(_) => "out-of-range",
            Self::Setting(_) => "setting",
            Self::NoLine(_) => "no-line",
            Self::TimeLimit(_) => "time-limit",
            Self::Panic { .. } | Self::ChainPanic { .. } => "panic",
            Self::TooManyPanels { .. } => "too-many-panels",
            Self::FilmTooThin { .. } => "film-too-thin",
            Self::ToleranceTooTight { .. } => "tolerance-too-tight",
            Self::TooFewPanels { .. } => "too-few-panels",
            Self::NewtonBrokeDown => "newton-broke-down",
            Self::NewtonStalled { .. } => "newton-stalled",
            Self::Tension { .. } => "tension",
            Self::ErrorTooLarge { .. } => "error-too-large",
            Self::DomainTooNarrow { .. } => "domain-too-narrow",
            Self::FilmLongerThanGrid { .. } => "film-longer-than-grid",
            Self::FlowError { .. } => "flow-error",
            Self::NarrowDip { .. } => "narrow-dip",
            Self::FilmThinnerThanGrid => "film-thinner-than-grid",
            Self::FlowLost => "flow-lost",
            Self::Diverged(_) => "diverged",
            Self::Stalled(_) => "stalled",
            Self::Other(_) => "other",
        }
    }
}

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

/// The [name](FailureKind::name) of the kind of a failure whose text is all that was stored; `other` if no kind has
/// such a text.
pub fn kind_name_of_text(text: &str) -> &'static str {
    // what a panic said may be anything
    let text = text.split_once(" panicked: ").map_or(text, |(before, _)| &text[..before.len() + " panicked".len()]);
    let last = WORDS.iter().filter_map(|(words, name)| Some((text.rfind(words)?, *name))).max();
    last.map_or("other", |(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Substrate;

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

    #[test]
    fn a_text_tells_seeds_and_waypoints() {
        let (case, here) = (Parameters::new(1.0, 100.0, 10.0), Parameters::new(1.0, 5.0, 10.0));
        let first = Failure::from(FailureKind::NewtonBrokeDown).seeded_by(Seed::None);
        let last = Failure::from(FailureKind::FlowLost).at(&here, &case).seeded_by(Seed::March(2)).after(vec![first]);
        let expected = "no first guess: Newton's method broke down: a step is not finite; \
                        from march-2: at beta = 5.0000e0: the iteration ends in a state that does not conserve the flow at all; use more points";
        assert_eq!(last.to_string(), expected);
    }
}
