//! Models as a declaration writes them: shorthands that read as formulas.

use lagrangian_symbolic::{Energies, Expression, Graph, Model, Rational, Symbol, Unary};

/// A model under construction: the graph, and shorthands that read as formulas.
pub(crate) struct Draft {
    pub(crate) graph: Graph,
    pub(crate) coordinates: u32,
}

impl Draft {
    pub(crate) fn new(coordinates: u32) -> Self {
        Self {
            graph: Graph::new(),
            coordinates,
        }
    }

    pub(crate) fn q(&mut self, i: u32) -> Expression {
        self.graph.symbol(Symbol::Coordinate(i))
    }

    pub(crate) fn v(&mut self, i: u32) -> Expression {
        self.graph.symbol(Symbol::Velocity(i))
    }

    pub(crate) fn parameter(&mut self, i: u32) -> Expression {
        self.graph.symbol(Symbol::Parameter(i))
    }

    pub(crate) fn sin(&mut self, x: Expression) -> Expression {
        self.graph.unary(Unary::Sin, x)
    }

    pub(crate) fn cos(&mut self, x: Expression) -> Expression {
        self.graph.unary(Unary::Cos, x)
    }

    pub(crate) fn times(&mut self, factors: &[Expression]) -> Expression {
        self.graph
            .product(factors.iter().map(|x| (*x, Rational::ONE)))
    }

    pub(crate) fn plus(&mut self, terms: &[Expression]) -> Expression {
        self.graph.sum(terms.iter().map(|x| (*x, Rational::ONE)))
    }

    pub(crate) fn half(&mut self, x: Expression) -> Expression {
        self.graph.scale(x, &Rational::HALF)
    }

    pub(crate) fn square(&mut self, x: Expression) -> Expression {
        self.graph.square(x)
    }

    pub(crate) fn dot(&mut self, x: Expression) -> Expression {
        self.graph.time_derivatives(&[x], self.coordinates)[0]
    }

    pub(crate) fn model(self, energies: Energies) -> Model {
        let zero = self.graph.zero();
        Model {
            coordinates: self.coordinates,
            inputs: 1,
            energies,
            dissipation: zero,
            forces: vec![zero; self.coordinates as usize],
            outputs: Vec::new(),
            graph: self.graph,
        }
    }

    pub(crate) fn natural(self, kinetic: Expression, potential: Expression) -> Model {
        self.model(Energies::Natural { kinetic, potential })
    }
}

/// Values for a few symbols, the same on every run.
pub(crate) fn value(symbol: Symbol) -> f64 {
    match symbol {
        Symbol::Time => 0.3,
        Symbol::Coordinate(i) => 0.7 + 0.4 * f64::from(i),
        Symbol::Velocity(i) => 1.1 - 0.6 * f64::from(i),
        Symbol::Acceleration(i) => -0.5 + 0.9 * f64::from(i),
        Symbol::Parameter(i) => 1.3 + 0.5 * f64::from(i),
        Symbol::Input(_) | Symbol::Invariant(_) | Symbol::Argument(_) => 0.2,
    }
}

#[track_caller]
pub(crate) fn assert_close(found: f64, expected: f64) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error < 1e-13, "{found} is not {expected}: {error:e}");
}
