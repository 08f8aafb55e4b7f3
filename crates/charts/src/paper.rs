//! How a chart stands on paper: its size, its letters, its heading.

use crate::ChartError;
use crate::paint::font;

/// Width of every layout, in its own pixels. Pictures are scaled from it.
pub(crate) const WIDTH: f64 = 1600.0;

/// Pixels of a screen for a point of 1/72 inch.
const PER_POINT: f64 = 96.0 / 72.0;
/// Pixels of a screen for a millimetre.
pub(crate) const PER_MILLIMETRE: f64 = 96.0 / 25.4;

/// The word by which a file of this library is known, near its beginning; the [note](Paper::note) stands behind it.
pub const MARK: &str = "stribeck-chart";

/// The size of a picture and of its letters. The default fits a page of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Paper {
    /// Width of an SVG and of a page of PDF, in pixels of 1/96 inch.
    pub width: f64,
    /// Their height, in the same pixels; if none it follows from the width.
    pub height: Option<f64>,
    /// Width of a PNG in pixels.
    pub pixels: u32,
    /// Size of letters in points at this width; if none 6 points or more when one panel is 8.5 cm wide, and several 17
    /// cm.
    pub font_size: Option<f64>,
    /// Whether title and subtitle are drawn.
    pub heading: bool,
    /// What the file remembers of its making: small letters, hyphens and blanks.
    pub note: String,
}

impl Default for Paper {
    fn default() -> Self {
        Self { width: 700.0, height: None, pixels: 1600, font_size: None, heading: true, note: String::new() }
    }
}

impl Paper {
    /// Letters may be this much smaller and larger than by default.
    const LETTERS: (f64, f64) = (0.4, 1.5);

    /// Size of the letters of a chart with this many panels side by side, in pixels of its layout.
    pub(crate) fn em(&self, side_by_side: usize) -> f64 {
        self.font_size.map_or_else(|| font::size(side_by_side), |points| WIDTH * PER_POINT * points / self.width)
    }

    /// What stands behind [`MARK`].
    pub(crate) fn mark(&self) -> String {
        format!("{MARK} {}", self.note).trim_end().to_owned()
    }

    /// Checks the size of letters.
    ///
    /// # Errors
    /// [`ChartError::Letters`] if the letters of a chart with this many panels side by side are too small to be read, or
    /// too large for labels.
    pub fn check(&self, side_by_side: usize) -> Result<(), ChartError> {
        let points = |share: f64| share * font::size(side_by_side) * self.width / (WIDTH * PER_POINT);
        let (least, most) = (points(Self::LETTERS.0), points(Self::LETTERS.1));
        match self.font_size {
            Some(found) if !(least..=most).contains(&found) => {
                let (least, most) = ((10.0 * least).ceil() / 10.0, (10.0 * most).floor() / 10.0);
                Err(ChartError::Letters { found, least, most })
            }
            _ => Ok(()),
        }
    }
}
