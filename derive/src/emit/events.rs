//! The impl of `Events`: the event functions and, with the clause `taylor`, their Taylor coefficients along a motion.

use core::ops::Range;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use super::signatures::InputsFrom;
use super::taylor_series::indices_of;
use crate::plan::{EventSeries, Interface, ValueSeries};
use crate::syntax::declaration::Declaration;
use crate::syntax::names::{constant_name, hygienic_ident, unraw};
use crate::syntax::shape::Shape;

impl Emitter<'_> {
    /// The impl of `Events`, for a model that declares some.
    pub(super) fn events(&self) -> TokenStream {
        if self.methods.event_functions.is_none() {
            return TokenStream::new();
        }
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let count = self.model.outputs.len() - count(&self.lowered.outputs);
        let types = quote! {
            const EVENTS: &'static [&'static str] = &Self::EVENTS;
            type EventValues = [#scalar; #count];
        };
        let branches = self
            .event_series()
            .map_or(&[][..], |series| &series.branches);
        let types = if branches.iter().any(|branches| !branches.is_empty()) {
            let lists = branches.iter().map(|branches| quote!(&[#(#branches),*]));
            quote!(#types const BRANCHES: &'static [&'static [usize]] = &[#(#lists),*];)
        } else {
            types
        };
        let methods = |inputs| self.methods_where(inputs, |row| row.interface == Interface::Events);
        let interface = quote!(#root::Events<#n, #scalar>);
        if !self.has_inputs() {
            let functions = methods(InputsFrom::Fields);
            let series = self.series_of_events(InputsFrom::Fields);
            return self.implement(&interface, &quote!(#types #functions #series));
        }
        let u = self.model.inputs as usize;
        let interface_with = quote!(#root::EventsWith<#n, #u, #scalar>);
        let functions = methods(InputsFrom::Argument);
        let series = self.series_of_events(InputsFrom::Argument);
        let with_inputs = self.implement(&interface_with, &quote!(#functions #series));
        let functions = self.delegations(Interface::Events);
        let series = self.series_of_held_inputs();
        let held = self.implement(&interface, &quote!(#types #functions #series));
        quote!(#with_inputs #held)
    }

    /// The series of the events, if they have some.
    fn event_series(&self) -> Option<&EventSeries> {
        self.series?.events.as_ref()
    }

    /// The method that computes the series of the events, if they have series.
    fn series_of_events(&self, inputs: InputsFrom) -> Option<TokenStream> {
        let series = self.event_series()?;
        let signature = self.parameters_of_series();
        let result = self.result_of_series();
        let body = self.body_of_series(&series.series, inputs);
        if inputs == InputsFrom::Fields {
            return Some(quote! {
                fn event_series<const HALF: usize>(&self, #signature) -> #result {
                    ::core::option::Option::Some({ #body })
                }
            });
        }
        let (root, vector) = (&self.declaration.root, self.signatures().inputs());
        Some(quote! {
            fn event_series_with<const HALF: usize>(
                &self, series_of_inputs: &[#vector], #signature
            ) -> #result {
                let (inputs, mut higher_inputs) = #root::__private::orders(series_of_inputs);
                let inputs = &inputs;
                ::core::option::Option::Some({ #body })
            }
        })
    }

    /// The method that computes the series of the events at the inputs of the fields, if they have series.
    fn series_of_held_inputs(&self) -> Option<TokenStream> {
        self.event_series()?;
        let (root, scalar) = (&self.declaration.root, &self.scalar);
        let (n, u) = (self.coordinates(), self.model.inputs as usize);
        let signature = self.parameters_of_series();
        let result = self.result_of_series();
        Some(quote! {
            fn event_series<const HALF: usize>(&self, #signature) -> #result {
                let held = [#root::Inputs::<#n, #u, #scalar>::inputs(self)];
                #root::EventsWith::<#n, #u, #scalar>::event_series_with(
                    self, &held, state, unit, motion,
                )
            }
        })
    }

    pub(super) fn parameters_of_series(&self) -> TokenStream {
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let state = self.signatures().state();
        quote! {
            state: #state,
            unit: #scalar,
            motion: &#root::TaylorCoefficients<#root::Phase<#scalar, #n>, HALF>,
        }
    }

    fn result_of_series(&self) -> TokenStream {
        let root = &self.declaration.root;
        quote!(::core::option::Option<#root::TaylorCoefficients<Self::EventValues, HALF>>)
    }

    pub(super) fn body_of_series(&self, series: &ValueSeries, inputs: InputsFrom) -> TokenStream {
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let next_inputs = (inputs == InputsFrom::Argument)
            .then(|| quote!(let term_of_inputs = higher_inputs.next();));
        self.with_writer(&series.initial, inputs, &[], |writer| {
            let (statements, values) = writer.compute(&series.values);
            let (more, invariants) = writer.compute(&series.invariants);
            let [(of_terms, terms), (of_factors, factors)] = self.recurrence(&series.program);
            let pairs: Vec<_> = series.program.convolutions.iter().map(indices_of).collect();
            let (count_of_pairs, count_of_factors) = (pairs.len(), series.program.factors());
            let (count, events) = (invariants.len(), values.len());
            quote! {
                #statements
                let values = [#(#values),*];
                #more
                let invariants: [#scalar; #count] = [#(#invariants),*];
                #root::__private::event_series::<
                    _, #n, #events, #count_of_factors, #count_of_pairs, HALF,
                >(unit, motion, values, &[#(#pairs),*], |term| {
                    #next_inputs
                    #of_terms
                    let terms = [#(#terms),*];
                    #of_factors
                    (terms, [#(#factors),*])
                })
            }
        })
    }

    /// The names of the events and their indices, as constants of the type.
    pub(super) fn event_constants(&self) -> TokenStream {
        constants(self.declaration, &self.lowered.events)
    }
}

/// How many events there are.
pub(super) fn count(shapes: &[Shape]) -> usize {
    shapes.iter().map(|shape| shape.count()).sum()
}

/// The declared events with their shapes and indices.
fn indices<'a>(
    declaration: &'a Declaration,
    shapes: &'a [Shape],
) -> impl Iterator<Item = (&'a Ident, Shape, Range<usize>)> {
    let events = declaration.clauses.events.iter().zip(shapes);
    events.scan(0, |next, (event, shape)| {
        let start = *next;
        *next += shape.count();
        Some((&event.name, *shape, start..*next))
    })
}

/// The names of the events, in order.
pub(super) fn names<'a>(
    declaration: &'a Declaration,
    shapes: &'a [Shape],
) -> impl Iterator<Item = String> + 'a {
    indices(declaration, shapes).flat_map(|(name, shape, indices)| {
        let name = unraw(name);
        let components = 0..indices.len();
        components.map(move |i| match shape.index(i) {
            None => name.clone(),
            Some(_) => format!("{name}[{i}]"),
        })
    })
}

/// The names of the events and their indices, as constants of the type; nothing where there are no events.
pub(super) fn constants(declaration: &Declaration, shapes: &[Shape]) -> TokenStream {
    if shapes.is_empty() {
        return TokenStream::new();
    }
    let visibility = &declaration.visibility;
    let names: Vec<String> = names(declaration, shapes).collect();
    let count = names.len();
    let constants = indices(declaration, shapes).map(|(name, shape, indices)| {
        let constant = hygienic_ident(&constant_name(name), name);
        let written = unraw(name);
        let start = indices.start;
        if shape == Shape::Scalar {
            let text = format!("The index of the event `{written}`.");
            quote!(#[doc = #text] #visibility const #constant: usize = #start;)
        } else {
            let text = format!("The indices of the events `{written}[0]` and so on.");
            let length = indices.len();
            quote!(#[doc = #text] #visibility const #constant: [usize; #length] = [#(#indices),*];)
        }
    });
    quote! {
        /// The names of the events, in order.
        #visibility const EVENTS: [&'static str; #count] = [#(#names),*];
        #(#constants)*
    }
}
