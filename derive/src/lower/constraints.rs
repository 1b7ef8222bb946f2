//! Constraints, component by component, and their reactions.

use lagrangian_symbolic::{
    Constraint, ConstraintForces, Expression, Symbol, TypedOperation, Value,
};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::{BinOp, Expr};

use crate::lower::count;
use crate::lower::expression::{ExpressionContext, Lowerer, base_and_indices};
use crate::syntax::clauses::Clauses;
use crate::syntax::label::{Index, Label};
use crate::syntax::named::NamedExpression;
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

/// The kind of a constraint.
type Kind = fn(Expression) -> Constraint;

/// The constraints of a declaration, the holonomic ones first.
#[derive(Clone, Default)]
pub(crate) struct Constraints {
    /// One for each constraint or member of a family.
    pub(crate) declared: Vec<DeclaredConstraint>,
    /// Component by component.
    pub(crate) components: Vec<Constraint>,
    /// The compliances, component by component, if some are declared.
    pub(crate) compliances: Option<Vec<Expression>>,
}

/// A constraint, or a member of a family of constraints.
#[derive(Clone)]
pub(crate) struct DeclaredConstraint {
    pub(crate) name: Ident,
    pub(crate) expression: Expr,
    /// The indices of a member.
    pub(super) member: Vec<usize>,
    pub(super) shape: Shape,
    value: Value,
    is_holonomic: bool,
    /// The index of the first component.
    first: usize,
}

impl Constraints {
    /// How many components there are.
    pub(crate) fn len(&self) -> usize {
        self.components.len()
    }

    /// How many components are holonomic.
    pub(crate) fn holonomic(&self) -> usize {
        let components = self.components.iter();
        components
            .filter(|constraint| constraint.is_holonomic())
            .count()
    }

    /// The values that are zero, each with whether it is one of coordinates, and not of velocities.
    pub(crate) fn values(&self) -> Vec<(Value, bool)> {
        let declared = self.declared.iter();
        declared.map(|one| (one.value, one.is_holonomic)).collect()
    }

    /// The names of the components.
    pub(crate) fn labels(&self) -> Vec<Label> {
        let declared = self.declared.iter();
        declared.flat_map(DeclaredConstraint::labels).collect()
    }

    /// The constraint with a component.
    pub(crate) fn of_component(&self, component: usize) -> Option<&DeclaredConstraint> {
        let before = self
            .declared
            .iter()
            .take_while(|one| one.first <= component);
        before.last()
    }

    /// The names, each with the indices of its components and whether it has a single one.
    pub(crate) fn names(&self) -> Vec<(&Ident, Vec<usize>, bool)> {
        let mut names: Vec<(&Ident, Vec<usize>, bool)> = Vec::new();
        for one in &self.declared {
            let is_single = one.member.is_empty() && one.shape == Shape::Scalar;
            match names.last_mut() {
                Some((name, indices, _)) if unraw(name) == unraw(&one.name) => {
                    indices.extend(one.indices());
                }
                _ => names.push((&one.name, one.indices().collect(), is_single)),
            }
        }
        names
    }
}

impl DeclaredConstraint {
    pub(super) fn indices(&self) -> core::ops::Range<usize> {
        self.first..self.first + self.shape.count()
    }

    fn labels(&self) -> Vec<Label> {
        let components = 0..self.shape.count();
        components
            .map(|component| {
                let member = self.member.iter().copied().map(Index::One);
                Label {
                    stem: unraw(&self.name),
                    indices: member.chain(self.shape.index(component)).collect(),
                }
            })
            .collect()
    }
}

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
        let value = self.lower(&constraint.expression, ExpressionContext::Energy)?;
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
        let name = match base {
            Expr::Path(path) => path.path.get_ident(),
            _ => None,
        };
        let Some(name) = name else {
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
        let quantity = self.lower(written, ExpressionContext::Observation)?;
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
