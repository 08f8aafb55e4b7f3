//! Pictures of a published data set, with the numbers behind them.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `request` | [`Request`]: what is wanted, and of which part of the sweep |
//! | `curves`, `profiles`, `loops`, `surfaces`, `maps`, `stress`, `cost` | the kinds of pictures |
//! | `known`, `family` | limits and approximations beside solutions; curves that belong together |
//! | `overlay` | measured points over curves |
//! | `bundle`, `cases`, `plane` | which curves stand together; which cases have their fields shown; where surfaces are |
//! | `axis`, `quantity` | what axes and columns are called in pictures |
//! | `source` | the data set |
//! | `picture`, `table` | [`Picture`]: a chart and its CSV |
//!
//! Only published files are looked at: nothing is solved here.

mod axis;
mod bundle;
mod cases;
mod cost;
mod curves;
mod error;
mod family;
mod known;
mod loops;
mod maps;
mod overlay;
mod picture;
mod plane;
mod profiles;
mod quantity;
mod request;
mod source;
mod stress;
mod surfaces;
mod table;

pub use axis::{Axis, AxisWords};
pub use error::PictureError;
pub use picture::{Chart, Format, Picture};
pub use quantity::Quantity;
pub use request::{AxisScale, Kind, Request, nearest};
pub use source::Source;
pub use table::Table;

use stribeck_sweep::Column;

/// The pictures that are asked for; where no kind is named, all that this data set has something for.
///
/// # Errors
/// [`PictureError`] if what is named is not there, or a picture cannot be made.
pub fn pictures(source: &Source, request: &Request) -> Result<Vec<Picture>, PictureError> {
    check_names(source, request)?;
    if !request.kinds.is_empty() {
        let mut all = Vec::new();
        for kind in &request.kinds {
            let found = of_kind(source, request, *kind)?;
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
        match of_kind(source, request, kind) {
            Ok(found) => all.extend(found),
            // Nobody asked for this kind by name, and the sweep has nothing for it.
            Err(PictureError::Missing { .. }) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(all)
}

fn of_kind(source: &Source, request: &Request, kind: Kind) -> Result<Vec<Picture>, PictureError> {
    match kind {
        Kind::Surfaces => surfaces::surfaces(source, request),
        Kind::Maps => maps::maps(source, request),
        Kind::Curves => curves::curves(source, request),
        Kind::Profiles => profiles::profiles(source, request),
        Kind::Loops => loops::loops(source, request),
        Kind::Stress => stress::stress(source, request),
        Kind::Status => maps::status(source, request),
        Kind::Cost => cost::cost(source, request),
        // A map where there is one, else curves.
        Kind::Errors => match maps::errors(source, request) {
            Err(PictureError::Missing { .. }) => curves::errors(source, request),
            found => found,
        },
    }
}

/// Every name must be that of a column or of a field that is there.
fn check_names(source: &Source, request: &Request) -> Result<(), PictureError> {
    let known =
        |name: &String| Column::named(name).is_some() || source.data.fields.iter().any(|field| field.name() == name);
    match request.of.iter().find(|name| !known(name)) {
        None => Ok(()),
        Some(name) => {
            let allowed: Vec<&str> = Column::ALL
                .map(Column::name)
                .into_iter()
                .chain(source.data.fields.iter().map(|field| field.name()))
                .collect();
            Err(PictureError::Unknown { name: name.clone(), allowed: allowed.join(", ") })
        }
    }
}
