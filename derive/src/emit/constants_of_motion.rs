//! The impl of `ConstantsOfMotion`: the momenta of ignorable coordinates, and the energy function.
//!
//! Its constants are constants of the type, too, where no scalar has to be named.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use crate::syntax::label::Label;

impl Emitter<'_> {
    /// The impl of `ConstantsOfMotion`, for a model that has some.
    pub(super) fn constants_of_motion(&self) -> TokenStream {
        let count = self.conserved().len();
        if count == 0 {
            return TokenStream::new();
        }
        let (root, scalar, n) = (
            &self.declaration.root,
            &self.scalar,
            self.signatures().dimension,
        );
        let count = Literal::usize_unsuffixed(count);
        let items = quote! {
            const CONSTANTS_OF_MOTION: [&'static str; #count] = Self::CONSTANTS_OF_MOTION;
            const IGNORABLE_COORDINATES: &'static [usize] = Self::IGNORABLE_COORDINATES;
        };
        self.implement(
            &quote!(#root::ConstantsOfMotion<#n, #count, #scalar>),
            &items,
        )
    }

    /// What is known of the constants of motion at compile time, as constants of the type.
    pub(super) fn conservation_constants(&self) -> TokenStream {
        let names = self.conserved();
        let count = names.len();
        if count == 0 {
            return TokenStream::new();
        }
        let visibility = &self.declaration.visibility;
        let indices = self.ignorable();
        let energy = self.equations.conservation.energy;
        quote! {
            /// The names of the constants of motion, in order.
            #visibility const CONSTANTS_OF_MOTION: [&'static str; #count] = [#(#names),*];
            /// The indices of the ignorable coordinates, in order.
            #visibility const IGNORABLE_COORDINATES: &'static [usize] = &[#(#indices),*];
            /// Whether the energy function is a constant of motion.
            #visibility const CONSERVES_ENERGY: bool = #energy;
        }
    }

    /// The indices of the ignorable coordinates.
    fn ignorable(&self) -> Vec<Literal> {
        let indices = self.equations.conservation.ignorable();
        indices.map(Literal::usize_unsuffixed).collect()
    }

    /// The names of the constants of motion.
    fn conserved(&self) -> Vec<String> {
        let conservation = &self.equations.conservation;
        let labels = conservation
            .ignorable()
            .map(|i| &self.lowered.quantities.coordinates[i]);
        let names = labels.map(Label::momentum);
        let energy = conservation.energy.then(|| "energy".to_owned());
        names.chain(energy).collect()
    }
}
