//! Any bytes as a sweep file.
#![no_main]

#[path = "../../crates/sweep/tests/laws/sweep_file.rs"]
mod law;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::check(bytes));
