//! Kinetic energy and momenta of a mechanism, by recursions along the links.
//!
//! The velocity of a link is that of the link before, moved to the origin and turned by one joint (Featherstone, Rigid Body
//! Dynamics Algorithms, 2008, chapter 3). The momenta of the links go back the way that forces do: p = ∂T/∂q̇ is
//! related to them as generalized forces are to wrenches.

use crate::mechanics::mechanism::{Link, Mechanism, total};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::newton_euler::Joint;
use crate::mechanics::solvers::spatial_vectors::Twist;
use crate::{Expression, Graph, Rational, Symbol};

impl LinkEquations {
    /// T and ∂L/∂q̇.
    pub(crate) fn energy_and_momenta(&self, graph: &mut Graph) -> (Expression, Vec<Expression>) {
        let mut twists: Vec<Twist> = Vec::with_capacity(self.joints.len());
        let mut momenta = Vec::with_capacity(self.joints.len());
        let mut powers = Vec::new();
        for (link, joint) in self.mechanism.links.iter().zip(&self.joints) {
            let still = Twist::none(graph);
            let before = link.parent.map_or(still, |parent| twists[parent]);
            let twist = before.next(graph, link, joint);
            let momentum = link.inertia.momentum(graph, &twist);
            powers.push((twist.power(graph, &momentum), Rational::HALF));
            twists.push(twist);
            momenta.push(momentum);
        }
        let energy = graph.sum(powers);
        let mut momenta = self.generalized_forces(graph, &momenta);
        let Mechanism {
            other_kinetic,
            other_potential,
            ..
        } = self.mechanism;
        let rest = graph.subtract(other_kinetic, other_potential);
        let velocities: Vec<_> = (0..self.coordinates).map(Symbol::Velocity).collect();
        let others = graph.jacobian(&[rest], &velocities).concat();
        for (momentum, other) in momenta.iter_mut().zip(others) {
            *momentum = graph.add(*momentum, other);
        }
        (graph.add(energy, other_kinetic), momenta)
    }
}

impl Twist {
    /// The twist of the next link.
    fn next(self, graph: &mut Graph, link: &Link, joint: &Joint) -> Self {
        let lever = graph.cross(self.angular, link.place);
        let linear = [0, 1, 2].map(|i| total(graph, &[self.linear[i], lever[i], joint.speed[i]]));
        let angular = link.turn.inward(graph, self.angular);
        Self {
            angular: [0, 1, 2].map(|i| total(graph, &[angular[i], joint.rate[i]])),
            linear: link.turn.inward(graph, linear),
        }
    }
}
