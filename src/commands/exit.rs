//! Exit codes: what a command tells the shell.

use super::CliError;
use crate::pictures::PictureError;
use stribeck_charts::ChartError;
use stribeck_input::is_of_disk;
use stribeck_surface::SurfaceError;
use stribeck_sweep::campaign::CampaignError;
use stribeck_sweep::surface::SurfaceBuildError;

/// How a command ended that did what it was asked to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// All is well.
    Success,
    /// A surface is not as exact as it says.
    DoesNotHold,
    /// Done, but some cases failed.
    CasesFailed,
    /// Damage was found.
    Damaged,
    /// A time limit ended it: what was found so far is printed.
    TimeIsUp,
    /// Stopped by a signal.
    Interrupted,
}

impl Exit {
    /// The exit code.
    pub fn code(self) -> u8 {
        match self {
            Exit::Success => 0,
            Exit::DoesNotHold => 1,
            Exit::CasesFailed => 3,
            Exit::Damaged => 4,
            Exit::TimeIsUp => 5,
            Exit::Interrupted => 130,
        }
    }
}

impl CliError {
    /// The exit code: 2 for bad input, 4 for the disk and the system, 5 for a time limit.
    pub fn code(&self) -> u8 {
        match self {
            CliError::Input(error) | CliError::Campaign(CampaignError::Input(error)) if error.is_of_disk() => 4,
            CliError::Table(error) if error.is_of_disk() => 4,
            CliError::Surface { source: SurfaceError::Unreadable(error), .. } if is_of_disk(error) => 4,
            CliError::Input(_)
            | CliError::Table(_)
            | CliError::NotLaboratory { .. }
            | CliError::FlatAtRest
            | CliError::RollerOverFlatAtRest
            | CliError::Modes(_)
            | CliError::SeveralCurves { .. }
            | CliError::NoSuchAxis { .. }
            | CliError::SeveralAsked { .. }
            | CliError::NoFit { .. }
            | CliError::Fit { .. }
            | CliError::Series { .. }
            | CliError::MasterCurve { .. }
            | CliError::NoShifts { .. }
            | CliError::Unused { .. }
            | CliError::NoTarget
            | CliError::IsInput { .. }
            | CliError::NoName { .. }
            | CliError::NoTimeToWork { .. }
            | CliError::NameForSlurm { .. }
            | CliError::Picture(
                PictureError::Unknown { .. }
                | PictureError::Outside { .. }
                | PictureError::NoAxis { .. }
                | PictureError::Missing { .. },
            )
            | CliError::Threads(_)
            | CliError::Surface { .. }
            | CliError::Outside(_)
            | CliError::NotAnAxis { .. }
            | CliError::OtherValue { .. }
            | CliError::NoCoordinate { .. }
            | CliError::Points { .. }
            | CliError::Estimate { .. }
            | CliError::OtherMethod { .. }
            | CliError::Sensitivities
            | CliError::Chart(ChartError::Letters { .. } | ChartError::Height { .. })
            | CliError::Tolerance { .. } => 2,
            CliError::Campaign(error) => code_of_campaign(error),
            CliError::SurfaceBuild(error) => code_of_build(error),
            CliError::TimeIsUp => 5,
            CliError::Store(_)
            | CliError::Incomplete { .. }
            | CliError::Foreign { .. }
            | CliError::IsThere { .. }
            | CliError::Slurm { .. }
            | CliError::Directory { .. }
            | CliError::Unwritten { .. }
            | CliError::Chart(_)
            | CliError::Picture(PictureError::Store(_) | PictureError::Chart(_))
            | CliError::Stopped { .. }
            | CliError::System { .. } => 4,
        }
    }
}

fn code_of_campaign(error: &CampaignError) -> u8 {
    match error {
        CampaignError::Input(_)
        | CampaignError::Threads(_)
        | CampaignError::NothingToMerge
        | CampaignError::OtherSweep { .. }
        | CampaignError::NoSuchAxis { .. }
        | CampaignError::NoSuchCase { .. } => 2,
        CampaignError::Store(_)
        | CampaignError::NotADirectory { .. }
        | CampaignError::Parts { .. }
        | CampaignError::Stopped { .. } => 4,
    }
}

fn code_of_build(error: &SurfaceBuildError) -> u8 {
    match error {
        SurfaceBuildError::NoNumber { .. } | SurfaceBuildError::Threads(_) => 2,
        SurfaceBuildError::Failed { .. } => 3,
        SurfaceBuildError::Interrupted => 130,
        _ => 4,
    }
}
