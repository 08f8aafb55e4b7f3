//! How many threads solve.

use std::num::NonZeroUsize;

use stribeck_sweep::campaign::available_threads;

/// Far more than cores, and far fewer than what would use up the memory of a machine with stacks alone.
const MOST: usize = 1024;

/// Reads the value of `--threads`.
pub fn parse(text: &str) -> Result<NonZeroUsize, String> {
    let number = text.parse().ok().and_then(NonZeroUsize::new).filter(|number| number.get() <= MOST);
    number.ok_or_else(|| format!("give a whole number from 1 to {MOST}, or leave it out"))
}

/// As many threads as asked for, else one for each core.
pub fn number(asked: Option<NonZeroUsize>) -> NonZeroUsize {
    asked.unwrap_or_else(available_threads)
}
