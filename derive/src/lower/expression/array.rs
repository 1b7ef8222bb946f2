//! Vectors and matrices: literals, and the functions of them.

use lagrangian_symbolic::{
    ArrayFunction, Contents, MAX_ARRAY, MAX_DIAGONAL_ROWS, NoValue, TypedOperation, Value,
};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, ExprArray, ExprRepeat};

use super::Lowerer;
use crate::syntax::shape::Shape;

impl Lowerer<'_> {
    /// `[x, y, z]`, or `[[a, b], [c, d]]` row by row.
    pub(super) fn array(&mut self, array: &ExprArray) -> Option<Value> {
        let values = self.each(&array.elems, Self::lower)?;
        if values.is_empty() {
            return self.reject(array, "write the components: `[x, y, z]`");
        }
        let values = self.filled(values)?;
        let rows = self.rows(values, |odd| &array.elems[odd])?;
        // It may be a rotation that is written out, or a homogeneous matrix.
        if let Shape::Array {
            rows: 3..,
            columns: 3..,
        } = self.shape(rows)
            && self.contains(rows, Contents::varies)
        {
            self.count_rotation(array)?;
        }
        Some(rows)
    }

    /// `[0.0; 3]`.
    pub(super) fn repeat(&mut self, repeat: &ExprRepeat) -> Option<Value> {
        let value = self.lower(&repeat.expr);
        let length = self.integer(&repeat.len);
        let (value, length) = (value?, length?);
        let value = if self.is_empty_sum(value) {
            self.constant(0)?
        } else {
            value
        };
        let shape = self.shape(value);
        match usize::try_from(length) {
            Ok(length) if length > 0 && length <= MAX_ARRAY / shape.count() => {
                self.rows(vec![value; length], |_| &repeat.expr)
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
        function: &'static ArrayFunction,
        name: &Ident,
        (arguments, values): (&[&Expr], &[Value]),
        call: &dyn ToTokens,
    ) -> Option<Value> {
        if function.keeps_empty_sum && self.is_empty_sum(values[0]) {
            return Some(values[0]);
        }
        for (argument, value) in arguments.iter().zip(values) {
            self.check_array(function.name, argument, *value)?;
        }
        let reason = match self
            .typed
            .add(TypedOperation::OfArrays(function, values.to_vec()))
        {
            Ok(value) => return Some(value),
            Err(reason) => reason,
        };
        let shapes: Vec<String> = values
            .iter()
            .map(|value| self.shape(*value).to_string())
            .collect();
        let message = match reason {
            NoValue::Arguments(wanted) => {
                let here = if shapes.len() > 1 { "here it" } else { "this" };
                let shapes = shapes.join(" and ");
                format!("`{name}` is of {wanted}, and {here} is of {shapes}")
            }
            NoValue::Size => format!("an array has at most {MAX_ARRAY} components"),
            NoValue::Singular => {
                "this matrix has no inverse: its determinant vanishes identically".to_owned()
            }
            NoValue::NoRotation(_) | NoValue::Shapes => return None,
        };
        match shapes.len() {
            1 => self.reject(call, message),
            _ => self.reject(name, message),
        }
    }

    fn check_array(&mut self, name: &str, argument: &Expr, value: Value) -> Option<()> {
        if self.typed.components(value).array().is_some() {
            return Some(());
        }
        let message = format!(
            "`{name}` is of vectors and matrices, and this is {}",
            self.shape(value)
        );
        self.reject(argument, message)
    }

    /// The identity matrix with so many rows.
    pub(super) fn identity(&mut self, rows: &Expr) -> Option<Value> {
        let written = self.integer(rows)?;
        match usize::try_from(written) {
            Ok(n @ 1..=MAX_DIAGONAL_ROWS) => self.add(TypedOperation::Identity(n)),
            _ => self.reject(
                rows,
                "the identity has from 1 to 100 rows: write `identity(3)`",
            ),
        }
    }

    /// A row or a column of a matrix.
    pub(super) fn row_or_column(
        &mut self,
        name: &str,
        (matrix, argument): (Value, &Expr),
        index: &Expr,
    ) -> Option<Value> {
        self.check_array(name, argument, matrix)?;
        let shape = self.shape(matrix);
        let Shape::Array { rows, columns } = shape else {
            return None;
        };
        let (first, size) = if name == "row" {
            let row = self.index_below(index, rows, "rows", shape)?;
            ((row, 0), (1, columns))
        } else {
            let column = self.index_below(index, columns, "columns", shape)?;
            ((0, column), (rows, 1))
        };
        self.add(TypedOperation::Block {
            of: matrix,
            first,
            size,
        })
    }
}
