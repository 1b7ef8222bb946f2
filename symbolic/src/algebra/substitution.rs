//! Simultaneous substitution of expressions for symbols.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Symbol};

impl Graph {
    /// The roots with `values` substituted for symbols, simultaneously.
    pub fn substitute(
        &mut self,
        roots: &[Expression],
        values: &BTreeMap<Symbol, Expression>,
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
        values: &BTreeMap<Symbol, Expression>,
    ) -> Expression {
        let of = |operand: Expression| results[operand.index()];
        match *self.node(expression) {
            Node::Constant(_) | Node::Pi => expression,
            Node::Symbol(symbol) => values.get(&symbol).copied().unwrap_or(expression),
            Node::Sum(ref terms) => {
                let terms: Vec<_> = terms.iter().map(|(x, c)| (of(*x), c.clone())).collect();
                self.sum(terms)
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
}
