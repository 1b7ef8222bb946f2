//! The shapes of quantities: scalars, vectors and matrices.

use core::fmt;

use super::label::Index;

/// The shape of a value, as errors speak of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Shape {
    Scalar,
    Array { rows: usize, columns: usize },
}

impl Shape {
    /// How many components there are.
    pub(crate) const fn count(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Array { rows, columns } => rows * columns,
        }
    }

    /// The lengths of a vector or a matrix.
    pub(crate) fn lengths(self) -> Vec<usize> {
        match self {
            Self::Scalar => Vec::new(),
            Self::Array { rows, columns: 1 } => vec![rows],
            Self::Array { rows, columns } => vec![rows, columns],
        }
    }

    /// The index of a component, counted column by column; none for a scalar.
    pub(crate) const fn index(self, component: usize) -> Option<Index> {
        match self {
            Self::Scalar => None,
            Self::Array { columns: 1, .. } => Some(Index::One(component)),
            Self::Array { rows, .. } => Some(Index::Pair {
                row: component % rows,
                column: component / rows,
            }),
        }
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scalar => write!(f, "a scalar"),
            Self::Array { rows, columns: 1 } => write!(f, "a vector of {}", components(*rows)),
            Self::Array { rows: 1, columns } => write!(f, "a row of {}", components(*columns)),
            Self::Array { rows, columns } => write!(f, "a {rows}×{columns} matrix"),
        }
    }
}

fn components(count: usize) -> String {
    if count == 1 {
        "one component".to_owned()
    } else {
        format!("{count} components")
    }
}
