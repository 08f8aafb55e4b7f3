//! Generalized Stribeck surfaces of a rigid cylinder sliding on a viscoelastic half space.
//!
//! A cylinder (radius R, load N per length, speed V) slides through a Newtonian film (viscosity η) over a half space
//! whose creep compliance has one or several retardation times. Made dimensionless, a case has three numbers:
//! α (slide time over a contact length / retardation time), β (inverse Hersey number) and f (strength of retardation).
//! The program solves Reynolds' equation together with the surface displacement for whole grids of (α, β, f) and
//! publishes the friction coefficients μ_v (viscoelastic), μ_h (hydrodynamic) and μ_tot with the fields behind them.
//!
//! Data flow one way:
//!
//! ```text
//! sweep file ─ sweep ─ plan ─ chains ─ continuation ─ solver ─ outcome ─ store ─ results.h5, summary.csv
//! ```
//!
//! | module | what it holds | may know |
//! | --- | --- | --- |
//! | [`cli`] | one file per command | everything below |
//! | [`input`] | files that users write: TOML by type, axes, errors that show the place | – |
//! | [`sweep`] | sweep file → validated [`sweep::Sweep`], axes, cases, plan | [`input`], [`model`], [`material`], [`collocation::Settings`], [`relaxation::Settings`] |
//! | [`model`] | the equations: parameters, kernel, film, load, friction; no iteration | – |
//! | [`exact`] | known limits: dry sliding, rigid film, Hertz, large-β approximation | [`model`] |
//! | [`material`] | measured moduli → relaxation spectrum → retardation spectrum of a substrate | [`input`], [`model`], [`exact`] for spectra |
//! | [`collocation`] | the default solver: panels fitted to the cavitation boundary, Newton's method, error estimate | [`model`], [`exact`], [`continuation`] |
//! | [`relaxation`] | the paper's solver: uniform grid, FFT deformation, Gauss–Seidel passes, Anderson acceleration | [`model`], [`exact`] |
//! | [`continuation`] | lines between cases, predictor, step control, seeds along one chain | [`model`], [`exact`] for the limits beside a solution |
//! | [`engine`] | a rayon pool over chains, interruption, progress | [`continuation`] |
//! | [`fit`] | quantities of the laboratory from measured friction | [`measured`], [`model`], [`collocation`], [`continuation`] |
//! | [`measured`] | measured friction from a CSV file | [`model`], [`sweep`] for units |
//! | [`figures`] | charts: numbers in, SVG or PNG out | – |
//! | [`pictures`] | pictures of a published data set, with their numbers | [`store`], [`model`], [`measured`], [`exact`] for known limits, [`figures`] |
//! | [`report`] | one HTML page of a published data set | [`store`], [`model`], [`measured`], [`pictures`] for names of axes |
//! | [`study`] | error against run time, stability of each method | [`input`], [`sweep`], the solvers, [`engine`], [`figures`] |
//! | [`store`] | log, shards, published files; the only place that touches HDF5 | [`model`] |
//!
//! Equation numbers "Eq. n" are those of Wu, Jagota and Hui, *Lubricated Sliding of a Rigid Cylinder on a Viscoelastic
//! Half Space*, Tribology Letters 70:1 (2022), doi 10.1007/s11249-021-01537-4; "(T n)" those of `docs/theory.md`.

#![deny(unsafe_code)]
#![warn(missing_docs)]

#[cfg(not(any(feature = "static-hdf5", feature = "system-hdf5")))]
compile_error!("choose where HDF5 comes from: feature `static-hdf5` (the default) or `system-hdf5`");

pub mod cli;
pub mod collocation;
pub mod continuation;
pub mod engine;
pub mod exact;
pub mod figures;
pub mod fit;
pub mod input;
pub mod material;
pub mod measured;
pub mod model;
pub mod pictures;
pub mod relaxation;
pub mod report;
mod shown;
pub mod store;
pub mod study;
pub mod sweep;
