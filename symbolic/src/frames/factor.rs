//! The factors of a product of 3 × 3 matrices, elementary rotations above all.

use crate::frames::axis::Axis;
use crate::{Expression, Graph, Rational, Unary};

/// A factor of a product of 3 × 3 matrices.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum MatrixFactor {
    /// The rotation by an angle about an axis.
    Elementary(ElementaryRotation),
    /// A matrix that is a rotation identically, by its elements, column by column.
    Rotation([Expression; 9]),
    /// Any other matrix, by its elements, column by column.
    General([Expression; 9]),
}

/// A rotation by an angle about an axis.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct ElementaryRotation {
    pub(crate) axis: Axis,
    pub(crate) angle: Expression,
    /// Whether the rotation is by the opposite of the angle.
    pub(crate) reversed: bool,
}

impl MatrixFactor {
    /// The transpose: of a rotation, its inverse.
    pub(crate) fn transpose(&self) -> Self {
        match *self {
            Self::Elementary(rotation) => Self::Elementary(ElementaryRotation {
                reversed: !rotation.reversed,
                ..rotation
            }),
            Self::Rotation(elements) => Self::Rotation(transposed(&elements)),
            Self::General(elements) => Self::General(transposed(&elements)),
        }
    }

    /// The elements, column by column.
    pub(crate) fn elements(self, graph: &mut Graph) -> [Expression; 9] {
        match self {
            Self::Elementary(rotation) => rotation.elements(graph),
            Self::Rotation(elements) | Self::General(elements) => elements,
        }
    }

    /// Whether this is a rotation whatever the values of all symbols are.
    pub(crate) const fn is_rotation(&self) -> bool {
        matches!(self, Self::Elementary(_) | Self::Rotation(_))
    }

    /// The factor times a vector.
    pub(crate) fn apply(self, graph: &mut Graph, vector: [Expression; 3]) -> [Expression; 3] {
        let elements = self.elements(graph);
        let row = |i: usize| [0, 1, 2].map(|j| (elements[3 * j + i], vector[j]));
        [0, 1, 2].map(|i| graph.sum_of_products(row(i)))
    }

    /// Whether this is the identity.
    pub(crate) fn is_identity(self, graph: &Graph) -> bool {
        match self {
            Self::Elementary(rotation) => graph.is_zero(rotation.angle),
            Self::Rotation(elements) | Self::General(elements) => elements == identity(graph),
        }
    }

    /// Whether this does not change.
    pub(crate) fn is_constant(self, graph: &Graph) -> bool {
        match self {
            Self::Elementary(rotation) => !graph.contents(rotation.angle).varies(),
            Self::Rotation(elements) | Self::General(elements) => {
                elements.iter().all(|x| !graph.contents(*x).varies())
            }
        }
    }

    /// The product with the next factor as one factor, if that is known without multiplication.
    pub(crate) fn then(self, next: Self, graph: &mut Graph) -> Option<Self> {
        match (self, next) {
            (Self::Elementary(rotation), Self::Elementary(next)) => {
                rotation.then(next, graph).map(Self::Elementary)
            }
            (Self::Rotation(_), Self::Rotation(_)) if next == self.transpose() => {
                Some(Self::Rotation(identity(graph)))
            }
            _ => None,
        }
    }
}

impl ElementaryRotation {
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

    /// The product with the next rotation as one, if both are about the same axis.
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

/// The elements of the transpose.
fn transposed(elements: &[Expression; 9]) -> [Expression; 9] {
    core::array::from_fn(|n| elements[n % 3 * 3 + n / 3])
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
