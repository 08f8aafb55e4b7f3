//! Cases far outside of the range of the relaxation method, and some inside it.

use stribeck_solver::{Parameters, RetardationMode, Substrate};

/// Decades of α, β and f.
const BOX: [[f64; 2]; 3] = [[-8.0, 8.0], [-4.0, 10.0], [-2.0, 6.0]];

/// Cases spread evenly over ln α, ln β and ln f of the box, by the additive recurrence whose ratios are powers of the
/// root of x⁴ = x + 1. Every other one has two retardation times six decades apart.
pub fn far_cases(count: usize) -> Vec<Parameters> {
    const ROOT: f64 = 1.220_744_084_605_759_6;
    let two_times = [1e-3, 1e3].map(|time| RetardationMode { share: 0.5, time });
    let wide = Substrate::new(two_times.to_vec()).expect("the shares add up to 1");
    let case = |i: usize| {
        let [alpha, beta, f] = [1, 2, 3].map(|k| {
            let [from, to] = BOX[k as usize - 1];
            let place = (0.5 + i as f64 * ROOT.powi(-k)).fract();
            10_f64.powf(from + place * (to - from))
        });
        let substrate = if i.is_multiple_of(2) { Substrate::default() } else { wide.clone() };
        Parameters { substrate, ..Parameters::new(alpha, beta, f) }
    };
    (1..=count).map(case).collect()
}
