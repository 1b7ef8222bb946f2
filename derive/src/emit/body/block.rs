//! The statements of a method, while they are written.
//!
//! In a short method each variable is a `let`. Each `let` opens a scope in the one before, and rustc recurses
//! scope by scope where it writes debug information: its stack overflows. So the variables of a
//! long method are declared many at once, by one pattern, and then assigned.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::limits::DECLARED_AT_ONCE;
use crate::syntax::scalar::Scalar;

/// The statements of one method.
pub(super) struct Block {
    is_long: bool,
    written: TokenStream,
    /// In a long method: what is still to be declared, and the statements that assign it.
    declared: Vec<Ident>,
    assignments: TokenStream,
}

impl Block {
    pub(super) fn new(is_long: bool) -> Self {
        Self {
            is_long,
            written: TokenStream::new(),
            declared: Vec::new(),
            assignments: TokenStream::new(),
        }
    }

    /// Gives a variable the value that is read from elsewhere.
    pub(super) fn read(&mut self, name: &Ident, value: &TokenStream, scalar: &Scalar<'_>) {
        if self.is_long {
            self.assign(core::slice::from_ref(name), &quote!(#name), value, scalar);
        } else {
            self.written.extend(quote!(let #name: #scalar = #value;));
        }
    }

    /// Gives the variables `names` of a pattern their values.
    pub(super) fn define(
        &mut self,
        names: &[Ident],
        pattern: &TokenStream,
        value: &TokenStream,
        scalar: &Scalar<'_>,
    ) {
        if self.is_long {
            self.assign(names, pattern, value, scalar);
        } else {
            self.written.extend(quote!(let #pattern = #value;));
        }
    }

    fn assign(
        &mut self,
        names: &[Ident],
        pattern: &TokenStream,
        value: &TokenStream,
        scalar: &Scalar<'_>,
    ) {
        if self.declared.len() >= DECLARED_AT_ONCE {
            self.declare(scalar);
        }
        self.declared.extend_from_slice(names);
        self.assignments.extend(quote!(#pattern = #value;));
    }

    /// Writes the declarations and assignments that are due.
    fn declare(&mut self, scalar: &Scalar<'_>) {
        let declared = core::mem::take(&mut self.declared);
        if !declared.is_empty() {
            let count = declared.len();
            self.written
                .extend(quote!(let [#(#declared),*]: [#scalar; #count];));
            self.written.extend(core::mem::take(&mut self.assignments));
        }
    }

    /// The statements since the last time.
    pub(super) fn take(&mut self, scalar: &Scalar<'_>) -> TokenStream {
        self.declare(scalar);
        core::mem::take(&mut self.written)
    }
}
