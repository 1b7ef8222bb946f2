//! The value of an expression of the declaration: a scalar, a vector or a matrix.

use lagrangian_symbolic::{Expression, Geometry, Matrix, Rational};

use crate::syntax::label::Index;
use crate::syntax::shape::Shape;

/// The value of an expression.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Value {
    /// A number.
    Scalar(Expression),
    /// A vector, which is a matrix of one column, or a matrix.
    Array(Matrix),
    /// A sum without terms: the zero of whatever it is added to.
    EmptySum,
}

impl Value {
    pub(crate) fn shape(&self) -> Shape {
        match self {
            Self::Array(matrix) => Shape::of(matrix),
            Self::Scalar(_) | Self::EmptySum => Shape::Scalar,
        }
    }

    /// The components, column by column.
    pub(crate) fn components(&self) -> &[Expression] {
        match self {
            Self::Scalar(expression) => core::slice::from_ref(expression),
            Self::Array(matrix) => matrix.elements(),
            Self::EmptySum => &[],
        }
    }

    /// The value with `indices` of its components, in their order.
    pub(crate) fn labelled(&self) -> Vec<(Vec<Index>, Expression)> {
        let shape = self.shape();
        let components = self.components().iter().enumerate();
        components
            .map(|(i, component)| (shape.index(i).into_iter().collect(), *component))
            .collect()
    }
}

impl Shape {
    pub(crate) fn of(matrix: &Matrix) -> Self {
        Self::Array {
            rows: matrix.rows(),
            columns: matrix.columns(),
        }
    }

    /// The value of this shape with all components alike.
    pub(crate) fn filled(self, component: Expression) -> Value {
        match self {
            Self::Scalar => Value::Scalar(component),
            Self::Array { rows, columns } => {
                let components = vec![component; rows * columns];
                Matrix::new(rows, columns, components).map_or(Value::EmptySum, Value::Array)
            }
        }
    }
}

/// A sum that grows term by term, all of one shape.
#[derive(Clone, Default)]
pub(crate) struct Sum {
    scalars: Vec<(Expression, Rational)>,
    arrays: Vec<(Matrix, Rational)>,
}

impl Sum {
    /// Adds `sign` times a value; the shape of the terms before it, if it has another.
    pub(crate) fn add(&mut self, value: Value, sign: Rational) -> Result<(), Shape> {
        match value {
            Value::EmptySum => {}
            Value::Scalar(term) => match self.arrays.first() {
                Some((first, _)) => return Err(Shape::of(first)),
                None => self.scalars.push((term, sign)),
            },
            Value::Array(term) => {
                if !self.scalars.is_empty() {
                    return Err(Shape::Scalar);
                }
                match self.arrays.first() {
                    Some((first, _)) if Shape::of(first) != Shape::of(&term) => {
                        return Err(Shape::of(first));
                    }
                    _ => self.arrays.push((term, sign)),
                }
            }
        }
        Ok(())
    }

    pub(crate) fn value(self, geometry: &mut Geometry) -> Value {
        if !self.scalars.is_empty() {
            return Value::Scalar(geometry.graph.sum(self.scalars));
        }
        let terms = self.arrays.iter();
        let terms: Vec<_> = terms.map(|(term, sign)| (term, sign.clone())).collect();
        match geometry.matrix_sum(&terms) {
            Some(sum) if !terms.is_empty() => Value::Array(sum),
            _ => Value::EmptySum,
        }
    }
}

/// A product that grows factor by factor: scalars, and at most one array, since arrays do not commute.
#[derive(Clone, Default)]
pub(crate) struct Product {
    scalars: Vec<(Expression, Rational)>,
    array: Option<Matrix>,
    vanishes: bool,
}

impl Product {
    /// Multiplies by a value, or divides by it where `exponent` is −1; the shape of what stands before
    /// it, if that does not fit.
    pub(crate) fn multiply(
        &mut self,
        geometry: &mut Geometry,
        value: Value,
        exponent: Rational,
    ) -> Result<(), Shape> {
        match value {
            Value::EmptySum => self.vanishes = true,
            Value::Scalar(factor) => self.scalars.push((factor, exponent)),
            Value::Array(_) if exponent.is_negative() => {
                return Err(self.array.as_ref().map_or(Shape::Scalar, Shape::of));
            }
            Value::Array(right) => match self.array.take() {
                None => self.array = Some(right),
                Some(left) => match geometry.matrix_product(&left, &right) {
                    Some(product) if product.elements().len() == 1 => {
                        self.scalars.push((product.elements()[0], Rational::ONE));
                    }
                    Some(product) => self.array = Some(product),
                    None => return Err(Shape::of(&left)),
                },
            },
        }
        Ok(())
    }

    pub(crate) fn value(self, geometry: &mut Geometry) -> Value {
        if self.vanishes {
            return Value::EmptySum;
        }
        match (self.array, self.scalars) {
            (None, scalars) => Value::Scalar(geometry.graph.product(scalars)),
            (Some(array), scalars) if scalars.is_empty() => Value::Array(array),
            (Some(array), scalars) => {
                let factor = geometry.graph.product(scalars);
                Value::Array(geometry.matrix_scaled(&array, factor))
            }
        }
    }
}
