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
use crate::mechanics::kinematic_tree::KinematicTree;
use crate::mechanics::quasi_velocities::QuasiVelocities;
use crate::{Equations, Expression, Graph, Model, Node, Program, Rational, Symbol};

/// What is computed of a motion, each in the cheapest way that was found.
pub struct Dynamics {
    /// The forcing f in M q̈ = f.
    pub forcing: Vec<Expression>,
    /// M q̈ − f with the accelerations as symbols.
    pub inverse_dynamics: Vec<Expression>,
    /// The factors of M, for few coordinates.
    pub elimination: Option<Elimination>,
    /// The accelerations; none for many coupled coordinates.
    pub solution: Option<Solution>,
}

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
enum Way {
    QuasiVelocities(BoltzmannHamel),
    Tree(Articulation),
    Elimination(Elimination),
}

/// Where more unknowns than this meet, elimination in numbers costs no more than straight-line code.
const MOST_NEIGHBOURS: usize = 7;

/// For more coordinates the derivatives are solved for in numbers.
const MOST_COLUMNS: usize = 5;

/// A mass matrix of more rows is not multiplied out.
const MOST_COORDINATES: u32 = 4;

/// Points to try until one is in the domain.
const ATTEMPTS: u64 = 64;

impl Dynamics {
    /// The dynamics of `model`.
    pub fn cheapest(model: &mut Model, equations: &Equations) -> Self {
        let declared = QuasiVelocities::declared(&mut model.graph, equations.lagrangian);
        let forces = &equations.generalized_forces;
        let tree = declared
            .as_ref()
            .map(|declared| KinematicTree::new(model, declared, forces));
        let graph = &mut model.graph;
        let (mut forcing, mut inverse_dynamics) = (
            equations.forcing.clone(),
            equations.inverse_dynamics.clone(),
        );
        if let Some(tree) = &tree {
            let (along, residuals) = (tree.forcing(graph), tree.inverse_dynamics(graph));
            forcing = cheaper(graph, forcing, along);
            inverse_dynamics = cheaper(graph, inverse_dynamics, residuals);
        }
        let elimination = Elimination::factor(graph, &equations.mass);
        let mut ways: Vec<_> = elimination.iter().cloned().map(Way::Elimination).collect();
        if let Some(tree) = tree {
            let tree = tree.without_unit(graph);
            let articulation = Articulation::factor(graph, tree, MOST_NEIGHBOURS);
            ways.extend(articulation.map(Way::Tree));
        }
        ways.extend(through_quasi_velocities(model, equations, declared));
        Self {
            solution: Solution::cheapest(&mut model.graph, &forcing, ways),
            forcing,
            inverse_dynamics,
            elimination,
        }
    }
}

impl Solution {
    /// The cheapest of several ways; of two that cost the same, the later.
    fn cheapest(graph: &mut Graph, forcing: &[Expression], ways: Vec<Way>) -> Option<Self> {
        let mut solutions = Vec::with_capacity(ways.len());
        for way in ways.into_iter().rev() {
            solutions.push(Self::by(graph, forcing, way));
        }
        solutions.into_iter().min_by_key(|solution| {
            let outputs = [&*solution.pivots, &solution.accelerations];
            let parts = Program::schedule_for_preparation(graph, &outputs).prepared();
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
        let many = inverse_dynamics.len() > MOST_COLUMNS;
        if many && !matches!(self.way, Way::QuasiVelocities(_)) {
            return None;
        }
        let residuals = match &self.way {
            Way::Tree(way) => way.inverse_dynamics(graph),
            _ => inverse_dynamics.to_vec(),
        };
        let mut columns = Vec::with_capacity(symbols.len() * residuals.len());
        for (symbol, slopes) in symbols.iter().zip(graph.jacobian(&residuals, symbols)) {
            if let Way::QuasiVelocities(way) = &self.way {
                columns.extend(way.derivative(graph, *symbol));
                continue;
            }
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

/// The ways through as many quasi-velocities as there are coordinates.
fn through_quasi_velocities(
    model: &mut Model,
    equations: &Equations,
    declared: Option<QuasiVelocities>,
) -> Vec<Way> {
    let mut choices: Vec<_> = declared.into_iter().collect();
    if model.coordinates <= MOST_COORDINATES {
        choices.extend(QuasiVelocities::by_inertia(&mut model.graph, equations));
    }
    choices.dedup_by(|a, b| a.forms == b.forms && a.inertia == b.inertia);
    let mut ways = Vec::new();
    for choice in choices {
        let found = BoltzmannHamel::new(model, choice, &equations.generalized_forces);
        ways.extend(found.map(Way::QuasiVelocities));
    }
    ways
}

/// The second of two lists if it costs less than the first.
fn cheaper(graph: &Graph, first: Vec<Expression>, second: Vec<Expression>) -> Vec<Expression> {
    if graph.cost(&second) < graph.cost(&first) {
        second
    } else {
        first
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
