//! The uniform grid.

/// Points x_i = x_min + i Δx, i = 0 … n−1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Left end, behind the outlet.
    pub x_min: f64,
    /// Right end, ahead of the inlet.
    pub x_max: f64,
    /// Number of points n.
    pub points: usize,
}

impl Grid {
    /// [x_min, x_max].
    pub fn ends(&self) -> [f64; 2] {
        [self.x_min, self.x_max]
    }

    /// Δx.
    pub fn spacing(&self) -> f64 {
        (self.x_max - self.x_min) / (self.points - 1) as f64
    }

    /// x_i.
    pub fn x(&self, i: usize) -> f64 {
        self.x_min + i as f64 * self.spacing()
    }

    /// The grid of half as many intervals, while it has enough points to be of use.
    pub fn coarser(&self) -> Option<Self> {
        const FEWEST: usize = 101;
        let points = self.points.div_ceil(2);
        (self.points % 2 == 1 && points >= FEWEST).then_some(Self { points, ..*self })
    }

    /// A function known at the points of this grid, at any x, by linear interpolation; zero outside.
    pub fn interpolate(&self, values: &[f64], x: f64) -> f64 {
        let place = (x - self.x_min) / self.spacing();
        if !(place >= 0.0 && place <= (self.points - 1) as f64) {
            return 0.0;
        }
        let i = (place as usize).min(self.points - 2);
        let t = place - i as f64;
        (1.0 - t) * values[i] + t * values[i + 1]
    }

    /// True if x lies on the grid.
    pub fn contains(&self, x: f64) -> bool {
        x >= self.x_min && x <= self.x_max
    }

    /// A smooth function known at the points of this grid, at an x on it, by the cubic through the four nearest points.
    pub fn cubic(&self, values: &[f64], x: f64) -> f64 {
        let place = (x - self.x_min) / self.spacing();
        let first = (place as usize).clamp(1, self.points - 3) - 1;
        let t = place - first as f64;
        (0..4)
            .map(|j| {
                let others = (0..4).filter(|&k| k != j);
                values[first + j] * others.map(|k| (t - k as f64) / (j as f64 - k as f64)).product::<f64>()
            })
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig {
            rng_seed: proptest::test_runner::RngSeed::Fixed(2022),
            ..ProptestConfig::default()
        })]

        /// Both interpolations hit the points; the linear one is exact for lines, the cubic one for cubics, up to the
        /// ends.
        #[test]
        fn interpolation_is_exact_for_its_polynomials(
            coefficients in prop::array::uniform4(-2.0..2.0),
            points in 5_usize..60,
            place in 0.0..=1.0,
        ) {
            let grid = Grid { x_min: -1.5, x_max: 2.0, points };
            let x = grid.x_min + place * (grid.x_max - grid.x_min);
            let [a, b, c, d] = coefficients;
            let cubic = |x: f64| a + x * (b + x * (c + x * d));
            let line = |x: f64| a + b * x;
            let on_grid = |function: &dyn Fn(f64) -> f64| (0..points).map(|i| function(grid.x(i))).collect::<Vec<_>>();
            prop_assert!((grid.cubic(&on_grid(&cubic), x) - cubic(x)).abs() < 1e-11);
            prop_assert!((grid.interpolate(&on_grid(&line), x) - line(x)).abs() < 1e-12);
            let i = (place * (points - 1) as f64) as usize;
            prop_assert!((grid.interpolate(&on_grid(&cubic), grid.x(i)) - cubic(grid.x(i))).abs() < 1e-11);
            prop_assert_eq!(grid.interpolate(&on_grid(&line), grid.x_max + 1e-3), 0.0);
        }
    }
}
