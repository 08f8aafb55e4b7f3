//! Where the contact lies, for placing a grid.

use super::DryContact;
use crate::model::Parameters;

/// (trailing edge, leading edge, half width) of the contact without a film, over a₀: an estimate for placing a grid.
///
/// With one retardation time these are the edges of [`DryContact`]. With several it is the hull of the contacts that
/// each mode would have alone with the whole of f. That is a place to look, not a solution, which is
/// [`DrySliding`](super::DrySliding).
pub fn contact_bounds(parameters: &Parameters) -> (f64, f64, f64) {
    let modes = parameters.substrate.modes().iter();
    let contacts = modes.map(|mode| DryContact::new(parameters.alpha / mode.time, parameters.f));
    let (trailing, leading) = contacts.fold((f64::INFINITY, f64::NEG_INFINITY), |(trailing, leading), contact| {
        (f64::min(trailing, contact.trailing_edge()), f64::max(leading, contact.leading_edge()))
    });
    (trailing, leading, 0.5 * (leading - trailing))
}
