//! The impl of `Inputs` without equations.

use proc_macro2::TokenStream;
use quote::quote;

use super::Fallback;
use crate::plan::Interface;

impl Fallback<'_> {
    pub(super) fn inputs(&self) -> TokenStream {
        let u = self.lowered.quantities.inputs.len();
        if u == 0 {
            return TokenStream::new();
        }
        let names = quote!(const INPUTS: [&'static str; #u] = [""; #u];);
        self.interface(Interface::Inputs, &names)
    }
}
