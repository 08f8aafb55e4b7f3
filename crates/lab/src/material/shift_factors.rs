//! Shift factors that are given: log₁₀ a_T at temperatures.

/// How far beyond the first and the last temperature a factor is taken, in K.
const BEYOND: f64 = 1.5;

/// log₁₀ a_T at temperatures, falling from cold to warm.
#[derive(Clone, Debug, PartialEq)]
pub struct ShiftFactors(Vec<(f64, f64)>);

impl ShiftFactors {
    /// Pairs of a temperature, in K, and log₁₀ a_T, in any order.
    ///
    /// # Errors
    /// [`ShiftFactorsError`] if there are fewer than two, a temperature stands there twice, or a factor rises with
    /// temperature.
    pub fn new(mut pairs: Vec<(f64, f64)>) -> Result<Self, ShiftFactorsError> {
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        if pairs.len() < 2 {
            return Err(ShiftFactorsError::TooFew);
        }
        for pair in pairs.windows(2) {
            let temperature = pair[1].0;
            if pair[0].0 == temperature {
                return Err(ShiftFactorsError::Twice { temperature });
            }
            if pair[1].1 > pair[0].1 {
                return Err(ShiftFactorsError::Rises { temperature });
            }
        }
        Ok(Self(pairs))
    }

    /// The pairs, in the order of their temperatures.
    pub fn pairs(&self) -> &[(f64, f64)] {
        &self.0
    }

    /// The lowest and the highest temperature, in K.
    pub fn range(&self) -> (f64, f64) {
        (self.0[0].0, self.0[self.0.len() - 1].0)
    }

    /// log₁₀ a_T at a temperature, on the straight line between the next ones; `None` more than 1.5 K outside of them.
    pub fn at(&self, temperature: f64) -> Option<f64> {
        let last = self.0.len() - 1;
        if temperature < self.0[0].0 - BEYOND || temperature > self.0[last].0 + BEYOND {
            return None;
        }
        Some(between(&self.0, temperature))
    }

    /// The temperature at which a_T is 1, in K; `None` if there is none within the temperatures.
    pub fn reference(&self) -> Option<f64> {
        let at = self.0.windows(2).find(|pair| pair[0].1 >= 0.0 && pair[1].1 <= 0.0)?;
        let [(from, low), (to, high)] = [at[0], at[1]];
        Some(if low == high { from } else { from + (to - from) * low / (low - high) })
    }

    /// The same factors at another reference temperature; `None` if it lies outside.
    pub fn at_reference(&self, reference: f64) -> Option<Self> {
        let zero = self.at(reference)?;
        Some(Self(self.0.iter().map(|(temperature, log)| (*temperature, log - zero)).collect()))
    }
}

/// What pairs have at a temperature: on the straight line between the next two.
pub(super) fn between(pairs: &[(f64, f64)], temperature: f64) -> f64 {
    let above = pairs.partition_point(|pair| pair.0 < temperature).clamp(1, pairs.len() - 1);
    let [(from, low), (to, high)] = [pairs[above - 1], pairs[above]];
    low + (high - low) * (temperature - from) / (to - from)
}

/// Why pairs are no shift factors. Messages have degrees Celsius, as laboratories do.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ShiftFactorsError {
    /// Fewer than two.
    #[error("shift factors are given at two temperatures or more")]
    TooFew,
    /// A temperature twice.
    #[error("{:.2} degC has two shift factors; keep one", temperature - 273.15)]
    Twice {
        /// The temperature, in K.
        temperature: f64,
    },
    /// Times that grow with temperature.
    #[error(
        "the shift factor rises up to {:.2} degC, and times fall with temperature: a_T is the time at T over that at the \
         reference, above 1 in the cold (some print its reciprocal)",
        temperature - 273.15
    )]
    Rises {
        /// The temperature, in K.
        temperature: f64,
    },
}
