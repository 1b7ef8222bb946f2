//! External functions: a method for the value and each derivative, and the impl of `ExternalFunctions`.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use syn::Expr;

use super::emitter::Emitter;
use super::implementation;
use super::item_names::{derivative_name, value_name};
use super::parameters::marked_if_unused;
use crate::plan::ParameterSource;
use crate::syntax::declaration::Declaration;
use crate::syntax::external_function::FunctionDeclaration;
use crate::syntax::names::unraw;
use crate::syntax::scalar::Scalar;

impl Emitter<'_> {
    pub(super) fn functions(&self) -> TokenStream {
        let declared = &self.declaration.clauses.functions;
        if declared.is_empty() {
            return TokenStream::new();
        }
        let values = values(self.declaration, &self.scalar);
        let derivatives = self.derivatives();
        let generics = &self.declaration.generics;
        let items = quote!(#values #derivatives);
        let own = implementation::inherent(self.declaration, generics, &items);
        let interface = self.external_functions();
        quote!(#own #interface)
    }

    /// A method for each declared derivative, of all arguments at once.
    fn derivatives(&self) -> TokenStream {
        let scalar = &self.scalar;
        let declared = &self.declaration.clauses.functions;
        let derivatives = self.methods.functions.iter().map(|derivative| {
            let function = &declared[derivative.function];
            let name = derivative_name(function, derivative.argument);
            let count = function.arguments.len();
            let parameters = parameters(scalar, &quote!(#scalar), self.declaration);
            let (method, names) = (&derivative.method, &function.arguments);
            let body = self.body(method, ParameterSource::Fields, names);
            let arguments = quote!(arguments: [#scalar; #count]);
            let arguments = marked_if_unused(arguments, &body);
            quote! {
                #[inline]
                fn #name #parameters(&self, #arguments) -> #scalar {
                    #body
                }
            }
        });
        derivatives.collect()
    }

    fn external_functions(&self) -> TokenStream {
        let root = &self.declaration.root;
        let declared = &self.declaration.clauses.functions;
        let values = declared.iter().enumerate().map(|(i, function)| {
            let (i, name) = (Literal::usize_unsuffixed(i), value_name(function));
            let arguments: Vec<Ident> = arguments(function);
            quote!((#i, &[#(#arguments),*]) => self.#name(#(#arguments),*))
        });
        let derivatives = self.methods.functions.iter().map(|derivative| {
            let function = &declared[derivative.function];
            let name = derivative_name(function, derivative.argument);
            let [i, j] = [derivative.function, derivative.argument].map(Literal::usize_unsuffixed);
            let arguments: Vec<Ident> = arguments(function);
            quote! {
                (#i, #j, &[#(#arguments),*]) => {
                    ::core::option::Option::Some(self.#name([#(#arguments),*]))
                }
            }
        });
        let scalar = of_checks(&self.scalar);
        let signatures = signatures(self.declaration);
        let items = quote! {
            type Scalar = #scalar;
            #signatures
            fn function(&self, function: usize, arguments: &[#scalar]) -> #scalar {
                match (function, arguments) {
                    #(#values,)*
                    _ => <#scalar as #root::Scalar>::from_f64(::core::primitive::f64::NAN),
                }
            }
            fn derivative(
                &self,
                function: usize,
                argument: usize,
                arguments: &[#scalar],
            ) -> ::core::option::Option<#scalar> {
                match (function, argument, arguments) {
                    #(#derivatives)*
                    _ => ::core::option::Option::None,
                }
            }
        };
        let interface = quote!(#root::ExternalFunctions);
        let generics = &self.declaration.generics;
        implementation::of_trait(self.declaration, generics, &interface, &items)
    }
}

/// A method for the value of each function: the user's expression, with the user's names for the arguments.
pub(crate) fn values(declaration: &Declaration, scalar: &Scalar<'_>) -> TokenStream {
    // The compiler's errors call it by this name.
    let any = Ident::new("AnyScalar", Span::mixed_site());
    let ty = if scalar.is_generic() {
        quote!(#any)
    } else {
        quote!(#scalar)
    };
    let mut once = BTreeSet::new();
    let declared = declaration.clauses.functions.iter();
    // Where two have one name, that has been reported.
    let declared = declared.filter(|function| once.insert(unraw(&function.name)));
    let values = declared
        .filter(|function| are_distinct(&function.arguments))
        .map(|function| {
            let name = value_name(function);
            let this = receiver(&function.value);
            let (arguments, value) = (&function.arguments, &function.value);
            let parameters = parameters(scalar, &ty, declaration);
            quote! {
                #[inline]
                fn #name #parameters(&#this #(, #arguments: #ty)*) -> #ty {
                    #value
                }
            }
        });
    values.collect()
}

fn are_distinct(names: &[Ident]) -> bool {
    let distinct: BTreeSet<String> = names.iter().map(unraw).collect();
    distinct.len() == names.len()
}

/// The parameter `self` with the hygiene of the value: in a value that a macro has expanded to, `self` differs from
/// that elsewhere.
fn receiver(value: &Expr) -> Ident {
    fn find(tokens: TokenStream) -> Option<Ident> {
        tokens.into_iter().find_map(|token| match token {
            TokenTree::Ident(name) if name == "self" => Some(name),
            TokenTree::Group(group) => find(group.stream()),
            _ => None,
        })
    }
    let found = find(value.to_token_stream());
    found.unwrap_or_else(|| Ident::new("self", Span::call_site()))
}

/// The parameters of a method on the scalar, outside of the impls that are.
fn parameters(
    scalar: &Scalar<'_>,
    ty: &TokenStream,
    declaration: &Declaration,
) -> Option<TokenStream> {
    let root = &declaration.root;
    scalar.is_generic().then(|| quote!(<#ty: #root::Scalar>))
}

/// The scalar on which derivatives are checked.
pub(crate) fn of_checks(scalar: &Scalar<'_>) -> TokenStream {
    if scalar.is_generic() {
        quote!(::core::primitive::f64)
    } else {
        quote!(#scalar)
    }
}

/// The names of all functions and their arguments.
pub(crate) fn signatures(declaration: &Declaration) -> TokenStream {
    let root = &declaration.root;
    let signatures = declaration.clauses.functions.iter().map(|function| {
        let name = unraw(&function.name);
        let arguments = function.arguments.iter().map(unraw);
        quote!(#root::FunctionSignature { name: #name, arguments: &[#(#arguments),*] })
    });
    quote!(const FUNCTIONS: &'static [#root::FunctionSignature] = &[#(#signatures),*];)
}

/// Variables for the arguments of a function, hygienic.
fn arguments(function: &FunctionDeclaration) -> Vec<Ident> {
    let names = (0..function.arguments.len()).map(|i| format_ident!("x{i}"));
    names
        .map(|mut name| {
            name.set_span(Span::mixed_site());
            name
        })
        .collect()
}
