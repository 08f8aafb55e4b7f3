//! How fast the two surfaces move: a roller that slides, or that rolls and slides.

use crate::LaboratoryQuantity as Quantity;

/// The speeds of both surfaces, in m/s, in the form in which they are given.
///
/// In the frame of the contact both surfaces move the same way, the roller's with u₁ ≥ 0 and the flat's with u₂ ≥ 0,
/// not both 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// The roller does not turn, and slides over the flat: u₁ = 0, u₂ = V.
    Sliding {
        /// V.
        speed: f64,
    },
    /// The roller turns.
    Rolling {
        /// U = (u₁ + u₂)/2 (T52).
        entrainment_speed: f64,
        /// (u₂ − u₁)/U, from −2 to 2 (T52); 2 is a roller that does not turn, 0 is pure rolling.
        slide_roll_ratio: f64,
    },
    /// Each speed by itself.
    Surfaces {
        /// u₁.
        roller_speed: f64,
        /// u₂.
        flat_speed: f64,
    },
}

impl Motion {
    /// u₁, the speed of the roller's surface.
    pub fn roller_speed(&self) -> f64 {
        match *self {
            Self::Sliding { .. } => 0.0,
            Self::Rolling { entrainment_speed, slide_roll_ratio } => entrainment_speed * (1.0 - 0.5 * slide_roll_ratio),
            Self::Surfaces { roller_speed, .. } => roller_speed,
        }
    }

    /// u₂, the speed of the flat.
    pub fn flat_speed(&self) -> f64 {
        match *self {
            Self::Sliding { speed } => speed,
            Self::Rolling { entrainment_speed, slide_roll_ratio } => entrainment_speed * (1.0 + 0.5 * slide_roll_ratio),
            Self::Surfaces { flat_speed, .. } => flat_speed,
        }
    }

    /// u₁ + u₂, the speed in β (T52).
    pub fn sum(&self) -> f64 {
        match *self {
            Self::Sliding { speed } => speed,
            Self::Rolling { entrainment_speed, .. } => 2.0 * entrainment_speed,
            Self::Surfaces { roller_speed, flat_speed } => roller_speed + flat_speed,
        }
    }

    /// S = (u₂ − u₁)/(u₁ + u₂), half of the slide-to-roll ratio (T52).
    pub fn slide_roll(&self) -> f64 {
        match *self {
            Self::Sliding { .. } => 1.0,
            Self::Rolling { slide_roll_ratio, .. } => 0.5 * slide_roll_ratio,
            Self::Surfaces { roller_speed, flat_speed } => (flat_speed - roller_speed) / (flat_speed + roller_speed),
        }
    }

    /// The quantities that it is given by; the last one is what curves run along.
    pub fn given(&self) -> &'static [Quantity] {
        match self {
            Self::Sliding { .. } => &[Quantity::Speed],
            Self::Rolling { .. } => &[Quantity::SlideRollRatio, Quantity::EntrainmentSpeed],
            Self::Surfaces { .. } => &[Quantity::RollerSpeed, Quantity::FlatSpeed],
        }
    }

    /// The quantity that curves run along, and its value.
    pub fn along(&self) -> (Quantity, f64) {
        let last = *self.given().last().expect("each form has a speed");
        (last, self.value(last))
    }

    /// The value of a quantity of the motion, be it given or not.
    ///
    /// # Panics
    /// If the quantity is none of the motion.
    pub fn value(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Speed => self.sum() * self.slide_roll(),
            Quantity::EntrainmentSpeed => 0.5 * self.sum(),
            Quantity::SlideRollRatio => 2.0 * self.slide_roll(),
            Quantity::RollerSpeed => self.roller_speed(),
            Quantity::FlatSpeed => self.flat_speed(),
            other => panic!("{} is no speed", other.name()),
        }
    }

    /// Sets a quantity. One that belongs to another form changes the form, whose other quantity is unknown then.
    pub fn set(&mut self, quantity: Quantity, value: f64) {
        *self = match (quantity, *self) {
            (Quantity::EntrainmentSpeed, Self::Rolling { slide_roll_ratio, .. }) => {
                Self::Rolling { entrainment_speed: value, slide_roll_ratio }
            }
            (Quantity::EntrainmentSpeed, _) => Self::Rolling { entrainment_speed: value, slide_roll_ratio: f64::NAN },
            (Quantity::SlideRollRatio, Self::Rolling { entrainment_speed, .. }) => {
                Self::Rolling { entrainment_speed, slide_roll_ratio: value }
            }
            (Quantity::SlideRollRatio, _) => Self::Rolling { entrainment_speed: f64::NAN, slide_roll_ratio: value },
            (Quantity::RollerSpeed, Self::Surfaces { flat_speed, .. }) => {
                Self::Surfaces { roller_speed: value, flat_speed }
            }
            (Quantity::RollerSpeed, _) => Self::Surfaces { roller_speed: value, flat_speed: f64::NAN },
            (Quantity::FlatSpeed, Self::Surfaces { roller_speed, .. }) => {
                Self::Surfaces { roller_speed, flat_speed: value }
            }
            (Quantity::FlatSpeed, _) => Self::Surfaces { roller_speed: f64::NAN, flat_speed: value },
            _ => Self::Sliding { speed: value },
        };
    }

    /// By which powers u₁, u₂ and u₁ + u₂ change with a quantity that is given, and how S does: d ln u₁, d ln u₂,
    /// d ln(u₁ + u₂) and dS, each over d ln q.
    pub(crate) fn powers(&self, quantity: Quantity) -> [f64; 4] {
        let (roller, flat) = (self.roller_speed() / self.sum(), self.flat_speed() / self.sum());
        let slide_roll = self.slide_roll();
        match quantity {
            Quantity::SlideRollRatio => {
                [-slide_roll / (1.0 - slide_roll), slide_roll / (1.0 + slide_roll), 0.0, slide_roll]
            }
            Quantity::RollerSpeed => [1.0, 0.0, roller, -2.0 * roller * flat],
            Quantity::FlatSpeed => [0.0, 1.0, flat, 2.0 * roller * flat],
            _ => [1.0, 1.0, 1.0, 0.0],
        }
    }
}
