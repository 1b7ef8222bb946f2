//! The factors of which a matrix of three rows and columns is the product.

use crate::geometry::axis::Axis;
use crate::{Expression, Graph, Rational, Unary};

/// A factor of a product of matrices of three rows and columns.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Factor {
    /// The rotation by an angle about an axis.
    Turn(Turn),
    /// Any matrix, by its elements, column by column.
    Written([Expression; 9]),
}

/// A rotation by an angle about an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    pub(crate) axis: Axis,
    pub(crate) angle: Expression,
    /// Whether it goes by the opposite of the angle.
    pub(crate) reversed: bool,
}

impl Factor {
    /// The transpose: of a rotation, the one back.
    pub(crate) fn transpose(&self) -> Self {
        match *self {
            Self::Turn(turn) => Self::Turn(Turn {
                reversed: !turn.reversed,
                ..turn
            }),
            Self::Written(elements) => {
                Self::Written(core::array::from_fn(|n| elements[n % 3 * 3 + n / 3]))
            }
        }
    }

    /// The elements, column by column.
    pub(crate) fn elements(self, graph: &mut Graph) -> [Expression; 9] {
        match self {
            Self::Turn(turn) => turn.elements(graph),
            Self::Written(elements) => elements,
        }
    }

    /// The factor times a vector.
    pub(crate) fn apply(self, graph: &mut Graph, vector: [Expression; 3]) -> [Expression; 3] {
        let elements = self.elements(graph);
        let row = |i: usize| [0, 1, 2].map(|j| (elements[3 * j + i], vector[j]));
        [0, 1, 2].map(|i| graph.sum_of_products(row(i)))
    }

    /// Whether this is the factor 1.
    fn is_identity(self, graph: &Graph) -> bool {
        match self {
            Self::Turn(turn) => graph.is_zero(turn.angle),
            Self::Written(elements) => elements == identity(graph),
        }
    }
}

impl Turn {
    /// The sign with which the angle counts.
    pub(crate) const fn sign(self) -> Rational {
        if self.reversed {
            Rational::MINUS_ONE
        } else {
            Rational::ONE
        }
    }

    fn elements(self, graph: &mut Graph) -> [Expression; 9] {
        let [_, j, k] = self.axis.cycle();
        let cosine = graph.unary(Unary::Cos, self.angle);
        let sine = graph.unary(Unary::Sin, self.angle);
        let sine = graph.scale(sine, &self.sign());
        let mut elements = identity(graph);
        elements[3 * j + j] = cosine;
        elements[3 * k + k] = cosine;
        elements[3 * j + k] = sine;
        elements[3 * k + j] = graph.negate(sine);
        elements
    }

    /// This and the next rotation as one, if both are about the same axis.
    fn then(self, next: Self, graph: &mut Graph) -> Option<Self> {
        let next_sign = if self.reversed == next.reversed {
            Rational::ONE
        } else {
            Rational::MINUS_ONE
        };
        (self.axis == next.axis).then(|| Self {
            angle: graph.sum([(self.angle, Rational::ONE), (next.angle, next_sign)]),
            ..self
        })
    }
}

/// The elements of the identity.
fn identity(graph: &Graph) -> [Expression; 9] {
    core::array::from_fn(|n| {
        if n % 4 == 0 {
            graph.one()
        } else {
            graph.zero()
        }
    })
}

impl Graph {
    /// The same product with fewer factors: neighbours about one axis are one rotation, and factors that
    /// do nothing are none.
    pub(crate) fn merged(&mut self, factors: impl IntoIterator<Item = Factor>) -> Vec<Factor> {
        let mut merged: Vec<Factor> = Vec::new();
        for mut factor in factors {
            if let (Some(Factor::Turn(last)), Factor::Turn(turn)) = (merged.last(), factor)
                && let Some(both) = last.then(turn, self)
            {
                merged.pop();
                factor = Factor::Turn(both);
            }
            if !factor.is_identity(self) {
                merged.push(factor);
            }
        }
        merged
    }
}
