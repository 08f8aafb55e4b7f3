//! Pictures of a published data set, with the numbers behind them.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `request` | [`Request`]: what is wanted, and of which part of the sweep |
//! | `curves`, `profiles`, `loops`, `surfaces`, `maps`, `stress`, `cost` | the kinds of pictures |
//! | `curve_family`, `surface_grid` | which curves stand in one picture; where surfaces are |
//! | `cases` | which cases have their fields shown |
//! | `reference_curves`, `measured_points` | limits and approximations beside solutions; measured points over curves |
//! | `axis`, `quantity` | what axes and columns are called in pictures |
//! | `sweep_data` | [`SweepData`]: the data set |
//! | `picture`, `table` | [`Picture`]: a chart and its CSV |
//!
//! Only published files are looked at: nothing is solved here.

mod axis;
mod cases;
mod cost;
mod curve_family;
mod curves;
mod error;
mod error_bars;
mod loops;
mod maps;
mod measured_points;
mod picture;
mod profiles;
mod quantity;
mod reference_curves;
mod request;
mod stress;
mod surface_grid;
mod surfaces;
mod sweep_data;
mod table;

pub use axis::{Axis, AxisWords};
pub use error::PictureError;
pub use picture::{Chart, Format, Picture, is_picture};
pub use quantity::Quantity;
pub use request::{AxisScale, Kind, Request, nearest};
pub use sweep_data::SweepData;
pub use table::Table;

use stribeck_sweep::Column;

/// The largest estimated error of the columns that curves of a request show, each over its largest value; `None` where
/// none is known.
///
/// # Errors
/// [`PictureError`] if the data set cannot be read.
pub fn largest_error(sweep: &SweepData, request: &Request) -> Result<Option<f64>, PictureError> {
    error_bars::largest(sweep, &curves::columns(sweep, request))
}

/// The pictures that are asked for; where no kind is named, all that this data set has something for.
///
/// # Errors
/// [`PictureError`] if what is named is not there, or a picture cannot be made.
pub fn pictures(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    check_names(sweep, request)?;
    if !request.kinds.is_empty() {
        let mut all = Vec::new();
        for kind in &request.kinds {
            let found = of_kind(sweep, request, *kind)?;
            if found.is_empty() {
                return Err(kind.missing("no case that is chosen has such numbers"));
            }
            all.extend(found);
        }
        return Ok(all);
    }
    const ALL: [Kind; 9] = [
        Kind::Surfaces,
        Kind::Maps,
        Kind::Curves,
        Kind::Profiles,
        Kind::Loops,
        Kind::Stress,
        Kind::Errors,
        Kind::Status,
        Kind::Cost,
    ];
    let mut all = Vec::new();
    for kind in ALL {
        match of_kind(sweep, request, kind) {
            Ok(found) => all.extend(found),
            // Nobody asked for this kind by name, and the sweep has nothing for it.
            Err(PictureError::Missing { .. }) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(all)
}

fn of_kind(sweep: &SweepData, request: &Request, kind: Kind) -> Result<Vec<Picture>, PictureError> {
    match kind {
        Kind::Surfaces => surfaces::surfaces(sweep, request),
        Kind::Maps => maps::maps(sweep, request),
        Kind::Curves => curves::curves(sweep, request),
        Kind::Profiles => profiles::profiles(sweep, request),
        Kind::Loops => loops::loops(sweep, request),
        Kind::Stress => stress::stress(sweep, request),
        Kind::Status => maps::status(sweep, request),
        Kind::Cost => cost::cost(sweep, request),
        // A map where there is one, else curves.
        Kind::Errors => match maps::errors(sweep, request) {
            Err(PictureError::Missing { .. }) => curves::errors(sweep, request),
            found => found,
        },
    }
}

/// Every name must be that of a column or of a field that is there.
fn check_names(sweep: &SweepData, request: &Request) -> Result<(), PictureError> {
    let known =
        |name: &String| Column::named(name).is_some() || sweep.data.fields.iter().any(|field| field.name() == name);
    match request.of.iter().find(|name| !known(name)) {
        None => Ok(()),
        Some(name) => {
            let columns = Column::ALL.map(Column::name).into_iter();
            let allowed: Vec<&str> = columns.chain(sweep.data.fields.iter().map(|field| field.name())).collect();
            Err(PictureError::Unknown { name: name.clone(), allowed: allowed.join(", ") })
        }
    }
}
