//! Any bytes in the place of a shard.
#![no_main]

#[path = "../../crates/sweep/tests/laws/shard.rs"]
mod law;
#[path = "../../crates/sweep/tests/grids/mod.rs"]
mod grids;
#[path = "../../crates/sweep/tests/synthetic/mod.rs"]
mod synthetic;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::check(bytes));
