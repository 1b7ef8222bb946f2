//! M q̈ = f as it is solved numerically.

use crate::mechanics::solvers::kinematic_tree::KinematicTree;
use crate::{Expression, Graph};

/// The equations M q̈ = f, divided by an inertia of which the others are multiples, if there is one.
#[derive(Clone, Debug)]
pub struct LinearSystem {
    /// M, row by row.
    pub mass: Vec<Vec<Expression>>,
    /// f.
    pub forcing: Vec<Expression>,
    /// M q̈ − f with the accelerations as symbols.
    pub inverse_dynamics: Vec<Expression>,
    /// The intermediate results of the recursion along links that computes M q̈ − f, in its order; of other ways none.
    pub recursion: Vec<Expression>,
}

impl LinearSystem {
    /// The system with f and M q̈ − f along a tree, and with a mass matrix in the unit of the tree.
    fn along(graph: &mut Graph, tree: &KinematicTree, mass: Vec<Vec<Expression>>) -> Self {
        Self {
            mass,
            forcing: tree.forcing(graph),
            inverse_dynamics: tree.inverse_dynamics(graph),
            recursion: Vec::new(),
        }
    }

    /// Takes f and M q̈ − f along a tree where they cost less.
    pub(crate) fn cheaper(self, graph: &mut Graph, tree: &KinematicTree) -> Self {
        let along_tree = Self::along(graph, tree, self.mass.clone());
        self.or(graph, along_tree)
    }

    /// Takes M, f and M q̈ − f from another form of the system where they cost less.
    pub(crate) fn or(mut self, graph: &Graph, other: Self) -> Self {
        if graph.costs_less(&other.mass.concat(), &self.mass.concat()) {
            self.mass = other.mass;
        }
        if graph.costs_less(&other.forcing, &self.forcing) {
            self.forcing = other.forcing;
        }
        if graph.costs_less(&other.inverse_dynamics, &self.inverse_dynamics) {
            self.inverse_dynamics = other.inverse_dynamics;
            self.recursion = other.recursion;
        }
        self
    }

    /// The same system in the unit of a tree.
    pub(crate) fn scaled(self, graph: &mut Graph, tree: &KinematicTree) -> Self {
        if tree.unit == graph.one() {
            return self;
        }
        let mut mass = self.mass;
        for entry in mass.iter_mut().flatten() {
            *entry = graph.divide(*entry, tree.unit);
        }
        Self::along(graph, tree, mass)
    }
}
