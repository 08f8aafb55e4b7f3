//! The picture that a page begins with, painted when the page is made: it is seen before the page's drawing library has
//! started, which then draws it anew in its place.

mod friction;
mod map;

use super::thinning::Grid;
use crate::pictures::{AxisWords, PictureError};
use stribeck_charts::{Chart, Paper};
use stribeck_sweep::store::{DataSet, Status};

/// Boxes of page.css with their letters: width and height in pixels, size of letters in points.
struct Size(f64, f64, f64);

/// The friction curve, and the map, beside which the surface stands; in a wide window.
const WIDE_CURVE: Size = Size(1320.0, 460.0, 10.0);
const WIDE_MAP: Size = Size(652.0, 460.0, 9.5);
/// Either on a phone.
const NARROW: Size = Size(366.0, 360.0, 8.0);

/// What a page begins with, as an element that is empty where there is nothing to draw.
pub(super) enum FirstPicture {
    /// The friction along an axis.
    Friction(String),
    /// A quantity over two axes.
    Map(String),
    /// Neither: there is one case.
    None,
}

impl FirstPicture {
    /// The picture of the places shown.
    ///
    /// # Errors
    /// [`PictureError`] if the data set cannot be read, or the chart not be painted.
    pub(super) fn of(data: &DataSet, grid: &Grid) -> Result<Self, PictureError> {
        let shown = Shown { data, grid, axes: AxisWords::of(data, &[]), statuses: data.statuses()? };
        let is_surface = shown.length(1) > 1 && shown.length(2) > 1;
        match shown.running_axis() {
            Some(along) if data.laboratory || !is_surface => {
                Ok(Self::Friction(element(shown.friction(along)?.as_ref(), WIDE_CURVE)?))
            }
            Some(_) => Ok(Self::Map(element(shown.map()?.as_ref(), WIDE_MAP)?)),
            None => Ok(Self::None),
        }
    }
}

/// The element of a chart in a wide window and in a narrow one, of which the page shows the one that fits.
fn element(chart: Option<&impl Chart>, wide: Size) -> Result<String, PictureError> {
    let Some(chart) = chart else { return Ok(String::new()) };
    let painted = |Size(width, height, points): Size| {
        let paper = Paper { width, height: Some(height), font_size: Some(points), heading: false, ..Paper::default() };
        chart.svg_in_page(&paper)
    };
    let (wide, narrow) = (painted(wide)?, painted(NARROW)?);
    Ok(format!(
        "<div class=\"first\" role=\"img\" aria-label=\"the picture as the page opens\">\n\
         <div class=\"in-wide\">{wide}</div>\n<div class=\"in-narrow\">{narrow}</div>\n</div>\n"
    ))
}

/// The places that a page shows.
struct Shown<'a> {
    data: &'a DataSet,
    grid: &'a Grid,
    axes: [AxisWords; 3],
    statuses: Vec<Status>,
}

impl Shown<'_> {
    /// How many values of an axis are shown.
    fn length(&self, axis: usize) -> usize {
        self.grid.0[axis].len()
    }

    /// The axis that the friction curve runs along: the speed, or another one that varies.
    fn running_axis(&self) -> Option<usize> {
        let long = || [2, 1, 0].into_iter().filter(|axis| self.length(*axis) > 1);
        long().find(|axis| self.axes[*axis].name != AxisWords::COMBINATION).or_else(|| long().next())
    }

    /// The case that the page begins with: at the largest f and in the middle of the other axes, or the nearest one that
    /// converged. Indices among the values shown.
    fn first_place(&self) -> Option<[usize; 3]> {
        let wanted = [self.length(0) - 1, self.length(1) / 2, self.length(2) / 2];
        // Another f is farther than any step along the others.
        let far = self.length(1) + self.length(2);
        let steps = |[i, j, k]: [usize; 3]| i.abs_diff(wanted[0]) * far + j.abs_diff(wanted[1]) + k.abs_diff(wanted[2]);
        let all = (0..self.length(0))
            .flat_map(|i| (0..self.length(1)).flat_map(move |j| (0..self.length(2)).map(move |k| [i, j, k])));
        all.filter(|indices| self.statuses[self.place(*indices)] == Status::Converged).min_by_key(|it| steps(*it))
    }

    /// The place in the data set.
    fn place(&self, indices: [usize; 3]) -> usize {
        self.data.place([0, 1, 2].map(|axis| self.grid.0[axis][indices[axis]]))
    }

    /// The places along an axis.
    fn along(&self, axis: usize, mut at: [usize; 3]) -> Vec<usize> {
        let place = |i| {
            at[axis] = i;
            self.place(at)
        };
        (0..self.length(axis)).map(place).collect()
    }

    /// The values shown of an axis.
    fn values(&self, axis: usize) -> Vec<f64> {
        self.grid.0[axis].iter().map(|i| self.axes[axis].values[*i]).collect()
    }

    /// A number of the column at each of these places; NaN where the case failed.
    fn solved(&self, values: &[f64], places: &[usize]) -> Vec<f64> {
        let value = |place: &usize| if self.statuses[*place] == Status::Failed { f64::NAN } else { values[*place] };
        places.iter().map(value).collect()
    }
}
