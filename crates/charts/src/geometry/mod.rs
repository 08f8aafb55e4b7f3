//! Lines and areas in the plane: cut at a rectangle, drawn in dashes, found on a grid.

pub(crate) mod bands;
pub(crate) mod contours;
pub(crate) mod polygon;
pub(crate) mod polyline;
