//! Impls without equations, emitted beside errors.
//!
//! Code that uses the model then shows no errors of its own. Unresolved names are accessed as fields here, for
//! rust-analyzer alone, which completes them to the names of fields.

mod constraints;
mod functions;
mod observations;
mod requested;
mod routhian;
mod taylor_series;

use core::ops::Range;
use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::editor;
use super::implementation;
use super::inputs::{Indices, input_indices};
use super::members_in_lanes::members_in_lanes;
use super::signatures::Signatures;
use crate::lower::Lowered;
use crate::plan::constants::constants;
use crate::plan::{EmittedMethod, Interface};
use crate::syntax::coordinate::{Coordinate, indices};
use crate::syntax::declaration::Declaration;
use crate::syntax::names::{constant_name, hygienic_ident};
use crate::syntax::scalar::Scalar;
pub(crate) use routhian::reduced_without_equations;

/// Impls with the declared names and without equations, and those of the reduced model if there is to be one.
pub(crate) fn items(declaration: &Declaration, lowered: &Lowered) -> TokenStream {
    let own = Fallback::new(declaration, lowered).items();
    let reduced = reduced_without_equations(declaration, lowered, None);
    quote!(#own #reduced)
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
        let constants = constants(declaration);
        let mut taken: BTreeSet<String> = constants.map(|(name, _)| name.to_owned()).collect();
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

    fn items(&self) -> TokenStream {
        [
            self.constants(),
            self.system(),
            self.quantities(),
            self.state_jacobian(),
            self.constraints(),
            self.energies(),
            self.inputs(),
            self.outputs(),
            self.functions(),
            self.taylor_series(),
            self.events(),
            self.requested(),
            self.reflect(),
        ]
        .into_iter()
        .collect()
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
        implementation::of_trait(self.declaration, &generics, interface, items)
    }

    fn constants(&self) -> TokenStream {
        let root = &self.declaration.root;
        let visibility = &self.declaration.visibility;
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
            let values = self.on_own_scalar(&quote!(inputs), u);
            quote! {
                #visibility const INPUTS: [&'static str; #u] = [#(#labels),*];
                #(#visibility const #indices;)*
                #values
            }
        });
        let events = self.event_constants();
        let constraints = self.constraint_constants();
        let requested = self.requested_constants();
        let items = quote! {
            #visibility const COORDINATES: [&'static str; #n] = [#(#names),*];
            #visibility const EQUATIONS: &'static str = "";
            #visibility const LATEX: &'static str = "";
            #visibility const OPERATIONS: #root::Operations = #root::Operations::NONE;
            #(#indices)*
            #inputs
            #events
            #constraints
            #requested
            #mentions
        };
        implementation::inherent(self.declaration, &self.declaration.generics, &items)
    }

    /// A method of the type on the scalar of the parameters, as models with equations have it.
    fn on_own_scalar(&self, method: &TokenStream, count: usize) -> TokenStream {
        let Declaration {
            root, visibility, ..
        } = self.declaration;
        let scalar = self.scalar.of_parameters();
        quote! {
            #visibility fn #method(&self) -> #root::__private::SVector<#scalar, #count> {
                ::core::unreachable!()
            }
        }
    }

    fn system(&self) -> TokenStream {
        let root = &self.declaration.root;
        let n = &self.dimension;
        let names = quote!(const COORDINATES: [&'static str; #n] = [""; #n];);
        self.implement(&quote!(#root::GeneralizedCoordinates<#n>), None, &names)
    }

    fn quantities(&self) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let inputs = self.signatures().inputs();
        let items = quote! {
            type Inputs = #inputs;
            type Prepared = [#scalar; 0];
            fn inputs(&self) -> #inputs { ::core::unreachable!() }
            fn prepare(&self) -> [#scalar; 0] { [] }
        };
        let quantities = self.interface(Interface::Quantities, &items);
        let lagrangian = self.implement(
            &quote!(#root::Lagrangian<#n, #scalar>),
            Some(scalar),
            &quote! {
                type Model = Self;
                fn model(&self) -> &Self { ::core::unreachable!() }
            },
        );
        let members = members_in_lanes(self.declaration, scalar, false);
        quote!(#quantities #lagrangian #members)
    }

    /// The impl of a trait of the table: these items, and its methods. How many base parameters there are is not known: any number
    /// fits.
    fn interface(&self, interface: Interface, items: &TokenStream) -> TokenStream {
        let methods = self.methods_of(interface);
        let path = self.signatures().interface(interface);
        let count = requested::base_parameters();
        let parameter = (interface == Interface::Regressor).then(|| quote!(const #count: usize));
        let items = quote!(#items #methods);
        self.implement_for(&path, Some(&self.scalar), &items, parameter.as_ref())
    }

    fn inputs(&self) -> TokenStream {
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return TokenStream::new();
        }
        let names = quote!(const INPUTS: [&'static str; #u] = [""; #u];);
        self.interface(Interface::Inputs, &names)
    }

    /// Also beside constraints: what is meant is not known.
    fn state_jacobian(&self) -> TokenStream {
        self.interface(Interface::StateJacobian, &TokenStream::new())
    }

    /// The energies, also beside a `lagrangian`: what is meant is not known.
    fn energies(&self) -> TokenStream {
        self.interface(Interface::Energies, &TokenStream::new())
    }

    /// What the types in signatures are made of.
    fn signatures(&self) -> Signatures<'_> {
        let scalar = &self.scalar;
        Signatures {
            root: &self.declaration.root,
            scalar,
            dimension: self.dimension.clone(),
            inputs: Literal::usize_unsuffixed(self.lowered.quantities.inputs.len()),
            parameters: Literal::usize_unsuffixed(self.parameters().len()),
            constraints: Literal::usize_unsuffixed(self.lowered.constraints.len()),
            base_parameters: requested::base_parameters().into_token_stream(),
            prepared: quote!([#scalar; 0]),
        }
    }

    /// The methods of a trait, of which one looks for unknown names among the fields.
    fn methods_of(&self, interface: Interface) -> TokenStream {
        let signatures = self.signatures();
        let state = signatures.state();
        let methods = EmittedMethod::ALL.iter();
        let methods = methods.filter(|method| {
            let row = method.row();
            row.interface == interface && row.takes_state()
        });
        let methods = methods.map(|method| {
            let row = method.row();
            let (name, output) = (format_ident!("{}", row.name), signatures.result(row.result));
            let others = signatures.parameters(row);
            let others = others.iter().map(|(_, ty)| quote!(_: #ty,));
            let looks = *method == EmittedMethod::Forcing;
            let unknown = self.unknown.iter().filter(|_| looks);
            let lookups = unknown.map(|name| quote!(#[cfg(rust_analyzer)] let _ = &self.#name;));
            let lints = looks.then(|| quote!(#[allow(unexpected_cfgs)]));
            quote! {
                #lints
                fn #name(&self, _: #state, #(#others)*) -> #output {
                    #(#lookups)*
                    ::core::unreachable!()
                }
            }
        });
        methods.collect()
    }
}
