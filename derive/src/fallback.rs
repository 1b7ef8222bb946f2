//! What is emitted beside errors.
//!
//! An impl still stands, so that code which uses the model shows no errors of its own. Names that stand
//! for nothing are accessed as fields here, for rust-analyzer alone: it completes what is half typed by the
//! names of the fields.

use core::ops::Range;
use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

use crate::check::{CONSTANTS, CONSTANTS_OF_INPUTS};
use crate::coordinate::Coordinate;
use crate::declaration::Declaration;
use crate::implementation::{
    Indices, indices, input_indices, of_checks, results, signatures, values,
};
use crate::lower::Lowered;
use crate::mentions;
use crate::names::placed;
use crate::names::{constant, plain};
use crate::scalar::Scalar;
use crate::value::Shape;

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
    /// How many coordinates there are. Where the declaration does not say it, a parameter of the impls:
    /// then states of any dimension fit.
    dimension: TokenStream,
    dimension_parameter: Option<TokenStream>,
    /// Names that stand for nothing, which an editor may complete to those of fields.
    unknown: Vec<&'a Ident>,
    scalar: Scalar<'a>,
    vector: TokenStream,
    state: TokenStream,
}

impl<'a> Fallback<'a> {
    fn new(declaration: &'a Declaration, lowered: &'a Lowered) -> Self {
        let scope = &lowered.scope;
        let root = &declaration.root;
        let declared = &declaration.clauses.coordinates;
        let mut taken: BTreeSet<String> = CONSTANTS.into_iter().map(str::to_owned).collect();
        if !lowered.quantities.inputs.is_empty() {
            taken.extend(CONSTANTS_OF_INPUTS.map(str::to_owned));
        }
        let coordinates: Vec<_> = indices(declared)
            .filter(|(coordinate, _)| taken.insert(constant(&coordinate.name)))
            .collect();
        let inputs = input_indices(&lowered.quantities.inputs)
            .filter(|(field, _)| taken.insert(constant(field)))
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
        let scalar = Scalar::of(declaration);
        Self {
            declaration,
            lowered,
            coordinates,
            inputs,
            vector: quote!(#root::__private::SVector<#scalar, #dimension>),
            state: quote!(&#root::State<#scalar, #dimension>),
            dimension,
            dimension_parameter,
            unknown,
            scalar,
        }
    }

    /// `impl<…> trait<…> for Model` with the parameters that the trait has.
    fn implement(
        &self,
        interface: &TokenStream,
        scalar: Option<&Scalar<'_>>,
        items: &TokenStream,
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
        let mentions = mentions::method(self.declaration);
        let names = &self.lowered.quantities.coordinates;
        let names = names.iter().map(ToString::to_string);
        let indices = self.coordinates.iter().map(|(coordinate, indices)| {
            let constant = placed(&constant(&coordinate.name), &coordinate.name);
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
        quote! {
            impl #generics #name #arguments #conditions {
                #visibility const COORDINATES: [&'static str; #n] = [#(#names),*];
                #visibility const EQUATIONS: &'static str = "";
                #visibility const OPERATIONS: #root::Operations = #root::Operations::NONE;
                #(#indices)*
                #inputs
                #mentions
            }
        }
    }

    fn system(&self) -> TokenStream {
        let root = &self.declaration.root;
        let n = &self.dimension;
        let names = quote!(const COORDINATES: [&'static str; #n] = [""; #n];);
        self.implement(&quote!(#root::System<#n>), None, &names)
    }

    fn lagrangian(&self) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let (state, vector) = (&self.state, &self.vector);
        let driven = self.driven("", &TokenStream::new(), &self.unknown);
        let items = quote! {
            #driven
            type Prepared = ();
            fn prepare(&self) {}
            fn momenta(&self, _: #state) -> #vector { ::core::unreachable!() }
            fn mass_matrix(&self, _: #state) -> #root::__private::SMatrix<#scalar, #n, #n> {
                ::core::unreachable!()
            }
        };
        let interface = quote!(#root::Lagrangian<#n, #scalar>);
        self.implement(&interface, Some(scalar), &items)
    }

    /// The methods that inputs act on; one of them looks for `fields`.
    fn driven(&self, suffix: &str, inputs: &TokenStream, fields: &[&Ident]) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let (state, vector) = (&self.state, &self.vector);
        let method = |name: &str, output: &TokenStream| {
            let name = format_ident!("{name}{suffix}");
            quote!(fn #name(&self, _: #state, #inputs) -> #output { ::core::unreachable!() })
        };
        let scalars = ["lagrangian", "energy"].map(|name| method(name, &quote!(#scalar)));
        let vectors = ["generalized_forces", "accelerations"].map(|name| method(name, vector));
        let linearize = method("linearize", &quote!(#root::Linearization<#scalar, #n>));
        let forcing = format_ident!("forcing{suffix}");
        let inverse = format_ident!("inverse_dynamics{suffix}");
        quote! {
            #(#scalars)* #(#vectors)* #linearize
            #[allow(unexpected_cfgs)]
            fn #forcing(&self, _: #state, #inputs) -> #vector {
                #(#[cfg(rust_analyzer)] let _ = &self.#fields;)*
                ::core::unreachable!()
            }
            fn #inverse(&self, _: #state, #inputs _: &#vector) -> #vector { ::core::unreachable!() }
        }
    }

    /// The energies, also beside a `lagrangian`: what is meant is not known.
    fn energies(&self) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar, state) = (&self.dimension, &self.scalar, &self.state);
        let items = quote! {
            fn kinetic_energy(&self, _: #state) -> #scalar { ::core::unreachable!() }
            fn potential_energy(&self, _: #state) -> #scalar { ::core::unreachable!() }
        };
        let interface = quote!(#root::Energies<#n, #scalar>);
        self.implement(&interface, Some(scalar), &items)
    }

    fn inputs(&self) -> TokenStream {
        let root = &self.declaration.root;
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return TokenStream::new();
        }
        let (n, scalar, state) = (&self.dimension, &self.scalar, &self.state);
        let inputs = quote!(#root::__private::SVector<#scalar, #u>);
        let driven = self.driven("_with", &quote!(_: &#inputs,), &[]);
        let items = quote! {
            const INPUTS: [&'static str; #u] = [""; #u];
            fn inputs(&self) -> #inputs { ::core::unreachable!() }
            #driven
            fn input_jacobian_with(&self, _: #state, _: &#inputs)
                -> #root::__private::SMatrix<#scalar, #n, #u> { ::core::unreachable!() }
        };
        let interface = quote!(#root::Inputs<#n, #u, #scalar>);
        let inputs = self.implement(&interface, Some(scalar), &items);
        let of_parameters = self.scalar.of_parameters();
        let scalar = (!self.scalar.is_every()).then_some(&self.scalar);
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
            .filter(|(name, _)| seen.insert(plain(name)))
            .collect();
        if names.is_empty() {
            return TokenStream::new();
        }
        let (n, scalar, state) = (&self.dimension, &self.scalar, &self.state);
        let (results, definition) = results(self.declaration, scalar, &names);
        let items = quote! {
            type Outputs = #results<#scalar>;
            fn outputs(&self, _: #state) -> Self::Outputs { ::core::unreachable!() }
        };
        let interface = quote!(#root::Outputs<#n, #scalar>);
        let implementation = self.implement(&interface, Some(scalar), &items);
        let u = self.lowered.quantities.inputs.len();
        let with_inputs = (u > 0).then(|| {
            let inputs = quote!(#root::__private::SVector<#scalar, #u>);
            let items = quote! {
                fn outputs_with(&self, _: #state, _: &#inputs) -> Self::Outputs {
                    ::core::unreachable!()
                }
            };
            let interface = quote!(#root::OutputsWith<#n, #u, #scalar>);
            self.implement(&interface, Some(scalar), &items)
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
        let generics = if self.scalar.is_every() {
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
            impl #generics #root::Functions for #name #arguments #conditions {
                type Scalar = #scalar;
                #signatures
                fn function(&self, _: usize, _: &[#scalar]) -> #scalar { ::core::unreachable!() }
                fn derivative(
                    &self, _: usize, _: usize, _: &[#scalar],
                ) -> ::core::option::Option<#scalar> { ::core::unreachable!() }
            }
        }
    }
}
