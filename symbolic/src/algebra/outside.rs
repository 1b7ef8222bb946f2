//! Functions from outside, such as tables: known by their names and their derivatives alone.
//!
//! A function is declared first and its derivatives afterwards, as expressions in its
//! [arguments](Symbol::Argument), so that functions can be each other's derivatives. The set of functions
//! is closed under differentiation: a derivative that is not declared is one more function of the same
//! arguments, and whether anything needs it is seen in the programs that apply it.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Symbol};

/// A handle to a function from outside of one [`Graph`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Function(u32);

impl Function {
    /// The position in the order of declaration.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// What is known of a function from outside.
#[derive(Clone, Debug)]
pub(crate) struct Outside {
    name: String,
    arguments: Vec<String>,
    /// By argument, in the symbols of the arguments.
    derivatives: Vec<Option<Expression>>,
    /// The function and the argument whose derivative this is, if it was not declared.
    undeclared: Option<(Function, usize)>,
}

impl Graph {
    /// A function from outside, with the names of its arguments.
    pub fn declare_function(&mut self, name: &str, arguments: &[&str]) -> Function {
        self.enter_function(Outside {
            name: name.to_owned(),
            arguments: arguments.iter().map(|name| (*name).to_owned()).collect(),
            derivatives: vec![None; arguments.len()],
            undeclared: None,
        })
    }

    /// Declares ∂f/∂xᵢ, an expression in the symbols of the arguments, before anything is differentiated.
    pub fn declare_derivative(
        &mut self,
        function: Function,
        argument: usize,
        derivative: Expression,
    ) {
        let derivatives = &mut self.functions[function.index()].derivatives;
        if let Some(declared) = derivatives.get_mut(argument) {
            *declared = Some(derivative);
        }
    }

    /// The functions from outside, in the order in which they were declared.
    pub fn functions(&self) -> impl Iterator<Item = Function> + use<> {
        let count = u32::try_from(self.functions.len()).unwrap_or(u32::MAX);
        (0..count).map(Function)
    }

    /// What a function is called.
    #[must_use]
    pub fn function_name(&self, function: Function) -> &str {
        &self.functions[function.index()].name
    }

    /// What the arguments of a function are called, in order.
    #[must_use]
    pub fn function_arguments(&self, function: Function) -> &[String] {
        &self.functions[function.index()].arguments
    }

    /// ∂f/∂xᵢ in the symbols of the arguments, if it was declared.
    #[must_use]
    pub fn declared_derivative(&self, function: Function, argument: usize) -> Option<Expression> {
        let derivatives = &self.functions[function.index()].derivatives;
        let derivative = derivatives.get(argument).copied().flatten()?;
        match self.node(derivative) {
            Node::Application(of, _) if self.undeclared(*of) == Some((function, argument)) => None,
            _ => Some(derivative),
        }
    }

    /// The function and the argument whose derivative `function` is, if it was not declared.
    #[must_use]
    pub fn undeclared(&self, function: Function) -> Option<(Function, usize)> {
        self.functions[function.index()].undeclared
    }

    /// f(x₁, x₂, …), of as many arguments as the function was declared with.
    pub fn apply(&mut self, function: Function, arguments: &[Expression]) -> Expression {
        self.intern(Node::Application(function, arguments.into()))
    }

    /// ∂f/∂xᵢ at the arguments of an application.
    pub(crate) fn slope(
        &mut self,
        function: Function,
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
    fn undeclared_derivative(&mut self, function: Function, argument: usize) -> Expression {
        let outside = &self.functions[function.index()];
        let arguments = outside.arguments.clone();
        let of = match outside.undeclared {
            Some(_) => format!("({})", outside.name),
            None => outside.name.clone(),
        };
        let by = arguments.get(argument).map_or("", String::as_str);
        let derivative = self.enter_function(Outside {
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

    fn enter_function(&mut self, outside: Outside) -> Function {
        self.functions.push(outside);
        // Four billion functions do not fit into a source file.
        Function(u32::try_from(self.functions.len() - 1).unwrap_or(u32::MAX))
    }
}
