//! Laws of materials, units and fits: one module a subject.

mod friction_fit;
mod material;
mod measured;
mod table;
