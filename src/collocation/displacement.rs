//! The displacement (T9) on a mesh, for one substrate.

use std::sync::Arc;

use super::discretisation::Discretisation;
use super::matrix::Matrix;
use super::retardation::RetardationFilter;
use crate::model::DisplacementKernel;

/// w and the part of w′ that does work, both as matrices on the pressure; for all cases with the same mesh, α and f.
pub struct Displacement {
    /// The mesh it is for.
    pub discretisation: Arc<Discretisation>,
    /// w at the rows from p at the nodes (T9), rows × nodes.
    pub matrix: Matrix,
    /// Σ f_j/(1+f) (v_j′ − e′ f-part) as it enters F_v: Σ f_j α_j/(1+f) (v_j − e) at the film's rows, film points × nodes;
    /// `None` without retardation, where nothing dissipates.
    pub retarded_slope: Option<Matrix>,
    filters: Vec<(f64, RetardationFilter)>,
    elastic_weight: f64,
}

impl Displacement {
    /// Filters the elastic displacement of a mesh.
    pub fn new(discretisation: Arc<Discretisation>, kernel: &DisplacementKernel) -> Self {
        let elastic_weight = kernel.singular_weight();
        let mut matrix = Matrix::default();
        matrix.reset(discretisation.elastic.rows(), discretisation.elastic.columns());
        for j in 0..matrix.columns() {
            for (w, e) in matrix.column_mut(j).iter_mut().zip(discretisation.elastic.column(j)) {
                *w = elastic_weight * e;
            }
        }
        let film = discretisation.film();
        let mut retarded_slope = None;
        let mut retarded = Matrix::default();
        let mut filters = Vec::with_capacity(kernel.retarded().len());
        for &(weight, alpha) in kernel.retarded() {
            let filter = RetardationFilter::new(&discretisation, alpha);
            filter.apply(&discretisation, &mut retarded);
            let slope = retarded_slope.get_or_insert_with(|| Matrix::zeros(film.len(), matrix.columns()));
            for j in 0..matrix.columns() {
                let v = retarded.column(j);
                for (w, v) in matrix.column_mut(j).iter_mut().zip(v) {
                    *w += weight * v;
                }
                let e = &discretisation.elastic.column(j)[film.clone()];
                for ((slope, v), e) in slope.column_mut(j).iter_mut().zip(&v[film.clone()]).zip(e) {
                    *slope += weight * alpha * (v - e);
                }
            }
            filters.push((weight, filter));
        }
        Self { discretisation, matrix, retarded_slope, filters, elastic_weight }
    }

    /// w at any places from p at the nodes.
    pub fn interpolate(&self, pressure: &[f64], places: &[f64]) -> Vec<f64> {
        let discretisation = &self.discretisation;
        let mut displacement = discretisation.elastic_at(pressure, places);
        for w in &mut displacement {
            *w *= self.elastic_weight;
        }
        if !self.filters.is_empty() {
            let mut e = vec![0.0; discretisation.points.len()];
            discretisation.elastic.multiply_rows(0, pressure, &mut e);
            for (weight, filter) in &self.filters {
                let retarded = filter.interpolate(discretisation, &e, pressure, places);
                for (w, v) in displacement.iter_mut().zip(retarded) {
                    *w += weight * v;
                }
            }
        }
        displacement
    }
}
