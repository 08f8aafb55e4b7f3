use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::{Output, Parameters};
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|x| x.parse().unwrap()).collect();
    let p = Parameters::new(a[0], a[1], a[2]);
    for d in 5..=16 {
        for t in [1e-6, 1e-9] {
            let s = CollocationSolver::new(Settings { tolerance: t, degree: d });
            let c = solve_chain(&s, &[p.clone()], &Output::numbers(), &Interrupt::new()).unwrap().remove(0);
            if let Ok(o) = c.outcome {
                let q = o.quantities;
                println!(
                    "{t:e} d={d} n={} c={:.13e} P={:.12e} load {:.2e}",
                    c.effort.unknowns, q.c, q.friction.pressure, q.load_residual
                );
            }
        }
    }
}
