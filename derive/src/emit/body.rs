//! From a straight-line program to the statements of a method.
//!
//! Each value that is used more than once, or that the declaration names, is a variable; the others are inlined
//! where they are used, up to a depth of nesting.

pub(super) mod variables;
mod pieces;
mod in_pieces;
mod block;
mod angles;
mod symbols;
mod fragment;
mod constant;

use std::collections::{BTreeMap, BTreeSet, HashMap};

use lagrangian_symbolic::{
    ExternalFunction, Instruction, Operand, Operation, OutputGroup, Pass, Passes, Program, Symbol,
};
use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use super::locals::Locals;
use crate::limits::{BodyLimits, MAX_STATEMENT_WIDTH, STATEMENTS_PER_PIECE};
use crate::syntax::scalar::Scalar;
use angles::Angles;
use block::{Block, Form};
use constant::constant;
use fragment::{Fragment, Precedence, infix};
use pieces::Read;
use symbols::last_call;
pub(crate) use symbols::{Array, Element, SymbolReader};
use variables::Variables;

/// Writes the groups of one program, one after the other.
pub(crate) struct Body<'a> {
    passes: Passes,
    locals: Locals<'a>,
    scalar: &'a Scalar<'a>,
    source: &'a dyn SymbolReader,
    /// The methods that compute external functions, in the order of declaration.
    functions: Vec<Ident>,
    symbols: BTreeMap<Symbol, Ident>,
    /// By value: what it is written as. One that is no variable is used once, and taken from here.
    fragments: Vec<Option<Fragment>>,
    /// In a method in pieces: what the fragment of a value reads.
    reads: Vec<Vec<Read>>,
    /// The symbols that have been read, in a method in pieces before these.
    read_before: BTreeSet<Symbol>,
    /// In a method in pieces: the arrays of the values of groups that are written, and their lengths.
    arrays: Vec<(Ident, usize)>,
    /// The arrays of symbols that pieces are given, by name, and their lengths.
    given: BTreeMap<Ident, usize>,
    /// The arrays, elements and names of what pieces read.
    homes: HashMap<Read, (Ident, usize, Ident)>,
    /// How many statements a piece of a long method has.
    piece_length: usize,
    variables: Variables,
    block: Block<'a>,
    /// Whether the group that is written is long.
    is_long: bool,
}

impl<'a> Body<'a> {
    pub(crate) fn new(
        program: &Program,
        passes: Passes,
        locals: Locals<'a>,
        scalar: &'a Scalar<'a>,
        source: &'a dyn SymbolReader,
        functions: Vec<Ident>,
        limits: BodyLimits,
    ) -> Self {
        let mut variables = Variables::of(program, |value| locals.is_defined(value));
        let scopes = program.symbols().len() + variables.count();
        let form = match scopes {
            _ if scopes <= limits.most_scopes => Form::Nested,
            _ if scopes <= limits.most_assigned => Form::Assigned,
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
            fragments: Vec::new(),
            reads: Vec::new(),
            read_before: BTreeSet::new(),
            arrays: Vec::new(),
            given: BTreeMap::new(),
            homes: HashMap::new(),
            piece_length: STATEMENTS_PER_PIECE.min(limits.most_scopes).max(1),
            variables,
            block: Block::new(form, scalar),
            is_long: false,
        }
    }

    /// The statements of a group, and the expressions of its outputs.
    pub(crate) fn group(&mut self, group: &OutputGroup) -> (TokenStream, Vec<TokenStream>) {
        self.is_long = group.is_long();
        let symbols = self.name_symbols(group);
        let angles = self.angles_at_once(group);
        let mut done = vec![false; group.instructions.len()];
        for index in angles.iter().flat_map(Angles::instructions) {
            done[index] = true;
        }
        let last_call = last_call(group, &done);
        let (first, rest) = self.split_at_call(group, symbols, (&done, last_call));
        self.load_symbols(&first);
        if let Some(angles) = angles {
            self.angles(group, &angles);
        }
        if last_call.is_none() {
            self.load_symbols(&rest);
        }
        for (index, instruction) in group.instructions.iter().enumerate() {
            if !done[index] {
                self.load_operands(instruction.operation.operands());
                self.instruction(instruction);
            }
            if last_call == Some(index) {
                self.load_symbols(&rest);
            }
        }
        self.load_operands(group.outputs.iter());
        let (statements, tokens) = self.block.take_statements();
        let mut written = self.block.take();
        if !statements.is_empty() {
            written.extend(self.pieces(&statements, tokens));
        }
        let outputs = group.outputs.iter();
        let outputs = outputs.map(|operand| self.operand(operand).into_tokens());
        let outputs = outputs.collect();
        (written, outputs)
    }

    /// The sines and cosines that are computed at once, and before everything else.
    fn angles_at_once(&self, group: &OutputGroup) -> Option<Angles> {
        let is_written = |value: usize| matches!(self.fragments.get(value), Some(Some(_)));
        let has_pass = self.passes.has(Pass::Vectors);
        has_pass.then(|| Angles::of(group, is_written)).flatten()
    }

    /// Computes these sines and cosines.
    fn angles(&mut self, group: &OutputGroup, angles: &Angles) {
        for index in angles.instructions() {
            self.load_operands(group.instructions[index].operation.operands());
        }
        for index in &angles.operands_of_angles {
            self.instruction(&group.instructions[*index]);
        }
        let (mut arguments, mut sines, mut cosines) = (Vec::new(), Vec::new(), Vec::new());
        let (mut defines, mut reads) = (Vec::new(), Vec::new());
        for index in &angles.pairs {
            let instruction = &group.instructions[*index];
            let operands = instruction.operation.operands();
            arguments.extend(operands.map(|operand| self.operand(operand).into_tokens()));
            reads.extend(self.reads_of(&instruction.operation));
            let (sine, cosine) = self.pair(instruction);
            defines.push((instruction.value, sine.clone()));
            defines.push((instruction.value + 1, cosine.clone()));
            sines.push(sine);
            cosines.push(cosine);
        }
        let functions = self.scalar.functions();
        let pattern = quote!(([#(#sines),*], [#(#cosines),*]));
        let mut value = quote!(#functions::sines_and_cosines([#(#arguments),*]));
        let width = pattern.to_string().len() + value.to_string().len();
        if self.block.is_nested() && width > MAX_STATEMENT_WIDTH {
            let arrays = ["sines", "cosines"].map(|name| self.locals.free(name.to_owned()));
            let pair = quote!((#(#arrays),*));
            self.block
                .define(Vec::new(), pair.clone(), value, Vec::new(), false);
            value = pair;
        }
        self.block.define(defines, pattern, value, reads, false);
    }

    /// Names the two values of an instruction that computes a sine and a cosine.
    fn pair(&mut self, instruction: &Instruction) -> (Ident, Ident) {
        let (sine, cosine) = self.locals.pair(instruction.expression);
        self.write(instruction.value, Fragment::atom(&sine));
        self.write(instruction.value + 1, Fragment::atom(&cosine));
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
            let x = self.operand(x);
            let call = self.call(x, "sin_cos", Vec::new());
            let (sine, cosine) = self.pair(instruction);
            let pattern = quote!((#sine, #cosine));
            let defines = vec![(value, sine), (value + 1, cosine)];
            self.block
                .define(defines, pattern, call, reads, calls_model);
            return;
        }
        let fragment = self.operation(&instruction.operation);
        if !self.variables.contain(value) {
            self.write(value, fragment);
            self.is_read(value, reads);
            return;
        }
        let name = self.locals.value(instruction.expression);
        let pattern = name.to_token_stream();
        self.write(value, Fragment::atom(&name));
        self.is_read(value, vec![Read::Value(value)]);
        let defines = vec![(value, name)];
        self.block
            .define(defines, pattern, fragment.into_tokens(), reads, calls_model);
    }

    /// Notes what a value is written as.
    fn write(&mut self, value: usize, fragment: Fragment) {
        if self.fragments.len() <= value {
            self.fragments.resize(value + 1, None);
        }
        self.fragments[value] = Some(fragment);
    }

    /// In a method in pieces: what an expression reads that contains a value.
    fn is_read(&mut self, value: usize, reads: Vec<Read>) {
        if self.block.is_in_pieces() {
            if self.reads.len() <= value {
                self.reads.resize(value + 1, Vec::new());
            }
            self.reads[value] = reads;
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
                    if let Some(of_value) = self.reads.get(*value) {
                        reads.extend_from_slice(of_value);
                    }
                }
                Operand::Symbol(symbol) => reads.push(Read::Symbol(*symbol)),
                _ => {}
            }
        }
        reads
    }

    fn operation(&mut self, operation: &Operation) -> Fragment {
        let mut operands = Vec::with_capacity(2);
        for operand in operation.operands() {
            operands.push(self.operand(operand));
        }
        let mut operands = operands.into_iter();
        let mut next = || {
            operands
                .next()
                .unwrap_or_else(|| Fragment::atom(TokenStream::new()))
        };
        match operation {
            Operation::Add(x, y) => self.sum(next(), next(), self.is_in_order(x, y)),
            Operation::Subtract(x, y) => self.difference(next(), next(), self.is_in_order(x, y)),
            Operation::Multiply(..) if self.passes.has(Pass::Fusion) => {
                Fragment::product(next(), next())
            }
            Operation::Multiply(..) => {
                let tokens = infix(next(), '*', next(), Precedence::Product);
                Fragment::new(tokens, Precedence::Product)
            }
            Operation::Divide(..) => {
                let tokens = infix(next(), '/', next(), Precedence::Product);
                Fragment::new(tokens, Precedence::Product)
            }
            Operation::Negate(_) => next().negated(),
            Operation::SquareRoot(_) => Fragment::atom(self.call(next(), "sqrt", Vec::new())),
            Operation::SineAndCosine(_) => Fragment::atom(self.call(next(), "sin_cos", Vec::new())),
            Operation::Unary(function, _) => {
                Fragment::atom(self.call(next(), function.name(), Vec::new()))
            }
            Operation::Binary(function, ..) => {
                let (x, y) = (next(), next());
                Fragment::atom(self.call(x, function.name(), vec![y.into_tokens()]))
            }
            Operation::Application(function, _) => {
                let arguments: Vec<_> = operands.map(Fragment::into_tokens).collect();
                Fragment::atom(self.application(*function, &arguments))
            }
        }
    }

    fn operand(&mut self, operand: &Operand) -> Fragment {
        match operand {
            Operand::Value(value) => {
                let written = self.fragments.get_mut(*value);
                // Tokens that nothing else holds are moved, and not copied, into what they are inlined in.
                let written = match written {
                    Some(written) if self.variables.contain(*value) => written.clone(),
                    Some(written) => written.take(),
                    None => None,
                };
                written.unwrap_or_else(|| Fragment::atom(TokenStream::new()))
            }
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

    /// Whether the second of two products is fused with their sum: in a long group the one that is computed last.
    fn is_in_order(&self, x: &Operand, y: &Operand) -> bool {
        !self.is_long || x.value() <= y.value()
    }

    /// x + y, with a product among them fused: of two the second one, if they are in order.
    fn sum(&self, x: Fragment, y: Fragment, in_order: bool) -> Fragment {
        let (first, last) = if in_order { (x, y) } else { (y, x) };
        let last = match last.into_factors() {
            Ok([a, b]) => return self.fused(a, b, first),
            Err(last) => last,
        };
        match first.into_factors() {
            Ok([a, b]) => self.fused(a, b, last),
            Err(first) => {
                let (x, y) = if in_order {
                    (first, last)
                } else {
                    (last, first)
                };
                Fragment::new(infix(x, '+', y, Precedence::Sum), Precedence::Sum)
            }
        }
    }

    /// x − y, with a product among them fused: of two the second one, if they are in order.
    fn difference(&self, x: Fragment, y: Fragment, in_order: bool) -> Fragment {
        let x = match x.into_factors() {
            Ok([a, b]) if !in_order => return self.fused(a, b, y.negated()),
            Ok([a, b]) => Fragment::product(a, b),
            Err(x) => x,
        };
        let y = match y.into_factors() {
            Ok([a, b]) => return self.fused(a.negated(), b, x),
            Err(y) => y,
        };
        match x.into_factors() {
            Ok([a, b]) => self.fused(a, b, y.negated()),
            Err(x) => Fragment::new(infix(x, '-', y, Precedence::Sum), Precedence::Sum),
        }
    }

    /// a · b + summand.
    fn fused(&self, a: Fragment, b: Fragment, summand: Fragment) -> Fragment {
        let arguments = vec![b.into_tokens(), summand.into_tokens()];
        Fragment::atom(self.call(a, "mul_add", arguments))
    }

    /// An external function, on the scalar.
    fn application(&self, function: ExternalFunction, arguments: &[TokenStream]) -> TokenStream {
        let name = self.functions.get(function.index());
        let scalar = self.scalar;
        let parameters = scalar.is_generic().then(|| quote!(::<#scalar>));
        quote!(self.#name #parameters(#(#arguments),*))
    }

    /// A function of the scalar: as a method, unless that could be another trait's.
    fn call(&self, x: Fragment, function: &str, arguments: Vec<TokenStream>) -> TokenStream {
        let function = Ident::new(function, Span::mixed_site());
        let is_ambiguous = self.scalar.is_ambiguous();
        let sign = |sign| TokenTree::Punct(Punct::new(sign, Spacing::Alone));
        let (mut call, receiver) = if is_ambiguous {
            let functions = self.scalar.functions();
            (quote!(#functions::#function), Some(x.into_tokens()))
        } else {
            let mut call = x.in_parentheses_below(Precedence::Atom);
            call.extend([sign('.'), TokenTree::Ident(function)]);
            (call, None)
        };
        let mut list = TokenStream::new();
        for (position, argument) in receiver.into_iter().chain(arguments).enumerate() {
            if position > 0 {
                list.extend([sign(',')]);
            }
            list.extend(argument);
        }
        call.extend([TokenTree::Group(Group::new(Delimiter::Parenthesis, list))]);
        call
    }
}
