//! The body of a long method, written in pieces.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use super::Body;
use super::pieces::{Piece, Pieces, Read, Statement, Transfer};
use crate::limits::DECLARED_AT_ONCE;

impl Body<'_> {
    /// The statements of a group of a long method, which have these tokens, in pieces. Of its values the outputs are variables
    /// afterwards, and what later groups read is in an array.
    pub(super) fn pieces(
        &mut self,
        statements: &[Statement],
        tokens: Vec<TokenStream>,
    ) -> TokenStream {
        let variables = &self.variables;
        let is_kept = |value| variables.is_output(value) || variables.is_read_later(value);
        let is_copied = |symbol| self.source.element(symbol).is_none();
        let pieces = Pieces::of(statements, self.piece_length, is_kept, is_copied);
        let (array, length) = (self.locals.free("values".to_owned()), pieces.length);
        let (root, functions) = (self.scalar.root(), self.scalar.functions());
        let scalar = self.scalar.to_token_stream();
        let (places, values): (Vec<_>, Vec<_>) = pieces
            .symbols()
            .map(|symbol| {
                let place = pieces.element(Read::Symbol(symbol));
                (place, self.source.read(symbol))
            })
            .unzip();
        let mut written = quote! {
            let mut #array: [#scalar; #length] = [#functions::from_f64(0.0); #length];
            #root::__private::scatter(&mut #array[..], [#(#places),*], [#(#values),*]);
        };
        let defined = statements.iter().flat_map(|statement| &statement.defines);
        for (value, name) in defined.clone() {
            if let Some(element) = pieces.element(Read::Value(*value)) {
                let home = (array.clone(), element, name.clone());
                self.homes.insert(Read::Value(*value), home);
            }
        }
        for symbol in pieces.symbols() {
            if let Some(element) = pieces.element(Read::Symbol(symbol)) {
                let home = (array.clone(), element, self.symbols[&symbol].clone());
                self.homes.insert(Read::Symbol(symbol), home);
            }
        }
        self.give_arrays(statements);
        let mut tokens = tokens.into_iter();
        for piece in pieces.parts(&array) {
            written.extend(self.piece(&piece, &mut tokens, &array, length));
        }
        let outputs = pieces
            .kept
            .iter()
            .filter(|value| self.variables.is_output(**value));
        let outputs: Vec<_> = outputs.map(|value| Read::Value(*value)).collect();
        for outputs in outputs.chunks(DECLARED_AT_ONCE) {
            written.extend(self.homes(outputs.iter()).gathered(root, &scalar));
        }
        self.arrays.push((array, length));
        written
    }

    /// Gives pieces the arrays of symbols that these statements read.
    fn give_arrays(&mut self, statements: &[Statement]) {
        for read in statements.iter().flat_map(|statement| &statement.reads) {
            if let Read::Symbol(symbol) = read
                && let Some(element) = self.source.element(*symbol)
            {
                let home = (
                    element.array.clone(),
                    element.index,
                    self.symbols[symbol].clone(),
                );
                self.homes.insert(*read, home);
                self.given.insert(element.array, element.length);
            }
        }
    }

    /// Where values are that are read.
    fn homes<'b>(&self, reads: impl Iterator<Item = &'b Read>) -> Transfer {
        let mut homes = Transfer::default();
        for (array, element, name) in reads.filter_map(|read| self.homes.get(read)) {
            homes.add(array, *element, name);
        }
        homes
    }

    /// One piece of a group whose values are in an array of this length: a function, or a block where it calls the model. The
    /// tokens of its statements are the next ones.
    fn piece(
        &self,
        piece: &Piece<'_>,
        tokens: &mut impl Iterator<Item = TokenStream>,
        array: &Ident,
        length: usize,
    ) -> TokenStream {
        let (root, scalar) = (self.scalar.root(), self.scalar.to_token_stream());
        let mut body = TokenStream::new();
        for run in &piece.runs {
            body.extend(self.homes(run.reads.iter()).gathered(root, &scalar));
            body.extend(tokens.take(run.statements.len()));
            body.extend(run.writes.scattered(root));
        }
        if piece.calls_model {
            return in_braces(body);
        }
        let generics = self.scalar.generics_of_functions();
        let reads = piece.runs.iter().flat_map(|run| &run.reads);
        let read = reads.filter_map(|read| self.homes.get(read));
        let read: BTreeSet<&Ident> = read.map(|(array, ..)| array).collect();
        let (mut parameters, mut arguments) = (Vec::new(), Vec::new());
        for (name, length) in self.arrays.iter().filter(|(name, _)| read.contains(name)) {
            parameters.push(quote!(#name: &[#scalar; #length]));
            arguments.push(quote!(&#name));
        }
        for (name, length) in self.given.iter().filter(|(name, _)| read.contains(name)) {
            parameters.push(quote!(#name: &[#scalar; #length]));
            arguments.push(quote!(#name));
        }
        let mut block = quote! {
            #[inline(never)]
            fn piece #generics(#array: &mut [#scalar; #length], #(#parameters),*)
        };
        block.extend(in_braces(body));
        block.extend(quote!(piece(&mut #array, #(#arguments),*);));
        in_braces(block)
    }
}

/// Statements in braces. They are moved: `quote` would copy them, token by token.
fn in_braces(statements: TokenStream) -> TokenStream {
    TokenTree::Group(Group::new(Delimiter::Brace, statements)).into()
}
