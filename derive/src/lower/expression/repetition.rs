//! Iteration over ranges and arrays, unrolled: sums, products, families.

use lagrangian_symbolic::{Components, Rational, TypedOperation, Value};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, ExprClosure, ExprMethodCall, Pat, RangeLimits};

use super::Lowerer;
use crate::limits::MAX_REPETITIONS;
use crate::lower::hints;
use crate::lower::value::{Product, Sum};
use crate::syntax::named::ForClause;
use crate::syntax::names::RESERVED;
use crate::syntax::shape::Shape;

/// Whether a method call ends an iteration, as `.sum()` does in `(0..5).map(|i| …).sum()`.
pub(super) fn repeated(call: &ExprMethodCall) -> Option<&ExprMethodCall> {
    if !["sum", "product", "collect"]
        .iter()
        .any(|name| call.method == name)
    {
        return None;
    }
    match &*call.receiver {
        Expr::MethodCall(map) if map.method == "map" => Some(map),
        _ => None,
    }
}

impl Lowerer<'_> {
    /// `range.map(|i| …).sum()`, `.product()` or `.collect()`.
    pub(super) fn repetition(
        &mut self,
        call: &ExprMethodCall,
        map: &ExprMethodCall,
    ) -> Option<Value> {
        if let Some(argument) = call.args.first() {
            let message = format!("write `.{}()`", call.method);
            return self.reject(argument, message);
        }
        let values = self.mapped(map)?;
        if call.method == "collect" {
            return self.collected(call, values);
        }
        let product = call.method == "product";
        self.folded(call, values, product)
    }

    /// The sum or the product of values.
    pub(super) fn folded(
        &mut self,
        call: &ExprMethodCall,
        values: Vec<Value>,
        product: bool,
    ) -> Option<Value> {
        let mut sum = Sum::default();
        let mut factors = Product::default();
        for value in values {
            let shape = self.shape(value);
            let result = if product {
                factors.multiply(&mut self.typed, value, Rational::ONE)
            } else {
                sum.add(&self.typed, value, Rational::ONE)
            };
            if let Err(before) = result {
                let message = if product {
                    format!("the factors do not fit: {shape} stands behind {before}")
                } else {
                    format!(
                        "the terms have different shapes: one is {before}, and another is {shape}"
                    )
                };
                return self.reject(&call.method, message);
            }
        }
        if product {
            factors.value(&mut self.typed)
        } else {
            sum.value(&mut self.typed)
        }
    }

    /// The values of a closure: for each index of a range, or each component of a vector.
    pub(super) fn mapped(&mut self, map: &ExprMethodCall) -> Option<Vec<Value>> {
        let arguments: Vec<Value> = match without_parentheses(&map.receiver) {
            range @ Expr::Range(_) => {
                let mut indices = self.indices(range)?;
                indices.try_fold(Vec::new(), |mut known, i| {
                    known.push(self.constant(i)?);
                    Some(known)
                })?
            }
            receiver => {
                let array = self.lower(receiver)?;
                if self.typed.components(array).array().is_none() {
                    let message = format!(
                        "this is {}, and `map` goes through a range or an array: write `(0..5).map(|i| …)`",
                        self.shape(array)
                    );
                    return self.reject(receiver, message);
                }
                self.each_element(array)?
            }
        };
        self.applied(map, arguments)
    }

    /// The values of the closure of `.map(|i| …)` for each of some arguments.
    pub(super) fn applied(
        &mut self,
        map: &ExprMethodCall,
        arguments: Vec<Value>,
    ) -> Option<Vec<Value>> {
        let (closure, variable) = self.closure(map)?;
        let mut values = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let before = variable.map(|name| (name, self.scope.bind(name, argument)));
            let value = self.lower(&closure.body);
            if let Some((name, before)) = before {
                self.scope.release(name, before);
            }
            // One error is enough for all indices.
            values.push(value?);
        }
        Some(values)
    }

    /// The closure of `.map(|i| …)` and its variable, if it has a name.
    fn closure<'a>(
        &mut self,
        map: &'a ExprMethodCall,
    ) -> Option<(&'a ExprClosure, Option<&'a Ident>)> {
        let message = "write `.map(|i| …)`";
        let mut arguments = map.args.iter();
        let (Some(Expr::Closure(closure)), None) = (arguments.next(), arguments.next()) else {
            return match map.args.first() {
                Some(argument) => self.reject(argument, message),
                None => self.reject(&map.method, message),
            };
        };
        let mut inputs = closure.inputs.iter();
        let (Some(input), None) = (inputs.next(), inputs.next()) else {
            return self.reject(
                &closure.inputs,
                "one variable stands between the bars: write `|i|`",
            );
        };
        match input {
            Pat::Wild(_) => Some((closure, None)),
            Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => {
                self.check_variable(&name.ident)?;
                Some((closure, Some(&name.ident)))
            }
            other => self.reject(other, "a variable is a name alone: write `|i|`"),
        }
    }

    fn check_variable(&mut self, name: &Ident) -> Option<()> {
        if RESERVED.iter().any(|reserved| name == reserved) {
            let message = format!("`{name}` has a meaning already: choose another name");
            return self.reject(name, message);
        }
        Some(())
    }

    /// The integers of `a..b` or `a..=b`.
    pub(super) fn indices(&mut self, range: &Expr) -> Option<core::ops::Range<i64>> {
        let Expr::Range(written) = without_parentheses(range) else {
            return self.reject(range, "write a range of integers: `0..5`");
        };
        let (Some(start), Some(end)) = (&written.start, &written.end) else {
            return self.reject(range, "a range has two ends: write `0..5`");
        };
        let (start, end) = (self.integer(start), self.integer(end));
        let (start, mut end) = (start?, end?);
        if matches!(written.limits, RangeLimits::Closed(_)) {
            end = end.saturating_add(1);
        }
        let length = usize::try_from(end.saturating_sub(start)).unwrap_or(0);
        self.repetitions = self.repetitions.saturating_add(length);
        if self.repetitions > MAX_REPETITIONS {
            let message = format!(
                "with this range, {} terms would be written out, and at most {MAX_REPETITIONS} are in one \
                 declaration",
                self.repetitions
            );
            self.repetitions = 0;
            return self.reject(range, message);
        }
        Some(start..end)
    }

    /// Runs an action for all values of the variables of `for … in …`, of which later ones may depend on those
    /// before; stops at the first error.
    pub(crate) fn for_each(
        &mut self,
        iterations: &[ForClause],
        action: &mut dyn FnMut(&mut Self) -> Option<()>,
    ) -> Option<()> {
        let Some((iteration, inner)) = iterations.split_first() else {
            return action(self);
        };
        self.check_variable(&iteration.index)?;
        for i in self.indices(&iteration.range)? {
            let value = self.constant(i)?;
            let before = self.scope.bind(&iteration.index, value);
            let done = self.for_each(inner, action);
            self.scope.release(&iteration.index, before);
            done?;
        }
        Some(())
    }

    /// The vector or matrix with these values as components or rows.
    fn collected(&mut self, call: &ExprMethodCall, values: Vec<Value>) -> Option<Value> {
        if values.is_empty() {
            return self.reject(
                &call.receiver,
                "this range is empty: a vector has components",
            );
        }
        let values = self.filled(values)?;
        self.rows(values, |_| &call.method)
    }
}

impl Lowerer<'_> {
    /// The elements of an array, column by column.
    pub(super) fn each_element(&mut self, array: Value) -> Option<Vec<Value>> {
        let count = self.elements(array).len();
        let elements = (0..count).map(|i| self.add(TypedOperation::Element(array, i)));
        elements.collect()
    }

    /// Values with empty sums replaced by zeros of the shape of the others.
    pub(super) fn filled(&mut self, mut values: Vec<Value>) -> Option<Vec<Value>> {
        let like = values.iter().find(|value| !self.is_empty_sum(**value));
        let shape = like.map_or(Shape::Scalar, |value| self.shape(*value));
        for value in &mut values {
            if self.is_empty_sum(*value) {
                *value = shape.zeros(&mut self.typed)?;
            }
        }
        Some(values)
    }

    /// Scalars as a vector, or vectors as the rows of a matrix. Where one does not fit the first, an error is at the tokens that `at`
    /// gives for its position.
    pub(super) fn rows<T: ToTokens>(
        &mut self,
        values: Vec<Value>,
        at: impl Fn(usize) -> T,
    ) -> Option<Value> {
        let shape = self.shape(*values.first()?);
        let fits = |value: &Value| {
            *self.typed.components(*value) != Components::EmptySum && self.shape(*value) == shape
        };
        let is_matrix = matches!(
            shape,
            Shape::Array {
                rows: 2..,
                columns: 2..
            }
        );
        let odd = values.iter().position(|value| !fits(value));
        if let Some(odd) = odd.or_else(|| is_matrix.then_some(0)) {
            let message = hints::incompatible_rows(shape, self.shape(values[odd]));
            return self.reject(at(odd), message);
        }
        self.add(TypedOperation::Rows(values))
    }
}

/// The name that an expression is, if it is nothing else.
pub(super) fn as_name(expression: &Expr) -> Option<&Ident> {
    match expression {
        Expr::Path(path) if path.qself.is_none() => path.path.get_ident(),
        _ => None,
    }
}

pub(super) fn without_parentheses(expression: &Expr) -> &Expr {
    match expression {
        Expr::Paren(inner) => without_parentheses(&inner.expr),
        Expr::Group(inner) => without_parentheses(&inner.expr),
        other => other,
    }
}
