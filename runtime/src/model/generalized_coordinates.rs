//! What is known of a system before any number is.

/// The names and the structure of a system with `N` degrees of freedom, known at compile time.
pub trait GeneralizedCoordinates<const N: usize> {
    /// The names of the coordinates, in order.
    const COORDINATES: [&'static str; N];

    /// Which coordinates are angles: they occur only inside of sine, cosine and tangent, so that their size
    /// means nothing to an error estimate. Where they are multiplied by whole numbers there, the motion
    /// repeats after a whole turn.
    const ANGLES: [bool; N] = [false; N];

    /// Which coordinates are ignorable: they occur neither in the Lagrangian nor in a force, so that only
    /// their change means something to an error estimate.
    const IGNORABLE: [bool; N] = [false; N];

    /// For each coordinate, the indices of the coordinates on which the determinant of its block of
    /// the mass matrix depends: where that block is singular, these are what to look at. Empty if
    /// only parameters and time decide.
    const SINGULARITIES: [&'static [usize]; N] = [&[]; N];
}
