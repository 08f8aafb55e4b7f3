//! Two isotherms laid over one another.

use super::isotherms::Isotherm;
use super::measurement::Measurement;
use crate::temperature::least_of;
use std::f64::consts::LN_10;

/// The part of the shorter one of two isotherms, in decades, that lies over the other one at least.
const OVERLAP: f64 = 0.2;
/// Steps in a decade in which a shift is looked for.
const STEPS: f64 = 50.0;
/// What (ln b)² counts beside the mean square of differences, b being the factor between the moduli of neighbours. It
/// is chosen, not derived: without it flat isotherms are shifted away.
const PRICE: f64 = 0.01;

/// How the warmer one of two isotherms was laid over the colder one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Overlap {
    /// Decades of rate to the right.
    pub(super) step: f64,
    /// Decades of modulus upwards.
    pub(super) level: f64,
    /// Root of the mean square of |ΔE*|/|E*| over the overlap; `None` where there is none.
    pub(super) residual: Option<f64>,
}

impl Overlap {
    /// The best one: the mean of |ΔE*|²/|E*|² is least. If moduli are free, (ln b)² counts beside it, a little: where a
    /// shift of rates and one of moduli do the same, moduli stay.
    ///
    /// `None` if there is none of a fifth of the shorter isotherm.
    pub(super) fn best(cold: &Isotherm, warm: &Isotherm, is_free: bool) -> Option<Self> {
        let pair = Pair::new(cold, warm);
        let (fixed, moved) = (pair.fixed.ends(), pair.moved.ends());
        let shared = OVERLAP * (fixed.1 - fixed.0).min(moved.1 - moved.0);
        // from the left end of the cold one to its right end
        let (least, most) = (fixed.0 + shared - moved.1, fixed.1 - shared - moved.0);
        let steps = (STEPS * (most - least)).ceil().max(2.0);
        let at = |step: f64| least + (most - least) * step / steps;
        let square = |step: f64| {
            let level = if is_free { pair.level(at(step)).unwrap_or(f64::NAN) } else { 0.0 };
            let price = PRICE * (LN_10 * level).powi(2);
            pair.mean_square(at(step), level).map_or(f64::INFINITY, |square| square + price)
        };
        let tried = (0..=steps as u32).map(|step| (f64::from(step), square(f64::from(step))));
        let (best, _) = tried.min_by(|a, b| a.1.total_cmp(&b.1))?;
        if best == 0.0 || best == steps {
            return None;
        }
        Self::at(cold, warm, at(least_of(square, best - 1.0, best + 1.0)), is_free)
    }

    /// The one with a given step; `None` if moduli are free, and nothing lies over anything.
    pub(super) fn at(cold: &Isotherm, warm: &Isotherm, step: f64, is_free: bool) -> Option<Self> {
        let pair = Pair::new(cold, warm);
        let level = if is_free { pair.level(step)? } else { 0.0 };
        Some(Self { step, level, residual: pair.mean_square(step, level).map(f64::sqrt) })
    }
}

/// log₁₀ of the rates, and the moduli, of an isotherm.
struct Curve<'a> {
    rows: &'a [Measurement],
    rates: Vec<f64>,
}

impl<'a> Curve<'a> {
    fn new(isotherm: &'a Isotherm) -> Self {
        let rows = isotherm.measurements.rows();
        Self { rows, rates: rows.iter().map(|row| row.rate().log10()).collect() }
    }

    fn ends(&self) -> (f64, f64) {
        (self.rates[0], self.rates[self.rates.len() - 1])
    }

    /// The moduli at a rate within the ends: on straight lines between the points on logarithmic scales, where both
    /// are above zero.
    fn moduli(&self, rate: f64) -> [f64; 2] {
        let above = self.rates.partition_point(|other| *other < rate).clamp(1, self.rates.len() - 1);
        let (from, to) = (self.rates[above - 1], self.rates[above]);
        let part = if to > from { ((rate - from) / (to - from)).clamp(0.0, 1.0) } else { 0.5 };
        let [low, high] = [self.rows[above - 1].moduli(), self.rows[above].moduli()];
        std::array::from_fn(|i| {
            let straight = low[i] + part * (high[i] - low[i]);
            if low[i] > 0.0 && high[i] > 0.0 { low[i] * (high[i] / low[i]).powf(part) } else { straight }
        })
    }

    /// The moduli of this curve, and those of each row of another one that lies over it when that is shifted.
    fn beside(&self, other: &Self, shift: f64) -> impl Iterator<Item = Moduli> {
        let (from, to) = self.ends();
        let rows = other.rates.iter().map(move |rate| rate + shift).zip(other.rows);
        let over = rows.filter(move |(rate, _)| (from..=to).contains(rate));
        over.map(|(rate, row)| [self.moduli(rate), row.moduli()])
    }
}

/// E′ and E″ of one curve, and of the other.
type Moduli = [[f64; 2]; 2];

/// Two isotherms, of which the second one is moved.
struct Pair<'a> {
    fixed: Curve<'a>,
    moved: Curve<'a>,
}

impl<'a> Pair<'a> {
    fn new(cold: &'a Isotherm, warm: &'a Isotherm) -> Self {
        Self { fixed: Curve::new(cold), moved: Curve::new(warm) }
    }

    /// The moduli of the fixed curve and of the moved one where one lies over the other: each with the one whose rows
    /// they are last.
    fn both(&self, shift: f64) -> (Vec<Moduli>, Vec<Moduli>) {
        (self.fixed.beside(&self.moved, shift).collect(), self.moved.beside(&self.fixed, -shift).collect())
    }

    /// The decades of modulus by which the moved curve lies best on the fixed one: log₁₀ of |E*| has the least squares
    /// then.
    fn level(&self, shift: f64) -> Option<f64> {
        let size = |[storage, loss]: [f64; 2]| storage.hypot(loss).log10();
        let (of_moved, of_fixed) = self.both(shift);
        let above = of_moved.iter().map(|[fixed, moved]| size(*fixed) - size(*moved));
        let all: Vec<f64> = above.chain(of_fixed.iter().map(|[moved, fixed]| size(*fixed) - size(*moved))).collect();
        (all.len() > 1).then(|| all.iter().sum::<f64>() / all.len() as f64)
    }

    /// The mean of |ΔE*|²/|E*|² over the overlap; `None` where none lies over the other.
    fn mean_square(&self, shift: f64, level: f64) -> Option<f64> {
        let factor = 10_f64.powf(level);
        let square = |curve: [f64; 2], row: [f64; 2], factor: f64| {
            Measurement::distance(curve, row.map(|modulus| factor * modulus)).powi(2)
        };
        let (of_moved, of_fixed) = self.both(shift);
        let squares = of_moved.iter().map(|[fixed, moved]| square(*fixed, *moved, factor));
        let all: Vec<f64> =
            squares.chain(of_fixed.iter().map(|[moved, fixed]| square(*moved, *fixed, 1.0 / factor))).collect();
        (all.len() > 1).then(|| all.iter().sum::<f64>() / all.len() as f64)
    }
}
