//! How a coordinate of a joint perturbs the motion of the link behind it, where the link before moves as it did.

use std::rc::Rc;

use crate::mechanics::mechanism::{Vector, cross, inner, kept, total};
use crate::mechanics::solvers::coriolis_matrix::Perturbation;
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::newton_euler::{JointPart, Motion};
use crate::mechanics::solvers::spatial_vectors::{Twist, derivative};
use crate::{Direction, Graph, Rational, Symbol};

/// The perturbations at all joints of a mechanism.
pub(crate) struct JointPerturbations<'a> {
    equations: &'a LinkEquations,
    pub(crate) motions: Vec<Motion>,
    /// d/dt, with the accelerations as symbols.
    direction: Rc<Direction>,
}

impl<'a> JointPerturbations<'a> {
    pub(crate) fn new(graph: &mut Graph, equations: &'a LinkEquations) -> Self {
        Self {
            motions: equations.motions(graph, true),
            direction: graph.time_direction(equations.coordinates),
            equations,
        }
    }

    /// The velocity of the origin relative to the frame that moves with the origin of the link before, and does not turn.
    pub(crate) fn speed(&self, graph: &mut Graph, index: usize) -> Vector {
        let mechanism = &self.equations.mechanism;
        let (link, joint) = (&mechanism.links[index], &self.equations.joints[index]);
        let before = link.motion_before(graph, mechanism, &self.motions);
        let around = graph.cross(before.angular_velocity, link.place);
        [0, 1, 2].map(|i| total(graph, &[around[i], joint.speed[i]]))
    }

    /// The perturbations by a coordinate of a part of a joint and by its velocity: along the axes of the link where it turns,
    /// along the axes of the link before where it slides.
    pub(crate) fn at(
        &self,
        graph: &mut Graph,
        index: usize,
        part: JointPart,
        (coordinate, slope): (usize, Twist),
    ) -> [Perturbation; 2] {
        match part {
            JointPart::Turning => self.turned(graph, index, coordinate, slope.angular),
            JointPart::Sliding => {
                self.moved(graph, index, coordinate, slope.linear)
                    .map(|linear| Perturbation {
                        turning: [graph.zero(); 3],
                        acceleration: Twist {
                            linear,
                            ..Twist::none(graph)
                        },
                    })
            }
        }
    }

    /// The perturbations by a coordinate that turns a link and by its velocity, along the axes of the link.
    fn turned(
        &self,
        graph: &mut Graph,
        index: usize,
        coordinate: usize,
        slope: Vector,
    ) -> [Perturbation; 2] {
        let equations = self.equations;
        let link = &equations.mechanism.links[index];
        let before = link.motion_before(graph, &equations.mechanism, &self.motions);
        let rate = equations.joints[index].rate;
        let rate_change = self.change(graph, rate);
        let carried = link.turn.inward(graph, before.angular_velocity);
        let turned = link.turn.inward(graph, before.angular_acceleration);
        let two = Rational::integer(2);
        let gyration = [0, 1, 2].map(|i| {
            let sum = graph.sum([(carried[i], two.clone()), (rate[i], Rational::ONE)]);
            kept(graph, sum)
        });
        let across = cross(graph, carried, slope);
        let [of_position, of_velocity] = symbols(coordinate);
        // By the coordinate.
        let rate_slope = derivative(graph, rate, of_position);
        let turning = [0, 1, 2].map(|i| total(graph, &[across[i], rate_slope[i]]));
        let parts = [
            graph.cross(turned, slope),
            graph.cross(carried, across),
            graph.cross(gyration, rate_slope),
            derivative(graph, rate_change, of_position),
        ];
        let position = Perturbation {
            turning: turning.map(|x| graph.scale(x, &two)),
            acceleration: Twist {
                angular: [0, 1, 2].map(|i| total(graph, &parts.map(|x| x[i]))),
                linear: cross(graph, self.motions[index].acceleration, slope),
            },
        };
        // By its velocity; the rate has no component across the slope of a joint with one axis.
        let along = graph.cross(rate, slope);
        let change = derivative(graph, rate_change, of_velocity);
        let angular = [0, 1, 2].map(|i| {
            let twice = graph.scale(across[i], &two);
            total(graph, &[twice, along[i], change[i]])
        });
        let velocity = Perturbation {
            turning: slope.map(|x| graph.scale(x, &two)),
            acceleration: Twist {
                angular,
                ..Twist::none(graph)
            },
        };
        [position, velocity]
    }

    /// The changes δa by a coordinate that moves the origin of a link and by its velocity, along the axes of the link before.
    fn moved(
        &self,
        graph: &mut Graph,
        index: usize,
        coordinate: usize,
        slope: Vector,
    ) -> [Vector; 2] {
        let equations = self.equations;
        let link = &equations.mechanism.links[index];
        let before = link.motion_before(graph, &equations.mechanism, &self.motions);
        let speed = equations.joints[index].speed;
        let speed_change = self.change(graph, speed);
        symbols(coordinate).map(|symbol| {
            let mut parts = Vec::new();
            if matches!(symbol, Symbol::Coordinate(_)) {
                let rows = before.field;
                parts.push(rows.map(|row| inner(graph, row.into_iter().zip(slope))));
            }
            let change = derivative(graph, speed, symbol);
            let coriolis = graph.cross(before.angular_velocity, change);
            parts.push(coriolis.map(|x| graph.scale(x, &Rational::integer(2))));
            parts.push(derivative(graph, speed_change, symbol));
            [0, 1, 2].map(|i| {
                let terms: Vec<_> = parts.iter().map(|part| part[i]).collect();
                total(graph, &terms)
            })
        })
    }

    /// The derivative of a rate by time.
    fn change(&self, graph: &mut Graph, rate: Vector) -> Vector {
        let change = graph.directional_derivatives(&rate, &self.direction);
        change.try_into().unwrap_or(rate)
    }
}

/// A coordinate and its velocity.
pub(crate) fn symbols(coordinate: usize) -> [Symbol; 2] {
    let coordinate = u32::try_from(coordinate).unwrap_or(u32::MAX);
    [Symbol::Coordinate(coordinate), Symbol::Velocity(coordinate)]
}
