//! Names of the components of states.

use core::fmt;

/// The name of a component of a state in error messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComponentName {
    /// The coordinate with this name.
    Coordinate(&'static str),
    /// The velocity of the coordinate with this name.
    Velocity(&'static str),
    /// The state of a controller with this index.
    Controller(usize),
    /// A component without a name.
    Index(usize),
}

impl fmt::Display for ComponentName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Coordinate(name) => write!(f, "the coordinate {name}"),
            Self::Velocity(name) => write!(f, "the velocity of {name}"),
            Self::Controller(index) => write!(f, "state {index} of the controller"),
            Self::Index(index) => write!(f, "component {index} of the state"),
        }
    }
}
