//! Maps of axes: from the value of an axis to the variable t of the Chebyshev polynomials, in −1 ≤ t ≤ 1.

use serde::{Deserialize, Serialize};

/// How the values x of an axis are spread: t is linear in z(x).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "map", rename_all = "snake_case")]
pub enum Spread {
    /// z = x.
    Linear,
    /// z = ln x.
    Log,
    /// z = s/(1 + s), s = (x/center)^(1/4): reaches x = 0 and x = ∞, where what is smooth in x or in 1/x is smooth in z.
    Compact {
        /// The x at which z = 1/2.
        center: f64,
    },
}

impl Spread {
    /// z of a value.
    pub fn forward(self, x: f64) -> f64 {
        match self {
            Self::Linear => x,
            Self::Log => x.ln(),
            Self::Compact { .. } if x == f64::INFINITY => 1.0,
            Self::Compact { center } => {
                let s = (x / center).sqrt().sqrt();
                s / (1.0 + s)
            }
        }
    }

    /// dz/dx; infinite at x = 0 of a compact axis.
    pub fn slope(self, x: f64) -> f64 {
        match self {
            Self::Linear => 1.0,
            Self::Log => 1.0 / x,
            Self::Compact { .. } if x == f64::INFINITY => 0.0,
            Self::Compact { center } => {
                let s = (x / center).sqrt().sqrt();
                s / (4.0 * x * (1.0 + s) * (1.0 + s))
            }
        }
    }
}

/// An axis of a surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// Its name, as in sweep files: `alpha`, `speed`.
    pub name: String,
    /// Its unit; `1` for pure numbers.
    pub units: String,
    /// What it is, in words.
    pub long_name: String,
    /// How its values are spread.
    #[serde(flatten)]
    pub spread: Spread,
    /// Its least value.
    pub from: f64,
    /// Its largest value; infinity is the text `inf` in the file.
    #[serde(with = "finite_or_inf")]
    pub to: f64,
}

impl Axis {
    /// True if a value is on the axis.
    pub fn contains(&self, x: f64) -> bool {
        self.from <= x && x <= self.to
    }

    /// t of a value: −1 at the least value, 1 at the largest.
    pub fn forward(&self, x: f64) -> f64 {
        let [from, to] = self.ends();
        // Rounding may lead beyond the end.
        (2.0 * (self.spread.forward(x) - from) / (to - from) - 1.0).clamp(-1.0, 1.0)
    }

    /// dt/dx.
    pub fn slope(&self, x: f64) -> f64 {
        let [from, to] = self.ends();
        2.0 * self.spread.slope(x) / (to - from)
    }

    fn ends(&self) -> [f64; 2] {
        [self.from, self.to].map(|x| self.spread.forward(x))
    }
}

/// A number that may be infinity, which JSON has no number for.
mod finite_or_inf {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    #[serde(untagged)]
    enum Number {
        Finite(f64),
        Text(String),
    }

    pub fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        let number = if value.is_finite() { Number::Finite(*value) } else { Number::Text("inf".to_owned()) };
        number.serialize(serializer)
    }

    pub fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<f64, D::Error> {
        match Number::deserialize(deserializer)? {
            Number::Finite(value) => Ok(value),
            Number::Text(text) if text == "inf" => Ok(f64::INFINITY),
            Number::Text(text) => Err(D::Error::custom(format!("`{text}` is no end of an axis: a number, or \"inf\""))),
        }
    }
}
