//! Names and structure of a system, known at compile time.

/// The generalized coordinates of a system with `N` degrees of freedom: their names, and the structure that is known
/// at compile time.
pub trait GeneralizedCoordinates<const N: usize> {
    /// The names of the coordinates, in order.
    const COORDINATES: [&'static str; N];

    /// Which coordinates are angles: they occur only as arguments of sine, cosine and tangent, so that their
    /// magnitude does not matter to an error estimate.
    const ANGLES: [bool; N] = [false; N];

    /// In which coordinates the accelerations are periodic, and with which period, in full turns: with 2, they are
    /// the same at qᵢ + 4π. It is 1 for an angle that is multiplied by integers where it occurs, 2 where it is halved,
    /// and 1 for an ignorable coordinate, on which nothing depends. 0 if there is no period, or none is known.
    ///
    /// An integration evaluates the accelerations at angles less whole periods, so that an angle that has grown
    /// costs no digits ([`Dynamics::reduced`](crate::Dynamics::reduced)).
    const PERIODS: [u32; N] = [0; N];

    /// Which coordinates are ignorable (cyclic): neither the Lagrangian nor a force depends on them, though they may be
    /// written there and cancel, so that only their change matters to an error estimate.
    ///
    /// A force that does not depend on the coordinate may act on it, as friction does on an axle. Where none does, its
    /// momentum is constant: those coordinates are the
    /// [`IGNORABLE_COORDINATES`](crate::ConstantsOfMotion::IGNORABLE_COORDINATES).
    const IGNORABLE: [bool; N] = [false; N];

    /// For each coordinate, the indices of the coordinates on which the determinant of its block of
    /// the mass matrix depends: they decide where that block is singular. Empty if
    /// it depends on parameters and time only.
    const SINGULARITIES: [&'static [usize]; N] = [&[]; N];

    /// Whether the mass matrix stays regular, and well-conditioned, while only the state changes: whether it is certain that
    /// nothing by which the accelerations are divided comes to vanish, whatever the coordinates and the parameters are.
    /// Then an integration looks at the [relative pivots](crate::Lagrangian::relative_pivots) only where it begins.
    const STAYS_REGULAR: bool = false;

    /// The indices of coordinates of a [reduced model](crate::Routhian) at whose poles sin q = 0 its equations have no value as
    /// they are written, though they have a limit for the constants with which a pole is reached. Empty with the clause
    /// `routhian(Name, half_angles)`, under which they have that value.
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
