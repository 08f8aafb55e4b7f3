//! A box in space and the picture of it, by parallel projection.

use crate::paint::scene::Point;

/// A place in the box: shares of its length to the right, to the back and upwards.
pub(crate) type Place = (f64, f64, f64);

/// Lengths of the box to the right, to the back and upwards.
const BOX: Place = (1.15, 0.9, 0.5);
/// How far the viewer stands to the right of the front, and above the floor, in degrees. Of a ridge along the middle of
/// the floor, a side that looks away is seen up to a slope of tan(elevation)/sin(azimuth), here about 2.
const AZIMUTH: f64 = 18.0;
const ELEVATION: f64 = 34.0;

/// Where the box lies in the picture. The corner next to the viewer is that at the right and the front; the picture of
/// the box reaches from the corner at the left and the front to that at the right and the back.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Space {
    /// Of the corner at the left, the front and the bottom.
    origin: Point,
    /// Pixels for a length of 1.
    scale: f64,
    /// Pixels upwards over those to the side.
    stretch: f64,
}

/// To the right and upwards in the picture, from the origin, for a length of 1.
fn projected((x, y, z): Place) -> Point {
    let (azimuth, elevation) = (AZIMUTH.to_radians(), ELEVATION.to_radians());
    let (x, y, z) = (BOX.0 * x, BOX.1 * y, BOX.2 * z);
    let back = y * azimuth.cos() - x * azimuth.sin();
    (x * azimuth.cos() + y * azimuth.sin(), back * elevation.sin() + z * elevation.cos())
}

impl Space {
    /// The box in this width, `stretch` times as high as it is seen, with its upper left corner there.
    pub(crate) fn new((left, top): Point, width: f64, stretch: f64) -> Self {
        let scale = width / projected((1.0, 1.0, 0.0)).0;
        let above = projected((0.0, 1.0, 1.0)).1;
        Space { origin: (left, top + stretch * scale * above), scale, stretch }
    }

    /// Height of the picture of a box of this width, so stretched.
    pub(crate) fn height(width: f64, stretch: f64) -> f64 {
        let (highest, lowest) = (projected((0.0, 1.0, 1.0)).1, projected((1.0, 0.0, 0.0)).1);
        stretch * width / projected((1.0, 1.0, 0.0)).0 * (highest - lowest)
    }

    /// Where a place lies in the picture.
    pub(crate) fn at(&self, place: Place) -> Point {
        let (right, up) = projected(place);
        (self.origin.0 + self.scale * right, self.origin.1 - self.stretch * self.scale * up)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_box_fills_its_part_of_the_picture() {
        let space = Space::new((100.0, 50.0), 700.0, 1.5);
        let ends = |of: fn(Point) -> f64| {
            let corners = (0..8).map(|i| of(space.at((f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)))));
            corners.fold((f64::INFINITY, f64::NEG_INFINITY), |ends, end| (ends.0.min(end), ends.1.max(end)))
        };
        let ((left, right), (top, bottom)) = (ends(|point| point.0), ends(|point| point.1));
        assert!((left - 100.0).abs() + (right - 800.0).abs() + (top - 50.0).abs() < 1e-9);
        assert!((bottom - 50.0 - Space::height(700.0, 1.5)).abs() < 1e-9);
    }
}
