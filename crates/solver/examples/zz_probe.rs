use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::{Output, Parameters};
fn main() {
    let a: Vec<f64> = std::env::args().skip(1).map(|x| x.parse().unwrap()).collect();
    let p = Parameters::new(a[0], a[1], a[2]);
    for (t, d, r) in [
        (1e-3, 8, 1.0),
        (1e-5, 8, 1.0),
        (1e-5, 8, 4.0),
        (1e-6, 8, 1.0),
        (1e-7, 8, 1.0),
        (1e-8, 8, 1.0),
        (1e-8, 12, 1.0),
        (1e-9, 12, 1.0),
        (1e-10, 12, 1.0),
        (1e-10, 12, 4.0),
    ] {
        let s = CollocationSolver::new(Settings { tolerance: t, degree: d }).reaching(r);
        let c = solve_chain(&s, &[p.clone()], &Output { sensitivities: true, ..Output::numbers() }, &Interrupt::new())
            .unwrap()
            .remove(0);
        match c.outcome {
            Ok(o) => {
                let q = o.quantities;
                let f = q.friction;
                println!(
                    "{t:e} {d} {r} n={} P={:.11e} C={:.11e} Fv={:.11e} D={:.11e} c={:.11e} fm={:.9e} pm={:.11e}\n   {:?}\n  S {:?}",
                    c.effort.unknowns,
                    f.pressure,
                    f.shear(),
                    f.viscoelastic,
                    f.drag,
                    q.c,
                    q.film_min,
                    q.p_max,
                    o.errors,
                    o.sensitivities.unwrap().row()
                );
            }
            Err(e) => println!("{t:e} {e}"),
        }
    }
}
