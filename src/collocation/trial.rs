use super::*;
use crate::continuation::{Interrupt, Work};
use crate::model::{DisplacementKernel, Parameters, CavityShear};
use std::sync::Arc;
use std::time::Instant;
fn model_c(beta: f64) -> f64 { let a = 0.4458*beta.powf(-0.6); let b = 1.0/(3.14159*beta); a*b/(a+b) }

#[test]
fn trial() {
    let interrupt = Interrupt::new();
    for (alpha, f) in [(f64::INFINITY, 0.0), (1.0, 100.0)] {
        println!("---- {alpha} {f}");
        let reference = Arc::new(reference::ReferencePanel::new(8));
        let mut corrector = newton::Corrector::default();
        let kernel = DisplacementKernel::new(&Parameters::new(alpha, 1.0, f));
        let disp = |mesh: &Arc<mesh::Mesh>| {
            let d = Arc::new(discretisation::Discretisation::new(&reference, mesh.clone()));
            displacement::Displacement::new(d, &kernel)
        };
        let mut w = disp(&thick_film::mesh(8, 0.01));
        let mut state = thick_film::state(&w, 0.01);
        let mut last: f64 = 0.01;
        let a2: f64 = 1.0;
        for k in -4..=8 {
            let beta = 10f64.powf(k as f64 / 2.0);
            let mut work = Work::new(&interrupt);
            let ratio = beta / last;
            let s = ((a2 + 0.52/beta)/(a2+0.52/last)).sqrt();
            state = state.scaled(s);
            let left = model_c(beta)/model_c(last)/s/s;
            let _ = ratio;
            for u in &mut state.film { *u *= left.powf((-(*u / state.c - 1.0).max(0.0)).exp()); }
            state.c *= left;
            last = beta;
            let mut mesh = state.mesh.clone();
            let mut before = f64::NAN;
            for pass in 0..4 {
                if pass > 0 { mesh = adaptation::equidistributed(&reference, &state, 16, mesh.reach()); }
                w = disp(&mesh);
                state = state.on(&reference, &mesh);
                let t = Instant::now();
                let r = corrector.correct(&w, beta, &mut state, 1e-11, &mut work);
                let t = t.elapsed();
                let q = quantities::quantities(&w, beta, &state, CavityShear::Full);
                let ind = adaptation::indicators(&reference, &state);
                println!("{beta:9.3e} {pass} {} {:?} {t:?} c {:.9} dc {:.1e} mu_v {:.9} mu_h {:.9} {:.1e} {:.1e}", r.is_ok(), (work.effort.iterations, work.effort.factorisations), q.c, q.c/before-1.0, q.friction.viscoelastic, q.friction.hydrodynamic(), ind.iter().fold(0., |a: f64, b| a.max(*b)), ind.iter().fold(1., |a: f64, b| a.min(*b)));
                before = q.c;
                if beta > 9e3 { let e = &mesh.film; for (i, v) in ind.iter().enumerate() { print!("[{:.3e} {:.1e} {:.0e}] ", state.outlet+e[i], e[i+1]-e[i], v); } println!(); }
                if let Err(e) = r { println!("{e:?} {:?}", mesh.film); return; }
            }
        }
        println!("{:?}", state.mesh.film);
    }
}
