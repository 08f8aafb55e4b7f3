//! Straight lines between cases, in (ln α, ln β, ln(1+f)).

use crate::model::{Parameters, Substrate};

/// Why there is no straight line between two cases.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoLine {
    /// Retardation modes are no coordinate.
    #[error("no line leads from one substrate to another; continue between cases with the same retardation modes")]
    Substrates {
        /// Where the line would start.
        from: Substrate,
        /// Where it would end.
        to: Substrate,
    },
    /// α = 0 and α = ∞ are at no finite distance from any other α.
    #[error("no line leads from alpha = {from} to alpha = {to}; start at the same alpha")]
    Alpha {
        /// α where the line would start.
        from: f64,
        /// α where it would end.
        to: f64,
    },
}

/// A straight line in (ln α, ln β, ln(1+f)) between two cases with the same substrate.
#[derive(Clone, Debug, PartialEq)]
pub struct Line<'a> {
    from: &'a Parameters,
    to: &'a Parameters,
}

impl<'a> Line<'a> {
    /// The line between two cases.
    ///
    /// # Errors
    /// [`NoLine`] if the substrates differ, or α is 0 or ∞ at one end only.
    pub fn new(from: &'a Parameters, to: &'a Parameters) -> Result<Self, NoLine> {
        if from.substrate != to.substrate {
            return Err(NoLine::Substrates { from: from.substrate.clone(), to: to.substrate.clone() });
        }
        if !distance(from, to).is_finite() {
            return Err(NoLine::Alpha { from: from.alpha, to: to.alpha });
        }
        Ok(Self { from, to })
    }

    /// The case at `t`: the ends, bit for bit, at 0 and 1 (and beyond), and what they have in common in between.
    pub fn at(&self, t: f64) -> Parameters {
        if t <= 0.0 {
            return self.from.clone();
        }
        if t >= 1.0 {
            return self.to.clone();
        }
        let mean = |from: f64, to: f64| if from == to { from } else { from.powf(1.0 - t) * to.powf(t) };
        let f = if self.from.f == self.to.f {
            self.from.f
        } else {
            ((1.0 - t) * self.from.f.ln_1p() + t * self.to.f.ln_1p()).exp_m1()
        };
        Parameters {
            alpha: mean(self.from.alpha, self.to.alpha),
            beta: mean(self.from.beta, self.to.beta),
            f,
            substrate: self.from.substrate.clone(),
        }
    }

    /// The length of the line, as [`distance`] has it.
    pub fn length(&self) -> f64 {
        distance(self.from, self.to)
    }
}

/// The largest of |Δ ln α|, |Δ ln β| and |Δ ln(1+f)|; infinite between α = 0 or ∞ and any other α.
pub fn distance(a: &Parameters, b: &Parameters) -> f64 {
    displacement(a, b).into_iter().fold(0.0, |largest, part| f64::max(largest, part.abs()))
}

/// The factor t of the secant predictor `near + t (near − far)`: `target` projected on the line through `far` and
/// `near`.
///
/// 0, the state at `near` as it is, where `far` and `near` do not make a line.
pub fn secant(far: &Parameters, near: &Parameters, target: &Parameters) -> f64 {
    let (done, ahead) = (displacement(far, near), displacement(near, target));
    let dot = |a: [f64; 3], b: [f64; 3]| a.into_iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let t = dot(done, ahead) / dot(done, done);
    if t.is_finite() { t } else { 0.0 }
}

/// b − a in (ln α, ln β, ln(1+f)); 0 where they are equal, be it at α = 0 or ∞.
fn displacement(a: &Parameters, b: &Parameters) -> [f64; 3] {
    let logarithm = |a: f64, b: f64| if a == b { 0.0 } else { b.ln() - a.ln() };
    let strength = if a.f == b.f { 0.0 } else { b.f.ln_1p() - a.f.ln_1p() };
    [logarithm(a.alpha, b.alpha), logarithm(a.beta, b.beta), strength]
}
