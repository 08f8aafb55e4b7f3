//! Lists of points in any order: cut into chains of neighbours, and solved chain by chain.

use std::cmp::Ordering;
use std::ops::RangeInclusive;

#[cfg(feature = "rayon")]
use rayon::prelude::*;

use crate::continuation::{Interrupt, Interrupted, SolvedCase, distance};
use crate::model::Parameters;
use crate::solve::{Settings, Solver};

/// The most points that a chain may have, for few points and for many: many in a chain, so that the first one's cost is
/// shared; few, so that there is work for many threads.
const LONGEST_CHAIN: RangeInclusive<usize> = 16..=64;
/// Chains that there are work enough with for any number of threads.
const ENOUGH_CHAINS: usize = 128;
/// A neighbour is of use up to this factor in α, β or 1 + f; from farther away a case is solved as quickly from its own
/// start.
const FARTHEST_FACTOR: f64 = 1000.0;

/// Solves points in any order: any mixture of substrates and parameters, equal points among them. The results are in
/// the order of the points.
///
/// The points are cut into chains, in which β ascends and each point is the nearest one to the point before it. The
/// chains depend on the set of points alone: neither their order nor the number of threads changes a number. With the
/// feature `rayon` the chains are solved in parallel, by the current pool of threads.
///
/// # Errors
/// [`Interrupted`] if the user asks to stop before the last point is done. A point that fails is a result.
pub fn solve_points(
    points: &[Parameters],
    settings: &Settings,
    interrupt: &Interrupt,
) -> Result<Vec<SolvedCase>, Interrupted> {
    let solver = Solver::new(settings);
    let order = in_order(points);
    let groups = equal_points(&order, points);
    let chains = chains_of_groups(&groups, points, &solver, interrupt)?;
    let solve = |chain: &Vec<usize>| {
        let chain: Vec<Parameters> = chain.iter().map(|&case| points[groups[case][0]].clone()).collect();
        solver.solve_chain(&chain, interrupt)
    };
    #[cfg(feature = "rayon")]
    let solved: Result<Vec<_>, Interrupted> = chains.par_iter().map(solve).collect();
    #[cfg(not(feature = "rayon"))]
    let solved: Result<Vec<_>, Interrupted> = chains.iter().map(solve).collect();

    let mut results = vec![None; points.len()];
    for (&case, solved) in chains.iter().flatten().zip(solved?.into_iter().flatten()) {
        for &point in groups[case] {
            results[point] = Some(solved.clone());
        }
    }
    Ok(results.into_iter().map(|result| result.expect("each point is in a chain")).collect())
}

/// The chains in which [`solve_points`] solves points: their places, each chain in the order in which it is solved. Of
/// equal points the first one stands for all.
pub fn point_chains(points: &[Parameters], settings: &Settings) -> Vec<Vec<usize>> {
    let order = in_order(points);
    let groups = equal_points(&order, points);
    let chains = chains_of_groups(&groups, points, &Solver::new(settings), &Interrupt::new());
    let chains = chains.expect("nobody interrupts");
    chains.into_iter().map(|chain| chain.into_iter().map(|case| groups[case][0]).collect()).collect()
}

/// The places of points in their order; of equal points those that come first do so here too.
fn in_order(points: &[Parameters]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| compare(&points[a], &points[b]));
    order
}

/// Equal points are one case.
fn equal_points<'a>(order: &'a [usize], points: &[Parameters]) -> Vec<&'a [usize]> {
    order.chunk_by(|&a, &b| compare(&points[a], &points[b]).is_eq()).collect()
}

fn chains_of_groups(
    groups: &[&[usize]],
    points: &[Parameters],
    solver: &Solver,
    interrupt: &Interrupt,
) -> Result<Vec<Vec<usize>>, Interrupted> {
    let cases: Vec<&Parameters> = groups.iter().map(|group| &points[group[0]]).collect();
    chains_of_neighbours(&cases, |from, to| solver.can_continue(from, to), interrupt)
}

/// A total order of cases, by β first.
fn compare(a: &Parameters, b: &Parameters) -> Ordering {
    let numbers = |of: &Parameters| {
        let modes = of.substrate.modes().iter().flat_map(|mode| [mode.share, mode.time]);
        [of.beta, of.alpha, of.f].into_iter().chain(modes).chain([of.substrate.of_roller() as f64]).collect::<Vec<_>>()
    };
    let (a, b) = (numbers(a), numbers(b));
    let differing = a.iter().zip(&b).map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne());
    differing.unwrap_or(a.len().cmp(&b.len()))
}

/// Cuts cases, which ascend in β, into chains: each case is followed by the nearest one left that has no smaller β,
/// unless that one has a nearer case to follow.
fn chains_of_neighbours(
    cases: &[&Parameters],
    can_continue: impl Fn(&Parameters, &Parameters) -> bool,
    interrupt: &Interrupt,
) -> Result<Vec<Vec<usize>>, Interrupted> {
    let mut search = Neighbours { cases, taken: vec![false; cases.len()], can_continue };
    let longest = (cases.len() / ENOUGH_CHAINS).clamp(*LONGEST_CHAIN.start(), *LONGEST_CHAIN.end());
    let mut chains = Vec::new();
    for first in 0..cases.len() {
        let (mut chain, mut next) = (Vec::new(), (!search.taken[first]).then_some(first));
        while let Some(case) = next {
            if interrupt.requested() {
                return Err(Interrupted);
            }
            search.taken[case] = true;
            chain.push(case);
            next = search.successor(case);
        }
        chains.extend(chain.chunks(longest).map(<[usize]>::to_vec));
    }
    Ok(chains)
}

/// Cases in ascending β, and which of them are in a chain.
struct Neighbours<'a, F> {
    cases: &'a [&'a Parameters],
    taken: Vec<bool>,
    can_continue: F,
}

impl<F: Fn(&Parameters, &Parameters) -> bool> Neighbours<'_, F> {
    /// The nearest case left that can follow a case; `None` if there is none within [`FARTHEST_FACTOR`].
    fn successor(&self, case: usize) -> Option<usize> {
        let (mut nearest, mut least) = (None, FARTHEST_FACTOR.ln());
        for other in case + 1..self.cases.len() {
            // β ascends: all others are farther away.
            if self.betas_apart(case, other) >= least {
                break;
            }
            let Some(away) = self.distance(case, other).filter(|away| *away < least) else { continue };
            if !self.taken[other] && !self.has_nearer_predecessor(other, away) {
                (nearest, least) = (Some(other), away);
            }
        }
        nearest
    }

    /// Whether a case left can be followed by `case` and is nearer to it than `away`.
    fn has_nearer_predecessor(&self, case: usize, away: f64) -> bool {
        let near = (0..case).rev().take_while(|&other| self.betas_apart(other, case) < away);
        let mut left = near.filter(|&other| !self.taken[other]);
        left.any(|other| self.distance(other, case).is_some_and(|distance| distance < away))
    }

    /// ln of the ratio of β.
    fn betas_apart(&self, from: usize, to: usize) -> f64 {
        (self.cases[to].beta / self.cases[from].beta).ln()
    }

    /// The distance between two cases; `None` if one cannot follow the other.
    fn distance(&self, from: usize, to: usize) -> Option<f64> {
        let (from, to) = (self.cases[from], self.cases[to]);
        let possible = from.computable().is_ok() && to.computable().is_ok() && (self.can_continue)(from, to);
        possible.then(|| distance(from, to))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::continuation::Line;

    fn chains(points: &[Parameters]) -> Vec<Vec<usize>> {
        let points: Vec<_> = points.iter().collect();
        let chains = chains_of_neighbours(&points, |from, to| Line::new(from, to).is_ok(), &Interrupt::new());
        chains.expect("nobody interrupts")
    }

    #[test]
    fn cases_with_the_same_alpha_are_chains_along_beta() {
        let points: Vec<Parameters> =
            (0..6).flat_map(|i| [0.1, 1.0, 10.0].map(|alpha| Parameters::new(alpha, 1.5_f64.powi(i), 5.0))).collect();
        let expected: Vec<Vec<usize>> = (0..3).map(|alpha| (0..6).map(|i| 3 * i + alpha).collect()).collect();
        assert_eq!(chains(&points), expected);
    }

    #[test]
    fn a_curve_over_speed_is_one_line_cut_into_chains() {
        let points: Vec<Parameters> =
            (0..40).map(|i| 1.2_f64.powi(i)).map(|inverse| Parameters::new(inverse, 10.0 * inverse, 5.0)).collect();
        let lengths: Vec<usize> = chains(&points).iter().map(Vec::len).collect();
        assert_eq!(lengths, [16, 16, 8]);
        assert!(chains(&points).concat().into_iter().eq(0..40));
    }

    #[test]
    fn chains_of_many_points_are_longer() {
        let curve = |points: i32| -> Vec<Parameters> {
            (0..points).map(|i| 1.001_f64.powi(i)).map(|inverse| Parameters::new(inverse, inverse, 5.0)).collect()
        };
        for (points, longest) in [(100, 16), (4096, 32), (10_000, 64)] {
            let lengths: Vec<usize> = chains(&curve(points)).iter().map(Vec::len).collect();
            assert_eq!(lengths.iter().max(), Some(&longest));
            assert_eq!(lengths.iter().sum::<usize>(), points as usize);
        }
    }

    #[test]
    fn cases_that_no_line_leads_to_are_chains_of_their_own() {
        let far = Parameters::new(1.0, 1e9, 5.0);
        let points = [Parameters::new(0.0, 1.0, 5.0), Parameters::new(1.0, 1.0, 5.0), Parameters::elastic(1.0), far];
        assert_eq!(chains(&points), [[0], [1], [2], [3]]);
        let impossible = [Parameters::new(1.0, 1.0, f64::NAN), Parameters::new(1.0, 1.0, 5.0)];
        assert_eq!(chains(&impossible), [[0], [1]]);
    }
}
