//! The collocation method: coordinates fitted to the cavitation boundary, high order, and its own error estimate.
//!
//! In y = x − x_out the free boundary is at rest (T12), and the mesh never has to follow it. The pressure is a polynomial on
//! each of a dozen panels; Reynolds' equation (T2) holds at their Gauss points; the displacement of the panels is known in
//! closed form (T31), and retardation is a filter along the surface (T30). What remains is a dense system of about a hundred
//! unknowns for Newton's method.
//!
//! | file | idea |
//! | --- | --- |
//! | `system.rs` | the equations: Reynolds, film, load, outlet; residuals and matrix |
//! | `newton.rs`, `factorisation.rs` | the corrector: Newton and chord steps |
//! | `legendre.rs`, `reference.rs`, `mesh.rs` | polynomials, the reference panel, panels |
//! | `log_moments.rs`, `discretisation.rs` | the logarithmic kernel, and e of a mesh |
//! | `exponential_moments.rs`, `retardation.rs` | the retardation filter |
//! | `displacement.rs`, `matrix.rs` | w of a mesh and a substrate |
//! | `inlet.rs` | the film ahead of the mesh |
//! | `thick_film.rs`, `scaling.rs`, `transfer.rs` | where solutions start, and how they are carried on |
//! | `adaptation.rs`, `estimate.rs`, `acceptance.rs` | where panels are wanted, how large the error is, whether that is good enough |
//! | `quantities.rs`, `fields.rs` | what comes out |
//! | `sensitivity.rs`, `adjoint.rs` | how friction changes with α, β and f, by one transposed system for each friction |
//! | `friction_partials.rs`, `inlet_partials.rs` | what friction takes of each unknown |
//! | `substrate_derivatives.rs`, `retardation_derivatives.rs`, `retardation_transpose.rs` | how w changes with α and f; the filter backwards |
//! | `workspace.rs`, `solver.rs`, `fixed_panels.rs`, `settings.rs`, `state.rs`, `timings.rs` | how it is run, and where the time goes |

mod acceptance;
mod adaptation;
mod adjoint;
mod discretisation;
mod displacement;
mod estimate;
mod exponential_moments;
mod factorisation;
mod fields;
mod fixed_panels;
mod friction_partials;
mod inlet;
mod inlet_partials;
mod legendre;
mod log_moments;
mod matrix;
mod mesh;
mod newton;
mod quantities;
mod reference;
mod retardation;
mod retardation_derivatives;
mod retardation_transpose;
mod scaling;
mod sensitivity;
mod settings;
mod solver;
mod state;
mod substrate_derivatives;
mod system;
mod thick_film;
mod timings;
mod transfer;
mod workspace;

pub use settings::Settings;
pub use solver::CollocationSolver;
pub use timings::Timings;
pub use workspace::Workspace;

/// Version of this solver's numbers, a part of every case id. Raise it when a change makes the solver give other numbers for
/// the same case and settings: cases of older results are then solved again instead of being reused.
pub const RESULTS_VERSION: u32 = 2;
