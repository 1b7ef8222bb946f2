//! Kinetic energy and momenta of a mechanism, by recursions along the links.
//!
//! The velocity of a link is that of the link before, moved to the origin and turned by one joint (Featherstone, Rigid Body
//! Dynamics Algorithms, 2008, chapter 3). The momenta of the links go back the way that forces do: p = ∂T/∂q̇ is
//! related to them as generalized forces are to wrenches.

use crate::mechanics::mechanism::{Link, Mechanism, Vector, kept, total};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::newton_euler::{Joint, Wrench};
use crate::{Expression, Graph, Rational, Symbol};

/// The angular velocity of a link and the velocity of its origin, along its axes.
#[derive(Clone, Copy)]
struct Twist {
    turning: Vector,
    moving: Vector,
}

impl LinkEquations {
    /// T and ∂L/∂q̇.
    pub(crate) fn energy_and_momenta(&self, graph: &mut Graph) -> (Expression, Vec<Expression>) {
        let mut twists: Vec<Twist> = Vec::with_capacity(self.joints.len());
        let mut momenta = Vec::with_capacity(self.joints.len());
        let mut powers = Vec::new();
        for (link, joint) in self.mechanism.links.iter().zip(&self.joints) {
            let still = [graph.zero(); 3];
            let before = link.parent.map_or(
                Twist {
                    turning: still,
                    moving: still,
                },
                |parent| twists[parent],
            );
            let twist = before.next(graph, link, joint);
            let momentum = twist.momentum(graph, link);
            let turning = twist.turning.into_iter().zip(momentum.moment);
            let moving = twist.moving.into_iter().zip(momentum.force);
            for (velocity, momentum) in turning.chain(moving) {
                powers.push((graph.multiply(velocity, momentum), Rational::HALF));
            }
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
        let lever = graph.cross(self.turning, link.place);
        let moving = [0, 1, 2].map(|i| total(graph, &[self.moving[i], lever[i], joint.speed[i]]));
        let turning = link.turn.inward(graph, self.turning);
        Self {
            turning: [0, 1, 2].map(|i| total(graph, &[turning[i], joint.rate[i]])),
            moving: link.turn.inward(graph, moving),
        }
    }

    /// The momentum of a link, and its moment about the origin.
    fn momentum(self, graph: &mut Graph, link: &Link) -> Wrench {
        let inertia = &link.inertia;
        let tensor = inertia.tensor(graph);
        let swing = graph.cross(self.turning, inertia.first);
        let lever = graph.cross(inertia.first, self.moving);
        let force = [0, 1, 2].map(|i| {
            let own = graph.multiply(inertia.mass, self.moving[i]);
            total(graph, &[own, swing[i]])
        });
        let moment = [0, 1, 2].map(|i| {
            let own = graph.sum_of_products(tensor[i].into_iter().zip(self.turning));
            let own = kept(graph, own);
            total(graph, &[own, lever[i]])
        });
        Wrench { moment, force }
    }
}
