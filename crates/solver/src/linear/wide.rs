//! Loops over vectors as wide as the processor has them.

/// Does some work with the widest vectors that the processor has; only what is inlined into it is built for them, so
/// mark the closure and the functions that it calls `#[inline(always)]`. It does the same operations in the same order
/// with any vectors, and gives the same bits; `mul_add` is fast here alone.
#[inline(always)]
pub fn wide<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}
