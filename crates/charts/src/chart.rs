//! What all charts can do: be painted.

use crate::paint::scene::Scene;
use crate::paint::{pdf, png, svg};
use crate::paper::{PER_MILLIMETRE, WIDTH};
use crate::{ChartError, Paper};

/// The heights of plots may be this much lower and higher than by default.
const STRETCHES: (f64, f64) = (0.2, 4.0);
/// Most rounds in which the stretch is found that makes a picture as high as its paper.
const MOST_ROUNDS: usize = 16;

/// A chart that can be painted in each format. The same chart on the same paper has the same bytes.
pub trait Chart: Drawing {
    /// The chart as SVG.
    ///
    /// # Errors
    ///
    /// [`ChartError`] if the chart has nothing to show, if lengths do not fit, if a value has no place on its axis, or
    /// if the letters or the height of the paper do not fit its width.
    fn svg(&self, paper: &Paper) -> Result<String, ChartError> {
        paper.check(self.side_by_side())?;
        Ok(svg::svg(&fitted(self, paper)?, paper))
    }

    /// The chart as an SVG element inside a page, which gives it its size. Its colours are `var(--ink-text)`, `quiet-text`,
    /// `frame`, `grid`, `paper` and `line-0` to `line-6`, those of the other formats where the page has no such variables.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    fn svg_in_page(&self, paper: &Paper) -> Result<String, ChartError> {
        paper.check(self.side_by_side())?;
        Ok(svg::svg_in_page(&fitted(self, paper)?))
    }

    /// The chart as PNG.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    fn png(&self, paper: &Paper) -> Result<Vec<u8>, ChartError> {
        paper.check(self.side_by_side())?;
        png::png(&fitted(self, paper)?, paper)
    }

    /// The chart as a page of PDF, with its letters as text.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    fn pdf(&self, paper: &Paper) -> Result<Vec<u8>, ChartError> {
        paper.check(self.side_by_side())?;
        Ok(pdf::pdf(&fitted(self, paper)?, paper))
    }
}

impl<T: Drawing> Chart for T {}

/// The private half of a chart: it is checked and laid out.
pub trait Drawing {
    /// The shapes of the chart, with plots `stretch` times as high as they are by default; the height of the paper is
    /// not looked at.
    ///
    /// # Errors
    ///
    /// As [`Chart::svg`].
    fn scene(&self, paper: &Paper, stretch: f64) -> Result<Scene, ChartError>;

    /// How many panels stand side by side.
    fn side_by_side(&self) -> usize {
        1
    }
}

/// The shapes of the chart in a picture as high as the paper, if this has a height.
///
/// The height grows with the stretch almost in proportion; where labels break otherwise it may jump. What little is
/// missing then stays free at the lower edge.
pub(crate) fn fitted(chart: &(impl Drawing + ?Sized), paper: &Paper) -> Result<Scene, ChartError> {
    let Some(height) = paper.height else { return chart.scene(paper, 1.0) };
    let wanted = (WIDTH * height / paper.width).round();
    let Around { mut low, mut fitting, mut high, mut above } = around(chart, paper, wanted)?;
    for _ in 0..MOST_ROUNDS {
        if wanted - fitting.height <= 1.0 {
            break;
        }
        let share = ((wanted - fitting.height) / (above - fitting.height)).clamp(0.02, 0.98);
        let stretch = low + share * (high - low);
        let scene = chart.scene(paper, stretch)?;
        if scene.height <= wanted {
            (low, fitting) = (stretch, scene);
        } else {
            (high, above) = (stretch, scene.height);
        }
    }
    Ok(Scene { height: wanted, ..fitting })
}

/// Two stretches with a height between theirs.
struct Around {
    /// One whose picture is no higher than wanted, and the picture.
    low: f64,
    fitting: Scene,
    /// One whose picture is higher, and how high that is.
    high: f64,
    above: f64,
}

/// The stretches around this height that are nearest to none.
fn around(chart: &(impl Drawing + ?Sized), paper: &Paper, wanted: f64) -> Result<Around, ChartError> {
    const STEP: f64 = 0.75;
    let beyond = |give, bound: f64| {
        let shown = |height: f64| height * paper.width / WIDTH;
        let in_both = |pixels: f64| (pixels / PER_MILLIMETRE, pixels);
        ChartError::Height { found: in_both(shown(wanted)), give, bound: in_both(shown(bound)) }
    };
    let (least, most) = STRETCHES;
    let (mut stretch, mut scene) = (1.0, chart.scene(paper, 1.0)?);
    while scene.height > wanted {
        let (high, above) = (stretch, scene.height);
        stretch = f64::max(STEP * stretch, least);
        if stretch == high {
            return Err(beyond("at least", above));
        }
        scene = chart.scene(paper, stretch)?;
        if scene.height <= wanted {
            return Ok(Around { low: stretch, fitting: scene, high, above });
        }
    }
    loop {
        let (low, fitting) = (stretch, scene);
        stretch = f64::min(stretch / STEP, most);
        if stretch == low && fitting.height < wanted {
            return Err(beyond("at most", fitting.height));
        }
        scene = chart.scene(paper, stretch)?;
        if scene.height > wanted || stretch == low {
            return Ok(Around { low, fitting, high: stretch, above: scene.height });
        }
    }
}
