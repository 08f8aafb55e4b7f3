//! Speeds of the cylinder that are given as turns.

use crate::{Dimension, LaboratoryQuantity};
use stribeck_input::{Entry, Fault, Values};

/// A quantity whose values may be turns of the cylinder: times its radius they are speeds.
pub struct Turning {
    quantity: LaboratoryQuantity,
    radius: Result<f64, &'static str>,
}

impl Turning {
    /// Values of a quantity beside a radius (m), or beside none, with the reason in words that follow "but".
    pub fn new(quantity: LaboratoryQuantity, radius: Result<f64, &'static str>) -> Self {
        Self { quantity, radius }
    }

    /// True for the speeds of what turns with the cylinder.
    pub fn is_of(quantity: LaboratoryQuantity) -> bool {
        matches!(quantity, LaboratoryQuantity::Speed | LaboratoryQuantity::RollerSpeed)
    }

    /// The turns in an entry (rad/s); `None` where it has none, or may have none.
    fn turns(&self, entry: &Entry<'_>) -> Option<f64> {
        if !Self::is_of(self.quantity) || !entry.is_text() {
            return None;
        }
        entry.text().ok().and_then(|text| Dimension::AngularFrequency.parse(text).ok())
    }
}

impl Values for Turning {
    /// A value of the quantity, or turns times the radius.
    fn read(&self, entry: &Entry<'_>) -> Result<f64, Fault> {
        let Some(turns) = self.turns(entry) else { return self.quantity.read(entry) };
        let radius = self.radius.map_err(|why| {
            let what = format!("`{}` is in turns, which one radius makes a speed, but {why}", entry.path());
            let help = "give one `radius`, or the speed in m/s: 1 rpm is 2π/60 times the radius per second";
            entry.fault(what, "turns, not a speed", help)
        })?;
        self.quantity.read_value(entry, turns * radius)
    }
}
