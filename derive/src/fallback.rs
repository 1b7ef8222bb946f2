//! What is emitted beside errors.
//!
//! An impl still stands, so that code which uses the model shows no errors of its own. Names that stand
//! for nothing are accessed as fields here, where the user wrote them: the compiler then says that there
//! is no such field, and which there are.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::declaration::{Declaration, Role};
use crate::names::{constant, plain};
use crate::scope::Scope;

/// Impls with the declared names and without equations.
pub(crate) fn items(declaration: &Declaration, scope: Option<&Scope>) -> TokenStream {
    let name = &declaration.name;
    let mut seen = BTreeSet::new();
    let coordinates: Vec<&Ident> = declaration
        .clauses
        .coordinates
        .iter()
        .filter(|coordinate| seen.insert(constant(coordinate)))
        .collect();
    let n = coordinates.len();
    let names = coordinates.iter().map(|coordinate| plain(coordinate));
    let indices = coordinates.iter().enumerate().map(|(i, coordinate)| {
        let constant = Ident::new(
            &constant(coordinate),
            Span::mixed_site().located_at(coordinate.span()),
        );
        quote!(pub const #constant: usize = #i;)
    });
    let fields: Vec<&Ident> = scope.into_iter().flat_map(Scope::unknown).collect();
    let (generics, arguments, conditions) = declaration.generics.split_for_impl();
    let lagrangian = lagrangian(declaration, n, &fields);
    quote! {
        #[automatically_derived]
        #[allow(missing_docs, dead_code)]
        impl #generics #name #arguments #conditions {
            pub const COORDINATES: [&'static str; #n] = [#(#names),*];
            pub const EQUATIONS: &'static str = "";
            pub const OPERATIONS: ::lagrangian::Operations = ::lagrangian::Operations::NONE;
            #(#indices)*
        }

        #[automatically_derived]
        impl #generics ::lagrangian::System<#n> for #name #arguments #conditions {
            const COORDINATES: [&'static str; #n] = Self::COORDINATES;
        }

        #lagrangian
    }
}

fn lagrangian(declaration: &Declaration, n: usize, fields: &[&Ident]) -> TokenStream {
    let name = &declaration.name;
    let mut generics = declaration.generics.clone();
    generics
        .params
        .push(syn::parse_quote!(__S: ::lagrangian::Scalar));
    let (generics, _, _) = generics.split_for_impl();
    let (_, arguments, conditions) = declaration.generics.split_for_impl();
    let state = quote!(&::lagrangian::State<__S, #n>);
    let vector = quote!(::lagrangian::__private::SVector<__S, #n>);
    let u = declaration.fields_with(Role::Input).count();
    let driven = |suffix: &str, inputs: TokenStream, fields: &[&Ident]| {
        let method = |name: &str, output: TokenStream| {
            let name = quote::format_ident!("{name}{suffix}");
            quote!(fn #name(&self, _: #state, #inputs) -> #output { ::core::unreachable!() })
        };
        let scalars = ["lagrangian", "energy"].map(|name| method(name, quote!(__S)));
        let vectors =
            ["generalized_forces", "accelerations"].map(|name| method(name, vector.clone()));
        let forcing = quote::format_ident!("forcing{suffix}");
        let inverse = quote::format_ident!("inverse_dynamics{suffix}");
        let linearize = method("linearize", quote!(::lagrangian::Linearization<__S, #n>));
        quote! {
            #(#scalars)* #(#vectors)* #linearize
            fn #forcing(&self, _: #state, #inputs) -> #vector {
                #(let _ = &self.#fields;)*
                ::core::unreachable!()
            }
            fn #inverse(&self, _: #state, #inputs _: &#vector) -> #vector { ::core::unreachable!() }
        }
    };
    let plain = driven("", TokenStream::new(), fields);
    let with_inputs = (u > 0).then(|| {
        let inputs = quote!(::lagrangian::__private::SVector<__S, #u>);
        let driven = driven("_with", quote!(_: &#inputs,), &[]);
        quote! {
            #[automatically_derived]
            impl #generics ::lagrangian::Inputs<#n, #u, __S> for #name #arguments #conditions {
                const INPUTS: [&'static str; #u] = [""; #u];
                fn inputs(&self) -> #inputs { ::core::unreachable!() }
                #driven
                fn input_jacobian_with(&self, _: #state, _: &#inputs)
                    -> ::lagrangian::__private::SMatrix<__S, #n, #u> { ::core::unreachable!() }
            }
        }
    });
    quote! {
        #[automatically_derived]
        impl #generics ::lagrangian::Lagrangian<#n, __S> for #name #arguments #conditions {
            #plain
            fn momenta(&self, _: #state) -> #vector { ::core::unreachable!() }
            fn mass_matrix(&self, _: #state) -> ::lagrangian::__private::SMatrix<__S, #n, #n> {
                ::core::unreachable!()
            }
        }

        #[automatically_derived]
        impl #generics ::lagrangian::Energies<#n, __S> for #name #arguments #conditions {
            fn kinetic_energy(&self, _: #state) -> __S { ::core::unreachable!() }
            fn potential_energy(&self, _: #state) -> __S { ::core::unreachable!() }
        }

        #with_inputs
    }
}
