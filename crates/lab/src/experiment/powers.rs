//! The powers by which the parameters of the dimensionless case change with a quantity of the experiment.

use super::Experiment;
use crate::{LaboratoryQuantity, RollerQuantity};

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
    use stribeck_solver::Substrate;

    use super::*;
    use crate::experiment::tests::EXAMPLE;
    use crate::{Modulus, Motion, Roller};

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
}
