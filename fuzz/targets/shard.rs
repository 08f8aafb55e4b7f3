//! Any bytes in the place of a shard.
#![no_main]

#[path = "../../tests/laws/shard.rs"]
mod law;
#[path = "../../tests/synthetic/mod.rs"]
mod synthetic;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::check(bytes));
