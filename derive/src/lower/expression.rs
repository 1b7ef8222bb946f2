//! From Rust expressions to the typed graph.
//!
//! Input: `syn` expressions with their spans. Output: values of the typed graph, or
//! errors at the tokens that are not supported. Long sums and products are loops; only nesting
//! recurses, and `syntax/size.rs` bounds its depth.

mod external_function;
mod array;
mod block;
mod call;
mod binary_operators;
mod circle;
mod body;
mod component;
mod derivative;
mod reaction;
mod repetition;
mod rotation;

use lagrangian_symbolic::{
    Components, Contents, Expression, Graph, Rational, TypedGraph, TypedOperation, Value,
};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, ExprLit, ExprUnary, Lit, Stmt, UnOp};

use crate::diagnostics::Diagnostics;
use crate::limits::in_range;
use crate::lower::builtins;
use crate::lower::constraints::Constraints;
use crate::lower::hints;
use crate::lower::scope::{Binding, Origin, Scope};
use crate::syntax::named::NamedExpression;
use crate::syntax::names::{to_source, unraw};
use crate::syntax::shape::Shape;

/// The lowering of one declaration.
pub(crate) struct Lowerer<'a> {
    pub(crate) typed: TypedGraph,
    pub(crate) scope: Scope,
    pub(crate) coordinates: u32,
    pub(crate) diagnostics: &'a mut Diagnostics,
    /// The number of unrolled iterations so far, over all ranges.
    pub(crate) repetitions: usize,
    /// Whether accelerations may occur: in definitions and outputs, and not in energies, dissipation, forces and events, which
    /// are functions of q, q̇, t, parameters and inputs.
    pub(crate) admits_accelerations: bool,
    /// Whether an index is lowered: there an unknown name is an unbound variable.
    pub(crate) within_index: bool,
    /// Whether the derivative of a function is lowered, which contains neither coordinates nor the time.
    pub(crate) within_derivative: bool,
    /// The number of rotations by angles, and of angular velocities, so far.
    pub(crate) rotations: usize,
    /// What is defined by the declaration.
    pub(crate) definitions: &'a [NamedExpression],
    /// The definition that is lowered, and its indices.
    pub(crate) defining: Option<(Ident, Vec<usize>)>,
    /// The bodies whose kinetic energies were lowered, as their masses, with their angular velocities.
    pub(crate) turning: Vec<(Expression, Vec<Expression>)>,
    /// The constraints, whose reactions outputs and events may contain; none while they are not known.
    pub(crate) known_constraints: Option<Constraints>,
}

impl Lowerer<'_> {
    /// The value of `expression`; `None` if errors were reported.
    pub(crate) fn lower(&mut self, expression: &Expr) -> Option<Value> {
        match expression {
            Expr::Paren(inner) => self.lower(&inner.expr),
            Expr::Group(inner) => self.lower(&inner.expr),
            Expr::Block(block) => match (block.block.stmts.as_slice(), &block.label) {
                ([Stmt::Expr(only, None)], None) => self.lower(only),
                _ => self.reject(block, hints::unsupported_syntax(expression)),
            },
            Expr::Lit(literal) => self.literal(literal),
            Expr::Path(path) => match path.path.get_ident() {
                Some(name) if path.qself.is_none() && !leads_a_path(name) => self.name(name),
                _ => self.reject(path, hints::unsupported_path(path)),
            },
            Expr::Unary(unary) => self.negation(unary),
            Expr::Binary(binary) => self.chain(binary),
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method(call),
            Expr::Array(array) => self.array(array),
            Expr::Repeat(repeat) => self.repeat(repeat),
            Expr::Index(_) => self.indexed(expression),
            Expr::Field(field) => self.field(field),
            other => self.reject(other, hints::unsupported_syntax(other)),
        }
    }

    /// What `lower` makes of expressions in which accelerations may occur.
    pub(crate) fn with_accelerations<T>(&mut self, lower: impl FnOnce(&mut Self) -> T) -> T {
        let outside = core::mem::replace(&mut self.admits_accelerations, true);
        let lowered = lower(self);
        self.admits_accelerations = outside;
        lowered
    }

    /// The value of an expression in which accelerations may occur.
    pub(crate) fn lower_with_accelerations(&mut self, expression: &Expr) -> Option<Value> {
        self.with_accelerations(|lowerer| lowerer.lower(expression))
    }

    /// The value of an operation, if its arguments have one.
    pub(crate) fn add(&mut self, operation: TypedOperation) -> Option<Value> {
        self.typed.add(operation).ok()
    }

    /// The value of an integer.
    pub(crate) fn constant(&mut self, integer: i64) -> Option<Value> {
        self.add(TypedOperation::Constant(Rational::integer(integer)))
    }

    /// The graph of the components.
    pub(crate) const fn graph(&self) -> &Graph {
        &self.typed.geometry.graph
    }

    /// The components of a value, column by column.
    pub(crate) fn elements(&self, value: Value) -> &[Expression] {
        self.typed.components(value).elements()
    }

    pub(crate) fn shape(&self, value: Value) -> Shape {
        Shape::of_value(&self.typed, value)
    }

    pub(crate) fn is_empty_sum(&self, value: Value) -> bool {
        *self.typed.components(value) == Components::EmptySum
    }

    /// The values of expressions, each by `lower`; `None` if errors were reported, in any of them.
    pub(crate) fn each<'e>(
        &mut self,
        expressions: impl IntoIterator<Item = &'e Expr>,
        lower: impl Fn(&mut Self, &Expr) -> Option<Value>,
    ) -> Option<Vec<Value>> {
        let values = expressions.into_iter();
        let values: Vec<_> = values.map(|one| lower(self, one)).collect();
        values.into_iter().collect()
    }

    /// Whether a component of a value contains something.
    pub(crate) fn contains(&self, value: Value, what: fn(Contents) -> bool) -> bool {
        let mut components = self.elements(value).iter();
        components.any(|component| what(self.graph().contents(*component)))
    }

    /// The value of an expression where only a scalar fits.
    pub(crate) fn scalar(&mut self, expression: &Expr) -> Option<Value> {
        let value = self.lower(expression)?;
        self.as_scalar(value, expression)
    }

    /// A value, written as `tokens`, where only a scalar fits.
    pub(crate) fn as_scalar(&mut self, value: Value, tokens: impl ToTokens) -> Option<Value> {
        match self.typed.components(value) {
            Components::Scalar(_) => Some(value),
            Components::EmptySum => self.constant(0),
            Components::Array(_) => {
                let message = format!(
                    "this is {}, and a scalar belongs here: write one of its components, as in `v[0]` or \
                     `m[(0, 1)]`, or what makes a scalar of it, as in `a.dot(b)`",
                    self.shape(value)
                );
                self.reject(tokens, message)
            }
        }
    }

    /// The value of an expression that is an integer known at compile time: an index, or an end of
    /// a range.
    pub(crate) fn integer(&mut self, expression: &Expr) -> Option<i64> {
        let outside = core::mem::replace(&mut self.within_index, true);
        let value = self.with_accelerations(|lowerer| lowerer.scalar(expression));
        self.within_index = outside;
        let value = value?;
        let constant = self.typed.as_constant(value);
        match constant.map(Rational::to_integer) {
            Some(Some(integer)) => Some(integer),
            Some(None) => self.reject(
                expression,
                "this has to come out as an integer: indices count from 0, and `1/2` is one half here",
            ),
            None => self.reject(
                expression,
                "this has to be an integer that is known at compile time: write a number, the `i` of `|i|` \
                 or of `for i in …`, or `theta.len()`",
            ),
        }
    }

    pub(crate) fn reject<T>(
        &mut self,
        tokens: impl ToTokens,
        message: impl core::fmt::Display,
    ) -> Option<T> {
        self.diagnostics.error(tokens, message);
        None
    }

    fn literal(&mut self, literal: &ExprLit) -> Option<Value> {
        let (digits, suffix) = match &literal.lit {
            Lit::Int(integer) => (integer.base10_digits(), integer.suffix()),
            Lit::Float(float) => (float.base10_digits(), float.suffix()),
            Lit::Str(_) => {
                return self.reject(
                    literal,
                    "write the expression itself, without quotation marks",
                );
            }
            other => return self.reject(other, "write a number such as `2`, `0.5` or `1e-3`"),
        };
        if self.scope.is_bound(suffix) {
            let message = format!("a product is written with `*`: write `{digits} * {suffix}`");
            return self.reject(literal, message);
        }
        if !matches!(suffix, "" | "f64" | "f32") {
            return self.reject(literal, format!("numbers here are real: write `{digits}`"));
        }
        match Rational::from_decimal(digits) {
            Some(value) if in_range(&value) => self.add(TypedOperation::Constant(value)),
            _ => self.reject(
                literal,
                "this number is outside of the range of `f64`, 5e-324 to 1.8e308: choose units in which \
                 it is not",
            ),
        }
    }

    fn name(&mut self, name: &Ident) -> Option<Value> {
        self.check_within_derivative(name)?;
        match self.scope.resolve(name) {
            Some(Binding::Quantity(origin, value)) => {
                self.check_accelerations(name, origin, value)?;
                Some(value)
            }
            Some(Binding::Family(_, family)) => {
                let brackets = "[i]".repeat(family.rank);
                let message = format!(
                    "`{name}` is a family of {} quantities: write one of them, as in `{name}{brackets}`, or all \
                     of them, `vector({name})`",
                    family.members.len()
                );
                self.reject(name, message)
            }
            Some(Binding::Bodies(family)) => {
                let message = hints::bodies(name, &family);
                self.reject(name, message)
            }
            Some(other) => self.refuse(name, &other),
            None => self.unknown(name),
        }
    }

    /// Energies do not contain accelerations; a definition that does is for outputs only.
    fn check_accelerations(&mut self, name: &Ident, origin: Origin, value: Value) -> Option<()> {
        if origin == Origin::Defined && !self.admits_accelerations && self.has_acceleration(value) {
            let message = format!(
                "`{name}` contains accelerations, which energies, forces and events cannot: \
                 use it under `output`"
            );
            return self.reject(name, message);
        }
        Some(())
    }

    /// An unresolved name that can be used here.
    fn refuse<T>(&mut self, name: &Ident, binding: &Binding) -> Option<T> {
        let message = match binding {
            Binding::DefinedLater => self.circle(name).unwrap_or_else(|| {
                format!("`{name}` is not defined yet: a definition may use only those before it")
            }),
            Binding::Output => format!(
                "`{name}` is an output: write it under `define` to use it in other expressions"
            ),
            Binding::Skipped => {
                self.scope.silence(name);
                format!("the field `{name}` is marked `skip`: remove the mark to use it here")
            }
            Binding::Quantity(..)
            | Binding::Family(..)
            | Binding::Bodies(..)
            | Binding::Poisoned => return None,
        };
        self.reject(name, message)
    }

    /// An unresolved name.
    fn unknown<T>(&mut self, name: &Ident) -> Option<T> {
        if !self.scope.complete {
            return None;
        }
        let written = unraw(name);
        if self.within_index {
            self.scope.silence(name);
            return self.reject(name, hints::not_an_integer(name));
        }
        if let Some(coordinate) = self.differentiated(&written) {
            let message =
                format!("unknown name `{name}`: the velocity is written `dot({coordinate})`");
            return self.reject(name, message);
        }
        if written == "pi" {
            return self.reject(name, "unknown name `pi`: the number π is `PI`");
        }
        if let Some(meant) = self.scope.suggest(name) {
            let message = format!("unknown name `{name}`: did you mean `{meant}`?");
            return self.reject(name, message);
        }
        if builtins::is_function(&written) || self.scope.function(name).is_some() {
            return self.reject(name, format!("`{name}` is a function: write `{name}(x)`"));
        }
        if self.scope.note_unknown(name) {
            let message = hints::unknown_name(name, &self.scope.quantities());
            return self.reject(name, message);
        }
        None
    }

    /// The coordinate of which `theta_dot`, `thetadot`, `d_theta` or `dtheta` is written as a velocity.
    fn differentiated(&self, name: &str) -> Option<String> {
        let before = ["_dot", "dot"].map(|suffix| name.strip_suffix(suffix));
        let behind = ["d_", "d"].map(|prefix| name.strip_prefix(prefix));
        before
            .into_iter()
            .chain(behind)
            .flatten()
            .find(|stem| self.scope.is_coordinate(stem))
            .map(to_source)
    }

    fn negation(&mut self, unary: &ExprUnary) -> Option<Value> {
        match unary.op {
            UnOp::Neg(_) => {
                let operand = self.lower(&unary.expr)?;
                if self.typed.components(operand).array().is_none() {
                    let terms = vec![(operand, Rational::MINUS_ONE)];
                    return self.add(TypedOperation::Sum(terms));
                }
                let opposite = self.constant(-1)?;
                self.add(TypedOperation::Scaled(operand, opposite))
            }
            UnOp::Deref(_) => self.reject(
                unary.op,
                "`**` is no power, and there are no references here: write `x.powi(2)`, or `x.powf(1.5)`",
            ),
            _ => self.reject(
                unary.op,
                "only the minus sign stands in front of an expression here",
            ),
        }
    }

    pub(crate) fn has_acceleration(&self, value: Value) -> bool {
        self.contains(value, Contents::has_acceleration)
    }
}

/// Whether an identifier is a keyword with which only paths begin.
fn leads_a_path(name: &Ident) -> bool {
    ["self", "Self", "super", "crate"]
        .iter()
        .any(|word| name == word)
}
