//! Fields at any place satisfy the equations.

use std::f64::consts::PI;

use rayon::prelude::*;
use stribeck_solver::collocation::Settings;
use stribeck_solver::exact::contact_bounds;
use stribeck_solver::{DisplacementKernel, FieldSelection, Output, Parameters};

use crate::collocation::cases::{fields_at, numbers, settings, solution};
use crate::collocation::forces::{Sampled, cases};
use crate::collocation::measure::EXACT;

/// Behind the outlet, in the contact, ahead of it and far away on both sides: u is the gap (T3), p is 0 behind the
/// outlet.
#[test]
fn the_film_is_the_gap() {
    cases().par_iter().for_each(|case| {
        let (trailing, leading, half_width) = contact_bounds(case);
        let far = [1.0, 10.0, 1e3, 1e5].into_iter().flat_map(|far| [trailing - far, leading + far]);
        let near = (0..400).map(|i| trailing - half_width + 0.01 * f64::from(i) * half_width);
        let mut x: Vec<f64> = far.chain(near).collect();
        x.sort_by(f64::total_cmp);
        let solution = solution(settings(1e-5), case, &fields_at(x.clone()));
        let (quantities, fields) = (&solution.quantities, &solution.fields);
        let (p, u, w) = (
            fields.pressure.as_ref().unwrap(),
            fields.film_thickness.as_ref().unwrap(),
            fields.displacement.as_ref().unwrap(),
        );
        for (i, &x) in x.iter().enumerate() {
            let gap = quantities.separation + 0.5 * x * x - w[i];
            let terms = quantities.separation.abs() + 0.5 * x * x + w[i].abs();
            assert!((u[i] - gap).abs() <= 1e-14 * terms, "{case:?} at {x}: {} and {gap}", u[i]);
            assert!(u[i] >= 0.99 * quantities.film_min, "{case:?} at {x}: {} {quantities:?}", u[i]);
            assert!(x > quantities.x_outlet || p[i] == 0.0, "{case:?} at {x}: {}", p[i]);
        }
    });
}

/// Where the film is so thin that the displacement between the Gauss points is not known to a hundredth of it: no field
/// falls below the smallest film, which the points know.
#[test]
fn very_thin_films_are_not_torn() {
    let cases = [
        Parameters::new(2.3087765166375434, 69762742.77589335, 8532.083314889915),
        Parameters::new(86.326527638278, 6.062764892504697e11, 1489.8928609002248),
        Parameters::new(826.0, 8.9e11, 623.0),
        Parameters::elastic(1e8),
    ];
    cases.par_iter().for_each(|case| {
        for tolerance in [1e-5, 1e-6] {
            let x: Vec<f64> = (0..=5000).map(|i| -1.2 + 2.4 * f64::from(i) / 5000.0).collect();
            let solution = solution(settings(tolerance), case, &fields_at(x));
            let film = solution.fields.film_thickness.as_ref().unwrap();
            let least = film.iter().fold(f64::INFINITY, |a, &u| a.min(u));
            assert!(least >= 0.98 * solution.quantities.film_min, "{case:?}: {least:e} {:?}", solution.quantities);
        }
    });
}

/// At the outlet the film is c, and pressure and its slope are 0 (T5).
#[test]
fn the_outlet_is_where_the_film_is_c() {
    cases().par_iter().for_each(|case| {
        let solver = settings(1e-8);
        let quantities = solution(solver, case, &numbers()).quantities;
        let step = 1e-3 * (quantities.x_p_max - quantities.x_outlet) * quantities.c.min(1.0);
        let x = [quantities.x_outlet, quantities.x_outlet + step];
        let fields = solution(solver, case, &fields_at(x)).fields;
        let (p, u) = (fields.pressure.unwrap(), fields.film_thickness.unwrap());
        assert!(
            (u[0] / quantities.c - 1.0).abs() < 2e-14 / quantities.c + 1e-12,
            "{case:?}: {} {}",
            u[0],
            quantities.c
        );
        assert_eq!(p[0], 0.0);
        let slope = (p[1] - p[0]) / step * (quantities.x_p_max - quantities.x_outlet) / quantities.p_max;
        assert!(slope.abs() < 0.01, "{case:?}: {slope:e}");
    });
}

/// What is left of Reynolds' equation (T2) over u, by central differences of the published pressure at places that know
/// nothing of the panels.
fn flow_error(settings: Settings, case: &Parameters) -> f64 {
    let quantities = solution(settings, case, &numbers()).quantities;
    let width = contact_bounds(case).2;
    // places in the film, and for each a pair close by
    let places: Vec<f64> = (1..400).map(|i| quantities.x_outlet + 1e-5 * width * 1.035_f64.powi(i)).collect();
    let steps: Vec<f64> = places.iter().map(|x| 1e-3 * (x - quantities.x_outlet).min(0.02 * width)).collect();
    let x: Vec<f64> = places.iter().zip(&steps).flat_map(|(x, step)| [x - step, *x, x + step]).collect();
    assert!(x.is_sorted());
    let fields = solution(settings, case, &fields_at(x)).fields;
    let (p, u) = (fields.pressure.unwrap(), fields.film_thickness.unwrap());
    let error = |(i, step): (usize, &f64)| {
        let film = u[3 * i + 1];
        let gradient = (p[3 * i + 2] - p[3 * i]) / (2.0 * step);
        ((case.beta * gradient * film.powi(3) + film - quantities.c) / film).abs()
    };
    steps.iter().enumerate().map(error).fold(0.0, f64::max)
}

/// It falls with the tolerance. It is larger than that: friction and flow are means, in which its oscillations cancel;
/// how much larger depends on where the panels happen to end.
#[test]
fn the_flow_is_conserved_between_the_points() {
    cases().par_iter().for_each(|case| {
        let errors = [settings(1e-4), settings(1e-8), EXACT].map(|settings| flow_error(settings, case));
        assert!(errors[0] < 0.1 && errors[1] < 5e-3 && errors[2] < 1e-4, "{case:?}: {errors:?}");
    });
}

/// Pressure, film and displacement at any place are nearly as exact as the numbers of a solution: over the largest
/// pressure, the film there and the range of the displacement.
#[test]
fn fields_are_as_exact_as_the_tolerance() {
    cases().par_iter().for_each(|case| {
        let (trailing, leading, half_width) = contact_bounds(case);
        let step = (leading - trailing + 4.0 * half_width) / 500.0;
        let x: Vec<f64> = (0..500).map(|i| trailing - 2.0 * half_width + step * f64::from(i)).collect();
        let fields = |settings| {
            let fields = solution(settings, case, &fields_at(x.clone())).fields;
            [fields.pressure, fields.film_thickness, fields.displacement].map(|field| field.expect("asked for"))
        };
        let [p, u, w] = fields(EXACT);
        let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        for tolerance in [1e-3, 1e-5, 1e-7] {
            let found = fields(settings(tolerance));
            let error = |of: usize, exact: &[f64], scale: &dyn Fn(usize) -> f64| {
                let one = |(i, (a, b)): (usize, (&f64, &f64))| (a - b).abs() / scale(i);
                found[of].iter().zip(exact).enumerate().map(one).fold(0.0, f64::max)
            };
            let errors = [error(0, &p, &|_| largest(&p)), error(1, &u, &|i| u[i]), error(2, &w, &|_| largest(&w))];
            assert!(errors.iter().all(|error| *error < 30.0 * tolerance), "{case:?} at {tolerance:e}: {errors:?}");
        }
    });
}

/// w another way: the kernel (T10) in closed form averaged over cells, times the mean pressure of each cell (T21).
///
/// The cells grow from the place on, so that the error is that of a pressure which is constant on each.
fn displacement_by_cells(case: &Parameters, settings: Settings, places: &[f64], ratio: f64) -> Vec<f64> {
    let kernel = DisplacementKernel::new(case);
    let outlet = solution(settings, case, &numbers()).quantities.x_outlet;
    let (_, leading, half_width) = contact_bounds(case);
    let distances = (0..).map(|i| 1e-5 * half_width * ratio.powi(i)).take_while(|far| *far < 1e4 * half_width);
    let centres: Vec<f64> = places.iter().copied().chain([outlet, leading]).collect();
    let mut ends: Vec<f64> =
        distances.flat_map(|far| centres.iter().flat_map(move |x| [x - far, x + far])).chain(centres.clone()).collect();
    ends.retain(|&end| end >= outlet);
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|b, a| *b - *a < 1e-9 * half_width);
    let middles: Vec<f64> = ends.windows(2).map(|ends| 0.5 * (ends[0] + ends[1])).collect();
    let fields = FieldSelection { pressure: true, ..FieldSelection::default() };
    let output = Output { fields, x: middles.clone().into(), ..numbers() };
    let pressure = solution(settings, case, &output).fields.pressure.expect("asked for");
    let at = |x: &f64| -> f64 {
        let cells = ends.windows(2).zip(&middles).zip(&pressure);
        cells
            .map(|((ends, middle), p)| {
                p * (ends[1] - ends[0]) / PI * kernel.cell_average(x - middle, ends[1] - ends[0])
            })
            .sum()
    };
    places.iter().map(at).collect()
}

/// The filter (T8) and the kernel (T10) are two ways to the same displacement, extrapolated from cells of two sizes:
/// they agree to six digits, and better than either size of cells by itself.
#[test]
fn the_displacement_is_that_of_the_kernel() {
    cases().par_iter().for_each(|case| {
        let (trailing, leading, half_width) = contact_bounds(case);
        let places = [
            trailing - half_width,
            trailing + 0.1 * half_width,
            leading - 0.7 * half_width,
            leading,
            leading + 3.0 * half_width,
        ];
        let solver = settings(1e-7);
        let found = solution(solver, case, &fields_at(places)).fields.displacement.expect("asked for");
        let by_cells = [1.04_f64, 1.04_f64.sqrt()].map(|ratio| displacement_by_cells(case, solver, &places, ratio));
        let mut worst = [0.0_f64; 2];
        for (i, w) in found.iter().enumerate() {
            let (coarse, fine) = (by_cells[0][i], by_cells[1][i]);
            // of second order
            let extrapolated = fine + (fine - coarse) / 3.0;
            worst = [worst[0].max((w - extrapolated).abs()), worst[1].max((w - coarse).abs())];
        }
        assert!(worst[0] < 2e-6 && worst[0] < 0.5 * worst[1], "{case:?}: {worst:?}");
    });
}

/// The same field wherever it is asked for: each place by itself has the value it has among others.
#[test]
fn places_do_not_know_of_each_other() {
    for case in cases() {
        let sampled = Sampled::new(settings(1e-5), &case);
        for i in (0..sampled.x.len()).step_by(sampled.x.len() / 7) {
            let fields = solution(settings(1e-5), &case, &fields_at([sampled.x[i]])).fields;
            assert_eq!(fields.pressure.unwrap(), [sampled.pressure[i]]);
            assert_eq!(fields.film_thickness.unwrap(), [sampled.film[i]]);
            assert_eq!(fields.displacement.unwrap(), [sampled.displacement[i]]);
        }
    }
}
