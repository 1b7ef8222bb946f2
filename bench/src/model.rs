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
    /// The general heavy top, its kinetic energy expanded.
    GeneralTopMultipliedOut,
    /// Two links, the kinetic energy expanded.
    DoublePendulumMultipliedOut,
    /// An arm of three joints that motors turn.
    Arm,
    /// Three bodies in a plane that attract each other.
    ThreeBodies,
}

impl Model {
    /// The number of coordinates.
    pub(crate) fn degrees(self) -> usize {
        match self {
            Self::SymmetricTop | Self::GeneralTop | Self::GeneralTopMultipliedOut | Self::Arm => 3,
            Self::ThreeBodies => 6,
            Self::DoublePendulumMultipliedOut => 2,
            Self::Pendulum(links) => links,
        }
    }

    /// The system that is modelled, as peers know it: to them it does not matter how it is spelt.
    pub(crate) fn system(self) -> Self {
        match self {
            Self::GeneralTopMultipliedOut => Self::GeneralTop,
            Self::DoublePendulumMultipliedOut => Self::Pendulum(2),
            other => other,
        }
    }
}

impl Display for Model {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::SymmetricTop => write!(f, "A1"),
            Self::GeneralTop => write!(f, "A2"),
            Self::GeneralTopMultipliedOut => write!(f, "A2m"),
            Self::DoublePendulumMultipliedOut => write!(f, "P2m"),
            Self::Pendulum(links) => write!(f, "P{links}"),
            Self::Arm => write!(f, "arm"),
            Self::ThreeBodies => write!(f, "figure-eight"),
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
            ("A2m", _) => Ok(Self::GeneralTopMultipliedOut),
            ("P2m", _) => Ok(Self::DoublePendulumMultipliedOut),
            ("arm", _) => Ok(Self::Arm),
            ("figure-eight", _) => Ok(Self::ThreeBodies),
            (_, Some(links @ 1..=99)) => Ok(Self::Pendulum(links)),
            _ => Err("models are A1, A2, A2m, P2m, arm, figure-eight, and P1 to P99".to_owned()),
        }
    }
}
