//! The section `[output]` of a sweep file.

use super::sections::section;
use super::specification::Method;
use crate::Field;
use stribeck_input::{Entry, Fault, Quantity, Readings, each, read_axis};
use stribeck_solver::{CavityShear, FieldSelection, Output};

/// What may fill the gap behind the film by name, the default first.
pub(super) const CAVITY_SHEARS: [(&str, CavityShear); 3] =
    [("full", CavityShear::Full), ("streamers", CavityShear::Streamers), ("none", CavityShear::None)];

/// Reads `[output]` of a sweep that is solved by a method.
pub(super) fn read(entry: &Entry<'_>, method: Method) -> Result<Output, Fault> {
    let section = section(entry)?;
    let defaults = Output::default();
    let (fields, x, limits, cavity_shear, sensitivities) = (
        section.optional("fields", read_fields),
        section.optional("x", |entry| read_axis(entry, Quantity::Position)),
        section.optional("limits", Entry::boolean),
        section.optional("cavity_shear", |entry| entry.choice(&CAVITY_SHEARS)),
        section.optional("sensitivities", |entry| read_sensitivities(entry, method)),
    )
        .all()?;
    Ok(Output {
        fields: fields.unwrap_or(defaults.fields),
        x: x.map_or(defaults.x, Into::into),
        limits: limits.unwrap_or(defaults.limits),
        cavity_shear: cavity_shear.unwrap_or(defaults.cavity_shear),
        sensitivities: sensitivities.unwrap_or(defaults.sensitivities),
    })
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
