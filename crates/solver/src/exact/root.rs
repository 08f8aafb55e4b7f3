//! The root of a function of one variable between two ends.

/// The root of `function` between `a` and `b`, to rounding error, by Chandrupatla's method (Adv. Eng. Software 28, 145,
/// 1997): inverse quadratic interpolation where the three last points allow it, bisection elsewhere.
///
/// `function` must not be positive at `a` nor negative at `b`. An end at which rounding turned the sign is the root.
pub(super) fn bracketed_root(function: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let (mut x1, mut x2) = (a, b);
    let (mut f1, mut f2) = (function(a), function(b));
    if f1 >= 0.0 {
        return a;
    }
    if f2 <= 0.0 {
        return b;
    }
    let mut part: f64 = 0.5;
    // Bisection alone would need about a hundred steps for ends 10⁷ apart; the method needs about ten.
    for _ in 0..200 {
        let x = x1 + part * (x2 - x1);
        let f = function(x);
        let (x3, f3);
        if (f < 0.0) == (f1 < 0.0) {
            (x3, f3) = (x1, f1);
        } else {
            (x3, f3) = (x2, f2);
            (x2, f2) = (x1, f1);
        }
        (x1, f1) = (x, f);
        let (best, residual) = if f1.abs() < f2.abs() { (x1, f1) } else { (x2, f2) };
        let smallest = (2.0 * f64::EPSILON * best.abs() + f64::MIN_POSITIVE) / (x2 - x1).abs();
        if smallest > 0.5 || residual == 0.0 {
            return best;
        }
        let xi = (x1 - x2) / (x3 - x2);
        let phi = (f1 - f2) / (f3 - f2);
        part = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
        } else {
            0.5
        };
        part = part.clamp(smallest, 1.0 - smallest);
    }
    x1
}

#[cfg(test)]
mod tests {
    use super::bracketed_root;

    #[test]
    fn finds_roots_to_rounding_error() {
        assert!((bracketed_root(|x| x * x - 2.0, 0.0, 1e6) - 2_f64.sqrt()).abs() < 1e-15);
        assert!((bracketed_root(|x| 2.0 - x * x, 1e6, 0.0) - 2_f64.sqrt()).abs() < 1e-15);
        assert!((bracketed_root(|x| x.powi(9), -1.0, 2.0)).abs() < 1e-15);
        let step = bracketed_root(|x| if x < 0.3 { -1.0 } else { 1e-9 }, 0.0, 1.0);
        assert!((step - 0.3).abs() < 1e-15);
    }

    #[test]
    fn an_end_can_be_the_root() {
        assert_eq!(bracketed_root(|x| x - 1.0, 1.0, 2.0), 1.0);
        assert_eq!(bracketed_root(|x| x - 2.0, 1.0, 2.0), 2.0);
    }
}
