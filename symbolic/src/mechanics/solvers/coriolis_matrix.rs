//! What a rigid perturbation of the motion of a link changes in the wrench on what it carries.
//!
//! The perturbation of all links behind a joint is known by that of the first: by δω, by δβ = δα + ω × δω, which passes joints
//! unchanged, and by δa of the origin. The wrench about the origin changes by
//!
//! m δa + δβ × h + 2 π × δω and h × δa + I δβ + 2 G δω,
//!
//! where π and G are the sums of h × ω and −[ω ×] S, moved from link to link. They are the part of the body-level Coriolis
//! matrix of Echeandia and Wensing, Numerical methods to compute the Coriolis matrix and Christoffel symbols for rigid-body
//! systems, 2021, that the velocity of the origin has no share in.

use crate::mechanics::mechanism::{Inertia, Turn, Vector, cross, difference, inner, total};
use crate::mechanics::solvers::spatial_vectors::{Twist, Wrench};
use crate::{Expression, Graph};

/// A change of the motion of a link, along its axes.
#[derive(Clone, Copy)]
pub(crate) struct Perturbation {
    /// 2 δω.
    pub(crate) turning: Vector,
    /// δβ and δa.
    pub(crate) acceleration: Twist,
}

/// π and G.
#[derive(Clone)]
pub(crate) struct CoriolisMatrix {
    force: Vector,
    moment: [Vector; 3],
}

impl CoriolisMatrix {
    /// Of one body with this angular velocity.
    pub(crate) fn of(graph: &mut Graph, inertia: &Inertia, angular_velocity: Vector) -> Self {
        let force = cross(graph, inertia.first, angular_velocity);
        // S is symmetric: its rows are its columns.
        let columns = inertia.second;
        let columns = columns.map(|column| cross(graph, column, angular_velocity));
        Self {
            force,
            moment: transposed(columns),
        }
    }

    /// The coefficients of 2 δω in the moment and in the force.
    pub(crate) fn rows(&self, graph: &mut Graph) -> [[Vector; 3]; 2] {
        let zero = graph.zero();
        let [x, y, z] = self.force;
        let [minus_x, minus_y, minus_z] = self.force.map(|x| graph.negate(x));
        let force = [[zero, minus_z, y], [z, zero, minus_x], [minus_y, x, zero]];
        [self.moment, force]
    }

    /// The same along the axes of the link before.
    pub(crate) fn turned(&self, graph: &mut Graph, turn: &Turn) -> Self {
        Self {
            force: turn.outward(graph, self.force),
            moment: turn.outward_block(graph, self.moment, false),
        }
    }

    /// The same about an origin from which this one is at `place`, and relative to which it has the velocity `speed`;
    /// `inertia` is that about this one.
    pub(crate) fn moved(
        &self,
        graph: &mut Graph,
        inertia: &Inertia,
        place: Vector,
        speed: Vector,
    ) -> Self {
        let force = [0, 1, 2].map(|i| {
            let momentum = graph.multiply(inertia.mass, speed[i]);
            difference(graph, self.force[i], momentum)
        });
        // [x ×] [y ×] = y xᵀ − (x · y) 1, on the diagonal without what cancels.
        let first = inertia.first;
        let shares = [0, 1, 2].map(|k| {
            let minus = graph.negate(force[k]);
            inner(graph, [(first[k], speed[k]), (minus, place[k])])
        });
        let moment = [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| {
                let own = self.moment[i][j];
                if i == j {
                    return total(graph, &[own, shares[(i + 1) % 3], shares[(i + 2) % 3]]);
                }
                let minus = graph.negate(speed[i]);
                let products = [(force[i], place[j]), (minus, first[j])];
                let products = graph.sum_of_products(products);
                total(graph, &[own, products])
            })
        });
        Self { force, moment }
    }

    /// Adds another one about the same origin.
    pub(crate) fn add(&mut self, graph: &mut Graph, other: &Self) {
        for i in 0..3 {
            self.force[i] = total(graph, &[self.force[i], other.force[i]]);
            for j in 0..3 {
                self.moment[i][j] = total(graph, &[self.moment[i][j], other.moment[i][j]]);
            }
        }
    }

    /// The change of the wrench on a body of this inertia.
    pub(crate) fn wrench(
        &self,
        graph: &mut Graph,
        inertia: &Inertia,
        change: &Perturbation,
    ) -> Wrench {
        let Twist { angular, linear } = change.acceleration;
        let tensor = inertia.tensor(graph);
        let swing = graph.cross(angular, inertia.first);
        let coriolis = graph.cross(self.force, change.turning);
        let force = [0, 1, 2].map(|i| {
            let own = graph.multiply(inertia.mass, linear[i]);
            total(graph, &[own, swing[i], coriolis[i]])
        });
        let lever = graph.cross(inertia.first, linear);
        let moment = [0, 1, 2].map(|i| {
            let turned = tensor[i].into_iter().zip(angular);
            let coriolis = self.moment[i].into_iter().zip(change.turning);
            let sum = graph.sum_of_products(turned.chain(coriolis));
            total(graph, &[sum, lever[i]])
        });
        Wrench { moment, force }
    }

    /// The coefficients of 2 δω in the power of the change at a twist.
    pub(crate) fn power(&self, graph: &mut Graph, twist: &Twist) -> Vector {
        let sliding = graph.cross(twist.linear, self.force);
        let columns = transposed(self.moment);
        [0, 1, 2].map(|i| {
            let turning = graph.sum_of_products(twist.angular.into_iter().zip(columns[i]));
            total(graph, &[turning, sliding[i]])
        })
    }
}

impl Perturbation {
    /// Its product with the coefficients of 2 δω, and with those of δβ and δa, which are a momentum.
    pub(crate) fn times(
        &self,
        graph: &mut Graph,
        of_turning: Vector,
        momentum: &Wrench,
    ) -> Expression {
        let turning = of_turning.into_iter().zip(self.turning);
        let others = momentum.components().zip(self.acceleration.components());
        graph.sum_of_products(turning.chain(others))
    }
}

const fn transposed(rows: [Vector; 3]) -> [Vector; 3] {
    let [x, y, z] = rows;
    [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Symbol;

    #[test]
    fn what_lies_along_an_axis_has_no_part_in_the_moment_about_it() {
        let mut graph = Graph::new();
        let mut symbols = (0..).map(Symbol::Parameter);
        let mut vector = || [0, 1, 2].map(|_| symbols.next().unwrap_or(Symbol::Time));
        let [center, turning, place, speed] = [0, 1, 2, 3].map(|_| vector());
        let mass = graph.symbol(Symbol::Input(0));
        let [x, angular_velocity, shift, velocity] =
            [center, turning, place, speed].map(|vector| vector.map(|symbol| graph.symbol(symbol)));
        let inertia = Inertia::point(&mut graph, mass, x);
        let matrix = CoriolisMatrix::of(&mut graph, &inertia, angular_velocity);
        let moved = matrix.moved(&mut graph, &inertia, shift, velocity);
        for i in 0..3 {
            let found = graph.symbols(&[moved.moment[i][i]]);
            assert!(
                !found.contains(&place[i]) && !found.contains(&speed[i]),
                "{i}"
            );
            let across = [(i + 1) % 3, (i + 2) % 3];
            assert!(across.iter().all(|j| found.contains(&place[*j])), "{i}");
        }
    }
}
