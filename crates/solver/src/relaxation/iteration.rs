//! The iteration: film, pass, load balance.

use std::f64::consts::PI;

use super::deformation::{Deformation, DeformationSpace};
use super::far_field::FarField;
use super::parabola::{parabola, vertex};
use super::reynolds::{self, PassSpace, Relaxation};
use super::stiffness::HALF_WIDTHS;
use super::{Grid, State};
use crate::model::{DisplacementKernel, Parameters};

/// Passes between two load balances, n_h of the paper.
pub const PASSES_PER_BALANCE: usize = 5;
/// λ_h1 of Eq. 43 over c.
pub const LOAD_GAIN: f64 = 0.1;

/// The matrices that all cases of one (α, f) share on one grid; computed once per chain.
pub struct Discretisation {
    /// The grid.
    pub grid: Grid,
    /// Displacement on the grid.
    pub deformation: Deformation,
    /// The inlet film ahead of the grid.
    pub ahead: FarField,
    /// The cavity behind the grid.
    pub behind: FarField,
    /// On which body hysteresis works.
    pub hysteresis: Hysteresis,
    /// The constant taken off the kernel; see [`DisplacementKernel::levelled`].
    level: f64,
    /// x_i²/2.
    parabola: Vec<f64>,
}

impl Discretisation {
    /// The kernel of (α, f) on a grid.
    pub fn new(parameters: &Parameters, grid: Grid) -> Self {
        let kernel = levelled_kernel(parameters, &grid);
        Self {
            level: kernel.level(),
            hysteresis: Hysteresis::new(&kernel, &grid),
            deformation: Deformation::new(&kernel, &grid),
            ahead: FarField::ahead(&kernel, &grid),
            behind: FarField::behind(&kernel, &grid),
            parabola: (0..grid.points).map(|i| 0.5 * grid.x(i) * grid.x(i)).collect(),
            grid,
        }
    }
}

/// The bodies that hysteresis works on.
pub enum Hysteresis {
    /// The flat, or none.
    Flat,
    /// The roller.
    Roller,
    /// Both: the displacement of the roller on the grid and ahead of it, but for what does no work.
    Both(Box<(Deformation, FarField)>),
}

impl Hysteresis {
    fn new(kernel: &DisplacementKernel, grid: &Grid) -> Self {
        match kernel.roller_beside_flat() {
            Some(roller) => Self::Both(Box::new((Deformation::new(&roller, grid), FarField::ahead(&roller, grid)))),
            None if kernel.of_roller() > 0 => Self::Roller,
            None => Self::Flat,
        }
    }
}

/// The kernel whose level is zero at about half a width of the contact.
pub fn levelled_kernel(parameters: &Parameters, grid: &Grid) -> DisplacementKernel {
    DisplacementKernel::new(parameters).levelled((grid.x_max - grid.x_min) / HALF_WIDTHS)
}

/// How far an iterate is from the solution of the discrete equations; NaN never passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residuals {
    /// See [`reynolds::flow_residual`].
    pub flow: f64,
    /// Load over π/2, minus 1 (T4); positive if the pressure carries too much.
    pub load: f64,
}

impl Residuals {
    /// The larger of the two.
    pub fn largest(&self) -> f64 {
        if self.flow.is_nan() { f64::NAN } else { self.flow.max(self.load.abs()) }
    }

    /// True if both are at most `tolerance`.
    pub fn within(&self, tolerance: f64) -> bool {
        self.flow <= tolerance && self.load.abs() <= tolerance
    }
}

/// The state of the iteration for one case: arrays of n points.
pub struct Iteration<'a> {
    /// The matrices that the case shares with others.
    pub shared: &'a Discretisation,
    /// β.
    pub beta: f64,
    /// p, n values; the last stands for the tail ahead of the grid too.
    pub p: Vec<f64>,
    /// u of `p` and `separation`, after [`Iteration::update_film`].
    pub u: Vec<f64>,
    /// w of `p` but for [`Iteration::level`], after [`Iteration::update_film`].
    pub w: Vec<f64>,
    /// h₀ but for [`Iteration::level`].
    pub separation: f64,
    /// Load of the film ahead of the grid.
    pub tail_load: f64,
    /// Number of passes done.
    pub passes: u64,
    /// True if `space` holds the convolution of the present `p`.
    convolved: bool,
    space: DeformationSpace,
    pass_space: PassSpace,
}

impl<'a> Iteration<'a> {
    /// An iteration that starts from a state on the same grid.
    pub fn new(shared: &'a Discretisation, beta: f64, state: &State) -> Self {
        let n = shared.grid.points;
        let mut iteration = Self {
            shared,
            beta,
            p: vec![0.0; n],
            u: vec![0.0; n],
            w: vec![0.0; n],
            separation: 0.0,
            tail_load: 0.0,
            passes: 0,
            convolved: false,
            space: shared.deformation.space(),
            pass_space: PassSpace::new(n),
        };
        iteration.restore(state);
        iteration
    }

    /// Goes back to a state.
    pub fn restore(&mut self, state: &State) {
        self.tail_load = state.tail_load;
        self.replace(&state.pressure, state.separation);
    }

    /// Goes on from another pressure and h₀, with the film that belongs to them.
    pub fn replace(&mut self, pressure: &[f64], separation: f64) {
        self.p.copy_from_slice(pressure);
        self.separation = separation;
        self.convolved = false;
        self.update_film();
    }

    /// The present state.
    pub fn state(&self) -> State {
        let mut state = State { pressure: vec![0.0; self.p.len()], separation: 0.0, tail_load: 0.0, c: 0.0 };
        self.save(&mut state);
        state
    }

    /// Keeps the present state in `state`, without allocating.
    pub fn save(&self, state: &mut State) {
        state.pressure.copy_from_slice(&self.p);
        state.separation = self.separation;
        state.tail_load = self.tail_load;
        state.c = self.c();
    }

    /// The film of the present pressure, u = h₀ + x²/2 − w (T3).
    pub fn update_film(&mut self) {
        let deformation = &self.shared.deformation;
        if !self.convolved {
            deformation.convolve(&self.p, &mut self.space);
            self.convolved = true;
        }
        deformation.assemble(self.p[self.p.len() - 1], self.tail_load, &mut self.w, &self.space);
        for ((u, parabola), w) in self.u.iter_mut().zip(&self.shared.parabola).zip(&self.w) {
            *u = self.separation + parabola - w;
        }
    }

    /// One pass with the film of the pressure before it.
    pub fn pass(&mut self, relaxation: Relaxation) {
        self.update_film();
        let dx = self.shared.grid.spacing();
        reynolds::pass(&mut self.p, &self.u, self.beta, dx, relaxation, &mut self.pass_space);
        self.convolved = false;
        self.passes += 1;
    }

    /// The passes up to and with one load balance, Eq. 43 with λ_h1 = `gain` times c: the map whose fixed point is the
    /// solution. It leaves the film of the last pass behind, which is that of the pressure before it.
    pub fn round(&mut self, relaxation: Relaxation, gain: f64) {
        for _ in 0..PASSES_PER_BALANCE {
            self.pass(relaxation);
        }
        self.update_inlet();
        // Eq. 43, signed: too much load raises h₀
        self.separation += gain * self.c() * self.load_residual();
    }

    /// The film at the largest pressure: c, where the pressure is near its solution. A continuous function of the
    /// state: taken at the nearest point it would jump, and the iteration with it.
    pub fn c(&self) -> f64 {
        let i = index_of_largest(&self.p).clamp(1, self.p.len() - 2);
        let t = vertex(&self.p[i - 1..=i + 1]);
        parabola(&self.u[i - 1..=i + 1], t)
    }

    /// Smallest film thickness on the grid.
    pub fn film_min(&self) -> f64 {
        self.u.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The part of h₀ and w that the iteration leaves out of both: the level of the kernel times load/π.
    pub fn level(&self) -> f64 {
        self.shared.level * self.load() / PI
    }

    /// ∫ p dx, the tail included.
    fn load(&self) -> f64 {
        let last = self.p.len() - 1;
        let sum = self.p.iter().sum::<f64>() - 0.5 * self.p[last];
        sum * self.shared.grid.spacing() + self.tail_load
    }

    /// (load − π/2)/(π/2) (T4).
    pub fn load_residual(&self) -> f64 {
        self.load() / (0.5 * PI) - 1.0
    }

    /// Residuals of the present state, whose film must be up to date.
    pub fn residuals(&self) -> Residuals {
        let dx = self.shared.grid.spacing();
        let flow = reynolds::flow_residual(&self.p, &self.u, self.beta, dx, self.c());
        Residuals { flow, load: self.load_residual() }
    }

    /// The pressure at the end of the grid and the load beyond it, from T2 with the film there:
    /// p(X) = ∫_X^∞ (u − c)/(βu³) dx, load ∫_X^∞ (x − X)(u − c)/(βu³) dx.
    fn update_inlet(&mut self) {
        let (c, end) = (self.c(), self.shared.grid.x_max);
        let (mut pressure, mut load) = (0.0, 0.0);
        for (x, weight, u) in self.film_ahead() {
            let gradient = weight * (u - c) / (self.beta * u.powi(3));
            pressure += gradient;
            load += gradient * (x - end);
        }
        let last = self.p.len() - 1;
        self.p[last] = pressure.max(0.0);
        self.tail_load = load.max(0.0);
    }

    /// (x, quadrature weight, u) ahead of the grid.
    pub fn film_ahead(&self) -> impl Iterator<Item = (f64, f64, f64)> {
        self.film_of(&self.shared.ahead)
    }

    /// (x, quadrature weight, u) behind the grid.
    pub fn film_behind(&self) -> impl Iterator<Item = (f64, f64, f64)> {
        self.film_of(&self.shared.behind)
    }

    fn film_of(&self, field: &FarField) -> impl Iterator<Item = (f64, f64, f64)> {
        (0..field.x.len()).map(|q| {
            let x = field.x[q];
            (x, field.weight[q], self.separation + 0.5 * x * x - field.displacement(q, &self.p, self.tail_load))
        })
    }
}

/// The index of the largest value.
pub fn index_of_largest(values: &[f64]) -> usize {
    (0..values.len()).fold(0, |best, i| if values[i] > values[best] { i } else { best })
}
