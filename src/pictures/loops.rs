//! What a point of the surface goes through: pressure against its height, from the inlet to the outlet.

use std::f64::consts::PI;

use super::cases::Cases;
use super::curve_family::{beside, member_colour};
use super::picture::{Chart, Picture};
use super::profiles::suffix;
use super::reference_curves::dry_pressure;
use super::request::{Kind, Request};
use super::sweep_data::{SweepData, rounded};
use super::table::Table;
use super::{Axis, PictureError};
use stribeck_charts::{Curve, LineAxis, Lines, Stroke};
use stribeck_solver::exact::DryContact;
use stribeck_sweep::{Column, Field};

/// The part of a loop with pressure, on points of its own.
struct Loop {
    x: Vec<f64>,
    heights: Vec<f64>,
    pressure: Vec<f64>,
    /// The area of the whole loop.
    area: f64,
}

impl Loop {
    /// The loop of a published case: from a point before the outlet to where the pressure is below a thousandth.
    fn solved(sweep: &SweepData, indices: [usize; 3]) -> Result<Self, PictureError> {
        let pressure = sweep.dimensionless_field(Field::Pressure, indices)?;
        let film = sweep.dimensionless_field(Field::FilmThickness, indices)?;
        let x = &sweep.data.x;
        let heights: Vec<f64> = x.iter().zip(&film).map(|(x, u)| height(*x, *u)).collect();
        let peak = pressure.iter().copied().fold(0.0, f64::max);
        let loaded = |i: &usize| pressure[*i] > 1e-3 * peak;
        let first = (0..x.len()).find(loaded).map_or(0, |i| i.saturating_sub(1));
        let last = (0..x.len()).rfind(loaded).map_or(x.len() - 1, |i| (i + 1).min(x.len() - 1));
        let kept = |values: &[f64]| values[first..=last].to_vec();
        Ok(Loop { area: area(&heights, &pressure), x: kept(x), heights: kept(&heights), pressure: kept(&pressure) })
    }

    /// The loop of a dry contact, whose film is zero.
    fn dry(contact: &DryContact) -> Self {
        let (x, pressure) = dry_pressure(contact);
        let heights = x.iter().map(|x| height(*x, 0.0)).collect();
        Loop { x, heights, pressure, area: contact.friction() }
    }

    fn points(&self) -> Vec<(f64, f64)> {
        self.heights.iter().copied().zip(self.pressure.iter().copied()).collect()
    }

    /// Adds the points to a table.
    fn list(&self, table: &mut Table, kind: &str, coordinates: &[f64]) {
        for ((x, height), pressure) in self.x.iter().zip(&self.heights).zip(&self.pressure) {
            table.row(&[kind], &[coordinates, &[*x, *height, *pressure]].concat());
        }
    }
}

/// The loops of chosen cases in one picture.
///
/// The height of the surface is w − h₀ = x²/2 − u (T3): where it starts from is the same in all cases. The area of a
/// loop is F_v = (2/π) ∫ p dw (Eq. 22), here by trapezia over the published x, beside the μᵥ of the solver.
pub(super) fn loops(sweep: &SweepData, request: &Request) -> Result<Vec<Picture>, PictureError> {
    sweep.check_fields(Kind::Loops, &[Field::Pressure, Field::FilmThickness])?;
    let cases = Cases::choose(sweep, request, Kind::Loops, Axis::Inner)?;
    let friction = sweep.data.column(Column::MuV)?;
    let mut table = Table::new(&[&["kind"], &sweep.coordinate_names()[..], &["x", "height", "pressure"]].concat());
    let (mut curves, mut dry_loops, mut dry_area) = (Vec::new(), Vec::new(), None);
    for (i, indices) in cases.indices.iter().enumerate() {
        let solved = Loop::solved(sweep, *indices)?;
        let mut coordinates = sweep.coordinates(*indices);
        solved.list(&mut table, "solution", &coordinates);
        let colour = member_colour(i, cases.indices.len());
        // areas are over the scales
        let mu_v = if sweep.data.laboratory { "μᵥR/a₀" } else { "μᵥ" };
        let label = format!(
            "{}: area {}, {mu_v} {}",
            cases.label(sweep, *indices),
            rounded(solved.area),
            rounded(friction[sweep.data.place(*indices)] / sweep.factor(Column::MuV.units(), *indices)),
        );
        let points = solved.points();
        let mark = Some(i).filter(|_| cases.indices.len() > 1);
        curves.push(Curve { label, points, failed: vec![], stroke: Stroke::Solid, colour, mark });
        if let Some(case) = sweep.parameters(*indices).filter(|_| !request.bare)
            && let Some(contact) = DryContact::of(&case)
        {
            let dry = Loop::dry(&contact);
            // β is the last coordinate, and ∞ in dry sliding.
            *coordinates.last_mut().expect("there are coordinates") = f64::INFINITY;
            dry.list(&mut table, "dry limit", &coordinates);
            dry_loops.push((colour, dry.points()));
            dry_area = Some(dry.area);
        }
    }
    let mut dry = beside("dry limit", Stroke::Dotted, dry_loops);
    // One dry loop for all has one area.
    if let ([only], Some(area)) = (&mut dry[..], dry_area) {
        only.label += &format!(": area {}", rounded(area));
    }
    curves.extend(dry);
    let axis = |label: &str, range| LineAxis { label: label.to_owned(), logarithmic: false, range };
    let chart = Lines {
        title: sweep.data.title.clone(),
        subtitle: cases.subtitle(sweep),
        x: axis("height of the surface w − h₀ (a₀²/R)", None),
        y: axis("pressure p (2N/(πa₀))", request.y),
        curves,
    };
    let name = format!("loop{}", suffix(sweep, request, &cases));
    Ok(vec![Picture { name, chart: Chart::Lines(chart), table }])
}

/// w − h₀ (T3).
fn height(x: f64, film: f64) -> f64 {
    0.5 * x * x - film
}

/// (2/π) ∫ p dw by trapezia.
fn area(heights: &[f64], pressure: &[f64]) -> f64 {
    let steps = heights.windows(2).zip(pressure.windows(2));
    2.0 / PI * steps.map(|(w, p)| 0.5 * (p[0] + p[1]) * (w[1] - w[0])).sum::<f64>()
}
