//! From a sweep over quantities of the laboratory and measured points to what a fit looks for.

use crate::{Grid, LaboratoryAxes, Method, Sweep};
use stribeck_lab::{Bounds, Experiment, FrictionTask, Measured, Unknown};

/// The points of a fit: of files that this program wrote, what is looked for is no column.
pub fn points_to_fit(measured: Measured, unknowns: &[Unknown]) -> Measured {
    if !measured.is_computed {
        return measured;
    }
    let looks_for = |is: &dyn Fn(&str) -> bool| unknowns.iter().any(|unknown| is(unknown.name()));
    let is_modulus = |name: &str| name.ends_with("_modulus") && !name.contains('.');
    measured.without(|column| looks_for(&|name| name == column || (is_modulus(name) && is_modulus(column))))
}

/// The fit of unknowns to points, with all else from a sweep, which has the value that each unknown begins at.
///
/// # Errors
/// What does not go together, and what to do.
pub fn friction_task<'a>(
    sweep: &'a Sweep,
    measured: &'a Measured,
    unknowns: &[Unknown],
    bounds: &[Bounds],
) -> Result<FrictionTask<'a>, String> {
    if let Some(name) = repeated(unknowns) {
        return Err(format!("{name} is among the unknowns twice; name it once"));
    }
    if let Some(other) = bounds.iter().find(|bounds| !unknowns.contains(&bounds.unknown)) {
        let name = other.unknown.name();
        return Err(format!(
            "{name} has bounds and is not looked for; add it to the unknowns, or leave its bounds out"
        ));
    }
    if sweep.solver.method != Method::Collocation {
        let what = "a fit needs sensitivities, which the collocation method alone has; write method = \
                    \"collocation\" in [solver]";
        return Err(what.to_owned());
    }
    let Grid::Laboratory(axes) = &sweep.grid else {
        let what = "the sweep is dimensionless, and a fit needs a speed: write the section [laboratory] in place of \
                    [axes]";
        return Err(what.to_owned());
    };
    Ok(FrictionTask {
        measured,
        experiment: beginning(axes, measured, unknowns)?,
        substrate: &sweep.substrate,
        roller_spectrum: &axes.roller_spectrum,
        cavity_shear: sweep.output.cavity_shear,
        unknowns: unknowns.to_vec(),
        bounds: bounds.to_vec(),
        tolerance: sweep.solver.tolerance,
    })
}

/// The name of an unknown that stands there twice.
fn repeated(unknowns: &[Unknown]) -> Option<&'static str> {
    let (_, again) = unknowns.iter().enumerate().find(|(place, unknown)| unknowns[..*place].contains(unknown))?;
    Some(again.name())
}

/// The experiment of the sweep, where what is neither measured nor looked for has one value.
fn beginning(axes: &LaboratoryAxes, measured: &Measured, unknowns: &[Unknown]) -> Result<Experiment, String> {
    let given = axes.given.iter().map(|given| (given.quantity.name(), given.values.len()));
    for (name, values) in given.chain([("f", axes.f.len())]) {
        if values > 1 && unknowns.iter().any(|unknown| unknown.name() == name) {
            return Err(format!(
                "{name} has {values} values in the sweep file; give it the one that the search begins at"
            ));
        }
        if values > 1 && measured.coordinate(name).is_none() {
            return Err(format!("{name} has {values} values in the sweep file and is no column here; give it one"));
        }
    }
    Ok(axes.experiment([0, 0, 0].into()))
}
