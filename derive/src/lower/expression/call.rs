//! Functions, called by name or as methods.

use lagrangian_symbolic::{ArrayFunction, Binary, Rational, TypedOperation, Unary, Value};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, ExprCall, ExprMethodCall};

use super::Lowerer;
use super::repetition::{as_name, repeated, without_parentheses};
use crate::lower::builtins;
use crate::lower::hints;
use crate::lower::scope::Binding;
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

impl Lowerer<'_> {
    pub(super) fn call(&mut self, call: &ExprCall) -> Option<Value> {
        let Some(name) = as_name(&call.func) else {
            return self.reject(&call.func, hints::not_callable(&call.func));
        };
        let arguments: Vec<&Expr> = call.args.iter().collect();
        if name == "dot" {
            return self.time_derivative(call, &arguments);
        }
        if name == "reaction" && self.scope.function(name).is_none() {
            return self.reaction(call, &arguments);
        }
        if name == "vector" {
            return self.family_as_vector(call, &arguments);
        }
        if let Some(value) = self.rotation(name, call, &arguments) {
            return value;
        }
        if let Some(value) = self.function_of_body(name, &arguments, call) {
            return value;
        }
        if let Some(value) = self.function_of_blocks(name, &arguments, call) {
            return value;
        }
        self.apply(name, &arguments, call)
    }

    pub(super) fn method(&mut self, call: &ExprMethodCall) -> Option<Value> {
        let name = unraw(&call.method);
        if let (Some(turbofish), true) = (&call.turbofish, builtins::is_function(&name)) {
            let arguments = if call.args.is_empty() { "" } else { "…" };
            return self.reject(
                turbofish,
                format!("functions here take no type arguments: write `.{name}({arguments})`"),
            );
        }
        if let Some(map) = repeated(call) {
            return self.repetition(call, map);
        }
        if name == "map" {
            return self.map(call);
        }
        if let Some(module) = self.module(&call.receiver)
            && builtins::is_function(&name)
        {
            let message = format!("functions are written without `{module}`: write `{name}(…)`");
            return self.reject(&call.receiver, message);
        }
        if let (Expr::Range(_), false) = (without_parentheses(&call.receiver), name == "len") {
            let message =
                format!("write `(0..5).map(|i| …).sum()`, not `.{name}(…)`, behind a range");
            return self.reject(&call.method, message);
        }
        if name == "len"
            && call.args.is_empty()
            && let Some(length) = self.length_of_family(&call.receiver)
        {
            return self.constant(length);
        }
        let mut arguments = vec![&*call.receiver];
        arguments.extend(&call.args);
        if let Some(value) = self.function_of_body(&call.method, &arguments, call) {
            return value;
        }
        if let Some(value) = self.function_of_blocks(&call.method, &arguments, call) {
            return value;
        }
        let is_quantity = self.scope.is_bound(&name) && self.scope.function(&call.method).is_none();
        if is_quantity && !builtins::is_function(&name) {
            let message = hints::no_method(&call.method, call.args.len());
            return self.reject(&call.method, message);
        }
        self.apply(&call.method, &arguments, call)
    }

    /// The name of a module, as functions have it in other languages.
    fn module(&mut self, receiver: &Expr) -> Option<Ident> {
        let name = as_name(receiver)?;
        let modules = [
            "np", "numpy", "math", "Math", "cmath", "sp", "sympy", "casadi", "ca", "jnp", "torch",
        ];
        let known = modules.iter().any(|module| name == module);
        (known && self.scope.resolve(name).is_none()).then(|| name.clone())
    }

    /// `v.map(|x| …)` of an array, component by component.
    fn map(&mut self, call: &ExprMethodCall) -> Option<Value> {
        if let Expr::Range(_) = without_parentheses(&call.receiver) {
            let message = "what is mapped has to become one quantity: write `.sum()`, `.product()` or \
                           `.collect()` behind it";
            return self.reject(&call.method, message);
        }
        let array = self.lower(&call.receiver)?;
        let Shape::Array { rows, .. } = self.shape(array) else {
            let message = "`map` goes through a range or an array: write `(0..5).map(|i| …)`";
            return self.reject(&call.receiver, message);
        };
        let components = self.each_element(array)?;
        let values = self.applied(call, components)?;
        let elements: Vec<_> = values
            .into_iter()
            .map(|value| self.as_scalar(value, &call.args))
            .collect::<Option<_>>()?;
        self.add(TypedOperation::Array { rows, elements })
    }

    /// `vector(theta)`: the members of a family as a vector, or as the rows of a matrix.
    fn family_as_vector(&mut self, call: &ExprCall, arguments: &[&Expr]) -> Option<Value> {
        let [argument] = arguments else {
            let message = "`vector` takes the name of a family: write `vector(theta)`, and `[x, y, z]` for a \
                           vector of components";
            return self.reject(call, message);
        };
        let name = as_name(without_parentheses(argument));
        let binding = name.and_then(|name| Some((name, self.scope.resolve(name)?)));
        let Some((name, Binding::Family(origin, family))) = binding else {
            // What is a vector already stays one, and what is unknown is reported as such.
            let value = self.lower(argument)?;
            return match self.shape(value) {
                Shape::Array { .. } => Some(value),
                shape @ Shape::Scalar => {
                    self.reject(argument, format!("this is {shape}, and no family"))
                }
            };
        };
        let counted = (0..family.members.len()).map(|i| vec![i]);
        if !family.members.keys().cloned().eq(counted) {
            let message = format!(
                "the members of `{name}` are not counted from 0 by one index: write which of them, as in \
                 `(1..5).map(|i| {name}[i]).collect()`"
            );
            return self.reject(argument, message);
        }
        let values: Vec<Value> = family.members.values().copied().collect();
        for value in &values {
            self.check_accelerations(name, origin, *value)?;
        }
        self.rows(values, |_| argument)
    }

    /// The number of members of a family.
    fn length_of_family(&mut self, receiver: &Expr) -> Option<i64> {
        let name = as_name(without_parentheses(receiver))?;
        match self.scope.resolve(name)? {
            Binding::Family(_, family) => i64::try_from(family.members.len()).ok(),
            Binding::Bodies(family) if family.rank > 0 => i64::try_from(family.members.len()).ok(),
            _ => None,
        }
    }

    /// An elementary function, `sqrt`, `powi`, `powf` or `recip`, or one of vectors and matrices.
    fn apply(&mut self, name: &Ident, arguments: &[&Expr], call: impl ToTokens) -> Option<Value> {
        if let Some(function) = self.scope.function(name) {
            return self.application(function, arguments, call);
        }
        let written = name.to_string();
        let mut unary = Unary::ALL.into_iter().filter(|one| one.is_written());
        let unary = unary.find(|one| one.name() == written);
        let binary = Binary::ALL.into_iter().find(|one| one.name() == written);
        let of_arrays = ArrayFunction::named(&written);
        let is_scalar = unary.is_some() || binary.is_some();
        let expected = match written.as_str() {
            "sqrt" | "recip" | "identity" => 1,
            "powi" | "row" | "column" => 2,
            _ if is_scalar => 1 + usize::from(unary.is_none()),
            // The time derivative is no method.
            "dot" if arguments.len() == 1 => {
                return self.reject(name, hints::unknown_function("dot"));
            }
            _ => match of_arrays {
                Some(function) => function.arity,
                None => return self.no_function(name),
            },
        };
        if arguments.len() != expected {
            let count = [
                "no argument",
                "one argument",
                "two arguments",
                "three arguments",
            ];
            let count = count[expected];
            let example = hints::example(&written, expected);
            return self.reject(
                call,
                format!("`{written}` takes {count}: write `{example}`"),
            );
        }
        let values = self.each(arguments.iter().copied(), Self::lower)?;
        match written.as_str() {
            "identity" => return self.identity(arguments[0]),
            "row" | "column" => {
                return self.row_or_column(&written, (values[0], arguments[0]), arguments[1]);
            }
            _ => {}
        }
        if let Some(function) = of_arrays {
            return self.array_function(function, name, (arguments, &values), &call);
        }
        let scalars: Vec<_> = values
            .into_iter()
            .zip(arguments)
            .map(|(value, argument)| self.as_scalar(value, argument))
            .collect();
        let scalars: Vec<Value> = scalars.into_iter().collect::<Option<_>>()?;
        self.check_domain(&written, unary, arguments, &scalars)?;
        match (unary, binary) {
            (Some(function), _) => self.add(TypedOperation::Unary(function, scalars[0])),
            (_, Some(function)) => {
                if function == Binary::Power {
                    self.check_range(arguments, &scalars)?;
                }
                self.add(TypedOperation::Binary(function, [scalars[0], scalars[1]]))
            }
            _ => self.power(&written, arguments, &scalars),
        }
    }

    /// Rejects a number at which a function has no value.
    fn check_domain(
        &mut self,
        name: &str,
        function: Option<Unary>,
        arguments: &[&Expr],
        values: &[Value],
    ) -> Option<()> {
        let number = self.typed.as_constant(*values.first()?);
        let number = number.map(Rational::to_f64);
        let Some(number) = number else {
            return Some(());
        };
        let value = match (function, name) {
            (Some(function), _) => function.value(number),
            (_, "sqrt") => number.sqrt(),
            _ => return Some(()),
        };
        if value.is_finite() {
            return Some(());
        }
        let message = format!("`{name}` has no finite value at {number}");
        self.reject(arguments[0], message)
    }

    /// Rejects a power of numbers that is beyond the range of numbers, before it is written out.
    fn check_range(&mut self, arguments: &[&Expr], values: &[Value]) -> Option<()> {
        let number = |x: &Value| self.typed.as_constant(*x).map(Rational::to_f64);
        let (Some(base), Some(exponent)) = (number(&values[0]), number(&values[1])) else {
            return Some(());
        };
        let power = base.abs().powf(exponent);
        let is_lost = power == 0.0 && base != 0.0;
        if power.is_infinite() && base != 0.0 || is_lost {
            let message = format!(
                "{base} to the power {exponent} is outside of the range of `f64`, from 2.2e-308 to 1.8e308: choose units in \
                 which numbers are nearer to 1"
            );
            return self.reject(arguments[1], message);
        }
        Some(())
    }

    /// A call of what is no function.
    fn no_function(&mut self, name: &Ident) -> Option<Value> {
        if self.scope.resolve(name).is_none() {
            return self.unknown_function(name);
        }
        let message = format!("`{name}` is no function: write `{name} * (…)` for a product");
        self.reject(name, message)
    }

    /// An unknown function: an error, unless it may have been declared where the parser failed.
    fn unknown_function(&mut self, name: &Ident) -> Option<Value> {
        if !self.scope.functions_complete {
            return None;
        }
        let message = match self.scope.suggest_function(name) {
            Some(meant) => format!("unknown function `{name}`: did you mean `{meant}`?"),
            None => hints::unknown_function(&name.to_string()),
        };
        self.reject(name, message)
    }

    fn power(&mut self, name: &str, arguments: &[&Expr], values: &[Value]) -> Option<Value> {
        let exponent = match name {
            "sqrt" => Rational::HALF,
            "recip" => Rational::MINUS_ONE,
            _ => match self
                .typed
                .as_constant(values[1])
                .and_then(Rational::to_integer)
            {
                Some(exponent) if i32::try_from(exponent).is_ok() => {
                    self.check_range(arguments, values)?;
                    Rational::integer(exponent)
                }
                _ => {
                    return self.reject(
                        arguments[1],
                        "the exponent of `powi` is an integer constant: write `x.powi(2)`, or `x.powf(y)` \
                         for any other exponent",
                    );
                }
            },
        };
        if exponent.is_negative() && self.vanishes(values[0]) {
            return self.reject(
                arguments[0],
                "this divisor is zero: the quotient has no value anywhere",
            );
        }
        self.add(TypedOperation::Power(values[0], exponent))
    }
}
