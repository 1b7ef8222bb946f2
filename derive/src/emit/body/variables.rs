//! Which values of a program are variables.
//!
//! A product that is inlined in a sum is fused with it. As a variable it would not be, so that long lines are divided at other values.

use lagrangian_symbolic::{Expression, Instruction, Operand, Operation, Program};

use crate::limits::{DEEPEST_NESTING, MAX_STATEMENT_WIDTH};

/// About how many characters the name of a variable takes.
const NAME_WIDTH: usize = 4;

/// The values that are variables: those that are used more than once, that have a name, or that would be
/// nested too deeply or make a statement longer than a line. The others are inlined. A value that is only returned may be nested
/// more deeply.
pub(in crate::emit) struct Variables {
    named: Vec<bool>,
    /// Which values a group behind their own reads.
    read_later: Vec<bool>,
    /// Which values are outputs.
    outputs: Vec<bool>,
}

impl Variables {
    /// Those of a program; `is_defined` tells what the declaration has a name for.
    pub(in crate::emit) fn of(
        program: &Program,
        is_defined: impl Fn(Option<Expression>) -> bool,
    ) -> Self {
        let (uses, read_later) = count_uses(program);
        let mut variables = vec![true; uses.len()];
        let mut depths = vec![0; uses.len()];
        for group in &program.groups {
            for instruction in &group.instructions {
                if matches!(instruction.operation, Operation::SineAndCosine(_)) {
                    continue;
                }
                let value = instruction.value;
                let operands = instruction.operation.operands();
                let operands = operands.filter_map(Operand::value);
                let depth = 1 + operands.map(|operand| depths[operand]).max().unwrap_or(0);
                let is_returned =
                    || !group.is_long() && group.outputs.contains(&Operand::Value(value));
                let is_inlined = uses[value] == 1 && (depth < DEEPEST_NESTING || is_returned());
                if is_inlined && !is_defined(instruction.expression) {
                    variables[value] = false;
                    depths[value] = depth;
                }
            }
        }
        for group in &program.groups {
            if group.is_long() {
                keep_order(&group.instructions, &mut variables);
            } else {
                keep_in_lines(&group.instructions, &mut variables);
            }
        }
        Self {
            named: variables,
            read_later,
            outputs: Vec::new(),
        }
    }

    /// Makes variables of the outputs and of what calls a function of the model, too.
    pub(super) fn add_ends_of_pieces(&mut self, program: &Program) {
        self.outputs = vec![false; self.named.len()];
        let outputs = program.groups.iter().flat_map(|group| &group.outputs);
        for value in outputs.filter_map(Operand::value) {
            self.named[value] = true;
            self.outputs[value] = true;
        }
        for instruction in program.instructions() {
            if matches!(instruction.operation, Operation::Application(..)) {
                self.named[instruction.value] = true;
            }
        }
    }

    /// Whether a value is an output.
    pub(super) fn is_output(&self, value: usize) -> bool {
        self.outputs.get(value).is_some_and(|output| *output)
    }

    /// Whether a group behind that of a value reads it.
    pub(super) fn is_read_later(&self, value: usize) -> bool {
        self.read_later.get(value).is_some_and(|later| *later)
    }

    /// Whether a value is a variable.
    pub(in crate::emit) fn contain(&self, value: usize) -> bool {
        self.named.get(value).is_none_or(|variable| *variable)
    }

    pub(super) fn count(&self) -> usize {
        self.named.iter().filter(|variable| **variable).count()
    }
}

/// Makes variables of the widest parts of statements that would otherwise be longer than a line. A product in a sum is not such a
/// part, but its factors are.
fn keep_in_lines(instructions: &[Instruction], variables: &mut [bool]) {
    let mut widths = vec![NAME_WIDTH; variables.len()];
    let mut factors: Vec<Option<Vec<usize>>> = vec![None; variables.len()];
    for Instruction {
        value, operation, ..
    } in instructions
    {
        let operands = || operation.operands().filter_map(Operand::value);
        let is_sum = matches!(operation, Operation::Add(..) | Operation::Subtract(..));
        let mut parts = Vec::new();
        for operand in operands() {
            match &factors[operand] {
                Some(factors) if is_sum => parts.extend_from_slice(factors),
                _ => parts.push(operand),
            }
        }
        parts.retain(|part| !variables[*part]);
        parts.sort_by_key(|part| widths[*part]);
        let mut width = width(operation, &widths);
        while width > MAX_STATEMENT_WIDTH
            && let Some(widest) = parts.pop()
        {
            variables[widest] = true;
            width -= widths[widest] - NAME_WIDTH;
        }
        if !variables[*value] {
            widths[*value] = width;
            let is_product = matches!(operation, Operation::Multiply(..));
            factors[*value] = is_product.then(|| operands().collect());
        }
    }
}

/// About how many characters an operation takes, where values take so many.
fn width(operation: &Operation, widths: &[usize]) -> usize {
    let operands = operation.operands().map(|operand| match operand {
        Operand::Value(value) => widths[*value],
        Operand::Symbol(_) => 2 * NAME_WIDTH,
        _ => "__S::from_f64(0.5)".len(),
    });
    let written = match operation {
        Operation::Multiply(..) | Operation::Negate(_) => " * ",
        Operation::Application(..) => "self.__value_of_function::<__S>()",
        _ => ".add(, )",
    };
    operands.sum::<usize>() + written.len()
}

/// Makes variables of the values that would otherwise be computed behind what stands between them and their use.
fn keep_order(instructions: &[Instruction], variables: &mut [bool]) {
    let mut uses = vec![usize::MAX; variables.len()];
    for (place, instruction) in instructions.iter().enumerate() {
        for value in instruction.operation.operands().filter_map(Operand::value) {
            uses[value] = place;
        }
    }
    let mut next_variable = usize::MAX;
    for (place, instruction) in instructions.iter().enumerate().rev() {
        let value = instruction.value;
        variables[value] |= next_variable < uses[value];
        if variables[value] {
            next_variable = place;
        }
    }
}

/// How often each value is used, and whether by a group behind its own; that counts twice, so that it is not inlined.
fn count_uses(program: &Program) -> (Vec<usize>, Vec<bool>) {
    let end = |last: &Instruction| last.values().end;
    let mut uses = vec![0; program.instructions().last().map_or(0, end)];
    let mut read_later = vec![false; uses.len()];
    let mut start = 0;
    for group in &program.groups {
        let mut note = |operand: &Operand| {
            if let Some(value) = operand.value() {
                uses[value] += if value < start { 2 } else { 1 };
                read_later[value] |= value < start;
            }
        };
        for instruction in &group.instructions {
            instruction.operation.operands().for_each(&mut note);
        }
        group.outputs.iter().for_each(&mut note);
        start = group.instructions.last().map_or(start, end);
    }
    (uses, read_later)
}
