use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::{Output, Parameters};
fn main() {
    let t: f64 = std::env::args().nth(1).unwrap().parse().unwrap();
    let s = CollocationSolver::new(Settings { tolerance: t, degree: 8 });
    let e = CollocationSolver::new(Settings { tolerance: 1e-10, degree: 12 });
    let one = |s: &CollocationSolver, p: &Parameters| {
        solve_chain(s, &[p.clone()], &Output::numbers(), &Interrupt::new()).unwrap().remove(0).outcome.unwrap()
    };
    for f in [100.0, 1000.0] {
        for a in [1.0, 10.0] {
            if f == 0.0 && a != 1.0 {
                continue;
            }
            let chain: Vec<Parameters> =
                (0..=240).map(|b| Parameters::new(a, 10f64.powf(-2.0 + b as f64 / 20.0), f)).collect();
            let solved = solve_chain(&s, &chain, &Output::numbers(), &Interrupt::new()).unwrap();
            let mut worst = [(0.0f64, 0.0f64, 0.0f64); 4];
            let meshes: u64 = solved.iter().map(|c| c.effort.meshes).sum();
            let failed: Vec<f64> =
                chain.iter().zip(&solved).filter(|x| x.1.outcome.is_err()).map(|x| x.0.beta.log10()).collect();
            println!("failed {} {:?}", failed.len(), failed.first());
            if let Some(e) = solved.iter().find_map(|x| x.outcome.as_ref().err()) {
                println!("   {e}");
            }
            let its: u64 = solved.iter().map(|c| c.effort.iterations).sum();
            for (p, c) in chain.iter().zip(&solved).skip(40).step_by(4) {
                let Ok(o) = c.outcome.as_ref() else { continue };
                if p.beta > 1e5 {
                    continue;
                }
                let x = one(&e, p);
                let l = one(&s, p);
                let err = |q: &stribeck_solver::Quantities| {
                    let w = x.quantities.x_p_max - x.quantities.x_outlet;
                    [
                        (q.x_outlet - x.quantities.x_outlet).abs() / w,
                        (q.friction.hydrodynamic_cavity / x.quantities.friction.hydrodynamic_cavity - 1.0).abs(),
                        (q.c / x.quantities.c - 1.0).abs(),
                        (q.friction.hydrodynamic() / x.quantities.friction.hydrodynamic() - 1.0).abs(),
                    ]
                };
                let (a, b) = (err(&o.quantities), err(&l.quantities));
                for i in 0..4 {
                    if a[i] > worst[i].0 {
                        worst[i] = (a[i], b[i], p.beta)
                    }
                }
            }
            println!(
                "a={a} f={f} meshes {meshes} its {its} outlet {:.1e} (alone {:.1e} at {:.0}) cavity {:.1e} ({:.1e} at {:.0}) c {:.1e} ({:.1e}) mu_h {:.1e} ({:.1e})",
                worst[0].0,
                worst[0].1,
                worst[0].2,
                worst[1].0,
                worst[1].1,
                worst[1].2,
                worst[2].0,
                worst[2].1,
                worst[3].0,
                worst[3].1
            );
        }
    }
}
