//! Surfaces: friction of a lubricated soft contact as a function in a file.
//!
//! `stribeck surface` makes `surface.json`, which has every quantity asked for at any point of its domain, to a
//! measured error. This crate reads such a file and evaluates it in microseconds.
//!
//! ```no_run
//! use stribeck_surface::Surface;
//!
//! let surface = Surface::read("results/universe/surface.json")?;
//! let mut evaluator = surface.evaluator();
//! let values = evaluator.values(&[1.0, 100.0, 10.0])?;
//! for (name, value) in surface.quantities().zip(values) {
//!     println!("{name} = {value}");
//! }
//! let (values, derivatives) = evaluator.derivatives(&[1.0, 100.0, 10.0])?;
//! println!("{} changes by {} for each unit of the first axis", values[0], derivatives[0]);
//! let mut along_beta = evaluator.line(1, &[1.0, 0.0, 10.0])?;
//! println!("{:?}", along_beta.values(200.0)?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A point outside the domain is an error: nothing is extrapolated.

mod error;
mod evaluator;
mod file;
mod map;
mod surface;
mod tensor;

pub use error::{Outside, SurfaceError};
pub use evaluator::{Evaluator, Line};
pub use file::{Certificate, CheckPoint, ErrorRecord, FORMAT, NumberKind, QuantityRecord, SurfaceFile, Transform};
pub use map::{Axis, Spread};
pub use surface::{Surface, encode};
pub use tensor::chebyshev;
