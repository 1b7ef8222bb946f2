//! The functions from outside that models are declared with.

use lagrangian::Scalar;

/// exp(−s²).
pub(crate) fn outside_bump<S: Scalar>(s: S) -> S {
    (-s * s).exp()
}

/// sin(s) u².
pub(crate) fn outside_plane<S: Scalar>(s: S, u: S) -> S {
    s.sin() * u * u
}
