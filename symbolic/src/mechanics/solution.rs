//! The accelerations in the cheapest way that a declaration allows.
//!
//! Several ways lead from energies to q̈: through the quasi-velocities whose squares were declared, as
//! they were or with equal inertias regrouped, or by elimination of the mass matrix. All are written
//! down, and the one that costs least by the [cost model](crate::program::cost) is taken.

use crate::decision::point::Point;
use crate::decision::residue;
use crate::mechanics::articulation::Articulation;
use crate::mechanics::boltzmann_hamel::BoltzmannHamel;
use crate::mechanics::elimination::Elimination;
use crate::mechanics::kinematic_tree::KinematicTree;
use crate::mechanics::quasi_velocities::QuasiVelocities;
use crate::{Equations, Expression, Graph, Model, Node, Program, Rational};

/// The accelerations q̈ as expressions.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The accelerations hold where all of these are positive; where one is not, M is to be factored
    /// with exchange of rows. Empty if they hold wherever M is regular.
    pub pivots: Vec<Expression>,
    /// The accelerations q̈.
    pub accelerations: Vec<Expression>,
}

/// Where more unknowns than this meet, elimination in numbers costs no more than straight-line code.
const MOST_NEIGHBOURS: usize = 7;

/// A mass matrix of more rows is not multiplied out.
const MOST_COORDINATES: u32 = 4;

/// Points to try until one is in the domain.
const ATTEMPTS: u64 = 64;

impl Solution {
    /// The cheapest of the solutions that were found; none for many coupled coordinates.
    pub fn cheapest(
        model: &mut Model,
        equations: &Equations,
        elimination: Option<&Elimination>,
    ) -> Option<Self> {
        let mut solutions = Self::through_quasi_velocities(model, equations);
        solutions.extend(elimination.map(|elimination| Self {
            pivots: elimination.pivots.clone(),
            accelerations: elimination.accelerations.clone(),
        }));
        solutions.into_iter().min_by_key(|solution| {
            let outputs = [&*solution.pivots, &solution.accelerations];
            Program::schedule(&model.graph, &outputs).count().cost()
        })
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

    fn through_quasi_velocities(model: &mut Model, equations: &Equations) -> Vec<Self> {
        let mut solutions = Vec::new();
        let declared = QuasiVelocities::declared(&mut model.graph, equations.lagrangian);
        if let Some(declared) = &declared {
            solutions.extend(Self::along_tree(model, equations, declared));
        }
        let coordinates = model.coordinates;
        let mut choices: Vec<_> = declared.into_iter().collect();
        if coordinates <= MOST_COORDINATES {
            choices.extend(QuasiVelocities::by_inertia(&mut model.graph, equations));
        }
        choices.dedup_by(|a, b| a.forms == b.forms && a.inertia == b.inertia);
        for choice in choices {
            let found = BoltzmannHamel::new(&mut model.graph, choice, coordinates);
            let forces = &equations.generalized_forces;
            solutions.extend(found.and_then(|found| found.accelerations(model, forces)));
        }
        solutions
    }

    fn along_tree(
        model: &mut Model,
        equations: &Equations,
        declared: &QuasiVelocities,
    ) -> Option<Self> {
        let tree = KinematicTree::new(model, declared, &equations.generalized_forces);
        let graph = &mut model.graph;
        let tree = tree.without_unit(graph);
        let found = Articulation::solve(graph, &tree, MOST_NEIGHBOURS)?;
        Some(Self {
            pivots: found.pivots,
            accelerations: found.accelerations,
        })
    }
}

fn has_higher_roots(graph: &Graph, roots: &[Expression]) -> bool {
    let higher = |exponent: &Rational| !(exponent * &Rational::integer(2)).is_integer();
    graph
        .descendants(roots)
        .into_iter()
        .any(|expression| match graph.node(expression) {
            Node::Product(factors) => factors.iter().any(|(_, exponent)| higher(exponent)),
            _ => false,
        })
}
