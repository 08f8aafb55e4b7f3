//! The columns of published sensitivities: d ln μ/d ln q for each input q of a case.

use super::further_columns::FurtherColumn;
use crate::{Column, Values};
use stribeck_lab::{Experiment, LaboratoryQuantity, Powers, Unknown};
use stribeck_solver::Sensitivities;

/// The friction coefficients that have sensitivities.
const FRICTION: [Column; 6] =
    [Column::MuV, Column::MuH, Column::MuTot, Column::MuDrag, Column::MuPressure, Column::MuShear];

/// An input of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Input {
    Alpha,
    Beta,
    Strength,
    Quantity(Unknown),
}

impl Input {
    /// Those of a dimensionless case, whose α and f move both bodies, or of one over quantities of the laboratory.
    fn all(experiment: Option<&Experiment>) -> Vec<Self> {
        let Some(experiment) = experiment else { return vec![Self::Alpha, Self::Beta, Self::Strength] };
        // The temperature stands for times and viscosity, which have their own.
        let given = experiment.given().filter(|quantity| *quantity != LaboratoryQuantity::Temperature);
        let of_flat = std::iter::once(Unknown::Strength).chain(given.map(Unknown::Quantity));
        of_flat.chain(experiment.roller.given().map(Unknown::Roller)).map(Self::Quantity).collect()
    }

    /// Its name in those of columns.
    fn name(self) -> String {
        match self {
            Self::Alpha => "alpha".to_owned(),
            Self::Beta => "beta".to_owned(),
            Self::Strength => "f".to_owned(),
            Self::Quantity(quantity) => quantity.name().replace('.', "_"),
        }
    }

    /// By which powers the parameters of the case and the scale of friction change with it.
    fn powers(self, experiment: Option<&Experiment>) -> Powers {
        let powers =
            |alpha, beta, f| Powers { alpha: [alpha; 2], beta, strength: [f; 2], friction: 0.0, slide_roll: 0.0 };
        match (self, experiment) {
            (Self::Alpha, _) => powers(1.0, 0.0, 0.0),
            (Self::Beta, _) => powers(0.0, 1.0, 0.0),
            (Self::Strength, _) => powers(0.0, 0.0, 1.0),
            (Self::Quantity(quantity), experiment) => quantity.powers(experiment.expect("it is of an experiment")),
        }
    }
}

/// The columns of a sweep, those of one friction coefficient together; then those of their errors.
pub(super) fn columns(experiment: Option<&Experiment>) -> Vec<FurtherColumn> {
    let inputs = Input::all(experiment);
    let pairs = || FRICTION.iter().flat_map(|mu| inputs.iter().map(move |input| (mu.name(), input.name())));
    let derivative = |(mu, input): (&str, String)| FurtherColumn {
        name: format!("dln_{mu}_dln_{input}"),
        long_name: format!("relative change of {mu} over that of {input}"),
    };
    let error = |(mu, input): (&str, String)| FurtherColumn {
        name: format!("error_dln_{mu}_dln_{input}"),
        long_name: format!("estimated error of the relative change of {mu} over that of {input}"),
    };
    pairs().map(derivative).chain(pairs().map(error)).collect()
}

/// Their values for a case with these numbers over a₀/R at a slide-to-roll ratio, from the sensitivities and their
/// errors; NaN where there are none, and where μ = 0.
pub(super) fn values(
    [sensitivities, errors]: [Option<Sensitivities>; 2],
    values: &Values,
    slide_roll: f64,
    experiment: Option<&Experiment>,
) -> Vec<f64> {
    let inputs = Input::all(experiment);
    let relative = |column: Column, input: &Input| {
        let (mu, powers) = (values[column], input.powers(experiment));
        let Some(sensitivities) = sensitivities.filter(|_| mu != 0.0) else { return f64::NAN };
        // S stands before C alone
        let sheared = [Column::MuH, Column::MuTot, Column::MuDrag].contains(&column);
        let by_ratio = if sheared { values[Column::MuShear] / mu * powers.slide_roll } else { 0.0 };
        let changes = powers.changes(derivatives(&sensitivities, column, slide_roll).map(|derivative| derivative / mu));
        changes.iter().sum::<f64>() + by_ratio + powers.friction
    };
    let error = |column: Column, input: &Input| {
        let (mu, powers) = (values[column], input.powers(experiment));
        let Some(errors) = errors.filter(|_| mu != 0.0) else { return f64::NAN };
        let changes = powers.changes(errors_of_derivatives(&errors, column, slide_roll).map(|error| error / mu));
        changes.iter().map(|change| change.abs()).sum()
    };
    let pairs = || FRICTION.into_iter().flat_map(|column| inputs.iter().map(move |input| (column, input)));
    let relative = pairs().map(|(column, input)| relative(column, input));
    relative.chain(pairs().map(|(column, input)| error(column, input))).collect()
}

/// dμ/d ln θ of one of [`FRICTION`] for the parameters θ of [`Sensitivities::PARAMETERS`].
fn derivatives(sensitivities: &Sensitivities, column: Column, slide_roll: f64) -> [f64; 5] {
    match column {
        Column::MuV => sensitivities.viscoelastic(),
        Column::MuH => sensitivities.hydrodynamic_at(slide_roll),
        Column::MuTot => sensitivities.total_at(slide_roll),
        Column::MuPressure => sensitivities.pressure,
        Column::MuShear => sensitivities.shear(),
        _ => sensitivities.drag_at(slide_roll),
    }
}

/// The errors of dμ/d ln θ of a friction coefficient at a slide-to-roll ratio, from those of F_v of each body, F_h and
/// P: what is made of several has the sum of their errors.
pub fn errors_of_derivatives(errors: &Sensitivities, column: Column, slide_roll: f64) -> [f64; 5] {
    // μ_h = S F_h + (1 − S) P and D = F_v,2 + S F_h − (1 + S) P
    let (own, ahead, against) = (slide_roll.abs(), (1.0 - slide_roll).abs(), (1.0 + slide_roll).abs());
    let of = |i: usize| {
        let (flat, h, p) = (errors.viscoelastic_flat[i], errors.hydrodynamic[i], errors.pressure[i]);
        let v = flat + errors.viscoelastic_roller[i];
        match column {
            Column::MuV => v,
            Column::MuH => own * h + ahead * p,
            Column::MuTot => v + own * h + ahead * p,
            Column::MuPressure => p,
            Column::MuShear => h + p,
            _ => flat + own * h + against * p,
        }
    };
    std::array::from_fn(of)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stribeck_lab::{Modulus, Motion, Roller};

    /// μ_v, μ_h and P, and what is made of them.
    fn friction(mu_v: f64, mu_h: f64, pressure: f64) -> Values {
        let mut values = Values::UNKNOWN;
        for (column, value) in
            FRICTION.into_iter().zip([mu_v, mu_h, mu_v + mu_h, mu_v + mu_h - 2.0 * pressure, pressure, mu_h - pressure])
        {
            values[column] = value;
        }
        values
    }

    /// Those of a flat alone.
    fn one_body(viscoelastic: [f64; 3], hydrodynamic: [f64; 3], pressure: [f64; 3]) -> Sensitivities {
        let [viscoelastic_flat, hydrodynamic, pressure] =
            [viscoelastic, hydrodynamic, pressure].map(|[alpha, beta, f]| [alpha, beta, f, 0.0, 0.0]);
        Sensitivities { viscoelastic_flat, viscoelastic_roller: [0.0; 5], hydrodynamic, pressure }
    }

    /// Twice the viscosity at half the speed is the same film at another α.
    #[test]
    fn speed_is_viscosity_and_retardation_time_together() {
        let experiment = Experiment {
            radius: 2e-3,
            load: 100.0,
            modulus: Modulus::Instantaneous(1e6),
            poisson_ratio: 0.3,
            viscosity: 1.0,
            retardation_time: 0.1,
            motion: Motion::Sliding { speed: 0.01 },
            f: 3.0,
            roller: Roller::RIGID,
            temperature: None,
        };
        let sensitivities = one_body([0.1, 0.2, 0.3], [0.4, -0.5, 0.6], [-0.1, 0.3, -0.2]);
        let names: Vec<String> = columns(Some(&experiment)).into_iter().map(|column| column.name).collect();
        let values = values([Some(sensitivities); 2], &friction(0.5, 0.25, -0.125), 1.0, Some(&experiment));
        assert_eq!(names.len(), values.len());
        let of = |mu: &str, input: &str| {
            values[names.iter().position(|name| *name == format!("dln_{mu}_dln_{input}")).expect(input)]
        };
        for mu in FRICTION.map(Column::name) {
            assert!((of(mu, "speed") - of(mu, "viscosity") - of(mu, "retardation_time")).abs() < 1e-15);
        }
        // dimensional analysis: nothing changes where all units of length change, or of mass, or of time
        for mu in FRICTION.map(Column::name) {
            let length = of(mu, "radius") - of(mu, "instantaneous_modulus") - of(mu, "viscosity") + of(mu, "speed");
            let mass = of(mu, "load") + of(mu, "instantaneous_modulus") + of(mu, "viscosity");
            let time = -2.0 * of(mu, "load") - 2.0 * of(mu, "instantaneous_modulus") - of(mu, "viscosity")
                + of(mu, "retardation_time")
                - of(mu, "speed");
            assert!(length.abs() < 1e-14 && mass.abs() < 1e-14 && time.abs() < 1e-14, "{mu} {length} {mass} {time}");
        }
        assert!((of("mu_v", "viscosity") + 0.4).abs() < 1e-15);
    }

    #[test]
    fn dimensionless_cases_have_their_own_derivatives() {
        let sensitivities = one_body([0.0; 3], [0.4, -0.5, 0.6], [-0.1, 0.2, -0.3]);
        let values = values([Some(sensitivities), None], &friction(0.0, 0.5, -0.25), 1.0, None);
        assert!(values[..3].iter().all(|value| value.is_nan()), "mu_v is 0");
        let rows =
            [[0.8, -1.0, 1.2], [0.8, -1.0, 1.2], [0.6, -0.9, 1.2], [0.4, -0.8, 1.2], [0.5 / 0.75, -0.7 / 0.75, 1.2]];
        for (value, expected) in values[3..18].iter().zip(rows.as_flattened()) {
            assert!((value - expected).abs() < 1e-15, "{values:?}");
        }
        assert_eq!(columns(None)[8].name, "dln_mu_tot_dln_f");
        assert!(values[18..].iter().all(|value| value.is_nan()), "no errors are known");
        assert!(super::values([None; 2], &Values::UNKNOWN, 1.0, None).iter().all(|value| value.is_nan()));
    }
    /// What is published is the largest change that errors of F_v, F_h and P can make together.
    #[test]
    fn errors_are_what_errors_of_the_parts_do_at_most() {
        let known = one_body([0.3, -0.2, 0.5], [0.4, -0.5, 0.6], [-0.1, 0.2, -0.3]);
        let errors = one_body([0.01; 3], [0.02; 3], [0.005; 3]);
        for slide_roll in [1.0, 0.3, -0.7] {
            let friction = friction(0.5, 0.25, -0.125);
            let of = |known| values([Some(known), Some(errors)], &friction, slide_roll, None);
            let exact = of(known);
            let mut largest = [0.0_f64; 18];
            for signs in 0..8 {
                let sign = |place: i32| if signs >> place & 1 == 0 { 1.0 } else { -1.0 };
                let moved =
                    |values: [f64; 5], error: [f64; 5], sign: f64| std::array::from_fn(|i| values[i] + sign * error[i]);
                let there = of(Sensitivities {
                    viscoelastic_flat: moved(known.viscoelastic_flat, errors.viscoelastic_flat, sign(0)),
                    viscoelastic_roller: [0.0; 5],
                    hydrodynamic: moved(known.hydrodynamic, errors.hydrodynamic, sign(1)),
                    pressure: moved(known.pressure, errors.pressure, sign(2)),
                });
                for (largest, (a, b)) in largest.iter_mut().zip(there.iter().zip(&exact)) {
                    *largest = largest.max((a - b).abs());
                }
            }
            for (place, (largest, error)) in largest.iter().zip(&exact[18..]).enumerate() {
                assert!((largest - error).abs() < 1e-12, "{place}: {largest} {error}");
            }
        }
    }
}
