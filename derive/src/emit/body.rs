//! From a straight-line program to the statements of a method.
//!
//! Each value that is used more than once, or that the declaration names, is a variable; the others stand
//! where they are used, as a person would write them, though never nested deeply.

mod variables;
mod block;
mod angles;
mod text;
mod constant;

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::{
    Function, Instruction, Operand, Operation, Pass, Passes, Phase, Program, Symbol,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};

use super::locals::Locals;
use crate::syntax::scalar::Scalar;
use angles::Angles;
use block::Block;
use constant::constant;
use text::{Level, Text, infix};
use variables::Variables;

/// Where the emitted code finds a symbol's value.
pub(crate) trait Source {
    /// The expression that reads `symbol`.
    fn read(&self, symbol: Symbol) -> TokenStream;
}

/// Writes the phases of one program, one after the other.
pub(crate) struct Body<'a> {
    passes: Passes,
    locals: Locals<'a>,
    scalar: &'a Scalar<'a>,
    source: &'a dyn Source,
    /// The methods that compute functions from outside, in the order of declaration.
    functions: Vec<Ident>,
    symbols: BTreeMap<Symbol, Ident>,
    texts: BTreeMap<usize, Text>,
    variables: Variables,
    block: Block,
}

impl<'a> Body<'a> {
    pub(crate) fn new(
        program: &Program,
        passes: Passes,
        locals: Locals<'a>,
        scalar: &'a Scalar<'a>,
        source: &'a dyn Source,
        functions: Vec<Ident>,
        most_scopes: usize,
    ) -> Self {
        let variables = Variables::of(program, |value| locals.is_defined(value));
        let scopes = program.symbols().len() + variables.count();
        Self {
            passes,
            locals,
            scalar,
            source,
            functions,
            symbols: BTreeMap::new(),
            texts: BTreeMap::new(),
            variables,
            block: Block::new(scopes > most_scopes),
        }
    }

    /// The statements of a phase, and the expressions of its outputs.
    pub(crate) fn phase(&mut self, phase: &Phase) -> (TokenStream, Vec<TokenStream>) {
        self.load_symbols(phase);
        let done = self.angles(phase);
        for (index, instruction) in phase.instructions.iter().enumerate() {
            if !done.contains(&index) {
                self.instruction(instruction);
            }
        }
        let outputs = phase
            .outputs
            .iter()
            .map(|operand| self.operand(operand).tokens)
            .collect();
        (self.block.take(self.scalar), outputs)
    }

    /// Reads the symbols that no phase before has read.
    fn load_symbols(&mut self, phase: &Phase) {
        let operands = phase
            .instructions
            .iter()
            .flat_map(|instruction| instruction.operation.operands());
        let wanted: BTreeSet<Symbol> = operands
            .chain(&phase.outputs)
            .filter_map(|operand| match operand {
                Operand::Symbol(symbol) => Some(*symbol),
                _ => None,
            })
            .collect();
        for symbol in wanted {
            if !self.symbols.contains_key(&symbol) {
                let name = self.locals.symbol(symbol);
                let read = self.source.read(symbol);
                self.block.read(&name, &read, self.scalar);
                self.symbols.insert(symbol, name);
            }
        }
    }

    /// Computes the sines and cosines that are computed at once; returns the instructions that are done.
    fn angles(&mut self, phase: &Phase) -> BTreeSet<usize> {
        if !self.passes.has(Pass::Vectors) {
            return BTreeSet::new();
        }
        let Some(angles) = Angles::of(phase, |value| self.texts.contains_key(&value)) else {
            return BTreeSet::new();
        };
        for index in &angles.made_of {
            self.instruction(&phase.instructions[*index]);
        }
        let (mut arguments, mut sines, mut cosines) = (Vec::new(), Vec::new(), Vec::new());
        for index in &angles.pairs {
            let instruction = &phase.instructions[*index];
            let operands = instruction.operation.operands();
            arguments.extend(operands.map(|operand| self.operand(operand).tokens));
            let (sine, cosine) = self.pair(instruction);
            sines.push(sine);
            cosines.push(cosine);
        }
        let functions = self.scalar.functions();
        let pattern = quote!(([#(#sines),*], [#(#cosines),*]));
        let value = quote!(#functions::sines_and_cosines([#(#arguments),*]));
        let names: Vec<Ident> = sines.into_iter().chain(cosines).collect();
        self.block.define(&names, &pattern, &value, self.scalar);
        angles.made_of.into_iter().chain(angles.pairs).collect()
    }

    /// Names the two values of an instruction that computes a sine and a cosine.
    fn pair(&mut self, instruction: &Instruction) -> (Ident, Ident) {
        let (sine, cosine) = self.locals.pair(instruction.expression);
        self.texts.insert(instruction.value, Text::atom(&sine));
        self.texts
            .insert(instruction.value + 1, Text::atom(&cosine));
        (sine, cosine)
    }

    fn instruction(&mut self, instruction: &Instruction) {
        let value = instruction.value;
        if let Operation::SineAndCosine(x) = &instruction.operation {
            let value = self.call(self.operand(x), "sin_cos", &[]);
            let (sine, cosine) = self.pair(instruction);
            let pattern = quote!((#sine, #cosine));
            let names = [sine, cosine];
            self.block.define(&names, &pattern, &value, self.scalar);
            return;
        }
        let text = self.operation(&instruction.operation);
        if !self.variables.contain(value) {
            self.texts.insert(value, text);
            return;
        }
        let name = self.locals.value(instruction.expression);
        let pattern = name.to_token_stream();
        self.texts.insert(value, Text::atom(&name));
        self.block
            .define(&[name], &pattern, &text.tokens, self.scalar);
    }

    fn operation(&self, operation: &Operation) -> Text {
        let operands: Vec<Text> = operation
            .operands()
            .map(|operand| self.operand(operand))
            .collect();
        let mut operands = operands.into_iter();
        let mut next = || {
            operands
                .next()
                .unwrap_or_else(|| Text::atom(TokenStream::new()))
        };
        let (tokens, level) = match operation {
            Operation::Add(..) => self.sum(next(), next()),
            Operation::Subtract(..) => self.difference(next(), next()),
            Operation::Multiply(..) => {
                let (x, y) = (next(), next());
                let tokens = infix(x.clone(), '*', y.clone(), Level::Product);
                return Text {
                    tokens,
                    level: Level::Product,
                    factors: self.passes.has(Pass::Fusion).then(|| Box::new([x, y])),
                };
            }
            Operation::Divide(..) => (infix(next(), '/', next(), Level::Product), Level::Product),
            Operation::Negate(_) => (next().negative(), Level::Sign),
            Operation::SquareRoot(_) => (self.call(next(), "sqrt", &[]), Level::Atom),
            Operation::SineAndCosine(_) => (self.call(next(), "sin_cos", &[]), Level::Atom),
            Operation::Unary(function, _) => (self.call(next(), function.name(), &[]), Level::Atom),
            Operation::Binary(function, ..) => {
                let (x, y) = (next(), next());
                (self.call(x, function.name(), &[y.tokens]), Level::Atom)
            }
            Operation::Application(function, _) => {
                let arguments: Vec<_> = operands.map(|text| text.tokens).collect();
                (self.application(*function, &arguments), Level::Atom)
            }
        };
        Text {
            tokens,
            level,
            factors: None,
        }
    }

    fn operand(&self, operand: &Operand) -> Text {
        match operand {
            Operand::Value(value) => self.texts[value].clone(),
            Operand::Symbol(symbol) => Text::atom(&self.symbols[symbol]),
            Operand::Constant(number) => Text::atom(constant(self.scalar, number)),
            Operand::Pi => {
                let functions = self.scalar.functions();
                Text::atom(quote!(#functions::pi()))
            }
            Operand::MinPositive => {
                let functions = self.scalar.functions();
                Text::atom(quote!(#functions::min_positive()))
            }
        }
    }

    /// x + y, with a product among them fused.
    fn sum(&self, x: Text, y: Text) -> (TokenStream, Level) {
        let (factors, summand) = match (x.factors.clone(), y.factors.clone()) {
            (_, Some(factors)) => (factors, x),
            (Some(factors), None) => (factors, y),
            (None, None) => return (infix(x, '+', y, Level::Sum), Level::Sum),
        };
        let [a, b] = *factors;
        (self.fused(a, b, summand.tokens), Level::Atom)
    }

    /// x − y, with a product among them fused.
    fn difference(&self, x: Text, y: Text) -> (TokenStream, Level) {
        let (a, b, summand) = match (x.factors.clone(), y.factors.clone()) {
            (_, Some(factors)) => {
                let [a, b] = *factors;
                (a.opposite(), b, x.tokens)
            }
            (Some(factors), None) => {
                let [a, b] = *factors;
                (a, b, y.negative())
            }
            (None, None) => return (infix(x, '-', y, Level::Sum), Level::Sum),
        };
        (self.fused(a, b, summand), Level::Atom)
    }

    /// a · b + summand.
    fn fused(&self, a: Text, b: Text, summand: TokenStream) -> TokenStream {
        self.call(a, "mul_add", &[b.tokens, summand])
    }

    /// A function from outside, on the scalar.
    fn application(&self, function: Function, arguments: &[TokenStream]) -> TokenStream {
        let name = self.functions.get(function.index());
        let scalar = self.scalar;
        let parameters = scalar.is_every().then(|| quote!(::<#scalar>));
        quote!(self.#name #parameters(#(#arguments),*))
    }

    /// A function of the scalar: as a method, unless that could be another trait's.
    fn call(&self, x: Text, function: &str, arguments: &[TokenStream]) -> TokenStream {
        let function = Ident::new(function, Span::mixed_site());
        if self.scalar.is_ambiguous() {
            let (functions, x) = (self.scalar.functions(), x.tokens);
            quote!(#functions::#function(#x #(, #arguments)*))
        } else {
            let receiver = x.at(Level::Atom);
            quote!(#receiver.#function(#(#arguments),*))
        }
    }
}
