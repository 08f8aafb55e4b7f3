use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::{Output, Parameters};
fn main() {
    let solver = CollocationSolver::new(Settings::default());
    let solver = if std::env::var_os("MARCH").is_some() { solver.marching() } else { solver };
    for line in ["beta", "speed", "alpha"] {
    for per in [1.0, 2.0, 3.0, 4.0, 5.0, 10.0] {
        let mut best = f64::INFINITY; let mut n = 0; let mut seeds = std::collections::BTreeMap::new();
        for rep in 0..5 {
            let mut t = 0.0; n = 0; 
            for alpha in -4..=4 { for f in [1.0, 100.0, 3000.0] {
                let k = (6.0 * per) as usize;
                let p = |e: f64| 10_f64.powf(e);
                let cases: Vec<_> = (0..=k).map(|i| { let e = i as f64 / per; match line { "beta" => Parameters::new(p(alpha as f64), p(0.5 + e), f), "speed" => Parameters::new(p(-3.0+e), p(1.0 + 0.25*(alpha as f64 + 4.0) + 0.66 * e), f), _ => Parameters::new(p(-3.0+e), p(0.8*(alpha as f64 + 4.0)), f) } }).collect();
                for s in solve_chain(&solver, &cases, &Output::numbers(), &Interrupt::new()).unwrap().into_iter().skip(1) { assert!(s.outcome.is_ok()); t += s.effort.seconds; n += 1; if rep == 0 { *seeds.entry(s.seed.name()).or_insert(0) += 1; } }
            } }
            best = f64::min(best, t);
        }
        println!("{line} {per} a decade: {:.3} ms a case, {seeds:?}", 1e3 * best / n as f64);
    }}
}
