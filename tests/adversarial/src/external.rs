//! The external functions that models are declared with.

use lagrangian::Scalar;

/// exp(−s²), without a unit.
#[must_use]
pub fn external_bump<S: Scalar>(s: S) -> S {
    (-s * s).exp()
}

/// sin(s) u², without a unit.
#[must_use]
pub fn external_plane<S: Scalar>(s: S, u: S) -> S {
    s.sin() * u * u
}
