//! Panels on y = x − x_out.

use std::sync::Arc;

/// Panels ahead of the outlet, which carry pressure, and behind it, which carry only displacement.
///
/// y = 0 is the outlet, so that the panels do not move with it.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Degree d of the pressure on a panel.
    pub degree: usize,
    /// Ends of the panels of the film, ascending from 0 to Y.
    pub film: Vec<f64>,
    /// Ends of the panels behind the outlet, ascending from −Y to 0.
    pub behind: Vec<f64>,
    /// Ratio of neighbouring panels behind the outlet.
    pub growth: f64,
}

/// So many times as long as its place asks for the last panel behind the outlet may be, so that none is a scrap.
const LAST: f64 = 1.3;

impl Mesh {
    /// A mesh with these ends of panels ahead of the outlet. Behind it panels grow from the size of the first one in
    /// geometric progression, by the factor `growth`, until they reach as far.
    pub fn new(degree: usize, growth: f64, film: Vec<f64>) -> Arc<Self> {
        let (first, reach) = (film[1] - film[0], film[film.len() - 1]);
        let mut behind = vec![0.0];
        let (mut size, mut at) = (first, 0.0);
        while at < reach {
            at = if at + LAST * size > reach { reach } else { at + size };
            behind.push(-at);
            size *= growth;
        }
        behind.reverse();
        Arc::new(Self { degree, film, behind, growth })
    }

    /// Number of panels with pressure.
    pub fn panels(&self) -> usize {
        self.film.len() - 1
    }

    /// Y, how far the mesh reaches ahead of the outlet.
    pub fn reach(&self) -> f64 {
        self.film[self.film.len() - 1]
    }

    /// The panel ahead of the outlet that holds y, and the place of y on it in [−1, 1]; y from 0 to Y.
    pub fn locate(&self, y: f64) -> (usize, f64) {
        locate(&self.film, y)
    }
}

/// The growth of panels behind the outlet that leaves an error of this part in integrals over them.
///
/// The gap there is smooth but for the outlet, a distance a behind which a panel of length (g − 1)a begins. Gauss' rule
/// with d points leaves ρ^{−2d} of such an integral, with the ellipse ρ = (√g + 1)/(√g − 1) that just reaches the
/// outlet.
pub fn growth_behind(degree: usize, error: f64) -> f64 {
    let rho = error.powf(-0.5 / degree as f64);
    ((rho + 1.0) / (rho - 1.0)).powi(2).clamp(1.1, 8.0)
}

/// The panel between two of `ends` that holds y, and its place there in [−1, 1].
pub fn locate(ends: &[f64], y: f64) -> (usize, f64) {
    let panel = ends.partition_point(|&end| end <= y).clamp(1, ends.len() - 1) - 1;
    let (left, right) = (ends[panel], ends[panel + 1]);
    (panel, (2.0 * y - left - right) / (right - left))
}
