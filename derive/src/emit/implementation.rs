//! The frames of impls.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Generics;

use crate::syntax::declaration::Declaration;

/// `impl<…> Model<…>`, with these parameters of the impl.
pub(super) fn inherent(
    declaration: &Declaration,
    generics: &Generics,
    items: &TokenStream,
) -> TokenStream {
    let name = &declaration.name;
    let (generics, _, conditions) = generics.split_for_impl();
    let (_, arguments, _) = declaration.generics.split_for_impl();
    quote! {
        impl #generics #name #arguments #conditions {
            #items
        }
    }
}

/// `impl<…> trait for Model<…>`, with these parameters of the impl.
pub(super) fn of_trait(
    declaration: &Declaration,
    generics: &Generics,
    interface: &TokenStream,
    items: &TokenStream,
) -> TokenStream {
    let name = &declaration.name;
    let (generics, _, conditions) = generics.split_for_impl();
    let (_, arguments, _) = declaration.generics.split_for_impl();
    quote! {
        #[automatically_derived]
        impl #generics #interface for #name #arguments #conditions {
            #items
        }
    }
}
