//! A quantity as colour over α and β.

use super::curves::{ERRORS, friction, named_columns};
use super::picture::{Chart, Picture};
use super::request::{Kind, Request, Selection, spread};
use super::sweep_data::SweepData;
use super::table::Table;
use super::{Axis, AxisWords, PictureError};
use stribeck_charts::{Cell, ColourScale, Map, Panel};
use stribeck_sweep::Column;
use stribeck_sweep::store::Status;

/// Most values of f side by side.
const MOST_PANELS: usize = 4;

/// The part of a sweep that maps show, by indices.
struct Shown<'a> {
    sweep: &'a SweepData,
    strengths: Vec<usize>,
    alphas: Vec<usize>,
    betas: Vec<usize>,
}

impl<'a> Shown<'a> {
    fn of(sweep: &'a SweepData, request: &Request, kind: Kind) -> Result<Self, PictureError> {
        let selection = Selection::of(sweep, request)?;
        check_plane(sweep, kind)?;
        for axis in [Axis::Middle, Axis::Inner] {
            if selection.on(axis).len() < 2 {
                return Err(kind.missing(why_no_grid(sweep, axis, "map")));
            }
            if selection.on(axis).iter().any(|index| sweep.value(axis, *index) < 0.0) {
                let name = &sweep.axis(axis).name;
                let why =
                    format!("{name} has values below 0, and the axes of a map are logarithmic; try --what curves");
                return Err(kind.missing(why));
            }
        }
        let strengths = selection.on(Axis::F);
        let asked = selection.is_asked(Axis::F);
        Ok(Self {
            sweep,
            strengths: if asked { strengths.to_vec() } else { spread(strengths, MOST_PANELS) },
            alphas: selection.on(Axis::Middle).to_vec(),
            betas: selection.on(Axis::Inner).to_vec(),
        })
    }

    /// The map of a number of each place.
    fn map(
        &self,
        (name, label): (&str, &str),
        contours: bool,
        cell: impl Fn(usize) -> Cell,
        logarithmic: impl FnOnce(&mut dyn Iterator<Item = f64>) -> bool,
    ) -> Map {
        let panel = |i_f: &usize| {
            let places = self.betas.iter().flat_map(|i_beta| {
                self.alphas.iter().map(move |i_alpha| self.sweep.data.place([*i_f, *i_alpha, *i_beta]))
            });
            Panel { cells: places.map(&cell).collect() }
        };
        let panels: Vec<Panel> = self.strengths.iter().map(panel).collect();
        let mut values = panels.iter().flat_map(|panel| &panel.cells).filter_map(|cell| match cell {
            Cell::Value(value) => Some(*value),
            _ => None,
        });
        let logarithmic = logarithmic(&mut values);
        let subtitle = [name.to_owned()].into_iter().chain(self.sweep.held()).collect::<Vec<_>>().join("; ");
        let on = |axis: Axis, indices: &[usize]| {
            let values = || indices.iter().map(|i| self.sweep.value(axis, *i));
            let (unit, label) = self.sweep.axis(axis).shown(values());
            (label, values().map(|value| unit.shown(value)).collect::<Vec<f64>>())
        };
        let ((x_label, x), (y_label, y)) = (on(Axis::Middle, &self.alphas), on(Axis::Inner, &self.betas));
        Map {
            title: self.sweep.data.title.clone(),
            subtitle,
            x_label,
            y_label,
            columns: self.strengths.iter().map(|i_f| self.sweep.words(Axis::F, *i_f)).collect(),
            rows: vec![String::new()],
            x,
            y,
            panels,
            scale: ColourScale { label: label.to_owned(), logarithmic, range: None },
            contours,
        }
    }

    /// The numbers behind a map.
    fn table(&self, column: &str, text: impl Fn(usize) -> (String, f64)) -> Table {
        let mut table = Table::new(&[&["status"], &self.sweep.coordinate_names()[..], &[column]].concat());
        for i_f in &self.strengths {
            for i_alpha in &self.alphas {
                for i_beta in &self.betas {
                    let indices = [*i_f, *i_alpha, *i_beta];
                    let (status, value) = text(self.sweep.data.place(indices));
                    table.row(&[&status], &[&self.sweep.coordinates(indices)[..], &[value]].concat());
                }
            }
        }
        table
    }
}

/// A map for each column asked for, with lines of equal value.
pub(super) fn maps(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let shown = Shown::of(sweep, request, Kind::Maps)?;
    let statuses = sweep.data.statuses()?;
    let mut pictures = Vec::new();
    for quantity in named_columns(sweep, request, &[&friction(sweep, request)[..], &[Column::FilmMin]].concat()) {
        let values = quantity.values(&sweep.data)?;
        let largest = values.iter().filter(|it| it.is_finite()).fold(0.0, |most: f64, it| most.max(it.abs()));
        let unit = quantity.unit(sweep.data.laboratory, largest);
        let map = shown.map(
            (&quantity.title(), &unit.label(&quantity.title())),
            true,
            |place| cell(statuses[place], unit.shown(values[place])),
            |values| request.scale.is_logarithmic(values),
        );
        // Without a solution there is nothing to show; the map of status says so.
        if map.panels.iter().flat_map(|panel| &panel.cells).any(|cell| matches!(cell, Cell::Value(_))) {
            let table = shown.table(quantity.name, |place| (statuses[place].name().to_owned(), values[place]));
            pictures.push(Picture { name: format!("map-{}", quantity.name), chart: Chart::Map(map), table });
        }
    }
    Ok(pictures)
}

/// The largest estimated error of each case.
pub(super) fn errors(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let shown = Shown::of(sweep, request, Kind::Errors)?;
    let statuses = sweep.data.statuses()?;
    let largest = largest_errors(sweep)?;
    if largest.iter().all(|error| error.is_nan()) {
        return Err(Kind::Errors.missing(
            "no case has estimated errors; with the relaxation method ask for them: estimate = true below \
             [solver.relaxation]",
        ));
    }
    let label = "largest estimated relative error of μᵥ, μₕ, μ_{drag} and c";
    let map =
        shown.map((label, "estimated relative error"), false, |place| cell(statuses[place], largest[place]), |_| true);
    let table = shown.table("largest_error", |place| (statuses[place].name().to_owned(), largest[place]));
    Ok(vec![Picture { name: "map-errors".to_owned(), chart: Chart::Map(map), table }])
}

/// Which cases converged; not shown unasked where all did.
pub(super) fn status(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    let shown = Shown::of(sweep, request, Kind::Status)?;
    let statuses = sweep.data.statuses()?;
    let failed = statuses.iter().filter(|status| **status == Status::Failed).count();
    if failed == 0 && request.kinds.is_empty() {
        return Err(Kind::Status.missing("no case failed"));
    }
    let converged = |status: Status| if status == Status::Failed { Cell::Failed } else { Cell::Solved };
    let words = format!("{} places of the sweep converged, {failed} failed", statuses.len() - failed);
    let map = shown.map((&words, ""), false, |place| converged(statuses[place]), |_| true);
    let reasons = sweep.data.reasons()?;
    let table = shown.table("failed", |place| {
        let reason = &reasons[place];
        let status = statuses[place].name();
        let text = if reason.is_empty() { status.to_owned() } else { format!("{status}: {reason}") };
        (text, if statuses[place] == Status::Failed { 1.0 } else { 0.0 })
    });
    Ok(vec![Picture { name: "map-status".to_owned(), chart: Chart::Map(map), table }])
}

/// Checks that no axis of a plane stands for several quantities, whose combinations have no order.
pub(super) fn check_plane(sweep: &SweepData, kind: Kind) -> Result<(), PictureError> {
    let axis = sweep.axis(Axis::Middle);
    if axis.name != AxisWords::COMBINATION {
        return Ok(());
    }
    let names = sweep.dimension_names(Axis::Middle).join(", ");
    Err(kind.missing(format!("{names} vary together; give one value of all but one with --at, as in --at load=100")))
}

/// Why there is no plane to draw on.
pub(super) fn why_no_grid(sweep: &SweepData, axis: Axis, what: &str) -> String {
    match sweep.axis(axis).name.as_str() {
        "" => format!("there is no axis between f and the speed here, and a {what} needs one; try --what curves"),
        name => format!("{name} has one value here, and a {what} needs two; try --what curves"),
    }
}

/// The largest of the estimates of each place; NaN where one is not known.
pub(super) fn largest_errors(sweep: &SweepData) -> Result<Vec<f64>, PictureError> {
    let columns: Vec<Vec<f64>> =
        ERRORS.into_iter().map(|column| sweep.data.column(column)).collect::<Result<_, _>>()?;
    let largest = |place: usize| {
        let errors = columns.iter().map(|errors| errors[place]);
        errors.fold(
            0.0,
            |largest: f64, error| if largest.is_nan() || error.is_nan() { f64::NAN } else { largest.max(error) },
        )
    };
    Ok((0..columns[0].len()).map(largest).collect())
}

fn cell(status: Status, value: f64) -> Cell {
    match status {
        Status::Failed => Cell::Failed,
        Status::Converged if value.is_finite() => Cell::Value(value),
        Status::Converged => Cell::Unknown,
    }
}
