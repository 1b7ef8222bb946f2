//! The components of a value, from the components of the values of which it is an operation.

use crate::frames::homogeneous::extended;
use crate::typed::components::{Components, NoValue};
use crate::typed::operation::{TypedOperation, Value};
use crate::{Expression, Geometry, Matrix, Rational};

impl TypedOperation {
    /// The components of its value, where these are known of the first values.
    pub(crate) fn evaluate(
        &self,
        geometry: &mut Geometry,
        coordinates: u32,
        known: &[Option<Components>],
    ) -> Result<Components, NoValue> {
        let mut evaluation = Evaluation {
            geometry,
            coordinates,
            known,
        };
        evaluation.evaluate(self)
    }
}

/// An evaluation of a typed graph: the arena of the components, and the components that are known.
struct Evaluation<'a> {
    geometry: &'a mut Geometry,
    coordinates: u32,
    known: &'a [Option<Components>],
}

impl Evaluation<'_> {
    /// The components of the value of an operation.
    fn evaluate(&mut self, operation: &TypedOperation) -> Result<Components, NoValue> {
        use TypedOperation as Op;
        match operation {
            Op::Given(components) => Ok(components.clone()),
            Op::Constant(number) => Ok(Components::Scalar(self.geometry.graph.constant(number))),
            Op::Symbol(symbol) => Ok(Components::Scalar(self.geometry.graph.symbol(*symbol))),
            Op::Sum(terms) => self.sum(terms),
            Op::Product(factors) => self.product(factors),
            Op::Scaled(x, factor) => {
                let (x, factor) = (self.array(*x)?.clone(), self.scalar(*factor)?);
                Ok(Components::Array(self.geometry.matrix_scaled(&x, factor)))
            }
            Op::MatrixProduct(x, y) => self.matrix_product(*x, *y),
            Op::Unary(function, x) => {
                let x = self.scalar(*x)?;
                Ok(Components::Scalar(self.geometry.graph.unary(*function, x)))
            }
            Op::Binary(function, [x, y]) => {
                let (x, y) = (self.scalar(*x)?, self.scalar(*y)?);
                let value = self.geometry.graph.binary(*function, x, y);
                Ok(Components::Scalar(value))
            }
            Op::Power(x, exponent) => {
                let x = self.scalar(*x)?;
                Ok(Components::Scalar(self.geometry.graph.power(x, exponent)))
            }
            Op::External(function, arguments) => {
                let arguments = self.scalars(arguments)?;
                let value = self.geometry.graph.apply(*function, &arguments);
                Ok(Components::Scalar(value))
            }
            Op::OfArrays(function, arguments) => {
                let known = self.known;
                let arguments = arguments.iter().map(|x| array(known, *x));
                let arguments: Vec<_> = arguments.collect::<Result<_, _>>()?;
                function.evaluate(self.geometry, &arguments)
            }
            Op::AngularVelocity {
                rotation,
                is_inertial,
            } => self.angular_velocity(*rotation, *is_inertial),
            Op::TimeDerivative(x) => self.time_derivative(*x),
            arrangement => self.arranged(arrangement),
        }
    }

    /// Arrays that are put together of others, and parts of them.
    fn arranged(&mut self, operation: &TypedOperation) -> Result<Components, NoValue> {
        use TypedOperation as Op;
        let array = match operation {
            Op::Array { rows, elements } => {
                let scalars = self.scalars(elements)?;
                Matrix::new(*rows, scalars.len() / (*rows).max(1), scalars)
            }
            Op::Rows(rows) => Some(self.stacked(rows)?),
            Op::Zeros { rows, columns } => {
                let zero = self.geometry.graph.zero();
                Matrix::new(*rows, *columns, vec![zero; rows * columns])
            }
            Op::Identity(rows) => Some(self.geometry.graph.identity_matrix(*rows)),
            Op::Element(x, i) => {
                let element = self.array(*x)?.elements().get(*i).copied();
                return element.map(Components::Scalar).ok_or(NoValue::Shapes);
            }
            Op::Block { of, first, size } => {
                let matrix = self.array(*of)?;
                matrix.block(*first, *size)
            }
            Op::Extended(vector, last) => Some(extended(self.array(*vector)?, self.scalar(*last)?)),
            Op::Homogeneous(rotation, place) => {
                let (rotation, place) = (self.array(*rotation)?, self.array(*place)?);
                self.geometry.graph.homogeneous(rotation, place)
            }
            Op::Rotation(factors) => {
                let mut known = Vec::with_capacity(factors.len());
                for (axis, angle) in factors {
                    known.push((*axis, self.scalar(*angle)?));
                }
                Some(self.geometry.rotation(&known))
            }
            _ => None,
        };
        array.map(Components::Array).ok_or(NoValue::Shapes)
    }

    /// Scalars as a vector, or vectors as the rows of a matrix.
    fn stacked(&self, rows: &[Value]) -> Result<Matrix, NoValue> {
        let mut values = Vec::with_capacity(rows.len());
        for row in rows {
            values.push(components(self.known, *row)?.elements());
        }
        let columns = values.first().map_or(0, |first| first.len());
        if values.iter().any(|row| row.len() != columns) {
            return Err(NoValue::Shapes);
        }
        let elements = (0..columns).flat_map(|column| values.iter().map(move |row| row[column]));
        Matrix::new(rows.len(), columns, elements.collect()).ok_or(NoValue::Shapes)
    }

    fn sum(&mut self, terms: &[(Value, Rational)]) -> Result<Components, NoValue> {
        let mut scalars = Vec::new();
        let mut arrays = Vec::new();
        for (term, coefficient) in terms {
            match components(self.known, *term)? {
                Components::EmptySum => {}
                Components::Scalar(x) => scalars.push((*x, coefficient.clone())),
                Components::Array(x) => arrays.push((x, coefficient.clone())),
            }
        }
        match (scalars.is_empty(), arrays.is_empty()) {
            (true, true) => Ok(Components::EmptySum),
            (false, true) => Ok(Components::Scalar(self.geometry.graph.sum(scalars))),
            (true, false) => {
                let sum = self.geometry.matrix_sum(&arrays);
                sum.map(Components::Array).ok_or(NoValue::Shapes)
            }
            (false, false) => Err(NoValue::Shapes),
        }
    }

    fn product(&mut self, factors: &[(Value, Rational)]) -> Result<Components, NoValue> {
        let mut scalars = Vec::with_capacity(factors.len());
        for (factor, exponent) in factors {
            match components(self.known, *factor)? {
                Components::EmptySum => return Ok(Components::EmptySum),
                Components::Scalar(x) => scalars.push((*x, exponent.clone())),
                Components::Array(_) => return Err(NoValue::Shapes),
            }
        }
        Ok(Components::Scalar(self.geometry.graph.product(scalars)))
    }

    fn matrix_product(&mut self, x: Value, y: Value) -> Result<Components, NoValue> {
        let (x, y) = (self.array(x)?, self.array(y)?);
        let product = self.geometry.matrix_product(x, y);
        let product = product.ok_or(NoValue::Shapes)?;
        Ok(match product.elements() {
            [only] => Components::Scalar(*only),
            _ => Components::Array(product),
        })
    }

    fn angular_velocity(
        &mut self,
        rotation: Value,
        is_inertial: bool,
    ) -> Result<Components, NoValue> {
        let rotation = self.array(rotation)?;
        let velocity = if is_inertial {
            self.geometry
                .angular_velocity_inertial(rotation, self.coordinates)
        } else {
            self.geometry.angular_velocity(rotation, self.coordinates)
        };
        velocity.map(Components::Array).map_err(NoValue::NoRotation)
    }

    fn time_derivative(&mut self, x: Value) -> Result<Components, NoValue> {
        Ok(match components(self.known, x)? {
            Components::Scalar(x) => {
                let rates = self.geometry.time_derivatives(&[*x], self.coordinates);
                Components::Scalar(rates[0])
            }
            Components::Array(x) => {
                let rate = self.geometry.matrix_time_derivative(x, self.coordinates);
                Components::Array(rate)
            }
            Components::EmptySum => Components::EmptySum,
        })
    }

    fn scalar(&self, x: Value) -> Result<Expression, NoValue> {
        match components(self.known, x)? {
            Components::Scalar(x) => Ok(*x),
            Components::EmptySum => Ok(self.geometry.graph.zero()),
            Components::Array(_) => Err(NoValue::Shapes),
        }
    }

    fn scalars(&self, values: &[Value]) -> Result<Vec<Expression>, NoValue> {
        values.iter().map(|x| self.scalar(*x)).collect()
    }
}

impl<'a> Evaluation<'a> {
    fn array(&self, x: Value) -> Result<&'a Matrix, NoValue> {
        array(self.known, x)
    }
}

fn components(known: &[Option<Components>], x: Value) -> Result<&Components, NoValue> {
    let found = known.get(x.0 as usize).and_then(Option::as_ref);
    found.ok_or(NoValue::Shapes)
}

fn array(known: &[Option<Components>], x: Value) -> Result<&Matrix, NoValue> {
    components(known, x)?.array().ok_or(NoValue::Shapes)
}
