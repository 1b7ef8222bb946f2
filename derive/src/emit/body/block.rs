//! The statements of a method, while they are written.
//!
//! In a short method each variable is a `let`. Each `let` opens a scope in the one before, and rustc recurses scope by scope
//! where it writes debug information: its stack overflows. So the variables of a longer method are declared many at once, by
//! one pattern, and then assigned. Compilers keep them in registers as those of a short one, but the time that they take grows
//! faster than the length; so a method that is longer still is divided into pieces.

use proc_macro2::{Ident, Punct, Spacing, TokenStream, TokenTree};
use quote::quote;

use super::pieces::{Read, Statement};
use crate::limits::DECLARED_AT_ONCE;
use crate::syntax::scalar::Scalar;

/// The form of a method by its length.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// Each variable is a `let`.
    Nested,
    /// Variables are declared many at once, and assigned.
    Assigned,
    /// Functions with an array between them.
    Pieces,
}

/// The statements of one group.
pub(super) struct Block<'a> {
    form: Form,
    scalar: &'a Scalar<'a>,
    written: TokenStream,
    /// Where variables are assigned: what is still to be declared, and the statements that assign it.
    declared: Vec<Ident>,
    assignments: TokenStream,
    /// Those of a method in pieces, and their tokens.
    statements: Vec<(Statement, TokenStream)>,
}

impl<'a> Block<'a> {
    pub(super) fn new(form: Form, scalar: &'a Scalar<'a>) -> Self {
        Self {
            form,
            scalar,
            written: TokenStream::new(),
            declared: Vec::new(),
            assignments: TokenStream::new(),
            statements: Vec::new(),
        }
    }

    /// Whether the statements are divided into pieces.
    pub(super) fn is_in_pieces(&self) -> bool {
        self.form == Form::Pieces
    }

    /// Whether each variable is a `let`.
    pub(super) fn is_nested(&self) -> bool {
        self.form == Form::Nested
    }

    /// Gives a variable the value that is read from elsewhere.
    pub(super) fn read(&mut self, name: &Ident, value: TokenStream) {
        match self.form {
            Form::Assigned => self.assign([name.clone()], quote!(#name), value),
            Form::Nested | Form::Pieces => {
                let scalar = self.scalar;
                set(&mut self.written, quote!(let #name: #scalar), value);
            }
        }
    }

    /// Gives the variables of a pattern the values of the elements of an array.
    pub(super) fn read_array(
        &mut self,
        names: Vec<Ident>,
        pattern: TokenStream,
        array: TokenStream,
    ) {
        match self.form {
            Form::Assigned => self.assign(names, pattern, array),
            Form::Nested | Form::Pieces => set(&mut self.written, quote!(let #pattern), array),
        }
    }

    /// Gives the variables of a pattern, which hold these values, what is computed from `reads`.
    pub(super) fn define(
        &mut self,
        defines: Vec<(usize, Ident)>,
        pattern: TokenStream,
        value: TokenStream,
        reads: Vec<Read>,
        calls_model: bool,
    ) {
        match self.form {
            Form::Nested => set(&mut self.written, quote!(let #pattern), value),
            Form::Assigned => {
                let names = defines.into_iter().map(|(_, name)| name);
                self.assign(names, pattern, value);
            }
            Form::Pieces => {
                let mut tokens = TokenStream::new();
                set(&mut tokens, quote!(let #pattern), value);
                let statement = Statement {
                    defines,
                    reads,
                    calls_model,
                };
                self.statements.push((statement, tokens));
            }
        }
    }

    fn assign(
        &mut self,
        names: impl IntoIterator<Item = Ident>,
        pattern: TokenStream,
        value: TokenStream,
    ) {
        if self.declared.len() >= DECLARED_AT_ONCE {
            self.declare();
        }
        self.declared.extend(names);
        set(&mut self.assignments, pattern, value);
    }

    /// Writes the declarations and assignments that are due.
    fn declare(&mut self) {
        let declared = core::mem::take(&mut self.declared);
        if !declared.is_empty() {
            let (count, scalar) = (declared.len(), self.scalar);
            self.written
                .extend(quote!(let [#(#declared),*]: [#scalar; #count];));
            self.written.extend(core::mem::take(&mut self.assignments));
        }
    }

    /// The statements of a method in pieces since the last time, and their tokens.
    pub(super) fn take_statements(&mut self) -> (Vec<Statement>, Vec<TokenStream>) {
        core::mem::take(&mut self.statements).into_iter().unzip()
    }

    /// What is written since the last time.
    pub(super) fn take(&mut self) -> TokenStream {
        self.declare();
        core::mem::take(&mut self.written)
    }
}

/// Appends `place = value;`. Streams are moved: `quote` would copy them, token by token.
fn set(statements: &mut TokenStream, place: TokenStream, value: TokenStream) {
    let sign = |sign| [TokenTree::Punct(Punct::new(sign, Spacing::Alone))];
    statements.extend(place);
    statements.extend(sign('='));
    statements.extend(value);
    statements.extend(sign(';'));
}
