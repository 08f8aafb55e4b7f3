//! An experiment in SI units, and the dimensionless parameters that follow from it.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `modulus` | [`Modulus`]: the modulus that is given, of two |
//! | `temperature_laws` | [`TemperatureLaws`]: how times and viscosity change with temperature |
//! | `quantities` | the quantities of an experiment by name: read, set, published |
//! | `powers` | [`Powers`]: how the parameters of the case change with a quantity |

use std::f64::consts::PI;

use stribeck_solver::{Parameters, RetardationMode, Substrate};

use crate::{Motion, Roller, Scales, ShiftLaw};

mod modulus;
mod powers;
mod quantities;
mod temperature_laws;

pub use modulus::Modulus;
pub use powers::Powers;
pub use temperature_laws::{Temperature, TemperatureLaws};

/// An experiment: a cylinder, a fluid and a flat, in SI units. Moduli, times and f are those of the flat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// R (m).
    pub radius: f64,
    /// N (N/m).
    pub load: f64,
    /// E∞ or E₀ (Pa); infinite for a rigid flat.
    pub modulus: Modulus,
    /// ν.
    pub poisson_ratio: f64,
    /// η (Pa s).
    pub viscosity: f64,
    /// τ (s), the time that α is made of.
    pub retardation_time: f64,
    /// The speeds of both surfaces (m/s).
    pub motion: Motion,
    /// f = E₀/E∞ − 1.
    pub f: f64,
    /// What the roller is made of.
    pub roller: Roller,
    /// The temperature, where times and viscosity follow from it: those that are given belong to its laws' reference.
    pub temperature: Option<Temperature>,
}

impl Experiment {
    /// E∞* (Pa), the relaxed modulus of the contact in plane strain: E∞/(1 − ν²) of the flat, and with a soft roller
    /// 1/E∞* = Σ 1/E∞,i* of both (T59).
    pub fn plane_strain_modulus(&self) -> f64 {
        let flat = self.flat_modulus();
        match self.roller.is_rigid() {
            true => flat,
            false => 1.0 / (1.0 / flat + 1.0 / self.roller.plane_strain_modulus()),
        }
    }

    /// E∞/(1 − ν²) of the flat.
    fn flat_modulus(&self) -> f64 {
        self.modulus.relaxed(self.f) / (1.0 - self.poisson_ratio * self.poisson_ratio)
    }

    /// a₀ = √(4NR/(πE∞*)) (m), half the width of the relaxed dry contact.
    pub fn contact_length(&self) -> f64 {
        (4.0 * self.load * self.radius / (PI * self.plane_strain_modulus())).sqrt()
    }

    /// α = a₀/(u₂τ) (Eq. 13, T52), with the speed of the flat, which is the soft body; ∞ where it is at rest.
    pub fn alpha(&self) -> f64 {
        self.contact_length() / (self.motion.flat_speed() * self.flat_time())
    }

    /// The retardation time of the flat at the temperature of the experiment; NaN where its law has no value.
    fn flat_time(&self) -> f64 {
        self.retardation_time * self.shift(|laws| laws.flat)
    }

    /// The retardation time of the roller at the temperature of the experiment.
    fn roller_time(&self) -> f64 {
        self.roller.retardation_time * self.shift(|laws| laws.roller)
    }

    fn shift(&self, law: impl Fn(&TemperatureLaws) -> Option<ShiftLaw>) -> f64 {
        let known = self.temperature.as_ref().and_then(|it| Some((law(&it.laws)?, it.value)));
        known.map_or(1.0, |(law, temperature)| law.shift_factor(temperature).unwrap_or(f64::NAN))
    }

    /// The viscosity at the temperature of the experiment; NaN where its law has no value.
    pub fn viscosity_there(&self) -> f64 {
        let known = self.temperature.as_ref().and_then(|it| Some((it.laws.viscosity?, it.value)));
        self.viscosity * known.map_or(1.0, |(law, temperature)| law.factor(temperature).unwrap_or(f64::NAN))
    }

    /// β = E∞* a₀⁴/(12 η (u₁+u₂) R³) (Eq. 14, T52).
    pub fn beta(&self) -> f64 {
        let slenderness = self.contact_length() / self.radius;
        self.plane_strain_modulus() * slenderness.powi(3) * self.contact_length()
            / (12.0 * self.viscosity_there() * self.motion.sum())
    }

    /// The dimensionless case of this experiment on a flat with the given retardation spectrum under a rigid roller.
    ///
    /// # Panics
    /// If the roller is soft: its spectrum counts then ([`Experiment::parameters_of_both`]).
    pub fn parameters(&self, substrate: &Substrate) -> Parameters {
        assert!(self.roller.is_rigid(), "the roller is soft");
        Parameters { alpha: self.alpha(), beta: self.beta(), f: self.f, substrate: substrate.clone() }
    }

    /// The dimensionless case of this experiment with the retardation spectra of flat and roller.
    ///
    /// The mode of body i with the part s of its φ_i = f_i and the time τ has f_ij = s φ_i E₀*/E₀,i* and a₀/(u_i τ)
    /// (T59). Its α is that of the flat, or that of the roller where the flat has no retardation or is at rest.
    pub fn parameters_of_both(&self, flat: &Substrate, roller: &Substrate) -> Parameters {
        if self.roller.is_rigid() {
            return self.parameters(flat);
        }
        let relaxed = [1.0 / self.flat_modulus(), 1.0 / self.roller.plane_strain_modulus()];
        let instantaneous = [relaxed[0] / (1.0 + self.f), relaxed[1] / (1.0 + self.roller.f)];
        let together: f64 = instantaneous.iter().sum();
        let f = relaxed.iter().sum::<f64>() / together - 1.0;
        // Part of f, not above 1 by rounding, and time over the one in α, of each body. Ratios of speeds follow from S,
        // which stays as it is to the last bit along the entrainment speed.
        let part = |body: usize, f_of_body: f64| (f_of_body * instantaneous[body] / (together * f)).min(1.0);
        let (flat_speed, roller_speed) = (self.motion.flat_speed(), self.motion.roller_speed());
        let slide_roll = self.motion.slide_roll();
        let (alpha, times) = if self.f > 0.0 && flat_speed > 0.0 {
            let slower = (1.0 - slide_roll) / (1.0 + slide_roll);
            (self.alpha(), [1.0, slower * self.roller_time() / self.flat_time()])
        } else if self.roller.f > 0.0 && roller_speed > 0.0 {
            (self.contact_length() / (roller_speed * self.roller_time()), [0.0, 1.0])
        } else {
            return Parameters::elastic(self.beta());
        };
        let modes = |body: usize, f_of_body: f64, spectrum: &Substrate| -> Vec<RetardationMode> {
            let share = part(body, f_of_body);
            let own = spectrum.modes().iter().filter(|_| f_of_body > 0.0);
            own.map(|mode| RetardationMode { share: share * mode.share, time: times[body] * mode.time }).collect()
        };
        let (flat, roller) = (modes(0, self.f, flat), modes(1, self.roller.f, roller));
        Parameters::of_two_bodies([alpha, self.beta(), f], &flat, &roller).expect("parts of f add up to 1")
    }

    /// The units of its solution.
    pub fn scales(&self) -> Scales {
        let length = self.contact_length();
        Scales {
            length,
            height: length * length / self.radius,
            pressure: 2.0 * self.load / (PI * length),
            friction: length / self.radius,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LaboratoryQuantity;

    /// The example of the paper: R = 2 mm, E∞* = 10⁵ Pa, η = 5.1 Pa s, N = 119 N/m, V = 1 mm/s gives β ≈ 1.9·10³.
    pub(super) const EXAMPLE: Experiment = Experiment {
        radius: 2e-3,
        load: 119.0,
        modulus: Modulus::Relaxed(1e5),
        poisson_ratio: 0.0,
        viscosity: 5.1,
        retardation_time: 0.1,
        motion: Motion::Sliding { speed: 1e-3 },
        f: 10.0,
        roller: Roller::RIGID,
        temperature: None,
    };

    #[test]
    fn the_example_of_the_paper_has_its_beta() {
        // 4N²/(3π² E∞* η V R)
        let expected = 4.0 * 119.0_f64.powi(2) / (3.0 * PI * PI * 1e5 * 5.1 * 1e-3 * 2e-3);
        assert!((EXAMPLE.beta() / expected - 1.0).abs() < 1e-14);
        assert!((EXAMPLE.beta() - 1.9e3).abs() < 0.05e3, "{}", EXAMPLE.beta());
        assert!((EXAMPLE.contact_length() - 1.741e-3).abs() < 1e-6);
        assert!((EXAMPLE.alpha() - 17.41).abs() < 0.01);
    }

    /// N² = (π/4) E∞* p₀² R, p₀ = 2N/(πa₀): Hertz.
    #[test]
    fn the_scale_of_the_pressure_is_that_of_hertz() {
        let scales = EXAMPLE.scales();
        let modulus = EXAMPLE.plane_strain_modulus();
        assert!((scales.pressure - modulus * scales.friction / 2.0).abs() < 1e-9 * scales.pressure);
        assert_eq!(scales.height, scales.length * scales.length / EXAMPLE.radius);
    }

    /// One motion in any form is one experiment, and a roller that does not turn is the paper's.
    #[test]
    fn one_motion_has_three_forms() {
        let rolling = Motion::Rolling { entrainment_speed: 2e-3, slide_roll_ratio: 1.0 };
        let surfaces = Motion::Surfaces { roller_speed: 1e-3, flat_speed: 3e-3 };
        for quantity in LaboratoryQuantity::SPEEDS {
            assert_eq!(rolling.value(quantity), surfaces.value(quantity), "{}", quantity.name());
        }
        let [one, other] = [rolling, surfaces].map(|motion| Experiment { motion, ..EXAMPLE });
        assert_eq!((one.alpha(), one.beta()), (other.alpha(), other.beta()));
        let still = Motion::Surfaces { roller_speed: 0.0, flat_speed: 1e-3 };
        let still = Experiment { motion: still, ..EXAMPLE };
        assert_eq!((still.alpha(), still.beta()), (EXAMPLE.alpha(), EXAMPLE.beta()));
        assert_eq!((still.motion.slide_roll(), EXAMPLE.motion.slide_roll()), (1.0, 1.0));
        // a flat at rest has all the time there is to relax
        let motion = Motion::Surfaces { roller_speed: 1e-3, flat_speed: 0.0 };
        assert_eq!(Experiment { motion, ..EXAMPLE }.alpha(), f64::INFINITY);
    }
}
