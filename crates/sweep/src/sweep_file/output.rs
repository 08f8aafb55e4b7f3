//! The section `[output]` of a sweep file.

use super::sections::section;
use super::specification::{Method, SolverSettings};
use crate::store::StoredOutput;
use crate::{Field, FieldPrecision};
use stribeck_input::{Entry, Fault, Quantity, Readings, each, read_axis};
use stribeck_solver::{CavityShear, FieldSelection, Output};

/// What may fill the gap behind the film by name, the default first.
pub(super) const CAVITY_SHEARS: [(&str, CavityShear); 3] =
    [("full", CavityShear::Full), ("streamers", CavityShear::Streamers), ("none", CavityShear::None)];

/// How precisely fields may be kept by name, the default first.
pub(super) const FIELD_PRECISIONS: [(&str, FieldPrecision); 2] =
    [("double", FieldPrecision::Double), ("single", FieldPrecision::Single)];

/// What is kept where there is no section `[output]`.
pub(super) fn default() -> StoredOutput {
    StoredOutput::from(&Output::default())
}

/// Reads `[output]` of a sweep that is solved so.
pub(super) fn read(entry: &Entry<'_>, solver: &SolverSettings) -> Result<StoredOutput, Fault> {
    let section = section(entry)?;
    let defaults = Output::default();
    let (fields, x, field_precision, limits, cavity_shear, sensitivities) = (
        section.optional("fields", read_fields),
        section.optional("x", |entry| read_axis(entry, Quantity::Position)),
        section.optional("field_precision", |entry| read_precision(entry, solver)),
        section.optional("limits", Entry::boolean),
        section.optional("cavity_shear", |entry| entry.choice(&CAVITY_SHEARS)),
        section.optional("sensitivities", |entry| read_sensitivities(entry, solver.method)),
    )
        .all()?;
    let output = Output {
        fields: fields.unwrap_or(defaults.fields),
        x: x.map_or(defaults.x, Into::into),
        limits: limits.unwrap_or(defaults.limits),
        cavity_shear: cavity_shear.unwrap_or(defaults.cavity_shear),
        sensitivities: sensitivities.unwrap_or(defaults.sensitivities),
    };
    Ok(StoredOutput { output, field_precision: field_precision.unwrap_or_default() })
}

/// Refuses to round what is solved more precisely. The tolerance of the relaxation method is no error.
fn read_precision(entry: &Entry<'_>, solver: &SolverSettings) -> Result<FieldPrecision, Fault> {
    let (precision, least) = (entry.choice(&FIELD_PRECISIONS)?, FieldPrecision::SINGLE_TOLERANCE);
    let is_fine = solver.method == Method::Relaxation || solver.tolerance >= least;
    if is_fine || precision == FieldPrecision::Double {
        return Ok(precision);
    }
    let what = format!(
        "`output.field_precision` may be \"single\" from a tolerance of {least:e} on, and `solver.tolerance` is {:e}",
        solver.tolerance
    );
    let help = format!(
        "numbers of fields are rounded by up to 6e-8 of themselves, a good part of such a tolerance: write \
         field_precision = \"double\", or tolerance = {least:e} in [solver]"
    );
    Err(entry.fault(what, "rounds by a good part of the tolerance", help).unquoted())
}

fn read_sensitivities(entry: &Entry<'_>, method: Method) -> Result<bool, Fault> {
    let wanted = entry.boolean()?;
    if wanted && method == Method::Relaxation {
        let what = "`output.sensitivities` needs the collocation method";
        let help = "the relaxation method has no derivatives of friction: write sensitivities = false, or \
                    method = \"collocation\" in [solver]";
        return Err(entry.fault(what, "not with the relaxation method", help));
    }
    Ok(wanted)
}

fn read_fields(entry: &Entry<'_>) -> Result<FieldSelection, Fault> {
    let choices = Field::ALL.map(|field| (field.name(), field));
    let help = "write fields = [\"pressure\", \"film_thickness\", \"displacement\"], some of them, or [] for none";
    let items = entry.require_list(help)?;
    let fields = each(items.map(|item| item.choice(&choices)))?;
    let places = entry.list().into_iter().flatten().zip(&fields).enumerate();
    each(places.map(|(place, (item, field))| match fields[..place].contains(field) {
        false => Ok(()),
        true => {
            let what = "a field may stand in `output.fields` only once";
            Err(item.fault(what, "stands there before", "remove one of the two"))
        }
    }))?;
    Ok(Field::selection(fields))
}
