//! Blocks of matrices, and what is put together of them: homogeneous matrices and coordinates.

use lagrangian_symbolic::{TypedOperation, Value};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::Expr;

use super::Lowerer;
use super::repetition::without_parentheses;
use crate::lower::builtins;
use crate::syntax::shape::Shape;

/// A pair of integers: a row and a column, or numbers of them.
type Pair = (usize, usize);

impl Lowerer<'_> {
    /// `m.view((0, 0), (3, 3))`, `m.rows(0, 3)`, `m.columns(0, 3)`, `v.xyz()`, `v.push(1.0)` and `homogeneous(r, p)`; `None`
    /// if `name` is none of those.
    #[allow(clippy::option_option)] // Whether it is one of those, and whether it has no errors.
    pub(super) fn function_of_blocks(
        &mut self,
        name: &Ident,
        arguments: &[&Expr],
        call: &dyn ToTokens,
    ) -> Option<Option<Value>> {
        let written = name.to_string();
        let example = builtins::example_of_blocks(&written)?;
        if self.scope.function(name).is_some() {
            return None;
        }
        let expected = match written.as_str() {
            "xyz" => 1,
            "homogeneous" | "push" => 2,
            _ => 3,
        };
        if arguments.len() != expected {
            return Some(self.reject(call, format!("write `{example}`")));
        }
        Some(match written.as_str() {
            "homogeneous" => self.homogeneous(arguments),
            "push" => self.push(arguments),
            _ => self.part(&written, arguments, example),
        })
    }

    /// The value of an argument that is an array, with its numbers of rows and columns.
    fn matrix(&mut self, argument: &Expr) -> Option<(Value, Pair)> {
        let value = self.lower(argument)?;
        match self.shape(value) {
            Shape::Array { rows, columns } => Some((value, (rows, columns))),
            shape @ Shape::Scalar => {
                let message = format!("this is {shape}, which has no parts");
                self.reject(argument, message)
            }
        }
    }

    /// A block of a matrix.
    fn part(&mut self, name: &str, arguments: &[&Expr], example: &str) -> Option<Value> {
        let matrix = self.matrix(arguments[0]);
        let (first, size) = match name {
            "xyz" => ((0, 0), (3, 1)),
            "view" => {
                let first = self.pair(arguments[1], example);
                let size = self.pair(arguments[2], example);
                (first?, size?)
            }
            _ => {
                let (first, count) = (
                    self.natural_number(arguments[1], "this"),
                    self.natural_number(arguments[2], "this"),
                );
                let (first, count) = (first?, count?);
                let (_, (rows, columns)) = matrix?;
                if name == "rows" {
                    ((first, 0), (count, columns))
                } else {
                    ((0, first), (rows, count))
                }
            }
        };
        let (of, (rows, columns)) = matrix?;
        let shape = Shape::Array { rows, columns };
        if name == "xyz" && (columns != 1 || !(3..=4).contains(&rows)) {
            let message =
                format!("`xyz` is of a vector of 3 or 4 components, and this is of {shape}");
            return self.reject(arguments[0], message);
        }
        if let Some(block) = self.add(TypedOperation::Block { of, first, size }) {
            return Some(block);
        }
        let message = format!(
            "this block is empty or larger than the matrix, {shape}: write the first element and then the size, as in `{example}`"
        );
        self.reject(arguments[1], message)
    }

    /// [r p; 0 1].
    fn homogeneous(&mut self, arguments: &[&Expr]) -> Option<Value> {
        let [rotation, place] = [0, 1].map(|i| self.matrix(arguments[i]));
        let ((rotation, shape), (place, _)) = (rotation?, place?);
        if let Some(matrix) = self.add(TypedOperation::Homogeneous(rotation, place)) {
            return Some(matrix);
        }
        let (odd, wanted, found) = if shape == (3, 3) {
            (
                arguments[1],
                "the place of its origin is a vector of 3 components",
                place,
            )
        } else {
            (arguments[0], "its rotation is a 3×3 matrix", rotation)
        };
        let message = format!(
            "a homogeneous matrix is 4×4, and {wanted}: this is {}",
            self.shape(found)
        );
        self.reject(odd, message)
    }

    /// A vector with one more component.
    fn push(&mut self, arguments: &[&Expr]) -> Option<Value> {
        let vector = self.matrix(arguments[0]);
        let last = self.scalar(arguments[1]);
        let ((vector, (rows, columns)), last) = (vector?, last?);
        if columns != 1 {
            let shape = Shape::Array { rows, columns };
            let message = format!("`push` is of a vector, and this is of {shape}");
            return self.reject(arguments[0], message);
        }
        self.add(TypedOperation::Extended(vector, last))
    }

    /// `(i, j)`.
    fn pair(&mut self, argument: &Expr, example: &str) -> Option<Pair> {
        match without_parentheses(argument) {
            Expr::Tuple(pair) if pair.elems.len() == 2 => {
                let [first, second] = [0, 1].map(|i| self.natural_number(&pair.elems[i], "this"));
                Some((first?, second?))
            }
            _ => self.reject(
                argument,
                format!("here a row and a column stand in parentheses: write `{example}`"),
            ),
        }
    }
}
