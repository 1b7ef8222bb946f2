//! A body among the parameters: its numbers as symbols.

use lagrangian_symbolic::{Components, Matrix, TypedGraph, TypedOperation, Value};

use crate::lower::quantities::Symbols;
use crate::syntax::body_quantity::BodyQuantity;
use crate::syntax::body_type::BodyType;
use crate::syntax::label::Index;

/// A body: its mass, its centre of gravity along its axes, and its inertia tensor about that.
#[derive(Clone)]
pub(crate) struct Body {
    pub(crate) mass: Value,
    pub(crate) center: Value,
    pub(crate) inertia: Value,
    /// Whether the centre of gravity is the origin of the axes of the body.
    pub(crate) is_centered: bool,
}

impl Body {
    /// A body whose numbers are the next symbols.
    pub(crate) fn of_symbols(
        ty: BodyType,
        symbols: &mut Symbols,
        typed: &mut TypedGraph,
    ) -> Option<Self> {
        let zero = typed.geometry.graph.zero();
        let (mut mass, mut center, mut inertia) = (zero, [zero; 3], [[zero; 3]; 3]);
        for number in ty.numbers() {
            let symbol = symbols.take(typed);
            match number.index {
                None => mass = symbol,
                Some(Index::Pair { row, column }) => {
                    inertia[row][column] = symbol;
                    inertia[column][row] = symbol;
                }
                Some(Index::Axis(i) | Index::One(i)) => center[i] = symbol,
                Some(Index::Quantity(_)) => {}
            }
        }
        if ty == BodyType::Symmetric {
            inertia[1][1] = inertia[0][0];
        }
        let is_centered = center == [zero; 3];
        let center = Matrix::vector(center.to_vec());
        let inertia = Matrix::new(3, 3, inertia.concat())?;
        let mut given = |components| typed.add(TypedOperation::Given(components)).ok();
        Some(Self {
            mass: given(Components::Scalar(mass))?,
            center: given(Components::Array(center))?,
            inertia: given(Components::Array(inertia))?,
            is_centered,
        })
    }

    /// A quantity of the body.
    pub(crate) const fn quantity(&self, quantity: BodyQuantity) -> Value {
        match quantity {
            BodyQuantity::Mass => self.mass,
            BodyQuantity::Center => self.center,
            BodyQuantity::Inertia => self.inertia,
        }
    }
}
