//! The statements of a method in pieces ([`Form::Pieces`](super::block::Form)), which are functions of their own.
//!
//! They are not inlined. What one computes and another reads is in an array, whose elements are given to others where nothing reads them any
//! more (linear scan: Poletto and Sarkar, Linear scan register allocation, 1999).

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::Symbol;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::limits::STATEMENTS_PER_TRANSFER;
use crate::syntax::root::Root;

/// A statement, which defines variables.
pub(super) struct Statement {
    pub(super) tokens: TokenStream,
    /// The values that it defines, with the names of their variables.
    pub(super) defines: Vec<(usize, Ident)>,
    pub(super) reads: Vec<Read>,
    /// Whether it calls a function of the model, which stands for itself between the pieces.
    pub(super) calls_model: bool,
}

/// What a statement reads.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Read {
    Value(usize),
    Symbol(Symbol),
}

/// The pieces of one group, and where the values are that they read of each other.
pub(super) struct Pieces<'a> {
    statements: Vec<&'a [Statement]>,
    /// For each value that is read behind its piece: its element of the array.
    elements: BTreeMap<Read, usize>,
    /// The values that are still there behind the last piece.
    pub(super) kept: Vec<usize>,
    /// The length of the array.
    pub(super) length: usize,
}

impl<'a> Pieces<'a> {
    /// Those of some statements, at most so many each, of which others read the values that `is_kept` tells; with the symbols in
    /// the array that `is_copied` tells.
    pub(super) fn of(
        statements: &'a [Statement],
        length: usize,
        is_kept: impl Fn(usize) -> bool,
        is_copied: impl Fn(Symbol) -> bool,
    ) -> Self {
        let runs = statements.chunk_by(|a, b| !a.calls_model && !b.calls_model);
        let mut pieces = Self {
            statements: runs.flat_map(|run| run.chunks(length)).collect(),
            elements: BTreeMap::new(),
            kept: Vec::new(),
            length: 0,
        };
        pieces.allocate(
            is_kept,
            |read| matches!(read, Read::Symbol(symbol) if is_copied(symbol)),
        );
        pieces
    }

    fn allocate(&mut self, is_kept: impl Fn(usize) -> bool, is_copied: impl Fn(Read) -> bool) {
        let mut last_pieces = BTreeMap::new();
        for (piece, statements) in self.statements.iter().enumerate() {
            for read in statements.iter().flat_map(|statement| &statement.reads) {
                last_pieces.insert(*read, piece);
            }
        }
        let mut free = Vec::new();
        let mut ending = vec![Vec::new(); self.statements.len()];
        let symbols = last_pieces.iter();
        for (symbol, last_piece) in symbols.filter(|(read, _)| is_copied(**read)) {
            ending[*last_piece].push(self.length);
            self.elements.insert(*symbol, self.length);
            self.length += 1;
        }
        for (piece, statements) in self.statements.iter().enumerate() {
            for (value, _) in statements.iter().flat_map(|statement| &statement.defines) {
                let read = Read::Value(*value);
                let is_kept = is_kept(*value);
                let last_piece = last_pieces.get(&read).copied().unwrap_or(0);
                if !is_kept && last_piece <= piece {
                    continue;
                }
                let element = free.pop().unwrap_or_else(|| {
                    self.length += 1;
                    self.length - 1
                });
                self.elements.insert(read, element);
                if is_kept {
                    self.kept.push(*value);
                } else {
                    ending[last_piece].push(element);
                }
            }
            free.append(&mut ending[piece]);
        }
    }

    /// The element that holds what is read.
    pub(super) fn element(&self, read: Read) -> Option<usize> {
        self.elements.get(&read).copied()
    }

    /// The symbols that are in the array when the first piece begins.
    pub(super) fn symbols(&self) -> impl Iterator<Item = Symbol> {
        self.elements.keys().filter_map(|read| match read {
            Read::Symbol(symbol) => Some(*symbol),
            Read::Value(_) => None,
        })
    }

    /// What the pieces are written from, with what they write to `array`.
    pub(super) fn parts(&self, array: &Ident) -> impl Iterator<Item = Piece<'a>> {
        self.statements.iter().map(|statements| {
            let mut known = BTreeSet::new();
            let runs = statements.chunks(STATEMENTS_PER_TRANSFER);
            Piece {
                runs: runs.map(|run| self.run(run, array, &mut known)).collect(),
                calls_model: statements.iter().any(|statement| statement.calls_model),
            }
        })
    }

    /// A run of statements behind others in which these are known.
    fn run(
        &self,
        statements: &'a [Statement],
        array: &Ident,
        known: &mut BTreeSet<Read>,
    ) -> Run<'a> {
        let (mut reads, mut writes) = (BTreeSet::new(), Transfer::default());
        for statement in statements {
            for read in &statement.reads {
                if known.insert(*read) {
                    reads.insert(*read);
                }
            }
            for (value, name) in &statement.defines {
                let read = Read::Value(*value);
                known.insert(read);
                if let Some(element) = self.element(read) {
                    writes.add(array, element, name);
                }
            }
        }
        Run {
            reads,
            statements,
            writes,
        }
    }
}

/// One piece.
pub(super) struct Piece<'a> {
    pub(super) runs: Vec<Run<'a>>,
    pub(super) calls_model: bool,
}

/// A few statements of a piece. What they need is read just before them, and what others need is written at once, so that
/// little waits in registers.
pub(super) struct Run<'a> {
    /// What others compute that it reads, and no run before it.
    pub(super) reads: BTreeSet<Read>,
    pub(super) statements: &'a [Statement],
    /// What it computes that other pieces read.
    pub(super) writes: Transfer,
}

/// Variables that are elements of arrays, by array.
#[derive(Default)]
pub(super) struct Transfer(BTreeMap<Ident, (Vec<Literal>, Vec<Ident>)>);

impl Transfer {
    /// Adds a variable.
    pub(super) fn add(&mut self, array: &Ident, element: usize, name: &Ident) {
        let (elements, names) = self.0.entry(array.clone()).or_default();
        elements.push(Literal::usize_unsuffixed(element));
        names.push(name.clone());
    }

    /// Gives the variables the values of the elements. One pattern costs rustc a tenth of as many indices.
    pub(super) fn gathered(&self, root: &Root, scalar: &TokenStream) -> TokenStream {
        let arrays = self.0.iter().map(|(array, (elements, names))| {
            let count = names.len();
            quote! {
                let [#(#names),*]: [#scalar; #count] =
                    #root::__private::gather(&#array[..], [#(#elements),*]);
            }
        });
        arrays.collect()
    }

    /// Gives the elements the values of the variables.
    pub(super) fn scattered(&self, root: &Root) -> TokenStream {
        let arrays = self.0.iter().map(|(array, (elements, names))| {
            quote!(#root::__private::scatter(&mut #array[..], [#(#elements),*], [#(#names),*]);)
        });
        arrays.collect()
    }
}
