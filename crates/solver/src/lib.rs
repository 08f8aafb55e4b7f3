//! Solves the lubricated sliding of a rigid cylinder on a viscoelastic half space: friction, film and pressure of a
//! steady contact, with an estimate of the error of every number.
//!
//! A case has three dimensionless parameters: α (slide time over retardation time), β (inverse Hersey number) and f
//! (strength of retardation). Lengths along the surface are in units of a₀, film thicknesses of a₀²/R, friction
//! coefficients of a₀/R.
//!
//! One case:
//!
//! ```
//! use stribeck_solver::{Parameters, Settings, solve};
//!
//! let solution = solve(&Parameters::new(1.0, 100.0, 10.0), &Settings::default())?;
//! let (mu_v, mu_h) = (solution.quantities.friction.viscoelastic, solution.quantities.friction.hydrodynamic());
//! println!("mu_v = {mu_v:.5}, mu_h = {mu_h:.5}, c = {:.5}", solution.quantities.c);
//! // Each error estimate is within the tolerance.
//! assert!(solution.errors.mu_v < 1e-5 && solution.errors.mu_h < 1e-5 && solution.errors.c < 1e-5);
//! # Ok::<(), stribeck_solver::Failure>(())
//! ```
//!
//! A chain along β, in which each solution is the first guess of the next one, with fields:
//!
//! ```
//! use stribeck_solver::{FieldSelection, Interrupt, Output, Parameters, Settings, Solver};
//!
//! let fields = FieldSelection { pressure: true, ..FieldSelection::default() };
//! let output = Output { fields, x: vec![-0.5, 0.0, 0.5].into(), ..Output::numbers() };
//! let solver = Solver::new(&Settings { output, ..Settings::default() });
//! let chain = [10.0, 20.0, 40.0].map(|beta| Parameters::new(1.0, beta, 10.0));
//! for case in solver.solve_chain(&chain, &Interrupt::new())? {
//!     let pressure = case.outcome?.fields.pressure.expect("it was asked for");
//!     println!("p(0) = {:.4}, first guess: {}, {} iterations", pressure[1], case.seed, case.effort.iterations);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Points in any order, which [`solve_points`] cuts into chains; with the feature `rayon` it solves these in parallel,
//! and gives the same numbers. A case that fails is a result, with a kind and a sentence:
//!
//! ```
//! use stribeck_solver::{FailureKind, Interrupt, Parameters, Settings, solve_points};
//!
//! let points = [Parameters::new(1.0, 1e30, 10.0), Parameters::elastic(50.0)];
//! let cases = solve_points(&points, &Settings::default(), &Interrupt::new())?;
//! let failure = cases[0].outcome.as_ref().unwrap_err();
//! assert!(matches!(failure.kind, FailureKind::FilmTooThin { .. }));
//! println!("{}: {failure}", failure.kind.name());
//! assert!(cases[1].outcome.is_ok());
//! # Ok::<(), stribeck_solver::Interrupted>(())
//! ```
//!
//! # Modules
//!
//! | module | what it holds |
//! | --- | --- |
//! | `model` (private, its items are here) | parameters, results, the kernel of the displacement |
//! | [`exact`] | limits with known answers: dry sliding, Hertz, thick films |
//! | [`collocation`] | the collocation method; Reynolds' equation is `flow_residual` in `system.rs` |
//! | [`relaxation`] | the relaxation method of the paper; Reynolds' equation is `row` in `reynolds.rs` |
//! | [`continuation`] | chains: from one case to the next |
//! | `solve`, `points` (private) | [`solve`], [`Solver`], [`solve_points`] |
//!
//! # Features
//!
//! `rayon` solves the chains of [`solve_points`] in parallel. `serde` derives serialisation for settings and small
//! enumerations.

pub mod collocation;
pub mod continuation;
pub mod exact;
mod linear;
mod model;
mod points;
pub mod relaxation;
mod solve;

pub use continuation::{Failure, FailureKind, Interrupt, Interrupted, Seed, Solution, SolvedCase};
pub use model::{
    CavityShear, DisplacementKernel, FieldSelection, Fields, Friction, Limits, Lubricant, OutOfRange, Output,
    Parameters, Quantities, RelativeErrors, Retardation, RetardationMode, Sensitivities, SettingOutOfRange, Substrate,
    SubstrateError, gauss, kernel, shear_traction, shortest, stress, viscoelastic_error_scale,
};
pub use points::{point_chains, solve_points};
pub use solve::{Method, Settings, Solver, solve};
