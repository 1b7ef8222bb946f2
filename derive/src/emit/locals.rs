//! The names of local variables in the emitted code.

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::{Expression, Graph, Node, Symbol, Unary};
use proc_macro2::{Ident, Span};

use crate::lower::quantities::Quantities;
use crate::lower::scope::Scope;
use crate::plan::PARAMETERS;

/// The names of variables where Taylor coefficients are computed.
const SERIES: [&str; 9] = [
    "unit",
    "coefficients",
    "memory",
    "invariants",
    "term",
    "convolutions",
    "series_of_inputs",
    "higher_inputs",
    "term_of_inputs",
];

/// Gives every local variable of one method a name of its own.
pub(crate) struct Locals<'a> {
    graph: &'a Graph,
    /// The names of variables for what the declaration has a name for.
    definitions: BTreeMap<Expression, String>,
    /// By expression, whether the declaration has a name for it: this is asked of every instruction.
    is_named: Vec<bool>,
    quantities: &'a Quantities,
    /// The names of a function's arguments, in one of its derivatives.
    arguments: Vec<String>,
    taken: BTreeSet<String>,
    counter: usize,
}

impl<'a> Locals<'a> {
    pub(crate) fn new(graph: &'a Graph, scope: &Scope, quantities: &'a Quantities) -> Self {
        let taken = PARAMETERS
            .into_iter()
            .chain(["self", "factors", "multipliers"])
            .chain(SERIES);
        let mut definitions = BTreeMap::new();
        let mut is_named = vec![false; graph.len()];
        for (label, expression) in scope.definitions(graph) {
            is_named[expression.index()] = true;
            // Of several names for one expression the first stands for it.
            definitions
                .entry(expression)
                .or_insert_with(|| label.variable());
        }
        Self {
            graph,
            definitions,
            is_named,
            quantities,
            arguments: Vec::new(),
            taken: taken.map(str::to_owned).collect(),
            counter: 0,
        }
    }

    /// The same in a derivative of a function whose arguments have these names.
    pub(crate) fn with_arguments(mut self, names: impl IntoIterator<Item = String>) -> Self {
        self.arguments.extend(names);
        self
    }

    /// The variable that holds a symbol.
    pub(crate) fn symbol(&mut self, symbol: Symbol) -> Ident {
        let argument = match symbol {
            Symbol::Argument(i) => self.arguments.get(i as usize).cloned(),
            _ => None,
        };
        let name = argument.unwrap_or_else(|| self.quantities.variable(symbol));
        self.unique(name)
    }

    /// The variable that holds the value of an expression: named by its definition, or by what it is.
    pub(crate) fn value(&mut self, expression: Option<Expression>) -> Ident {
        match expression.and_then(|expression| self.describe(expression)) {
            Some(name) => self.unique(name),
            None => self.numbered(),
        }
    }

    /// The variables that hold the sine and the cosine of one argument.
    pub(crate) fn pair(&mut self, either: Option<Expression>) -> (Ident, Ident) {
        match either.and_then(|either| self.describe(either)) {
            Some(name) if name.starts_with("sin_") => {
                let cosine = name.replacen("sin_", "cos_", 1);
                (self.unique(name), self.unique(cosine))
            }
            Some(name) if name.starts_with("cos_") => {
                let sine = name.replacen("cos_", "sin_", 1);
                (self.unique(sine), self.unique(name))
            }
            _ => (self.numbered(), self.numbered()),
        }
    }

    /// Whether the declaration has a name for an expression.
    pub(crate) fn is_defined(&self, expression: Option<Expression>) -> bool {
        expression.is_some_and(|expression| self.is_named(expression))
    }

    fn is_named(&self, expression: Expression) -> bool {
        self.is_named.get(expression.index()) == Some(&true)
    }

    fn describe(&self, expression: Expression) -> Option<String> {
        if self.is_named(expression) {
            return self.definitions.get(&expression).cloned();
        }
        match self.graph.node(expression) {
            Node::Unary(function @ (Unary::Sin | Unary::Cos), x) => match self.graph.node(*x) {
                Node::Symbol(symbol) => Some(format!(
                    "{}_{}",
                    function.name(),
                    self.quantities.variable(*symbol)
                )),
                _ => None,
            },
            _ => None,
        }
    }

    fn numbered(&mut self) -> Ident {
        let name = format!("x{}", self.counter);
        self.counter += 1;
        if self.taken.contains(&name) {
            return self.free(name);
        }
        Ident::new(&name, Span::mixed_site())
    }

    /// Whether a name is that of a variable with a number. Those are most, so that they are not listed.
    fn is_numbered(&self, name: &str) -> bool {
        let number = name
            .strip_prefix('x')
            .and_then(|number| number.parse().ok());
        number.is_some_and(|number: usize| number < self.counter && name == format!("x{number}"))
    }

    /// `name`, or the next free one after it. A local variable is hygienic: it never meets a variable of the user's. A
    /// constant or a unit struct of the same name would make a pattern of it, and those are written in capitals.
    fn unique(&mut self, name: String) -> Ident {
        let mut name = if name.is_ascii() {
            name.to_ascii_lowercase()
        } else {
            name
        };
        // No keyword has a digit: most names need not be parsed, which takes long without optimization.
        let has_digit = name.is_ascii() && name.bytes().any(|byte| byte.is_ascii_digit());
        while !has_digit && syn::parse_str::<Ident>(&name).is_err() {
            name.push('_');
        }
        self.free(name)
    }

    /// `name`, which is no keyword, or the next free one after it.
    pub(crate) fn free(&mut self, mut name: String) -> Ident {
        while self.taken.contains(&name) || self.is_numbered(&name) {
            name.push('_');
        }
        let ident = Ident::new(&name, Span::mixed_site());
        self.taken.insert(name);
        ident
    }
}
