//! A field below a deformed surface: what the chart is given.

mod layout;

use crate::ChartError;
use crate::chart::Drawing;
use crate::checks;
use crate::map::ColourScale;
use crate::paint::scene::Scene;
use crate::paper::Paper;

/// A field, a stress for instance, as bands of colour below a deformed surface under a cylinder, in panels.
///
/// A material point at depth d below x is drawn at the height surface(x) − d. Both axes are linear; what lies outside
/// their ranges is cut off.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSection {
    /// Heading.
    pub title: String,
    /// Second line of the heading; may be empty.
    pub subtitle: String,
    /// Name of the horizontal axis, with its unit.
    pub x_label: String,
    /// Name of the heights, with their unit.
    pub y_label: String,
    /// The panels, in two columns if there are several.
    pub panels: Vec<CrossSectionPanel>,
    /// Ends of the horizontal axis, low < high.
    pub x_range: (f64, f64),
    /// Ends of the heights, low < high.
    pub y_range: (f64, f64),
    /// From values to colours, the same in all panels.
    pub scale: ColourScale,
    /// About how many bands of colour there are, at least one. Their boundaries are round values.
    pub levels: usize,
}

/// One field.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSectionPanel {
    /// Heading of the panel: "α = 0.3"; may be empty.
    pub label: String,
    /// Places along the surface: at least two, increasing.
    pub x: Vec<f64>,
    /// Height of the deformed surface at each.
    pub surface: Vec<f64>,
    /// Height of the lower side of the cylinder at each.
    pub cylinder: Vec<f64>,
    /// Depths below the surface: at least two, increasing, from 0.
    pub depth: Vec<f64>,
    /// `depth.len() * x.len()` values, x running fastest; above zero if the scale is logarithmic.
    pub values: Vec<f64>,
}

impl Drawing for CrossSection {
    fn scene(&self, paper: &Paper, stretch: f64) -> Result<Scene, ChartError> {
        self.check()?;
        Ok(layout::draw(self, paper, stretch))
    }

    fn side_by_side(&self) -> usize {
        self.panels.len().min(layout::MOST_COLUMNS)
    }
}

impl CrossSection {
    fn check(&self) -> Result<(), ChartError> {
        let chart = &self.title;
        checks::range(chart, &self.x_label, Some(self.x_range), false)?;
        checks::range(chart, &self.y_label, Some(self.y_range), false)?;
        checks::range(chart, &self.scale.label, self.scale.range, self.scale.logarithmic)?;
        if self.panels.is_empty() {
            return Err(ChartError::Empty { chart: chart.clone(), what: "panel" });
        }
        if self.levels == 0 {
            return Err(ChartError::Empty { chart: chart.clone(), what: "band of colour" });
        }
        for (i, panel) in self.panels.iter().enumerate() {
            checks::axis(chart, &self.x_label, &panel.x, false)?;
            checks::axis(chart, "of depths", &panel.depth, false)?;
            if panel.depth[0] != 0.0 {
                return Err(self.refused(
                    panel.depth[0],
                    "the first depth",
                    panel,
                    "depths begin at the surface, with 0",
                ));
            }
            let columns = panel.x.len();
            for (what, list, wanted) in [
                ("heights of the surface", &panel.surface, columns),
                ("heights of the cylinder", &panel.cylinder, columns),
                ("values", &panel.values, columns * panel.depth.len()),
            ] {
                checks::count(chart, format!("{what} in panel {}", i + 1), list.len(), wanted)?;
                if let Some(value) = list.iter().find(|value| !value.is_finite()) {
                    return Err(self.refused(*value, "a number", panel, "heights and values are finite"));
                }
            }
            if let Some(value) = panel.values.iter().find(|value| self.scale.logarithmic && **value <= 0.0) {
                let wanted = "values are above zero if the scale is logarithmic";
                return Err(self.refused(*value, "a value", panel, wanted));
            }
        }
        Ok(())
    }

    fn refused(&self, value: f64, what: &'static str, panel: &CrossSectionPanel, wanted: &'static str) -> ChartError {
        let place = format!("the panel \"{}\"", panel.label);
        ChartError::Value { chart: self.title.clone(), what, value, place, wanted }
    }
}
