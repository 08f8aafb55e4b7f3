//! Pictures of a published data set, with the numbers behind them.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `request` | [`Request`]: what is wanted, and of which part of the sweep |
//! | `curves`, `profiles`, `loops`, `surfaces`, `maps`, `stress`, `cost` | the kinds of pictures |
//! | `curve_family`, `surface_grid` | which curves stand in one picture; where surfaces are |
//! | `cases` | which cases have their fields shown |
//! | `reference_curves`, `measured_points` | limits and approximations beside solutions; measured points over curves |
//! | `axis`, `quantity`, `engineering` | what axes and columns are called in pictures, and numbers with units |
//! | `sweep_data` | [`SweepData`]: the data set |
//! | `picture`, `table` | [`Picture`]: a chart and its CSV |
//!
//! Only published files are looked at: nothing is solved here.

mod axis;
mod cases;
mod cost;
mod curve_family;
mod curves;
mod engineering;
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

pub use axis::{Axis, AxisWords, held, symbol_and_words, typeset};
pub use engineering::ShownUnit;
pub use error::PictureError;
pub use picture::{Chart, Format, Picture, is_picture, made_with};
pub use quantity::Quantity;
pub use request::{AxisScale, Kind, Request, nearest};
pub use sweep_data::SweepData;
pub use table::Table;

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
    let mut all = Vec::new();
    let mut add = |found: Result<Vec<Picture>, PictureError>| match found {
        Ok(found) => {
            all.extend(found);
            Ok(())
        }
        // Nobody asked for this kind by name, and the sweep has nothing for it.
        Err(PictureError::Missing { .. }) => Ok(()),
        Err(error) => Err(error),
    };
    let is_experiment = sweep.data.laboratory;
    if is_experiment && request.of.is_empty() {
        add(curves::drag_with_parts(sweep, request))?;
    }
    const PLANES: [Kind; 2] = [Kind::Surfaces, Kind::Maps];
    const LINES: [Kind; 4] = [Kind::Curves, Kind::Profiles, Kind::Loops, Kind::Stress];
    let (first, then) = if is_experiment { (&LINES[..], &PLANES[..]) } else { (&PLANES[..], &LINES[..]) };
    for kind in first.iter().chain(then).chain(&[Kind::Errors, Kind::Status, Kind::Cost]) {
        add(of_kind(sweep, request, *kind))?;
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
    let fields = || sweep.data.fields.iter().map(|field| field.name());
    let names: Vec<&str> = Quantity::all(&sweep.data).map(|quantity| quantity.name).chain(fields()).collect();
    match request.of.iter().find(|name| !names.contains(&name.as_str())) {
        None => Ok(()),
        Some(name) => Err(PictureError::Unknown { name: name.clone(), allowed: names.join(", ") }),
    }
}
