//! What an expression depends on.

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
    /// An input: varies in time, set from outside, its rate unknown.
    Input(u32),
    /// What was computed beforehand from parameters alone.
    Prepared(u32),
    /// An argument of a function from outside, in the expressions that are its derivatives.
    Argument(u32),
}
