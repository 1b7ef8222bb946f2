//! The axes of a Cartesian frame.

/// An axis of a right-handed frame, about which a rotation goes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[allow(missing_docs)] // Each is the axis of that name.
pub enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// All of them, in order.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// The positions of this axis and of the two that follow it in a right-handed frame.
    #[must_use]
    pub const fn cycle(self) -> [usize; 3] {
        match self {
            Self::X => [0, 1, 2],
            Self::Y => [1, 2, 0],
            Self::Z => [2, 0, 1],
        }
    }
}
