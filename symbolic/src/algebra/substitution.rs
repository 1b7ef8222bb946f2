//! Simultaneous substitution of expressions for symbols, and expressions of other graphs.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Rational, Symbol};

impl Graph {
    /// The roots with `values` substituted for symbols, simultaneously.
    pub fn substitute(
        &mut self,
        roots: &[Expression],
        values: &BTreeMap<Symbol, Expression>,
    ) -> Vec<Expression> {
        let known = values
            .iter()
            .map(|(symbol, value)| (self.symbol(*symbol), *value));
        let known = known.collect();
        self.replace(roots, &known)
    }

    /// Expressions where these symbols are zero.
    pub(crate) fn at_zero(
        &mut self,
        expressions: &[Expression],
        symbols: &[Symbol],
    ) -> Vec<Expression> {
        let zeros = symbols.iter().map(|symbol| (*symbol, self.zero()));
        let zeros = zeros.collect();
        self.substitute(expressions, &zeros)
    }

    /// The roots with `values` in place of expressions that are keys, simultaneously.
    pub(crate) fn replace(
        &mut self,
        roots: &[Expression],
        values: &BTreeMap<Expression, Expression>,
    ) -> Vec<Expression> {
        let descendants = self.descendants(roots);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        let mut results = vec![self.zero(); length];
        for expression in descendants {
            results[expression.index()] = self.substituted(expression, &results, values);
        }
        roots.iter().map(|root| results[root.index()]).collect()
    }

    fn substituted(
        &mut self,
        expression: Expression,
        results: &[Expression],
        values: &BTreeMap<Expression, Expression>,
    ) -> Expression {
        if let Some(value) = values.get(&expression) {
            return *value;
        }
        let of = |operand: Expression| results[operand.index()];
        match *self.node(expression) {
            Node::Constant(_) | Node::Pi | Node::Symbol(_) => expression,
            Node::Sum(ref terms) => {
                let terms: Vec<_> = terms.iter().map(|(x, c)| (of(*x), c.clone())).collect();
                let sum = self.sum(terms);
                if self.squared_distances.contains(&expression) {
                    self.note_squared_distance(sum);
                }
                sum
            }
            Node::Product(ref factors) => {
                let factors: Vec<_> = factors.iter().map(|(x, k)| (of(*x), k.clone())).collect();
                self.product(factors)
            }
            Node::Unary(function, x) => self.unary(function, of(x)),
            Node::Binary(function, x, y) => self.binary(function, of(x), of(y)),
            Node::Application(function, ref arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|x| of(*x)).collect();
                self.apply(function, &arguments)
            }
            Node::Opaque(x) => self.opaque(of(x)),
        }
    }

    /// The roots of another graph in this one: symbols and external functions of the same numbers are the same.
    pub fn imported(&mut self, from: &Self, roots: &[Expression]) -> Vec<Expression> {
        let descendants = from.descendants(roots);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        let mut copies = vec![self.zero(); length];
        for expression in descendants {
            let of = |operand: Expression| copies[operand.index()];
            let parts = |parts: &[(Expression, Rational)]| {
                let copied = parts.iter().map(|(x, c)| (of(*x), c.clone()));
                copied.collect::<Vec<_>>()
            };
            copies[expression.index()] = match from.node(expression) {
                Node::Constant(value) => self.constant(value),
                Node::Pi => self.pi(),
                Node::Symbol(symbol) => self.symbol(*symbol),
                Node::Sum(terms) => {
                    let sum = self.sum(parts(terms));
                    if from.squared_distances.contains(&expression) {
                        self.note_squared_distance(sum);
                    }
                    sum
                }
                Node::Product(factors) => self.product(parts(factors)),
                Node::Unary(function, x) => self.unary(*function, of(*x)),
                Node::Binary(function, x, y) => self.binary(*function, of(*x), of(*y)),
                Node::Application(function, arguments) => {
                    let arguments: Vec<_> = arguments.iter().map(|x| of(*x)).collect();
                    self.apply(*function, &arguments)
                }
                Node::Opaque(x) => self.opaque(of(*x)),
            };
        }
        roots.iter().map(|root| copies[root.index()]).collect()
    }
}
