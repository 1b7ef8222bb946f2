//! The constraints of a mechanism along its links: coefficients of the accelerations of links, and what the velocities
//! contribute to the accelerations of the points that they restrict.

use crate::mechanics::constraints::ConstraintEquations;
use crate::mechanics::mechanism::{LinkVelocity, LinkedConstraint, Vector, VelocityKind, slopes};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::link_vectors::Accelerations;
use crate::mechanics::solvers::newton_euler::Motion;
use crate::mechanics::solvers::spatial_vectors::Wrench;
use crate::mechanics::solvers::twist_elimination::{Unknown, twist};
use crate::{Expression, Graph, Rational};

/// A constraint G q̈ + γ = 0 of a mechanism.
#[derive(Clone)]
pub(crate) struct LinkConstraint {
    /// The coefficients of the angular accelerations of links and of the accelerations of their origins, along their axes.
    pub(crate) links: Vec<(usize, Wrench)>,
    /// The coefficients of accelerations of coordinates.
    pub(crate) coordinates: Vec<(usize, Expression)>,
    /// γ.
    pub(crate) rate: Expression,
}

impl LinkEquations {
    /// The constraints along the links; none if they cannot be read so.
    pub(crate) fn constraints(
        &self,
        graph: &mut Graph,
        equations: &ConstraintEquations,
    ) -> Option<Vec<LinkConstraint>> {
        if equations.is_empty() {
            return Some(Vec::new());
        }
        let linked = self.mechanism.constraints.as_ref()?;
        let motions = self.motions(graph, false);
        let mut constraints = Vec::with_capacity(linked.len());
        let mut differences = Vec::new();
        for (i, declared) in equations.declared.iter().enumerate() {
            let linked = linked.get(*declared)?;
            let links = linked.velocities.iter();
            let links = links.map(|velocity| (velocity.link, velocity.coefficients(graph)));
            let links: Vec<_> = links.collect();
            let zero = graph.zero();
            let rest = slopes(graph, [linked.rest, zero, zero], self.coordinates);
            let coordinates: Vec<_> = rest
                .into_iter()
                .map(|(i, [slope, ..])| (i, slope))
                .collect();
            for (found, expected) in self
                .row(graph, &links, &coordinates)
                .into_iter()
                .zip(&equations.jacobian[i])
            {
                differences.push(graph.subtract(found, *expected));
            }
            let rate = match self.rate(graph, linked, &motions) {
                Some(rate) => {
                    differences.push(graph.subtract(rate, equations.rates[i]));
                    rate
                }
                None => equations.rates[i],
            };
            constraints.push(LinkConstraint {
                links,
                coordinates,
                rate,
            });
        }
        graph.vanishes(&differences).then_some(constraints)
    }

    /// The row of G of coefficients of links and coordinates.
    fn row(
        &self,
        graph: &mut Graph,
        links: &[(usize, Wrench)],
        coordinates: &[(usize, Expression)],
    ) -> Vec<Expression> {
        let mut wrenches = vec![Wrench::none(graph); self.mechanism.links.len()];
        for (link, wrench) in links {
            wrenches[*link] = wrenches[*link].plus(graph, *wrench);
        }
        let mut row = self.generalized_forces(graph, &wrenches);
        for (i, coefficient) in coordinates {
            row[*i] = graph.add(row[*i], *coefficient);
        }
        row
    }

    /// γ by the accelerations of the links at q̈ = 0, if all directions are constant.
    fn rate(
        &self,
        graph: &mut Graph,
        constraint: &LinkedConstraint,
        motions: &[Motion],
    ) -> Option<Expression> {
        let direction = graph.constant_velocity_direction(self.coordinates);
        let rest = graph.directional_derivatives(&[constraint.rest], &direction);
        let mut terms = vec![(rest[0], Rational::ONE)];
        for velocity in &constraint.velocities {
            let constant = velocity.constant?;
            let motion = &motions[velocity.link];
            let centripetal = |graph: &mut Graph, place: Vector| {
                motion
                    .field
                    .map(|row| graph.sum_of_products(row.into_iter().zip(place)))
            };
            let acceleration = match velocity.kind {
                VelocityKind::Point(place) => {
                    let base = self.mechanism.base_acceleration;
                    let base = graph.sum_of_products(constant.into_iter().zip(base));
                    terms.push((base, Rational::MINUS_ONE));
                    let field = centripetal(graph, place);
                    [0, 1, 2].map(|i| graph.add(motion.acceleration[i], field[i]))
                }
                VelocityKind::Fixed(vector) => centripetal(graph, vector),
                VelocityKind::Axes => motion.angular_acceleration,
            };
            let pairs = velocity.direction.into_iter().zip(acceleration);
            terms.push((graph.sum_of_products(pairs), Rational::ONE));
        }
        Some(graph.sum(terms))
    }
}

impl LinkVelocity {
    /// The coefficients of the angular velocity of the link and of the velocity of its origin, along its axes.
    fn coefficients(&self, graph: &mut Graph) -> Wrench {
        let n = self.direction;
        let none = [graph.zero(); 3];
        let (moment, force) = match self.kind {
            VelocityKind::Point(place) => (graph.cross(place, n), n),
            VelocityKind::Fixed(vector) => (graph.cross(vector, n), none),
            VelocityKind::Axes => (n, none),
        };
        Wrench { moment, force }
    }
}

impl LinkConstraint {
    /// G q̈ of the accelerations of links and coordinates.
    pub(crate) fn acceleration(&self, graph: &mut Graph, known: &Accelerations) -> Expression {
        let mut pairs = Vec::new();
        for (link, coefficients) in &self.links {
            let accelerations = twist(*link).map(|unknown| known.get(graph, unknown));
            pairs.extend(coefficients.components().zip(accelerations));
        }
        for (i, coefficient) in &self.coordinates {
            let acceleration = known.get(graph, Unknown::Coordinate(*i));
            pairs.push((*coefficient, acceleration));
        }
        graph.sum_of_products(pairs)
    }
}
