//! The slope of the surface from the kernel (T10), apart from any closed form.

use std::f64::consts::PI;

use stribeck_solver::exact::DryContact;
use stribeck_solver::kernel::retarded_log_integral;

/// Piecewise linear pressure on a row of ascending places, gathered at both ends.
pub struct Load {
    x: Vec<f64>,
    p: Vec<f64>,
}

impl Load {
    /// The pressure of a dry contact on `cells` cells.
    pub fn of(contact: &DryContact, cells: u32) -> Self {
        let angle = |i: u32| PI * f64::from(i) / f64::from(cells);
        let x: Vec<f64> = (0..=cells).map(|i| contact.centre() - contact.half_width() * angle(i).cos()).collect();
        let mut p = contact.pressure_on(&x);
        // Rounding may place the first and last point just inside.
        (p[0], p[cells as usize]) = (0.0, 0.0);
        Self { x, p }
    }

    /// The same load moved along x.
    pub fn moved(&self, by: f64) -> Self {
        Self { x: self.x.iter().map(|x| x + by).collect(), p: self.p.clone() }
    }

    /// w′(x) = (1/π) ∫ p′(s) κ(x − s) ds with the kernel κ of (T10), exact for the piecewise linear pressure (T11).
    pub fn slope(&self, alpha: f64, f: f64, x: f64) -> f64 {
        let integral = |z: f64| {
            let retarded = f / (1.0 + f) / alpha * retarded_log_integral(alpha * z);
            if z == 0.0 { retarded } else { z * z.abs().ln() - z + retarded }
        };
        let cells = self.x.windows(2).zip(self.p.windows(2));
        let sum: f64 =
            cells.map(|(s, p)| (p[1] - p[0]) / (s[1] - s[0]) * (integral(x - s[0]) - integral(x - s[1]))).sum();
        sum / PI
    }

    /// (2/π) ∫ p w′ dx (Eq. 22, sign corrected), by the middles of the cells.
    pub fn friction(&self, alpha: f64, f: f64) -> f64 {
        let cells = self.x.windows(2).zip(self.p.windows(2));
        let sum: f64 =
            cells.map(|(x, p)| 0.5 * (p[0] + p[1]) * (x[1] - x[0]) * self.slope(alpha, f, 0.5 * (x[0] + x[1]))).sum();
        2.0 / PI * sum
    }
}
