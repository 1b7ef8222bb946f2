//! Generalized forces: those that act on coordinates, and those that act on what coordinates move.
//!
//! A force F on a position p(q, t) does the work F·δp, so that Qᵢ = F·∂p/∂qᵢ; a torque on an angle that is
//! made of coordinates likewise. A force on a velocity w(q, q̇, t), such as the angular velocity in the axes of
//! a body, has the power F·w where w is of first degree in q̇, and Qᵢ = F·∂w/∂q̇ᵢ.

use lagrangian_symbolic::{Expression, Node, Symbol};

use crate::declaration::Declaration;
use crate::expression::{Place, Translator};
use crate::hints;
use crate::named::Named;
use crate::scope::{Kind, Meaning};
use crate::value::Value;

/// What a force acts on.
enum Target {
    /// The coordinate with this index.
    Coordinate(usize),
    /// What is defined as a function of coordinates, or of velocities.
    Moved(Value),
}

impl Translator<'_> {
    /// The generalized force of each coordinate: the sum of what the clauses say.
    pub(super) fn forces(&mut self, declaration: &Declaration) -> Option<Vec<Expression>> {
        let zero = self.graph.zero();
        let mut totals = vec![zero; self.coordinates as usize];
        let mut understood = true;
        for clause in &declaration.clauses.forces {
            // Which coordinates have a force in this clause.
            let mut taken = vec![false; totals.len()];
            for force in clause {
                let done = self.for_each(&force.iterations, &mut |translator| {
                    translator.force(force, &mut taken, &mut totals)
                });
                understood &= done.is_some();
            }
        }
        understood.then_some(totals)
    }

    /// Adds one force to the totals.
    fn force(
        &mut self,
        force: &Named,
        taken: &mut [bool],
        totals: &mut [Expression],
    ) -> Option<()> {
        self.check_not_bound(&force.name, &force.iterations)?;
        let target = if force.indices.is_empty() {
            self.target(force)
        } else {
            // What is wrong with an index is wrong with the expression, too.
            Some(self.target(force)?)
        };
        let value = self.translate(&force.expression, Place::Energy);
        match target? {
            Target::Coordinate(i) => {
                let value = self.as_scalar(&value?, &force.expression)?;
                if core::mem::replace(taken.get_mut(i)?, true) {
                    return self.reject(
                        &force.name,
                        "this coordinate has a force already: add them up in one expression, or write \
                         another `force(…)`, which adds to this one",
                    );
                }
                totals[i] = self.graph.add(totals[i], value);
            }
            Target::Moved(moved) => {
                let work = self.work(force, &value?, &moved)?;
                for (total, work) in totals.iter_mut().zip(work) {
                    *total = self.graph.add(*total, work);
                }
            }
        }
        Some(())
    }

    /// F·∂p/∂qᵢ for each coordinate, or F·∂w/∂q̇ᵢ.
    fn work(&mut self, force: &Named, value: &Value, moved: &Value) -> Option<Vec<Expression>> {
        let zero = self.graph.zero();
        if *value == Value::Nothing {
            return Some(vec![zero; self.coordinates as usize]);
        }
        if value.shape() != moved.shape() {
            let message = format!(
                "`{}` is {}, and so is a force on it: this is {}",
                force.name,
                moved.shape(),
                value.shape()
            );
            return self.reject(&force.expression, message);
        }
        let mut work = vec![zero; self.coordinates as usize];
        for (component, along) in value.components().iter().zip(moved.components()) {
            let slopes = self.slopes(force, *along)?;
            for (total, slope) in work.iter_mut().zip(slopes) {
                let part = self.graph.multiply(*component, slope);
                *total = self.graph.add(*total, part);
            }
        }
        Some(work)
    }

    /// ∂p/∂qᵢ, or ∂w/∂q̇ᵢ for a velocity, which has to be of first degree in the velocities.
    fn slopes(&mut self, force: &Named, along: Expression) -> Option<Vec<Expression>> {
        let is_velocity = self.graph.contents(along).has_velocity();
        let symbol = if is_velocity {
            Symbol::Velocity
        } else {
            Symbol::Coordinate
        };
        let symbols: Vec<_> = (0..self.coordinates).map(symbol).collect();
        let columns = self.graph.jacobian(&[along], &symbols);
        let slopes: Vec<_> = columns.into_iter().flatten().collect();
        let linear = |slope: &Expression| !self.graph.contents(*slope).has_velocity();
        if is_velocity && !slopes.iter().all(linear) {
            let message = format!(
                "`{}` is not linear in the velocities, so that no force gives power with it: a force acts on a \
                 coordinate, a position or a velocity",
                force.name
            );
            return self.reject(&force.name, message);
        }
        Some(slopes)
    }

    /// What a force acts on; that there is a coordinate or a definition of this name has been checked.
    fn target(&mut self, force: &Named) -> Option<Target> {
        let name = &force.name;
        let (kind, value) = match (self.scope.resolve(name)?, force.indices.as_slice()) {
            (Meaning::Quantity(kind, value), []) => (kind, value),
            (Meaning::Quantity(Kind::Coordinate, _), [index, ..]) => {
                let message = format!("`{name}` is one coordinate: leave out the index");
                return self.reject(index, message);
            }
            (Meaning::Quantity(..), [index, ..]) => {
                let message = format!("`{name}` has no index: write the force on the whole of it");
                return self.reject(index, message);
            }
            (Meaning::Family(kind, family), indices) if indices.len() == family.rank => {
                let member = self.member(indices)?;
                let Some(value) = family.members.get(&member) else {
                    let message = match kind {
                        Kind::Coordinate => hints::beyond(name, &member[0], family.members.len()),
                        _ => format!("`{}` is not defined", hints::member(name, &member)),
                    };
                    return self.reject(&indices[0], message);
                };
                (kind, value.clone())
            }
            (Meaning::Family(_, family), _) => {
                let message = format!(
                    "`{name}` is a family: write `{} = … for i in 0..{}`",
                    hints::member(name, &vec!["i"; family.rank]),
                    family.members.len()
                );
                return self.reject(name, message);
            }
            _ => return None,
        };
        if let Value::Scalar(expression) = value
            && let Node::Symbol(Symbol::Coordinate(i)) = self.graph.node(expression)
        {
            return Some(Target::Coordinate(*i as usize));
        }
        self.moved(force, kind, value).map(Target::Moved)
    }

    /// What a force can act on beside a coordinate.
    fn moved(&mut self, force: &Named, kind: Kind, value: Value) -> Option<Value> {
        if kind != Kind::Defined {
            return None;
        }
        let name = &force.name;
        if self.has_acceleration(&value) {
            let message = format!(
                "`{name}` contains accelerations: a force acts on a position or a velocity"
            );
            return self.reject(name, message);
        }
        let moves = |symbol| matches!(symbol, Symbol::Coordinate(_) | Symbol::Velocity(_));
        if !self.graph.contains(value.components(), moves) {
            let message = format!("no coordinate moves `{name}`: a force on it does no work");
            return self.reject(name, message);
        }
        Some(value)
    }
}
