//! What laboratories measure of a material: moduli in oscillation, and a modulus that relaxes.

/// A measured modulus: in oscillation at one frequency, or at one time after a step of strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measurement {
    /// E* = E′ + iE″ in oscillation.
    Oscillation {
        /// ω, in rad/s.
        omega: f64,
        /// E′, in Pa.
        storage: f64,
        /// E″, in Pa.
        loss: f64,
    },
    /// E(t), stress over strain after a step of strain.
    Relaxation {
        /// t, in s.
        time: f64,
        /// E(t), in Pa.
        modulus: f64,
    },
}

impl Measurement {
    /// How fast it was measured, in 1/s: ω, or 1/t.
    pub fn rate(&self) -> f64 {
        match *self {
            Self::Oscillation { omega, .. } => omega,
            Self::Relaxation { time, .. } => 1.0 / time,
        }
    }

    /// E′ and E″, or E(t) and zero, in Pa.
    pub fn moduli(&self) -> [f64; 2] {
        match *self {
            Self::Oscillation { storage, loss, .. } => [storage, loss],
            Self::Relaxation { modulus, .. } => [modulus, 0.0],
        }
    }

    /// How many numbers were measured.
    pub fn numbers(&self) -> usize {
        match self {
            Self::Oscillation { .. } => 2,
            Self::Relaxation { .. } => 1,
        }
    }

    /// |E*| or E(t), in Pa.
    pub fn size(&self) -> f64 {
        let [storage, loss] = self.moduli();
        storage.hypot(loss)
    }

    /// The same moduli at rates that are larger by a factor.
    pub fn faster(self, factor: f64) -> Self {
        match self {
            Self::Oscillation { omega, storage, loss } => Self::Oscillation { omega: omega * factor, storage, loss },
            Self::Relaxation { time, modulus } => Self::Relaxation { time: time / factor, modulus },
        }
    }

    /// The same moduli, all larger by a factor.
    pub fn stiffer(self, factor: f64) -> Self {
        match self {
            Self::Oscillation { omega, storage, loss } => {
                Self::Oscillation { omega, storage: storage * factor, loss: loss * factor }
            }
            Self::Relaxation { time, modulus } => Self::Relaxation { time, modulus: modulus * factor },
        }
    }

    /// |E*_a − E*_b|/|E*_b| of two moduli as they come from [`moduli`](Self::moduli).
    pub(super) fn distance([storage, loss]: [f64; 2], from: [f64; 2]) -> f64 {
        (storage - from[0]).hypot(loss - from[1]) / from[0].hypot(from[1])
    }
}

/// Measurements in the order of their rates, at two rates at least.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurements(Vec<Measurement>);

impl Measurements {
    /// The measurements in any order; `None` if they are at fewer than two rates.
    pub fn new(mut rows: Vec<Measurement>) -> Option<Self> {
        rows.sort_by(|a, b| a.rate().total_cmp(&b.rate()));
        let rates = (rows.first()?.rate(), rows.last()?.rate());
        (rates.0 < rates.1).then_some(Self(rows))
    }

    /// The rows, ascending in their rates: slow ones first.
    pub fn rows(&self) -> &[Measurement] {
        &self.0
    }

    /// The lowest and the highest rate, in 1/s.
    pub fn rates(&self) -> (f64, f64) {
        (self.0[0].rate(), self.0[self.0.len() - 1].rate())
    }

    /// How many numbers were measured.
    pub fn numbers(&self) -> usize {
        self.0.iter().map(Measurement::numbers).sum()
    }

    /// All moduli larger by a factor.
    pub fn stiffer(&self, factor: f64) -> Self {
        Self(self.0.iter().map(|row| row.stiffer(factor)).collect())
    }

    /// All of them at rates that are larger by a factor.
    pub fn faster(&self, factor: f64) -> Self {
        Self(self.0.iter().map(|row| row.faster(factor)).collect())
    }
}
