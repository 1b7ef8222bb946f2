//! The compliances of constraints, which weigh the squares of multipliers where constraints are redundant.

use lagrangian_symbolic::{Expression, Rational, Symbol, Value};

use crate::lower::constraints::{Constraints, DeclaredConstraint};
use crate::lower::expression::Lowerer;
use crate::syntax::named::NamedExpression;
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

impl Lowerer<'_> {
    /// Adds the compliances to the constraints, as far as they are free of errors.
    pub(super) fn compliances(&mut self, compliances: &[NamedExpression]) {
        let Some(constraints) = self.known_constraints.clone() else {
            return;
        };
        let mut found = vec![None; constraints.len()];
        let mut understood = !compliances.is_empty();
        for compliance in compliances {
            let done = self.for_each(&compliance.iterations, &mut |lowerer| {
                lowerer.compliance(compliance, &constraints, &mut found)
            });
            understood &= done.is_some();
        }
        if understood && let Some(known) = &mut self.known_constraints {
            let one = self.typed.geometry.graph.constant(&Rational::ONE);
            let all = found.into_iter().map(|found| found.unwrap_or(one));
            known.compliances = Some(all.collect());
        }
    }

    fn compliance(
        &mut self,
        compliance: &NamedExpression,
        constraints: &Constraints,
        found: &mut [Option<Expression>],
    ) -> Option<()> {
        let name = &compliance.name;
        self.check_not_bound(name, &compliance.iterations)?;
        let member = self.member(&compliance.indices)?;
        let constraint = self.constraint_with_compliance(compliance, &member, constraints)?;
        let value = self.lower(&compliance.expression)?;
        let components = self.compliances_of(compliance, constraint, value)?;
        for (i, component) in constraint.indices().zip(components) {
            if found[i].replace(component).is_some() {
                let message = "this constraint has a compliance already: leave one of them out";
                return self.reject(name, message);
            }
        }
        Some(())
    }

    /// The constraint of which a compliance is declared.
    fn constraint_with_compliance<'a>(
        &mut self,
        compliance: &NamedExpression,
        member: &[usize],
        constraints: &'a Constraints,
    ) -> Option<&'a DeclaredConstraint> {
        let name = &compliance.name;
        let of_name = |one: &&DeclaredConstraint| unraw(&one.name) == unraw(name);
        let members: Vec<_> = constraints.declared.iter().filter(of_name).collect();
        let Some(first) = members.first() else {
            return self.no_constraint(name, constraints, "compliances", |known| {
                format!("compliance({known} = …)")
            });
        };
        if first.member.len() != member.len() {
            let message = if first.member.is_empty() {
                format!(
                    "`{name}` is one constraint: leave out the index; of a vector, write the vector of the compliances"
                )
            } else {
                format!(
                    "`{name}` is a family of constraints: write `{name}{} = …` with a compliance for each",
                    "[i]".repeat(first.member.len())
                )
            };
            return self.reject(name, message);
        }
        let constraint = members.iter().find(|one| one.member == member);
        if constraint.is_none() {
            let message = format!("there is no constraint `{name}` with this index");
            return self.reject(name, message);
        }
        constraint.copied()
    }

    /// A compliance for each component: a scalar stands for all of them, and a vector has one for each.
    fn compliances_of(
        &mut self,
        compliance: &NamedExpression,
        constraint: &DeclaredConstraint,
        value: Value,
    ) -> Option<Vec<Expression>> {
        let written = &compliance.expression;
        let components = match self.shape(value) {
            Shape::Scalar => vec![self.typed.expression(value); constraint.shape.count()],
            shape @ Shape::Array { .. } if shape == constraint.shape => {
                self.elements(value).to_vec()
            }
            shape @ Shape::Array { .. } => {
                let shape_of_constraint = constraint.shape;
                let message = format!(
                    "`{}` is {shape_of_constraint}: write one compliance for all components, or as many, and not {shape}",
                    compliance.name
                );
                return self.reject(written, message);
            }
        };
        let symbols = self.graph().symbols(&components);
        let is_other = |symbol: &Symbol| !matches!(symbol, Symbol::Parameter(_));
        if symbols.iter().any(is_other) {
            let message = "a compliance depends on parameters alone: write a positive number, such as `1.0 / k` with the \
                           stiffness of the part that holds the constraint";
            return self.reject(written, message);
        }
        let mut constants = components
            .iter()
            .filter_map(|x| self.graph().as_constant(*x));
        if constants.any(|constant| *constant <= Rational::ZERO) {
            let message = "a compliance is positive: a part that does not yield has a small one";
            return self.reject(written, message);
        }
        Some(components)
    }
}
