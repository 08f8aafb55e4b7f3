//! What a mesh fixes, whatever the substrate: points, weights, and the elastic displacement (T7) at the points.

use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

use super::log_moments::{ELSEWHERE, LANES, MOST_MOMENTS, log_moments_together};
use super::mesh::Mesh;
use super::reference::ReferencePanel;
use crate::linear::{Matrix, wide};

/// A mesh with its points and the matrix of the elastic displacement.
///
/// Rows of the matrices of displacement are, in this order: the Gauss points behind the outlet, those of the film, the
/// ends of the film's panels, of which the outlet is the first, and the ends of the panels behind it. Columns are the
/// nodes of the pressure, from the outlet to Y; neighbouring panels share one.
#[derive(Debug)]
pub struct Discretisation {
    /// The panels.
    pub mesh: Arc<Mesh>,
    /// The reference panel of their degree.
    pub reference: Arc<ReferencePanel>,
    /// y of each row.
    pub points: Vec<f64>,
    /// Quadrature weights of the rows, 0 for ends.
    pub weights: Vec<f64>,
    /// Weight of each node in ∫ p dy.
    pub node_weights: Vec<f64>,
    /// e − e(0) at the rows from p at the nodes (T7), rows × nodes. Near the outlet it is far smaller than e, and only
    /// so are its digits kept.
    pub elastic: Matrix,
    /// e(0), at the outlet, from p at the nodes.
    pub elastic_at_outlet: Vec<f64>,
    /// Buffer: moments of the kernel, rows × degrees.
    moments: Matrix,
}

impl Discretisation {
    /// A discretisation without panels.
    pub fn new(reference: &Arc<ReferencePanel>) -> Self {
        Self {
            mesh: Mesh::new(reference.degree, 2.0, vec![0.0, 1.0]),
            reference: Arc::clone(reference),
            points: Vec::new(),
            weights: Vec::new(),
            node_weights: Vec::new(),
            elastic: Matrix::default(),
            elastic_at_outlet: Vec::new(),
            moments: Matrix::default(),
        }
    }

    /// Computes what depends on the mesh alone, in the memory of the mesh before.
    pub fn set_mesh(&mut self, mesh: &Arc<Mesh>) {
        let Self { reference, points, weights, node_weights, .. } = self;
        let degree = reference.degree;
        assert_eq!(degree, mesh.degree, "a mesh is made for one degree");
        points.clear();
        weights.clear();
        for ends in mesh.behind.windows(2).chain(mesh.film.windows(2)) {
            let (centre, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
            points.extend(reference.points.iter().map(|t| centre + half * t));
            weights.extend(reference.weights.iter().map(|weight| half * weight));
        }
        points.extend(mesh.film.iter().chain(&mesh.behind[..mesh.behind.len() - 1]));
        weights.resize(points.len(), 0.0);
        node_weights.clear();
        node_weights.resize(mesh.panels() * degree + 1, 0.0);
        for (panel, ends) in mesh.film.windows(2).enumerate() {
            for (j, weight) in reference.node_weights.iter().enumerate() {
                node_weights[panel * degree + j] += 0.5 * (ends[1] - ends[0]) * weight;
            }
        }
        self.mesh = Arc::clone(mesh);
        wide(
            #[inline(always)]
            || self.set_elastic_displacement(),
        );
    }

    /// Number of nodes of the pressure.
    pub fn nodes(&self) -> usize {
        self.node_weights.len()
    }

    /// Number of Gauss points of the film.
    pub fn film_points(&self) -> usize {
        self.nodes() - 1
    }

    /// The rows of the film.
    pub fn film(&self) -> Range<usize> {
        let behind = self.behind().end;
        behind..behind + self.film_points()
    }

    /// The rows behind the outlet.
    pub fn behind(&self) -> Range<usize> {
        0..(self.mesh.behind.len() - 1) * self.reference.degree
    }

    /// The rows of the ends of the film's panels, the outlet first.
    pub fn ends_of_film(&self) -> Range<usize> {
        self.outlet()..self.outlet() + self.mesh.film.len()
    }

    /// The row of the outlet.
    pub fn outlet(&self) -> usize {
        self.film().end
    }

    /// The rows of the left and the right end of a panel; panels are counted from the one furthest behind the outlet.
    pub fn ends(&self, panel: usize) -> (usize, usize) {
        let (behind, film) = (self.mesh.behind.len() - 1, self.mesh.film.len());
        let row = |end: usize| self.outlet() + if end < behind { film + end } else { end - behind };
        (row(panel), row(panel + 1))
    }

    /// The columns of a panel are the moments of the kernel for the Legendre polynomials on it (T31), times their
    /// coefficients.
    #[inline(always)]
    fn set_elastic_displacement(&mut self) {
        let Self { mesh, reference, points, elastic, moments, .. } = self;
        let (degree, rows) = (reference.degree, points.len());
        let size = degree + 1;
        elastic.reshape(rows, mesh.panels() * degree + 1);
        moments.reshape(rows, size);
        let first_film_row = (mesh.behind.len() - 1) * degree;
        let mut together = [[0.0; LANES]; MOST_MOMENTS + 1];
        for (panel, ends) in mesh.film.windows(2).enumerate() {
            let (centre, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
            let own = first_film_row + panel * degree..first_film_row + (panel + 1) * degree;
            for (block, y) in points.chunks(LANES).enumerate() {
                // rows of this panel are known, and a last block need not be full
                let places = std::array::from_fn(|lane| match y.get(lane) {
                    Some(y) if !own.contains(&(block * LANES + lane)) => (y - centre) / half,
                    _ => ELSEWHERE,
                });
                log_moments_together(&places, &mut together[..=size]);
                for (k, values) in together[..size].iter().enumerate() {
                    moments.column_mut(k)[block * LANES..][..y.len()].copy_from_slice(&values[..y.len()]);
                }
            }
            for k in 0..size {
                let values = &reference.own_log_moments[k * degree..(k + 1) * degree];
                moments.column_mut(k)[own.clone()].copy_from_slice(values);
            }
            // ln|y − s| = ln|t − t′| + ln half, and ∫ P_0 = 2
            for moment in moments.column_mut(0) {
                *moment += 2.0 * half.ln();
            }
            elastic.set_product(panel * degree, half / PI, moments, &reference.node_coefficients, panel > 0);
        }
        let outlet = self.outlet();
        self.elastic_at_outlet.clear();
        for j in 0..self.elastic.columns() {
            let column = self.elastic.column_mut(j);
            let at_outlet = column[outlet];
            self.elastic_at_outlet.push(at_outlet);
            for e in column {
                *e -= at_outlet;
            }
        }
    }

    /// The values of a vector over the rows at the Gauss points of a panel, and at its ends; panels are counted as for
    /// [`Discretisation::ends`].
    pub fn on_panel<'v>(&self, values: &'v [f64], panel: usize) -> (&'v [f64], [f64; 2]) {
        let degree = self.reference.degree;
        let (left, right) = self.ends(panel);
        (&values[panel * degree..(panel + 1) * degree], [values[left], values[right]])
    }

    /// y at the Gauss points of the film.
    pub fn film_y(&self) -> &[f64] {
        &self.points[self.film()]
    }
}

/// y at the Gauss points of the film of a mesh.
pub fn film_points<'a>(reference: &'a ReferencePanel, mesh: &'a Mesh) -> impl DoubleEndedIterator<Item = f64> + 'a {
    mesh.film.windows(2).flat_map(|ends| {
        let (centre, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
        reference.points.iter().map(move |t| centre + half * t)
    })
}
