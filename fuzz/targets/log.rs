//! Any bytes between the records of a log.
#![no_main]

#[path = "../../crates/sweep/tests/laws/log.rs"]
mod law;
#[path = "../../crates/sweep/tests/grids/mod.rs"]
mod grids;
#[path = "../../crates/sweep/tests/synthetic/mod.rs"]
mod synthetic;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::check(bytes));
