//! Names and structure of a system, known at compile time.

/// The generalized coordinates of a system with `N` degrees of freedom: their names, and the structure that is known
/// at compile time.
pub trait GeneralizedCoordinates<const N: usize> {
    /// The names of the coordinates, in order.
    const COORDINATES: [&'static str; N];

    /// Which coordinates are angles: they occur only as arguments of sine, cosine and tangent, so that their
    /// magnitude does not matter to an error estimate. Where they are multiplied by integers there, the motion
    /// is periodic in them.
    const ANGLES: [bool; N] = [false; N];

    /// Which coordinates are ignorable (cyclic): they occur neither in the Lagrangian nor in a force, so that only
    /// their change matters to an error estimate.
    const IGNORABLE: [bool; N] = [false; N];

    /// For each coordinate, the indices of the coordinates on which the determinant of its block of
    /// the mass matrix depends: they decide where that block is singular. Empty if
    /// it depends on parameters and time only.
    const SINGULARITIES: [&'static [usize]; N] = [&[]; N];
}
