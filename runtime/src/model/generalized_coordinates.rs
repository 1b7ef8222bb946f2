//! The names and the structure of a system, known at compile time.

/// The generalized coordinates of a system with `N` degrees of freedom: their names, and the structure that is known at
/// compile time.
pub trait GeneralizedCoordinates<const N: usize> {
    /// The names of the coordinates, in order.
    const COORDINATES: [&'static str; N];

    /// Which coordinates are angles: they occur only as arguments of sine, cosine and tangent, so that their magnitude
    /// does not matter to an error estimate.
    const ANGLES: [bool; N] = [false; N];

    /// The periods of the accelerations in each coordinate, in full turns: with 2, the accelerations agree at qᵢ and
    /// qᵢ + 4π.
    ///
    /// The period is 1 for an angle that is multiplied by integers where it occurs, 2 where it is halved, and 1 for an
    /// ignorable coordinate, on which nothing depends. It is 0 if there is no period, or if none is known.
    ///
    /// An integration evaluates the accelerations at angles reduced by whole periods, so that a large angle does not
    /// cost accuracy ([`Dynamics::reduced`](crate::Dynamics::reduced)).
    const PERIODS: [u32; N] = [0; N];

    /// Which coordinates are ignorable (cyclic): neither the Lagrangian nor a force depends on them.
    ///
    /// They may appear in the declaration and cancel. Only their change matters to an error estimate. A force that does
    /// not depend on the coordinate may still act on it, such as the friction of an axle. If no force acts on it, its
    /// momentum is constant; these coordinates are the
    /// [`IGNORABLE_COORDINATES`](crate::ConstantsOfMotion::IGNORABLE_COORDINATES).
    const IGNORABLE: [bool; N] = [false; N];

    /// For each coordinate, the indices of the coordinates on which the determinant of its block of the mass matrix
    /// depends. They decide where the block is singular. Empty if the determinant depends only on parameters and time.
    const SINGULARITIES: [&'static [usize]; N] = [&[]; N];

    /// Whether the mass matrix is guaranteed to stay regular and well-conditioned while only the state changes: no
    /// divisor of the accelerations can vanish, whatever the values of coordinates and parameters.
    ///
    /// If so, an integration checks the [relative pivots](crate::Lagrangian::relative_pivots) only at its beginning.
    const STAYS_REGULAR: bool = false;

    /// The indices of coordinates of a [reduced model](crate::Routhian) with poles sin q = 0 at which its equations, as
    /// written, have no value.
    ///
    /// The equations do have a limit for the constants with which a pole is reached. The list is empty with the clause
    /// `routhian(Name, half_angles)`, which evaluates this limit.
    const POLES: &'static [usize] = &[];
}

impl<M: GeneralizedCoordinates<N> + ?Sized, const N: usize> GeneralizedCoordinates<N> for &M {
    const COORDINATES: [&'static str; N] = M::COORDINATES;
    const ANGLES: [bool; N] = M::ANGLES;
    const PERIODS: [u32; N] = M::PERIODS;
    const IGNORABLE: [bool; N] = M::IGNORABLE;
    const SINGULARITIES: [&'static [usize]; N] = M::SINGULARITIES;
    const STAYS_REGULAR: bool = M::STAYS_REGULAR;
    const POLES: &'static [usize] = M::POLES;
}
