//! The displacement (T9) on a mesh, for one substrate.

use std::cell::OnceCell;
use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

use super::discretisation::Discretisation;
use super::inlet::Inlet;
use super::mesh::Mesh;
use super::reference::{ReferencePanel, dot};
use super::retardation::{RetardationFilter, far_field};
use super::retardation_derivatives::FilterDerivatives;
use super::timings::{Timings, timed};
use crate::linear::Matrix;
use crate::model::{DisplacementKernel, gauss, retarded_mode};

/// One of the two bodies of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// The flat, whose modes come first.
    Flat,
    /// The roller.
    Roller,
}

impl Body {
    /// Both, in the order of their modes.
    pub const BOTH: [Self; 2] = [Self::Flat, Self::Roller];
}

/// The displacement of a mesh as a matrix on the pressure, relative to the outlet, and the quantities that follow from
/// it; for all cases with the same mesh, α and f.
pub struct Displacement {
    /// The mesh it is for.
    pub discretisation: Discretisation,
    /// w less w(0) at the film's Gauss points from p at the nodes (T9), points × nodes. The film near the outlet
    /// differs from c by far less than w from 0, and only so is the difference known.
    pub relative: Matrix,
    /// w(0), at the outlet, from p at the nodes.
    outlet: Vec<f64>,
    /// Buffer.
    retarded_outlet: Vec<f64>,
    /// f_j/(1+f) of each mode, with its filter.
    pub(super) filters: Vec<(f64, RetardationFilter)>,
    /// How many of the filters, the last ones, are the roller's.
    of_roller: usize,
    /// Derivatives of the filters with respect to α, computed when they are first asked for.
    pub(super) filter_derivatives: OnceCell<Vec<FilterDerivatives>>,
    /// Weight of e in w.
    pub(super) elastic_weight: f64,
}

/// The quantities along the mesh that follow from the displacement of one solution.
pub struct Along {
    /// e less e(0) at the rows; all 0 where nothing below needs it.
    pub elastic: Vec<f64>,
    /// Σ f_j/(1+f) v_j′ at the film's Gauss points, the part of w′ that does work; all 0 without retardation.
    pub retarded_slope: Vec<f64>,
    /// The roller's part of it; empty without retardation of the roller.
    pub roller_slope: Vec<f64>,
    /// w less w(0) at the Gauss points behind the outlet, if wanted.
    pub behind: Vec<f64>,
}

impl Along {
    /// The part of `retarded_slope` that is of a body.
    pub fn slope(&self, body: Body) -> Vec<f64> {
        match (body, self.roller_slope.as_slice()) {
            (Body::Roller, []) => vec![0.0; self.retarded_slope.len()],
            (Body::Roller, roller) => roller.to_vec(),
            (Body::Flat, []) => self.retarded_slope.clone(),
            (Body::Flat, roller) => {
                self.retarded_slope.iter().zip(roller).map(|(both, roller)| both - roller).collect()
            }
        }
    }
}

impl Displacement {
    /// A displacement without panels.
    pub fn new(reference: &Arc<ReferencePanel>) -> Self {
        Self {
            discretisation: Discretisation::new(reference),
            relative: Matrix::default(),
            outlet: Vec::new(),
            retarded_outlet: Vec::new(),
            filters: Vec::new(),
            of_roller: 0,
            filter_derivatives: OnceCell::new(),
            elastic_weight: 1.0,
        }
    }

    /// Computes the displacement on a mesh, in the memory of the mesh before.
    pub fn set_mesh(&mut self, mesh: &Arc<Mesh>, kernel: &DisplacementKernel, timings: &mut Timings) {
        timed(&mut timings.kernel, || self.discretisation.set_mesh(mesh));
        timed(&mut timings.filter, || self.set_substrate(kernel));
    }

    /// Filters the elastic displacement of the mesh for a substrate.
    pub fn set_substrate(&mut self, kernel: &DisplacementKernel) {
        let Self {
            discretisation,
            relative,
            outlet,
            retarded_outlet,
            filters,
            of_roller,
            filter_derivatives,
            elastic_weight,
        } = self;
        *of_roller = kernel.of_roller();
        *elastic_weight = kernel.singular_weight();
        filters.clear();
        filter_derivatives.take();
        relative.copy_scaled(&discretisation.elastic, discretisation.film(), *elastic_weight);
        outlet.clear();
        outlet.extend(discretisation.elastic_at_outlet.iter().map(|e| *elastic_weight * e));
        for &(weight, alpha) in kernel.retarded() {
            let filter = RetardationFilter::new(discretisation, alpha);
            filter.add_to(discretisation, weight, relative, retarded_outlet);
            for ((w, e), difference) in outlet.iter_mut().zip(&discretisation.elastic_at_outlet).zip(&*retarded_outlet)
            {
                *w += weight * (e + difference);
            }
            filters.push((weight, filter));
        }
    }

    /// The filters of a body.
    pub fn modes(&self, body: Body) -> Range<usize> {
        let of_flat = self.filters.len() - self.of_roller;
        match body {
            Body::Flat => 0..of_flat,
            Body::Roller => of_flat..self.filters.len(),
        }
    }

    /// w(0), the displacement at the outlet, from p at the nodes.
    pub fn at_outlet(&self, pressure: &[f64]) -> f64 {
        dot(&self.outlet, pressure)
    }

    /// The quantities along the mesh that follow from p at the nodes.
    pub fn along(&self, pressure: &[f64], behind: bool) -> Along {
        let discretisation = &self.discretisation;
        let mut e = vec![0.0; discretisation.points.len()];
        if behind || !self.filters.is_empty() {
            discretisation.elastic.multiply(pressure, &mut e);
        }
        let places = if behind { discretisation.behind() } else { 0..0 };
        let mut retarded_slope = vec![0.0; discretisation.film_points()];
        let mut roller_slope = vec![0.0; if self.of_roller > 0 { retarded_slope.len() } else { 0 }];
        let of_roller = self.modes(Body::Roller);
        let mut displaced: Vec<f64> = e[places].iter().map(|e| self.elastic_weight * e).collect();
        for (mode, (weight, filter)) in self.filters.iter().enumerate() {
            let (slope, outlet) = filter.slope(discretisation, &e, pressure);
            if of_roller.contains(&mode) {
                for (sum, slope) in roller_slope.iter_mut().zip(&slope) {
                    *sum += weight * slope;
                }
            }
            for (sum, slope) in retarded_slope.iter_mut().zip(slope) {
                *sum += weight * slope;
            }
            if behind {
                for (w, v) in displaced.iter_mut().zip(filter.behind(discretisation, &e, outlet)) {
                    *w += weight * v;
                }
            }
        }
        Along { elastic: e, retarded_slope, roller_slope, behind: displaced }
    }

    /// w of the load ahead of the mesh, which is so far away that it displaces all of the contact alike: it is a part
    /// of h₀ and w that no film knows of. The pressure ahead falls as x⁻³.
    pub fn of_load_ahead(&self, inlet: &Inlet) -> f64 {
        inlet.load / PI * gauss::mean(0.0, 1.0, |t| 2.0 * t * self.kernel(-inlet.start / t))
    }

    /// w less w(0) at all rows, from p at the nodes.
    pub fn on_rows(&self, pressure: &[f64]) -> Vec<f64> {
        let discretisation = &self.discretisation;
        let mut e = vec![0.0; discretisation.points.len()];
        discretisation.elastic.multiply(pressure, &mut e);
        let mut displacement: Vec<f64> = e.iter().map(|e| self.elastic_weight * e).collect();
        for (weight, filter) in &self.filters {
            for (w, v) in displacement.iter_mut().zip(filter.on_rows(discretisation, &e, pressure)) {
                *w += weight * v;
            }
        }
        displacement
    }

    /// w at a place beyond either end of the mesh, from p at the nodes.
    pub fn beyond(&self, pressure: &[f64], y: f64) -> f64 {
        dot(&far_field(&self.discretisation, y, |x| self.kernel(x)), pressure)
    }

    /// π times the displacement of a load of 1 from x to the right of it, but for a constant (T9).
    fn kernel(&self, x: f64) -> f64 {
        let retarded = self.filters.iter().map(|(weight, filter)| weight * retarded_mode(filter.alpha(), x));
        self.elastic_weight * x.abs().ln() + retarded.sum::<f64>()
    }
}
