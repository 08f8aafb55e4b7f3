//! Laws of stiff and extreme cases: a right answer, or a reason why there is none.

mod cases;
mod limits;
mod magnitudes;
#[allow(dead_code, reason = "shared with other tests, which need the rest of it")]
#[path = "../../../solver/tests/collocation/measure.rs"]
mod measure;
mod random;
mod sets;
