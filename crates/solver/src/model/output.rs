//! What a sweep wants to know of each case.

use std::fmt;
use std::sync::Arc;

/// What fills the gap behind the outlet (θ in the cavity's part of F_h).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum CavityShear {
    /// The gap is full of fluid: θ = 1 (Eq. 20 as printed).
    #[default]
    Full,
    /// Streamers that keep the flow: θ = c/u.
    Streamers,
    /// No shear behind the outlet: θ = 0.
    None,
}

impl fmt::Display for CavityShear {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            CavityShear::Full => "full",
            CavityShear::Streamers => "streamers",
            CavityShear::None => "none",
        })
    }
}

impl CavityShear {
    /// What the choice means for friction.
    pub fn meaning(self) -> &'static str {
        match self {
            CavityShear::Full => "the gap behind the film is full of fluid: an upper bound",
            CavityShear::Streamers => {
                "behind the film there is the fluid that leaves it: the choice that carries the flow"
            }
            CavityShear::None => "no fluid shears behind the film: a lower bound",
        }
    }
}

/// Which fields to evaluate. What is not asked for is not computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FieldSelection {
    /// p(x).
    pub pressure: bool,
    /// u(x).
    pub film_thickness: bool,
    /// w(x).
    pub displacement: bool,
    /// Shear on the roller's surface.
    pub shear_traction: bool,
    /// (2/π) p w′, the part of the pressure that does the work of the hysteresis.
    pub hysteresis_traction: bool,
}

impl FieldSelection {
    /// Every field.
    pub const ALL: Self = Self {
        pressure: true,
        film_thickness: true,
        displacement: true,
        shear_traction: true,
        hysteresis_traction: true,
    };

    /// True if no field is asked for.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// What to evaluate once a case is solved.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// The fields wanted.
    pub fields: FieldSelection,
    /// Where the fields are wanted, ascending, in units of a₀.
    pub x: Arc<[f64]>,
    /// Whether the dry limit and the large-β approximation are wanted.
    pub limits: bool,
    /// What fills the gap behind the outlet.
    pub cavity_shear: CavityShear,
    /// Whether the derivatives of friction with respect to α, β and f are wanted; only the collocation method has them.
    pub sensitivities: bool,
}

impl Output {
    /// What every solution has: friction, film and their errors; no fields, limits or sensitivities.
    pub fn numbers() -> Self {
        Self { fields: FieldSelection::default(), limits: false, ..Self::default() }
    }
}

impl Default for Output {
    /// All fields at 601 points from −3 to 3, limits, a full cavity, no sensitivities.
    fn default() -> Self {
        let x = (0..=600).map(|i| f64::from(i - 300) / 100.0).collect();
        Self { fields: FieldSelection::ALL, x, limits: true, cavity_shear: CavityShear::Full, sensitivities: false }
    }
}
