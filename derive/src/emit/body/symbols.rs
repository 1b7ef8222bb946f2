//! Where a body reads symbols: at its beginning and behind its last call, or where a long one needs them first.

use lagrangian_symbolic::{Operand, Operation, OutputGroup, Symbol};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens as _, quote};

use super::Body;

/// So many characters of a pattern fit in a line.
const MAX_PATTERN_WIDTH: usize = 64;

/// Where the emitted code finds a symbol's value.
pub(crate) trait SymbolReader {
    /// The expression that reads `symbol`.
    fn read(&self, symbol: Symbol) -> TokenStream;

    /// Where `symbol` is an element of an array of the scalar to which the method has a reference.
    fn element(&self, _symbol: Symbol) -> Option<Element> {
        None
    }

    /// The array that has the value of `symbol`, as an expression, from which a pattern reads several values at once.
    fn array(&self, _symbol: Symbol) -> Option<Array> {
        None
    }
}

/// An array of values, and the index of one of them.
pub(crate) struct Array {
    pub(crate) value: TokenStream,
    pub(crate) length: usize,
    pub(crate) index: usize,
}

/// An element of an array.
pub(crate) struct Element {
    pub(crate) array: Ident,
    /// The number of elements of the array.
    pub(crate) length: usize,
    pub(crate) index: usize,
}

/// The last instruction that may be a call of a function, among those that are not done.
pub(super) fn last_call(group: &OutputGroup, done: &[bool]) -> Option<usize> {
    let mut instructions = group.instructions.iter().zip(done);
    instructions.rposition(|(instruction, done)| {
        let is_call = matches!(
            instruction.operation,
            Operation::SineAndCosine(_)
                | Operation::Unary(..)
                | Operation::Binary(..)
                | Operation::Application(..)
        );
        is_call && !done
    })
}

impl Body<'_> {
    /// Names the symbols that no group before has read, and returns those that a short group reads.
    pub(super) fn name_symbols(&mut self, group: &OutputGroup) -> Vec<Symbol> {
        let in_pieces = self.block.is_in_pieces();
        let mut needed = Vec::new();
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
                needed.push(symbol);
            }
        }
        needed
    }

    /// The symbols that are read before the last call, and the others. What is read before a call waits for its end, in registers
    /// or on the stack.
    pub(super) fn split_at_call(
        &self,
        group: &OutputGroup,
        symbols: Vec<Symbol>,
        (done, last_call): (&[bool], Option<usize>),
    ) -> (Vec<Symbol>, Vec<Symbol>) {
        let instructions = group.instructions.iter().zip(done).enumerate();
        let before = instructions.filter(|(index, (_, done))| {
            **done || last_call.is_some_and(|last_call| *index <= last_call)
        });
        let read = before.flat_map(|(_, (instruction, _))| instruction.operation.operands());
        let read: Vec<_> = read.collect();
        let is_read = |symbol: &Symbol| read.contains(&&Operand::Symbol(*symbol));
        let in_pieces = self.block.is_in_pieces();
        let symbols = symbols.into_iter();
        symbols.partition(|symbol| in_pieces || is_read(symbol))
    }

    /// Reads some symbols.
    pub(super) fn load_symbols(&mut self, symbols: &[Symbol]) {
        if !self.block.is_in_pieces() {
            self.load_by_patterns(symbols);
        }
        for symbol in symbols {
            self.load(*symbol);
        }
    }

    /// Reads symbols that stand in one array by one pattern, where that fits in a line.
    fn load_by_patterns(&mut self, symbols: &[Symbol]) {
        let mut arrays: Vec<(Array, Vec<(usize, Symbol)>)> = Vec::new();
        for symbol in symbols {
            let Some(array) = self.source.array(*symbol) else {
                continue;
            };
            let (text, element) = (array.value.to_string(), (array.index, *symbol));
            let known = arrays.iter_mut();
            let mut known = known.filter(|(other, _)| other.value.to_string() == text);
            match known.next() {
                Some((_, elements)) => elements.push(element),
                None => arrays.push((array, vec![element])),
            }
        }
        for (array, mut elements) in arrays {
            elements.sort_unstable();
            let Some(pattern) = self.pattern(array.length, &elements) else {
                continue;
            };
            let symbols = elements.into_iter().map(|(_, symbol)| symbol);
            let mut names = Vec::new();
            for symbol in symbols {
                self.read_before.insert(symbol);
                names.extend(self.symbols.get(&symbol).cloned());
            }
            self.block.read_array(names, pattern, array.value);
        }
    }

    /// The pattern for elements of an array, in order, if it is shorter than reading them one by one.
    fn pattern(&self, length: usize, elements: &[(usize, Symbol)]) -> Option<TokenStream> {
        let (last, _) = elements.last()?;
        let mut places = vec![quote!(_); last + 1];
        let mut width = 3 * (last + 1);
        for (index, symbol) in elements {
            let name = self.symbols.get(symbol)?;
            width += name.to_string().len();
            *places.get_mut(*index)? = name.to_token_stream();
        }
        let rest = (last + 1 < length).then(|| quote!(, ..));
        (elements.len() > 1 && width <= MAX_PATTERN_WIDTH).then(|| quote!([#(#places),* #rest]))
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
            self.block.read(name, read);
        }
    }
}
