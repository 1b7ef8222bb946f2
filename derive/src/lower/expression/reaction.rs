//! The reactions of constraints.

use lagrangian_symbolic::{ConstraintForces, Symbol, TypedOperation, Value};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::Expr;

use super::Lowerer;
use super::component::base_and_indices;
use super::repetition::as_name;
use crate::lower::constraints::DeclaredConstraint;
use crate::lower::count;
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

impl Lowerer<'_> {
    /// `reaction(name)`: the multipliers of a constraint, in its shape; `reaction(name, quantity)`: the force or moment of the
    /// constraint on a position, an angle or a rotation that it contains.
    pub(super) fn reaction(&mut self, call: &impl ToTokens, arguments: &[&Expr]) -> Option<Value> {
        let (argument, quantity) = match arguments {
            [argument] => (argument, None),
            [argument, quantity] => (argument, Some(*quantity)),
            _ => {
                let message = "`reaction` takes the name of a constraint, and of what it acts on: write `reaction(name)`, or \
                               `reaction(name, p)` for its force on a position p";
                return self.reject(call, message);
            }
        };
        let (name, constraint, of_component) = self.reacting(call, argument)?;
        let multipliers = constraint.indices().map(|i| {
            let index = self.coordinates + count(i);
            self.add(TypedOperation::Symbol(Symbol::Acceleration(index)))
        });
        let elements: Vec<_> = multipliers.collect::<Option<_>>()?;
        let value = match constraint.shape {
            Shape::Scalar => *elements.first()?,
            Shape::Array { rows, .. } => self.add(TypedOperation::Array { rows, elements })?,
        };
        let Some(quantity) = quantity else {
            return self.components(value, &of_component);
        };
        if let Some(index) = of_component.first() {
            let message = format!(
                "a force is of all components of a constraint: write `reaction({name}, …)` without this index"
            );
            return self.reject(index, message);
        }
        let forces = ConstraintForces {
            constraint: constraint.value,
            is_holonomic: constraint.is_holonomic,
            multipliers: self.elements(value).to_vec(),
        };
        self.force_on(&forces, name, quantity)
    }

    /// The name of the constraint, or of a member of a family, that an expression refers to, the constraint, and the indices of a
    /// component behind it.
    fn reacting<'a>(
        &mut self,
        call: &impl ToTokens,
        argument: &'a Expr,
    ) -> Option<(&'a Ident, DeclaredConstraint, Vec<&'a Expr>)> {
        let (base, indices) = base_and_indices(argument);
        let Some(name) = as_name(base) else {
            let message = "`reaction` takes the name of a constraint: write `reaction(name)`";
            return self.reject(argument, message);
        };
        let Some(constraints) = self.known_constraints.clone() else {
            let message = "a reaction is found together with the accelerations, so that no energy, force or definition contains it: \
                           write `reaction(name)` under `output` or `event`";
            return self.reject(call, message);
        };
        let of_name = |one: &&DeclaredConstraint| unraw(&one.name) == unraw(name);
        let members: Vec<_> = constraints.declared.iter().filter(of_name).collect();
        let Some(first) = members.first() else {
            return self.no_constraint(name, &constraints, "reactions", |known| {
                format!("reaction({known})")
            });
        };
        let rank = first.member.len();
        if indices.len() < rank {
            let message = format!(
                "`{name}` is a family of constraints: write one of them, as in `reaction({name}{})`",
                "[i]".repeat(rank)
            );
            return self.reject(argument, message);
        }
        let (of_member, of_component) = indices.split_at(rank);
        let member: Vec<i64> = of_member
            .iter()
            .map(|i| self.integer(i))
            .collect::<Option<_>>()?;
        let is_meant = |one: &DeclaredConstraint| {
            let indices = one.member.iter().map(|i| i64::try_from(*i).ok());
            indices.eq(member.iter().map(|i| Some(*i)))
        };
        let Some(constraint) = members.into_iter().find(|one| is_meant(one)) else {
            let message = format!("there is no constraint `{name}` with this index");
            return self.reject(argument, message);
        };
        Some((name, constraint.clone(), of_component.to_vec()))
    }

    /// The force of a constraint on a quantity that it contains.
    fn force_on(
        &mut self,
        forces: &ConstraintForces,
        name: &Ident,
        written: &Expr,
    ) -> Option<Value> {
        let quantity = self.lower_with_accelerations(written)?;
        if let Shape::Array {
            rows,
            columns: columns @ 2..,
        } = self.shape(quantity)
            && (rows, columns) != (3, 3)
        {
            let message = format!(
                "a constraint acts on a position, an angle or a rotation, which is a 3×3 matrix, and this is {}",
                self.shape(quantity)
            );
            return self.reject(written, message);
        }
        let force = self.typed.force_on(forces, quantity);
        if force.is_none() {
            let message = format!(
                "`{name}` does not contain this quantity as it is defined: write the name of a definition or coordinate of which the \
                 constraint is made"
            );
            return self.reject(written, message);
        }
        force
    }
}
