//! How far the cases of a sweep over quantities of the laboratory reach, and where that is beyond the model.

use std::fmt;

use crate::LaboratoryAxes;
use stribeck_solver::shortest;

/// The contact is taken for small beside the cylinder up to this a₀/R: the gap is a parabola, the bodies half spaces.
const WIDE: f64 = 1.0 / 3.0;

/// The least and the most of some numbers over all places of a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// α.
    pub alpha: [f64; 2],
    /// β.
    pub beta: [f64; 2],
    /// a₀, half the width of the relaxed dry contact, in m.
    pub contact: [f64; 2],
    /// a₀/R.
    pub slenderness: [f64; 2],
    /// Largest pressure of the relaxed dry contact, in Pa.
    pub pressure: [f64; 2],
    /// Film of the relaxed elastic contact for thin films, 0.4458 β^(−3/5) a₀²/R (T35), in m.
    pub film: [f64; 2],
}

impl Extent {
    /// The extent of a sweep.
    pub fn of(axes: &LaboratoryAxes) -> Self {
        let shape = axes.shape();
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let mut extent = Self {
            alpha: nothing,
            beta: nothing,
            contact: nothing,
            slenderness: nothing,
            pressure: nothing,
            film: nothing,
        };
        for place in 0..shape.places() {
            let experiment = axes.experiment(shape.index(place));
            let (contact, scales) = (experiment.contact_length(), experiment.scales());
            for (range, value) in [
                (&mut extent.alpha, experiment.alpha()),
                (&mut extent.beta, experiment.beta()),
                (&mut extent.contact, contact),
                (&mut extent.slenderness, contact / experiment.radius),
                (&mut extent.pressure, scales.pressure),
                (&mut extent.film, 0.4458 * experiment.beta().powf(-0.6) * scales.height),
            ] {
                *range = [range[0].min(value), range[1].max(value)];
            }
        }
        extent
    }

    /// Why the model does not hold everywhere; `None` if it does, as far as is known before anything is solved.
    pub fn note(&self) -> Option<String> {
        let [_, most] = self.slenderness;
        (most > WIDE).then(|| {
            format!(
                "a0 is up to {} R: the contact is not small beside the cylinder, and a parabola on a half space is no \
                 model of it. The load is per length of the cylinder, in N/m; look at load, radius and modulus",
                three(most)
            )
        })
    }
}

impl fmt::Display for Extent {
    /// The ranges of α, β, a₀, and estimates of pressure and film.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [alpha, beta, contact] = [self.alpha, self.beta, self.contact].map(range);
        let slenderness = range(self.slenderness);
        write!(formatter, "alpha {alpha}, beta {beta}, a0 {contact} m ({slenderness} R), ")?;
        write!(formatter, "of the relaxed contact p_max {} Pa dry, film {} m", range(self.pressure), range(self.film))
    }
}

/// The ends of a range with three digits.
pub fn range([least, most]: [f64; 2]) -> String {
    match least == most {
        true => three(least),
        false => format!("{} to {}", three(least), three(most)),
    }
}

/// A number with three digits.
fn three(value: f64) -> String {
    shortest(format!("{value:.2e}").parse().expect("{:e} writes a number"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Grid, Sweep};

    fn extent(load: &str) -> Extent {
        let text = format!(
            "[laboratory]\nradius = \"10 mm\"\nload = {load}\nrelaxed_modulus = \"1.5 MPa\"\npoisson_ratio = 0.5\n\
             viscosity = 0.08\nretardation_time = \"5 ms\"\nspeed = [0.01, 0.1]\nf = 3.0\n"
        );
        match Sweep::parse("wide", &text).expect("valid").grid {
            Grid::Laboratory(axes) => Extent::of(&axes),
            Grid::Dimensionless(_) => unreachable!("it has quantities of the laboratory"),
        }
    }

    #[test]
    fn a_contact_wider_than_a_third_of_the_radius_is_told() {
        assert_eq!(extent("[40.0, 400.0]").note(), None);
        // a₀² = 4NR/(πE∞*) is R²/9
        let limit = std::f64::consts::PI * 2e6 * 0.01 / 36.0;
        assert_eq!(extent(&format!("{:?}", 0.99 * limit)).note(), None);
        let note = extent(&format!("[1.0, {:?}]", 9.0 * limit)).note().expect("a0 = R");
        assert!(note.starts_with("a0 is up to 1 R: "), "{note}");
    }

    #[test]
    fn ranges_are_those_of_the_ends() {
        let extent = extent("[40.0, 400.0]");
        assert!((extent.alpha[1] / extent.alpha[0] - 10.0 * 10_f64.sqrt()).abs() < 1e-9, "{extent:?}");
        assert!((extent.beta[1] / extent.beta[0] - 1000.0).abs() < 1e-6, "{extent:?}");
        assert!(extent.to_string().starts_with("alpha "), "{extent}");
    }
}
