//! How times of a material change with temperature.

/// R = 8.314462618 J/(mol K), exact in the SI of 2019 to the digits here.
pub const GAS_CONSTANT: f64 = 8.314462618;

/// The law of time–temperature superposition: all times at T are a_T times those at a reference temperature.
///
/// Temperatures are in K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShiftLaw {
    /// Williams, Landel and Ferry (1955): log₁₀ a_T = −c₁(T − T_r)/(c₂ + T − T_r).
    Wlf {
        /// c₁, in decades.
        c1: f64,
        /// c₂, in K.
        c2: f64,
        /// T_r.
        reference: f64,
    },
    /// Arrhenius: ln a_T = (E/R)(1/T − 1/T_r).
    Arrhenius {
        /// E, in J/mol.
        activation_energy: f64,
        /// T_r.
        reference: f64,
    },
}

impl ShiftLaw {
    /// log₁₀ a_T; `None` where the law has none: at T_r − c₂ and below.
    pub fn log_shift_factor(&self, temperature: f64) -> Option<f64> {
        match *self {
            Self::Wlf { c1, c2, reference } => {
                let above = temperature - reference;
                (c2 + above > 0.0).then(|| -c1 * above / (c2 + above))
            }
            Self::Arrhenius { activation_energy, reference } => {
                let inverse = 1.0 / temperature - 1.0 / reference;
                (temperature > 0.0).then(|| activation_energy / GAS_CONSTANT * inverse * std::f64::consts::LOG10_E)
            }
        }
    }

    /// a_T, the times at a temperature over those at the reference; `None` where the law has none.
    pub fn shift_factor(&self, temperature: f64) -> Option<f64> {
        self.log_shift_factor(temperature).map(|log| 10_f64.powf(log))
    }

    /// T_r, in K.
    pub fn reference(&self) -> f64 {
        match *self {
            Self::Wlf { reference, .. } | Self::Arrhenius { reference, .. } => reference,
        }
    }

    /// Its name in files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Wlf { .. } => "wlf",
            Self::Arrhenius { .. } => "arrhenius",
        }
    }

    /// The law as a value of TOML, with units.
    pub fn toml(&self) -> String {
        let celsius = |kelvins: f64| format!("{} degC", rounded(kelvins - 273.15, 1e3));
        match *self {
            Self::Wlf { c1, c2, reference } => {
                let (c1, c2, reference) = (rounded(c1, 1e4), rounded(c2, 1e4), celsius(reference));
                format!("{{ law = \"wlf\", c1 = {c1:?}, c2 = \"{c2} K\", reference = \"{reference}\" }}")
            }
            Self::Arrhenius { activation_energy, reference } => {
                let (energy, reference) = (rounded(activation_energy / 1e3, 1e4), celsius(reference));
                format!(
                    "{{ law = \"arrhenius\", activation_energy = \"{energy} kJ/mol\", reference = \"{reference}\" }}"
                )
            }
        }
    }
}

/// A number in steps of 1/`steps`: what more digits say was not measured.
fn rounded(value: f64, steps: f64) -> f64 {
    (value * steps).round() / steps + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ln a_T of both laws has the slope −2.303 c₁/c₂ and −E/(RT²) at the reference, where a_T is 1.
    #[test]
    fn laws_have_their_slope_at_the_reference() {
        let reference = 300.0;
        let wlf = ShiftLaw::Wlf { c1: 17.44, c2: 51.6, reference };
        let arrhenius = ShiftLaw::Arrhenius { activation_energy: 2e5, reference };
        for (law, slope) in
            [(wlf, -17.44 / 51.6 * std::f64::consts::LN_10), (arrhenius, -2e5 / (GAS_CONSTANT * reference * reference))]
        {
            let log = |temperature: f64| law.shift_factor(temperature).expect("within the law").ln();
            assert_eq!(law.shift_factor(reference), Some(1.0));
            assert!(((log(reference + 1e-4) - log(reference - 1e-4)) / 2e-4 / slope - 1.0).abs() < 1e-6, "{law:?}");
            assert!(law.shift_factor(260.0) > law.shift_factor(310.0), "{law:?}: cold is slow");
        }
    }

    #[test]
    fn a_law_has_no_factor_at_its_pole() {
        let law = ShiftLaw::Wlf { c1: 17.44, c2: 50.0, reference: 300.0 };
        assert_eq!((law.shift_factor(250.0), law.shift_factor(200.0)), (None, None));
        assert!(law.shift_factor(251.0).is_some_and(|factor| factor > 1e50));
        assert_eq!(ShiftLaw::Arrhenius { activation_energy: 2e5, reference: 300.0 }.shift_factor(0.0), None);
    }
}
