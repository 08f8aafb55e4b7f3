//! How the viscosity of a fluid changes with temperature.

use crate::temperature::GAS_CONSTANT;

/// The viscosity over that at a reference temperature. Temperatures are in K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViscosityLaw {
    /// ln(η/η_r) = (E/R)(1/T − 1/T_r).
    Arrhenius {
        /// E (J/mol).
        activation_energy: f64,
        /// T_r.
        reference: f64,
    },
    /// ln(η/η_r) = B/(T − C) − B/(T_r − C), of Vogel, Fulcher and Tammann.
    Vogel {
        /// B (K).
        b: f64,
        /// C (K), below all temperatures at which the fluid flows.
        c: f64,
        /// T_r.
        reference: f64,
    },
    /// Measured values.
    Table(ViscosityTable),
}

impl ViscosityLaw {
    /// η at a temperature over the viscosity that is given; `None` where the law has no value.
    pub fn factor(&self, temperature: f64) -> Option<f64> {
        match self {
            Self::Arrhenius { activation_energy, reference } => {
                let exponent = activation_energy / GAS_CONSTANT * (1.0 / temperature - 1.0 / reference);
                (temperature > 0.0).then(|| exponent.exp())
            }
            Self::Vogel { b, c, reference } => {
                (temperature > *c).then(|| (b / (temperature - c) - b / (reference - c)).exp())
            }
            Self::Table(table) => table.factor(temperature),
        }
    }
}

/// Measured viscosities at ascending temperatures, two at least.
///
/// Between them ln η is linear in 1/T; beyond them nothing is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViscosityTable {
    points: [(f64, f64); Self::MOST],
    count: usize,
}

impl ViscosityTable {
    /// Most values of a table.
    pub const MOST: usize = 12;

    /// The table of these temperatures (K) and viscosities; `None` unless there are 2 to 12 of them, the temperatures
    /// ascend, and all numbers are finite and above 0.
    pub fn new(values: &[(f64, f64)]) -> Option<Self> {
        let is_positive = |&(temperature, viscosity): &(f64, f64)| {
            temperature > 0.0 && viscosity > 0.0 && temperature.is_finite() && viscosity.is_finite()
        };
        let ascends = values.is_sorted_by(|a, b| a.0 < b.0);
        if !(2..=Self::MOST).contains(&values.len()) || !ascends || !values.iter().all(is_positive) {
            return None;
        }
        let mut points = [(0.0, 0.0); Self::MOST];
        points[..values.len()].copy_from_slice(values);
        Some(Self { points, count: values.len() })
    }

    /// The viscosity at the lowest temperature, which others are over.
    pub fn first(&self) -> f64 {
        self.points[0].1
    }

    fn factor(&self, temperature: f64) -> Option<f64> {
        let points = &self.points[..self.count];
        let (_, last) = (points[0], points[self.count - 1]);
        if !(points[0].0..=last.0).contains(&temperature) {
            return None;
        }
        let above = points.partition_point(|point| point.0 < temperature).max(1);
        let ((t0, eta0), (t1, eta1)) = (points[above - 1], points[above]);
        let part = (1.0 / temperature - 1.0 / t0) / (1.0 / t1 - 1.0 / t0);
        Some((eta0.ln() * (1.0 - part) + eta1.ln() * part).exp() / self.first())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ARRHENIUS: ViscosityLaw = ViscosityLaw::Arrhenius { activation_energy: 3e4, reference: 300.0 };

    /// A table of Arrhenius' law is that law, between its points too, and knows nothing beyond them.
    #[test]
    fn a_table_is_the_law_it_was_made_of() {
        let factor = |temperature: f64| ARRHENIUS.factor(temperature).expect("everywhere");
        let values = [280.0, 300.0, 350.0].map(|temperature| (temperature, 0.2 * factor(temperature)));
        let table = ViscosityTable::new(&values).expect("a table");
        let law = ViscosityLaw::Table(table);
        for temperature in [280.0, 290.0, 300.0, 333.0, 350.0] {
            let found = law.factor(temperature).expect("within the table") * table.first();
            assert!((found / (0.2 * factor(temperature)) - 1.0).abs() < 1e-12, "{temperature}");
        }
        assert_eq!((law.factor(279.0), law.factor(351.0)), (None, None));
        assert_eq!(ViscosityTable::new(&values[..1]), None);
        assert_eq!(ViscosityTable::new(&[values[1], values[0]]), None);
    }

    /// Vogel's law without C is that of Arrhenius, and has no value at its pole.
    #[test]
    fn vogel_without_c_is_arrhenius() {
        let vogel = |c| ViscosityLaw::Vogel { b: 3e4 / GAS_CONSTANT, c, reference: 300.0 };
        for temperature in [250.0, 300.0, 370.0] {
            let (one, other) = (vogel(0.0).factor(temperature), ARRHENIUS.factor(temperature));
            assert!((one.expect("flows") / other.expect("flows") - 1.0).abs() < 1e-12);
        }
        assert_eq!(vogel(150.0).factor(150.0), None);
    }
}
