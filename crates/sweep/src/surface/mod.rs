//! Making a surface: friction and film as functions of one to three axes, to a measured error.
//!
//! Along one axis a quantity is a polynomial in the mapped coordinate, through Leja points. Along all axes it is a sum
//! of products of few functions of one coordinate (a cross approximation). Lines along each axis tell these functions;
//! the grid of the few nodes that tell them apart tells the factors of the products. The surface is compared with
//! solutions at random points. Where it is worst, lines are added, until fresh points show no error above the tolerance.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `build` | [`build`]: from a sweep file to the file of the surface |
//! | `refinement` | the rounds: lines, grid, random points |
//! | `draft` | from a cross to the file of a surface: compression, certificate |
//! | `domain` | from a point of the axes to a case, and from its numbers to those of the surface |
//! | `leja` | the nodes along one axis, and the polynomials that belong to them |
//! | `lines` | lines along one axis, with as many nodes as they need |
//! | `basis` | the functions of one coordinate, and the nodes that tell them apart |
//! | `cross` | the cross approximation |
//! | `compression` | tensors, and their Tucker form of lower rank |
//! | `nodes` | solving cases and storing them |
//! | `comparison` | random points, and the errors there |
//! | `rounds` | how far a surface is, in its directory |

mod basis;
mod build;
mod comparison;
mod compression;
mod cross;
mod domain;
mod draft;
mod leja;
mod lines;
mod matrix;
mod nodes;
mod refinement;
mod rounds;

pub use build::{Progress, SurfaceBuildError, SurfaceOptions, SurfaceReport, build, compare_surface};
pub use rounds::{Round, Rounds};
