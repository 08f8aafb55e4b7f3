//! Any bytes between the records of a log.
#![no_main]

#[path = "../../tests/laws/log.rs"]
mod law;
#[path = "../../tests/synthetic/mod.rs"]
mod synthetic;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::check(bytes));
