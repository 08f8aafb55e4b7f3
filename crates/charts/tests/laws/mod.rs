//! Laws on random input, each twice: with a fixed seed, and slowly with a fresh one.

use proptest::test_runner::{Config, RngSeed};

/// A configuration with this many cases, from this seed.
pub(crate) fn config(cases: u32, seed: u64) -> Config {
    Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(seed), ..Config::default() }
}

/// A seed that differs from run to run. A law that fails shows it, to be put in the place of the fixed one.
pub(crate) fn fresh_seed() -> u64 {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).expect("a clock after 1970");
    let seed = now.as_nanos() as u64;
    println!("seed {seed}");
    seed
}

/// Laws in proptest's form, without `#[test]`. Each is a test with the fixed seed, and a slow one with a fresh seed.
macro_rules! laws {
    (seed: $seed:literal, cases: $cases:literal; $($(#[$meta:meta])* fn $name:ident $arguments:tt $body:block)+) => {
        proptest::proptest! {
            #![proptest_config($crate::laws::config($cases, $seed))]
            $($(#[$meta])* #[test] fn $name $arguments $body)+
        }

        mod with_a_fresh_seed {
            use super::*;

            proptest::proptest! {
                #![proptest_config($crate::laws::config($cases, $crate::laws::fresh_seed()))]
                $($(#[$meta])* #[test] #[ignore = "slow: a fresh seed"] fn $name $arguments $body)+
            }
        }
    };
}
pub(crate) use laws;
