fn cpu() -> f64 {
    let s = std::fs::read_to_string("/proc/self/schedstat").unwrap();
    s.split(' ').next().unwrap().parse::<f64>().unwrap() * 1e-9
}
use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Interrupt, solve_chain};
use stribeck_solver::{Output, Parameters};
fn main() {
    let mut best = vec![];
    let output = Output { sensitivities: std::env::args().nth(1).is_some(), ..Output::numbers() };
    for t in [1e-5, 1e-7] {
        let s = CollocationSolver::new(Settings { tolerance: t, degree: 8 });
        let chains: Vec<Vec<Parameters>> = (-3..=3)
            .map(|a| {
                (0..=60).map(|b| Parameters::new(10f64.powi(a), 10f64.powf(1.0 + b as f64 / 20.0), 100.0)).collect()
            })
            .collect();
        let alone: Vec<Vec<Parameters>> = (-3..=3)
            .flat_map(|a| (0..=3).map(move |b| vec![Parameters::new(10f64.powi(a), 10f64.powf(1.0 + b as f64), 100.0)]))
            .collect();
        for set in [chains, alone] {
            let cases: usize = set.iter().map(|c| c.len()).sum();
            let mut least = f64::INFINITY;
            for _ in 0..5 {
                let start = cpu();
                for c in &set {
                    solve_chain(&s, c, &output, &Interrupt::new()).unwrap();
                }
                least = least.min(cpu() - start);
            }
            best.push(1e3 * least / cases as f64);
        }
    }
    println!("{:.4} {:.4} {:.4} {:.4}", best[0], best[1], best[2], best[3]);
}
