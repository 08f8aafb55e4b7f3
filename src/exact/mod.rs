//! Limits with known answers.
