//! The impl of `Events`: the event functions and, with the clause `taylor`, their Taylor coefficients along a motion.

use core::ops::Range;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use super::signatures::InputsFrom;
use super::taylor_series::indices_of;
use crate::plan::{EventSeries, Interface};
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
        let count = count(&self.lowered.events);
        let functions =
            self.methods_where(InputsFrom::Fields, |row| row.interface == Interface::Events);
        let series = self
            .event_series
            .map(|series| self.series_of_events(series));
        let items = quote! {
            const EVENTS: &'static [&'static str] = &Self::EVENTS;
            type EventValues = [#scalar; #count];
            #functions
            #series
        };
        self.implement(&quote!(#root::Events<#n, #scalar>), &items)
    }

    fn series_of_events(&self, series: &EventSeries) -> TokenStream {
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let state = self.signatures().state();
        let body = self.with_writer(&series.initial, InputsFrom::Fields, &[], |writer| {
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
                    #of_terms
                    let terms = [#(#terms),*];
                    #of_factors
                    (terms, [#(#factors),*])
                })
            }
        });
        quote! {
            fn event_series<const HALF: usize>(
                &self,
                state: #state,
                unit: #scalar,
                motion: &#root::TaylorCoefficients<#root::Phase<#scalar, #n>, HALF>,
            ) -> ::core::option::Option<#root::TaylorCoefficients<Self::EventValues, HALF>> {
                ::core::option::Option::Some({ #body })
            }
        }
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
