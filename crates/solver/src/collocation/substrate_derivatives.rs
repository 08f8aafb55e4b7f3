//! Derivatives of the displacement of a given pressure with respect to the substrate, and transposed sums over the
//! displacement.

use super::displacement::{Along, Displacement};
use super::retardation_derivatives::FilterDerivatives;
use super::retardation_transpose::Taken;

/// Derivatives of the displacement of one pressure along the mesh with respect to the logarithm of a parameter.
pub struct DisplacementDerivatives {
    /// Derivatives of w − w(0) at the film's Gauss points.
    pub film: Vec<f64>,
    /// Derivatives of Σ f_j/(1+f) v_j′ at the same points.
    pub retarded_slope: Vec<f64>,
    /// Derivatives of w − w(0) at the Gauss points behind the outlet.
    pub behind: Vec<f64>,
}

impl Displacement {
    /// Derivatives with respect to ln α, all modes' rates together (T50); 0 without retardation. `along` is that of the
    /// pressure, what is behind the outlet included.
    pub fn derivatives_with_alpha(&self, pressure: &[f64], along: &Along) -> DisplacementDerivatives {
        let discretisation = &self.discretisation;
        let points = discretisation.film_points();
        let mut sum = DisplacementDerivatives {
            film: vec![0.0; points],
            retarded_slope: vec![0.0; points],
            behind: vec![0.0; discretisation.behind().len()],
        };
        if self.filters.is_empty() {
            return sum;
        }
        let derivatives = self.filter_derivatives.get_or_init(|| {
            self.filters.iter().map(|(_, filter)| FilterDerivatives::new(discretisation, filter.alpha())).collect()
        });
        for ((weight, filter), derivatives) in self.filters.iter().zip(derivatives) {
            let mode = derivatives.along(filter, discretisation, &along.elastic, pressure);
            let pairs =
                [(&mut sum.film, mode.film), (&mut sum.retarded_slope, mode.slope), (&mut sum.behind, mode.behind)];
            for (sum, values) in pairs {
                for (sum, value) in sum.iter_mut().zip(values) {
                    *sum += weight * value;
                }
            }
        }
        sum
    }

    /// Derivatives with respect to ln f at fixed shares: (w − e)/(1 + f), and the retarded part alike (T51); 0 in the
    /// relaxed elastic limit.
    pub fn derivatives_with_f(&self, pressure: &[f64], along: &Along) -> DisplacementDerivatives {
        let discretisation = &self.discretisation;
        let mut displaced = vec![0.0; discretisation.film_points()];
        self.relative.multiply_rows(0, pressure, &mut displaced);
        let (e, compliance) = (&along.elastic, self.elastic_weight);
        let retarded = |w: &[f64], e: &[f64]| w.iter().zip(e).map(|(w, e)| compliance * (w - e)).collect();
        DisplacementDerivatives {
            film: retarded(&displaced, &e[discretisation.film()]),
            retarded_slope: along.retarded_slope.iter().map(|slope| compliance * slope).collect(),
            behind: retarded(&along.behind, &e[discretisation.behind()]),
        }
    }

    /// What Σ `slope` Σ_j f_j/(1+f) v_j′ over the film's Gauss points and Σ `behind` (w − w(0)) over those behind the
    /// outlet take of p at the nodes. Either may be empty.
    pub fn transposed(&self, slope: &[f64], behind: &[f64]) -> Vec<f64> {
        let discretisation = &self.discretisation;
        let mut e: Vec<f64> = behind.iter().map(|weight| self.elastic_weight * weight).collect();
        e.resize(discretisation.points.len(), 0.0);
        let mut pressure = vec![0.0; discretisation.nodes()];
        for (weight, filter) in &self.filters {
            let weighted = |values: &[f64]| values.iter().map(|value| weight * value).collect::<Vec<f64>>();
            let mut slope = weighted(slope);
            slope.resize(discretisation.film_points(), 0.0);
            let taken = Taken { e: &mut e, pressure: &mut pressure };
            filter.transposed(discretisation, &slope, &weighted(behind), taken);
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

    fn two_modes(alpha: f64, f: f64) -> DisplacementKernel {
        let modes = [(0.7, 1.0), (0.3, 100.0)].map(|(share, time)| RetardationMode { share, time });
        let substrate = Substrate::new(modes.to_vec()).expect("shares add up to 1");
        DisplacementKernel::new(&Parameters { substrate, ..Parameters::new(alpha, 1.0, f) })
    }

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
        displacement.relative.multiply_rows(0, pressure, &mut film);
        let along = displacement.along(pressure, true);
        DisplacementDerivatives { film, retarded_slope: along.retarded_slope, behind: along.behind }
    }

    /// The derivatives are those of the discrete displacement, against differences of fourth order on the same mesh.
    #[test]
    fn rates_are_derivatives_of_the_displacement() {
        for alpha in [1e-3, 0.3, 4.0, 1e3] {
            let f = 20.0;
            let here = displacement(&two_modes(alpha, f));
            let p = pressure(&here);
            let along = here.along(&p, true);
            let step = 1e-3_f64;
            let difference = |at: &dyn Fn(f64) -> DisplacementKernel| {
                let at = |steps: f64| values(&displacement(&at((steps * step).exp())), &p);
                let (near, far) = ([at(1.0), at(-1.0)], [at(2.0), at(-2.0)]);
                let of = |part: fn(&DisplacementDerivatives) -> &Vec<f64>| -> Vec<f64> {
                    let values = |derivatives: &DisplacementDerivatives, i: usize| part(derivatives)[i];
                    (0..part(&near[0]).len())
                        .map(|i| {
                            (8.0 * (values(&near[0], i) - values(&near[1], i)) - values(&far[0], i)
                                + values(&far[1], i))
                                / (12.0 * step)
                        })
                        .collect()
                };
                DisplacementDerivatives {
                    film: of(|derivatives| &derivatives.film),
                    retarded_slope: of(|derivatives| &derivatives.retarded_slope),
                    behind: of(|derivatives| &derivatives.behind),
                }
            };
            let pairs = [
                (here.derivatives_with_alpha(&p, &along), difference(&|factor| two_modes(alpha * factor, f))),
                (here.derivatives_with_f(&p, &along), difference(&|factor| two_modes(alpha, f * factor))),
            ];
            for (derivatives, differences) in pairs {
                let parts = [
                    (derivatives.film, differences.film),
                    (derivatives.retarded_slope, differences.retarded_slope),
                    (derivatives.behind, differences.behind),
                ];
                for (part, (derivatives, differences)) in parts.into_iter().enumerate() {
                    let largest = derivatives.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                    for (derivative, difference) in derivatives.iter().zip(&differences) {
                        let error = (derivative - difference).abs();
                        assert!(error < 1e-8 * largest.max(1e-3), "α {alpha}, {part}: {derivative:e} {difference:e}");
                    }
                }
            }
        }
    }

    /// ⟨a, A p⟩ = ⟨Aᵀ a, p⟩ for the retarded slope and for the displacement behind the outlet.
    #[test]
    fn the_filter_backwards_is_its_transpose() {
        for alpha in [1e-3, 0.3, 4.0, 1e3] {
            let displacement = displacement(&two_modes(alpha, 20.0));
            let p = pressure(&displacement);
            let DisplacementDerivatives { retarded_slope, behind, .. } = values(&displacement, &p);
            let weights =
                |count: usize, phase: f64| -> Vec<f64> { (0..count).map(|i| (phase + 1.7 * i as f64).sin()).collect() };
            let (a, b) = (weights(retarded_slope.len(), 0.3), weights(behind.len(), 1.1));
            for (a, b) in [(&a[..], &b[..]), (&a[..], &[]), (&[], &b[..])] {
                let terms = a.iter().zip(&retarded_slope).chain(b.iter().zip(&behind)).map(|(x, y)| x * y);
                let (forward, size) = terms.fold((0.0, 0.0), |(sum, size): (f64, f64), x| (sum + x, size + x.abs()));
                let backward = dot(&displacement.transposed(a, b), &p);
                assert!((forward - backward).abs() < 1e-12 * size, "α {alpha}: {forward:e} {backward:e}");
            }
        }
    }
}
