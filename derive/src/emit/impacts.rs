//! The impl of `Impacts`.

use proc_macro2::TokenStream;
use quote::quote;

use super::emitter::Emitter;
use crate::plan::Interface;

impl Emitter<'_> {
    /// The impl of `Impacts`, for a model whose events have gradients.
    pub(super) fn impacts(&self) -> TokenStream {
        if self.methods.event_gradients.is_none() {
            return TokenStream::new();
        }
        let response = self.is_constrained().then(|| {
            let signatures = self.signatures();
            let (state, vector) = (signatures.state(), signatures.vector());
            let (root, scalar) = (&self.declaration.root, &self.scalar);
            let (n, c, prepared) = (
                self.coordinates(),
                self.constraint_count(),
                &signatures.prepared,
            );
            quote! {
                fn impulse_response(
                    &self,
                    state: #state,
                    prepared: &#prepared,
                    impulse: &#vector,
                ) -> #vector {
                    #root::__private::constrained_impulse_response::<Self, #scalar, #n, #c>(
                        self, state, prepared, impulse,
                    )
                }
            }
        });
        self.interface(Interface::Impacts, response.unwrap_or_default())
    }
}
