//! A body among the parameters: its numbers as symbols.

use lagrangian_symbolic::{Expression, Graph, Matrix};

use crate::lower::quantities::Symbols;
use crate::lower::value::Value;
use crate::syntax::body_quantity::BodyQuantity;
use crate::syntax::body_type::BodyType;
use crate::syntax::label::Index;

/// A body: its mass, its centre of gravity along its axes, and its inertia tensor about that.
#[derive(Clone)]
pub(crate) struct Body {
    pub(crate) mass: Expression,
    center: [Expression; 3],
    inertia: [[Expression; 3]; 3],
}

impl Body {
    /// A body whose numbers are the next symbols.
    pub(crate) fn of_symbols(ty: BodyType, symbols: &mut Symbols, graph: &mut Graph) -> Self {
        let zero = graph.zero();
        let mut body = Self {
            mass: zero,
            center: [zero; 3],
            inertia: [[zero; 3]; 3],
        };
        for number in ty.numbers() {
            let symbol = symbols.take(graph);
            match number.index {
                None => body.mass = symbol,
                Some(Index::Pair { row, column }) => {
                    body.inertia[row][column] = symbol;
                    body.inertia[column][row] = symbol;
                }
                Some(Index::Axis(i) | Index::One(i)) => body.center[i] = symbol,
                Some(Index::Quantity(_)) => {}
            }
        }
        if ty == BodyType::Symmetric {
            body.inertia[1][1] = body.inertia[0][0];
        }
        body
    }

    /// Whether the centre of gravity is the origin of the axes of the body.
    pub(crate) fn is_centered(&self, graph: &Graph) -> bool {
        self.center
            .iter()
            .all(|component| graph.is_zero(*component))
    }

    pub(crate) fn center(&self) -> Option<Matrix> {
        Matrix::new(3, 1, self.center.to_vec())
    }

    pub(crate) fn inertia(&self) -> Option<Matrix> {
        Matrix::new(3, 3, self.inertia.concat())
    }

    /// A quantity of the body as a value.
    pub(crate) fn quantity(&self, quantity: BodyQuantity) -> Option<Value> {
        match quantity {
            BodyQuantity::Mass => Some(Value::Scalar(self.mass)),
            BodyQuantity::Center => self.center().map(Value::Array),
            BodyQuantity::Inertia => self.inertia().map(Value::Array),
        }
    }
}
