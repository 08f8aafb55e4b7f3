//! Measured points and fitted friction along the speed, as charts.

use super::fitted_friction::FittedFriction;
use super::short_value::short;
use crate::pictures::{Quantity, held, symbol_and_words};
use stribeck_charts::{Colour, Curve, LineAxis, Lines, Stroke};
use stribeck_lab::{Experiment, FittedCurve, LaboratoryQuantity, Measured};
use stribeck_sweep::Column;

/// More curves than this would be a tangle: their points are drawn alone.
const MOST_CURVES: usize = 7;

/// A fit with its curves.
pub struct FittedCurves<'a> {
    pub fitted: &'a FittedFriction<'a>,
    pub curves: &'a [FittedCurve],
}

impl FittedCurves<'_> {
    /// Measured friction over speed, and the fitted curves through it: each with the colour and the mark of its points.
    pub fn friction_chart(&self) -> Lines {
        let points = &self.fitted.fit.points;
        let (mut lines, mut measured) = (Vec::new(), Vec::new());
        for (i, fitted) in self.curves.iter().enumerate() {
            let look = self.look(i);
            if self.has_lines() {
                lines.push(curve(Look { mark: None, ..look }, fitted.line.clone(), Stroke::Solid));
            }
            let own = || fitted.points.iter().map(|point| &points[*point]);
            for (point, error) in own().filter_map(|point| Some((point, point.error?))) {
                let x = point.experiment.motion.along().1;
                let ends = vec![(x, point.measured - error), (x, point.measured + error)];
                measured.push(curve(Look { mark: None, ..look }, ends, Stroke::Solid));
            }
            let places = own().map(|point| (point.experiment.motion.along().1, point.measured)).collect();
            measured.push(curve(look, places, Stroke::Points));
        }
        let mut curves = [lines, measured, self.legend()].concat();
        if !self.has_lines() {
            let fitted = points.iter().map(|point| (point.experiment.motion.along().1, point.fitted)).collect();
            let hollow = Look { colour: Colour::Kind(0), mark: Some(5) };
            curves.push(Curve { label: "fitted".to_owned(), ..curve(hollow, fitted, Stroke::Points) });
        }
        let estimates = self.fitted.fit.estimates.iter().map(|it| {
            let (symbol, _) = symbol_and_words(it.unknown.name());
            format!("{symbol} = {}", short(it.value, it.error, it.unknown.units()))
        });
        let column = Column::named(self.fitted.measured.column).unwrap_or(Column::MuDrag);
        let (title, y) = ("Friction, measured and fitted", Quantity::from(column).title());
        let found = estimates.collect::<Vec<_>>().join(", ");
        let best = if self.fitted.fit.is_minimum { "" } else { "no minimum, the best so far: " };
        self.chart(title, format!("{best}{found}"), y, curves)
    }

    /// Residuals over speed.
    pub fn residual_chart(&self) -> Lines {
        let (residuals, (from, to)) = self.fitted.residuals();
        let black = Look { colour: Colour::Black, mark: None };
        let mut curves = vec![curve(black, vec![(from, 0.0), (to, 0.0)], Stroke::Dashed)];
        for (i, fitted) in self.curves.iter().enumerate() {
            let own = fitted.points.iter().map(|point| residuals[*point]).collect();
            curves.push(curve(self.look(i), own, Stroke::Points));
        }
        curves.extend(self.names(Stroke::Points));
        self.chart("Residuals of the fit", String::new(), self.fitted.residual_label().to_owned(), curves)
    }

    fn has_lines(&self) -> bool {
        self.curves.len() <= MOST_CURVES && self.curves.iter().any(|curve| !curve.line.is_empty())
    }

    fn look(&self, i: usize) -> Look {
        match self.curves.len() {
            1 => Look { colour: Colour::Kind(0), mark: Some(0) },
            count if count <= MOST_CURVES => {
                Look { colour: Colour::Family(i as f64 / (count - 1) as f64), mark: Some(i) }
            }
            _ => Look { colour: Colour::Black, mark: Some(0) },
        }
    }

    /// Lines of the legend: what marks and lines are, and what tells the curves apart.
    fn legend(&self) -> Vec<Curve> {
        let entry = |label: &str, look, stroke| Curve { label: label.to_owned(), ..curve(look, vec![], stroke) };
        let black = Look { colour: Colour::Black, mark: Some(0) };
        match self.curves.len() {
            _ if !self.has_lines() => vec![entry("measured", self.look(0), Stroke::Points)],
            1 => vec![
                entry("fitted", Look { mark: None, ..self.look(0) }, Stroke::Solid),
                entry("measured", self.look(0), Stroke::Points),
            ],
            _ => {
                let meaning = entry("marks: measured; lines: fitted", black, Stroke::Points);
                self.names(Stroke::Solid).chain([meaning]).collect()
            }
        }
    }

    /// A line of the legend for each of several curves.
    fn names(&self, stroke: Stroke) -> impl Iterator<Item = Curve> {
        let are_told_apart = (2..=MOST_CURVES).contains(&self.curves.len());
        let labels = if are_told_apart { self.labels() } else { Vec::new() };
        labels.into_iter().enumerate().map(move |(i, label)| Curve { label, ..curve(self.look(i), vec![], stroke) })
    }

    /// What tells each curve from the others: "SRR = 0.2, T = 20 °C".
    fn labels(&self) -> Vec<String> {
        let first = |curve: &FittedCurve| self.fitted.fit.points[curve.points[0]].experiment;
        let experiments: Vec<Experiment> = self.curves.iter().map(first).collect();
        let along = experiments[0].motion.along().0;
        let given: Vec<LaboratoryQuantity> = experiments[0].given().filter(|quantity| *quantity != along).collect();
        let varies = |of: &dyn Fn(&Experiment) -> f64| {
            experiments.iter().any(|experiment| !Measured::is_same(of(experiment), of(&experiments[0])))
        };
        let words = |experiment: &Experiment| {
            let own = given.iter().filter(|quantity| varies(&|it| it.value(**quantity)));
            let own = own.map(|quantity| held(quantity.name(), quantity.units(), experiment.value(*quantity)));
            let strength = varies(&|it| it.f).then(|| held("f", "1", experiment.f));
            own.chain(strength).collect::<Vec<_>>().join(", ")
        };
        experiments.iter().map(words).collect()
    }

    fn chart(&self, title: &str, subtitle: String, y: String, curves: Vec<Curve>) -> Lines {
        let axis = |label, logarithmic| LineAxis { label, logarithmic, range: None };
        let x = format!("{}  (m/s)", symbol_and_words(self.fitted.along()).1);
        Lines { title: title.to_owned(), subtitle, x: axis(x, true), y: axis(y, false), curves }
    }
}

/// By what the points of a curve are known.
#[derive(Clone, Copy)]
struct Look {
    colour: Colour,
    mark: Option<usize>,
}

fn curve(look: Look, points: Vec<(f64, f64)>, stroke: Stroke) -> Curve {
    Curve { label: String::new(), points, failed: vec![], stroke, colour: look.colour, mark: look.mark }
}
