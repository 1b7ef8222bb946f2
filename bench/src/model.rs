//! A model that is measured.

use std::fmt::{self, Display, Formatter};
use std::str::FromStr;

/// A system that every peer knows, with the same numbers for its parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Model {
    /// The symmetric heavy top.
    SymmetricTop,
    /// The general heavy top.
    GeneralTop,
    /// A plane chain of so many point masses.
    Pendulum(usize),
}

impl Model {
    /// The number of coordinates.
    pub(crate) fn degrees(self) -> usize {
        match self {
            Self::SymmetricTop | Self::GeneralTop => 3,
            Self::Pendulum(links) => links,
        }
    }
}

impl Display for Model {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::SymmetricTop => write!(f, "A1"),
            Self::GeneralTop => write!(f, "A2"),
            Self::Pendulum(links) => write!(f, "P{links}"),
        }
    }
}

impl FromStr for Model {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let links = name.strip_prefix('P').and_then(|links| links.parse().ok());
        match (name, links) {
            ("A1", _) => Ok(Self::SymmetricTop),
            ("A2", _) => Ok(Self::GeneralTop),
            (_, Some(links @ 1..=99)) => Ok(Self::Pendulum(links)),
            _ => Err("models are A1, A2, and P1 to P99".to_owned()),
        }
    }
}
