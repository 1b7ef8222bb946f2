//! Generalized forces: on coordinates, and on positions and velocities that depend on them.
//!
//! A force F on a position p(q, t) does the virtual work F·δp, so that Qᵢ = F·∂p/∂qᵢ; a torque on an angle
//! likewise. A force on a velocity w = A(q, t) q̇ + b(q, t), such as the angular velocity in body axes, has the
//! power F·w, of which F·b is the power of the prescribed motion, and Q = Aᵀ F: the principle of virtual power
//! (Jourdain, 1909). A vector or family with a velocity in any component is a velocity as a whole.

use lagrangian_symbolic::{AtRest, Contents, Expression, Node, Symbol, Value};

use crate::lower::expression::Lowerer;
use crate::lower::hints;
use crate::lower::scope::{Binding, Family, Origin};
use crate::syntax::declaration::Declaration;
use crate::syntax::named::NamedExpression;
use crate::syntax::shape::Shape;

/// What a force acts on.
enum Target {
    /// The coordinates with these indices, which are those of one scalar or vector.
    Coordinates(Vec<usize>, Shape),
    /// A definition: a position or a velocity.
    Defined(DefinedTarget),
}

/// A position or a velocity on which a force acts.
struct DefinedTarget {
    value: Value,
    is_velocity: bool,
}

/// The generalized forces so far.
struct GeneralizedForces {
    forces: Vec<Expression>,
    /// The definitions at rest, where one is needed.
    at_rest: Option<AtRest>,
}

impl Lowerer<'_> {
    /// The generalized force of each coordinate: the sum of what the clauses say.
    pub(super) fn forces(&mut self, declaration: &Declaration) -> Option<Vec<Expression>> {
        let zero = self.graph().zero();
        let mut totals = GeneralizedForces {
            forces: vec![zero; self.coordinates as usize],
            at_rest: None,
        };
        let mut understood = true;
        for clause in &declaration.clauses.forces {
            // Which coordinates have a force in this clause.
            let mut taken = vec![false; totals.forces.len()];
            for force in clause {
                let done = self.for_each(&force.iterations, &mut |lowerer| {
                    lowerer.force(force, &mut taken, &mut totals)
                });
                understood &= done.is_some();
            }
        }
        understood.then_some(totals.forces)
    }

    /// Adds one force to the totals.
    fn force(
        &mut self,
        force: &NamedExpression,
        taken: &mut [bool],
        totals: &mut GeneralizedForces,
    ) -> Option<()> {
        self.check_not_bound(&force.name, &force.iterations)?;
        let target = if force.indices.is_empty() {
            self.target(force)
        } else {
            // What is wrong with an index is wrong with the expression, too.
            Some(self.target(force)?)
        };
        let value = self.lower(&force.expression);
        match target? {
            Target::Coordinates(indices, shape) => {
                let components = self.force_on_coordinates(force, value?, shape)?;
                for (i, component) in indices.into_iter().zip(components) {
                    if core::mem::replace(taken.get_mut(i)?, true) {
                        return self.reject(
                            &force.name,
                            "this coordinate has a force already: add them up in one expression, or write \
                             another `force(…)`, which adds to this one",
                        );
                    }
                    let graph = &mut self.typed.geometry.graph;
                    totals.forces[i] = graph.add(totals.forces[i], component);
                }
            }
            Target::Defined(target) => {
                let work = self.generalized_force(force, value?, &target, totals)?;
                for (total, work) in totals.forces.iter_mut().zip(work) {
                    *total = self.typed.geometry.graph.add(*total, work);
                }
            }
        }
        Some(())
    }

    /// The components of a force on a scalar or vector of coordinates.
    fn force_on_coordinates(
        &mut self,
        force: &NamedExpression,
        value: Value,
        shape: Shape,
    ) -> Option<Vec<Expression>> {
        if shape == Shape::Scalar {
            let value = self.as_scalar(value, &force.expression)?;
            return Some(vec![self.typed.expression(value)]);
        }
        if self.is_empty_sum(value) {
            return Some(vec![self.graph().zero(); shape.count()]);
        }
        self.check_shape(force, value, shape)?;
        Some(self.elements(value).to_vec())
    }

    /// A force has the shape of what it acts on.
    fn check_shape(&mut self, force: &NamedExpression, value: Value, shape: Shape) -> Option<()> {
        if self.shape(value) == shape {
            return Some(());
        }
        let message = format!(
            "`{}` is {shape}, and so is a force on it: this is {}",
            force.name,
            self.shape(value)
        );
        self.reject(&force.expression, message)
    }

    /// F·∂p/∂qᵢ for each coordinate, or F·∂w/∂q̇ᵢ.
    fn generalized_force(
        &mut self,
        force: &NamedExpression,
        value: Value,
        target: &DefinedTarget,
        totals: &mut GeneralizedForces,
    ) -> Option<Vec<Expression>> {
        let zero = self.graph().zero();
        if self.is_empty_sum(value) {
            return Some(vec![zero; self.coordinates as usize]);
        }
        self.check_shape(force, value, self.shape(target.value))?;
        let mut work = vec![zero; self.coordinates as usize];
        let forces = self.elements(value).to_vec();
        let acted_on = self.elements(target.value).to_vec();
        for (i, (component, acted_on)) in forces.into_iter().zip(acted_on).enumerate() {
            let partial_derivatives = self.partial_derivatives(acted_on, target.is_velocity);
            if target.is_velocity && self.graph().contents(acted_on).has_velocity() {
                self.check_velocity(force, target, (i, acted_on), totals)?;
            }
            let graph = &mut self.typed.geometry.graph;
            for (total, derivative) in work.iter_mut().zip(partial_derivatives) {
                let part = graph.multiply(component, derivative);
                *total = graph.add(*total, part);
            }
        }
        Some(work)
    }

    /// ∂p/∂qᵢ, or ∂w/∂q̇ᵢ.
    fn partial_derivatives(&mut self, acted_on: Expression, is_velocity: bool) -> Vec<Expression> {
        let symbol = if is_velocity {
            Symbol::Velocity
        } else {
            Symbol::Coordinate
        };
        let symbols: Vec<_> = (0..self.coordinates).map(symbol).collect();
        let columns = self.typed.geometry.graph.jacobian(&[acted_on], &symbols);
        columns.into_iter().flatten().collect()
    }

    /// Checks that a velocity is linear in q̇, and that nothing else in it depends on coordinates at rest: else it may
    /// be the sum of a position and a velocity.
    fn check_velocity(
        &mut self,
        force: &NamedExpression,
        target: &DefinedTarget,
        (component, velocity): (usize, Expression),
        totals: &mut GeneralizedForces,
    ) -> Option<()> {
        let name = &force.name;
        let degree = self.graph().velocity_degree(velocity);
        if degree.is_none_or(|degree| degree > 1) {
            let message = format!(
                "`{name}` is not linear in the velocities, so that no force gives power with it: a force acts on a \
                 coordinate, a position or a velocity"
            );
            return self.reject(name, message);
        }
        let at_rest = &mut totals.at_rest;
        let at_rest = at_rest.get_or_insert_with(|| AtRest::new(&self.typed));
        if at_rest.depends_on_position(&self.typed, target.value, component) {
            return self.reject(name, hints::position_and_velocity(name));
        }
        Some(())
    }

    /// Resolves what a force acts on; that there is a coordinate or a definition of this name has been checked.
    fn target(&mut self, force: &NamedExpression) -> Option<Target> {
        let name = &force.name;
        match (self.scope.resolve(name)?, force.indices.as_slice()) {
            (Binding::Quantity(Origin::Coordinate, value), indices) => {
                if let (Shape::Scalar, [index, ..]) = (self.shape(value), indices) {
                    let message = format!("`{name}` is one coordinate: leave out the index");
                    return self.reject(index, message);
                }
                self.on_coordinates(value, indices)
            }
            (Binding::Quantity(..), [index, ..]) => {
                let message = format!("`{name}` has no index: write the force on the whole of it");
                self.reject(index, message)
            }
            (Binding::Quantity(origin, value), []) => {
                let is_velocity = self.has_velocity(value);
                self.defined_target(force, origin, value, is_velocity)
            }
            (Binding::Family(origin, family), indices) if indices.len() >= family.rank => {
                let (outer, inner) = indices.split_at(family.rank);
                let member = self.member(outer)?;
                let Some(value) = family.members.get(&member).copied() else {
                    let message = match origin {
                        Origin::Coordinate => hints::out_of_range(name, &member, &family),
                        _ => format!("`{}` is not defined", hints::member(name, &member)),
                    };
                    return self.reject(&indices[0], message);
                };
                match inner {
                    _ if origin == Origin::Coordinate => self.on_coordinates(value, inner),
                    [] => {
                        let mut members = family.members.values();
                        let is_velocity = members.any(|member| self.has_velocity(*member));
                        self.defined_target(force, origin, value, is_velocity)
                    }
                    _ => self.reject_family(force, &family),
                }
            }
            (Binding::Family(_, family), _) => self.reject_family(force, &family),
            _ => None,
        }
    }

    fn reject_family<T>(&mut self, force: &NamedExpression, family: &Family) -> Option<T> {
        let name = &force.name;
        let message = format!(
            "`{name}` is a family: write `{}`",
            hints::every_member(name, family)
        );
        self.reject(name, message)
    }

    /// A scalar or vector of coordinates, or one of its components.
    fn on_coordinates(&mut self, value: Value, indices: &[syn::Expr]) -> Option<Target> {
        let indices: Vec<&syn::Expr> = indices.iter().collect();
        let value = self.components(value, &indices)?;
        let index = |component: &Expression| match self.graph().node(*component) {
            Node::Symbol(Symbol::Coordinate(i)) => Some(*i as usize),
            _ => None,
        };
        let indices = self.elements(value).iter().map(index);
        Some(Target::Coordinates(
            indices.collect::<Option<_>>()?,
            self.shape(value),
        ))
    }

    fn has_velocity(&self, value: Value) -> bool {
        self.contains(value, Contents::has_velocity)
    }

    /// A position or a velocity, where a force can act on it.
    fn defined_target(
        &mut self,
        force: &NamedExpression,
        origin: Origin,
        value: Value,
        is_velocity: bool,
    ) -> Option<Target> {
        if origin != Origin::Defined {
            return None;
        }
        let name = &force.name;
        if self.has_acceleration(value) {
            let message = format!(
                "`{name}` contains accelerations: a force acts on a position or a velocity"
            );
            return self.reject(name, message);
        }
        let moves = |symbol| matches!(symbol, Symbol::Coordinate(_) | Symbol::Velocity(_));
        if !self.graph().contains(self.elements(value), moves) {
            let message = format!("no coordinate moves `{name}`: a force on it does no work");
            return self.reject(name, message);
        }
        // Another name of a coordinate.
        if let [expression] = self.elements(value)
            && self.shape(value) == Shape::Scalar
            && let Node::Symbol(Symbol::Coordinate(_)) = self.graph().node(*expression)
            && !is_velocity
        {
            return self.on_coordinates(value, &[]);
        }
        Some(Target::Defined(DefinedTarget { value, is_velocity }))
    }
}
