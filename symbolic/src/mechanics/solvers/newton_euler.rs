//! Inverse dynamics of a mechanism, from the root to the leaves and back (Luh, Walker and Paul, On-line computational
//! scheme for mechanical manipulators, 1980), with everything along the axes of the links.
//!
//! The accelerations of origins are those of points, relative to the inertial frame: no velocity of a point occurs. Gravity
//! is an upward acceleration of the inertial frame. With Ω = [α ×] + [ω ×]², the acceleration of a point at r is a + Ω r;
//! the force on a link is m a + Ω h, and the moment about its origin h × a + vee(Ω S − (Ω S)ᵀ), where h and S are the
//! first and second moments.

use std::rc::Rc;

use crate::mechanics::mechanism::{
    Link, Mechanism, Vector, difference, inner, kept, slopes, total,
};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::spatial_vectors::{Twist, Wrench};
use crate::{Expression, Graph, Rational};

/// How a link moves.
#[derive(Clone, Copy)]
pub(crate) struct Motion {
    pub(crate) angular_velocity: Vector,
    /// Of the origin, relative to the inertial frame.
    pub(crate) acceleration: Vector,
    /// Ω.
    pub(crate) field: [Vector; 3],
    /// Ωⱼⱼ − Ωᵢᵢ for the axes i, j, k in order.
    stretch: Vector,
    pub(crate) angular_acceleration: Vector,
}

/// What each joint adds to the motion of the link before, and the coordinates with which it does.
#[derive(Clone)]
pub(crate) struct Joint {
    /// The angular velocity relative to the link before, along the axes of the link.
    pub(crate) rate: Vector,
    /// Its derivatives by the velocities.
    pub(crate) turning: Vec<(usize, Twist)>,
    /// The rate of the place in the link before, along its axes.
    pub(crate) speed: Vector,
    /// Its derivatives by the velocities.
    pub(crate) sliding: Vec<(usize, Twist)>,
}

/// A part of a joint: where it slides and turns, it slides first, seen from the link before.
#[derive(Clone, Copy)]
pub(crate) enum JointPart {
    Turning,
    Sliding,
}

impl Joint {
    pub(crate) fn of(graph: &mut Graph, link: &Link, coordinates: u32) -> Self {
        let rate = link.turn.rate(graph, coordinates);
        let speed = graph.time_derivatives(&link.place, coordinates);
        let speed = speed.try_into().unwrap_or([graph.zero(); 3]);
        let none = Twist::none(graph);
        let turning = slopes(graph, rate, coordinates).into_iter();
        let sliding = slopes(graph, speed, coordinates).into_iter();
        Self {
            turning: turning
                .map(|(i, angular)| (i, Twist { angular, ..none }))
                .collect(),
            sliding: sliding
                .map(|(i, linear)| (i, Twist { linear, ..none }))
                .collect(),
            rate,
            speed,
        }
    }

    /// The twists that unit velocities give to a part.
    pub(crate) fn slopes(&self, part: JointPart) -> &[(usize, Twist)] {
        match part {
            JointPart::Turning => &self.turning,
            JointPart::Sliding => &self.sliding,
        }
    }
}

impl LinkEquations {
    /// The links with their joints, from the leaves to the root.
    pub(crate) fn inward(&self) -> impl Iterator<Item = (usize, &Link, &Joint)> {
        let links = self.mechanism.links.iter().zip(&self.joints).enumerate();
        links.rev().map(|(i, (link, joint))| (i, link, joint))
    }

    /// How the links move; with the accelerations of the coordinates as symbols, or with none.
    pub(crate) fn motions(&self, graph: &mut Graph, with_accelerations: bool) -> Vec<Motion> {
        let direction = if with_accelerations {
            graph.time_direction(self.coordinates)
        } else {
            Rc::new(graph.constant_velocity_direction(self.coordinates))
        };
        let mut motions: Vec<Motion> = Vec::with_capacity(self.joints.len());
        for (link, joint) in self.mechanism.links.iter().zip(&self.joints) {
            let before = link.motion_before(graph, &self.mechanism, &motions);
            let mut change = |vector: Vector| -> Vector {
                let rates = graph.directional_derivatives(&vector, &direction);
                rates.try_into().unwrap_or(vector)
            };
            let changes = [change(joint.rate), change(joint.speed)];
            motions.push(before.next(graph, link, joint, changes));
        }
        motions
    }

    /// The wrenches on the links that their motion takes.
    pub(crate) fn wrenches(&self, graph: &mut Graph, with_accelerations: bool) -> Vec<Wrench> {
        let motions = self.motions(graph, with_accelerations);
        let pairs = self.mechanism.links.iter().zip(motions);
        pairs
            .map(|(link, motion)| motion.wrench(graph, link))
            .collect()
    }

    /// The generalized forces that wrenches on the links are balanced by.
    pub(crate) fn generalized_forces(
        &self,
        graph: &mut Graph,
        wrenches: &[Wrench],
    ) -> Vec<Expression> {
        let mut terms = vec![Vec::new(); self.forces.len()];
        let mut totals = wrenches.to_vec();
        for (i, link, joint) in self.inward() {
            for (coordinate, slope) in &joint.turning {
                terms[*coordinate].push((slope.power(graph, &totals[i]), Rational::ONE));
            }
            if link.parent.is_none() && joint.sliding.is_empty() {
                continue;
            }
            let wrench = totals[i].turned(graph, &link.turn);
            let wrench = wrench.moved(graph, link.place);
            for (coordinate, slope) in &joint.sliding {
                terms[*coordinate].push((slope.power(graph, &wrench), Rational::ONE));
            }
            if let Some(parent) = link.parent {
                totals[parent] = totals[parent].plus(graph, wrench);
            }
        }
        terms.into_iter().map(|terms| graph.sum(terms)).collect()
    }
}

impl Link {
    /// How the link before moves, where the links before have these motions.
    pub(crate) fn motion_before(
        &self,
        graph: &Graph,
        mechanism: &Mechanism,
        motions: &[Motion],
    ) -> Motion {
        match self.parent {
            Some(parent) => motions[parent],
            None => Motion::of_base(graph, mechanism.base_acceleration),
        }
    }
}

impl Motion {
    fn of_base(graph: &Graph, acceleration: Vector) -> Self {
        let zero = graph.zero();
        Self {
            angular_velocity: [zero; 3],
            acceleration,
            field: [[zero; 3]; 3],
            stretch: [zero; 3],
            angular_acceleration: [zero; 3],
        }
    }

    /// The motion of the next link, whose joint has these derivatives of its rate and speed.
    fn next(
        self,
        graph: &mut Graph,
        link: &Link,
        joint: &Joint,
        [rate_change, speed_change]: [Vector; 2],
    ) -> Self {
        let before = self.acceleration;
        let along = graph.cross(self.angular_velocity, joint.speed);
        let acceleration = [0, 1, 2].map(|i| {
            let centripetal = (0..3).map(|j| (self.field[i][j], link.place[j]));
            let centripetal = graph.sum_of_products(centripetal);
            let sum = graph.sum([
                (before[i], Rational::ONE),
                (centripetal, Rational::ONE),
                (along[i], Rational::integer(2)),
                (speed_change[i], Rational::ONE),
            ]);
            kept(graph, sum)
        });
        let acceleration = link.turn.inward(graph, acceleration);
        let carried = link.turn.inward(graph, self.angular_velocity);
        let angular_velocity = [0, 1, 2].map(|i| total(graph, &[carried[i], joint.rate[i]]));
        let turned = link.turn.inward(graph, self.angular_acceleration);
        let gyration = graph.cross(carried, joint.rate);
        let angular_acceleration =
            [0, 1, 2].map(|i| total(graph, &[turned[i], gyration[i], rate_change[i]]));
        let (field, stretch) = field(graph, angular_velocity, angular_acceleration);
        Self {
            angular_velocity,
            acceleration,
            field,
            stretch,
            angular_acceleration,
        }
    }

    /// The wrench that the motion of a link takes.
    fn wrench(&self, graph: &mut Graph, link: &Link) -> Wrench {
        let inertia = &link.inertia;
        let (field, first, second) = (&self.field, inertia.first, &inertia.second);
        let force = [0, 1, 2].map(|i| {
            let products = (0..3).map(|j| (field[i][j], first[j]));
            let products = products.chain([(inertia.mass, self.acceleration[i])]);
            inner(graph, products)
        });
        let lever = graph.cross(first, self.acceleration);
        let moment = [0, 1, 2].map(|k: usize| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            // (Ω S)ⱼᵢ − (Ω S)ᵢⱼ, the diagonal of Ω gathered around the product Sᵢⱼ.
            let minus = |graph: &mut Graph, x| graph.negate(x);
            let pairs = [
                (second[i][j], self.stretch[k]),
                (second[k][i], field[j][k]),
                (minus(graph, second[k][j]), field[i][k]),
                (second[i][i], field[j][i]),
                (minus(graph, second[j][j]), field[i][j]),
            ];
            let turning = graph.sum_of_products(pairs);
            total(graph, &[turning, lever[k]])
        });
        Wrench { moment, force }
    }
}

/// Ω = [α ×] + [ω ×]², and the differences of its diagonal.
fn field(graph: &mut Graph, velocity: Vector, acceleration: Vector) -> ([Vector; 3], Vector) {
    let mut field = [[graph.zero(); 3]; 3];
    let mut stretch = [graph.zero(); 3];
    let squares = velocity.map(|x| graph.square(x));
    for k in 0..3 {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let sum = graph.add(squares[i], squares[j]);
        let minus = graph.negate(sum);
        field[k][k] = kept(graph, minus);
        stretch[k] = difference(graph, squares[j], squares[i]);
        let product = inner(graph, [(velocity[i], velocity[j])]);
        field[j][i] = total(graph, &[product, acceleration[k]]);
        field[i][j] = difference(graph, product, acceleration[k]);
    }
    (field, stretch)
}
