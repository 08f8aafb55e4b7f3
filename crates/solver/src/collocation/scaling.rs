//! How films and widths change with β, roughly: what a guess needs to know.

use std::f64::consts::PI;

use super::state::State;
use crate::model::{Parameters, Retardation};

/// Lengths of a case, known beforehand to a factor of order 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaling {
    /// Half the width of the region with pressure: that of the dry contact and that of a rigid film, as a root of the
    /// sum of squares.
    pub width: f64,
    /// c, by a mean of its limits.
    pub film: f64,
    beta: f64,
}

impl Scaling {
    /// The scaling at β, with a dry contact of half width ā: a case like the elastic one of compliance ā².
    ///
    /// The limits of c are 0.4458 β^{−3/5} for thin films and 1/(πβ) for thick ones; a thick film doubles over √(2h₀)
    /// with h₀ = 0.2597/β (section "Limits" of `docs/explanation/theory.md`).
    pub fn new(half_width: f64, beta: f64) -> Self {
        let compliance = half_width * half_width;
        let (thin, thick) = (0.4458 * (compliance * beta).powf(-0.6), (PI * compliance * beta).recip());
        Self { width: (compliance + 0.5194 / beta).sqrt(), film: compliance * thin * thick / (thin + thick), beta }
    }

    /// How far a mesh must reach ahead of the outlet for what lies beyond to be an [`Inlet`](super::inlet::Inlet): what
    /// that leaves out is the displacement of the load ahead, which falls as 1/(βX³).
    pub fn reach(&self, tolerance: f64) -> f64 {
        f64::max(20.0 * self.width, 8.0 * (self.beta * tolerance).powf(-1.0 / 3.0))
    }
}

/// The length over which a film of thickness c leaves and enters the contact.
///
/// There p changes by as much as lifts the film by c, κpℓ ~ c, over the length that Reynolds' equation allows (T2),
/// βpc² ~ ℓ: so ℓ² = βc³/κ with the compliance κ of the time that ℓ takes.
pub fn layer(parameters: &Parameters, c: f64) -> f64 {
    let modes = parameters.retardation();
    // without modes it is the substrate of (T10): relaxed, or frozen at α = 0
    let instantaneous = if parameters.is_relaxed_elastic() { 1.0 } else { parameters.instantaneous_compliance() };
    let mut layer = 0.0;
    for _ in 0..3 {
        let relaxed = |mode: &Retardation| {
            let passed = mode.rate * layer * (1.0 + parameters.f);
            mode.strength * instantaneous * passed / (1.0 + passed)
        };
        let compliance = instantaneous + modes.iter().map(relaxed).sum::<f64>();
        layer = (parameters.beta * c.powi(3) / compliance).sqrt();
    }
    layer
}

/// Widths that differ by less than this part are taken as the same: the mesh, and what was computed for it, stays.
const SAME_WIDTH: f64 = 0.15;

impl State {
    /// A guess at another case from a solution: lengths as the widths, then films as the films where they are thin.
    /// Ahead of the contact the film is that of the geometry and stays.
    pub fn rescaled(&self, from: Scaling, to: Scaling) -> Self {
        let stretch = to.width / from.width;
        self.stretched(if stretch.ln().abs() < SAME_WIDTH { 1.0 } else { stretch }, from, to)
    }

    /// The same with panels that are always stretched as the widths.
    pub fn fitted(&self, from: Scaling, to: Scaling) -> Self {
        self.stretched(to.width / from.width, from, to)
    }

    fn stretched(&self, stretch: f64, from: Scaling, to: Scaling) -> Self {
        let mut state = if stretch == 1.0 { self.clone() } else { self.scaled(stretch) };
        let ln_thinning = (to.film / from.film / (stretch * stretch)).ln();
        let c = state.c;
        for u in &mut state.film {
            *u *= (ln_thinning * (-(*u / c - 1.0).max(0.0)).exp()).exp();
        }
        state.c *= ln_thinning.exp();
        state
    }
}
