//! Impls of `Outputs` and `Events` without equations.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::Fallback;
use crate::emit::events;
use crate::emit::outputs::results;
use crate::plan::Interface;
use crate::syntax::names::{constant_name, unraw};
use crate::syntax::shape::Shape;

impl Fallback<'_> {
    pub(super) fn outputs(&self) -> TokenStream {
        let mut seen = BTreeSet::new();
        let declared = self.declaration.clauses.outputs.iter();
        let shapes = self.lowered.outputs.iter().copied();
        let names: Vec<(&Ident, Shape)> = declared
            .map(|output| &output.name)
            .zip(shapes)
            .filter(|(name, _)| seen.insert(unraw(name)))
            .collect();
        if names.is_empty() {
            return TokenStream::new();
        }
        let scalar = &self.scalar;
        let (results, definition) = results(self.declaration, scalar, &names);
        let items = quote!(type Outputs = #results<#scalar>;);
        let implementation = self.interface(Interface::Outputs, &items);
        quote!(#definition #implementation)
    }

    /// The constants of events, unless the names of some are taken.
    pub(super) fn event_constants(&self) -> TokenStream {
        let mut taken = self.taken.clone();
        let events = self.declaration.clauses.events.iter();
        let mut names = events.map(|event| constant_name(&event.name));
        if names.all(|name| taken.insert(name)) {
            events::constants(self.declaration, &self.lowered.events)
        } else {
            TokenStream::new()
        }
    }

    pub(super) fn events(&self) -> TokenStream {
        if self.lowered.events.is_empty() {
            return TokenStream::new();
        }
        let (scalar, count) = (&self.scalar, events::count(&self.lowered.events));
        let items = quote! {
            const EVENTS: &'static [&'static str] = &[""; #count];
            type EventValues = [#scalar; #count];
        };
        let events = self.interface(Interface::Events, &items);
        let impacts = self.interface(Interface::Impacts, &TokenStream::new());
        quote!(#events #impacts)
    }
}
