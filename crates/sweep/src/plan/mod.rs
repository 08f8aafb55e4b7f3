//! The plan of a sweep: which cases are solved, in what chains, under what ids.
//!
//! [`Plan`] turns a sweep into rows, chains and case ids by index arithmetic. A plan of a billion cases is as small as
//! its axes.
//!
//! | file | what it holds |
//! | --- | --- |
//! | `recipe` | [`Recipe`]: what cases are solved with |
//! | `fingerprint` | [`Fingerprint`]: what makes two cases the same |
//! | `chain` | [`Chain`]: neighbouring cases that are solved one after the other |
//! | `listing` | rows and chains where several places can have the same problem |
//! | `sweep_plan` | [`Plan`] |
//! | `part` | [`Part`]: the chains that one of several machines solves |

mod chain;
mod fingerprint;
mod listing;
mod part;
mod recipe;
mod sweep_plan;

pub use chain::{Chain, MAX_CHAIN};
pub use fingerprint::Fingerprint;
pub use part::{NotAPart, Part};
pub use recipe::{Recipe, SolverRecipe};
pub use sweep_plan::Plan;
