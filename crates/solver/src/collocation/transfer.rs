//! Carrying a state from one mesh to another.

use std::sync::Arc;

use super::discretisation::film_points;
use super::log_moments::MOST_MOMENTS;
use super::mesh::Mesh;
use super::reference::{ReferencePanel, evaluate};
use super::state::State;

impl State {
    /// The same state on other panels: p and ln u by their polynomials. (Linear interpolation of p would be an error of
    /// the size of the film.) Beyond the old mesh p falls as x^{−3}, and u grows as x²/2.
    pub fn on(&self, reference: &ReferencePanel, mesh: &Arc<Mesh>) -> Self {
        self.with_degree(reference, reference, mesh)
    }

    /// [`State::on`] from panels of one degree to panels of another.
    pub fn with_degree(&self, reference: &ReferencePanel, of_mesh: &ReferencePanel, mesh: &Arc<Mesh>) -> Self {
        let mut onto = Self {
            mesh: Arc::clone(mesh),
            pressure: Vec::new(),
            film: Vec::new(),
            c: self.c,
            outlet: self.outlet,
            error: None,
            outlet_panel: self.outlet_panel,
        };
        self.interpolate(reference, of_mesh, &mut onto);
        onto
    }

    fn interpolate(&self, reference: &ReferencePanel, of_mesh: &ReferencePanel, onto: &mut Self) {
        let (degree, size) = (reference.degree, reference.degree + 1);
        let reach = self.mesh.reach();
        let mut coefficients = [0.0; MOST_MOMENTS];
        let mut current = usize::MAX;
        let old = (self.pressure[self.pressure.len() - 1], self.film[self.film.len() - 1]);
        let last_x = self.outlet + film_points(reference, &self.mesh).next_back().expect("a mesh has panels");

        onto.pressure.push(0.0);
        for ends in onto.mesh.film.windows(2) {
            for t in &of_mesh.nodes[1..] {
                let y = at(ends, *t);
                if y > reach {
                    onto.pressure.push(old.0 * ((self.outlet + reach) / (self.outlet + y)).powi(3));
                    continue;
                }
                let (panel, t) = self.mesh.locate(y);
                if panel != current {
                    let nodes = &self.pressure[panel * degree..panel * degree + size];
                    reference.coefficients_of_nodes(nodes, &mut coefficients[..size]);
                    current = panel;
                }
                onto.pressure.push(evaluate(&coefficients[..size], t));
            }
        }
        current = usize::MAX;
        for ends in onto.mesh.film.windows(2) {
            for t in &of_mesh.points {
                let y = at(ends, *t);
                if y > reach {
                    onto.film.push(old.1 + 0.5 * ((self.outlet + y).powi(2) - last_x * last_x));
                    continue;
                }
                let (panel, t) = self.mesh.locate(y);
                if panel != current {
                    let mut logarithms = [0.0; MOST_MOMENTS];
                    for (ln, u) in logarithms.iter_mut().zip(&self.film[panel * degree..(panel + 1) * degree]) {
                        *ln = u.ln();
                    }
                    reference.coefficients_of_points(&logarithms[..degree], &mut coefficients[..degree]);
                    current = panel;
                }
                onto.film.push(evaluate(&coefficients[..degree], t).exp());
            }
        }
    }

    /// The state with all lengths along x multiplied by a factor, at the same load: p over it, films by its square.
    pub fn scaled(&self, factor: f64) -> Self {
        let film = self.mesh.film.iter().map(|end| factor * end).collect();
        Self {
            mesh: Mesh::new(self.mesh.degree, self.mesh.growth, film),
            pressure: self.pressure.iter().map(|p| p / factor).collect(),
            film: self.film.iter().map(|u| u * factor * factor).collect(),
            c: self.c * factor * factor,
            outlet: self.outlet * factor,
            error: None,
            outlet_panel: self.outlet_panel,
        }
    }
}

impl State {
    /// Adds a factor times the difference of two states, all on meshes with as many panels; films and flows as
    /// logarithms.
    pub fn add_difference(&mut self, factor: f64, of: &Self, from: &Self) {
        for (p, (of, from)) in self.pressure.iter_mut().zip(of.pressure.iter().zip(&from.pressure)) {
            *p += factor * (of - from);
        }
        for (u, (of, from)) in self.film.iter_mut().zip(of.film.iter().zip(&from.film)) {
            *u *= (of / from).powf(factor);
        }
        self.c *= (of.c / from.c).powf(factor);
        self.outlet += factor * (of.outlet - from.outlet);
    }
}

/// The place on a panel.
fn at(ends: &[f64], t: f64) -> f64 {
    0.5 * (ends[0] + ends[1]) + 0.5 * (ends[1] - ends[0]) * t
}

#[cfg(test)]
mod tests {
    use super::super::displacement::Displacement;
    use super::super::thick_film;
    use super::super::timings::Timings;
    use super::*;
    use crate::model::{DisplacementKernel, Parameters};

    /// A thick film with panels of degree 7, and what displaces it.
    fn thick_film() -> (Displacement, DisplacementKernel, State) {
        let mut displacement = Displacement::new(&Arc::new(ReferencePanel::new(7)));
        let kernel = DisplacementKernel::new(&Parameters::elastic(1.0));
        displacement.set_mesh(&thick_film::mesh(7, 3.0, 1.0, 300.0), &kernel, &mut Timings::default());
        let state = thick_film::state(&displacement, 1.0);
        (displacement, kernel, state)
    }

    #[test]
    fn a_finer_mesh_holds_the_same_polynomials() {
        let (displacement, _, state) = thick_film();
        let reference = &displacement.discretisation.reference;
        let ends = &state.mesh.film;
        let halved = ends.windows(2).flat_map(|ends| [ends[0], 0.5 * (ends[0] + ends[1])]).chain([state.mesh.reach()]);
        let there = state.on(reference, &Mesh::new(7, 3.0, halved.collect()));
        let back = there.on(reference, &state.mesh);
        let largest = state.pressure.iter().fold(0.0, |a: f64, b| a.max(*b));
        for (before, after) in state.pressure.iter().zip(&back.pressure) {
            assert!((before - after).abs() < 1e-13 * largest);
        }
        for (before, after) in state.film.iter().zip(&back.film) {
            assert!((after / before - 1.0).abs() < 1e-11);
        }
    }

    #[test]
    fn stretching_keeps_the_load() {
        let (mut displacement, kernel, state) = thick_film();
        let stretched = state.scaled(3.0);
        let load = |displacement: &Displacement, state: &State| -> f64 {
            let weights = &displacement.discretisation.node_weights;
            weights.iter().zip(&state.pressure).map(|(weight, p)| weight * p).sum()
        };
        let before = load(&displacement, &state);
        displacement.set_mesh(&stretched.mesh, &kernel, &mut Timings::default());
        assert!((load(&displacement, &stretched) / before - 1.0).abs() < 1e-14);
    }
}
