//! The section `[solver]` of a sweep file.

use super::sections::section;
use super::specification::{Method, SolverSettings};
use stribeck_input::{Entry, Fault, Readings};
use stribeck_solver::collocation;
use stribeck_solver::relaxation::{Acceleration, Domain, Settings};

/// The methods by name, the default first.
pub(super) const METHODS: [(&str, Method); 2] =
    [("collocation", Method::Collocation), ("relaxation", Method::Relaxation)];

/// The accelerations by name, the default first.
pub(super) const ACCELERATIONS: [(&str, Acceleration); 2] =
    [("anderson", Acceleration::Anderson), ("none", Acceleration::None)];

/// Reads `[solver]`.
pub(super) fn read(entry: &Entry<'_>) -> Result<SolverSettings, Fault> {
    let section = section(entry)?;
    let defaults = SolverSettings::default();
    let (method, tolerance, relaxation, time_limit) = (
        section.optional("method", |entry| entry.choice(&METHODS)),
        section.optional("tolerance", read_error),
        section.optional("relaxation", read_relaxation),
        section.optional("time_limit", read_time_limit),
    )
        .all()?;
    Ok(SolverSettings {
        method: method.unwrap_or_default(),
        tolerance: tolerance.unwrap_or(defaults.tolerance),
        relaxation: relaxation.unwrap_or(defaults.relaxation),
        time_limit: time_limit.unwrap_or(defaults.time_limit),
    })
}

fn read_time_limit(entry: &Entry<'_>) -> Result<f64, Fault> {
    let seconds = entry.number()?;
    if seconds > 0.0 {
        return Ok(seconds);
    }
    let help = "it is the time in seconds after which a case is given up, as in 600.0; inf is no limit";
    Err(entry.fault(format!("`{}` must be above 0", entry.path()), "not a time", help))
}

/// Reads the relative error wanted by the collocation method.
pub fn read_error(entry: &Entry<'_>) -> Result<f64, Fault> {
    let (allowed, error) = (collocation::Settings::TOLERANCE, entry.number()?);
    if allowed.contains(&error) {
        return Ok(error);
    }
    let what = format!("`{}` must be from {:e} to {:e}", entry.path(), allowed.start(), allowed.end());
    let help = "it is the relative error wanted by the collocation method, as in 1e-5; the relaxation method has a \
                tolerance of its own in [solver.relaxation]";
    Err(entry.fault(what, "out of range", help))
}

const ESTIMATE_POINTS: usize = Settings::ESTIMATE_POINTS;

fn read_relaxation(entry: &Entry<'_>) -> Result<Settings, Fault> {
    let section = section(entry)?;
    let defaults = Settings::default();
    let (domain, points, tolerance, acceleration, estimate) = (
        section.optional("domain", read_domain),
        section.optional("points", read_points),
        section.optional("tolerance", read_residual),
        section.optional("acceleration", |entry| entry.choice(&ACCELERATIONS)),
        section.optional("estimate", Entry::boolean),
    )
        .all()?;
    let settings = Settings {
        domain: domain.unwrap_or(defaults.domain),
        points: points.unwrap_or(defaults.points),
        tolerance: tolerance.unwrap_or(defaults.tolerance),
        acceleration: acceleration.unwrap_or(defaults.acceleration),
        estimate: estimate.unwrap_or(defaults.estimate),
    };
    match section.get("estimate") {
        Some(entry) if settings.estimate && settings.points < ESTIMATE_POINTS => {
            let what = format!("`solver.relaxation.estimate` needs at least {ESTIMATE_POINTS} points");
            let label = format!("not with {} points", settings.points);
            let help = "errors are estimated from a second grid of half as many intervals: write points = 201 or more, \
                        or estimate = false";
            Err(entry.fault(what, label, help))
        }
        _ => Ok(settings),
    }
}

fn read_residual(entry: &Entry<'_>) -> Result<f64, Fault> {
    let tolerance = entry.number()?;
    if Settings::TOLERANCE.contains(&tolerance) {
        return Ok(tolerance);
    }
    let what = "`solver.relaxation.tolerance` must be from 1e-12 to 1e-2";
    let help = "it is the residual at which a case counts as converged; 1e-8 is a good value";
    Err(entry.fault(what, "out of range", help))
}

/// Reads the number of points of a grid.
pub fn read_points(entry: &Entry<'_>) -> Result<usize, Fault> {
    let points = entry.whole(Settings::POINTS)?;
    if points % 2 == 1 {
        return Ok(points);
    }
    let help = format!(
        "coarse-to-fine solving halves the grid, which takes an even number of intervals: write {}; 401, 801 and 1601 \
         can be halved several times and are good",
        points + 1
    );
    Err(entry.fault(format!("`{}` must be an odd number from 51 to 20001", entry.path()), "even", help))
}

fn read_domain(entry: &Entry<'_>) -> Result<Domain, Fault> {
    let help = "write domain = \"auto\" (on the dry contact of each case), or both ends as in [-3.0, 4.0]";
    let what = "`solver.relaxation.domain` must be \"auto\" or [x_min, x_max]";
    let Some(ends) = entry.list() else {
        return match entry.text() {
            Ok("auto") => Ok(Domain::Auto),
            _ => Err(entry.fault(what, "neither", help)),
        };
    };
    let ends: Vec<Entry<'_>> = ends.take(3).collect();
    let [left, right] = ends.as_slice() else { return Err(entry.fault(what, "not two numbers", help)) };
    let (x_min, x_max) = (left.number(), right.number()).all()?;
    let help = "the contact lies within -1 and 1 (in units of a0; narrower at small alpha), and the film needs room on \
                both sides of it, as in [-3.0, 4.0]";
    let (leftmost, rightmost) = Domain::ENDS.into_inner();
    let is_left = (leftmost..0.0).contains(&x_min).then_some(()).ok_or_else(|| {
        let what = format!("x_min of the domain must be below 0 and at least {leftmost:?}");
        left.fault(what, "not left of the contact", help)
    });
    let is_right = (x_max > 0.0 && x_max <= rightmost).then_some(()).ok_or_else(|| {
        let what = format!("x_max of the domain must be above 0 and at most {rightmost:?}");
        right.fault(what, "not right of the contact", help)
    });
    (is_left, is_right).all().map(|_| Domain::Fixed { x_min, x_max })
}
