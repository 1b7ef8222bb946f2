//! The impl of `Inputs`.

use proc_macro2::TokenStream;
use quote::quote;

use super::Implementation;

impl Implementation<'_> {
    pub(super) fn inputs(&self) -> TokenStream {
        if !self.has_inputs() {
            return TokenStream::new();
        }
        let (n, u) = (self.coordinates(), self.model.inputs as usize);
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        let vector = quote!(#root::__private::SVector<#scalar, #u>);
        let components = &self.lowered.quantities.inputs;
        let names = components.iter().map(|input| input.label.to_string());
        let values = components.iter().map(|input| self.read(input));
        let arguments = [quote!(inputs: &#vector)];
        let driven = self.driven(&arguments, "_with");
        let matrix = quote!(#root::__private::SMatrix<#scalar, #n, #u>);
        let jacobian = self.method(
            "input_jacobian_with",
            &arguments,
            &matrix,
            &self.methods.input_jacobian,
            |b| b.input_jacobian(n, self.methods.pivots_of_derivatives()),
        );
        let items = quote! {
            const INPUTS: [&'static str; #u] = [#(#names),*];

            fn inputs(&self) -> #vector {
                <#vector as ::core::convert::From<[#scalar; #u]>>::from([
                    #(#values),*
                ])
            }

            #driven
            #jacobian
        };
        self.implement(&quote!(#root::Inputs<#n, #u, #scalar>), &items)
    }
}
