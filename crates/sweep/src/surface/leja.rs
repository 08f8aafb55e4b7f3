//! Leja points: nodes of interpolation of which each one lies where the polynomial of those before it is largest.

/// Places that are looked at for the next node.
const CANDIDATES: usize = 8192;

/// The nodes t_0, t_1, … in −1 ≤ t ≤ 1, and the polynomials h_k = Π (t − t_j)/(t_k − t_j) over j < k, which are 0 at
/// the nodes before the k-th and 1 there, and at most 1 everywhere.
#[derive(Clone, Debug)]
pub struct Leja {
    /// The nodes.
    pub nodes: Vec<f64>,
    /// h_j(t_k) for j < k.
    at_nodes: Vec<Vec<f64>>,
    /// Chebyshev coefficients of h_k.
    coefficients: Vec<Vec<f64>>,
}

impl Leja {
    /// So many nodes. The first three are 0, 1 and −1.
    pub fn new(count: usize) -> Self {
        // Cosines are the program's own: nodes are the same numbers on every machine.
        let last = (CANDIDATES - 1) as f64;
        let candidates: Vec<f64> = (0..CANDIDATES).map(|i| pxfm::f_cospi(i as f64 / last)).collect();
        let mut products = vec![1.0_f64; CANDIDATES];
        let mut nodes = vec![0.0];
        while nodes.len() < count {
            let newest = nodes[nodes.len() - 1];
            products.iter_mut().zip(&candidates).for_each(|(product, t)| *product *= t - newest);
            // Of equals the first.
            let largest = products.iter().map(|product| product.abs()).fold(0.0, f64::max);
            let place = products.iter().position(|product| product.abs() == largest).expect("it is one of them");
            nodes.push(candidates[place]);
            products.iter_mut().for_each(|product| *product /= largest);
        }
        let at_nodes = (0..count).map(|k| values(&nodes[..k], nodes[k])).collect();
        Self { at_nodes, coefficients: coefficients(&nodes), nodes }
    }

    /// From values at the first nodes to the factors of the h_k, in place.
    pub fn surpluses(&self, values: &mut [f64]) {
        for k in 0..values.len() {
            let (before, rest) = values.split_at_mut(k);
            rest[0] -= before.iter().zip(&self.at_nodes[k]).map(|(c, h)| c * h).sum::<f64>();
        }
    }

    /// From factors of the h_k to those of the Chebyshev polynomials, in place.
    pub fn chebyshev(&self, factors: &mut [f64]) {
        let mut sums = vec![0.0; factors.len()];
        for (factor, coefficients) in factors.iter().zip(&self.coefficients) {
            sums.iter_mut().zip(coefficients).for_each(|(sum, coefficient)| *sum += factor * coefficient);
        }
        factors.copy_from_slice(&sums);
    }
}

/// h_j(t) for each of some nodes.
fn values(nodes: &[f64], t: f64) -> Vec<f64> {
    (0..nodes.len()).map(|j| nodes[..j].iter().map(|node| (t - node) / (nodes[j] - node)).product()).collect()
}

/// The Chebyshev coefficients of the h_k: h_(k+1) is h_k (t − t_k), scaled to 1 at its own node.
fn coefficients(nodes: &[f64]) -> Vec<Vec<f64>> {
    let mut all = vec![vec![1.0]];
    for k in 1..nodes.len() {
        let (before, node) = (&all[k - 1], nodes[k - 1]);
        let scale: f64 = {
            let [now, then] = [nodes[k], nodes[k - 1]];
            nodes[..k - 1].iter().map(|other| (now - other) / (then - other)).product::<f64>() * (now - then)
        };
        let mut next = vec![0.0; k + 1];
        for (n, c) in before.iter().enumerate() {
            // t T_n = (T_(n+1) + T_|n−1|)/2, and t T_0 = T_1
            let half = if n == 0 { 1.0 } else { 0.5 };
            next[n + 1] += half * c;
            if n > 0 {
                next[n - 1] += 0.5 * c;
            }
            next[n] -= node * c;
        }
        next.iter_mut().for_each(|c| *c /= scale);
        all.push(next);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_polynomial_is_one_at_its_node_and_nowhere_larger() {
        let leja = Leja::new(130);
        assert_eq!(leja.nodes[..3], [0.0, 1.0, -1.0]);
        for k in [1, 2, 5, 20, 60, 129] {
            let value =
                |t: f64| leja.nodes[..k].iter().map(|node| (t - node) / (leja.nodes[k] - node)).product::<f64>();
            let largest = (0..=5000).map(|i| value(f64::from(i) / 2500.0 - 1.0).abs()).fold(0.0, f64::max);
            assert!(largest < 1.0 + 1e-4, "h_{k} reaches {largest}");
            let series = |t: f64| -> f64 {
                leja.coefficients[k].iter().enumerate().map(|(n, c)| c * (n as f64 * t.acos()).cos()).sum()
            };
            for t in [-1.0, -0.77, 0.1, 0.5, 1.0] {
                assert!((series(t) - value(t)).abs() < 1e-11, "h_{k}({t}): {} {}", series(t), value(t));
            }
        }
    }

    #[test]
    fn a_smooth_function_comes_back_as_its_chebyshev_series() {
        let leja = Leja::new(40);
        // 1/(a − t) has the coefficients 2 r^n/√(a² − 1), the first one half of it, with r = a − √(a² − 1).
        let (a, root) = (1.5_f64, 1.25_f64.sqrt());
        let mut factors: Vec<f64> = leja.nodes.iter().map(|t| 1.0 / (a - t)).collect();
        leja.surpluses(&mut factors);
        leja.chebyshev(&mut factors);
        for (n, factor) in factors.iter().enumerate().take(25) {
            let expected = if n == 0 { 1.0 } else { 2.0 } * (a - root).powi(n as i32) / root;
            assert!((factor - expected).abs() < 1e-12, "{n}: {factor} {expected}");
        }
    }
}
