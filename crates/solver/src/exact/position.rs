//! Places in a dry contact.

/// A place in the contact: its distances to the two edges over the width, sin²(θ/2) and cos²(θ/2).
#[derive(Clone, Copy)]
pub(super) struct Position {
    pub(super) to_leading: f64,
    pub(super) to_trailing: f64,
}

impl Position {
    pub(super) const LEADING_EDGE: Self = Self { to_leading: 0.0, to_trailing: 1.0 };

    /// The place where ln tan(θ/2) has the given value.
    pub(super) fn at(ln_tan: f64) -> Self {
        let squared = (2.0 * ln_tan).exp();
        Self { to_leading: squared / (1.0 + squared), to_trailing: 1.0 / (1.0 + squared) }
    }

    /// θ, 0 at the leading edge and π at the trailing edge.
    pub(super) fn angle(&self) -> f64 {
        2.0 * self.to_leading.sqrt().atan2(self.to_trailing.sqrt())
    }

    /// The place so many contact widths ahead.
    pub(super) fn ahead(&self, distance: f64) -> Self {
        Self { to_leading: self.to_leading - distance, to_trailing: self.to_trailing + distance }
    }

    /// The angle between this place and one `distance` contact widths ahead, without loss if it is small.
    pub(super) fn angle_to(&self, ahead: Self, distance: f64) -> f64 {
        let a = (self.to_leading * ahead.to_trailing).sqrt();
        let b = (self.to_trailing * ahead.to_leading).sqrt();
        let cos = (self.to_trailing * ahead.to_trailing).sqrt() + (self.to_leading * ahead.to_leading).sqrt();
        2.0 * (distance / (a + b)).atan2(cos)
    }
}
