//! Any bytes as a table of measured points, and as one of a material.
#![no_main]

#[path = "../../crates/lab/tests/laws/table.rs"]
mod law;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    law::check(bytes);
    law::check_material(bytes);
});
