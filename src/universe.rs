//! The surface that is built in: friction of materials with one retardation mode under a sliding roller, everywhere.
//!
//! It is made by `stribeck surface sweeps/universe.toml`.

use stribeck_surface::Surface;

/// The file of the surface.
pub const TEXT: &str = include_str!("../assets/universe.json");

/// Drag, its parts and c over α from 0 to ∞, β from 1 to 10⁸ and f from 0 to 10⁴.
///
/// # Panics
/// Never: the file is tested.
pub fn universe() -> Surface {
    Surface::parse(TEXT).expect("the file is tested")
}
