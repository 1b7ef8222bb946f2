//! Constraints, component by component.

use lagrangian_symbolic::{Constraint, Expression, Value};
use proc_macro2::Ident;
use syn::Expr;

use crate::syntax::label::{Index, Label};
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

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
    pub(super) value: Value,
    pub(super) is_holonomic: bool,
    /// The index of the first component.
    pub(super) first: usize,
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
