//! Choices that are the same for the same seed.

/// A xorshift generator.
pub struct Random(u64);

impl Random {
    /// The generator of a round. Each round has its own, so that its choices do not depend on how the others went.
    pub fn new(seed: u64, round: u64) -> Self {
        // Neighbouring seeds are brought far apart (splitmix64); xorshift stays at 0, hence the last bit.
        let mut state = seed.wrapping_add(round.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        for factor in [0xbf58_476d_1ce4_e5b9, 0x94d0_49bb_1331_11eb] {
            state = (state ^ (state >> 30)).wrapping_mul(factor);
        }
        Self(state | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A number from 0 up to 1.
    pub fn part(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A whole number below `limit`.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.part() * limit as f64) as usize
    }

    /// How many threads a run has: 1 or 2.
    pub fn threads(&mut self) -> usize {
        1 + self.below(2)
    }

    /// One of these.
    pub fn pick<'a, T>(&mut self, choices: &'a [T]) -> &'a T {
        &choices[self.below(choices.len())]
    }

    /// At least one of these, in any order.
    pub fn some<T>(&mut self, mut choices: Vec<T>) -> Vec<T> {
        let number = 1 + self.below(choices.len());
        (0..number).map(|_| choices.swap_remove(self.below(choices.len()))).collect()
    }

    /// A whole number from 0 to about `2^octaves`, each octave as likely as the others.
    pub fn octave(&mut self, octaves: f64) -> u64 {
        (octaves * self.part()).exp2() as u64 - 1
    }
}
