//! Paints a scene, which is a list of shapes, as SVG text, as the bytes of a PNG, or as a page of PDF.

pub(crate) mod font;
mod indexed;
pub(crate) mod marker;
pub(crate) mod palette;
pub(crate) mod pdf;
pub(crate) mod png;
pub(crate) mod scene;
pub(crate) mod svg;
