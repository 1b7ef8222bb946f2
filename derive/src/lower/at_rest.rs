//! The definitions of a declaration at rest: with all time derivatives zero.
//!
//! At rest a velocity does not depend on the coordinates: the velocity of a moving frame is a time derivative,
//! too, or a product ω × r as in (1.4), which belongs to the rate of r. The sum of a position and a velocity leaves the
//! position. As expressions of q and q̇ the two do not differ: hence the definitions are lowered once more, in
//! a graph of their own.

use core::mem;

use lagrangian_symbolic::Geometry;
use proc_macro2::Ident;

use crate::lower::expression::Lowerer;
use crate::lower::rest::Rest;
use crate::lower::scope::{Binding, Scope};
use crate::syntax::declaration::Declaration;

/// The definitions of a declaration at rest.
pub(super) struct AtRest {
    geometry: Geometry,
    scope: Scope,
    rest: Rest,
}

impl AtRest {
    /// Translates the definitions, all of which are free of errors.
    pub(super) fn new(lowerer: &mut Lowerer<'_>, declaration: &Declaration) -> Self {
        let mut geometry = Geometry::new();
        let scope = Scope::new(declaration, &mut geometry.graph);
        let mut at_rest = Self {
            geometry,
            scope,
            rest: Rest::default(),
        };
        // What has a value only in motion has no power at rest; that is no error of the user's.
        let before = mem::take(lowerer.diagnostics);
        let repetitions = mem::take(&mut lowerer.repetitions);
        at_rest.exchange(lowerer);
        lowerer.at_rest = Some(Rest::default());
        lowerer.declare_functions(&declaration.clauses.functions);
        for definition in &declaration.clauses.definitions {
            lowerer.define(definition);
        }
        let rest = lowerer.at_rest.take();
        at_rest.exchange(lowerer);
        at_rest.rest = rest.unwrap_or_default();
        lowerer.repetitions = repetitions;
        *lowerer.diagnostics = before;
        at_rest
    }

    fn exchange(&mut self, lowerer: &mut Lowerer<'_>) {
        mem::swap(&mut self.geometry, &mut lowerer.geometry);
        mem::swap(&mut self.scope, &mut lowerer.scope);
    }

    /// Whether a component of what is defined depends on coordinates at rest, as far as is known.
    pub(super) fn depends_on_position(
        &mut self,
        name: &Ident,
        member: &[usize],
        component: usize,
    ) -> bool {
        let value = match self.scope.resolve(name) {
            Some(Binding::Quantity(_, value)) => Some(value),
            Some(Binding::Family(_, family)) => family.members.get(member).cloned(),
            _ => None,
        };
        value.is_none_or(|value| {
            let components = value.components();
            self.rest
                .depends_on_position(&mut self.geometry.graph, components, component)
        })
    }
}
