//! Sweep files, and the plan made of them.
