//! How many threads solve.

use std::num::NonZeroUsize;

/// Far more than cores, and far fewer than what would use up the memory of a machine with stacks alone.
const MOST: usize = 1024;

/// Reads the value of `--threads`.
pub fn parse(text: &str) -> Result<NonZeroUsize, String> {
    let number = text.parse().ok().and_then(NonZeroUsize::new).filter(|number| number.get() <= MOST);
    number.ok_or_else(|| format!("give a whole number from 1 to {MOST}, or leave it out"))
}

/// As many threads as asked for, else one for each core.
pub fn number(asked: Option<NonZeroUsize>) -> NonZeroUsize {
    // Where the system does not tell its cores there is at least the one that runs this.
    asked.unwrap_or_else(|| std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN))
}
