//! The built-in table of solutions, from which cases without neighbours start.
//!
//! Its nodes are cases with one retardation time, about one a decade in α, in ā²β and in 1 + f. Those with f = 0 are
//! the same for all α. The example `starting_solutions` writes the table.
//!
//! The file is little-endian: the version of the results as `u32`, the place of each node as `u32`, the nodes. A node
//! is a number of panels `u32`; ā, c, x_out, the estimated error, the longest first panel, the largest p, the ends of
//! ln u, and the ends of the panels, as `f32`; p and ln u between their ends as `u16`.

use super::acceptance::Acceptance;
use super::adaptation::Panels;
use super::mesh::Mesh;
use super::scaling::Scaling;
use super::settings::Settings;
use super::solver::{AIM, CLOSE, CollocationSolver};
use super::state::State;
use super::{RESULTS_VERSION, Workspace};
use crate::continuation::{Chain, Interrupt, SolveContext, SolveError};
use crate::exact::DryContact;
use crate::model::{Output, Parameters};

/// The settings with which the nodes were solved.
pub const SOLVED_WITH: Settings = Settings { tolerance: 1e-5, degree: 8 };
/// f of the nodes.
const STRENGTHS: [f64; 6] = [0.0, 1.0, 10.0, 100.0, 1e3, 1e4];
/// lg α of the nodes with f > 0.
const ALPHAS: [i32; 8] = [-3, -2, -1, 0, 1, 2, 3, 4];
/// lg ā²β of the nodes.
const LOADS: [i32; 10] = [-2, -1, 0, 1, 2, 3, 4, 5, 6, 7];
/// How many nodes there are.
const NODES: usize = LOADS.len() * (1 + ALPHAS.len() * (STRENGTHS.len() - 1));
/// Numbers of a node before the ends of its panels.
const SCALARS: usize = 8;
/// The largest packed number.
const FULL: f64 = u16::MAX as f64;

static TABLE: &[u8] = include_bytes!("starting_solutions.bin");

/// A solution of the table.
pub struct Node {
    /// ā of its case.
    pub half_width: f64,
    /// β of its case.
    pub beta: f64,
    /// The solution on panels of the degree of [`SOLVED_WITH`].
    pub state: State,
    /// Its estimated error over the tolerance of [`SOLVED_WITH`].
    pub error: f64,
}

/// A place of the grid of nodes between the one before and the next: their indices, and the part of the way.
type Between = ([usize; 2], f64);

fn between(places: impl Iterator<Item = f64>, place: f64) -> Between {
    let places: Vec<f64> = places.collect();
    let right = places.partition_point(|&at| at <= place).clamp(1, places.len() - 1);
    let part = (place - places[right - 1]) / (places[right] - places[right - 1]);
    ([right - 1, right], part.clamp(0.0, 1.0))
}

/// The place of a node in the table.
fn index(strength: usize, alpha: usize, load: usize) -> usize {
    let column = if strength == 0 { 0 } else { 1 + (strength - 1) * ALPHAS.len() + alpha };
    column * LOADS.len() + load
}

/// α, ā²β and f of the nodes, in their order.
fn grid() -> impl Iterator<Item = (f64, f64, f64)> {
    let columns = STRENGTHS[1..].iter().flat_map(|&f| ALPHAS.iter().map(move |&alpha| (10_f64.powi(alpha), f)));
    let columns = [(f64::INFINITY, 0.0)].into_iter().chain(columns);
    columns.flat_map(|(alpha, f)| LOADS.iter().map(move |&load| (alpha, 10_f64.powi(load), f)))
}

/// The cases of the nodes, in their order.
pub fn cases() -> Vec<Parameters> {
    let case = |(alpha, load, f): (f64, f64, f64)| {
        let half_width = DryContact::new(alpha, f).half_width();
        Parameters::new(alpha, load / (half_width * half_width), f)
    };
    grid().map(case).collect()
}

/// The nodes around a case with one retardation time and ā as its half width, with the weights of a linear
/// interpolation in ln α, ln ā²β and ln(1 + f). A case beyond the table has the nodes of its edge.
pub fn around(case: &Parameters, half_width: f64) -> Vec<(usize, f64)> {
    let strength = between(STRENGTHS.iter().map(|f| f.ln_1p()), case.f.ln_1p());
    let alpha = between(ALPHAS.iter().map(|&lg| f64::from(lg)), case.alpha.log10());
    let load = between(LOADS.iter().map(|&lg| f64::from(lg)), (half_width * half_width * case.beta).log10());
    let weighted = |(places, part): Between| [(places[0], 1.0 - part), (places[1], part)];
    let mut nodes: Vec<(usize, f64)> = Vec::with_capacity(8);
    for (i, of_strength) in weighted(strength) {
        for (j, of_alpha) in weighted(alpha) {
            for (k, of_load) in weighted(load) {
                let (node, weight) = (index(i, j, k), of_strength * of_alpha * of_load);
                match nodes.iter_mut().find(|(known, _)| *known == node) {
                    Some((_, sum)) => *sum += weight,
                    None if weight > 0.0 => nodes.push((node, weight)),
                    None => {}
                }
            }
        }
    }
    nodes
}

/// Whether the table belongs to this version of the results; else it is not used.
pub fn is_present() -> bool {
    TABLE.get(..4) == Some(RESULTS_VERSION.to_le_bytes().as_slice())
}

/// A node of the table, its panels behind the outlet growing by `growth`.
pub fn node(index: usize, growth: f64) -> Node {
    let (_, load, _) = grid().nth(index).expect("a node of the grid");
    let mut reader = Reader(&TABLE[4 + 4 * index..]);
    reader = Reader(&TABLE[reader.whole() as usize..]);
    let panels = reader.whole() as usize;
    let scalars: [f64; SCALARS] = std::array::from_fn(|_| reader.real());
    let [half_width, c, outlet, error, outlet_panel, largest, thinnest, thickest] = scalars;
    let ends = (0..=panels).map(|_| reader.real()).collect();
    let points = panels * SOLVED_WITH.degree;
    let pressure = (0..=points).map(|_| largest * reader.part()).collect();
    let film = (0..points).map(|_| (thinnest + (thickest - thinnest) * reader.part()).exp()).collect();
    let mesh = Mesh::new(SOLVED_WITH.degree, growth, ends);
    let state = State { mesh, pressure, film, c, outlet, error: None, outlet_panel };
    Node { half_width, beta: load / (half_width * half_width), state, error }
}

/// Numbers read one after the other.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn bytes<const N: usize>(&mut self) -> [u8; N] {
        let (bytes, rest) = self.0.split_first_chunk().expect("the table is whole");
        self.0 = rest;
        *bytes
    }

    fn whole(&mut self) -> u32 {
        u32::from_le_bytes(self.bytes())
    }

    fn real(&mut self) -> f64 {
        f64::from(f32::from_le_bytes(self.bytes()))
    }

    /// From 0 to 1.
    fn part(&mut self) -> f64 {
        f64::from(u16::from_le_bytes(self.bytes())) / FULL
    }
}

/// The table made of the solutions at the nodes, each with ā.
pub fn pack(nodes: &[(f64, State)]) -> Vec<u8> {
    assert_eq!(nodes.len(), NODES, "one solution for each node");
    let mut places = RESULTS_VERSION.to_le_bytes().to_vec();
    let mut packed = Vec::new();
    for (half_width, state) in nodes {
        places.extend(((4 + 4 * NODES + packed.len()) as u32).to_le_bytes());
        packed.extend((state.mesh.panels() as u32).to_le_bytes());
        let extremes = |(least, most): (f64, f64), number: f64| (least.min(number), most.max(number));
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let (_, largest) = state.pressure.iter().copied().fold(none, extremes);
        let logarithms = state.film.iter().map(|u| u.ln());
        let (thinnest, thickest) = logarithms.clone().fold(none, extremes);
        let error = state.error.expect("the errors of a node are known");
        let scalars = [*half_width, state.c, state.outlet, error, state.outlet_panel, largest, thinnest, thickest];
        for number in scalars.iter().chain(&state.mesh.film) {
            packed.extend((*number as f32).to_le_bytes());
        }
        let films = logarithms.map(|ln| (ln - thinnest) / (thickest - thinnest));
        for part in state.pressure.iter().map(|p| p / largest).chain(films) {
            packed.extend(((part.clamp(0.0, 1.0) * FULL).round() as u16).to_le_bytes());
        }
    }
    [places, packed].concat()
}

impl CollocationSolver {
    /// The table of starting solutions, made anew by marches: for the example that writes it.
    ///
    /// # Panics
    /// If a node has no solution.
    pub fn starting_solutions() -> Vec<u8> {
        let solver = Self::new(SOLVED_WITH).marching();
        let nodes: Vec<(f64, State)> = cases().iter().map(|case| solver.node(case)).collect();
        pack(&nodes)
    }

    /// ā of a node, and its solution on panels that are neither too many nor too few.
    fn node(&self, case: &Parameters) -> (f64, State) {
        const MOST_MESHES: usize = 8;
        let (output, interrupt) = (Output::numbers(), Interrupt::new());
        let mut context = SolveContext::new(&interrupt);
        let mut chain = Chain::new(self, &output, &interrupt);
        let outcome = chain.solve(case).expect("nobody interrupts").outcome;
        assert!(outcome.is_ok(), "{case:?}: {outcome:?}");
        let (workspace, _, state) = chain.last().expect("it is solved");
        let mut state = state.clone();
        for _ in 0..MOST_MESHES {
            let error = state.error.expect("it is evaluated");
            if (0.5 * AIM..=CLOSE).contains(&error) {
                break;
            }
            let panels = self.panels(state.mesh.panels(), error);
            match self.on_panels(workspace, case, &state, panels, &mut context) {
                Ok(Some(other)) => state = other,
                _ => break,
            }
        }
        (workspace.half_width(), state)
    }

    /// The solution on another number of panels, if it is accepted.
    fn on_panels(
        &self,
        workspace: &mut Workspace,
        case: &Parameters,
        state: &State,
        panels: usize,
        context: &mut SolveContext,
    ) -> Result<Option<State>, SolveError> {
        let reach = self.reach(Scaling::new(workspace.half_width(), case.beta));
        let mut state = self.remeshed(case, state, Panels::Number(panels), reach);
        self.correct(workspace, case.beta, &mut state, context)?;
        let solved = (case, &state);
        let (acceptance, _) = Acceptance::of(workspace, solved, &Output::numbers(), SOLVED_WITH.tolerance, context);
        Ok(acceptance.is_accepted().then_some(State { error: Some(acceptance.error), ..state }))
    }
}

#[cfg(test)]
mod tests {
    use rayon::prelude::*;

    use super::*;

    /// The committed table belongs to this version of the solver: each node is the solution, as well as its tolerance
    /// and sixteen bits tell. If this fails, run the example `starting_solutions`.
    #[test]
    fn the_table_is_what_the_solver_makes() {
        assert!(is_present() && TABLE.len() < 300_000, "{} bytes", TABLE.len());
        let solver = CollocationSolver::new(SOLVED_WITH).marching();
        cases().par_iter().enumerate().for_each(|(index, case)| {
            let known = node(index, 2.0);
            let (half_width, state) = solver.node(case);
            assert!((known.half_width / half_width - 1.0).abs() < 1e-6);
            assert!((known.beta / case.beta - 1.0).abs() < 1e-6);
            assert!((known.state.c / state.c - 1.0).abs() < 2.0 * SOLVED_WITH.tolerance, "{case:?}: {:e}", state.c);
            let thinnest = |state: &State| state.film.iter().fold(state.c, |least, &u| least.min(u));
            let largest = |state: &State| state.pressure.iter().fold(0.0, |most: f64, &p| most.max(p));
            assert!((thinnest(&known.state) / thinnest(&state) - 1.0).abs() < 1e-2, "{case:?}");
            assert!((largest(&known.state) / largest(&state) - 1.0).abs() < 1e-2, "{case:?}");
        });
    }

    /// At a node the interpolation is the node, and weights add up to 1 everywhere.
    #[test]
    fn weights_are_those_of_an_interpolation() {
        for (index, case) in cases().iter().enumerate() {
            let half_width = DryContact::new(case.alpha, case.f).half_width();
            let heaviest = around(case, half_width).into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).expect("a node");
            assert!(heaviest.0 == index && heaviest.1 > 1.0 - 1e-12, "{case:?}: {heaviest:?}");
        }
        for alpha in [0.0, 1e-9, 0.3, 1e9, f64::INFINITY] {
            for (beta, f) in [(1e-9, 0.0), (3e3, 0.2), (1e12, 1e9)] {
                let nodes = around(&Parameters::new(alpha, beta, f), 0.7);
                let sum: f64 = nodes.iter().map(|(_, weight)| weight).sum();
                assert!((sum - 1.0).abs() < 1e-12 && nodes.iter().all(|&(index, _)| index < NODES), "{nodes:?}");
            }
        }
    }
}
