//! Polynomial degrees in the velocities.

use crate::{Expression, Graph, Node, Symbol};

impl Graph {
    /// The degree of an expression as a polynomial in the velocities; none for what is not a polynomial as it
    /// stands, such as |ẋ|, whose second derivative would not show it.
    #[must_use]
    pub fn velocity_degree(&self, expression: Expression) -> Option<u8> {
        Degrees::of(self, expression).of_expression(expression)
    }
}

/// The degrees of expressions as polynomials in the velocities; none for what is not a polynomial.
pub(crate) struct Degrees(Vec<Option<u8>>);

impl Degrees {
    pub(crate) fn of(graph: &Graph, root: Expression) -> Self {
        let mut degrees = Self(vec![Some(0); root.index() + 1]);
        for expression in graph.descendants(&[root]) {
            degrees.0[expression.index()] = degrees.degree(graph.node(expression));
        }
        degrees
    }

    pub(crate) fn of_expression(&self, expression: Expression) -> Option<u8> {
        self.0[expression.index()]
    }

    fn degree(&self, node: &Node) -> Option<u8> {
        match node {
            Node::Symbol(Symbol::Velocity(_) | Symbol::VelocityComponent(_)) => Some(1),
            Node::Constant(_) | Node::Pi | Node::Symbol(_) => Some(0),
            Node::Sum(terms) => terms
                .iter()
                .try_fold(0, |most, (x, _)| Some(self.of_expression(*x)?.max(most))),
            Node::Product(factors) => factors.iter().try_fold(0, |total: u8, (x, k)| {
                match (self.of_expression(*x)?, k.to_integer()) {
                    (0, _) => Some(total),
                    (degree, Some(k)) => {
                        total.checked_add(degree.checked_mul(u8::try_from(k).ok()?)?)
                    }
                    (_, None) => None,
                }
            }),
            Node::Opaque(x) => self.of_expression(*x),
            // Of what does not vary with velocities.
            Node::Unary(..) | Node::Binary(..) | Node::Application(..) => {
                let mut is_still = true;
                node.for_each_operand(|x| is_still &= self.of_expression(x) == Some(0));
                is_still.then_some(0)
            }
        }
    }
}
