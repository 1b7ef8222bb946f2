//! From the clauses of constraints to their components.

use lagrangian_symbolic::{Constraint, Expression};
use proc_macro2::Ident;
use syn::{BinOp, Expr};

use crate::lower::constraints::{Constraints, DeclaredConstraint};
use crate::lower::expression::Lowerer;
use crate::syntax::clauses::Clauses;
use crate::syntax::named::NamedExpression;
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

/// The kind of a constraint.
type Kind = fn(Expression) -> Constraint;

impl Lowerer<'_> {
    /// The constraints; none if there are errors.
    pub(super) fn constraints(&mut self, clauses: &Clauses) -> Option<Constraints> {
        let mut constraints = Constraints::default();
        let mut understood = true;
        let kinds: [(_, Kind); 2] = [
            (&clauses.constraints, Constraint::Holonomic),
            (&clauses.nonholonomic, Constraint::Nonholonomic),
        ];
        for (named, kind) in kinds {
            for constraint in named {
                let done = self.for_each(&constraint.iterations, &mut |lowerer| {
                    lowerer.constraint(constraint, kind, &mut constraints)
                });
                understood &= done.is_some();
            }
        }
        understood.then_some(constraints)
    }

    fn constraint(
        &mut self,
        constraint: &NamedExpression,
        kind: Kind,
        constraints: &mut Constraints,
    ) -> Option<()> {
        self.check_not_bound(&constraint.name, &constraint.iterations)?;
        let member = self.member(&constraint.indices)?;
        if let Some(message) = of_comparison(&constraint.expression) {
            return self.reject(&constraint.expression, message);
        }
        let value = self.lower(&constraint.expression)?;
        let shape = self.shape(value);
        if let Shape::Array { columns: 2.., .. } = shape {
            let message = format!(
                "this is {shape}, and a constraint is a scalar or a vector that is zero: write its columns as constraints, \
                 each with a name"
            );
            return self.reject(&constraint.expression, message);
        }
        let mut declared = constraints.declared.iter();
        let name = unraw(&constraint.name);
        if declared.any(|other| unraw(&other.name) == name && other.member == member) {
            if member.is_empty() {
                // Reported by the check of names.
                return None;
            }
            let message = "this constraint is declared twice: leave one of them out";
            return self.reject(&constraint.name, message);
        }
        if self.is_empty_sum(value) {
            let message =
                "this is a sum without terms, which restricts nothing: remove the constraint";
            return self.reject(&constraint.expression, message);
        }
        constraints.declared.push(DeclaredConstraint {
            name: constraint.name.clone(),
            expression: constraint.expression.clone(),
            member,
            shape,
            value,
            is_holonomic: kind(self.typed.expression(value)).is_holonomic(),
            first: constraints.len(),
        });
        let components = self.elements(value).iter().copied();
        constraints.components.extend(components.map(kind));
        Some(())
    }

    /// Says that there is no constraint of a name, whose reaction or compliance is meant, and how one of the others is written.
    pub(super) fn no_constraint<T>(
        &mut self,
        name: &Ident,
        constraints: &Constraints,
        meant: &str,
        written: impl FnOnce(&str) -> String,
    ) -> Option<T> {
        let names = constraints.declared.iter().map(|one| unraw(&one.name));
        let mut names: Vec<_> = names.collect();
        names.dedup();
        let message = if names.is_empty() {
            format!(
                "there are no constraints, and so no {meant}: declare one by `constraint(name = …)`"
            )
        } else if let [known] = names.as_slice() {
            format!(
                "no constraint is called `{name}`: write `{}`",
                written(known)
            )
        } else {
            format!(
                "no constraint is called `{name}`: write one of `{}`",
                names.join("`, `")
            )
        };
        self.reject(name, message)
    }
}

/// What is written for an equation or an inequality.
fn of_comparison(expression: &Expr) -> Option<&'static str> {
    match expression {
        Expr::Assign(_) => Some(TWO_SIDES),
        Expr::Binary(binary) => match binary.op {
            BinOp::Eq(_) => Some(TWO_SIDES),
            BinOp::Le(_) | BinOp::Lt(_) | BinOp::Ge(_) | BinOp::Gt(_) => Some(
                "a constraint holds on both sides: a contact is declared by `event(name = …)` with the distance that becomes \
                 zero, to which a motion reacts, or is a spring under `force`, as in `-k * max(x - 1.0, 0.0)`",
            ),
            _ => None,
        },
        _ => None,
    }
}

const TWO_SIDES: &str = "a constraint is an expression that is zero: write the difference of both sides, `a - b` for a = b";
