//! The transposed system: how a number of a solution answers a small violation of each equation.

use super::displacement::Displacement;
use super::friction_partials::Partials;
use super::inlet::Inlet;
use super::inlet_partials::InletPartials;
use super::state::State;
use super::system::System;
use crate::linear::Factorisation;

/// The linearised equations of a solution, factorised.
///
/// Unlike in Newton's method p(Y) = p_inlet is an equation of its own, and the inlet's derivatives with respect to c
/// and u are in it, so that nothing of the discrete equations is left out. With u eliminated, g the gap of the inlet
/// and its derivatives as indices,
///
/// ```text
///             δp (m·d)                   δc              δx_out
///   ┌                                                                       ┐
///   │  βu²D − a∘W                       3βp′u            a y                │  flow / u (T2)
///   │  node weights − L_g W_m           L_c + L_g       −p(X) − L_g x_out   │  load (T4)
///   │  (0 … 0 1) + P_g W_m             −P_c − P_g       −p′(X) + P_g x_out  │  p(Y) (T33)
///   └                                                                       ┘
/// ```
///
/// L being the load ahead, P its pressure and W_m the last row of W.
pub struct Adjoint<'a> {
    displacement: &'a Displacement,
    state: &'a State,
    system: &'a System,
    factors: &'a mut Factorisation,
    inlet: Inlet,
    partials: InletPartials,
    beta: f64,
}

/// The response of a number of a solution to a residual of each equation, with the sign that makes it grow by
/// −(multiplier) times what a parameter adds to the residual.
pub struct Multipliers {
    /// Multipliers of flow/u at the film's Gauss points.
    pub flow: Vec<f64>,
    /// Multiplier of the load.
    pub load: f64,
    /// Multiplier of p(Y) less the pressure of the inlet.
    pub end: f64,
    /// Multipliers of u less the right side of the film equation at the film's Gauss points.
    pub film: Vec<f64>,
}

impl<'a> Adjoint<'a> {
    /// Factorises the equations about a solution. Both buffers are used for it.
    pub fn new(
        system: &'a mut System,
        factors: &'a mut Factorisation,
        displacement: &'a Displacement,
        beta: f64,
        state: &'a State,
    ) -> Self {
        system.linearise(displacement, beta, state);
        let inlet = *system.inlet();
        let partials = InletPartials::new(&inlet, beta, state.c);
        let mut adjoint = Self { displacement, state, system, factors, inlet, partials, beta };
        adjoint.assemble();
        adjoint.factors.factorise();
        adjoint
    }

    fn assemble(&mut self) {
        let Self { displacement, state, system, factors, inlet, partials, beta } = self;
        let discretisation = &displacement.discretisation;
        let points = discretisation.film_points();
        let (load, end) = (points, points + 1);
        let (gap, c) = (&partials.gap, &partials.c);
        let matrix = &mut factors.matrix;
        matrix.reshape(points + 2, points + 2);
        for node in 1..=points {
            let displaced = displacement.relative.column(node)[points - 1];
            let column = matrix.column_mut(node - 1);
            system.set_node(displacement, *beta, state, node, 1.0, &mut column[..points]);
            column[load] = discretisation.node_weights[node] - gap.load * displaced;
            column[end] = f64::from(u8::from(node == points)) + gap.pressure * displaced;
        }
        let column = matrix.column_mut(points);
        for ((entry, a), u) in column.iter_mut().zip(system.stiffness()).zip(&state.film) {
            *entry = a - 1.0 / u;
        }
        column[load] = c.load + gap.load;
        column[end] = -c.pressure - gap.pressure;
        let column = matrix.column_mut(points + 1);
        for ((entry, a), y) in column.iter_mut().zip(system.stiffness()).zip(discretisation.film_y()) {
            *entry = a * y;
        }
        column[load] = -inlet.pressure - gap.load * state.outlet;
        column[end] = -inlet.gradient + gap.pressure * state.outlet;
    }

    /// The multipliers of a number with these partial derivatives (T49).
    pub fn multipliers(&mut self, of: &Partials) -> Multipliers {
        let discretisation = &self.displacement.discretisation;
        let (points, y) = (discretisation.film_points(), discretisation.film_y());
        let mut right_side = of.of_nodes(self.displacement);
        let weights: Vec<f64> = of.film.iter().map(|weight| -weight).collect();
        self.displacement.relative.add_transposed(&weights, &mut right_side);
        // p is 0 at the outlet, whatever happens
        right_side.remove(0);
        right_side.push(of.c + of.film.iter().sum::<f64>());
        right_side.push(of.outlet + of.film.iter().zip(y).map(|(weight, y)| weight * y).sum::<f64>());
        self.factors.solve_transposed(&mut right_side);

        let (load, end) = (right_side[points], right_side[points + 1]);
        let mut flow = right_side;
        flow.truncate(points);
        let mut film: Vec<f64> = flow.iter().zip(self.system.stiffness()).map(|(flow, a)| -flow * a).collect();
        for (sum, weight) in film.iter_mut().zip(&of.film) {
            *sum += weight;
        }
        film[points - 1] += end * self.partials.gap.pressure - load * self.partials.gap.load;
        Multipliers { flow, load, end, film }
    }

    /// Derivative with respect to ln β, which is in the flow and in the film ahead: all of its integrals are as 1/β.
    pub fn with_beta(&self, of: &Partials, multipliers: &Multipliers) -> f64 {
        let Multipliers { flow, load, end, .. } = multipliers;
        let in_flow: f64 = flow.iter().zip(self.flow_pressure()).map(|(flow, pressure)| flow * pressure).sum();
        of.ln_beta - in_flow + load * self.inlet.load - end * self.inlet.pressure
    }

    /// β p′ u² at the film's Gauss points.
    fn flow_pressure(&self) -> impl Iterator<Item = f64> {
        let films = self.state.film.iter();
        self.system.gradient().iter().zip(films).map(|(gradient, u)| self.beta * gradient * u * u)
    }
}
