//! Seeds of property tests: a fixed one for every run, and a fresh one for their slow twins.

use std::time::{SystemTime, UNIX_EPOCH};

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// So many random cases, the same ones each time.
pub fn with_seed(cases: u32, seed: u64) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(seed), ..ProptestConfig::default() }
}

/// So many random cases, other ones each time. The seed is printed: with [`with_seed`] it gives the same cases again.
pub fn with_fresh_seed(cases: u32) -> ProptestConfig {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).expect("a clock after 1970");
    let seed = since.as_secs().wrapping_mul(1_000_000_000).wrapping_add(u64::from(since.subsec_nanos()));
    println!("seed {seed}");
    with_seed(cases, seed)
}
