//! The collocation method: coordinates fitted to the cavitation boundary, high order, and its own error estimate.
//!
//! In y = x − x_out the free boundary is at rest (T12), and the mesh never has to follow it. The pressure is a
//! polynomial on each of a dozen panels; Reynolds' equation (T2) holds at their Gauss points; the displacement of the
//! panels is known in closed form (T31), and retardation is a filter along the surface (T30). What remains is a dense
//! system of about a hundred unknowns for Newton's method.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `system.rs` | the equations: Reynolds, film, load, outlet; residuals and matrix |
//! | `newton.rs`, `factorisation.rs` | the corrector: Newton and chord steps |
//! | `legendre.rs`, `reference.rs`, `mesh.rs` | polynomials, the reference panel, panels |
//! | `log_moments.rs`, `discretisation.rs` | the logarithmic kernel, and e of a mesh |
//! | `exponential_moments.rs`, `retardation.rs` | the retardation filter |
//! | `displacement.rs`, `matrix.rs` | w of a mesh and a substrate |
//! | `inlet.rs` | the film ahead of the mesh |
//! | `starting_solutions.rs`, `start.rs` | the table of solutions, and the start from it |
//! | `thick_film.rs` | the start of a march |
//! | `scaling.rs`, `transfer.rs` | how solutions are carried on |
//! | `adaptation.rs` | where panels are wanted |
//! | `estimate.rs`, `bounds.rs`, `acceptance.rs` | how large the errors are, and whether the solution is accepted |
//! | `refine.rs`, `two_level.rs` | the solution on richer panels, which the estimate compares with |
//! | `parts.rs`, `truncation.rs` | sources of error: panels, and what lies beyond the mesh |
//! | `quantities.rs` | the numbers of a solution |
//! | `gap.rs`, `fields.rs` | film and surface between the points, and the fields of a solution |
//! | `sensitivity.rs`, `adjoint.rs` | derivatives of friction with respect to α, β and f |
//! | `friction_partials.rs`, `inlet_partials.rs` | partial derivatives of friction with respect to the unknowns |
//! | `substrate_derivatives.rs`, `retardation_derivatives.rs` | derivatives of w with respect to α and f |
//! | `retardation_transpose.rs` | the transposed retardation filter |
//! | `wide.rs` | loops over vectors as wide as the processor has them |
//! | `workspace.rs`, `state.rs`, `settings.rs`, `timings.rs` | what a chain keeps, what a case is, how time is spent |
//! | `solver.rs`, `fixed_panels.rs` | the method as a [`CaseSolver`](crate::continuation::CaseSolver) |

mod acceptance;
mod adaptation;
mod adjoint;
mod bounds;
mod discretisation;
mod displacement;
mod estimate;
mod exponential_moments;
mod fields;
mod fixed_panels;
mod friction_partials;
mod gap;
mod inlet;
mod inlet_partials;
mod legendre;
mod log_moments;
mod mesh;
mod newton;
mod panel_filter;
mod parts;
mod quantities;
mod reference;
mod refine;
mod retardation;
mod retardation_derivatives;
mod retardation_transpose;
mod scaling;
mod sensitivity;
mod settings;
mod solver;
mod start;
mod starting_solutions;
mod state;
mod substrate_derivatives;
mod system;
mod thick_film;
mod timings;
mod transfer;
mod truncation;
mod two_level;
mod workspace;

pub use settings::Settings;
pub use solver::CollocationSolver;
pub use timings::Timings;
pub use workspace::Workspace;

/// Version of this solver's numbers, a part of every case id. Raise it when a change makes the solver give other
/// numbers for the same case and settings: cases of older results are then solved again instead of being reused.
pub const RESULTS_VERSION: u32 = 7;
