//! `dot(x)`: the total time derivative.

use lagrangian_symbolic::{Contents, TypedOperation, Value};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Expr, ExprCall};

use super::Lowerer;
use super::external_function::MADE_OF;
use crate::lower::scope::{Binding, Origin};

impl Lowerer<'_> {
    pub(super) fn time_derivative(
        &mut self,
        call: &ExprCall,
        arguments: &[&Expr],
    ) -> Option<Value> {
        let argument = match arguments {
            [argument] => argument,
            [_, _] => {
                let message = "`dot` takes one argument: write `dot(theta)` for a time derivative, and \
                               `a.dot(b)` for the product of two vectors";
                return self.reject(call, message);
            }
            _ => return self.reject(call, "`dot` takes one argument: write `dot(theta)`"),
        };
        let value = self.lower_with_accelerations(argument)?;
        let varies = self.contains(value, Contents::varies);
        if !varies && !self.is_empty_sum(value) && !self.is_named(argument.to_token_stream()) {
            return self.reject(
                argument,
                "this is constant in time: take `dot` of a coordinate, or of what is made of coordinates",
            );
        }
        self.rate(call, value)
    }

    /// The time derivative of a value.
    pub(super) fn rate(&mut self, call: &dyn ToTokens, value: Value) -> Option<Value> {
        self.check_differentiable(call, value)?;
        let rate = self.add(TypedOperation::TimeDerivative(value))?;
        self.check_derivative(call, rate)?;
        Some(rate)
    }

    /// Rejects the time derivative of inputs and accelerations.
    pub(super) fn check_differentiable(&mut self, call: &dyn ToTokens, value: Value) -> Option<()> {
        if self.within_derivative {
            return self.reject(call, format!("no time passes in a function: {MADE_OF}"));
        }
        if self.contains(value, Contents::has_input) {
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
        Some(())
    }

    /// A time derivative with accelerations is for outputs only.
    pub(super) fn check_derivative(
        &mut self,
        call: &dyn ToTokens,
        derivative: Value,
    ) -> Option<()> {
        if !self.admits_accelerations && self.has_acceleration(derivative) {
            return self.reject(
                call,
                "`dot` of what contains velocities contains accelerations, which energies, forces and events cannot: \
                 use it under `output`",
            );
        }
        Some(())
    }

    /// Whether this refers to a definition or a variable: the derivative of one that happens to be constant is no
    /// mistake.
    fn is_named(&mut self, tokens: TokenStream) -> bool {
        tokens.into_iter().any(|token| match token {
            TokenTree::Group(group) => self.is_named(group.stream()),
            TokenTree::Ident(name) => matches!(
                self.scope.resolve(&name),
                Some(
                    Binding::Quantity(Origin::Defined | Origin::Variable, _)
                        | Binding::Family(Origin::Defined, _)
                )
            ),
            _ => false,
        })
    }
}
