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

/// Something for each thing that is read.
struct ByRead<T> {
    values: Vec<Option<T>>,
    symbols: BTreeMap<Symbol, T>,
}

impl<T> ByRead<T> {
    const fn new() -> Self {
        Self {
            values: Vec::new(),
            symbols: BTreeMap::new(),
        }
    }

    fn get(&self, read: Read) -> Option<&T> {
        match read {
            Read::Value(value) => self.values.get(value)?.as_ref(),
            Read::Symbol(symbol) => self.symbols.get(&symbol),
        }
    }

    /// Puts in what belongs to `read`; returns what did before.
    fn insert(&mut self, read: Read, new: T) -> Option<T> {
        match read {
            Read::Value(value) => {
                if self.values.len() <= value {
                    self.values.resize_with(value + 1, || None);
                }
                self.values[value].replace(new)
            }
            Read::Symbol(symbol) => self.symbols.insert(symbol, new),
        }
    }
}

/// The pieces of one group, and where the values are that they read of each other.
pub(super) struct Pieces<'a> {
    statements: Vec<&'a [Statement]>,
    /// For each value that is read behind its piece: its element of the array.
    elements: ByRead<usize>,
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
            elements: ByRead::new(),
            kept: Vec::new(),
            length: 0,
        };
        pieces.allocate(is_kept, is_copied);
        pieces
    }

    fn allocate(&mut self, is_kept: impl Fn(usize) -> bool, is_copied: impl Fn(Symbol) -> bool) {
        let mut last_pieces = ByRead::new();
        for (piece, statements) in self.statements.iter().enumerate() {
            for read in statements.iter().flat_map(|statement| &statement.reads) {
                last_pieces.insert(*read, piece);
            }
        }
        let mut free = Vec::new();
        let mut ending = vec![Vec::new(); self.statements.len()];
        let symbols = last_pieces.symbols.iter();
        for (symbol, last_piece) in symbols.filter(|(symbol, _)| is_copied(**symbol)) {
            ending[*last_piece].push(self.length);
            self.elements.insert(Read::Symbol(*symbol), self.length);
            self.length += 1;
        }
        for (piece, statements) in self.statements.iter().enumerate() {
            for (value, _) in statements.iter().flat_map(|statement| &statement.defines) {
                let read = Read::Value(*value);
                let is_kept = is_kept(*value);
                let last_piece = last_pieces.get(read).copied().unwrap_or(0);
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
        self.elements.get(read).copied()
    }

    /// The symbols that are in the array when the first piece begins.
    pub(super) fn symbols(&self) -> impl Iterator<Item = Symbol> {
        self.elements.symbols.keys().copied()
    }

    /// What the pieces are written from, with what they write to `array`.
    pub(super) fn parts(&self, array: &Ident) -> impl Iterator<Item = Piece<'a>> {
        // The last piece in which something is known.
        let mut known = ByRead::new();
        let pieces = self.statements.iter().enumerate();
        pieces.map(move |(number, statements)| {
            let runs = statements.chunks(STATEMENTS_PER_TRANSFER);
            let mut learn = |read| known.insert(read, number) != Some(number);
            Piece {
                runs: runs.map(|run| self.run(run, array, &mut learn)).collect(),
                calls_model: statements.iter().any(|statement| statement.calls_model),
            }
        })
    }

    /// A run of statements; `learn` tells what is not known in the piece so far, and then is.
    fn run(
        &self,
        statements: &'a [Statement],
        array: &Ident,
        learn: &mut impl FnMut(Read) -> bool,
    ) -> Run<'a> {
        let (mut reads, mut writes) = (BTreeSet::new(), Transfer::default());
        for statement in statements {
            for read in &statement.reads {
                if learn(*read) {
                    reads.insert(*read);
                }
            }
            for (value, name) in &statement.defines {
                let read = Read::Value(*value);
                learn(read);
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
