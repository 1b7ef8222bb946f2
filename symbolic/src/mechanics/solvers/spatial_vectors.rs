//! Spatial vectors of a link: its twist, and the wrench on it (Featherstone, Rigid Body Dynamics Algorithms, 2008,
//! chapter 2), each as two vectors along the axes of the link.

use crate::mechanics::mechanism::{Inertia, Turn, Vector, cross, inner, total};
use crate::{Expression, Graph, Symbol};

/// An angular velocity and the velocity of the origin, or an angular acceleration and the acceleration of the origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Twist {
    pub(crate) angular: Vector,
    pub(crate) linear: Vector,
}

/// A moment about the origin of a link, and a force.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wrench {
    pub(crate) moment: Vector,
    pub(crate) force: Vector,
}

impl Twist {
    /// The twist of a body at rest.
    pub(crate) const fn none(graph: &Graph) -> Self {
        let zero = graph.zero();
        Self {
            angular: [zero; 3],
            linear: [zero; 3],
        }
    }

    pub(crate) fn components(&self) -> impl Iterator<Item = Expression> {
        self.angular.into_iter().chain(self.linear)
    }

    /// The power of a wrench.
    pub(crate) fn power(&self, graph: &mut Graph, wrench: &Wrench) -> Expression {
        graph.sum_of_products(self.components().zip(wrench.components()))
    }

    /// The derivative of each component.
    pub(crate) fn derivative(&self, graph: &mut Graph, symbol: Symbol) -> Self {
        let [angular, linear] =
            [self.angular, self.linear].map(|vector| derivative(graph, vector, symbol));
        Self { angular, linear }
    }

    /// The rate of a wrench that is carried along: (ω × n + v × f, ω × f).
    pub(crate) fn rate_of(&self, graph: &mut Graph, wrench: &Wrench) -> Wrench {
        let turned = graph.cross(self.angular, wrench.moment);
        let lever = graph.cross(self.linear, wrench.force);
        Wrench {
            moment: [0, 1, 2].map(|i| graph.add(turned[i], lever[i])),
            force: graph.cross(self.angular, wrench.force),
        }
    }
}

impl Wrench {
    /// No wrench.
    pub(crate) const fn none(graph: &Graph) -> Self {
        let zero = graph.zero();
        Self {
            moment: [zero; 3],
            force: [zero; 3],
        }
    }

    pub(crate) fn components(&self) -> impl Iterator<Item = Expression> {
        self.moment.into_iter().chain(self.force)
    }

    /// The wrench along the axes of the link before, given how the link is turned against it.
    pub(crate) fn turned(self, graph: &mut Graph, turn: &Turn) -> Self {
        Self {
            force: turn.outward(graph, self.force),
            moment: turn.outward(graph, self.moment),
        }
    }

    /// About another origin, from which this one is at `place`.
    pub(crate) fn moved(self, graph: &mut Graph, place: Vector) -> Self {
        let lever = cross(graph, place, self.force);
        Self {
            moment: [0, 1, 2].map(|i| total(graph, &[self.moment[i], lever[i]])),
            ..self
        }
    }

    pub(crate) fn plus(self, graph: &mut Graph, other: Self) -> Self {
        let mut add = |x: Vector, y: Vector| [0, 1, 2].map(|i| total(graph, &[x[i], y[i]]));
        Self {
            moment: add(self.moment, other.moment),
            force: add(self.force, other.force),
        }
    }
}

impl Inertia {
    /// The momentum of what moves with this twist: (I ω + h × v, m v + ω × h).
    pub(crate) fn momentum(&self, graph: &mut Graph, twist: &Twist) -> Wrench {
        let tensor = self.tensor(graph);
        let swing = graph.cross(twist.angular, self.first);
        let lever = graph.cross(self.first, twist.linear);
        let force = [0, 1, 2].map(|i| {
            let own = graph.multiply(self.mass, twist.linear[i]);
            total(graph, &[own, swing[i]])
        });
        let moment = [0, 1, 2].map(|i| {
            let own = inner(graph, tensor[i].into_iter().zip(twist.angular));
            total(graph, &[own, lever[i]])
        });
        Wrench { moment, force }
    }
}

/// The derivatives of three components.
pub(crate) fn derivative(graph: &mut Graph, vector: Vector, symbol: Symbol) -> Vector {
    let derivatives = graph.derivatives(&vector, symbol);
    derivatives.try_into().unwrap_or([graph.zero(); 3])
}
