//! Agreement with the relaxation solver, another method with another kind of error.

use rayon::prelude::*;
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::relaxation::{RelaxationSolver, Settings};
use stribeck_solver::{Parameters, Quantities};

use crate::collocation::cases::{numbers, quantities};

/// f and α of cases at β = 100, whose films 401 points resolve.
const CASES: [(f64, f64); 12] = [
    (0.0, f64::INFINITY),
    (1.0, 1.0),
    (1.0, 10.0),
    (1.0, 100.0),
    (3.0, 3.0),
    (10.0, 1.0),
    (10.0, 10.0),
    (10.0, 30.0),
    (30.0, 2.0),
    (100.0, 10.0),
    (100.0, 30.0),
    (1000.0, 10.0),
];
/// Each grid halves the step of the one before it.
const POINTS: [usize; 3] = [401, 801, 1601];

/// What both solvers know: F_v, F_h, F_drag, c and p_max.
fn compared(quantities: &Quantities) -> [(&'static str, f64); 5] {
    let friction = &quantities.friction;
    [
        ("F_v", friction.viscoelastic),
        ("F_h", friction.hydrodynamic()),
        ("F_drag", friction.drag),
        ("c", quantities.c),
        ("p_max", quantities.p_max),
    ]
}

fn relaxed(points: usize, case: &Parameters) -> Quantities {
    let solver = RelaxationSolver::new(Settings { points, ..Settings::default() });
    let solved = solve_chain(&solver, std::slice::from_ref(case), &numbers(), &Interrupt::new());
    let outcome = solved.expect("nobody interrupts").remove(0).outcome;
    outcome.unwrap_or_else(|why| panic!("{case:?}, {points} points: {why}")).quantities
}

/// Three grids, Richardson's extrapolation from the two finest: the two solvers differ by less than the error which the
/// grids show of themselves. What the ends of the domain leave, no grid shows: 1e-5 of F_drag or of the number.
///
/// c and F_h, whose errors are cleanly of second order, converge to the numbers of the collocation solver grid by grid.
#[test]
#[ignore = "slow: 12 cases with 401 to 1601 points"]
fn both_solvers_agree_within_the_error_of_the_grid() {
    CASES.par_iter().with_max_len(1).for_each(|&(f, alpha)| {
        let case = Parameters::new(alpha, 100.0, f);
        let collocated = compared(&quantities(1e-8, &case));
        let grids = POINTS.map(|points| compared(&relaxed(points, &case)));
        for (i, (name, value)) in collocated.into_iter().enumerate() {
            let [coarse, middle, fine] = [0, 1, 2].map(|grid| grids[grid][i].1);
            let grid_error = (fine - middle).abs() / 3.0;
            let extrapolated = fine + (fine - middle) / 3.0;
            let floor = 1e-5 * if name == "F_v" { collocated[2].1 } else { value };
            let difference = (value - extrapolated).abs();
            assert!(difference <= grid_error + floor, "{case:?}: {name}: {value}, grids {coarse}, {middle}, {fine}");
            if name == "c" || name == "F_h" {
                let errors = [coarse, middle, fine].map(|grid| (grid - value).abs());
                let halved = errors.windows(2).all(|pair| pair[1] <= 0.35 * pair[0] + floor);
                assert!(halved, "{case:?}: {name}: {errors:?}");
            }
        }
    });
}
