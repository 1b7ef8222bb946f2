//! The accelerations in the cheapest way that a declaration allows.
//!
//! Several ways lead from energies to q̈: through as many quasi-velocities as there are coordinates, along
//! the tree that quasi-velocities form, or by elimination of the mass matrix. All are written down, and the
//! one that costs least by the [cost model](crate::program::cost) is taken. M is differentiated through
//! the same factors.

use crate::decision::point::Point;
use crate::decision::residue;
use crate::mechanics::articulation::Articulation;
use crate::mechanics::boltzmann_hamel::BoltzmannHamel;
use crate::mechanics::elimination::Elimination;
use crate::{Equations, Expression, Graph, Node, Program, Rational, Symbol};

/// The accelerations q̈ as expressions.
pub struct Solution {
    /// The accelerations hold where all of these are positive; where one is not, M is to be factored
    /// with exchange of rows. Empty if they hold wherever M is regular.
    pub pivots: Vec<Expression>,
    /// The accelerations q̈.
    pub accelerations: Vec<Expression>,
    way: Way,
}

/// How M x = r is solved.
pub(crate) enum Way {
    QuasiVelocities(BoltzmannHamel),
    Tree(Articulation),
    Elimination(Elimination),
}

/// For more coordinates the derivatives are solved for in numbers.
const MOST_COLUMNS: usize = 4;

/// Points to try until one is in the domain.
const ATTEMPTS: u64 = 64;

impl Solution {
    /// The cheapest of several ways; of two that cost the same, the later.
    pub(crate) fn cheapest(
        graph: &mut Graph,
        forcing: &[Expression],
        ways: Vec<Way>,
    ) -> Option<Self> {
        let mut solutions = Vec::with_capacity(ways.len());
        for way in ways.into_iter().rev() {
            solutions.push(Self::by(graph, forcing, way));
        }
        let written =
            |solution: &Self| graph.cost(&[&*solution.pivots, &solution.accelerations].concat());
        // What costs far more as it is written is not made cheaper by scheduling.
        let least = solutions.iter().map(written).min().unwrap_or(0);
        solutions.retain(|solution| written(solution) <= 2 * least);
        if solutions.len() == 1 {
            return solutions.pop();
        }
        solutions.into_iter().min_by_key(|solution| {
            let outputs = [&*solution.pivots, &solution.accelerations];
            let program = Program::schedule_for_preparation(graph, &outputs);
            let parts = program.parted(graph.passes);
            (parts.after.count().cost(), parts.before.count().cost())
        })
    }

    fn by(graph: &mut Graph, forcing: &[Expression], way: Way) -> Self {
        let (pivots, accelerations) = match &way {
            Way::QuasiVelocities(way) => (way.pivots(), way.accelerations(graph)),
            Way::Tree(way) => (way.pivots.clone(), way.accelerations(graph)),
            Way::Elimination(way) => {
                let accelerations = way.solve(graph, forcing);
                (way.pivots.clone(), accelerations)
            }
        };
        Self {
            pivots,
            accelerations,
            way,
        }
    }

    /// The derivatives ∂q̈/∂x, column by column, with the accelerations as symbols; none where the
    /// columns are so many and long that a factorization in numbers is the better way.
    pub fn derivatives(
        &self,
        graph: &mut Graph,
        inverse_dynamics: &[Expression],
        symbols: &[Symbol],
    ) -> Option<Vec<Expression>> {
        if let Way::QuasiVelocities(way) = &self.way {
            return Some(way.derivatives(graph, symbols));
        }
        if inverse_dynamics.len() > MOST_COLUMNS {
            return None;
        }
        let residuals = match &self.way {
            Way::Tree(way) => way.inverse_dynamics(graph),
            _ => inverse_dynamics.to_vec(),
        };
        let mut columns = Vec::new();
        for slopes in graph.jacobian(&residuals, symbols) {
            let right: Vec<_> = slopes.iter().map(|slope| graph.negate(*slope)).collect();
            columns.extend(match &self.way {
                Way::Tree(way) => way.solution(graph, &right),
                Way::Elimination(way) => way.solve(graph, &right),
                Way::QuasiVelocities(_) => Vec::new(),
            });
        }
        Some(columns)
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
        let points = (0..ATTEMPTS).map(Point::new);
        let mut found = points.filter_map(|point| Some((point, point.evaluate(graph, &roots)?)));
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
