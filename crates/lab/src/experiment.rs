//! An experiment in SI units, and the dimensionless parameters that follow from it.

use std::f64::consts::PI;

use crate::{LaboratoryQuantity, Motion, Roller, RollerQuantity, Scales, ShiftLaw, ViscosityLaw};
use stribeck_solver::{Parameters, RetardationMode, Substrate};

/// Which of the two moduli of a substrate is given, in Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Modulus {
    /// E∞.
    Relaxed(f64),
    /// E₀ = (1 + f) E∞.
    Instantaneous(f64),
}

impl Modulus {
    /// E∞ of a body with this f.
    pub fn relaxed(self, f: f64) -> f64 {
        match self {
            Self::Relaxed(modulus) => modulus,
            Self::Instantaneous(modulus) => modulus / (1.0 + f),
        }
    }

    /// E₀ of a body with this f.
    pub fn instantaneous(self, f: f64) -> f64 {
        match self {
            Self::Relaxed(modulus) => modulus * (1.0 + f),
            Self::Instantaneous(modulus) => modulus,
        }
    }

    /// d ln/d ln f of 1/E∞ and of 1/E₀.
    fn compliances_with_strength(self, f: f64) -> [f64; 2] {
        match self {
            Self::Relaxed(_) => [0.0, -f / (1.0 + f)],
            Self::Instantaneous(_) => [f / (1.0 + f), 0.0],
        }
    }

    /// The same one, larger by a factor.
    pub fn times(self, factor: f64) -> Self {
        match self {
            Self::Relaxed(value) => Self::Relaxed(value * factor),
            Self::Instantaneous(value) => Self::Instantaneous(value * factor),
        }
    }
}

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

/// A temperature, and what changes with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temperature {
    /// T (K).
    pub value: f64,
    /// The laws of what changes.
    pub laws: TemperatureLaws,
}

/// How times and viscosity change with temperature; what has no law stays as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TemperatureLaws {
    /// Of the times of the flat.
    pub flat: Option<ShiftLaw>,
    /// Of the times of the roller.
    pub roller: Option<ShiftLaw>,
    /// Of the viscosity.
    pub viscosity: Option<ViscosityLaw>,
}

impl TemperatureLaws {
    /// What a quantity is, in words; what a law changes belongs to the reference temperature of that law.
    pub fn long_name(&self, quantity: LaboratoryQuantity) -> &'static str {
        match quantity {
            LaboratoryQuantity::Viscosity if self.viscosity.is_some() => {
                "viscosity of the fluid at the reference temperature of its law"
            }
            LaboratoryQuantity::RetardationTime if self.flat.is_some() => {
                "retardation time of the substrate at the reference temperature of its shift"
            }
            other => other.long_name(),
        }
    }

    /// True where every law has a value.
    pub fn admit(&self, temperature: f64) -> bool {
        let shifts = [self.flat, self.roller].into_iter().flatten().all(|law| law.shift_factor(temperature).is_some());
        shifts && self.viscosity.is_none_or(|law| law.factor(temperature).is_some())
    }
}

/// The powers by which α and f of flat and roller, β and the friction scale a₀/R change with a quantity q: d ln/d ln q.
/// S changes by itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Powers {
    /// Of α of the flat and of the roller (Eq. 13, T59).
    pub alpha: [f64; 2],
    /// Of β (Eq. 14).
    pub beta: f64,
    /// Of f_i, the parts of f that are of the flat and of the roller (T59).
    pub strength: [f64; 2],
    /// Of a₀/R.
    pub friction: f64,
    /// dS/d ln q of the slide-to-roll ratio S (T52).
    pub slide_roll: f64,
}

impl Powers {
    /// What each of the parameters of [`Sensitivities::PARAMETERS`](stribeck_solver::Sensitivities::PARAMETERS) adds to
    /// the derivative with respect to ln q of a friction with these derivatives.
    pub fn changes(&self, derivatives: [f64; 5]) -> [f64; 5] {
        let powers = [self.alpha[0], self.beta, self.strength[0], self.alpha[1], self.strength[1]];
        // Where a body comes to rest its α grows without bound; what does not depend on it stays as it is.
        let change = |i: usize| if derivatives[i] == 0.0 { 0.0 } else { derivatives[i] * powers[i] };
        std::array::from_fn(change)
    }
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

    /// Names of the numbers that temperature changes, with unit and description, in the order of
    /// [`Experiment::variables`], behind those of [`Scales::VARIABLES`].
    pub const AT_TEMPERATURE: [(&'static str, &'static str, &'static str); 2] = [
        ("viscosity_at_temperature", "Pa s", "viscosity of the fluid at the temperature"),
        ("retardation_time_at_temperature", "s", "retardation time of the substrate at the temperature"),
    ];

    /// What is published beside the solution, with name, unit and description: the scales, and what temperature changes
    /// if there is one.
    pub fn variables(&self) -> impl Iterator<Item = ((&'static str, &'static str, &'static str), f64)> {
        let at_temperature = [self.viscosity_there(), self.flat_time()];
        let shifted = Self::AT_TEMPERATURE.into_iter().zip(at_temperature).filter(|_| self.temperature.is_some());
        Scales::VARIABLES.into_iter().zip(self.scales().values()).chain(shifted)
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

    /// The value of a quantity; the modulus that was not given follows from f.
    pub fn value(&self, quantity: LaboratoryQuantity) -> f64 {
        match quantity {
            LaboratoryQuantity::Radius => self.radius,
            LaboratoryQuantity::Load => self.load,
            LaboratoryQuantity::RelaxedModulus => self.modulus.relaxed(self.f),
            LaboratoryQuantity::InstantaneousModulus => self.modulus.instantaneous(self.f),
            LaboratoryQuantity::PoissonRatio => self.poisson_ratio,
            LaboratoryQuantity::Viscosity => self.viscosity,
            LaboratoryQuantity::RetardationTime => self.retardation_time,
            LaboratoryQuantity::Temperature => self.temperature.map_or(f64::NAN, |temperature| temperature.value),
            speed => self.motion.value(speed),
        }
    }

    /// What a quantity is, in words.
    pub fn long_name(&self, quantity: LaboratoryQuantity) -> &'static str {
        self.temperature.map_or(quantity.long_name(), |temperature| temperature.laws.long_name(quantity))
    }

    /// The quantities that are given, in the order of [`LaboratoryQuantity::ALL`]: one of the moduli, and the speeds of
    /// one form of motion; the temperature where times or viscosity follow from it.
    pub fn given(&self) -> impl Iterator<Item = LaboratoryQuantity> {
        let other = match self.modulus {
            Modulus::Relaxed(_) => LaboratoryQuantity::InstantaneousModulus,
            Modulus::Instantaneous(_) => LaboratoryQuantity::RelaxedModulus,
        };
        let speeds = self.motion.given();
        let is_speed = |quantity: &LaboratoryQuantity| LaboratoryQuantity::SPEEDS.contains(quantity);
        let is_known = |it: &LaboratoryQuantity| *it != LaboratoryQuantity::Temperature || self.temperature.is_some();
        let others =
            LaboratoryQuantity::ALL.into_iter().filter(move |it| *it != other && !is_speed(it) && is_known(it));
        others.chain(speeds.iter().copied())
    }

    /// Sets a quantity; a modulus becomes the given one.
    pub fn set(&mut self, quantity: LaboratoryQuantity, value: f64) {
        match quantity {
            LaboratoryQuantity::Radius => self.radius = value,
            LaboratoryQuantity::Load => self.load = value,
            LaboratoryQuantity::RelaxedModulus => self.modulus = Modulus::Relaxed(value),
            LaboratoryQuantity::InstantaneousModulus => self.modulus = Modulus::Instantaneous(value),
            LaboratoryQuantity::PoissonRatio => self.poisson_ratio = value,
            LaboratoryQuantity::Viscosity => self.viscosity = value,
            LaboratoryQuantity::RetardationTime => self.retardation_time = value,
            LaboratoryQuantity::Temperature => {
                let laws = self.temperature.map_or_else(TemperatureLaws::default, |temperature| temperature.laws);
                self.temperature = Some(Temperature { value, laws });
            }
            speed => self.motion.set(speed, value),
        }
    }

    /// The powers of a quantity while the others that are given stay. Moduli and times are those of the flat.
    ///
    /// From a₀² = 4NR/(πE∞*): β = 4N²/(3π² E∞* η (u₁+u₂) R). NaN for the temperature, which no power law holds for.
    pub fn powers(&self, quantity: LaboratoryQuantity) -> Powers {
        let powers = |alpha, beta, friction| Powers { alpha, beta, strength: [0.0; 2], friction, slide_roll: 0.0 };
        match quantity {
            LaboratoryQuantity::Radius => powers([0.5; 2], -1.0, -0.5),
            LaboratoryQuantity::Load => powers([0.5; 2], 2.0, 0.5),
            LaboratoryQuantity::RelaxedModulus | LaboratoryQuantity::InstantaneousModulus => {
                self.powers_of_body(0, [-1.0; 2], 0.0)
            }
            LaboratoryQuantity::PoissonRatio => {
                let square = self.poisson_ratio * self.poisson_ratio;
                self.powers_of_body(0, [-2.0 * square / (1.0 - square); 2], 0.0)
            }
            LaboratoryQuantity::Viscosity => powers([0.0; 2], -1.0, 0.0),
            LaboratoryQuantity::RetardationTime => powers([-1.0, 0.0], 0.0, 0.0),
            LaboratoryQuantity::Temperature => powers([f64::NAN; 2], f64::NAN, f64::NAN),
            speed => {
                let [roller, flat, sum, slide_roll] = self.motion.powers(speed);
                Powers { slide_roll, ..powers([-flat, -roller], -sum, 0.0) }
            }
        }
    }

    /// The powers of f of the flat: where the instantaneous modulus is given, the relaxed one falls as 1/(1 + f).
    pub fn powers_of_strength(&self) -> Powers {
        self.powers_of_body(0, self.modulus.compliances_with_strength(self.f), 1.0)
    }

    /// The powers of a quantity of the roller.
    pub fn powers_of_roller(&self, quantity: RollerQuantity) -> Powers {
        match quantity {
            RollerQuantity::Strength => {
                self.powers_of_body(1, self.roller.modulus.compliances_with_strength(self.roller.f), 1.0)
            }
            RollerQuantity::RelaxedModulus | RollerQuantity::InstantaneousModulus => {
                self.powers_of_body(1, [-1.0; 2], 0.0)
            }
            RollerQuantity::RetardationTime => Powers { alpha: [0.0, -1.0], ..self.powers_of_body(1, [0.0; 2], 0.0) },
        }
    }

    /// The powers of a quantity with which 1/E∞,i* and 1/E₀,i* of a body and its own f have the given ones.
    ///
    /// The body has a part of the relaxed compliance 1/E∞*, and one of the instantaneous 1/E₀*; its part of f is f_i =
    /// φ_i E₀*/E₀,i* with its own φ_i (T59). A body at rest has relaxed: its instantaneous compliance is the relaxed one.
    fn powers_of_body(&self, body: usize, [relaxed, instantaneous]: [f64; 2], own: f64) -> Powers {
        let speeds = [self.motion.flat_speed(), self.motion.roller_speed()];
        let compliances = [1.0 / self.flat_modulus(), 1.0 / self.roller.plane_strain_modulus()];
        let at_once = |i: usize| {
            let f = [self.f, self.roller.f][i];
            if speeds[i] == 0.0 { compliances[i] } else { compliances[i] / (1.0 + f) }
        };
        let instantaneous = if speeds[body] == 0.0 { relaxed } else { instantaneous };
        let of_relaxed = relaxed * compliances[body] / (compliances[0] + compliances[1]);
        let of_instantaneous = instantaneous * at_once(body) / (at_once(0) + at_once(1));
        let mut strength = [-of_instantaneous; 2];
        strength[body] += own + instantaneous;
        let (half, beta) = (0.5 * of_relaxed, of_relaxed);
        Powers { alpha: [half; 2], beta, strength, friction: half, slide_roll: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of the paper: R = 2 mm, E∞* = 10⁵ Pa, η = 5.1 Pa s, N = 119 N/m, V = 1 mm/s gives β ≈ 1.9·10³.
    const EXAMPLE: Experiment = Experiment {
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

    #[test]
    fn both_moduli_give_the_same_experiment() {
        for f in [0.0, 1.0, 100.0] {
            let relaxed = Experiment { f, ..EXAMPLE };
            let mut instantaneous = relaxed;
            let value = relaxed.value(LaboratoryQuantity::InstantaneousModulus);
            instantaneous.set(LaboratoryQuantity::InstantaneousModulus, value);
            assert!((instantaneous.beta() / relaxed.beta() - 1.0).abs() < 1e-14);
            assert!((instantaneous.value(LaboratoryQuantity::RelaxedModulus) - 1e5).abs() < 1e-9);
        }
    }

    /// All forms of the motion of one pair of speeds.
    const MOTIONS: [Motion; 3] = [
        Motion::Sliding { speed: 1e-3 },
        Motion::Rolling { entrainment_speed: 2e-3, slide_roll_ratio: 0.7 },
        Motion::Surfaces { roller_speed: 1e-3, flat_speed: 3e-3 },
    ];

    /// α and f of flat and roller, β, a₀/R and S of an experiment, as logarithms but for S.
    fn numbers(experiment: &Experiment) -> [f64; 7] {
        let case = experiment.parameters_of_both(&Substrate::default(), &Substrate::default());
        let modes: Vec<[f64; 2]> =
            case.substrate.modes().iter().map(|mode| [case.alpha / mode.time, case.f * mode.share]).collect();
        let of = |body: usize| match case.substrate.of_roller() {
            0 if body == 1 => [1.0; 2],
            1 if body == 0 && modes.len() == 1 => [1.0; 2],
            _ => modes[body.min(modes.len() - 1)],
        };
        let ([flat, f], [roller, roller_f]) = (of(0), of(1));
        let [flat, f, roller, roller_f] = [flat, f, roller, roller_f].map(f64::ln);
        let [beta, friction] = [case.beta, experiment.scales().friction].map(f64::ln);
        [flat, roller, beta, f, roller_f, friction, experiment.motion.slide_roll()]
    }

    fn compare(powers: Powers, below: Experiment, above: Experiment, step: f64, what: &str) {
        let Powers { alpha: [flat, roller], beta, strength: [f, roller_f], friction, slide_roll } = powers;
        let powers = [flat, roller, beta, f, roller_f, friction, slide_roll];
        for (place, (power, (low, high))) in
            powers.into_iter().zip(numbers(&below).into_iter().zip(numbers(&above))).enumerate()
        {
            // what is not there has no power that counts
            let is_there = low != 0.0 || high != 0.0;
            let slope = (high - low) / step;
            assert!(!is_there || (power - slope).abs() < 1e-7, "{what}, {place}: {power} {slope}");
        }
    }

    /// Powers against differences, for each quantity and for f, of a flat alone, of a roller alone and of both.
    #[test]
    fn powers_are_logarithmic_derivatives() {
        let step: f64 = 1e-4;
        let soft = Roller { modulus: Modulus::Relaxed(3e5), poisson_ratio: 0.4, f: 4.0, retardation_time: 0.3 };
        let rollers =
            [Roller::RIGID, soft, Roller { modulus: Modulus::Instantaneous(2e6), ..soft }, Roller { f: 0.0, ..soft }];
        let moduli = [Modulus::Relaxed(1e5), Modulus::Instantaneous(1e6), Modulus::Relaxed(f64::INFINITY)];
        let all = moduli.into_iter().flat_map(|modulus| rollers.map(|roller| (modulus, roller)));
        let all = all.filter(|(modulus, roller)| modulus.relaxed(1.0) < f64::INFINITY || roller.f > 0.0);
        for ((modulus, roller), motion) in all.flat_map(|bodies| MOTIONS.map(|motion| (bodies, motion))) {
            if modulus.relaxed(1.0) == f64::INFINITY && motion.roller_speed() == 0.0 {
                continue;
            }
            let f = if modulus.relaxed(1.0) == f64::INFINITY { 0.0 } else { EXAMPLE.f };
            let at = Experiment { modulus, poisson_ratio: 0.45, motion, roller, f, ..EXAMPLE };
            let of_flat = |quantity: &LaboratoryQuantity| f > 0.0 || !quantity.name().ends_with("_modulus");
            for quantity in at.given().filter(of_flat) {
                assert_eq!(LaboratoryQuantity::named(quantity.name()), Some(quantity));
                let moved = |by: f64| {
                    let mut other = at;
                    other.set(quantity, at.value(quantity) * by.exp());
                    other
                };
                compare(at.powers(quantity), moved(-0.5 * step), moved(0.5 * step), step, quantity.name());
            }
            for quantity in at.roller.given() {
                let moved = |by: f64| {
                    let mut other = at;
                    other.roller.set(quantity, at.roller.value(quantity) * by.exp());
                    other
                };
                compare(at.powers_of_roller(quantity), moved(-0.5 * step), moved(0.5 * step), step, quantity.name());
            }
            if f > 0.0 {
                let moved = |by: f64| Experiment { f: at.f * by.exp(), ..at };
                compare(at.powers_of_strength(), moved(-0.5 * step), moved(0.5 * step), step, "f");
            }
        }
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
