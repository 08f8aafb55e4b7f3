//! The section `[output]` of a sweep file.

use super::sections::section;
use super::specification::Method;
use crate::Field;
use stribeck_input::{Entry, Fault, Quantity, read_axis};
use stribeck_solver::{CavityShear, FieldSelection, Output};

/// What may fill the gap behind the film by name, the default first.
pub(super) const CAVITY_SHEARS: [(&str, CavityShear); 3] =
    [("full", CavityShear::Full), ("streamers", CavityShear::Streamers), ("none", CavityShear::None)];

/// Reads `[output]` of a sweep that is solved by a method.
pub(super) fn read(entry: &Entry<'_>, method: Method) -> Result<Output, Fault> {
    let section = section(entry)?;
    let defaults = Output::default();
    Ok(Output {
        fields: section.get("fields").map(|entry| read_fields(&entry)).transpose()?.unwrap_or(defaults.fields),
        x: match section.get("x") {
            Some(entry) => read_axis(&entry, Quantity::Position)?.into(),
            None => defaults.x,
        },
        limits: section.get("limits").map(|entry| entry.boolean()).transpose()?.unwrap_or(defaults.limits),
        cavity_shear: match section.get("cavity_shear") {
            Some(entry) => entry.choice(&CAVITY_SHEARS)?,
            None => defaults.cavity_shear,
        },
        sensitivities: match section.get("sensitivities") {
            Some(entry) => read_sensitivities(&entry, method)?,
            None => defaults.sensitivities,
        },
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
    let mut fields = Vec::new();
    let help = "write fields = [\"pressure\", \"film_thickness\", \"displacement\"], some of them, or [] for none";
    for item in entry.require_list(help)? {
        let field = item.choice(&choices)?;
        if fields.contains(&field) {
            let what = "a field may stand in `output.fields` only once";
            return Err(item.fault(what, "stands there before", "remove one of the two"));
        }
        fields.push(field);
    }
    Ok(Field::selection(fields))
}
