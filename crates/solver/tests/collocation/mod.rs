//! Laws of the collocation solver: what it must give whatever it does inside.

mod agreement;
mod cases;
mod chains;
mod efficiency;
mod estimates;
mod fields;
mod forces;
mod identities;
mod instrument;
mod limits;
mod measure;
mod random;
mod range;
mod reference;
mod sensitivities;
mod table;
mod tolerance;
