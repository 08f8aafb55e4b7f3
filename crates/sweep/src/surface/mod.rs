//! Making a surface: friction and film as functions of one to three axes, to a measured error.
//!
//! A quantity is interpolated by polynomials in the mapped axes. Its nodes are Leja points, whose indices are a lower
//! set: with a node all nodes of smaller indices are there. Where an index changes the interpolant much, its neighbours
//! are added, round by round. Then the surface is compared with solutions at random points that no one chose, and
//! refined until the largest error is below the tolerance. At last the polynomials are written in Tucker form.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `build` | [`build`]: the rounds, the comparison, the file |
//! | `domain` | from a point of the axes to a case, and from its numbers to those of the surface |
//! | `leja` | the nodes along one axis, and the polynomials that belong to them |
//! | `lower_set` | the nodes of a surface: growing, surpluses, Chebyshev coefficients |
//! | `compression` | from Chebyshev coefficients to a Tucker form |
//! | `nodes` | solving cases and storing them |
//! | `comparison` | random points, and the errors there |
//! | `rounds` | how far a surface is, in its directory |

mod build;
mod comparison;
mod compression;
mod domain;
mod leja;
mod lower_set;
mod nodes;
mod rounds;

pub use build::{Progress, SurfaceBuildError, SurfaceOptions, SurfaceReport, build, compare_surface};
pub use rounds::{Round, Rounds};
