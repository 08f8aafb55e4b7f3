//! Discrete spectra of a material: from that of creep to that of relaxation, and back.

use super::root::bracketed_root;

/// Lines whose places differ by less than this part of them are one.
const SAME_PLACE: f64 = 1e-10;

/// One line of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// f_j of a retardation mode, or E_i/E∞ of a relaxation term; positive.
    pub strength: f64,
    /// Rate of a retardation mode, or time of a relaxation term; positive, in any unit.
    pub place: f64,
}

/// Lines in ascending order of their places, no two at the same.
///
/// Creep compliance and relaxation modulus are each other's reciprocal, Ĉ Ê = 1, and each is a sum of simple fractions:
/// 1/E₀ and the f_j with poles at the retardation rates, E∞ and the E_i with poles at the relaxation rates. So the
/// rates of one are the zeros of the other (T40), and its strengths the residues there (T41). In strengths over the
/// weakest response (f_j over the compliance at once, E_i over the relaxed modulus) and with rates for creep but times
/// for relaxation, both ways are the same map.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    lines: Vec<Line>,
}

/// What [`Spectrum::conjugate`] gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Conjugate {
    /// The spectrum of the other response, with places in the same unit: relaxation rates of retardation rates,
    /// retardation times of relaxation times. It has as many lines, and its strengths have the same sum.
    pub spectrum: Spectrum,
    /// x_m/p_j − 1 for each line m of it and each line j of the spectrum it was made from: to full relative accuracy,
    /// also where it is next to nothing.
    pub distances: Vec<Vec<f64>>,
}

impl Spectrum {
    /// The spectrum of lines in any order; those at the same place (to ten digits) are added up.
    pub fn new(lines: impl IntoIterator<Item = Line>) -> Self {
        let mut all: Vec<Line> = lines.into_iter().collect();
        all.sort_by(|a, b| a.place.total_cmp(&b.place));
        let mut lines: Vec<Line> = Vec::with_capacity(all.len());
        for line in all {
            match lines.last_mut() {
                Some(last) if line.place - last.place <= SAME_PLACE * last.place => {
                    last.strength += line.strength;
                    // The strength-weighted mean, exactly the old place if both are equal.
                    last.place += (line.place - last.place) * (line.strength / last.strength);
                }
                _ => lines.push(line),
            }
        }
        Self { lines }
    }

    /// The lines, ascending.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// The sum of the strengths: f, for creep and relaxation alike.
    pub fn total(&self) -> f64 {
        self.lines.iter().map(|line| line.strength).sum()
    }

    /// The spectrum of the other response: places x_m (T40), one above each line and below the next, and strengths
    /// (T41).
    pub fn conjugate(&self) -> Conjugate {
        let ratio = 1.0 + self.total();
        let distances: Vec<Vec<f64>> = (0..self.lines.len()).map(|m| self.distances_of_root(m)).collect();
        let lines = self.lines.iter().enumerate().map(|(m, line)| {
            let distances = &distances[m];
            let slope: f64 =
                self.lines.iter().zip(distances).map(|(line, r)| (1.0 + r) * (line.strength / r) / r).sum();
            Line { strength: ratio / slope, place: line.place * (1.0 + distances[m]) }
        });
        Conjugate { spectrum: Self { lines: lines.collect() }, distances }
    }

    /// x/p_j − 1 for the root of (T40) above line `m`.
    ///
    /// What is solved for is the logarithm of the distance to the nearer of the two lines around, which is tiny for a
    /// weak line, and a Newton step turns its absolute into relative accuracy.
    fn distances_of_root(&self, m: usize) -> Vec<f64> {
        let weight: f64 = self.lines.iter().map(|line| line.strength * line.place).sum();
        let (line, next) = (self.lines[m], self.lines.get(m + 1));
        let half_gap = next.map(|next| 0.5 * (next.place - line.place));
        let (base, side, most) = match half_gap {
            None => (m, 1.0, weight / line.place),
            Some(half) if self.excess(&self.distances(m, half / line.place)) > 0.0 => (m, 1.0, half / line.place),
            Some(half) => (m + 1, -1.0, half / self.lines[m + 1].place),
        };
        // What the line itself has to balance is at most 1 and the lines beyond the gap, half of it away.
        let least = self.lines[base].strength / (1.0 + half_gap.map_or(0.0, |half| weight / half));
        let least = least.max(f64::MIN_POSITIVE);
        let residual = |ln_distance: f64| side * self.excess(&self.distances(base, side * ln_distance.exp()));
        let distance = side * bracketed_root(residual, least.ln(), most.ln()).exp();
        let distances = self.distances(base, distance);
        let slope: f64 =
            self.lines.iter().zip(&distances).map(|(line, r)| (line.strength / r) / (line.place * r)).sum();
        self.distances(base, distance - self.excess(&distances) / (slope * self.lines[base].place))
    }

    /// 1 − Σ_j s_j/(x/p_j − 1), which (T40) asks to be zero.
    fn excess(&self, distances: &[f64]) -> f64 {
        1.0 - self.lines.iter().zip(distances).map(|(line, r)| line.strength / r).sum::<f64>()
    }

    /// x/p_j − 1 for the x at the given relative distance from line `base`.
    fn distances(&self, base: usize, distance: f64) -> Vec<f64> {
        let origin = self.lines[base].place;
        let others = self.lines.iter().map(|line| ((origin - line.place) + origin * distance) / line.place);
        let mut distances: Vec<f64> = others.collect();
        distances[base] = distance;
        distances
    }
}
