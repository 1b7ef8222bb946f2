//! What is computed of a motion, each in the cheapest way that was found.
//!
//! Lagrange's formula gives f and M q̈ − f for every model; where quasi-velocities build on each other,
//! running along their tree takes fewer operations. The [solution](crate::mechanics::solution) for q̈ is
//! chosen among all that apply.

use crate::mechanics::articulation::Articulation;
use crate::mechanics::boltzmann_hamel::BoltzmannHamel;
use crate::mechanics::elimination::Elimination;
use crate::mechanics::kinematic_tree::KinematicTree;
use crate::mechanics::multiplied_out::MOST_COORDINATES;
use crate::mechanics::quasi_velocities::QuasiVelocities;
use crate::mechanics::solution::{Solution, Way};
use crate::{Equations, Expression, Graph, Model, Pass};

/// The kinetics of a model, as expressions of its graph.
pub struct Kinetics {
    /// The forcing f in M q̈ = f.
    pub forcing: Vec<Expression>,
    /// M q̈ − f with the accelerations as symbols.
    pub inverse_dynamics: Vec<Expression>,
    /// M q̈ = f as it is solved in numbers.
    pub system: LinearSystem,
    /// The factors of M, where elimination before any number is known takes few operations.
    pub elimination: Option<Elimination>,
    /// The accelerations; none for many coupled coordinates.
    pub solution: Option<Solution>,
}

/// The equations M q̈ = f, divided by an inertia where that leaves numbers in the place of parameters.
#[derive(Clone, Debug)]
pub struct LinearSystem {
    /// M, row by row.
    pub mass: Vec<Vec<Expression>>,
    /// f.
    pub forcing: Vec<Expression>,
    /// M q̈ − f with the accelerations as symbols.
    pub residuals: Vec<Expression>,
}

/// Where more unknowns than this meet, elimination in numbers costs no more than straight-line code.
const MOST_NEIGHBOURS: usize = 7;

impl Kinetics {
    /// The kinetics of `model`.
    pub fn cheapest(model: &mut Model, equations: &Equations) -> Self {
        let declared = QuasiVelocities::declared(&mut model.graph, equations.lagrangian);
        let forces = &equations.generalized_forces;
        let passes = model.graph.passes;
        let tree = declared
            .as_ref()
            .filter(|_| passes.has(Pass::Tree))
            .map(|declared| KinematicTree::new(model, declared, forces));
        let graph = &mut model.graph;
        let lagrange = LinearSystem {
            mass: equations.mass.clone(),
            forcing: equations.forcing.clone(),
            residuals: equations.inverse_dynamics.clone(),
        };
        let along = match &tree {
            Some(tree) => lagrange.cheaper(graph, tree),
            None => lagrange,
        };
        let elimination = passes
            .has(Pass::Elimination)
            .then(|| Elimination::factor(graph, &equations.mass, MOST_NEIGHBOURS))
            .flatten();
        let mut ways: Vec<_> = elimination.iter().cloned().map(Way::Elimination).collect();
        let mut system = along.clone();
        if let Some(tree) = tree {
            let scaled = tree.without_unit(graph);
            system = system.scaled(graph, &scaled);
            let articulation = Articulation::factor(graph, scaled, MOST_NEIGHBOURS);
            ways.extend(articulation.map(Way::Tree));
        }
        ways.extend(through_quasi_velocities(model, equations, declared));
        Self {
            solution: Solution::cheapest(&mut model.graph, &along.forcing, ways),
            forcing: along.forcing,
            inverse_dynamics: along.residuals,
            system,
            elimination,
        }
    }
}

impl LinearSystem {
    /// The same system with f and M q̈ − f along a tree where they cost less so.
    fn cheaper(self, graph: &mut Graph, tree: &KinematicTree) -> Self {
        let (forcing, residuals) = (tree.forcing(graph), tree.inverse_dynamics(graph));
        Self {
            mass: self.mass,
            forcing: cheaper(graph, self.forcing, forcing),
            residuals: cheaper(graph, self.residuals, residuals),
        }
    }

    /// The same system in the unit of a tree.
    fn scaled(self, graph: &mut Graph, tree: &KinematicTree) -> Self {
        if tree.unit == graph.one() {
            return self;
        }
        let mut mass = self.mass;
        for entry in mass.iter_mut().flatten() {
            *entry = graph.divide(*entry, tree.unit);
        }
        Self {
            mass,
            forcing: tree.forcing(graph),
            residuals: tree.inverse_dynamics(graph),
        }
    }
}

/// The ways through as many quasi-velocities as there are coordinates.
fn through_quasi_velocities(
    model: &mut Model,
    equations: &Equations,
    declared: Option<QuasiVelocities>,
) -> Vec<Way> {
    let passes = model.graph.passes;
    if !passes.has(Pass::QuasiVelocities) {
        return Vec::new();
    }
    let combined = declared
        .as_ref()
        .and_then(|declared| declared.combined(&mut model.graph));
    let mut choices: Vec<_> = declared.into_iter().chain(combined).collect();
    if model.coordinates <= MOST_COORDINATES && passes.has(Pass::Inertias) {
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
