//! The force of a constraint on a quantity that it contains, by its virtual work.
//!
//! Where a position p alone is displaced by δp, the multipliers λ of a constraint g = 0 do the virtual work
//! λ·(∂g/∂p) δp, so that (∂g/∂p)ᵀ λ is the force on p. A rotation R is turned by a small vector δθ, R + δθ × R, and
//! the work λ·(∂g/∂θ) δθ has the moment as its factor. Of a nonholonomic constraint w = 0 it is the virtual power, with
//! ∂w/∂ṗ in place of ∂g/∂p (Lanczos, The Variational Principles of Mechanics, 1970, III).

use crate::typed::components::Components;
use crate::typed::graph::TypedGraph;
use crate::typed::operation::{TypedOperation, Value};
use crate::{Axis, Expression, Matrix, Rational, Symbol};

/// A constraint, with the multipliers of its components.
#[derive(Clone, Debug)]
pub struct ConstraintForces {
    /// The value that is zero.
    pub constraint: Value,
    /// Whether it is one of coordinates, and not of velocities.
    pub is_holonomic: bool,
    /// λ, one for each component.
    pub multipliers: Vec<Expression>,
}

impl TypedGraph {
    /// The force of a constraint on a scalar or a vector, in its shape, or the moment on a rotation, a vector along inertial
    /// axes; none if the constraint does not contain it, or if it is another matrix.
    pub fn force_on(&mut self, forces: &ConstraintForces, quantity: Value) -> Option<Value> {
        let shape = self.components(quantity).array().map(Matrix::shape);
        let count = match shape {
            None => 1,
            Some((3, 3)) => 3,
            Some((rows, 1)) => rows,
            Some(_) => return None,
        };
        let indices = (self.coordinates..).take(count);
        let displacements: Vec<_> = indices.map(Symbol::Coordinate).collect();
        let rates: Vec<_> = displacements.iter().map(|symbol| rate(*symbol)).collect();
        let displaced = self.displaced(quantity, &displacements)?;
        let residuals = self.with_displaced((quantity, displaced), forces.constraint, count)?;
        let graph = &mut self.geometry.graph;
        let varied = if forces.is_holonomic {
            &displacements
        } else {
            &rates
        };
        let columns = graph.jacobian(&residuals, varied);
        let all = [&*displacements, &rates].concat();
        let mut found = Vec::with_capacity(count);
        for column in columns {
            let slopes = graph.at_zero(&column, &all);
            let pairs = slopes.into_iter().zip(forces.multipliers.iter().copied());
            found.push(graph.sum_of_products(pairs));
        }
        let components = match shape {
            None => Components::Scalar(*found.first()?),
            Some(_) => Components::Array(Matrix::vector(found)),
        };
        self.add(TypedOperation::Given(components)).ok()
    }

    /// A quantity, displaced or turned.
    fn displaced(&mut self, quantity: Value, displacements: &[Symbol]) -> Option<Components> {
        let components = self.components(quantity).clone();
        let geometry = &mut self.geometry;
        let moved = displacements.iter();
        let moved: Vec<_> = moved.map(|symbol| geometry.graph.symbol(*symbol)).collect();
        Some(match components {
            Components::Array(rotation) if rotation.shape() == (3, 3) => {
                let sequence: Vec<_> = Axis::ALL.into_iter().zip(moved).collect();
                let turn = geometry.rotation(&sequence);
                Components::Array(geometry.matrix_product(&turn, &rotation)?)
            }
            Components::Array(place) => {
                let moved = Matrix::vector(moved);
                let terms = [(&place, Rational::ONE), (&moved, Rational::ONE)];
                Components::Array(geometry.matrix_sum(&terms)?)
            }
            Components::Scalar(x) => Components::Scalar(geometry.graph.add(x, *moved.first()?)),
            Components::EmptySum => return None,
        })
    }

    /// The components of a value that contains another, with this one displaced by so many coordinates.
    fn with_displaced(
        &mut self,
        (quantity, displaced): (Value, Components),
        whole: Value,
        count: usize,
    ) -> Option<Vec<Expression>> {
        let coordinates = self.coordinates + u32::try_from(count).ok()?;
        let (first, last) = (quantity.0 as usize, whole.0 as usize);
        let mut known = self.components[..=last].to_vec();
        let mut changes = vec![false; last + 1];
        *changes.get_mut(first)? = true;
        known[first] = Some(displaced);
        for (i, operation) in self.operations[..=last].iter().enumerate().skip(first + 1) {
            let arguments = operation.arguments();
            if arguments.iter().any(|x| changes[x.0 as usize]) {
                let components = operation.evaluate(&mut self.geometry, coordinates, &known);
                known[i] = components.ok();
                changes[i] = true;
            }
        }
        let components = known[last].as_ref().filter(|_| changes[last])?;
        Some(components.elements().to_vec())
    }
}

/// The velocity of a coordinate.
const fn rate(coordinate: Symbol) -> Symbol {
    match coordinate {
        Symbol::Coordinate(i) => Symbol::Velocity(i),
        other => other,
    }
}
