//! The statements of a method, while they are written.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::pieces::{Read, Statement};
use crate::syntax::scalar::Scalar;

/// The statements of one group.
pub(super) struct Block {
    /// Whether the method is long, so that its statements are divided into pieces.
    pub(super) is_long: bool,
    written: TokenStream,
    /// Those of a long method.
    statements: Vec<Statement>,
}

impl Block {
    pub(super) fn new(is_long: bool) -> Self {
        Self {
            is_long,
            written: TokenStream::new(),
            statements: Vec::new(),
        }
    }

    /// Gives a variable the value that is read from elsewhere.
    pub(super) fn read(&mut self, name: &Ident, value: &TokenStream, scalar: &Scalar<'_>) {
        self.written.extend(quote!(let #name: #scalar = #value;));
    }

    /// Gives the variables of a pattern, which hold these values, what is computed from `reads`.
    pub(super) fn define(
        &mut self,
        defines: Vec<(usize, Ident)>,
        pattern: &TokenStream,
        value: &TokenStream,
        reads: Vec<Read>,
        calls_model: bool,
    ) {
        let tokens = quote!(let #pattern = #value;);
        if self.is_long {
            self.statements.push(Statement {
                tokens,
                defines,
                reads,
                calls_model,
            });
        } else {
            self.written.extend(tokens);
        }
    }

    /// The statements of a long method since the last time.
    pub(super) fn take_statements(&mut self) -> Vec<Statement> {
        core::mem::take(&mut self.statements)
    }

    /// What is written since the last time.
    pub(super) fn take(&mut self) -> TokenStream {
        core::mem::take(&mut self.written)
    }
}
