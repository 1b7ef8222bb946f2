//! From a straight-line program to the statements of a method.
//!
//! Each value that is used more than once, or that the declaration names, is a `let`; the others stand
//! where they are used, as a person would write them, though never nested deeply.

mod angles;

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::{
    Function, Instruction, Operand, Operation, Pass, Passes, Phase, Program, Rational, Symbol,
};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use crate::names::Locals;
use crate::scalar::Scalar;
use angles::Angles;

/// How deep expressions are nested in one statement.
const DEEPEST: usize = 6;

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Sign,
    Atom,
}

/// The text of a value.
#[derive(Clone)]
struct Text {
    tokens: TokenStream,
    level: Level,
    depth: usize,
    /// The factors, if this is a product that may be fused with a sum.
    factors: Option<Box<[Self; 2]>>,
}

impl Text {
    fn atom(tokens: impl ToTokens) -> Self {
        Self {
            tokens: tokens.into_token_stream(),
            level: Level::Atom,
            depth: 0,
            factors: None,
        }
    }

    /// −x, which is not fused with anything.
    fn opposite(self) -> Self {
        Self {
            level: Level::Sign,
            depth: self.depth,
            factors: None,
            tokens: self.negative(),
        }
    }

    /// −x.
    fn negative(self) -> TokenStream {
        let x = self.at(Level::Atom);
        quote!(-#x)
    }

    /// The tokens, in parentheses unless they hold together at `level`.
    fn at(self, level: Level) -> TokenStream {
        if self.level >= level {
            self.tokens
        } else {
            TokenTree::Group(Group::new(Delimiter::Parenthesis, self.tokens)).into()
        }
    }
}

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
    /// For each value how often it is used; more than once if a later phase uses it, so that it is not
    /// written twice.
    uses: Vec<usize>,
}

impl<'a> Body<'a> {
    pub(crate) fn new(
        program: &Program,
        passes: Passes,
        locals: Locals<'a>,
        scalar: &'a Scalar<'a>,
        source: &'a dyn Source,
        functions: Vec<Ident>,
    ) -> Self {
        Self {
            passes,
            locals,
            scalar,
            source,
            functions,
            symbols: BTreeMap::new(),
            texts: BTreeMap::new(),
            uses: count_uses(program),
        }
    }

    /// The statements of a phase, and the expressions of its outputs.
    pub(crate) fn phase(&mut self, phase: &Phase) -> (TokenStream, Vec<TokenStream>) {
        let mut statements = TokenStream::new();
        self.load_symbols(phase, &mut statements);
        let done = self.angles(phase, &mut statements);
        for (index, instruction) in phase.instructions.iter().enumerate() {
            if !done.contains(&index) {
                self.instruction(instruction, &mut statements);
            }
        }
        let outputs = phase
            .outputs
            .iter()
            .map(|operand| self.operand(operand).tokens)
            .collect();
        (statements, outputs)
    }

    /// Reads the symbols that no phase before has read.
    fn load_symbols(&mut self, phase: &Phase, statements: &mut TokenStream) {
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
                let scalar = self.scalar;
                statements.extend(quote!(let #name: #scalar = #read;));
                self.symbols.insert(symbol, name);
            }
        }
    }

    /// Computes the sines and cosines that are computed at once; returns the instructions that are done.
    fn angles(&mut self, phase: &Phase, statements: &mut TokenStream) -> BTreeSet<usize> {
        if !self.passes.has(Pass::Vectors) {
            return BTreeSet::new();
        }
        let Some(angles) = Angles::of(phase, |value| self.texts.contains_key(&value)) else {
            return BTreeSet::new();
        };
        for index in &angles.made_of {
            self.instruction(&phase.instructions[*index], statements);
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
        statements.extend(quote! {
            let ([#(#sines),*], [#(#cosines),*]) = #functions::sines_and_cosines([#(#arguments),*]);
        });
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

    fn instruction(&mut self, instruction: &Instruction, statements: &mut TokenStream) {
        let value = instruction.value;
        if let Operation::SineAndCosine(x) = &instruction.operation {
            let value = self.call(self.operand(x), "sin_cos", &[]);
            let (sine, cosine) = self.pair(instruction);
            statements.extend(quote!(let (#sine, #cosine) = #value;));
            return;
        }
        let text = self.operation(&instruction.operation);
        let once = self.uses[value] == 1;
        let named = self.locals.is_defined(instruction.expression);
        if once && !named && text.depth < DEEPEST {
            self.texts.insert(value, text);
            return;
        }
        let name = self.locals.value(instruction.expression);
        let tokens = text.tokens;
        statements.extend(quote!(let #name = #tokens;));
        self.texts.insert(value, Text::atom(name));
    }

    fn operation(&mut self, operation: &Operation) -> Text {
        let operands: Vec<Text> = operation
            .operands()
            .map(|operand| self.operand(operand))
            .collect();
        let depth = 1 + operands.iter().map(|text| text.depth).max().unwrap_or(0);
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
                    depth,
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
            depth,
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

/// How often each value is used; where a phase uses a value of another one, that counts twice.
fn count_uses(program: &Program) -> Vec<usize> {
    let end = |last: &Instruction| last.value + last.operation.results();
    let mut uses = vec![0; program.instructions().last().map_or(0, end)];
    let mut start = 0;
    for phase in &program.phases {
        let mut note = |operand: &Operand| {
            if let Operand::Value(value) = operand {
                uses[*value] += if *value < start { 2 } else { 1 };
            }
        };
        for instruction in &phase.instructions {
            instruction.operation.operands().for_each(&mut note);
        }
        phase.outputs.iter().for_each(&mut note);
        start = phase.instructions.last().map_or(start, end);
    }
    uses
}

fn infix(left: Text, operator: char, right: Text, level: Level) -> TokenStream {
    let mut tokens = left.at(level);
    tokens.extend([TokenTree::Punct(Punct::new(operator, Spacing::Alone))]);
    // The operand on the right keeps its parentheses at the same level: the order of operations is
    // part of what was scheduled.
    let tighter = if level == Level::Sum {
        Level::Product
    } else {
        Level::Sign
    };
    tokens.extend(right.at(tighter));
    tokens
}

/// The scalar nearest to an exact number.
pub(crate) fn constant(scalar: &Scalar<'_>, number: &Rational) -> TokenStream {
    let functions = scalar.functions();
    if let Some((numerator, denominator)) = quotient(number) {
        let (numerator, denominator) = (signed(numerator), signed(denominator));
        return quote!(#functions::ratio(#numerator, #denominator));
    }
    let value = signed(number.to_f64());
    quote!(#functions::from_f64(#value))
}

/// Numerator and denominator of a number that `f64` does not have, if it has those.
#[allow(clippy::cast_precision_loss)] // They are exact.
fn quotient(number: &Rational) -> Option<(f64, f64)> {
    const EXACT: u64 = 1 << 53;
    let (numerator, denominator) = number.to_fraction()?;
    let exact = [numerator, denominator]
        .iter()
        .all(|part| part.unsigned_abs() <= EXACT);
    let dyadic = denominator.unsigned_abs().is_power_of_two();
    (exact && !dyadic).then_some((numerator as f64, denominator as f64))
}

/// The literal of a number, with its sign.
fn signed(value: f64) -> TokenStream {
    let magnitude = literal(value.abs());
    let sign = (value < 0.0).then(|| quote!(-));
    quote!(#sign #magnitude)
}

/// The shortest literal that reads back as `value`, which is not negative.
fn literal(value: f64) -> TokenStream {
    let written = format!("{value:?}");
    match written.parse::<Literal>() {
        Ok(literal) => literal.into_token_stream(),
        // Not a number, or infinite: there is no literal.
        Err(_) if value.is_nan() => quote!(::core::primitive::f64::NAN),
        Err(_) => quote!(::core::primitive::f64::INFINITY),
    }
}
