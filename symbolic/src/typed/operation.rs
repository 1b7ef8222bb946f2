//! Operations of scalars, vectors and matrices.

use crate::typed::array_function::ArrayFunction;
use crate::typed::components::Components;
use crate::{Axis, Binary, ExternalFunction, Rational, Symbol, Unary};

/// A value of a [typed graph](crate::TypedGraph), by its position.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Value(pub(crate) u32);

/// The operation by which a value is declared. What its arguments have to be is said where it is not obvious.
#[derive(Clone, Debug)]
pub enum TypedOperation {
    /// Symbols that were there before, such as a parameter that is a vector.
    Given(Components),
    /// A number.
    Constant(Rational),
    /// A symbol.
    Symbol(Symbol),
    /// Σ cᵢ xᵢ of values of one shape.
    Sum(Vec<(Value, Rational)>),
    /// Π xᵢ^cᵢ of scalars.
    Product(Vec<(Value, Rational)>),
    /// A vector or matrix times a scalar.
    Scaled(Value, Value),
    /// A B; a scalar where that has one element.
    MatrixProduct(Value, Value),
    /// A function of a scalar.
    Unary(Unary, Value),
    /// A function of two scalars.
    Binary(Binary, [Value; 2]),
    /// A constant power of a scalar.
    Power(Value, Rational),
    /// An external function of scalars.
    External(ExternalFunction, Vec<Value>),
    /// A function of vectors and matrices.
    OfArrays(&'static ArrayFunction, Vec<Value>),
    /// The array with these scalars, column by column.
    Array {
        /// The number of rows.
        rows: usize,
        /// The scalars.
        elements: Vec<Value>,
    },
    /// Scalars as a vector, or vectors as the rows of a matrix.
    Rows(Vec<Value>),
    /// An array of zeros.
    Zeros {
        /// The number of rows.
        rows: usize,
        /// The number of columns.
        columns: usize,
    },
    /// The identity matrix with so many rows.
    Identity(usize),
    /// An element of an array, counted column by column.
    Element(Value, usize),
    /// A block of a matrix.
    Block {
        /// The matrix.
        of: Value,
        /// The row and the column of the first element.
        first: (usize, usize),
        /// The numbers of rows and of columns.
        size: (usize, usize),
    },
    /// A vector with one more component, a scalar.
    Extended(Value, Value),
    /// [R p; 0 1] of a rotation and a place.
    Homogeneous(Value, Value),
    /// The product of elementary rotations about axes, by angles.
    Rotation(Vec<(Axis, Value)>),
    /// The angular velocity of a rotation.
    AngularVelocity {
        /// The rotation, from the axes of a body to inertial ones.
        rotation: Value,
        /// Whether its components are along inertial axes, and not along the axes of the body.
        is_inertial: bool,
    },
    /// The total time derivative.
    TimeDerivative(Value),
}

impl TypedOperation {
    /// The values of which it is one.
    pub(crate) fn arguments(&self) -> Vec<Value> {
        let firsts = |pairs: &[(Value, Rational)]| pairs.iter().map(|(x, _)| *x).collect();
        match self {
            Self::Given(_)
            | Self::Constant(_)
            | Self::Symbol(_)
            | Self::Zeros { .. }
            | Self::Identity(_) => Vec::new(),
            Self::Sum(pairs) | Self::Product(pairs) => firsts(pairs),
            Self::Scaled(x, y)
            | Self::MatrixProduct(x, y)
            | Self::Extended(x, y)
            | Self::Homogeneous(x, y)
            | Self::Binary(_, [x, y]) => vec![*x, *y],
            Self::Unary(_, x)
            | Self::Power(x, _)
            | Self::Element(x, _)
            | Self::Block { of: x, .. }
            | Self::AngularVelocity { rotation: x, .. }
            | Self::TimeDerivative(x) => vec![*x],
            Self::External(_, all)
            | Self::OfArrays(_, all)
            | Self::Rows(all)
            | Self::Array { elements: all, .. } => all.clone(),
            Self::Rotation(factors) => factors.iter().map(|(_, angle)| *angle).collect(),
        }
    }
}
