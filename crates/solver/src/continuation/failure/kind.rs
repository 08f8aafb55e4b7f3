//! The kinds of failures, with their numbers, their sentences and their names.

use std::fmt;
use std::time::Duration;

use crate::continuation::NoLine;
use crate::model::{OutOfRange, SettingOutOfRange, shortest};

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
