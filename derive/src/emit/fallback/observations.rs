//! Impls of `Outputs` and `Events` without equations.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::Fallback;
use crate::emit::events;
use crate::emit::outputs::results;
use crate::emit::signatures::InputsFrom;
use crate::plan::Interface;
use crate::syntax::names::{constant_name, unraw};
use crate::syntax::shape::Shape;

impl Fallback<'_> {
    pub(super) fn outputs(&self) -> TokenStream {
        let root = &self.declaration.root;
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
        let (n, scalar) = (&self.dimension, &self.scalar);
        let (results, definition) = results(self.declaration, scalar, &names);
        let methods =
            |inputs| self.methods_where(inputs, |row| row.interface == Interface::Outputs);
        let method = methods(InputsFrom::Fields);
        let items = quote!(type Outputs = #results<#scalar>; #method);
        let interface = quote!(#root::Outputs<#n, #scalar>);
        let implementation = self.implement(&interface, Some(scalar), &items);
        let u = self.lowered.quantities.inputs.len();
        let with_inputs = (u > 0).then(|| {
            let interface = quote!(#root::OutputsWith<#n, #u, #scalar>);
            self.implement(&interface, Some(scalar), &methods(InputsFrom::Argument))
        });
        quote!(#definition #implementation #with_inputs)
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
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let count = events::count(&self.lowered.events);
        let methods = |inputs| self.methods_where(inputs, |row| row.interface == Interface::Events);
        let functions = methods(InputsFrom::Fields);
        let items = quote! {
            const EVENTS: &'static [&'static str] = &[""; #count];
            type EventValues = [#scalar; #count];
            #functions
        };
        let held = self.implement(&quote!(#root::Events<#n, #scalar>), Some(scalar), &items);
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return held;
        }
        let interface = quote!(#root::EventsWith<#n, #u, #scalar>);
        let functions = methods(InputsFrom::Argument);
        let with_inputs = self.implement(&interface, Some(scalar), &functions);
        quote!(#held #with_inputs)
    }
}
