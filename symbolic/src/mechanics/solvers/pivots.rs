//! The pivots through which q̈ is solved for, and the magnitudes that they are compared with: a running bound of their
//! rounding errors (Higham, Accuracy and Stability of Numerical Algorithms, 2nd edition 2002, section 3.3).

use crate::{Binary, Expression, Graph, Ldlt, Node, Rational, Symbol, Unary};

/// What some accelerations are divided by.
#[derive(Clone, Debug)]
pub struct Pivot {
    /// The divisor.
    pub value: Expression,
    /// The coordinates that are solved for with it.
    pub coordinates: Vec<usize>,
}

impl Ldlt {
    /// The pivots, each with its coordinate.
    pub(crate) fn divisors(&self) -> Vec<Pivot> {
        let pivots = self.pivots.iter().enumerate();
        let pivots = pivots.map(|(coordinate, value)| Pivot {
            value: *value,
            coordinates: vec![coordinate],
        });
        pivots.collect()
    }
}

impl Pivot {
    /// The sum of the magnitudes of its terms and of qⱼ ∂D/∂qⱼ, to which its rounding error is proportional. An angle
    /// counts as 1 radian at most, since full turns do not matter; `angles` says which coordinates are angles.
    pub fn magnitude(&self, graph: &mut Graph, angles: &[bool]) -> Expression {
        let mut pivot = self.value;
        while let Node::Opaque(operand) = graph.node(pivot) {
            pivot = *operand;
        }
        let terms = graph.terms(pivot).into_iter();
        let mut magnitudes: Vec<_> = terms
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
}
