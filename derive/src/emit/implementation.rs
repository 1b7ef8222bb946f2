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
    frame(declaration, generics, [&TokenStream::new(); 2], items)
}

/// `impl<…> trait for Model<…>`, with these parameters of the impl.
pub(super) fn of_trait(
    declaration: &Declaration,
    generics: &Generics,
    interface: &TokenStream,
    items: &TokenStream,
) -> TokenStream {
    let attribute = quote!(#[automatically_derived]);
    frame(
        declaration,
        generics,
        [&attribute, &quote!(#interface for)],
        items,
    )
}

/// An impl with this attribute, and with these tokens before the name of the model.
fn frame(
    declaration: &Declaration,
    generics: &Generics,
    [attribute, interface]: [&TokenStream; 2],
    items: &TokenStream,
) -> TokenStream {
    let name = &declaration.name;
    let (generics, _, conditions) = generics.split_for_impl();
    let (_, arguments, _) = declaration.generics.split_for_impl();
    quote! {
        #attribute
        impl #generics #interface #name #arguments #conditions {
            #items
        }
    }
}
