use stribeck::continuation::*;
use stribeck::model::*;
use stribeck::relaxation::*;
fn main() {
    let a: Vec<String> = std::env::args().skip(1).collect();
    let v = |i: usize| a[i].parse::<f64>().unwrap();
    let settings = Settings {
        points: a[3].parse().unwrap(),
        acceleration: if a.get(4).is_some_and(|s| s == "none") { Acceleration::None } else { Acceleration::Anderson },
        ..Default::default()
    };
    let settings = if a.len() > 6 {
        Settings { domain: Domain::Fixed { x_min: v(5), x_max: v(6) }, ..settings }
    } else {
        settings
    };
    let betas: Vec<f64> = a[2].split(',').map(|s| s.parse().unwrap()).collect();
    let cases: Vec<Parameters> = betas.iter().map(|&b| Parameters::new(v(1), b, v(0))).collect();
    let solver = RelaxationSolver::new(settings);
    let out = Output::default();
    let refs = std::fs::read_to_string("/work/shared/reference/single_mode.csv").unwrap();
    for (p, r) in cases.iter().zip(solve_chain(&solver, &cases, &out, &Interrupt::new()).unwrap()) {
        match r.outcome {
            Ok(s) => {
                let q = s.quantities;
                print!(
                    "f {} a {} b {:6} n {} {:6} passes {:.3}s {} ",
                    p.f, p.alpha, p.beta, settings.points, r.effort.iterations, r.effort.seconds, r.seed
                );
                for l in refs.lines().skip(1) {
                    let c: Vec<f64> = l.split(',').map(|s| s.parse().unwrap()).collect();
                    if c[0] == p.f && (c[0] == 0.0 || c[1] == p.alpha) && c[2] == p.beta {
                        let e = |x: f64, y: f64| format!("{:8.1e}", (x - y) / if y == 0.0 { 1.0 } else { y });
                        print!(
                            " c{} um{} pm{} xo{:8.1e} Fv{} Fh{} Fc{} Fd{}",
                            e(q.c, c[3]),
                            e(q.film_min, c[4]),
                            e(q.p_max, c[5]),
                            q.x_outlet - c[6],
                            e(q.friction.viscoelastic, c[7]),
                            e(q.friction.hydrodynamic_film, c[8]),
                            e(q.friction.hydrodynamic_cavity, c[9]),
                            e(q.friction.drag, c[11])
                        );
                    }
                }
                println!();
            }
            Err(e) => println!(
                "f {} a {} b {} FAILED {:.3}s {} {}",
                p.f, p.alpha, p.beta, r.effort.seconds, r.effort.iterations, e.reason
            ),
        }
    }
}
