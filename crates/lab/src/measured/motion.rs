//! Speeds that instruments write in several forms: mean, difference, ratio, and each surface by itself.

use crate::table::Columns;

/// Leaves out what follows from the entrainment speed and the slide-to-roll ratio, where a file of an instrument has
/// both. What has its own name to the letter stays.
pub(super) fn keep_one_form(columns: &mut Columns) {
    let has = |columns: &Columns, name: &str| columns.find(name).is_some();
    if !has(columns, "entrainment_speed") || !(has(columns, "slide_roll_ratio") || sliding(columns)) {
        return;
    }
    let ratio = has(columns, "slide_roll_ratio");
    for name in ["speed", "roller_speed", "flat_speed"] {
        let is_own = columns.find(name).is_some_and(|column| column.is_own);
        if !is_own && (ratio || name != "speed") {
            columns.leave_out(name, "follows from the entrainment speed and the slide-to-roll ratio");
        }
    }
}

/// True where an instrument gives the sliding speed beside the entrainment speed, and no ratio of both.
pub(super) fn sliding(columns: &Columns) -> bool {
    let is_foreign = columns.find("speed").is_some_and(|column| !column.is_own);
    is_foreign && columns.find("entrainment_speed").is_some() && columns.find("slide_roll_ratio").is_none()
}
