//! Solutions by each solver, and whether they hold.

use crate::identity::residue;
use crate::mechanics::solvers::solution::Solver;
use crate::{
    Equations, Expression, Graph, Kinetics, Model, ModularPoint, Node, Rational, Solution,
};

impl Kinetics {
    /// The accelerations by each solver that applies, to compare them.
    pub fn solutions(model: &mut Model, equations: &Equations) -> Vec<Solution> {
        let (_, solvers) = Self::with_solvers(model, equations);
        let solvers = solvers.into_iter();
        solvers
            .map(|solver| Solution::by(&mut model.graph, solver))
            .collect()
    }
}

impl Solution {
    /// How M x = r is solved, in words.
    #[must_use]
    pub const fn method(&self) -> &'static str {
        match self.solver() {
            Solver::BoltzmannHamel(_) => "quasi-velocities",
            Solver::ArticulatedBodies(_) => "articulated bodies",
            Solver::ArticulatedLinks(_) => "articulated links",
            Solver::Ldlt(..) => "factors of M",
        }
    }

    /// Whether the accelerations solve M q̈ = f, as far as a random point in modular arithmetic tells;
    /// true where there is none, and where roots other than square roots have relations unknown there.
    #[must_use]
    pub fn holds(&self, graph: &Graph, equations: &Equations) -> bool {
        let mut roots = self.accelerations.clone();
        roots.extend(&equations.forcing);
        roots.extend(equations.mass.concat());
        if has_higher_roots(graph, &roots) {
            return true;
        }
        let size = self.accelerations.len();
        let mut found = ModularPoint::attempts()
            .filter_map(|point| Some((point, point.evaluate(graph, &roots)?)));
        found.next().is_none_or(|(point, values)| {
            let (accelerations, rest) = values.split_at(size);
            let (forcing, mass) = rest.split_at(size);
            mass.chunks(size).zip(forcing).all(|(row, force)| {
                let products = row.iter().zip(accelerations);
                let terms = products.map(|(x, y)| residue::multiply(*x, *y, point.p()));
                terms.fold(0, |sum, term| residue::add(sum, term, point.p())) == *force
            })
        })
    }
}

fn has_higher_roots(graph: &Graph, roots: &[Expression]) -> bool {
    let higher = |exponent: &Rational| !(exponent * &Rational::integer(2)).is_integer();
    let expressions = graph.descendants(roots);
    expressions
        .into_iter()
        .any(|expression| match graph.node(expression) {
            Node::Product(factors) => factors.iter().any(|(_, exponent)| higher(exponent)),
            _ => false,
        })
}
