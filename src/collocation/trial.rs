use super::*;
use crate::continuation::{Interrupt, solve_chain};
use crate::model::{FieldSelection, Output, Parameters};
#[test]
fn trial() {
    let interrupt = Interrupt::new();
    let text = include_str!("../../tests/reference/single_mode.csv");
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    if std::env::var("GRID").is_ok() {
        return grid();
    }
    for tolerance in [1e-3, 1e-5, 1e-8] {
        let solver = CollocationSolver::new(Settings { tolerance, ..Settings::default() });
        let mut ratios = Vec::new();
        for line in text.lines().skip(1) {
            let v: Vec<f64> = line.split(',').map(|t| t.parse().unwrap()).collect();
            let p = if v[0] == 0.0 { Parameters::elastic(v[2]) } else { Parameters::new(v[1], v[2], v[0]) };
            let r = solve_chain(&solver, &[p], &output, &interrupt).unwrap().remove(0);
            match &r.outcome {
                Ok(s) => {
                    let q = &s.quantities;
                    let mu_h = v[8] + v[9];
                    let tot = v[7] + mu_h;
                    let e = [
                        (q.friction.viscoelastic - v[7]).abs() / v[7].max(1e-3 * tot),
                        q.friction.hydrodynamic() / mu_h - 1.0,
                        q.c / v[3] - 1.0,
                        q.film_min / v[4] - 1.0,
                        q.p_max / v[5] - 1.0,
                        q.x_outlet / v[6] - 1.0,
                        q.friction.drag / v[11] - 1.0,
                    ]
                    .map(f64::abs);
                    let worst = e[0].max(e[1]).max(e[2]);
                    let est = s.errors.mu_v.max(s.errors.mu_h).max(s.errors.c);
                    if worst > tolerance
                        || tolerance == 1e-8
                            && (worst > 3e-8 || e[3] > 1e-6 || e[4] > 1e-7 || e[5] > 1e-7 || e[6] > 1e-7)
                    {
                        println!("{line} {:?}", e.map(|e| format!("{e:.0e}")));
                    }
                    ratios.push(est / worst);
                }
                Err(e) => println!("{line} FAILED {e:?} {:?}", r.path.points.len()),
            }
        }
        ratios.sort_by(f64::total_cmp);
        println!(
            "tolerance {tolerance}: {} ratios {:.2} {:.2} {:.2}",
            ratios.len(),
            ratios[ratios.len() / 20],
            ratios[ratios.len() / 2],
            ratios[ratios.len() * 19 / 20]
        );
    }
}

fn grid() {
    let interrupt = Interrupt::new();
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    let solver = CollocationSolver::new(Settings::default());
    let (mut n, mut failed) = (0, 0);
    for i in 0..9 {
        for k in 0..6 {
            let alpha = 10f64.powi(i - 4);
            let f = if k == 0 { 0.0 } else { 10f64.powi(k - 1) };
            let t = std::time::Instant::now();
            let mut works = (0, 0);
            let mut text = String::new();
            for chained in [true, false] {
                let cases: Vec<_> = (0..11)
                    .map(|j| {
                        let beta = 10f64.powi(j - 2);
                        if f == 0.0 { Parameters::elastic(beta) } else { Parameters::new(alpha, beta, f) }
                    })
                    .collect();
                let chains: Vec<Vec<_>> =
                    if chained { vec![cases] } else { cases.into_iter().map(|c| vec![c]).collect() };
                for chain in chains {
                    let r = solve_chain(&solver, &chain, &output, &interrupt).unwrap();
                    for (r, c) in r.iter().zip(&chain) {
                        n += 1;
                        works.0 += r.effort.iterations;
                        works.1 += r.effort.factorisations;
                        match &r.outcome {
                            Err(e) => {
                                failed += 1;
                                text += &format!("   FAIL chained {chained} {c:?} {}\n", e.reason);
                            }
                            Ok(s) => {
                                if s.quantities.load_residual > 1e-10 {
                                    text += &format!("  load {:e} {c:?}\n", s.quantities.load_residual)
                                }
                            }
                        }
                    }
                }
            }
            println!("alpha {alpha} f {f} {works:?} {:?}\n{text}", t.elapsed());
        }
    }
    println!("{n} {failed}");
}
#[test]
fn one() {
    let Ok(v) = std::env::var("CASE") else { return };
    let v: Vec<f64> = v.split(',').map(|t| t.parse().unwrap()).collect();
    let interrupt = Interrupt::new();
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    let solver = CollocationSolver::new(Settings { tolerance: v[3], ..Settings::default() });
    let p = if v[2] == 0.0 { Parameters::elastic(v[1]) } else { Parameters::new(v[0], v[1], v[2]) };
    let r = solve_chain(&solver, &[p], &output, &interrupt).unwrap().remove(0);
    for p in &r.path.points {
        println!("{p:?}");
    }
    println!("{r:?}");
}
#[test]
fn speed() {
    if std::env::var("SPEED").is_err() {
        return;
    }
    let interrupt = Interrupt::new();
    let output = Output {
        limits: std::env::var("SPEED").unwrap() == "limits",
        fields: FieldSelection::default(),
        ..Output::default()
    };
    let solver = CollocationSolver::new(Settings::default());
    let mut all = Vec::new();
    for i in 0..7 {
        let alpha = 10f64.powi(i - 3);
        let cases: Vec<_> = (0..61).map(|j| Parameters::new(alpha, 10f64.powf(1.0 + j as f64 / 20.0), 100.0)).collect();
        let t = std::time::Instant::now();
        let r = solve_chain(&solver, &cases, &output, &interrupt).unwrap();
        let t = t.elapsed();
        let mut s: Vec<f64> = r.iter().map(|r| r.effort.seconds * 1e3).collect();
        all.extend(s.clone());
        let its: u64 = r.iter().map(|r| r.effort.iterations).sum();
        let lus: u64 = r.iter().map(|r| r.effort.factorisations).sum();
        let first = s[0];
        let seeds: std::collections::BTreeMap<String, usize> = r.iter().fold(Default::default(), |mut m, r| {
            *m.entry(r.seed.to_string()).or_default() += 1;
            m
        });
        s.sort_by(f64::total_cmp);
        let errs: f64 = r
            .iter()
            .map(|r| {
                let e = &r.outcome.as_ref().unwrap().errors;
                e.mu_v.max(e.mu_h).max(e.c).ln()
            })
            .sum::<f64>()
            / 61.0;
        println!(
            "alpha {alpha}: {t:?} its {its} lus {lus} first {first:.2} median {:.3} mean {:.3} max {:.2} err {:.1e} {seeds:?}",
            s[30],
            s.iter().sum::<f64>() / 61.0,
            s[60],
            errs.exp()
        );
    }
    all.sort_by(f64::total_cmp);
    println!("median {:.3} mean {:.3}", all[all.len() / 2], all.iter().sum::<f64>() / all.len() as f64);
}
#[test]
fn stress() {
    let Ok(n) = std::env::var("STRESS") else { return };
    use crate::model::{RetardationMode, Substrate};
    let interrupt = Interrupt::new();
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    let solver = CollocationSolver::new(Settings::default());
    let mut seed = 12345u64;
    let mut random = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 33) as f64 / (1u64 << 31) as f64
    };
    let (mut failed, mut slowest) = (0, 0.0);
    let n: usize = n.parse().unwrap();
    for _ in 0..n {
        let alpha = 10f64.powf(-8.0 + 16.0 * random());
        let beta = 10f64.powf(-4.0 + 14.0 * random());
        let f = 10f64.powf(-2.0 + 8.0 * random());
        let modes = 1 + (3.0 * random()) as usize;
        let shares: Vec<f64> = (0..modes).map(|_| 0.1 + random()).collect();
        let sum: f64 = shares.iter().sum();
        let mut list: Vec<_> = shares
            .iter()
            .map(|s| RetardationMode { share: s / sum, time: 10f64.powf(-3.0 + 6.0 * random()) })
            .collect();
        let rest: f64 = list[1..].iter().map(|m| m.share).sum();
        list[0].share = 1.0 - rest;
        let p = Parameters { substrate: Substrate::new(list).unwrap(), ..Parameters::new(alpha, beta, f) };
        let t = std::time::Instant::now();
        let r = solve_chain(&solver, &[p.clone()], &output, &interrupt).unwrap().remove(0);
        let t = t.elapsed().as_secs_f64();
        if t > slowest {
            slowest = t;
            println!("slowest {t:.3} {p:?} {:?}", r.outcome.is_ok());
        }
        if let Err(e) = r.outcome {
            failed += 1;
            println!("FAIL {t:.3} {p:?} {}", e.reason);
        }
    }
    println!("{n} {failed} {slowest}");
}
#[test]
fn dips() {
    if std::env::var("DIPS").is_err() {
        return;
    }
    let interrupt = Interrupt::new();
    for p in [Parameters::new(1.0, 1e7, 1.0), Parameters::new(1.0, 1e5, 10.0), Parameters::new(0.01, 1e8, 10.0)] {
        let x: Vec<f64> = (0..200001).map(|i| -1.5 + 3.0 * i as f64 / 200000.0).collect();
        let output = Output {
            limits: false,
            x: x.clone().into(),
            fields: FieldSelection { pressure: true, ..FieldSelection::default() },
            ..Output::default()
        };
        let solver = CollocationSolver::new(Settings::default());
        let r = solve_chain(&solver, &[p.clone()], &output, &interrupt).unwrap().remove(0);
        let s = r.outcome.unwrap();
        let f = s.fields.pressure.unwrap();
        let i = (0..f.len()).min_by(|&i, &j| f[i].total_cmp(&f[j])).unwrap();
        println!(
            "{p:?} min {:.2e} at {} outlet {} pmax {} unknowns {}",
            f[i], x[i], s.quantities.x_outlet, s.quantities.p_max, r.effort.unknowns
        );
    }
}
#[test]
fn field_speed() {
    let Ok(which) = std::env::var("FIELDS") else { return };
    let interrupt = Interrupt::new();
    let x: Vec<f64> = (0..601).map(|i| -3.0 + 6.0 * i as f64 / 600.0).collect();
    let all = which == "all";
    let output = Output {
        limits: false,
        x: x.clone().into(),
        fields: FieldSelection { pressure: true, film_thickness: all, displacement: all },
        ..Output::default()
    };
    let solver = CollocationSolver::new(Settings::default());
    let cases: Vec<_> = (0..61).map(|j| Parameters::new(1.0, 10f64.powf(1.0 + j as f64 / 20.0), 100.0)).collect();
    let t = std::time::Instant::now();
    solve_chain(&solver, &cases, &output, &interrupt).unwrap();
    println!("fields {which} {:?} a case", t.elapsed() / 61);
}
#[test]
fn rough() {
    if std::env::var("ROUGH").is_err() {
        return;
    }
    let interrupt = Interrupt::new();
    let text = include_str!("../../tests/reference/single_mode.csv");
    let output = Output { limits: false, fields: FieldSelection::default(), ..Output::default() };
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|t| t.parse().unwrap()).collect()).collect();
    let solver = CollocationSolver::new(Settings { tolerance: 1e-3, ..Settings::default() });
    for chain in rows.chunk_by(|a, b| a[0] == b[0] && a[1] == b[1]) {
        let cases: Vec<_> = chain
            .iter()
            .map(|v| if v[0] == 0.0 { Parameters::elastic(v[2]) } else { Parameters::new(v[1], v[2], v[0]) })
            .collect();
        for (r, v) in solve_chain(&solver, &cases, &output, &interrupt).unwrap().iter().zip(chain) {
            let s = r.outcome.as_ref().unwrap();
            let q = &s.quantities;
            let mu_h = v[8] + v[9];
            let tot = v[7] + mu_h;
            let e = [
                (q.friction.viscoelastic - v[7]).abs() / v[7].max(1e-3 * tot),
                q.friction.hydrodynamic() / mu_h - 1.0,
                q.c / v[3] - 1.0,
            ];
            let est = [s.errors.mu_v, s.errors.mu_h, s.errors.c];
            if e.iter().any(|e| e.abs() > 2e-5) {
                println!(
                    "{:?} {} est {} n {}",
                    &v[..3],
                    e.map(|e| format!("{e:.0e}")).join(" "),
                    est.map(|e| format!("{e:.0e}")).join(" "),
                    r.effort.unknowns
                );
            }
        }
    }
}
