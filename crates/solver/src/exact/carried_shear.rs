//! The shear of the film that a dry contact carries (Eq. 20), for the large-β approximation.

use super::dry_gradient::{DryGradient, Panel, Place};
use super::large_beta::{STEEPEST, film_ratio};
use super::position::Position;
use super::root::bracketed_root;
use crate::model::gauss::integrate;

/// Dips of p′ to within these parts of what a film can carry make the film nearly end there, or end for a short way
/// only.
const CRITICAL: (f64, f64) = (0.8, 1.25);
/// Panels next to such a place, each a quarter as long as the one after it.
const GRADED_PANELS: i32 = 8;

/// ∫ (c/u − ⅔)(c/u) s²/4 dη over the parts of the contact that carry a film, s = sin θ and η = ln tan(θ/2): with p′
/// from (T2), F_h over 4ā/(πβc).
///
/// `number` is βc², which times p′ is the one number in the cubic for u/c. A film ends where that is −4/27, with a
/// square root. Panels of the table that are clear of such ends are summed over their own points; next to an end the
/// coordinate takes care of the root. Where p′ has a dip that a film can just carry, or just not, the root is nearly
/// double, and the quadrature is graded towards it.
pub(super) fn carried_shear(table: &DryGradient, number: f64) -> f64 {
    let critical = |gradient: f64| (CRITICAL.0..CRITICAL.1).contains(&(-number * gradient / STEEPEST));
    let graded = table.places.iter().any(|place| place.dip && critical(place.gradient));
    let integral = Integral { table, number, graded };
    let carries = |place: &Place| number * place.gradient > -STEEPEST;
    let first = table.places[0];
    let mut start = carries(&first).then_some(End { eta: first.eta, smooth: true });
    let mut sum = 0.0;
    for pair in table.places.windows(2) {
        let (before, here) = (&pair[0], &pair[1]);
        match start {
            None if carries(here) => start = Some(integral.root(before.eta, here.eta)),
            Some(begin) if !carries(here) => {
                sum += integral.part(begin, integral.root(before.eta, here.eta));
                start = None;
            }
            Some(begin) if here.dip && critical(here.gradient) => {
                let dip = End { eta: here.eta, smooth: false };
                sum += integral.part(begin, dip);
                start = Some(dip);
            }
            _ => {}
        }
    }
    let last = table.places[table.places.len() - 1].eta;
    start.map_or(sum, |begin| sum + integral.part(begin, End { eta: last, smooth: true }))
}

/// Where a part of the contact with a film ends.
#[derive(Clone, Copy)]
struct End {
    eta: f64,
    /// True at the edges of the contact; not where the pressure is as steep as a film can carry, or nearly so.
    smooth: bool,
}

/// The integral at work.
struct Integral<'a> {
    table: &'a DryGradient,
    number: f64,
    graded: bool,
}

impl Integral<'_> {
    /// The place between two others of one panel where the pressure is as steep as a film can carry.
    fn root(&self, a: f64, b: f64) -> End {
        let panel = self.table.panel(b);
        let carried = |eta: f64| self.number * self.table.at(panel, eta, Position::at(eta)) + STEEPEST;
        let eta = if carried(a) < carried(b) { bracketed_root(carried, a, b) } else { bracketed_root(carried, b, a) };
        End { eta, smooth: false }
    }

    /// The integral over one part: panels that are at least the length of one away from an end that is not smooth, and
    /// what is left beside them.
    fn part(&self, start: End, end: End) -> f64 {
        let first = self.table.panel(start.eta) + if start.smooth { 0 } else { 2 };
        let last = if end.smooth { self.table.panels.len() } else { self.table.panel(end.eta).saturating_sub(1) };
        if first >= last {
            let middle = 0.5 * (start.eta + end.eta);
            return self.beside(start.eta, middle) + self.beside(end.eta, middle);
        }
        let panels = &self.table.panels[first..last];
        let on = |panel: &Panel| -> f64 {
            let terms = panel.gradient.iter().zip(&panel.weights);
            terms.map(|(gradient, weight)| weight * shear(self.number * gradient)).sum()
        };
        let mut sum: f64 = panels.iter().map(on).sum();
        if !start.smooth {
            sum += self.beside(start.eta, panels[0].start);
        }
        if !end.smooth {
            sum += self.beside(end.eta, panels[panels.len() - 1].end);
        }
        sum
    }

    /// The integral between an end and another place, in the coordinate t with η = end + (other − end) t².
    fn beside(&self, end: f64, other: f64) -> f64 {
        let length = other - end;
        let integrand = |t: f64| {
            let eta = end + length * t * t;
            let here = Position::at(eta);
            let gradient = self.table.at(self.table.panel(eta), eta, here);
            here.to_leading * here.to_trailing * shear(self.number * gradient) * 2.0 * t * length.abs()
        };
        if self.graded {
            let panels = (0..GRADED_PANELS).map(|i| {
                let far = 0.25_f64.powi(i);
                integrate(if i + 1 == GRADED_PANELS { 0.0 } else { 0.25 * far }, far, integrand)
            });
            panels.sum()
        } else {
            integrate(0.0, 0.5, integrand) + integrate(0.5, 1.0, integrand)
        }
    }
}

/// (c/u − ⅔)(c/u) where β c² p′ has the given value.
fn shear(steepness: f64) -> f64 {
    let film = film_ratio(steepness);
    (1.0 / film - 2.0 / 3.0) / film
}
