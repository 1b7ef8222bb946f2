//! Indexing: members of families, components of vectors and matrices.

use lagrangian_symbolic::{TypedOperation, Value};
use proc_macro2::Ident;
use syn::{Expr, ExprField, Member};

use super::Lowerer;
use super::repetition::{as_name, without_parentheses};
use crate::lower::hints;
use crate::lower::scope::{Binding, Family, Origin};
use crate::syntax::label::Index;
use crate::syntax::shape::Shape;

impl Lowerer<'_> {
    /// `theta[i]`, `m[(i, j)]`, `rows[i][j]`.
    pub(super) fn indexed(&mut self, whole: &Expr) -> Option<Value> {
        let (base, indices) = base_and_indices(whole);
        let family = as_name(base).and_then(|name| Some((name, self.scope.resolve(name)?)));
        let (name, origin, family) = match family {
            Some((name, Binding::Family(origin, family))) => (name, origin, family),
            Some((name, Binding::DefinedLater)) => {
                let written = indices.first().and_then(|index| self.integer(index));
                if let Some(message) = self
                    .own_member(name, &[written?])
                    .or_else(|| self.circle(name))
                {
                    return self.reject(name, message);
                }
                let message = format!(
                    "no member of `{name}` is defined before this one: define the first of them first, as in \
                     `{name}[0] = …, {name}[i] = … for i in 1..5`"
                );
                return self.reject(name, message);
            }
            Some((name, Binding::Bodies(family))) => {
                self.body(whole)??;
                let message = hints::one_body(name, &family);
                return self.reject(whole, message);
            }
            _ => {
                let value = self.lower(base)?;
                return self.components(value, &indices);
            }
        };
        if indices.len() < family.rank {
            let message = format!(
                "`{name}` is told apart by {} indices: write `{name}{}`",
                family.rank,
                "[i]".repeat(family.rank)
            );
            return self.reject(whole, message);
        }
        let value = self.family_member(name, origin, &family, &indices)?;
        self.check_accelerations(name, origin, value)?;
        self.components(value, &indices[family.rank..])
    }

    /// The member of a family with the first of some indices, of which there are enough.
    pub(super) fn family_member<T: Clone>(
        &mut self,
        name: &Ident,
        origin: Origin,
        family: &Family<T>,
        indices: &[&Expr],
    ) -> Option<T> {
        let outer = &indices[..family.rank];
        let first = outer.first().map(|index| without_parentheses(index));
        if let Some(Expr::Tuple(pair)) = first {
            let message = format!(
                "the members of `{name}` are told apart by one index in each pair of brackets: write `{name}[i][j]`"
            );
            return self.reject(pair, message);
        }
        let member = outer.iter().map(|index| self.integer(index));
        let member: Vec<i64> = member.collect::<Option<_>>()?;
        let positions = member.iter().map(|i| usize::try_from(*i).ok());
        let positions: Option<Vec<usize>> = positions.collect();
        let found = positions.and_then(|positions| family.members.get(&positions).cloned());
        if found.is_none() {
            let itself = self.own_member(name, &member);
            let message = itself.unwrap_or_else(|| absent(name, origin, &member, family));
            return self.reject(outer.first(), message);
        }
        found
    }

    /// The component of a value at the indices that follow it.
    pub(crate) fn components(&mut self, value: Value, indices: &[&Expr]) -> Option<Value> {
        let Some((first, rest)) = indices.split_first() else {
            return Some(value);
        };
        if self.is_empty_sum(value) {
            return Some(value);
        }
        let shape = self.shape(value);
        let Shape::Array { rows, columns } = shape else {
            let message = format!("this is {shape}, which has no components: leave out the index");
            return self.reject(first, message);
        };
        let (row, column, rest) = match (without_parentheses(first), rest) {
            (Expr::Tuple(pair), rest) if pair.elems.len() == 2 => {
                let row = self.index_below(&pair.elems[0], rows, "rows", shape);
                let column = self.index_below(&pair.elems[1], columns, "columns", shape);
                (row?, column?, rest)
            }
            (row, [column, rest @ ..]) => {
                let row = self.index_below(row, rows, "rows", shape);
                let column = self.index_below(column, columns, "columns", shape);
                (row?, column?, rest)
            }
            (single, rest) if columns == 1 => (
                self.index_below(single, rows, "components", shape)?,
                0,
                rest,
            ),
            (single, rest) if rows == 1 => (
                0,
                self.index_below(single, columns, "components", shape)?,
                rest,
            ),
            (single, []) => {
                let message = format!(
                    "this is {shape}, whose entries have two indices: write `m[(i, j)]` for the entry in row i and \
                     column j, or `m.row(i)` and `m.column(j)`"
                );
                return self.reject(single, message);
            }
        };
        let component = self.add(TypedOperation::Element(value, column * rows + row))?;
        self.components(component, rest)
    }

    /// An index that counts from 0 and is below `end`.
    pub(super) fn index_below(
        &mut self,
        index: &Expr,
        end: usize,
        what: &str,
        shape: Shape,
    ) -> Option<usize> {
        let written = self.integer(index)?;
        match usize::try_from(written) {
            Ok(i) if i < end => Some(i),
            _ => {
                let message = format!(
                    "the index {written} is out of range: {shape} has {what} 0 to {}",
                    end.saturating_sub(1)
                );
                self.reject(index, message)
            }
        }
    }

    /// `v.x`, `v.y`, `v.z`, `v.w`.
    pub(super) fn field(&mut self, field: &ExprField) -> Option<Value> {
        let position = match &field.member {
            Member::Named(name) => Index::AXES.iter().position(|axis| name == axis),
            Member::Unnamed(_) => None,
        };
        if let Some(quantity) = self.quantity_of_body(&field.base, &field.member) {
            return quantity;
        }
        let is_self = matches!(&*field.base, Expr::Path(base) if base.path.is_ident("self"));
        let Some(position) = position.filter(|_| !is_self) else {
            return self.reject(field, hints::unsupported_field(field));
        };
        let value = self.lower(&field.base)?;
        if self.is_empty_sum(value) {
            return Some(value);
        }
        let shape = self.shape(value);
        let message = match shape {
            Shape::Array { rows, columns: 1 } if rows <= 4 && position < rows => {
                return self.add(TypedOperation::Element(value, position));
            }
            Shape::Array {
                rows: rows @ 2..=4,
                columns: 1,
            } => {
                let names = Index::AXES[..rows].join("`, `.");
                format!("this is {shape}: its components are `.{names}`")
            }
            _ => format!("this is {shape}, which has no such component"),
        };
        self.reject(&field.member, message)
    }
}

/// What stands before all indices behind an expression, and those, the first first.
pub(crate) fn base_and_indices(whole: &Expr) -> (&Expr, Vec<&Expr>) {
    let mut indices = Vec::new();
    let mut base = without_parentheses(whole);
    while let Expr::Index(inner) = base {
        indices.push(&*inner.index);
        base = without_parentheses(&inner.expr);
    }
    indices.reverse();
    (base, indices)
}

/// The message for a member that a family does not have.
fn absent<T>(name: &Ident, origin: Origin, member: &[i64], family: &Family<T>) -> String {
    let written = hints::member(name, member);
    match (origin, bounds(family)) {
        (Origin::Coordinate, _) => hints::out_of_range(name, member, family),
        (Origin::Field, _) => format!(
            "`{written}` is out of range: the array has {} members",
            family.members.len()
        ),
        (_, Some((first, last))) if family.rank == 1 => format!(
            "`{written}` is not defined here: what is defined before is `{name}[{first}]` to \
             `{name}[{last}]`"
        ),
        _ => format!("`{written}` is not defined here"),
    }
}

/// The least and the greatest index of a family that is distinguished by one.
fn bounds<T>(family: &Family<T>) -> Option<(usize, usize)> {
    let first = family.members.keys().next()?.first()?;
    let last = family.members.keys().next_back()?.first()?;
    Some((*first, *last))
}
