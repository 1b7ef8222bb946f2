//! Derivatives, forward through the arena.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Node, Rational, Symbol};

/// The direction of a derivative: for each symbol its own derivative, 0 for those not named.
pub type Direction = BTreeMap<Symbol, Expression>;

impl Graph {
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
            derivatives[expression.index()] = self.chain_rule(expression, &derivatives, direction);
        }
        roots.iter().map(|root| derivatives[root.index()]).collect()
    }

    /// The derivative of one expression from those of its operands.
    fn chain_rule(
        &mut self,
        expression: Expression,
        derivatives: &[Expression],
        direction: &Direction,
    ) -> Expression {
        let zero = self.zero();
        let of = |operand: Expression| derivatives[operand.index()];
        let mut constant = true;
        self.node(expression)
            .for_each_operand(|operand| constant &= of(operand) == zero);
        match *self.node(expression) {
            Node::Constant(_) | Node::Pi => zero,
            Node::Symbol(symbol) => direction.get(&symbol).copied().unwrap_or(zero),
            _ if constant => zero,
            Node::Sum(ref terms) => {
                let terms: Vec<_> = terms.iter().map(|(x, c)| (of(*x), c.clone())).collect();
                self.sum(terms)
            }
            Node::Product(ref factors) => {
                let factors = factors.clone();
                self.product_rule(&factors, of)
            }
            Node::Unary(function, x) => {
                let slope = function.derivative(self, x);
                self.multiply(slope, of(x))
            }
            Node::Whole(x) => of(x),
            Node::Binary(function, x, y) => {
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
            let mut parts = factors.to_vec();
            parts[position].1 = exponent - &Rational::ONE;
            parts.push((change, Rational::ONE));
            terms.push((self.product(parts), exponent.clone()));
        }
        self.sum(terms)
    }
}
