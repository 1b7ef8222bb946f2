//! Declarations, applications and partial derivatives of external functions.

use std::collections::BTreeMap;

use crate::algebra::external_function::{ExternalDeclaration, ExternalFunction};
use crate::{Expression, Graph, Node, Symbol};

impl Graph {
    /// Declares an external function, with the names of its arguments.
    pub fn declare_function(&mut self, name: &str, arguments: &[&str]) -> ExternalFunction {
        self.enter_function(ExternalDeclaration {
            name: name.to_owned(),
            arguments: arguments.iter().map(|name| (*name).to_owned()).collect(),
            derivatives: vec![None; arguments.len()],
            undeclared: None,
        })
    }

    /// Declares ∂f/∂xᵢ, an expression in the symbols of the arguments, before anything is differentiated.
    pub fn declare_derivative(
        &mut self,
        function: ExternalFunction,
        argument: usize,
        derivative: Expression,
    ) {
        let derivatives = &mut self.functions[function.index()].derivatives;
        if let Some(declared) = derivatives.get_mut(argument) {
            *declared = Some(derivative);
        }
    }

    /// The external functions, in the order of declaration.
    pub fn functions(&self) -> impl Iterator<Item = ExternalFunction> + use<> {
        let count = u32::try_from(self.functions.len()).unwrap_or(u32::MAX);
        (0..count).map(ExternalFunction)
    }

    /// The name of a function.
    #[must_use]
    pub fn function_name(&self, function: ExternalFunction) -> &str {
        &self.functions[function.index()].name
    }

    /// The names of the arguments of a function, in order.
    #[must_use]
    pub fn function_arguments(&self, function: ExternalFunction) -> &[String] {
        &self.functions[function.index()].arguments
    }

    /// ∂f/∂xᵢ in the symbols of the arguments, if it was declared.
    #[must_use]
    pub fn declared_derivative(
        &self,
        function: ExternalFunction,
        argument: usize,
    ) -> Option<Expression> {
        let derivatives = &self.functions[function.index()].derivatives;
        let derivative = derivatives.get(argument).copied().flatten()?;
        match self.node(derivative) {
            Node::Application(of, _) if self.undeclared(*of) == Some((function, argument)) => None,
            _ => Some(derivative),
        }
    }

    /// The function and the argument whose derivative `function` is, if it was not declared.
    #[must_use]
    pub fn undeclared(&self, function: ExternalFunction) -> Option<(ExternalFunction, usize)> {
        self.functions[function.index()].undeclared
    }

    /// f(x₁, x₂, …), of as many arguments as the function was declared with.
    pub fn apply(&mut self, function: ExternalFunction, arguments: &[Expression]) -> Expression {
        self.intern(Node::Application(function, arguments.into()))
    }

    /// ∂f/∂xᵢ at the arguments of an application.
    pub(crate) fn partial_derivative(
        &mut self,
        function: ExternalFunction,
        argument: usize,
        arguments: &[Expression],
    ) -> Expression {
        let derivative = match self.functions[function.index()].derivatives.get(argument) {
            Some(Some(declared)) => *declared,
            _ => self.undeclared_derivative(function, argument),
        };
        let values: BTreeMap<_, _> = (0..)
            .map(Symbol::Argument)
            .zip(arguments.iter().copied())
            .collect();
        self.substitute(&[derivative], &values)[0]
    }

    /// A function that stands for a derivative which was not declared, of the same arguments.
    fn undeclared_derivative(&mut self, function: ExternalFunction, argument: usize) -> Expression {
        let declaration = &self.functions[function.index()];
        let arguments = declaration.arguments.clone();
        let of = match declaration.undeclared {
            Some(_) => format!("({})", declaration.name),
            None => declaration.name.clone(),
        };
        let by = arguments.get(argument).map_or("", String::as_str);
        let derivative = self.enter_function(ExternalDeclaration {
            name: format!("∂{of}/∂{by}"),
            derivatives: vec![None; arguments.len()],
            arguments,
            undeclared: Some((function, argument)),
        });
        let count = self.functions[function.index()].arguments.len();
        let arguments: Vec<_> = (0..)
            .take(count)
            .map(|position| self.symbol(Symbol::Argument(position)))
            .collect();
        let applied = self.apply(derivative, &arguments);
        self.declare_derivative(function, argument, applied);
        applied
    }

    fn enter_function(&mut self, declaration: ExternalDeclaration) -> ExternalFunction {
        self.functions.push(declaration);
        // Four billion functions do not fit into a source file.
        ExternalFunction(u32::try_from(self.functions.len() - 1).unwrap_or(u32::MAX))
    }
}
