//! Derivatives, forward through the arena.
//!
//! Only what contains a symbol is looked at when it is differentiated with respect to it.

use std::collections::BTreeMap;

use crate::algebra::dependence::Dependence;
use crate::{Expression, Graph, Node, Rational, Symbol};

/// The direction of a derivative: for each symbol its own derivative, 0 for those not named.
pub type Direction = BTreeMap<Symbol, Expression>;

impl Graph {
    /// The derivatives ∂rootᵢ/∂symbolⱼ, as one list over i for each j.
    pub fn jacobian(&mut self, roots: &[Expression], symbols: &[Symbol]) -> Vec<Vec<Expression>> {
        let mut tangents = Tangents::new(self, roots, symbols);
        (0..symbols.len())
            .map(|position| tangents.column(self, roots, position))
            .collect()
    }

    /// The derivatives ∂rootᵢ/∂symbol.
    pub fn derivatives(&mut self, roots: &[Expression], symbol: Symbol) -> Vec<Expression> {
        let direction = Direction::from([(symbol, self.one())]);
        self.directional_derivatives(roots, &direction)
    }

    /// The derivative ∂root/∂symbol.
    pub fn derivative(&mut self, root: Expression, symbol: Symbol) -> Expression {
        self.derivatives(&[root], symbol)[0]
    }

    /// The derivatives Σ ∂rootᵢ/∂s · ds over all symbols s of the direction.
    pub fn directional_derivatives(
        &mut self,
        roots: &[Expression],
        direction: &Direction,
    ) -> Vec<Expression> {
        let zero = self.zero();
        let descendants = self.descendants(roots);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        let mut derivatives = vec![zero; length];
        for expression in descendants {
            derivatives[expression.index()] = match self.node(expression) {
                Node::Symbol(symbol) => direction.get(symbol).copied().unwrap_or(zero),
                _ => self.chain_rule(expression, &derivatives),
            };
        }
        roots.iter().map(|root| derivatives[root.index()]).collect()
    }

    /// The derivative of what is no symbol from those of its operands.
    fn chain_rule(&mut self, expression: Expression, derivatives: &[Expression]) -> Expression {
        let zero = self.zero();
        let of = |operand: Expression| derivatives[operand.index()];
        match *self.node(expression) {
            Node::Constant(_) | Node::Pi | Node::Symbol(_) => zero,
            Node::Sum(ref terms) => {
                let mut changes = Vec::new();
                for (x, c) in terms {
                    let change = of(*x);
                    if change != zero {
                        changes.push((change, c.clone()));
                    }
                }
                self.sum(changes)
            }
            Node::Product(ref factors) => {
                let constant = factors.iter().all(|(x, _)| of(*x) == zero);
                if constant {
                    return zero;
                }
                let factors = factors.clone();
                self.product_rule(&factors, of)
            }
            Node::Unary(function, x) => {
                if of(x) == zero {
                    return zero;
                }
                let slope = function.derivative(self, x);
                self.multiply(slope, of(x))
            }
            Node::Whole(x) => of(x),
            Node::Binary(function, x, y) => {
                if of(x) == zero && of(y) == zero {
                    return zero;
                }
                let [over_x, over_y] = function.derivatives(self, x, y);
                let along_x = self.multiply(over_x, of(x));
                let along_y = self.multiply(over_y, of(y));
                self.add(along_x, along_y)
            }
        }
    }

    /// d Π xᵢ^kᵢ = Σⱼ kⱼ dxⱼ xⱼ^(kⱼ−1) Π_{i≠j} xᵢ^kᵢ, which divides by nothing.
    fn product_rule(
        &mut self,
        factors: &[(Expression, Rational)],
        derivative: impl Fn(Expression) -> Expression,
    ) -> Expression {
        let mut terms = Vec::new();
        for (position, (base, exponent)) in factors.iter().enumerate() {
            let change = derivative(*base);
            if self.is_zero(change) {
                continue;
            }
            // The other factors are in normal form already.
            let mut others = Vec::with_capacity(factors.len() + 1);
            others.extend_from_slice(&factors[..position]);
            others.extend_from_slice(&factors[position + 1..]);
            let power = (*base, exponent - &Rational::ONE);
            let product = self.multiply_factors(others, vec![power, (change, Rational::ONE)]);
            terms.push((product, exponent.clone()));
        }
        self.sum(terms)
    }
}

/// Derivatives of the same expressions with respect to one symbol after the other.
pub(crate) struct Tangents {
    symbols: Vec<Symbol>,
    dependence: Dependence,
    /// By expression, with respect to the symbol that is looked at; between two of them all 0.
    derivatives: Vec<Expression>,
}

impl Tangents {
    /// What is needed to differentiate `roots` with respect to each of `symbols`.
    pub(crate) fn new(graph: &Graph, roots: &[Expression], symbols: &[Symbol]) -> Self {
        let length = roots.iter().map(|root| root.index() + 1).max().unwrap_or(0);
        Self {
            symbols: symbols.to_vec(),
            dependence: Dependence::of(graph, roots, symbols),
            derivatives: vec![graph.zero(); length],
        }
    }

    /// The derivatives of all roots with respect to the symbol at `position`.
    pub(crate) fn column(
        &mut self,
        graph: &mut Graph,
        roots: &[Expression],
        position: usize,
    ) -> Vec<Expression> {
        let dependents = self.dependence.on(position);
        let symbol = self.symbols[position];
        forward(graph, &mut self.derivatives, dependents, symbol, roots)
    }

    /// The derivatives of some of the roots with respect to the symbol at `position`.
    pub(crate) fn part_of_column(
        &mut self,
        graph: &mut Graph,
        roots: &[Expression],
        position: usize,
    ) -> Vec<Expression> {
        let dependents = self.dependence.within(graph, roots, position);
        let symbol = self.symbols[position];
        forward(graph, &mut self.derivatives, &dependents, symbol, roots)
    }
}

/// The derivatives of `roots` with respect to the only symbol among `dependents`, in which all that
/// contains it stands. Leaves `derivatives` as they were: 0.
fn forward(
    graph: &mut Graph,
    derivatives: &mut [Expression],
    dependents: &[Expression],
    symbol: Symbol,
    roots: &[Expression],
) -> Vec<Expression> {
    for expression in dependents {
        derivatives[expression.index()] = match graph.node(*expression) {
            Node::Symbol(found) if *found == symbol => graph.one(),
            _ => graph.chain_rule(*expression, derivatives),
        };
    }
    let results = roots.iter().map(|root| derivatives[root.index()]).collect();
    for expression in dependents {
        derivatives[expression.index()] = graph.zero();
    }
    results
}
