//! Values of a declaration: their shapes, and sums and products that grow operand by operand.

use lagrangian_symbolic::{
    Components, Expression, Matrix, Rational, TypedGraph, TypedOperation, Value,
};

use crate::syntax::label::Index;
use crate::syntax::shape::Shape;

impl Shape {
    pub(crate) fn of(matrix: &Matrix) -> Self {
        Self::Array {
            rows: matrix.rows(),
            columns: matrix.columns(),
        }
    }

    /// The shape of a value.
    pub(crate) fn of_value(typed: &TypedGraph, value: Value) -> Self {
        typed
            .components(value)
            .array()
            .map_or(Self::Scalar, Self::of)
    }

    /// The value of this shape with all components zero.
    pub(crate) fn zeros(self, typed: &mut TypedGraph) -> Option<Value> {
        let zeros = match self {
            Self::Scalar => TypedOperation::Constant(Rational::ZERO),
            Self::Array { rows, columns } => TypedOperation::Zeros { rows, columns },
        };
        typed.add(zeros).ok()
    }
}

/// The components of a value with their indices, in their order.
pub(crate) fn labelled(typed: &TypedGraph, value: Value) -> Vec<(Vec<Index>, Expression)> {
    let shape = Shape::of_value(typed, value);
    let components = typed.components(value).elements().iter().enumerate();
    components
        .map(|(i, component)| (shape.index(i).into_iter().collect(), *component))
        .collect()
}

/// A sum that grows term by term, all of one shape.
#[derive(Clone, Default)]
pub(crate) struct Sum {
    terms: Vec<(Value, Rational)>,
    shape: Option<Shape>,
}

impl Sum {
    /// The sum of one term.
    pub(crate) fn of(typed: &TypedGraph, term: Value) -> Self {
        let mut sum = Self::default();
        if *typed.components(term) != Components::EmptySum {
            sum.terms.push((term, Rational::ONE));
            sum.shape = Some(Shape::of_value(typed, term));
        }
        sum
    }

    /// Adds `sign` times a value; the shape of the terms before it, if it has another.
    pub(crate) fn add(
        &mut self,
        typed: &TypedGraph,
        value: Value,
        sign: Rational,
    ) -> Result<(), Shape> {
        if *typed.components(value) == Components::EmptySum {
            return Ok(());
        }
        let shape = Shape::of_value(typed, value);
        match self.shape {
            Some(before) if before != shape => return Err(before),
            _ => self.shape = Some(shape),
        }
        self.terms.push((value, sign));
        Ok(())
    }

    pub(crate) fn value(self, typed: &mut TypedGraph) -> Option<Value> {
        match self.terms.as_slice() {
            [(only, sign)] if sign.is_one() => Some(*only),
            _ => typed.add(TypedOperation::Sum(self.terms)).ok(),
        }
    }
}

/// A product that grows factor by factor: scalars, and at most one array, since arrays do not commute.
#[derive(Clone, Default)]
pub(crate) struct Product {
    scalars: Vec<(Value, Rational)>,
    array: Option<Value>,
    vanishes: bool,
}

impl Product {
    /// Multiplies by a value, or divides by it where `exponent` is −1; the shape of what stands before
    /// it, if that does not fit.
    pub(crate) fn multiply(
        &mut self,
        typed: &mut TypedGraph,
        value: Value,
        exponent: Rational,
    ) -> Result<(), Shape> {
        match (typed.components(value), self.array) {
            (Components::EmptySum, _) => self.vanishes = true,
            (Components::Scalar(_), _) => self.scalars.push((value, exponent)),
            (Components::Array(_), left) if exponent.is_negative() => {
                return Err(left.map_or(Shape::Scalar, |left| Shape::of_value(typed, left)));
            }
            (Components::Array(_), None) => self.array = Some(value),
            (Components::Array(_), Some(left)) => {
                let product = typed.add(TypedOperation::MatrixProduct(left, value));
                let product = product.map_err(|_| Shape::of_value(typed, left))?;
                let is_array = typed.components(product).array().is_some();
                self.array = is_array.then_some(product);
                if !is_array {
                    self.scalars.push((product, Rational::ONE));
                }
            }
        }
        Ok(())
    }

    pub(crate) fn value(self, typed: &mut TypedGraph) -> Option<Value> {
        let operation = match (self.vanishes, self.array, self.scalars.as_slice()) {
            (true, ..) => TypedOperation::Sum(Vec::new()),
            (_, None, [(only, exponent)]) if exponent.is_one() => return Some(*only),
            (_, None, _) => TypedOperation::Product(self.scalars),
            (_, Some(array), []) => return Some(array),
            (_, Some(array), _) => {
                let factor = typed.add(TypedOperation::Product(self.scalars)).ok()?;
                TypedOperation::Scaled(array, factor)
            }
        };
        typed.add(operation).ok()
    }
}
