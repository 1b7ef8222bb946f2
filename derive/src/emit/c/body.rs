//! The statements of a straight-line program in C: one for each instruction, in its order.
//!
//! Products are fused with the sums with which they are fused in Rust, so that both round alike.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use lagrangian_symbolic::{
    Instruction, LiveValues, Operand, Operation, OutputGroup, Pass, Passes, Program, Rational,
    Symbol,
};

use crate::emit::body::variables::Variables;
use crate::emit::locals::Locals;
use crate::plan::OutputSlice;

/// Outputs that are not needed: some of consecutive ones, by their indices.
pub(super) type Unneeded<'b> = (&'b OutputSlice, &'b dyn Fn(usize) -> bool);

/// A function in C that contains the statements of a program.
pub(super) struct Body<'a> {
    program: &'a Program,
    /// How parameters are read.
    parameters: &'a [String],
    /// The sums that are fused with a product, by their values.
    fusions: BTreeMap<usize, Fusion<'a>>,
    /// The products that are.
    fused: BTreeSet<usize>,
    needed: LiveValues,
    /// How many groups are written.
    written: usize,
    /// The values that are written before their group.
    hoisted: BTreeSet<usize>,
    /// What the statements read of the point at which the function is evaluated.
    reads: BTreeSet<&'static str>,
    text: String,
    depth: usize,
}

/// A sum a b + c: the factors and the other operand, as they are written before.
struct Fusion<'a> {
    factors: [&'a Operand; 2],
    other: &'a Operand,
    /// The signs of the product and of the other operand.
    signs: [&'static str; 2],
}

/// The products of a program that may be fused, with their factors.
struct Products<'a>(BTreeMap<usize, [&'a Operand; 2]>);

impl<'a> Products<'a> {
    fn of(program: &'a Program, passes: Passes, locals: &Locals<'_>) -> Self {
        let mut products = BTreeMap::new();
        if passes.has(Pass::Fusion) {
            let variables = Variables::of(program, |value| locals.is_defined(value));
            for instruction in program.instructions() {
                if let Operation::Multiply(x, y) = &instruction.operation
                    && !variables.contain(instruction.value)
                {
                    products.insert(instruction.value, [x, y]);
                }
            }
        }
        Self(products)
    }

    /// The product that is fused with a sum or a difference, and the sum: of two products the second one, in a long group the one
    /// that is computed last.
    fn fusion(&self, operation: &'a Operation, is_long: bool) -> Option<(usize, Fusion<'a>)> {
        let (x, y, of_x, of_y) = match operation {
            Operation::Add(x, y) => (x, y, ["", ""], ["", ""]),
            Operation::Subtract(x, y) => (x, y, ["", "-"], ["-", ""]),
            _ => return None,
        };
        let in_order = !is_long || x.value() <= y.value();
        let (first, last) = ((x, y, of_x), (y, x, of_y));
        let tried = if in_order {
            [last, first]
        } else {
            [first, last]
        };
        tried.into_iter().find_map(|(product, other, signs)| {
            let value = product.value()?;
            let factors = *self.0.get(&value)?;
            let fusion = Fusion {
                factors,
                other,
                signs,
            };
            Some((value, fusion))
        })
    }
}

impl<'a> Body<'a> {
    /// The function of a program, of which some outputs may not be needed.
    pub(super) fn new(
        program: &'a Program,
        (passes, locals): (Passes, &Locals<'_>),
        parameters: &'a [String],
        unneeded: &[Unneeded<'_>],
    ) -> Self {
        let products = Products::of(program, passes, locals);
        let (mut fusions, mut fused) = (BTreeMap::new(), BTreeSet::new());
        for group in &program.groups {
            for instruction in &group.instructions {
                let found = products.fusion(&instruction.operation, group.is_long());
                if let Some((product, fusion)) = found {
                    fused.insert(product);
                    fusions.insert(instruction.value, fusion);
                }
            }
        }
        Self {
            program,
            parameters,
            fusions,
            fused,
            needed: needed(program, unneeded),
            written: 0,
            hoisted: BTreeSet::new(),
            reads: BTreeSet::new(),
            text: String::new(),
            depth: 1,
        }
    }

    /// Appends a line.
    pub(super) fn line(&mut self, line: &str) {
        if line.starts_with('}') {
            self.depth = self.depth.saturating_sub(1);
        }
        self.text.push_str(&"    ".repeat(self.depth));
        self.text.push_str(line);
        self.text.push('\n');
        if line.ends_with('{') {
            self.depth += 1;
        }
    }

    /// Writes the statements that do not depend on the variation, in front of the loop over its directions.
    pub(super) fn compute_without_variation(&mut self) {
        let program = self.program;
        let mut varies = BTreeSet::new();
        for instruction in program.instructions() {
            let is_varied = |operand: &Operand| match operand {
                Operand::Symbol(Symbol::Variation(_)) => true,
                Operand::Value(value) => varies.contains(value),
                _ => false,
            };
            let value = instruction.value;
            if instruction.operation.operands().any(is_varied) {
                varies.extend(instruction.values());
            } else {
                self.needed_instruction(instruction);
                self.hoisted.insert(value);
            }
        }
    }

    /// Writes the statements that compute some outputs, as far as they are not written yet, and returns the outputs.
    pub(super) fn compute(&mut self, slice: &OutputSlice) -> Vec<String> {
        self.compute_some(slice, |_| true)
    }

    /// Computes some outputs, by their indices; the others are empty.
    pub(super) fn compute_some(
        &mut self,
        slice: &OutputSlice,
        is_wanted: impl Fn(usize) -> bool,
    ) -> Vec<String> {
        let program = self.program;
        let groups = program.groups.iter();
        for group in groups.take(slice.group() + 1).skip(self.written) {
            self.group(group);
            self.written += 1;
        }
        let outputs = slice.operands(program).iter().enumerate();
        let outputs = outputs.map(|(index, output)| {
            if is_wanted(index) {
                self.operand(output)
            } else {
                String::new()
            }
        });
        outputs.collect()
    }

    /// Whether the program reads accelerations or multipliers.
    pub(super) fn reads_accelerations(&self) -> bool {
        let symbols = self.program.symbols().into_iter();
        let mut symbols = symbols.filter(|symbol| matches!(symbol, Symbol::Acceleration(_)));
        symbols.next().is_some()
    }

    /// Whether what is written reads the variation.
    pub(super) fn reads_variation(&self) -> bool {
        self.reads.contains("delta")
    }

    /// Assigns values to the elements of an array.
    pub(super) fn assign(
        &mut self,
        array: &str,
        values: impl IntoIterator<Item = (usize, String)>,
    ) {
        for (index, value) in values {
            self.line(&format!("{array}[{index}] = {value};"));
        }
    }

    /// The function with this signature, which is evaluated at a point.
    pub(super) fn into_function(self, signature: &str) -> String {
        let mut declarations = String::new();
        let is_argument = |name: &str| {
            signature.contains(&format!("*{name},")) || signature.contains(&format!("*{name})"))
        };
        for read in &self.reads {
            let declaration = match *read {
                "t" => "const double t = at->t;",
                // Where it is an argument of its own.
                "p" if is_argument("p") => continue,
                "p" => "const $_parameters *const p = at->p;",
                "q" => "const double *const q = at->q;",
                "v" => "const double *const v = at->v;",
                "u" => "const double *const u = at->u;",
                "z" => "const double *const z = at->z;",
                _ => continue,
            };
            // Writing to a `String` does not fail.
            let _ = writeln!(declarations, "    {declaration}");
        }
        for argument in ["at", "a", "p", "x"] {
            let is_used = mentions(&self.text, argument) || mentions(&declarations, argument);
            if is_argument(argument) && !is_used {
                let _ = writeln!(declarations, "    (void){argument};");
            }
        }
        format!("{signature}\n{{\n{declarations}{}}}\n", self.text)
    }

    fn group(&mut self, group: &OutputGroup) {
        for instruction in &group.instructions {
            if !self.hoisted.contains(&instruction.value) {
                self.needed_instruction(instruction);
            }
        }
    }

    /// Writes an instruction, if it is needed and not part of another one.
    fn needed_instruction(&mut self, instruction: &Instruction) {
        if self.needed.contain(instruction) && !self.fused.contains(&instruction.value) {
            self.instruction(instruction);
        }
    }

    fn instruction(&mut self, instruction: &Instruction) {
        let value = instruction.value;
        if let Operation::SineAndCosine(x) = &instruction.operation {
            let x = self.operand(x);
            let next = value + 1;
            self.line(&format!("double s{value}, s{next};"));
            self.line(&format!("$_sin_cos({x}, &s{value}, &s{next});"));
            return;
        }
        let computed = match self.fusions.remove(&value) {
            Some(fusion) => self.fusion(&fusion),
            None => self.operation(&instruction.operation),
        };
        self.line(&format!("const double s{value} = {computed};"));
    }

    fn fusion(&mut self, fusion: &Fusion<'_>) -> String {
        let [x, y] = fusion.factors.map(|factor| self.operand(factor));
        let (other, [of_product, of_other]) = (self.operand(fusion.other), fusion.signs);
        format!("$_mul_add({of_product}{x}, {y}, {of_other}{other})")
    }

    fn operation(&mut self, operation: &Operation) -> String {
        let operands: Vec<String> = operation.operands().map(|x| self.operand(x)).collect();
        let call = |name: Option<&str>, own: &str| match name {
            Some(name) => format!("{name}({})", operands.join(", ")),
            None => format!("$_{own}({})", operands.join(", ")),
        };
        match operation {
            Operation::Add(..) => operands.join(" + "),
            Operation::Subtract(..) => operands.join(" - "),
            Operation::Multiply(..) => operands.join(" * "),
            Operation::Divide(..) => operands.join(" / "),
            Operation::Negate(_) => format!("-{}", operands.concat()),
            Operation::SquareRoot(_) => call(Some("sqrt"), ""),
            Operation::Unary(function, _) => call(function.c_name(), function.name()),
            Operation::Binary(function, ..) => call(function.c_name(), function.name()),
            // The one is written before, the other one is an error before.
            Operation::SineAndCosine(_) | Operation::Application(..) => String::new(),
        }
    }

    fn operand(&mut self, operand: &Operand) -> String {
        match operand {
            Operand::Value(value) => format!("s{value}"),
            Operand::Constant(number) => constant(number),
            Operand::Pi => literal(core::f64::consts::PI),
            Operand::MinPositive => literal(f64::MIN_POSITIVE),
            Operand::Symbol(symbol) => self.symbol(*symbol),
        }
    }

    fn symbol(&mut self, symbol: Symbol) -> String {
        let (array, i) = match symbol {
            Symbol::Time => {
                self.reads.insert("t");
                return "t".to_owned();
            }
            Symbol::Parameter(i) => {
                self.reads.insert("p");
                let read = self.parameters.get(i as usize);
                return read.cloned().unwrap_or_default();
            }
            Symbol::Coordinate(i) => ("q", i),
            Symbol::Velocity(i) => ("v", i),
            Symbol::Input(i) => ("u", i),
            Symbol::Invariant(i) => ("z", i),
            Symbol::Acceleration(i) => ("a", i),
            Symbol::Variation(i) => ("delta", i),
            // Symbols that no method contains.
            _ => return String::new(),
        };
        self.reads.insert(array);
        format!("{array}[{i}]")
    }
}

/// Whether a text mentions a name as a whole word.
pub(super) fn mentions(text: &str, name: &str) -> bool {
    let is_part = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'$';
    let bytes = text.as_bytes();
    text.match_indices(name).any(|(start, _)| {
        let before = start.checked_sub(1).and_then(|i| bytes.get(i));
        let after = bytes.get(start + name.len());
        !before.copied().is_some_and(is_part) && !after.copied().is_some_and(is_part)
    })
}

/// The values that outputs depend on, without some of them.
fn needed(program: &Program, unneeded: &[Unneeded<'_>]) -> LiveValues {
    let mut needed = Vec::new();
    for (index, group) in program.groups.iter().enumerate() {
        for (position, output) in group.outputs.iter().enumerate() {
            let is_left_out = unneeded.iter().any(|(slice, is_left_out)| {
                slice.index_of(index, position).is_some_and(is_left_out)
            });
            if !is_left_out {
                needed.push(output);
            }
        }
    }
    LiveValues::of(needed.into_iter(), program.instructions())
}

/// The number nearest to an exact one, in parentheses if it has a sign.
fn constant(number: &Rational) -> String {
    literal(number.to_f64())
}

fn literal(value: f64) -> String {
    if value.is_nan() {
        return "NAN".to_owned();
    }
    if value.is_infinite() {
        return if value < 0.0 {
            "(-HUGE_VAL)"
        } else {
            "HUGE_VAL"
        }
        .to_owned();
    }
    if value.is_sign_negative() {
        format!("({value:?})")
    } else {
        format!("{value:?}")
    }
}
