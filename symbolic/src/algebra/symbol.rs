//! Symbols: the leaves that expressions depend on.

/// A quantity that has a value at each instant. Indices count within each kind.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Symbol {
    /// Time t.
    Time,
    /// A coordinate qᵢ.
    Coordinate(u32),
    /// A velocity q̇ᵢ.
    Velocity(u32),
    /// An acceleration q̈ᵢ.
    Acceleration(u32),
    /// A parameter: constant in time.
    Parameter(u32),
    /// An input: a given function of time, its derivative unknown.
    Input(u32),
    /// An invariant: a value that depends on parameters alone, computed by the setup program; in the recurrence of a
    /// [Taylor series](crate::TaylorProgram), a value that does not depend on the order.
    Invariant(u32),
    /// An argument of an external function, in the expressions of its declared derivatives.
    Argument(u32),
    /// The order k, in the recurrence of a Taylor series.
    Order,
    /// 1/k.
    ReciprocalOrder,
    /// A [convolution](crate::Convolution) of terms of orders below k.
    Convolution(u32),
    /// A quasi-velocity wᵢ, in [equations of first order](crate::QuasiVelocityEquations).
    QuasiVelocity(u32),
    /// Its rate ẇᵢ, in formulas that are printed.
    QuasiVelocityRate(u32),
    /// A component rᵢ of the right-hand side of M x = r, in [implicit equations](crate::ImplicitEquations).
    RightHandSide(u32),
    /// A component of a vector that is not resolved yet and depends on positions alone, where a
    /// [declared system](crate::DeclaredSystem) is evaluated with whole vectors.
    PositionComponent(u32),
    /// The same of a vector that depends on velocities.
    VelocityComponent(u32),
    /// A component of a variation of the state: δq, then δq̇, then δt.
    Variation(u32),
}

impl Symbol {
    /// One of 64 bits, of its own where there are few symbols.
    pub(crate) const fn bit(self) -> u64 {
        let (kind, index) = self.code();
        1 << ((11 * kind + index as u64) % 64)
    }

    /// The number of the kind, and the index within it.
    pub(crate) const fn code(self) -> (u64, u32) {
        match self {
            Self::Time => (0, 0),
            Self::Coordinate(index) => (1, index),
            Self::Velocity(index) => (2, index),
            Self::Acceleration(index) => (3, index),
            Self::Parameter(index) => (4, index),
            Self::Input(index) => (5, index),
            Self::Invariant(index) => (6, index),
            Self::Argument(index) => (7, index),
            Self::Order => (8, 0),
            Self::ReciprocalOrder => (9, 0),
            Self::Convolution(index) => (10, index),
            Self::QuasiVelocity(index) => (11, index),
            Self::PositionComponent(index) => (12, index),
            Self::VelocityComponent(index) => (13, index),
            Self::QuasiVelocityRate(index) => (14, index),
            Self::RightHandSide(index) => (15, index),
            Self::Variation(index) => (16, index),
        }
    }
}
