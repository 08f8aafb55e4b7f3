//! What pictures are made of.

use crate::model::{Parameters, Substrate, shortest};
use crate::store::DataSet;

use super::Axis;

/// A published data set, and the substrate it was computed for.
#[derive(Debug)]
pub struct Source {
    /// The data set.
    pub data: DataSet,
    /// The substrate, which known limits need; none if it is not known.
    pub substrate: Option<Substrate>,
}

impl Source {
    /// The value of an axis at an index.
    pub(super) fn value(&self, axis: Axis, index: usize) -> f64 {
        axis.values(&self.data)[index]
    }

    /// f, α and β at these indices.
    pub(super) fn point(&self, [i_f, i_alpha, i_beta]: [usize; 3]) -> [f64; 3] {
        [self.data.f[i_f], self.data.alpha[i_alpha], self.data.beta[i_beta]]
    }

    /// The parameters of the case at these indices; `None` if the substrate is not known.
    pub(super) fn parameters(&self, indices: [usize; 3]) -> Option<Parameters> {
        let [f, alpha, beta] = self.point(indices);
        Some(Parameters { f, alpha, beta, substrate: self.substrate.clone()? })
    }

    /// "β = 100".
    pub(super) fn words(&self, axis: Axis, index: usize) -> String {
        format!("{} = {}", axis.symbol(), rounded(self.value(axis, index)))
    }

    /// "f = 100, α = 1" of the axes named.
    pub(super) fn list(&self, axes: &[Axis], indices: [usize; 3]) -> String {
        let words: Vec<String> = axes.iter().map(|axis| self.words(*axis, indices[axis.dimension()])).collect();
        words.join(", ")
    }
}

/// A number with at most four digits: 31.62, 0.001, 1e6, ∞.
pub(super) fn rounded(value: f64) -> String {
    if value == f64::INFINITY {
        return "∞".to_owned();
    }
    let short: f64 = format!("{value:.3e}").parse().expect("{:e} writes a number");
    if short != 0.0 && !(1e-4..1e6).contains(&short.abs()) { format!("{short:e}") } else { shortest(short) }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn numbers_are_short() {
        let values = [31.622776601683793, 0.001, 1000.0, 0.0, f64::INFINITY, 2e-7];
        assert_eq!(values.map(rounded), ["31.62", "0.001", "1000", "0", "∞", "2e-7"]);
    }
}
