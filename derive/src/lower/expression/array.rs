//! Vectors and matrices: literals, and the functions of them.

use lagrangian_symbolic::{Expression, MAX_DETERMINANT, Matrix, Rational};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, ExprArray, ExprRepeat};

use super::repetition::stacked;
use super::{ExpressionContext, Lowerer};
use crate::limits::{MAX_ARRAY, MAX_DIAGONAL_ROWS};
use crate::lower::hints;
use crate::lower::value::Value;
use crate::syntax::shape::Shape;

impl Lowerer<'_> {
    /// `[x, y, z]`, or `[[a, b], [c, d]]` row by row.
    pub(super) fn array(&mut self, array: &ExprArray, context: ExpressionContext) -> Option<Value> {
        let values: Vec<_> = array
            .elems
            .iter()
            .map(|element| self.lower(element, context))
            .collect();
        let values: Vec<Value> = values.into_iter().collect::<Option<_>>()?;
        if values.is_empty() {
            return self.reject(array, "write the components: `[x, y, z]`");
        }
        let values = self.filled(values);
        match stacked(&values) {
            Ok(matrix) => {
                // It may be a rotation that is written out, or a homogeneous matrix.
                let varies = |x: &Expression| self.geometry.graph.contents(*x).varies();
                let is_large = matrix.rows() >= 3 && matrix.columns() >= 3;
                if is_large && matrix.elements().iter().any(varies) {
                    self.count_rotation(array)?;
                }
                Some(Value::Array(matrix))
            }
            Err(odd) => {
                let message = hints::incompatible_rows(values[0].shape(), values[odd].shape());
                self.reject(&array.elems[odd], message)
            }
        }
    }

    /// `[0.0; 3]`.
    pub(super) fn repeat(
        &mut self,
        repeat: &ExprRepeat,
        context: ExpressionContext,
    ) -> Option<Value> {
        let value = self.lower(&repeat.expr, context);
        let length = self.integer(&repeat.len);
        let (value, length) = (value?, length?);
        let value = match value {
            Value::EmptySum => Value::Scalar(self.geometry.graph.zero()),
            other => other,
        };
        let size = value.components().len().max(1);
        match usize::try_from(length) {
            Ok(length) if length > 0 && length <= MAX_ARRAY / size => {
                if let Ok(matrix) = stacked(&vec![value.clone(); length]) {
                    return Some(Value::Array(matrix));
                }
                let message = hints::incompatible_rows(value.shape(), value.shape());
                self.reject(&repeat.expr, message)
            }
            _ => {
                let message = format!("an array has from 1 to {MAX_ARRAY} components");
                self.reject(&repeat.len, message)
            }
        }
    }

    /// A function of vectors and matrices; `arguments` are the expressions, and `values` their values.
    pub(super) fn array_function(
        &mut self,
        name: &Ident,
        arguments: &[&Expr],
        values: &[Value],
        call: &dyn ToTokens,
    ) -> Option<Value> {
        let written = name.to_string();
        if written == "identity" {
            return self.identity(arguments[0]);
        }
        if values[0] == Value::EmptySum
            && ["norm", "norm_squared", "sum", "dot"].contains(&&*written)
        {
            return Some(Value::EmptySum);
        }
        let Value::Array(first) = &values[0] else {
            return self.reject(arguments[0], wants_array(&written, &values[0]));
        };
        match (written.as_str(), &values[1..]) {
            ("row" | "column", _) => self.row_or_column(&written, first, arguments[1]),
            (_, [Value::Array(second)]) => self.binary_array_function(name, first, second),
            (_, [other]) => {
                let message = wants_array(&written, other);
                self.reject(arguments[1], message)
            }
            _ => self.unary_array_function(&written, first, call),
        }
    }

    /// The identity matrix with so many rows.
    fn identity(&mut self, rows: &Expr) -> Option<Value> {
        let written = self.integer(rows)?;
        match usize::try_from(written) {
            Ok(n @ 1..=MAX_DIAGONAL_ROWS) => {
                Some(Value::Array(self.geometry.graph.identity_matrix(n)))
            }
            _ => self.reject(
                rows,
                "the identity has from 1 to 100 rows: write `identity(3)`",
            ),
        }
    }

    fn row_or_column(&mut self, name: &str, matrix: &Matrix, index: &Expr) -> Option<Value> {
        let line = if name == "row" {
            let i = self.index_below(index, matrix.rows(), "rows", matrix)?;
            matrix.row(i)
        } else {
            let i = self.index_below(index, matrix.columns(), "columns", matrix)?;
            matrix.column(i)
        };
        line.map(Value::Array)
    }

    fn binary_array_function(
        &mut self,
        name: &Ident,
        first: &Matrix,
        second: &Matrix,
    ) -> Option<Value> {
        let written = name.to_string();
        if written == "outer" && first.elements().len() > MAX_ARRAY / second.elements().len().max(1)
        {
            let message = format!("an array has at most {MAX_ARRAY} components");
            return self.reject(name, message);
        }
        let geometry = &mut self.geometry;
        let value = match written.as_str() {
            "dot" => geometry.dot_product(first, second).map(Value::Scalar),
            "cross" => {
                let product = geometry.cross_product(first, second);
                let product = match (product, &mut self.at_rest) {
                    (Some(product), Some(rest)) => {
                        Some(rest.cross_product(&mut geometry.graph, [first, second], &product))
                    }
                    (product, _) => product,
                };
                product.map(Value::Array)
            }
            "outer" => geometry
                .graph
                .outer_product(first, second)
                .map(Value::Array),
            _ => geometry
                .graph
                .component_product(first, second)
                .map(Value::Array),
        };
        if value.is_some() {
            return value;
        }
        let rule = match written.as_str() {
            "cross" => "is of two vectors of 3 components",
            "outer" => "is of two vectors",
            _ => "is of two arrays of the same shape",
        };
        let message = format!(
            "`{written}` {rule}, and here it is of {} and {}",
            Shape::of(first),
            Shape::of(second)
        );
        self.reject(name, message)
    }

    /// A function that every vector or matrix has.
    fn total_array_function(&mut self, name: &str, array: &Matrix) -> Option<Value> {
        let geometry = &mut self.geometry;
        let elements = array.elements().iter();
        let terms = elements.map(|element| (*element, Rational::ONE));
        Some(match name {
            "norm" => Value::Scalar(geometry.norm(array)),
            "norm_squared" => Value::Scalar(geometry.norm_squared(array)),
            "transpose" => Value::Array(array.transpose()),
            "sum" => Value::Scalar(geometry.graph.sum(terms)),
            "product" => Value::Scalar(geometry.graph.product(terms)),
            "len" => {
                let length = i64::try_from(array.elements().len()).unwrap_or(i64::MAX);
                Value::Scalar(geometry.graph.integer(length))
            }
            _ => return None,
        })
    }

    fn unary_array_function(
        &mut self,
        name: &str,
        array: &Matrix,
        call: &dyn ToTokens,
    ) -> Option<Value> {
        if let Some(value) = self.total_array_function(name, array) {
            return Some(value);
        }
        let geometry = &mut self.geometry;
        let square = array.rows() == array.columns();
        let few = array.rows() <= MAX_DETERMINANT;
        let is_vector = array.columns() == 1;
        let wanted = match name {
            "normalize" => {
                let norm = geometry.norm(array);
                if geometry.graph.is_zero(norm) {
                    "a vector other than zero"
                } else {
                    let factor = geometry.graph.power(norm, &Rational::MINUS_ONE);
                    return Some(Value::Array(geometry.matrix_scaled(array, factor)));
                }
            }
            "diagonal" if is_vector && array.rows() > MAX_DIAGONAL_ROWS => {
                "a vector of at most 100 components"
            }
            "diagonal" if is_vector => {
                return geometry.graph.diagonal_matrix(array).map(Value::Array);
            }
            "diagonal" if square => return array.diagonal().map(Value::Array),
            "diagonal" => "a square matrix, or a vector that becomes the diagonal of one",
            "trace" if square => return geometry.graph.trace(array).map(Value::Scalar),
            "trace" => "a square matrix",
            "determinant" if square && few => {
                return geometry.determinant(array).map(Value::Scalar);
            }
            "inverse" if square && few => {
                if let Ok(inverse) = geometry.inverse(array) {
                    return Some(Value::Array(inverse));
                }
                let message = "this matrix has no inverse: its determinant vanishes identically";
                return self.reject(call, message);
            }
            "determinant" | "inverse" => "a square matrix of at most 4 rows",
            "cross_matrix" => match geometry.graph.cross_matrix(array) {
                Some(matrix) => return Some(Value::Array(matrix)),
                None => "a vector of 3 components",
            },
            _ => "something else",
        };
        let message = format!(
            "`{name}` is of {wanted}, and this is of {}",
            Shape::of(array)
        );
        self.reject(call, message)
    }
}

fn wants_array(name: &str, value: &Value) -> String {
    format!(
        "`{name}` is of vectors and matrices, and this is {}",
        value.shape()
    )
}
