use stribeck_solver::collocation::{CollocationSolver, Settings};
use stribeck_solver::continuation::{Chain, Interrupt};
use stribeck_solver::{Output, Parameters};
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut mixed = *state;
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}
fn main() {
    let mut state = 24;
    let mut power = |from: f64, to: f64| 10_f64.powf(from + (to - from) * random(&mut state));
    let cases: Vec<Parameters> = (0..1000).map(|_| Parameters::new(power(-4.0, 4.0), power(0.0, 7.0), power(-2.0, 4.0))).collect();
    let wide = std::env::var_os("WIDE").is_some();
    let tol: f64 = std::env::var("TOL").map_or(1e-5, |t| t.parse().unwrap());
    let modes = std::env::var_os("MODES").is_some();
    let mut power = |from: f64, to: f64| 10_f64.powf(from + (to - from) * random(&mut state));
    let cases: Vec<Parameters> = if wide { (0..1000).map(|_| Parameters::new(power(-6.0, 6.0), power(-3.0, 9.0), power(-3.0, 6.0))).collect() } else { cases };
    let cases: Vec<Parameters> = if modes { cases.into_iter().map(|c| {
        let m: Vec<_> = (0..2 + (power(0.0,1.0) > 3.0) as usize).map(|_| (power(-1.0, 0.0), power(-2.0, 2.0))).collect();
        let sum: f64 = m.iter().map(|m| m.0).sum();
        let m = m.iter().map(|&(share, time)| stribeck_solver::RetardationMode { share: share / sum, time }).collect();
        Parameters { substrate: stribeck_solver::Substrate::new(m).unwrap(), ..c }
    }).collect() } else { cases };
    let settings = std::env::var("DEG").map_or(Settings::for_tolerance(tol), |d| Settings { tolerance: tol, degree: d.parse().unwrap() });
    let solver = CollocationSolver::new(settings);
    let solver = if std::env::var_os("MARCH").is_some() { solver.marching() } else { solver };
    let mut seeds = std::collections::BTreeMap::new(); let mut ms = vec![];
    let (output, interrupt) = (Output::numbers(), Interrupt::new());
    let mut sum = [[0.0; 5]; 2]; let mut total = 0.0;
    for case in &cases {
        let mut chain = Chain::new(&solver, &output, &interrupt);
        chain.traced(std::env::var_os("T").is_some());
        let s = chain.solve(case).unwrap();
        total += s.effort.seconds;
        for e in &s.trace.events { if let stribeck_solver::continuation::Event::Error { unknowns, error } = e { print!("{unknowns} {error:.2}  "); } }
        if !s.trace.events.is_empty() { println!("meshes {} it {} lu {} a {:.1e} b {:.1e} f {:.1e} ab {:.1e}", s.effort.meshes, s.effort.iterations, s.effort.factorisations, case.alpha, case.beta, case.f, case.beta*stribeck_solver::exact::contact_bounds(case).2.powi(2)); }
        if std::env::var_os("RES").is_some() {
            let mut line = String::new();
            for e in &s.trace.events { match e {
                stribeck_solver::continuation::Event::Residual { residual, .. } => line += &format!("{residual:.0e} "),
                stribeck_solver::continuation::Event::Attempt { .. } => line.clear(),
                stribeck_solver::continuation::Event::Failed(_) => { println!("FAILED {line}"); line.clear(); }
                stribeck_solver::continuation::Event::Solved => { if line.split(' ').count() > 8 { println!("SOLVED {line}"); } line.clear(); }
                _ => {} } }
        }
        ms.push(1e3 * s.effort.seconds);
        *seeds.entry(format!("{} {}", s.seed.name(), s.outcome.is_ok())).or_insert(0) += 1;
        if std::env::var_os("SHOW").is_some() && (s.seed.name() != "table" && s.seed.name() != "thick-film" || s.outcome.is_err()) { println!("{:.1e} {:.1e} {:.1e} {} {:?} {:?} {:?}", case.alpha, case.beta, case.f, s.seed, s.effort, s.outcome.err(), s.path.points.iter().take(2).map(|p| p.iterations).collect::<Vec<_>>()); }
        let Some((w, _, _)) = chain.last() else { continue };
        for (sum, t) in sum.iter_mut().zip(w.timings()) {
            for (s, t) in sum.iter_mut().zip([t.kernel, t.filter, t.assembly, t.factorisation, t.step]) { *s += t; }
        }
    }
    ms.sort_by(f64::total_cmp); println!("{seeds:?} median {:.2} p95 {:.2} max {:.2}", ms[500], ms[950], ms[999]);
    println!("ms a case {total:.4}  (kernel filter assembly factorisation step)\n coarse {:.3?}\n fine {:.3?} rest {:.3}", sum[0], sum[1], total - sum.iter().flatten().sum::<f64>());
}
