//! Time derivatives along the motion of a system.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::{Direction, Expression, Graph, Symbol};

impl Graph {
    /// The total time derivative of expressions of a system with `coordinates` degrees of freedom, by
    /// the chain rule through q, q̇ and t: q̇ for q, q̈ for q̇, 1 for t.
    pub fn time_derivatives(&mut self, roots: &[Expression], coordinates: u32) -> Vec<Expression> {
        let direction = self.time_direction(coordinates);
        self.directional_derivatives(roots, &direction)
    }

    /// The direction in which time goes on: q̇ for q, q̈ for q̇, 1 for t.
    pub(crate) fn time_direction(&mut self, coordinates: u32) -> Rc<Direction> {
        if let Some(known) = self.derivatives.time(coordinates) {
            return known;
        }
        let mut direction = self.constant_velocity_direction(coordinates);
        for i in 0..coordinates {
            let acceleration = self.symbol(Symbol::Acceleration(i));
            direction.insert(Symbol::Velocity(i), acceleration);
        }
        let direction = Rc::new(direction);
        self.derivatives.keep_time(coordinates, &direction);
        direction
    }

    /// The direction in which time goes on while velocities stay: q̇ for q, 1 for t.
    pub(crate) fn constant_velocity_direction(&mut self, coordinates: u32) -> Direction {
        let mut direction = BTreeMap::from([(Symbol::Time, self.one())]);
        for i in 0..coordinates {
            let velocity = self.symbol(Symbol::Velocity(i));
            direction.insert(Symbol::Coordinate(i), velocity);
        }
        direction
    }
}
