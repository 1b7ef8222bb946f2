//! From a straight-line program to the statements of a method.
//!
//! Each value that is used more than once, or that the declaration names, is a variable; the others are inlined
//! where they are used, up to a depth of nesting.

mod variables;
mod pieces;
mod in_pieces;
mod block;
mod angles;
mod fragment;
mod constant;

use std::collections::{BTreeMap, BTreeSet, HashMap};

use lagrangian_symbolic::{
    ExternalFunction, Instruction, Operand, Operation, OutputGroup, Pass, Passes, Program, Symbol,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};

use super::locals::Locals;
use crate::limits::{MOST_ASSIGNED, STATEMENTS_PER_PIECE};
use crate::syntax::scalar::Scalar;
use angles::Angles;
use block::{Block, Form};
use constant::constant;
use fragment::{Fragment, Precedence, infix};
use pieces::Read;
use variables::Variables;

/// Where the emitted code finds a symbol's value.
pub(crate) trait SymbolReader {
    /// The expression that reads `symbol`.
    fn read(&self, symbol: Symbol) -> TokenStream;
}

/// Writes the groups of one program, one after the other.
pub(crate) struct Body<'a> {
    passes: Passes,
    locals: Locals<'a>,
    scalar: &'a Scalar<'a>,
    source: &'a dyn SymbolReader,
    /// The methods that compute external functions, in the order of declaration.
    functions: Vec<Ident>,
    symbols: BTreeMap<Symbol, Ident>,
    fragments: HashMap<usize, Fragment>,
    /// In a method in pieces: what the fragment of a value reads.
    reads: HashMap<usize, Vec<Read>>,
    /// In a method in pieces: the symbols that have been read before the pieces.
    read_before: BTreeSet<Symbol>,
    /// In a method in pieces: the arrays of the values of groups that are written, and their lengths.
    arrays: Vec<(Ident, usize)>,
    /// The arrays, elements and names of what pieces read.
    homes: HashMap<Read, (Ident, usize, Ident)>,
    /// How many statements a piece of a long method has.
    piece_length: usize,
    variables: Variables,
    block: Block,
}

impl<'a> Body<'a> {
    pub(crate) fn new(
        program: &Program,
        passes: Passes,
        locals: Locals<'a>,
        scalar: &'a Scalar<'a>,
        source: &'a dyn SymbolReader,
        functions: Vec<Ident>,
        most_scopes: usize,
    ) -> Self {
        let mut variables = Variables::of(program, |value| locals.is_defined(value));
        let scopes = program.symbols().len() + variables.count();
        let form = match scopes {
            _ if scopes <= most_scopes => Form::Nested,
            _ if scopes <= most_scopes.saturating_mul(MOST_ASSIGNED) => Form::Assigned,
            _ => Form::Pieces,
        };
        if form == Form::Pieces {
            variables.add_ends_of_pieces(program);
        }
        Self {
            passes,
            locals,
            scalar,
            source,
            functions,
            symbols: BTreeMap::new(),
            fragments: HashMap::new(),
            reads: HashMap::new(),
            read_before: BTreeSet::new(),
            arrays: Vec::new(),
            homes: HashMap::new(),
            piece_length: STATEMENTS_PER_PIECE.min(most_scopes).max(1),
            variables,
            block: Block::new(form),
        }
    }

    /// The statements of a group, and the expressions of its outputs.
    pub(crate) fn group(&mut self, group: &OutputGroup) -> (TokenStream, Vec<TokenStream>) {
        self.load_symbols(group);
        let done = self.angles(group);
        for (index, instruction) in group.instructions.iter().enumerate() {
            if !done.contains(&index) {
                self.instruction(instruction);
            }
        }
        let statements = self.block.take_statements();
        let mut written = self.block.take(self.scalar);
        if !statements.is_empty() {
            written.extend(self.pieces(&statements));
        }
        let outputs = group.outputs.iter();
        let outputs = outputs.map(|operand| self.operand(operand).tokens);
        (written, outputs.collect())
    }

    /// Reads the symbols that no group before has read.
    fn load_symbols(&mut self, group: &OutputGroup) {
        let operands = group
            .instructions
            .iter()
            .flat_map(|instruction| instruction.operation.operands());
        let symbols = |operand: &Operand| match operand {
            Operand::Symbol(symbol) => Some(*symbol),
            _ => None,
        };
        let wanted: BTreeSet<Symbol> = operands.chain(&group.outputs).filter_map(symbols).collect();
        for symbol in wanted {
            if !self.symbols.contains_key(&symbol) {
                let name = self.locals.symbol(symbol);
                self.symbols.insert(symbol, name);
            } else if !self.block.is_in_pieces() {
                continue;
            }
            // Each piece reads what it needs.
            let is_output = || group.outputs.contains(&Operand::Symbol(symbol));
            if !self.block.is_in_pieces() || (is_output() && self.read_before.insert(symbol)) {
                let (name, read) = (&self.symbols[&symbol], self.source.read(symbol));
                self.block.read(name, &read, self.scalar);
            }
        }
    }

    /// Computes the sines and cosines that are computed at once; returns the instructions that are done.
    fn angles(&mut self, group: &OutputGroup) -> BTreeSet<usize> {
        if !self.passes.has(Pass::Vectors) {
            return BTreeSet::new();
        }
        let Some(angles) = Angles::of(group, |value| self.fragments.contains_key(&value)) else {
            return BTreeSet::new();
        };
        for index in &angles.operands_of_angles {
            self.instruction(&group.instructions[*index]);
        }
        let (mut arguments, mut sines, mut cosines) = (Vec::new(), Vec::new(), Vec::new());
        let (mut defines, mut reads) = (Vec::new(), Vec::new());
        for index in &angles.pairs {
            let instruction = &group.instructions[*index];
            let operands = instruction.operation.operands();
            arguments.extend(operands.map(|operand| self.operand(operand).tokens));
            reads.extend(self.reads_of(&instruction.operation));
            let (sine, cosine) = self.pair(instruction);
            defines.push((instruction.value, sine.clone()));
            defines.push((instruction.value + 1, cosine.clone()));
            sines.push(sine);
            cosines.push(cosine);
        }
        let functions = self.scalar.functions();
        let pattern = quote!(([#(#sines),*], [#(#cosines),*]));
        let value = quote!(#functions::sines_and_cosines([#(#arguments),*]));
        self.block
            .define(defines, &pattern, &value, reads, false, self.scalar);
        angles
            .operands_of_angles
            .into_iter()
            .chain(angles.pairs)
            .collect()
    }

    /// Names the two values of an instruction that computes a sine and a cosine.
    fn pair(&mut self, instruction: &Instruction) -> (Ident, Ident) {
        let (sine, cosine) = self.locals.pair(instruction.expression);
        self.fragments
            .insert(instruction.value, Fragment::atom(&sine));
        self.fragments
            .insert(instruction.value + 1, Fragment::atom(&cosine));
        for value in [instruction.value, instruction.value + 1] {
            self.is_read(value, vec![Read::Value(value)]);
        }
        (sine, cosine)
    }

    fn instruction(&mut self, instruction: &Instruction) {
        let value = instruction.value;
        let reads = self.reads_of(&instruction.operation);
        let calls_model = matches!(instruction.operation, Operation::Application(..));
        if let Operation::SineAndCosine(x) = &instruction.operation {
            let call = self.call(self.operand(x), "sin_cos", &[]);
            let (sine, cosine) = self.pair(instruction);
            let pattern = quote!((#sine, #cosine));
            let defines = vec![(value, sine), (value + 1, cosine)];
            self.block
                .define(defines, &pattern, &call, reads, calls_model, self.scalar);
            return;
        }
        let fragment = self.operation(&instruction.operation);
        if !self.variables.contain(value) {
            self.fragments.insert(value, fragment);
            self.is_read(value, reads);
            return;
        }
        let name = self.locals.value(instruction.expression);
        let pattern = name.to_token_stream();
        self.fragments.insert(value, Fragment::atom(&name));
        self.is_read(value, vec![Read::Value(value)]);
        let defines = vec![(value, name)];
        self.block.define(
            defines,
            &pattern,
            &fragment.tokens,
            reads,
            calls_model,
            self.scalar,
        );
    }

    /// In a method in pieces: what an expression reads that contains a value.
    fn is_read(&mut self, value: usize, reads: Vec<Read>) {
        if self.block.is_in_pieces() {
            self.reads.insert(value, reads);
        }
    }

    /// In a method in pieces: the variables and symbols that an operation reads, through what is inlined in it.
    fn reads_of(&self, operation: &Operation) -> Vec<Read> {
        if !self.block.is_in_pieces() {
            return Vec::new();
        }
        let mut reads = Vec::new();
        for operand in operation.operands() {
            match operand {
                Operand::Value(value) => {
                    reads.extend(self.reads.get(value).into_iter().flatten().copied());
                }
                Operand::Symbol(symbol) => reads.push(Read::Symbol(*symbol)),
                _ => {}
            }
        }
        reads
    }

    fn operation(&self, operation: &Operation) -> Fragment {
        let operands: Vec<Fragment> = operation
            .operands()
            .map(|operand| self.operand(operand))
            .collect();
        let mut operands = operands.into_iter();
        let mut next = || {
            operands
                .next()
                .unwrap_or_else(|| Fragment::atom(TokenStream::new()))
        };
        let (tokens, precedence) = match operation {
            Operation::Add(..) => self.sum(next(), next()),
            Operation::Subtract(..) => self.difference(next(), next()),
            Operation::Multiply(..) => {
                let (x, y) = (next(), next());
                let tokens = infix(x.clone(), '*', y.clone(), Precedence::Product);
                return Fragment {
                    tokens,
                    precedence: Precedence::Product,
                    factors: self.passes.has(Pass::Fusion).then(|| Box::new([x, y])),
                };
            }
            Operation::Divide(..) => (
                infix(next(), '/', next(), Precedence::Product),
                Precedence::Product,
            ),
            Operation::Negate(_) => (next().negated_tokens(), Precedence::Sign),
            Operation::SquareRoot(_) => (self.call(next(), "sqrt", &[]), Precedence::Atom),
            Operation::SineAndCosine(_) => (self.call(next(), "sin_cos", &[]), Precedence::Atom),
            Operation::Unary(function, _) => {
                (self.call(next(), function.name(), &[]), Precedence::Atom)
            }
            Operation::Binary(function, ..) => {
                let (x, y) = (next(), next());
                (self.call(x, function.name(), &[y.tokens]), Precedence::Atom)
            }
            Operation::Application(function, _) => {
                let arguments: Vec<_> = operands.map(|fragment| fragment.tokens).collect();
                (self.application(*function, &arguments), Precedence::Atom)
            }
        };
        Fragment {
            tokens,
            precedence,
            factors: None,
        }
    }

    fn operand(&self, operand: &Operand) -> Fragment {
        match operand {
            Operand::Value(value) => self.fragments[value].clone(),
            Operand::Symbol(symbol) => Fragment::atom(&self.symbols[symbol]),
            Operand::Constant(number) => Fragment::atom(constant(self.scalar, number)),
            Operand::Pi => {
                let functions = self.scalar.functions();
                Fragment::atom(quote!(#functions::pi()))
            }
            Operand::MinPositive => {
                let functions = self.scalar.functions();
                Fragment::atom(quote!(#functions::min_positive()))
            }
        }
    }

    /// x + y, with a product among them fused.
    fn sum(&self, x: Fragment, y: Fragment) -> (TokenStream, Precedence) {
        let (factors, summand) = match (x.factors.clone(), y.factors.clone()) {
            (_, Some(factors)) => (factors, x),
            (Some(factors), None) => (factors, y),
            (None, None) => return (infix(x, '+', y, Precedence::Sum), Precedence::Sum),
        };
        let [a, b] = *factors;
        (self.fused(a, b, summand.tokens), Precedence::Atom)
    }

    /// x − y, with a product among them fused.
    fn difference(&self, x: Fragment, y: Fragment) -> (TokenStream, Precedence) {
        let (a, b, summand) = match (x.factors.clone(), y.factors.clone()) {
            (_, Some(factors)) => {
                let [a, b] = *factors;
                (a.negated(), b, x.tokens)
            }
            (Some(factors), None) => {
                let [a, b] = *factors;
                (a, b, y.negated_tokens())
            }
            (None, None) => return (infix(x, '-', y, Precedence::Sum), Precedence::Sum),
        };
        (self.fused(a, b, summand), Precedence::Atom)
    }

    /// a · b + summand.
    fn fused(&self, a: Fragment, b: Fragment, summand: TokenStream) -> TokenStream {
        self.call(a, "mul_add", &[b.tokens, summand])
    }

    /// An external function, on the scalar.
    fn application(&self, function: ExternalFunction, arguments: &[TokenStream]) -> TokenStream {
        let name = self.functions.get(function.index());
        let scalar = self.scalar;
        let parameters = scalar.is_generic().then(|| quote!(::<#scalar>));
        quote!(self.#name #parameters(#(#arguments),*))
    }

    /// A function of the scalar: as a method, unless that could be another trait's.
    fn call(&self, x: Fragment, function: &str, arguments: &[TokenStream]) -> TokenStream {
        let function = Ident::new(function, Span::mixed_site());
        if self.scalar.is_ambiguous() {
            let (functions, x) = (self.scalar.functions(), x.tokens);
            quote!(#functions::#function(#x #(, #arguments)*))
        } else {
            let receiver = x.in_parentheses_below(Precedence::Atom);
            quote!(#receiver.#function(#(#arguments),*))
        }
    }
}
