//! The laws by which temperature shifts the times of a material.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `shift_law` | [`ShiftLaw`]: times over those at a reference temperature, by Williams, Landel and Ferry or by Arrhenius |
//! | `shift_law_fit` | [`ShiftLawFit`]: the law that fits measured shift factors |

mod shift_law;
mod shift_law_fit;

pub use shift_law::{GAS_CONSTANT, ShiftLaw};
pub use shift_law_fit::ShiftLawFit;
pub(crate) use shift_law_fit::least_of;
