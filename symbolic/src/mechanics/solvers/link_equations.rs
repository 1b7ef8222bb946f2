//! The equations of motion of a mechanism, by recursions along its links: M by composite bodies, f and M q̈ − f by Newton
//! and Euler.

use crate::matrix::rows::{differences, sums};
use crate::mechanics::mechanism::Mechanism;
use crate::mechanics::solvers::newton_euler::Joint;
use crate::mechanics::solvers::spatial_vectors::Wrench;
use crate::{Expression, Graph, LinearSystem, Model, Symbol};

/// The equations of motion of a mechanism.
#[derive(Clone)]
pub(crate) struct LinkEquations {
    pub(crate) mechanism: Mechanism,
    pub(crate) joints: Vec<Joint>,
    pub(crate) coordinates: u32,
    /// The part of M that no link has.
    pub(crate) other_mass: Vec<Vec<Expression>>,
    /// Q − 𝓛 of the part of L that no link has.
    pub(crate) forces: Vec<Expression>,
}

impl LinkEquations {
    /// The equations of a mechanism in the graph of a model, under the generalized forces Q.
    pub(crate) fn of_mechanism(
        model: &mut Model,
        mechanism: Mechanism,
        forces: &[Expression],
    ) -> Self {
        let coordinates = model.coordinates;
        let graph = &mut model.graph;
        let rest = graph.subtract(mechanism.other_kinetic, mechanism.other_potential);
        let gradient = graph.lagrange_derivatives(&[rest], coordinates);
        let forces = differences(graph, forces, &gradient[0]);
        let velocities: Vec<_> = (0..coordinates).map(Symbol::Velocity).collect();
        let momenta = graph.jacobian(&[rest], &velocities).concat();
        let other_mass = graph.jacobian(&momenta, &velocities);
        let joints = mechanism.links.iter();
        let joints = joints.map(|link| Joint::of(graph, link, coordinates));
        Self {
            joints: joints.collect(),
            mechanism,
            coordinates,
            other_mass,
            forces,
        }
    }

    /// M, f and M q̈ − f, each by a recursion along the links.
    pub(crate) fn system(&self, graph: &mut Graph) -> LinearSystem {
        let wrenches = self.wrenches(graph, false);
        let inner = self.generalized_forces(graph, &wrenches);
        let forcing = differences(graph, &self.forces, &inner);
        let mut mass = self.mass_matrix(graph);
        let others = self.other_mass.iter().flatten();
        for (entry, other) in mass.iter_mut().flatten().zip(others) {
            *entry = graph.add(*entry, *other);
        }
        let wrenches = self.wrenches(graph, true);
        LinearSystem {
            forcing,
            mass,
            inverse_dynamics: self.residuals(graph, &wrenches),
            recursion: wrenches.iter().flat_map(Wrench::components).collect(),
        }
    }

    /// M q̈ − f with the accelerations as symbols.
    pub(crate) fn inverse_dynamics(&self, graph: &mut Graph) -> Vec<Expression> {
        let wrenches = self.wrenches(graph, true);
        self.residuals(graph, &wrenches)
    }

    /// M q̈ − f where the motion of the links takes these wrenches.
    fn residuals(&self, graph: &mut Graph, wrenches: &[Wrench]) -> Vec<Expression> {
        let inner = self.generalized_forces(graph, wrenches);
        let others = self.residuals_of_others(graph);
        sums(graph, &inner, &others)
    }

    /// The part of M q̈ − f that no link has.
    pub(crate) fn residuals_of_others(&self, graph: &mut Graph) -> Vec<Expression> {
        let mut residuals = Vec::with_capacity(self.forces.len());
        for (force, row) in self.forces.iter().zip(&self.other_mass) {
            let accelerations = (0..self.coordinates).map(Symbol::Acceleration);
            let accelerations: Vec<_> = accelerations.map(|x| graph.symbol(x)).collect();
            let others = graph.sum_of_products(row.iter().copied().zip(accelerations));
            residuals.push(graph.subtract(others, *force));
        }
        residuals
    }
}
