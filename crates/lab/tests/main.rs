//! Laws of materials, units and fits: one module a subject.

mod dialects;
mod friction_fit;
mod material;
mod measured;
mod table;
