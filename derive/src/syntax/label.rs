//! The names of components: a name with its indices.

use core::fmt;

use super::body_quantity::BodyQuantity;

/// A name with its indices, such as `theta[2]` or `inertia[(0, 1)]`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Label {
    pub(crate) stem: String,
    pub(crate) indices: Vec<Index>,
}

impl Label {
    /// The name of a local variable: `theta_2`, `inertia_0_1`.
    pub(crate) fn variable(&self) -> String {
        let mut parts = vec![self.stem.clone()];
        parts.extend(self.indices.iter().map(|index| index.word()));
        parts.join("_")
    }

    /// The name of the momentum of a coordinate: `p_theta_2`.
    pub(crate) fn momentum(&self) -> String {
        format!("p_{}", self.variable())
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.stem)?;
        self.indices
            .iter()
            .try_for_each(|index| write!(f, "{index}"))
    }
}

/// One index.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Index {
    /// `[i]`.
    One(usize),
    /// `[(row, column)]`.
    Pair { row: usize, column: usize },
    /// `.x`, `.y`, `.z` or `.w`.
    Axis(usize),
    /// `.mass`, `.center` or `.inertia` of a body.
    Quantity(BodyQuantity),
}

impl Index {
    /// The names of the components of vectors.
    pub(crate) const AXES: [&'static str; 4] = ["x", "y", "z", "w"];

    /// The index as a part of the name of a variable.
    pub(crate) fn word(self) -> String {
        match self {
            Self::One(i) => i.to_string(),
            Self::Pair { row, column } => format!("{row}_{column}"),
            Self::Axis(i) => Self::AXES.get(i).copied().unwrap_or_default().to_owned(),
            Self::Quantity(quantity) => quantity.name().to_owned(),
        }
    }
}

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::One(i) => write!(f, "[{i}]"),
            Self::Pair { row, column } => write!(f, "[({row}, {column})]"),
            Self::Axis(_) | Self::Quantity(_) => write!(f, ".{}", self.word()),
        }
    }
}
