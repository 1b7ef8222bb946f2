//! The impl of `Events`: the event functions and, with the clause `taylor`, their Taylor coefficients along a motion.

use core::ops::Range;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use super::parameters::{marked_if_unused, mentions};
use super::taylor_series::factor_pairs;
use crate::plan::{EventSeries, Interface, ParameterSource, ValueSeries};
use crate::syntax::declaration::Declaration;
use crate::syntax::names::{constant_name, hygienic_ident, unraw};
use crate::syntax::shape::Shape;

impl Emitter<'_> {
    /// The impl of `Events`, for a model that declares some.
    pub(super) fn events(&self) -> TokenStream {
        if self.methods.event_functions.is_none() {
            return TokenStream::new();
        }
        let scalar = &self.scalar;
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
        let series = self.series_of_events();
        self.interface(Interface::Events, quote!(#types #series))
    }

    /// The series of the events, if they have some.
    fn event_series(&self) -> Option<&EventSeries> {
        self.series?.events.as_ref()
    }

    /// The method that computes the series of the events, if they have series.
    fn series_of_events(&self) -> Option<TokenStream> {
        let series = self.event_series()?;
        let result = self.result_of_series();
        let body = self.body_of_series(&series.series);
        let value = quote!(::core::option::Option::Some({ #body }));
        Some(self.function_of_series(&quote!(event_series), true, None, &value, Some(&result)))
    }

    /// The method that visits the events in a step, for a model whose events have series.
    pub(super) fn events_in_step(&self) -> Option<TokenStream> {
        self.event_series()?;
        let (root, scalar) = (&self.declaration.root, &self.scalar);
        let (state, inputs) = (self.signatures().state(), self.signatures().inputs());
        let (prepared, others) = (self.signatures().prepared, self.parameters_of_series(true));
        Some(quote! {
            fn events_in_step<const HALF: usize, const OF_MOTION: usize>(
                &self,
                begin: (#state, &[#inputs]),
                prepared: &#prepared,
                #others
                end: (#state, &#inputs),
                visitor: (
                    #root::MetConditions,
                    &mut impl ::core::ops::FnMut(usize, &#root::TaylorCoefficients<#scalar, HALF>, #scalar),
                ),
            ) {
                #root::__private::visit_events(self, begin, prepared, (unit, motion), end, visitor);
            }
        })
    }

    /// A method that takes the series of a motion and of the inputs, whose body reads those. The order of its result may be
    /// lower than the order of the motion if `is_leading`.
    pub(super) fn function_of_series(
        &self,
        name: &TokenStream,
        is_leading: bool,
        more: Option<&TokenStream>,
        body: &TokenStream,
        result: Option<&TokenStream>,
    ) -> TokenStream {
        let (state, others) = (
            self.signatures().state(),
            self.parameters_of_series(is_leading),
        );
        let of_motion = is_leading.then(|| quote!(, const OF_MOTION: usize));
        let (inputs, orders) = self.series_of_inputs(body);
        let prepared = self.prepared_parameter(body);
        let result = result.map(|ty| quote!(-> #ty));
        quote! {
            fn #name<const HALF: usize #of_motion>(&self, state: #state, #inputs #prepared #others #more) #result {
                #orders
                #body
            }
        }
    }

    /// The parameter for the series of the inputs, and the statements that read it for a body.
    pub(super) fn series_of_inputs(
        &self,
        body: &TokenStream,
    ) -> (TokenStream, Option<TokenStream>) {
        let (root, vector) = (&self.declaration.root, self.signatures().inputs());
        if !self.has_inputs() {
            let none = mentions(body, "inputs");
            let none = none.then(|| quote!(let inputs = &#root::__private::vector([]);));
            return (quote!(_: &[#vector],), none);
        }
        let orders = quote! {
            let (inputs, mut higher_inputs) = #root::__private::orders(series_of_inputs);
            let inputs = &inputs;
        };
        (quote!(series_of_inputs: &[#vector],), Some(orders))
    }

    /// The parameter for the prepared array, for a body.
    pub(super) fn prepared_parameter(&self, body: &TokenStream) -> TokenStream {
        let prepared = self.signatures().prepared;
        marked_if_unused(quote!(prepared: &#prepared,), body)
    }

    pub(super) fn parameters_of_series(&self, is_leading: bool) -> TokenStream {
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let half = if is_leading {
            quote!(OF_MOTION)
        } else {
            quote!(HALF)
        };
        quote! {
            unit: #scalar,
            motion: &#root::TaylorCoefficients<#root::Phase<#scalar, #n>, #half>,
        }
    }

    fn result_of_series(&self) -> TokenStream {
        let root = &self.declaration.root;
        quote!(::core::option::Option<#root::TaylorCoefficients<Self::EventValues, HALF>>)
    }

    pub(super) fn body_of_series(&self, series: &ValueSeries) -> TokenStream {
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let next_inputs = self.next_inputs();
        self.with_writer(&series.initial, ParameterSource::Prepared, &[], |writer| {
            let (statements, values) = writer.compute(&series.values);
            let (more, invariants) = writer.compute(&series.invariants);
            let [(of_terms, terms), (of_factors, factors)] = self.recurrence(&series.program);
            let (convolutions, count_of_factors) =
                (&series.program.convolutions, series.program.factors());
            let count_of_pairs = convolutions.len();
            let pairs = factor_pairs(root, convolutions, count_of_pairs);
            let (count, events) = (invariants.len(), values.len());
            quote! {
                #statements
                let values = [#(#values),*];
                #more
                let invariants: [#scalar; #count] = [#(#invariants),*];
                #root::__private::event_series::<
                    _, #n, #events, #count_of_factors, #count_of_pairs, HALF, _,
                >(unit, motion, values, { #pairs }, |term| {
                    #next_inputs
                    #of_terms
                    let terms = [#(#terms),*];
                    #of_factors
                    (terms, [#(#factors),*])
                })
            }
        })
    }

    /// The statement that reads the inputs of the next order, in a model with inputs.
    pub(super) fn next_inputs(&self) -> Option<TokenStream> {
        let has_inputs = self.has_inputs();
        has_inputs.then(|| quote!(let term_of_inputs = higher_inputs.next();))
    }

    /// The names of the events and the events, as constants of the type.
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

/// The names of the events and the events, as constants of the type; nothing where there are no events.
pub(super) fn constants(declaration: &Declaration, shapes: &[Shape]) -> TokenStream {
    if shapes.is_empty() {
        return TokenStream::new();
    }
    let (root, visibility) = (&declaration.root, &declaration.visibility);
    let event = quote!(#root::DeclaredEvent);
    let names: Vec<String> = names(declaration, shapes).collect();
    let count = names.len();
    let constants = indices(declaration, shapes).map(|(name, shape, indices)| {
        let constant = hygienic_ident(&constant_name(name), name);
        let written = unraw(name);
        let start = indices.start;
        if shape == Shape::Scalar {
            let text = format!("The event `{written}`.");
            quote!(#[doc = #text] #visibility const #constant: #event<Self> = #event::new(#start);)
        } else {
            let text = format!("The events `{written}[0]` and so on.");
            let length = indices.len();
            quote! {
                #[doc = #text]
                #visibility const #constant: [#event<Self>; #length] = [#(#event::new(#indices)),*];
            }
        }
    });
    quote! {
        /// The names of the events, in order.
        #visibility const EVENTS: [&'static str; #count] = [#(#names),*];
        #(#constants)*
    }
}
