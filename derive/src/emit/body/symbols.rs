//! Where a body reads symbols: at its beginning, or where a long one needs them first.

use lagrangian_symbolic::{Operand, OutputGroup, Symbol};
use proc_macro2::{Ident, TokenStream};

use super::Body;

/// Where the emitted code finds a symbol's value.
pub(crate) trait SymbolReader {
    /// The expression that reads `symbol`.
    fn read(&self, symbol: Symbol) -> TokenStream;

    /// Where `symbol` is an element of an array of the scalar to which the method has a reference.
    fn element(&self, _symbol: Symbol) -> Option<Element> {
        None
    }
}

/// An element of an array.
pub(crate) struct Element {
    pub(crate) array: Ident,
    /// The number of elements of the array.
    pub(crate) length: usize,
    pub(crate) index: usize,
}

impl Body<'_> {
    /// Names the symbols that no group before has read, and reads those of a short group.
    pub(super) fn load_symbols(&mut self, group: &OutputGroup) {
        let in_pieces = self.block.is_in_pieces();
        for symbol in group.symbols() {
            let is_new = !self.symbols.contains_key(&symbol);
            if is_new {
                let name = self.locals.symbol(symbol);
                self.symbols.insert(symbol, name);
            }
            // Each piece reads what it needs.
            let is_needed = if in_pieces {
                group.outputs.contains(&Operand::Symbol(symbol))
            } else {
                is_new && !self.is_long
            };
            if is_needed {
                self.load(symbol);
            }
        }
    }

    /// Reads the symbols among operands of a long group that have not been read: where they are needed first, so that they do not
    /// wait for it in registers.
    pub(super) fn load_operands<'b>(&mut self, operands: impl Iterator<Item = &'b Operand>) {
        if self.block.is_in_pieces() {
            return;
        }
        for operand in operands {
            if let Operand::Symbol(symbol) = operand {
                self.load(*symbol);
            }
        }
    }

    /// Reads a symbol that has not been read.
    fn load(&mut self, symbol: Symbol) {
        if self.read_before.insert(symbol) {
            let (name, read) = (&self.symbols[&symbol], self.source.read(symbol));
            self.block.read(name, read, self.scalar);
        }
    }
}
