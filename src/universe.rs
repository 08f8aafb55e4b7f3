//! The surface that is built in: friction of materials with one retardation mode under a sliding roller, everywhere.
//!
//! It is made by `stribeck surface sweeps/universe.toml`.

use miniz_oxide::inflate::decompress_to_vec;
use stribeck_surface::Surface;

const DEFLATED: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/universe.deflate"));

/// The file of the surface, `assets/universe.json`.
///
/// # Panics
/// Never: the program holds it whole.
pub fn text() -> String {
    let bytes = decompress_to_vec(DEFLATED).expect("the build deflated it");
    String::from_utf8(bytes).expect("it is text")
}

/// Drag, its parts and c over α from 0 to ∞, β from 1 to 10⁸ and f from 0 to 10⁴.
///
/// # Panics
/// Never: the file is tested.
pub fn universe() -> Surface {
    Surface::parse(&text()).expect("the file is tested")
}
