//! Why a chart cannot be drawn.

/// Input that no chart can show, or an error of the drawing library.
#[derive(Debug, thiserror::Error)]
pub enum ChartError {
    /// A work-precision chart without a single case, or a map without a single cell.
    #[error("nothing to draw in the chart \"{chart}\": it holds no {what}; give it at least one")]
    Empty {
        /// Title of the chart.
        chart: String,
        /// What is missing.
        what: &'static str,
    },
    /// A number that has no place on its axis.
    #[error("the chart \"{chart}\" cannot show {what} = {value} of {place}: {wanted}")]
    Value {
        /// Title of the chart.
        chart: String,
        /// Quantity.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Line and setting, or panel and cell.
        place: String,
        /// What would be accepted.
        wanted: &'static str,
    },
    /// A list whose length does not fit the others of its chart.
    #[error("the chart \"{chart}\" has {found} {what}, but its axes ask for {wanted}")]
    Count {
        /// Title of the chart.
        chart: String,
        /// What is counted.
        what: String,
        /// Number given.
        found: usize,
        /// Number wanted.
        wanted: usize,
    },
    /// Letters too small to be read, or too large for the paper.
    #[error(
        "letters of {found} points do not fit the width of the picture; give a size from {least} to {most}, or another \
         width"
    )]
    Letters {
        /// Points asked for.
        found: f64,
        /// The least that can be read.
        least: f64,
        /// The most that leaves room.
        most: f64,
    },
    /// A height that leaves no room for plots, or is beyond them.
    #[error(
        "a picture this wide cannot be {:.0} mm ({:.0} pixels) high; give {give} {:.0} mm ({:.0} pixels), or another width",
        found.0, found.1, bound.0, bound.1
    )]
    Height {
        /// Millimetres and pixels asked for.
        found: (f64, f64),
        /// "at least" or "at most".
        give: &'static str,
        /// The least that leaves room, or the most that plots are stretched to.
        bound: (f64, f64),
    },
    /// The drawing library refused.
    #[error("the chart could not be painted: {0}")]
    Painting(String),
    /// The PNG could not be encoded.
    #[error("the picture could not be encoded as PNG: {0}")]
    Encoding(#[from] png::EncodingError),
}
