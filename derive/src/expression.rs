//! From Rust expressions to the expression graph.
//!
//! Comes in: `syn` expressions with their spans. Goes out: handles of the graph, or errors at the
//! tokens that are not understood. Long sums and products are loops; only nesting recurses, which the
//! compiler's own parser bounds.

use lagrangian_symbolic::{Binary, Expression, Graph, Rational, Unary};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{BinOp, Expr, ExprBinary, ExprCall, ExprLit, ExprMethodCall, ExprUnary, Lit, UnOp};

use crate::diagnostics::Diagnostics;
use crate::hints;
use crate::methods::in_range;
use crate::names::{plain, spelled};
use crate::scope::{Meaning, Scope};

/// Where an expression stands, which decides what it may contain.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
    /// Energies, dissipation and forces: functions of q, q̇, t, parameters and inputs.
    Energy,
    /// Definitions and outputs, which may contain accelerations.
    Observation,
}

/// The translation of one declaration.
pub(crate) struct Translator<'a> {
    pub(crate) graph: Graph,
    pub(crate) scope: Scope,
    pub(crate) coordinates: u32,
    pub(crate) diagnostics: &'a mut Diagnostics,
}

/// A chain of operations of one kind, kept until it ends.
enum Chain {
    Sum(Vec<(Expression, Rational)>),
    Product(Vec<(Expression, Rational)>),
}

impl Translator<'_> {
    /// The handle of `expression`; `None` if errors were reported.
    pub(crate) fn translate(&mut self, expression: &Expr, place: Place) -> Option<Expression> {
        match expression {
            Expr::Paren(inner) => self.translate(&inner.expr, place),
            Expr::Group(inner) => self.translate(&inner.expr, place),
            Expr::Lit(literal) => self.literal(literal),
            Expr::Path(path) => match path.path.get_ident() {
                Some(name) if path.qself.is_none() && !leads_a_path(name) => self.name(name, place),
                _ => self.reject(path, hints::path(path)),
            },
            Expr::Unary(unary) => self.negation(unary, place),
            Expr::Binary(binary) => self.chain(binary, place),
            Expr::Call(call) => self.call(call, place),
            Expr::MethodCall(call) => self.method(call, place),
            Expr::Field(field) => self.reject(field, hints::field(field)),
            other => self.reject(other, hints::syntax(other)),
        }
    }

    fn reject<T>(&mut self, tokens: impl ToTokens, message: impl core::fmt::Display) -> Option<T> {
        self.diagnostics.error(tokens, message);
        None
    }

    fn literal(&mut self, literal: &ExprLit) -> Option<Expression> {
        let (digits, suffix) = match &literal.lit {
            Lit::Int(integer) => (integer.base10_digits(), integer.suffix()),
            Lit::Float(float) => (float.base10_digits(), float.suffix()),
            other => return self.reject(other, "write a number such as `2`, `0.5` or `1e-3`"),
        };
        if !matches!(suffix, "" | "f64" | "f32") {
            return self.reject(literal, format!("numbers here are real: write `{digits}`"));
        }
        match Rational::from_decimal(digits) {
            Some(value) if in_range(&value) => Some(self.graph.constant(&value)),
            _ => self.reject(
                literal,
                "this number is outside of the range of `f64`, 5e-324 to 1.8e308: choose units in which \
                 it is not",
            ),
        }
    }

    fn name(&mut self, name: &Ident, place: Place) -> Option<Expression> {
        match self.scope.resolve(name) {
            Some(Meaning::Symbol(symbol)) => Some(self.graph.symbol(symbol)),
            Some(Meaning::Pi) => Some(self.graph.pi()),
            Some(Meaning::Defined(expression)) => {
                if place == Place::Energy && self.has_acceleration(expression) {
                    return self.reject(
                        name,
                        format!(
                            "`{name}` contains accelerations, which energies and forces cannot: \
                             use it under `output`"
                        ),
                    );
                }
                Some(expression)
            }
            Some(Meaning::Broken) => None,
            Some(Meaning::Later) => self.reject(
                name,
                format!("`{name}` is not defined yet: a definition may use only those before it"),
            ),
            Some(Meaning::Output) => self.reject(
                name,
                format!(
                    "`{name}` is an output: write it under `define` to use it in other expressions"
                ),
            ),
            Some(Meaning::Skipped) => {
                self.scope.silence(name);
                self.reject(
                    name,
                    format!("the field `{name}` is marked `skip`: remove the mark to use it here"),
                )
            }
            None => self.unknown(name),
        }
    }

    /// A name that stands for nothing. What looks like a misspelt coordinate, definition or function is
    /// ours to report; anything else may have been a field, and the compiler says so best.
    fn unknown(&mut self, name: &Ident) -> Option<Expression> {
        if !self.scope.complete {
            return None;
        }
        let written = plain(name);
        if let Some(coordinate) = self.differentiated(&written) {
            let message =
                format!("unknown name `{name}`: the velocity is written `dot({coordinate})`");
            return self.reject(name, message);
        }
        if let Some(meant) = self.scope.suggest(name) {
            let message = format!("unknown name `{name}`: did you mean `{meant}`?");
            return self.reject(name, message);
        }
        if hints::is_function(&written) {
            return self.reject(name, format!("`{name}` is a function: write `{name}(x)`"));
        }
        self.scope.note_unknown(name);
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
            .find(|stem| self.scope.coordinate(stem).is_some())
            .map(spelled)
    }

    fn negation(&mut self, unary: &ExprUnary, place: Place) -> Option<Expression> {
        match unary.op {
            UnOp::Neg(_) => {
                let operand = self.translate(&unary.expr, place)?;
                Some(self.graph.negate(operand))
            }
            _ => self.reject(
                unary.op,
                "only the minus sign stands in front of an expression here",
            ),
        }
    }

    /// A chain of operators, from the left.
    fn chain(&mut self, binary: &ExprBinary, place: Place) -> Option<Expression> {
        let mut steps = vec![(&binary.op, &*binary.right)];
        let mut first = &*binary.left;
        while let Expr::Binary(inner) = first {
            steps.push((&inner.op, &*inner.right));
            first = &*inner.left;
        }
        let first = self.translate(first, place);
        let mut chain = first.map(|first| Chain::Sum(vec![(first, Rational::ONE)]));
        for (operator, operand) in steps.into_iter().rev() {
            let value = self.operand(operator, operand, place);
            chain = match (chain, value) {
                (Some(chain), Some(value)) => Some(self.extend(chain, operator, value)),
                _ => None,
            };
        }
        chain.map(|chain| self.close(chain))
    }

    /// The operand on the right of an operator that is understood.
    fn operand(&mut self, operator: &BinOp, operand: &Expr, place: Place) -> Option<Expression> {
        if let Some(hint) = hints::operator(operator) {
            return self.reject(operator, hint);
        }
        let value = self.translate(operand, place)?;
        if matches!(operator, BinOp::Div(_)) && self.graph.is_zero(value) {
            return self.reject(
                operand,
                "this divisor is zero: the quotient has no value anywhere",
            );
        }
        Some(value)
    }

    fn extend(&mut self, chain: Chain, operator: &BinOp, value: Expression) -> Chain {
        let sign = match operator {
            BinOp::Sub(_) | BinOp::Div(_) => Rational::MINUS_ONE,
            _ => Rational::ONE,
        };
        let additive = matches!(operator, BinOp::Add(_) | BinOp::Sub(_));
        match (chain, additive) {
            (Chain::Sum(mut terms), true) => {
                terms.push((value, sign));
                Chain::Sum(terms)
            }
            (Chain::Product(mut factors), false) => {
                factors.push((value, sign));
                Chain::Product(factors)
            }
            (chain, additive) => {
                let start = vec![(self.close(chain), Rational::ONE), (value, sign)];
                if additive {
                    Chain::Sum(start)
                } else {
                    Chain::Product(start)
                }
            }
        }
    }

    fn close(&mut self, chain: Chain) -> Expression {
        match chain {
            Chain::Sum(terms) => self.graph.sum(terms),
            Chain::Product(factors) => self.graph.product(factors),
        }
    }

    fn call(&mut self, call: &ExprCall, place: Place) -> Option<Expression> {
        let name = match &*call.func {
            Expr::Path(path) if path.qself.is_none() => path.path.get_ident(),
            _ => None,
        };
        let Some(name) = name else {
            return self.reject(&call.func, hints::callee(&call.func));
        };
        let arguments: Vec<&Expr> = call.args.iter().collect();
        if name == "dot" {
            return self.time_derivative(call, &arguments, place);
        }
        self.apply(name, &arguments, call, place)
    }

    fn method(&mut self, call: &ExprMethodCall, place: Place) -> Option<Expression> {
        let mut arguments = vec![&*call.receiver];
        arguments.extend(&call.args);
        let name = plain(&call.method);
        if let (Some(turbofish), true) = (&call.turbofish, hints::is_function(&name)) {
            return self.reject(
                turbofish,
                format!("functions here take no type arguments: write `.{name}(…)`"),
            );
        }
        self.apply(&call.method, &arguments, call, place)
    }

    /// A function of the table, `sqrt`, `powi`, `powf` or `recip`.
    fn apply(
        &mut self,
        name: &Ident,
        arguments: &[&Expr],
        call: impl ToTokens,
        place: Place,
    ) -> Option<Expression> {
        let written = name.to_string();
        let unary = Unary::ALL
            .into_iter()
            .find(|function| function.name() == written);
        let binary = Binary::ALL
            .into_iter()
            .find(|function| function.name() == written);
        let expected = match written.as_str() {
            "sqrt" | "recip" => 1,
            "powi" => 2,
            _ if unary.is_some() => 1,
            _ if binary.is_some() => 2,
            _ if self.scope.resolve(name).is_some() => {
                let message =
                    format!("`{name}` is no function: write `{name} * (…)` for a product");
                return self.reject(name, message);
            }
            _ => return self.reject(name, hints::function(&written)),
        };
        if arguments.len() != expected {
            let message = format!(
                "`{written}` takes {}: write `{}`",
                if expected == 1 {
                    "one argument"
                } else {
                    "two arguments"
                },
                hints::example(&written, expected),
            );
            return self.reject(call, message);
        }
        let values: Vec<_> = arguments
            .iter()
            .map(|argument| self.translate(argument, place))
            .collect();
        let values: Vec<Expression> = values.into_iter().collect::<Option<_>>()?;
        match (unary, binary) {
            (Some(function), _) => Some(self.graph.unary(function, values[0])),
            (_, Some(function)) => Some(self.graph.binary(function, values[0], values[1])),
            _ => self.power(&written, arguments, &values),
        }
    }

    fn power(
        &mut self,
        name: &str,
        arguments: &[&Expr],
        values: &[Expression],
    ) -> Option<Expression> {
        let exponent = match name {
            "sqrt" => Rational::HALF,
            "recip" => Rational::MINUS_ONE,
            _ => match self
                .graph
                .as_constant(values[1])
                .and_then(Rational::to_integer)
            {
                Some(exponent) if i32::try_from(exponent).is_ok() => Rational::integer(exponent),
                _ => {
                    return self.reject(
                        arguments[1],
                        "the exponent of `powi` is an integer constant: write `x.powi(2)`, or `x.powf(y)` \
                         for any other exponent",
                    );
                }
            },
        };
        if exponent.is_negative() && self.graph.is_zero(values[0]) {
            return self.reject(
                arguments[0],
                "this divisor is zero: the quotient has no value anywhere",
            );
        }
        Some(self.graph.power(values[0], &exponent))
    }

    /// `dot(x)`: the total time derivative.
    fn time_derivative(
        &mut self,
        call: &ExprCall,
        arguments: &[&Expr],
        place: Place,
    ) -> Option<Expression> {
        let [argument] = arguments else {
            return self.reject(call, "`dot` takes one argument: write `dot(theta)`");
        };
        let value = self.translate(argument, Place::Observation)?;
        if !self.graph.contents(value).varies() && !self.is_defined(argument) {
            return self.reject(
                argument,
                "this is constant in time: take `dot` of a coordinate, or of what is made of coordinates",
            );
        }
        if self.graph.contents(value).has_input() {
            return self.reject(
                call,
                "this contains an input, whose rate of change is unknown: take `dot` of coordinates and of \
                 what is made of them, or make the input a coordinate",
            );
        }
        if self.has_acceleration(value) {
            return self.reject(
                call,
                "this contains accelerations already: a third time derivative is not part of the equations \
                 of motion",
            );
        }
        let derivative = self.graph.time_derivatives(&[value], self.coordinates)[0];
        if place == Place::Energy && self.has_acceleration(derivative) {
            return self.reject(
                call,
                "`dot` of what contains velocities contains accelerations, which energies and forces cannot: \
                 use it under `output`",
            );
        }
        Some(derivative)
    }

    /// Whether this is the name of a definition: one that happens to be constant is no mistake.
    fn is_defined(&mut self, expression: &Expr) -> bool {
        match expression {
            Expr::Paren(inner) => self.is_defined(&inner.expr),
            Expr::Group(inner) => self.is_defined(&inner.expr),
            Expr::Path(path) => path
                .path
                .get_ident()
                .is_some_and(|name| matches!(self.scope.resolve(name), Some(Meaning::Defined(_)))),
            _ => false,
        }
    }

    fn has_acceleration(&self, expression: Expression) -> bool {
        self.graph.contents(expression).has_acceleration()
    }
}

/// Whether a word is one of those that only paths begin with, which no field can be called.
fn leads_a_path(name: &Ident) -> bool {
    ["self", "Self", "super", "crate"]
        .iter()
        .any(|word| name == word)
}
