//! Impls without equations, emitted beside errors.
//!
//! Code that uses the model then shows no errors of its own. Unresolved names are accessed as fields here, for
//! rust-analyzer alone, which completes them to the names of fields.

mod requested;

use core::ops::Range;
use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};

use super::editor;
use super::events;
use super::external_functions::{of_checks, signatures, values};
use super::inputs::{Indices, input_indices};
use super::outputs::results;
use super::routhian::reduced_without_equations;
use super::signatures::{InputsFrom, Signatures, method_name};
use crate::lower::Lowered;
use crate::plan::constants::{CONSTANTS, CONSTANTS_OF_EVENTS, CONSTANTS_OF_INPUTS};
use crate::plan::{EmittedMethod, Interface, MethodRow};
use crate::syntax::coordinate::{Coordinate, indices};
use crate::syntax::declaration::Declaration;
use crate::syntax::names::{constant_name, hygienic_ident, unraw};
use crate::syntax::scalar::Scalar;
use crate::syntax::shape::Shape;

/// Impls with the declared names and without equations.
pub(crate) fn items(declaration: &Declaration, lowered: &Lowered) -> TokenStream {
    let fallback = Fallback::new(declaration, lowered);
    [
        fallback.constants(),
        fallback.system(),
        fallback.lagrangian(),
        fallback.energies(),
        fallback.inputs(),
        fallback.outputs(),
        fallback.functions(),
        fallback.taylor_series(),
        fallback.events(),
        fallback.requested(),
        reduced_without_equations(declaration),
    ]
    .into_iter()
    .collect()
}

struct Fallback<'a> {
    declaration: &'a Declaration,
    lowered: &'a Lowered,
    /// Those with constants of their own.
    coordinates: Vec<(&'a Coordinate, Range<usize>)>,
    /// The same of inputs.
    inputs: Vec<(&'a Ident, Indices)>,
    /// The names of their constants, and of those that every model has.
    taken: BTreeSet<String>,
    /// How many coordinates there are. Where the declaration does not say it, a parameter of the impls:
    /// then states of any dimension fit.
    dimension: TokenStream,
    dimension_parameter: Option<TokenStream>,
    /// Unresolved names, which an editor may complete to those of fields.
    unknown: Vec<&'a Ident>,
    scalar: Scalar<'a>,
}

impl<'a> Fallback<'a> {
    fn new(declaration: &'a Declaration, lowered: &'a Lowered) -> Self {
        let scope = &lowered.scope;
        let declared = &declaration.clauses.coordinates;
        let mut taken: BTreeSet<String> = CONSTANTS.into_iter().map(str::to_owned).collect();
        if !lowered.events.is_empty() {
            taken.extend(CONSTANTS_OF_EVENTS.map(str::to_owned));
        }
        if !lowered.quantities.inputs.is_empty() {
            taken.extend(CONSTANTS_OF_INPUTS.map(str::to_owned));
        }
        let coordinates: Vec<_> = indices(declared)
            .filter(|(coordinate, _)| taken.insert(constant_name(&coordinate.name)))
            .collect();
        let inputs = input_indices(&lowered.quantities.inputs)
            .filter(|(field, _)| taken.insert(constant_name(field)))
            .collect();
        let certain = scope.complete && coordinates.len() == declared.len();
        let (dimension, dimension_parameter) = if certain {
            let count = lowered.quantities.coordinates.len();
            (count.to_token_stream(), None)
        } else {
            let parameter = Ident::new("__N", Span::mixed_site());
            (quote!(#parameter), Some(quote!(const #parameter: usize)))
        };
        let unknown = if declaration.names_fields {
            scope.unknown().collect()
        } else {
            Vec::new()
        };
        Self {
            declaration,
            lowered,
            coordinates,
            inputs,
            taken,
            dimension,
            dimension_parameter,
            unknown,
            scalar: Scalar::of(declaration),
        }
    }

    /// `impl<…> trait<…> for Model` with the parameters that the trait has.
    fn implement(
        &self,
        interface: &TokenStream,
        scalar: Option<&Scalar<'_>>,
        items: &TokenStream,
    ) -> TokenStream {
        self.implement_for(interface, scalar, items, None)
    }

    /// The same with one more parameter.
    fn implement_for(
        &self,
        interface: &TokenStream,
        scalar: Option<&Scalar<'_>>,
        items: &TokenStream,
        parameter: Option<&TokenStream>,
    ) -> TokenStream {
        let name = &self.declaration.name;
        let declared = &self.declaration.generics;
        let mut generics = match scalar {
            Some(scalar) => scalar.generics(declared),
            None => declared.clone(),
        };
        if let Some(dimension) = &self.dimension_parameter {
            generics.params.push(syn::parse_quote!(#dimension));
        }
        if let Some(parameter) = parameter {
            generics.params.push(syn::parse_quote!(#parameter));
        }
        let (generics, _, conditions) = generics.split_for_impl();
        let (_, arguments, _) = declared.split_for_impl();
        quote! {
            #[automatically_derived]
            impl #generics #interface for #name #arguments #conditions {
                #items
            }
        }
    }

    fn constants(&self) -> TokenStream {
        let root = &self.declaration.root;
        let name = &self.declaration.name;
        let visibility = &self.declaration.visibility;
        let (generics, arguments, conditions) = self.declaration.generics.split_for_impl();
        let n = self.lowered.quantities.coordinates.len();
        let mentions = editor::method(self.declaration);
        let names = &self.lowered.quantities.coordinates;
        let names = names.iter().map(ToString::to_string);
        let indices = self.coordinates.iter().map(|(coordinate, indices)| {
            let constant = hygienic_ident(&constant_name(&coordinate.name), &coordinate.name);
            let (ty, value) = coordinate.constant(indices.start);
            quote!(#visibility const #constant: #ty = #value;)
        });
        let u = self.lowered.quantities.inputs.len();
        let labels = self.lowered.quantities.inputs.iter();
        let labels = labels.map(|input| input.label.to_string());
        let inputs = (u > 0).then(|| {
            let indices = self.inputs.iter();
            let indices = indices.map(|(field, indices)| indices.constant(field));
            quote! {
                #visibility const INPUTS: [&'static str; #u] = [#(#labels),*];
                #(#visibility const #indices;)*
            }
        });
        let events = self.event_constants();
        quote! {
            impl #generics #name #arguments #conditions {
                #visibility const COORDINATES: [&'static str; #n] = [#(#names),*];
                #visibility const EQUATIONS: &'static str = "";
                #visibility const LATEX: &'static str = "";
                #visibility const OPERATIONS: #root::Operations = #root::Operations::NONE;
                #(#indices)*
                #inputs
                #events
                #mentions
            }
        }
    }

    fn system(&self) -> TokenStream {
        let root = &self.declaration.root;
        let n = &self.dimension;
        let names = quote!(const COORDINATES: [&'static str; #n] = [""; #n];);
        self.implement(&quote!(#root::GeneralizedCoordinates<#n>), None, &names)
    }

    fn lagrangian(&self) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let methods = self.methods_where(InputsFrom::Fields, |row| {
            row.interface == Interface::Lagrangian
        });
        let items = quote! {
            type Prepared = ();
            fn prepare(&self) {}
            #methods
        };
        let interface = quote!(#root::Lagrangian<#n, #scalar>);
        self.implement(&interface, Some(scalar), &items)
    }

    /// The energies, also beside a `lagrangian`: what is meant is not known.
    fn energies(&self) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let items = self.methods_where(InputsFrom::Fields, |row| {
            row.interface == Interface::Energies
        });
        let interface = quote!(#root::Energies<#n, #scalar>);
        self.implement(&interface, Some(scalar), &items)
    }

    /// What the types in signatures are made of.
    fn signatures(&self) -> Signatures<'_> {
        Signatures {
            root: &self.declaration.root,
            scalar: &self.scalar,
            dimension: self.dimension.clone(),
            inputs: self.lowered.quantities.inputs.len(),
            parameters: self.parameters().len(),
            base_parameters: requested::base_parameters().into_token_stream(),
            prepared: quote!(()),
        }
    }

    /// The methods of some rows, of which one looks for unknown names among the fields.
    fn methods_where(
        &self,
        inputs: InputsFrom,
        is_wanted: impl Fn(MethodRow) -> bool,
    ) -> TokenStream {
        let signatures = self.signatures();
        let (state, given) = (signatures.state(), signatures.inputs());
        let given = (inputs == InputsFrom::Argument).then(|| quote!(_: &#given,));
        let methods = EmittedMethod::ALL.iter();
        let methods =
            methods.filter(|method| is_wanted(method.row()) && method.row().takes_state());
        let methods = methods.map(|method| {
            let row = method.row();
            let variant = row.unprepared();
            let (name, output) = (method_name(variant, inputs), signatures.result(row.result));
            let others = signatures.parameters(variant);
            let others = others.iter().map(|(_, ty)| quote!(_: #ty,));
            let looks = *method == EmittedMethod::Forcing && inputs == InputsFrom::Fields;
            let unknown = self.unknown.iter().filter(|_| looks);
            let lookups = unknown.map(|name| quote!(#[cfg(rust_analyzer)] let _ = &self.#name;));
            let lints = looks.then(|| quote!(#[allow(unexpected_cfgs)]));
            quote! {
                #lints
                fn #name(&self, _: #state, #given #(#others)*) -> #output {
                    #(#lookups)*
                    ::core::unreachable!()
                }
            }
        });
        methods.collect()
    }

    fn inputs(&self) -> TokenStream {
        let root = &self.declaration.root;
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return TokenStream::new();
        }
        let (n, scalar) = (&self.dimension, &self.scalar);
        let inputs = self.signatures().inputs();
        let methods = self.methods_where(InputsFrom::Argument, MethodRow::is_of_inputs);
        let items = quote! {
            const INPUTS: [&'static str; #u] = [""; #u];
            fn inputs(&self) -> #inputs { ::core::unreachable!() }
            #methods
        };
        let interface = quote!(#root::Inputs<#n, #u, #scalar>);
        let inputs = self.implement(&interface, Some(scalar), &items);
        let of_parameters = self.scalar.of_parameters();
        let scalar = (!self.scalar.is_generic()).then_some(&self.scalar);
        let plant = self.implement(
            &quote!(#root::Plant<#n, #u>),
            scalar,
            &quote!(type Scalar = #of_parameters;),
        );
        quote!(#inputs #plant)
    }

    fn outputs(&self) -> TokenStream {
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

    fn functions(&self) -> TokenStream {
        let declaration = self.declaration;
        if declaration.clauses.functions.is_empty() {
            return TokenStream::new();
        }
        let root = &declaration.root;
        let name = &declaration.name;
        let scalar = of_checks(&self.scalar);
        let generics = if self.scalar.is_generic() {
            declaration.generics.clone()
        } else {
            self.scalar.generics(&declaration.generics)
        };
        let (generics, _, conditions) = generics.split_for_impl();
        let (_, arguments, _) = declaration.generics.split_for_impl();
        let signatures = signatures(declaration);
        let values = values(declaration, &self.scalar);
        quote! {
            impl #generics #name #arguments #conditions { #values }

            #[automatically_derived]
            impl #generics #root::ExternalFunctions for #name #arguments #conditions {
                type Scalar = #scalar;
                #signatures
                fn function(&self, _: usize, _: &[#scalar]) -> #scalar { ::core::unreachable!() }
                fn derivative(
                    &self, _: usize, _: usize, _: &[#scalar],
                ) -> ::core::option::Option<#scalar> { ::core::unreachable!() }
            }
        }
    }

    /// The constants of events, unless the names of some are taken.
    fn event_constants(&self) -> TokenStream {
        let mut taken = self.taken.clone();
        let events = self.declaration.clauses.events.iter();
        let mut names = events.map(|event| constant_name(&event.name));
        if names.all(|name| taken.insert(name)) {
            events::constants(self.declaration, &self.lowered.events)
        } else {
            TokenStream::new()
        }
    }

    fn events(&self) -> TokenStream {
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

    fn taylor_series(&self) -> TokenStream {
        if self.declaration.clauses.taylor.is_none() {
            return TokenStream::new();
        }
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let state = self.signatures().state();
        let rest = quote! {
            _: &(),
            _: #scalar,
            _: &mut #root::TaylorCoefficients<#root::Phase<#scalar, #n>, HALF>,
        };
        let items = quote! {
            fn taylor_series<const HALF: usize>(&self, _: #state, #rest) {
                ::core::unreachable!()
            }
        };
        let interface = quote!(#root::MotionSeries<#n, #scalar>);
        let held = self.implement(&interface, Some(scalar), &items);
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return held;
        }
        let inputs = self.signatures().inputs();
        let items = quote! {
            fn taylor_series_with<const HALF: usize>(&self, _: #state, _: &[#inputs], #rest) {
                ::core::unreachable!()
            }
        };
        let interface = quote!(#root::MotionSeriesWith<#n, #u, #scalar>);
        let with_inputs = self.implement(&interface, Some(scalar), &items);
        quote!(#held #with_inputs)
    }
}
