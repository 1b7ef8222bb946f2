//! Checkpoints of a graph: what is tried out in it can be taken back.

use std::collections::BTreeSet;

use crate::algebra::derivative_memory::DerivativeMemory;
use crate::algebra::external_function::ExternalDeclaration;
use crate::algebra::growth::KnownScales;
use crate::algebra::split::KnownSplits;
use crate::{Expression, Graph};

/// What a graph was at some time.
pub(crate) struct Checkpoint {
    length: usize,
    functions: Vec<ExternalDeclaration>,
    squared_distances: BTreeSet<Expression>,
    /// Whether there was a hyperbolic and an exponential function.
    has_functions: [bool; 2],
}

impl Graph {
    /// The state to which [`Self::roll_back`] returns.
    pub(crate) fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            length: self.len(),
            functions: self.functions.clone(),
            squared_distances: self.squared_distances.clone(),
            has_functions: [self.has_hyperbolic, self.has_exponential],
        }
    }

    /// Removes the expressions that were added since a checkpoint; their handles name others from then on.
    pub(crate) fn roll_back(&mut self, checkpoint: Checkpoint) {
        self.nodes.truncate(checkpoint.length);
        self.contents.truncate(checkpoint.length);
        self.symbol_bits.truncate(checkpoint.length);
        self.functions = checkpoint.functions;
        self.squared_distances = checkpoint.squared_distances;
        [self.has_hyperbolic, self.has_exponential] = checkpoint.has_functions;
        // Caches may name what is removed.
        self.splits = KnownSplits::default();
        self.scales = KnownScales::default();
        self.swollen = BTreeSet::new();
        self.derivatives = DerivativeMemory::default();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Binary, ExternalFunction, Rational, Symbol, Unary};

    /// A graph with three coordinates and an external function.
    fn beginning() -> (Graph, [Expression; 3], ExternalFunction) {
        let mut graph = Graph::new();
        let coordinates = [0, 1, 2].map(|i| graph.symbol(Symbol::Coordinate(i)));
        let function = graph.declare_function("f", &["x"]);
        (graph, coordinates, function)
    }

    /// Fills every cache and sets every flag; the number of monomials of (1 + x + y + z + a + b + c)ⁿ, if it is not too large.
    fn work(
        graph: &mut Graph,
        [x, y, z]: [Expression; 3],
        function: ExternalFunction,
        power: i64,
    ) -> Option<usize> {
        let mut terms = vec![graph.one(), x, y, z];
        terms.extend([0, 1, 2].map(|i| graph.symbol(Symbol::Parameter(i))));
        let sum = graph.sum(terms.into_iter().map(|x| (x, Rational::ONE)));
        let raised = graph.power(sum, &Rational::integer(power));
        let growing = graph.unary(Unary::Exp, x);
        let growing = graph.multiply(y, growing);
        let sum = graph.add(z, growing);
        assert!(graph.scaled(sum).is_some());
        graph.unary(Unary::Cosh, z);
        let factors = [y, z].map(|other| graph.multiply(x, other));
        let sum = graph.add(factors[0], factors[1]);
        assert!(graph.split(sum).is_some());
        let angle = graph.binary(Binary::Atan2, x, y);
        graph.derivative(angle, Symbol::Coordinate(0));
        let moved = graph.add(x, y);
        let applied = graph.apply(function, &[moved]);
        graph.time_derivatives(&[applied], 3);
        graph.monomials(raised).map(|terms| terms.len())
    }

    fn assert_equal(graph: &Graph, other: &Graph) {
        assert!(graph.nodes().eq(other.nodes()));
        let contents = [graph, other].map(|graph| format!("{:?}", graph.contents));
        assert_eq!(contents[0], contents[1]);
        assert_eq!(graph.symbol_bits, other.symbol_bits);
        let functions = [graph, other].map(|graph| format!("{:?}", graph.functions));
        assert_eq!(functions[0], functions[1]);
        assert_eq!(graph.squared_distances, other.squared_distances);
        let flags = |graph: &Graph| [graph.has_hyperbolic, graph.has_exponential];
        assert_eq!(flags(graph), flags(other));
    }

    #[test]
    fn what_is_rolled_back_leaves_no_trace() {
        let (mut graph, [x, y, z], function) = beginning();
        let checkpoint = graph.checkpoint();
        assert_eq!(work(&mut graph, [x, y, z], function, 4), None);
        graph.declare_function("g", &[]);
        graph.roll_back(checkpoint);
        let (mut other, ..) = beginning();
        assert_equal(&graph, &other);

        // The handles of what was removed now name other expressions.
        for graph in [&mut graph, &mut other] {
            assert_eq!(work(graph, [y, z, x], function, 2), Some(28));
        }
        assert_equal(&graph, &other);
    }
}
