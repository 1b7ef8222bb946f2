//! External functions: the declaration of their derivatives, and their application.

use lagrangian_symbolic::{Contents, ExternalFunction, Symbol, TypedOperation, Value};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::Expr;

use super::Lowerer;
use crate::lower::scope::{Binding, Origin};
use crate::syntax::external_function::{DerivativeDeclaration, FunctionDeclaration};
use crate::syntax::names::unraw;

impl Lowerer<'_> {
    /// Declares all functions, then their derivatives, which may be made of any of them.
    pub(crate) fn declare_functions(&mut self, declared: &[FunctionDeclaration]) {
        let mut functions = Vec::with_capacity(declared.len());
        for declared in declared {
            let arguments: Vec<String> = declared.arguments.iter().map(unraw).collect();
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            let graph = &mut self.typed.geometry.graph;
            let function = graph.declare_function(&unraw(&declared.name), &arguments);
            self.scope.declare_function(&declared.name, function);
            functions.push(function);
        }
        for (declared, function) in declared.iter().zip(functions) {
            for derivative in &declared.derivatives {
                self.declare_derivative(function, &declared.arguments, derivative);
            }
        }
    }

    fn declare_derivative(
        &mut self,
        function: ExternalFunction,
        arguments: &[Ident],
        derivative: &DerivativeDeclaration,
    ) {
        let mut hidden = Vec::new();
        for (i, argument) in (0..).zip(arguments) {
            if let Some(value) = self.add(TypedOperation::Symbol(Symbol::Argument(i))) {
                hidden.push((argument, self.scope.bind(argument, value)));
            }
        }
        self.within_derivative = true;
        let value = self.with_accelerations(|lowerer| lowerer.scalar(&derivative.expression));
        self.within_derivative = false;
        for (argument, before) in hidden.into_iter().rev() {
            self.scope.release(argument, before);
        }
        let mut names = arguments.iter();
        let argument = names.position(|argument| unraw(argument) == unraw(&derivative.argument));
        if let (Some(value), Some(argument)) = (value, argument) {
            let value = self.typed.expression(value);
            let graph = &mut self.typed.geometry.graph;
            if graph.contents(value).varies_in_time() {
                return self.diagnostics.error(&derivative.expression, MADE_OF);
            }
            graph.declare_derivative(function, argument, value);
        }
    }

    /// Rejects names that the derivative of a function cannot refer to.
    pub(super) fn check_within_derivative(&mut self, name: &Ident) -> Option<()> {
        if !self.within_derivative {
            return Some(());
        }
        let known = match self.scope.resolve(name) {
            Some(
                Binding::Quantity(Origin::Defined, _) | Binding::Family(..) | Binding::DefinedLater,
            ) => false,
            Some(Binding::Quantity(_, value)) => !self.contains(value, Contents::varies_in_time),
            _ => true,
        };
        if known {
            return Some(());
        }
        self.reject(
            name,
            format!("`{name}` is unknown to this function: {MADE_OF}"),
        )
    }

    /// An external function, applied to scalars.
    pub(super) fn application(
        &mut self,
        function: ExternalFunction,
        arguments: &[&Expr],
        call: impl ToTokens,
    ) -> Option<Value> {
        let expected = self.graph().function_arguments(function);
        if expected.len() != arguments.len() {
            let name = self.graph().function_name(function);
            let count = match expected {
                [] => "no arguments".to_owned(),
                [_] => "one argument".to_owned(),
                [_, _] => "two arguments".to_owned(),
                more => format!("{} arguments", more.len()),
            };
            let message = format!(
                "`{name}` takes {count}: write `{name}({})`",
                expected.join(", ")
            );
            return self.reject(call, message);
        }
        let values = self.each(arguments.iter().copied(), Self::scalar)?;
        self.add(TypedOperation::External(function, values))
    }
}

pub(super) const MADE_OF: &str =
    "a derivative is made of the function's arguments, of parameters and of other functions";
