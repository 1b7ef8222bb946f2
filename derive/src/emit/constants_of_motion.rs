//! The impl of `ConstantsOfMotion`: the momenta of ignorable coordinates, and the energy function.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use crate::syntax::label::Label;

impl Emitter<'_> {
    /// The impl of `ConstantsOfMotion`, for a model that has some.
    pub(super) fn constants_of_motion(&self) -> TokenStream {
        let conservation = &self.equations.conservation;
        let ignorable: Vec<usize> = conservation.ignorable().collect();
        let count = ignorable.len() + usize::from(conservation.energy);
        if count == 0 {
            return TokenStream::new();
        }
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let state = self.signatures().state();
        let labels = ignorable
            .iter()
            .map(|i| &self.lowered.quantities.coordinates[*i]);
        let names = labels.map(Label::momentum);
        let energy = conservation.energy;
        let names = names.chain(energy.then(|| "energy".to_owned()));
        let indices = ignorable.iter().copied().map(Literal::usize_unsuffixed);
        let indices: Vec<_> = indices.collect();
        let momenta = (!indices.is_empty())
            .then(|| quote!(let momenta = #root::Lagrangian::<#n, #scalar>::momenta(self, state);));
        let values = indices.iter().map(|i| quote!(momenta[#i]));
        let values = values
            .chain(energy.then(|| quote!(#root::Lagrangian::<#n, #scalar>::energy(self, state))));
        let items = quote! {
            const CONSTANTS_OF_MOTION: [&'static str; #count] = [#(#names),*];
            const IGNORABLE_COORDINATES: &'static [usize] = &[#(#indices),*];
            const CONSERVES_ENERGY: bool = #energy;
            fn constants_of_motion(
                &self,
                state: #state,
            ) -> #root::__private::SVector<#scalar, #count> {
                #momenta
                #root::__private::vector([#(#values),*])
            }
        };
        self.implement(
            &quote!(#root::ConstantsOfMotion<#n, #count, #scalar>),
            &items,
        )
    }
}
