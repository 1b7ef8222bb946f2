//! The magnitudes that pivots are compared with: a running bound of their rounding errors (Higham, Accuracy and
//! Stability of Numerical Algorithms, 2nd edition 2002, section 3.3).

use crate::{Binary, Expression, Graph, Ldlt, Node, Rational, Symbol, Unary};

impl Ldlt {
    /// For each pivot Dᵢ, the sum of the magnitudes of its terms and of qⱼ ∂Dᵢ/∂qⱼ, to which its rounding error is
    /// proportional. An angle counts as 1 radian at most, since full turns do not matter;
    /// `angles` says which coordinates are angles.
    pub fn magnitudes(&self, graph: &mut Graph, angles: &[bool]) -> Vec<Expression> {
        let pivots = self.pivots.iter();
        pivots
            .map(|pivot| magnitude(graph, *pivot, angles))
            .collect()
    }
}

/// Σ |terms of D| + Σⱼ |qⱼ ∂D/∂qⱼ|.
fn magnitude(graph: &mut Graph, pivot: Expression, angles: &[bool]) -> Expression {
    let terms = match graph.node(pivot) {
        Node::Sum(terms) => terms.to_vec(),
        _ => vec![(pivot, Rational::ONE)],
    };
    let mut magnitudes: Vec<_> = terms
        .into_iter()
        .map(|(x, c)| (graph.unary(Unary::Abs, x), c.abs()))
        .collect();
    for (symbol, is_angle) in (0..).map(Symbol::Coordinate).zip(angles) {
        let slope = graph.derivative(pivot, symbol);
        let coordinate = graph.symbol(symbol);
        let [slope, mut size] = [slope, coordinate].map(|x| graph.unary(Unary::Abs, x));
        if *is_angle {
            let one = graph.one();
            size = graph.binary(Binary::Min, size, one);
        }
        magnitudes.push((graph.multiply(size, slope), Rational::ONE));
    }
    graph.sum(magnitudes)
}
