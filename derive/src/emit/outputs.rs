//! The struct of a model's outputs, and the impl of `Outputs`.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use super::item_names::outputs_name;
use crate::plan::Interface;
use crate::syntax::declaration::Declaration;
use crate::syntax::names::{hygienic_span, unraw};
use crate::syntax::root::Root;
use crate::syntax::scalar::Scalar;
use crate::syntax::shape::Shape;

impl Emitter<'_> {
    pub(super) fn outputs(&self) -> TokenStream {
        let outputs = &self.declaration.clauses.outputs;
        if outputs.is_empty() {
            return TokenStream::new();
        }
        let scalar = &self.scalar;
        let names = outputs.iter().map(|output| &output.name);
        let shapes = self.lowered.outputs.iter().copied();
        let named: Vec<_> = names.zip(shapes).collect();
        let (results, definition) = results(self.declaration, scalar, &named);
        let items = quote!(type Outputs = #results<#scalar>;);
        let implementation = self.interface(Interface::Outputs, items);
        quote!(#definition #implementation)
    }
}

/// The struct that holds a model's outputs: its name, and its definition.
pub(crate) fn results(
    declaration: &Declaration,
    scalar: &Scalar<'_>,
    outputs: &[(&Ident, Shape)],
) -> (Ident, TokenStream) {
    let name = &declaration.name;
    let visibility = &declaration.visibility;
    let results = outputs_name(declaration);
    let documentation = format!("The outputs of [`{name}`].");
    let scalar = scalar.of_results();
    let fields = outputs.iter().map(|(output, shape)| {
        let ty = type_of(*shape, &scalar, &declaration.root);
        let mut name = (*output).clone();
        name.set_span(hygienic_span(output));
        let text = format!("The output `{}`.", unraw(output));
        quote!(#[doc = #text] #visibility #name: #ty)
    });
    let definition = quote! {
        #[doc = #documentation]
        #[derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::cmp::PartialEq,
            ::core::cmp::Eq,
        )]
        #visibility struct #results<#scalar> {
            #(#fields),*
        }
    };
    (results, definition)
}

/// The type of a value.
fn type_of(shape: Shape, scalar: &TokenStream, root: &Root) -> TokenStream {
    match shape {
        Shape::Scalar => quote!(#scalar),
        Shape::Array { rows, columns: 1 } => {
            quote!(#root::__private::SVector<#scalar, #rows>)
        }
        Shape::Array { rows, columns } => {
            quote!(#root::__private::SMatrix<#scalar, #rows, #columns>)
        }
    }
}
