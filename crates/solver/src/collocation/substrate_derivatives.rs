//! Derivatives of the displacement of a given pressure with respect to the substrate, and transposed sums over the
//! displacement.

use super::discretisation::Discretisation;
use super::displacement::{Along, Body, Displacement};
use super::retardation_derivatives::FilterDerivatives;
use super::retardation_transpose::Taken;

/// Derivatives of the displacement of one pressure along the mesh with respect to the logarithm of a parameter.
#[derive(Clone)]
pub struct DisplacementDerivatives {
    /// Derivatives of w − w(0) at the film's Gauss points.
    pub film: Vec<f64>,
    /// Derivatives of Σ f_j/(1+f) v_j′ of the flat and of the roller at the same points.
    pub retarded_slopes: [Vec<f64>; 2],
    /// Derivatives of w − w(0) at the Gauss points behind the outlet.
    pub behind: Vec<f64>,
}

impl DisplacementDerivatives {
    fn none(discretisation: &Discretisation) -> Self {
        let film = vec![0.0; discretisation.film_points()];
        let retarded_slopes = [film.clone(), film.clone()];
        Self { film, retarded_slopes, behind: vec![0.0; discretisation.behind().len()] }
    }

    /// All less those of a part.
    fn less(&self, part: &Self) -> Self {
        let less = |all: &[f64], part: &[f64]| all.iter().zip(part).map(|(all, part)| all - part).collect();
        Self {
            film: less(&self.film, &part.film),
            retarded_slopes: std::array::from_fn(|i| less(&self.retarded_slopes[i], &part.retarded_slopes[i])),
            behind: less(&self.behind, &part.behind),
        }
    }
}

impl Displacement {
    /// Derivatives with respect to ln α of a body, the rates of all of its modes together (T50); 0 without retardation
    /// of it. `along` is that of the pressure, what is behind the outlet included.
    pub fn derivatives_with_alpha(&self, body: Body, pressure: &[f64], along: &Along) -> DisplacementDerivatives {
        let discretisation = &self.discretisation;
        let mut sum = DisplacementDerivatives::none(discretisation);
        let modes = self.modes(body);
        if modes.is_empty() {
            return sum;
        }
        let derivatives = self.filter_derivatives.get_or_init(|| {
            self.filters.iter().map(|(_, filter)| FilterDerivatives::new(discretisation, filter.alpha())).collect()
        });
        for ((weight, filter), derivatives) in self.filters[modes.clone()].iter().zip(&derivatives[modes]) {
            let mode = derivatives.along(filter, discretisation, &along.elastic, pressure);
            let slope = &mut sum.retarded_slopes[body as usize];
            let pairs = [(&mut sum.film, mode.film), (slope, mode.slope), (&mut sum.behind, mode.behind)];
            for (sum, values) in pairs {
                for (sum, value) in sum.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        }
        sum
    }

    /// Derivatives with respect to ln f_i of flat and roller at fixed shares of its modes (T51); 0 in the relaxed
    /// elastic limit. Together they are (w − e)/(1 + f), and the retarded parts alike.
    pub fn derivatives_with_f(&self, pressure: &[f64], along: &Along) -> [DisplacementDerivatives; 2] {
        let discretisation = &self.discretisation;
        let mut displaced = vec![0.0; discretisation.film_points()];
        self.relative.multiply(pressure, &mut displaced);
        let (e, compliance) = (&along.elastic, self.elastic_weight);
        let retarded = |w: &[f64], e: &[f64]| w.iter().zip(e).map(|(w, e)| compliance * (w - e)).collect();
        let scaled = |slope: Vec<f64>| slope.iter().map(|slope| compliance * slope).collect();
        let both = DisplacementDerivatives {
            film: retarded(&displaced, &e[discretisation.film()]),
            retarded_slopes: Body::BOTH.map(|body| scaled(along.slope(body))),
            behind: retarded(&along.behind, &e[discretisation.behind()]),
        };
        let none = || DisplacementDerivatives::none(discretisation);
        match Body::BOTH.map(|body| self.modes(body).is_empty()) {
            [_, true] => [both, none()],
            [true, false] => [none(), both],
            [false, false] => {
                let roller = self.derivatives_with_f_of_roller(pressure, along, &displaced);
                [both.less(&roller), roller]
            }
        }
    }

    /// With respect to ln f_1: w_1 − g w, w_1 being the retarded part of w that is of the roller and g = f_1/(1+f) the
    /// sum of its weights. `displaced` is w − w(0) at the film's Gauss points.
    fn derivatives_with_f_of_roller(
        &self,
        pressure: &[f64],
        along: &Along,
        displaced: &[f64],
    ) -> DisplacementDerivatives {
        let discretisation = &self.discretisation;
        let modes = &self.filters[self.modes(Body::Roller)];
        let part: f64 = modes.iter().map(|(weight, _)| weight).sum();
        let mut own = vec![0.0; discretisation.points.len()];
        for (weight, filter) in modes {
            for (sum, v) in own.iter_mut().zip(filter.on_rows(discretisation, &along.elastic, pressure)) {
                *sum += weight * v;
            }
        }
        let less = |own: &[f64], w: &[f64]| own.iter().zip(w).map(|(own, w)| own - part * w).collect();
        let [flat, roller] = Body::BOTH.map(|body| along.slope(body));
        DisplacementDerivatives {
            film: less(&own[discretisation.film()], displaced),
            retarded_slopes: [flat.iter().map(|slope| -part * slope).collect(), less(&roller, &roller)],
            behind: less(&own[discretisation.behind()], &along.behind),
        }
    }

    /// What Σ_i Σ `slopes`_i Σ_j f_ij/(1+f) v_ij′ of flat and roller over the film's Gauss points and Σ `behind` (w −
    /// w(0)) over those behind the outlet take of p at the nodes. Each may be empty.
    pub fn transposed(&self, slopes: &[Vec<f64>; 2], behind: &[f64]) -> Vec<f64> {
        let discretisation = &self.discretisation;
        let mut e: Vec<f64> = behind.iter().map(|weight| self.elastic_weight * weight).collect();
        e.resize(discretisation.points.len(), 0.0);
        let mut pressure = vec![0.0; discretisation.nodes()];
        for (body, slope) in Body::BOTH.into_iter().zip(slopes) {
            if slope.is_empty() && behind.is_empty() {
                continue;
            }
            for (weight, filter) in &self.filters[self.modes(body)] {
                let weighted = |values: &[f64]| values.iter().map(|value| weight * value).collect::<Vec<f64>>();
                let mut slope = weighted(slope);
                slope.resize(discretisation.film_points(), 0.0);
                let taken = Taken { e: &mut e, pressure: &mut pressure };
                filter.transposed(discretisation, &slope, &weighted(behind), taken);
            }
        }
        discretisation.elastic.add_transposed(&e, &mut pressure);
        pressure
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::mesh::Mesh;
    use super::super::reference::{ReferencePanel, dot};
    use super::super::timings::Timings;
    use super::*;
    use crate::model::{DisplacementKernel, Parameters, RetardationMode, Substrate};

    /// Two modes, of f and of times 1 and 100 over that in α, the second of the roller.
    fn two_modes(alpha: [f64; 2], f: [f64; 2]) -> DisplacementKernel {
        let whole = f[0] + f[1];
        let mode = |i: usize, time: f64| vec![RetardationMode { share: f[i] / whole, time: time / alpha[i] }];
        let substrate = Substrate::of_two_bodies(mode(0, 1.0), mode(1, 100.0)).expect("shares add up to 1");
        DisplacementKernel::new(&Parameters { substrate, ..Parameters::new(1.0, 1.0, whole) })
    }

    const STRENGTHS: [f64; 2] = [14.0, 6.0];

    /// Panels from far shorter to far longer than 1/α.
    fn displacement(kernel: &DisplacementKernel) -> Displacement {
        let mut displacement = Displacement::new(&Arc::new(ReferencePanel::new(8)));
        let ends = vec![0.0, 1e-3, 0.01, 0.1, 0.3, 0.6, 1.0, 1.5, 2.5, 5.0, 12.0, 40.0];
        displacement.set_mesh(&Mesh::new(8, 3.0, ends), kernel, &mut Timings::default());
        displacement
    }

    fn pressure(displacement: &Displacement) -> Vec<f64> {
        let discretisation = &displacement.discretisation;
        let nodes = discretisation.mesh.film.windows(2).flat_map(|ends| {
            let (centre, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
            discretisation.reference.nodes[1..].iter().map(move |t| centre + half * t)
        });
        std::iter::once(0.0).chain(nodes).map(|y| y * y / (1.0 + y * y) / (1.0 + (y / 2.0).powi(6))).collect()
    }

    fn values(displacement: &Displacement, pressure: &[f64]) -> DisplacementDerivatives {
        let mut film = vec![0.0; displacement.discretisation.film_points()];
        displacement.relative.multiply(pressure, &mut film);
        let along = displacement.along(pressure, true);
        let retarded_slopes = Body::BOTH.map(|body| along.slope(body));
        DisplacementDerivatives { film, retarded_slopes, behind: along.behind }
    }

    /// The derivatives are those of the discrete displacement, against differences of fourth order on the same mesh.
    #[test]
    fn rates_are_derivatives_of_the_displacement() {
        for alpha in [1e-3, 0.3, 4.0, 1e3] {
            let here = displacement(&two_modes([alpha; 2], STRENGTHS));
            let p = pressure(&here);
            let along = here.along(&p, true);
            let step = 1e-3_f64;
            let difference = |at: &dyn Fn(f64) -> DisplacementKernel| {
                let at = |steps: f64| all(&values(&displacement(&at((steps * step).exp())), &p));
                let ([near, left], [far, farther]) = ([at(1.0), at(-1.0)], [at(2.0), at(-2.0)]);
                let of = |part: usize, i: usize| {
                    (8.0 * (near[part][i] - left[part][i]) - far[part][i] + farther[part][i]) / (12.0 * step)
                };
                std::array::from_fn(|part| (0..near[part].len()).map(|i| of(part, i)).collect())
            };
            for (i, body) in Body::BOTH.into_iter().enumerate() {
                let with = |value: [f64; 2], factor: f64| {
                    std::array::from_fn(|body| if body == i { value[body] * factor } else { value[body] })
                };
                let derivatives =
                    [here.derivatives_with_alpha(body, &p, &along), here.derivatives_with_f(&p, &along)[i].clone()];
                let differences: [[Vec<f64>; 4]; 2] = [
                    difference(&|factor| two_modes(with([alpha; 2], factor), STRENGTHS)),
                    difference(&|factor| two_modes([alpha; 2], with(STRENGTHS, factor))),
                ];
                for (derivatives, differences) in derivatives.iter().zip(&differences) {
                    for (part, (derivatives, differences)) in all(derivatives).iter().zip(differences).enumerate() {
                        let largest = derivatives.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                        for (derivative, difference) in derivatives.iter().zip(differences) {
                            let error = (derivative - difference).abs();
                            assert!(
                                error < 1e-8 * largest.max(1e-3),
                                "α {alpha}, {body:?}, {part}: {derivative:e} {difference:e}"
                            );
                        }
                    }
                }
            }
        }
    }

    /// Film, slopes of flat and roller, and behind the outlet.
    fn all(derivatives: &DisplacementDerivatives) -> [Vec<f64>; 4] {
        let DisplacementDerivatives { film, retarded_slopes: [flat, roller], behind } = derivatives.clone();
        [film, flat, roller, behind]
    }

    /// ⟨a, A p⟩ = ⟨Aᵀ a, p⟩ for the retarded slope of each body and for the displacement behind the outlet.
    #[test]
    fn the_filter_backwards_is_its_transpose() {
        for alpha in [1e-3, 0.3, 4.0, 1e3] {
            let displacement = displacement(&two_modes([alpha; 2], STRENGTHS));
            let p = pressure(&displacement);
            let [_, flat, roller, behind] = all(&values(&displacement, &p));
            let weights =
                |count: usize, phase: f64| -> Vec<f64> { (0..count).map(|i| (phase + 1.7 * i as f64).sin()).collect() };
            let (a, b, c) = (weights(flat.len(), 0.3), weights(roller.len(), 0.7), weights(behind.len(), 1.1));
            for kept in 1..8 {
                let [a, b, c] = [&a, &b, &c].map(Clone::clone);
                let keep = |place: usize, of: Vec<f64>| if kept >> place & 1 == 1 { of } else { Vec::new() };
                let (a, b, c) = (keep(0, a), keep(1, b), keep(2, c));
                let pairs = a.iter().zip(&flat).chain(b.iter().zip(&roller)).chain(c.iter().zip(&behind));
                let terms = pairs.map(|(x, y)| x * y);
                let (forward, size) = terms.fold((0.0, 0.0), |(sum, size): (f64, f64), x| (sum + x, size + x.abs()));
                let backward = dot(&displacement.transposed(&[a, b], &c), &p);
                assert!((forward - backward).abs() < 1e-12 * size, "α {alpha}: {forward:e} {backward:e}");
            }
        }
    }
}
