//! How the axes of a link are turned against those of the link before.

use crate::frames::factor::{ElementaryRotation, MatrixFactor};
use crate::mechanics::mechanism::Vector;
use crate::{Expression, Graph, Node, Rational, Symbol, Unary};

/// A rotation that takes components along the axes of a link to those along the axes of the link before.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Turn {
    /// None.
    Identity,
    /// About a coordinate axis.
    Elementary(ElementaryRotation),
    /// About an axis of symmetry of all that turns: the axes stay with the link before, along which the link has the same
    /// moments whatever the angle.
    Spin(ElementaryRotation),
    /// Any other, by its elements, column by column.
    General([Expression; 9]),
}

impl Turn {
    /// The turn of a factor that is a rotation.
    pub(crate) fn of(factor: MatrixFactor) -> Option<Self> {
        match factor {
            MatrixFactor::Elementary(rotation) => Some(Self::Elementary(rotation)),
            MatrixFactor::Rotation(elements) => Some(Self::General(elements)),
            MatrixFactor::General(_) => None,
        }
    }

    /// From the axes of the link before to those of the link.
    pub(crate) fn inverse(&self) -> Self {
        let factor = match *self {
            Self::Identity | Self::Spin(_) => return Self::Identity,
            Self::Elementary(rotation) => MatrixFactor::Elementary(rotation),
            Self::General(elements) => MatrixFactor::Rotation(elements),
        };
        Self::of(factor.transpose()).unwrap_or(*self)
    }

    /// Whether it does not change.
    pub(crate) fn is_constant(&self, graph: &Graph) -> bool {
        match self {
            Self::Identity => true,
            Self::Elementary(rotation) | Self::Spin(rotation) => {
                !graph.contents(rotation.angle).varies()
            }
            Self::General(elements) => elements.iter().all(|x| !graph.contents(*x).varies()),
        }
    }

    /// The coordinate axis about which it turns.
    pub(crate) const fn axis(&self) -> Option<usize> {
        match self {
            Self::Elementary(rotation) | Self::Spin(rotation) => Some(rotation.axis.cycle()[0]),
            _ => None,
        }
    }

    /// Cosine and sine of the angle about a coordinate axis.
    pub(crate) fn cosine_and_sine(
        graph: &mut Graph,
        rotation: ElementaryRotation,
    ) -> [Expression; 2] {
        let cosine = graph.unary(Unary::Cos, rotation.angle);
        let sine = graph.unary(Unary::Sin, rotation.angle);
        [cosine, graph.scale(sine, &rotation.sign())]
    }

    /// Components along the axes of the link before.
    pub(crate) fn outward(&self, graph: &mut Graph, vector: Vector) -> Vector {
        self.apply(graph, vector, false)
    }

    /// Components along the axes of the link, of a vector along those of the link before.
    pub(crate) fn inward(&self, graph: &mut Graph, vector: Vector) -> Vector {
        self.apply(graph, vector, true)
    }

    fn apply(&self, graph: &mut Graph, vector: Vector, is_inward: bool) -> Vector {
        let turned = match *self {
            Self::Identity | Self::Spin(_) => return vector,
            Self::Elementary(rotation) => {
                let [cosine, mut sine] = Self::cosine_and_sine(graph, rotation);
                if is_inward {
                    sine = graph.negate(sine);
                }
                let [k, a, b] = rotation.axis.cycle();
                let minus = graph.negate(sine);
                let mut turned = vector;
                turned[a] = graph.sum_of_products([(cosine, vector[a]), (minus, vector[b])]);
                turned[b] = graph.sum_of_products([(sine, vector[a]), (cosine, vector[b])]);
                turned[k] = vector[k];
                turned
            }
            Self::General(elements) => {
                let factor = MatrixFactor::Rotation(elements);
                let factor = if is_inward {
                    factor.transpose()
                } else {
                    factor
                };
                factor.apply(graph, vector)
            }
        };
        turned.map(|x| kept(graph, x))
    }

    /// The angular velocity of the link relative to the link before, along the axes of the link.
    pub(crate) fn rate(&self, graph: &mut Graph, coordinates: u32) -> Vector {
        let factor = match *self {
            Self::Identity => return [graph.zero(); 3],
            Self::Elementary(rotation) | Self::Spin(rotation) => MatrixFactor::Elementary(rotation),
            Self::General(elements) => MatrixFactor::Rotation(elements),
        };
        let velocity = graph.angular_velocity_of_product(&[factor], coordinates);
        velocity.unwrap_or([graph.zero(); 3])
    }
}

/// The coefficients of the velocities in a vector that is linear in them, by coordinate.
pub(crate) fn slopes(graph: &mut Graph, vector: Vector, coordinates: u32) -> Vec<(usize, Vector)> {
    let mut slopes = Vec::new();
    for symbol in graph.symbols(&vector) {
        if let Symbol::Velocity(i) = symbol
            && i < coordinates
        {
            let derivatives = graph.derivatives(&vector, symbol);
            if let Ok(slope) = derivatives.try_into() {
                slopes.push((i as usize, slope));
            }
        }
    }
    slopes
}

/// An expression as an intermediate result, with which sums and products do not merge. A minus sign stays outside,
/// where it is part of the sums that follow.
pub(crate) fn kept(graph: &mut Graph, expression: Expression) -> Expression {
    let is_negative = match graph.node(expression) {
        Node::Sum(terms) => terms.iter().all(|(_, c)| c.is_negative()),
        _ => false,
    };
    if is_negative {
        let opposite = graph.negate(expression);
        let opposite = graph.opaque(opposite);
        return graph.negate(opposite);
    }
    graph.opaque(expression)
}

/// x × y, with kept components.
pub(crate) fn cross(graph: &mut Graph, x: Vector, y: Vector) -> Vector {
    let product = graph.cross(x, y);
    product.map(|x| kept(graph, x))
}

/// Σ xᵢ, term by term.
pub(crate) fn total(graph: &mut Graph, terms: &[Expression]) -> Expression {
    let sum = graph.sum(terms.iter().map(|x| (*x, Rational::ONE)));
    kept(graph, sum)
}

/// x − y, kept.
pub(crate) fn difference(graph: &mut Graph, x: Expression, y: Expression) -> Expression {
    let difference = graph.subtract(x, y);
    kept(graph, difference)
}

/// Σ xᵢ·yᵢ, kept.
pub(crate) fn inner(
    graph: &mut Graph,
    pairs: impl IntoIterator<Item = (Expression, Expression)>,
) -> Expression {
    let sum = graph.sum_of_products(pairs);
    kept(graph, sum)
}
