//! Staging: invariants, which depend on parameters alone, are hoisted out of the kernel into a setup program that
//! runs once (Jørring and Scherlis, Compilers and staging transformations, 1986).
//!
//! The [scheduler](crate::program::schedule) gathers them before. The kernel reads the hoisted values as
//! [symbols](crate::Symbol::Invariant).

use std::collections::BTreeMap;

use crate::program::numbering::Instructions;
use crate::program::straight_line::{Instruction, Operand, OutputGroup, Program};
use crate::{Pass, Passes, Symbol};

/// A program in two stages.
#[derive(Clone, Debug, Default)]
pub struct Staged {
    /// Computes the invariants, the outputs of its one group, from the parameters alone.
    pub setup: Program,
    /// The rest, which reads the invariants as symbols.
    pub kernel: Program,
}

impl Program {
    /// The program in two stages; without [`Pass::Staging`] all of it is in the kernel.
    #[must_use]
    pub fn staged(self, passes: Passes) -> Staged {
        if passes.has(Pass::Staging) {
            return self.hoist_invariants();
        }
        let groups = vec![OutputGroup::default()];
        Staged {
            setup: Self { groups },
            kernel: self,
        }
    }

    /// Hoists the invariants into a setup program.
    #[must_use]
    pub fn hoist_invariants(&self) -> Staged {
        let mut hoisting = Hoisting::default();
        for group in &self.groups {
            let mut rest = OutputGroup::default();
            for instruction in &group.instructions {
                hoisting.instruction(instruction, &mut rest.instructions);
            }
            rest.outputs = group
                .outputs
                .iter()
                .map(|operand| hoisting.in_kernel(operand))
                .collect();
            hoisting.programs.kernel.groups.push(rest);
        }
        hoisting.programs.setup.groups.push(OutputGroup {
            instructions: hoisting.setup_instructions,
            outputs: hoisting.outputs,
        });
        hoisting.programs
    }
}

impl Staged {
    /// Appends the setup program to that of another kernel, and returns the kernel, which finds its invariants there.
    #[must_use]
    pub fn with_setup_in(self, setup: &mut Program) -> Program {
        let indices = setup.append(&self.setup);
        let mut kernel = self.kernel;
        kernel.replace_symbols(|symbol| match symbol {
            Symbol::Invariant(i) => {
                let index = u32::try_from(*indices.get(i as usize)?).ok()?;
                Some(Operand::Symbol(Symbol::Invariant(index)))
            }
            _ => None,
        });
        kernel
    }
}

impl Program {
    /// Computes the outputs of another program in the last group, too, each value once; returns their indices there.
    fn append(&mut self, other: &Self) -> Vec<usize> {
        let mut instructions = Instructions::behind(self);
        let Some(group) = self.groups.last_mut() else {
            return Vec::new();
        };
        // The number of each value of the other program.
        let mut values: Vec<usize> = Vec::new();
        for instruction in other.instructions() {
            let mut operation = instruction.operation.clone();
            operation.for_each_operand(|operand| renumber(operand, &values));
            let results = operation.results();
            let first = instructions.number(operation, instruction.expression);
            values.extend(first..first + results);
        }
        group.instructions.append(&mut instructions.list);
        let outputs = other.groups.iter().flat_map(|group| &group.outputs);
        let indices = outputs.map(|output| {
            let mut output = output.clone();
            renumber(&mut output, &values);
            let known = group.outputs.iter().position(|known| *known == output);
            known.unwrap_or_else(|| {
                group.outputs.push(output);
                group.outputs.len() - 1
            })
        });
        indices.collect()
    }
}

fn renumber(operand: &mut Operand, numbers: &[usize]) {
    if let Operand::Value(value) = operand
        && let Some(number) = numbers.get(*value)
    {
        *value = *number;
    }
}

/// The location of a value: its number in either program.
#[derive(Clone, Copy)]
enum Location {
    Setup(usize),
    Kernel(usize),
}

#[derive(Default)]
struct Hoisting {
    programs: Staged,
    setup_instructions: Vec<Instruction>,
    outputs: Vec<Operand>,
    /// By value.
    locations: Vec<Option<Location>>,
    symbols: BTreeMap<usize, u32>,
    setup_values: usize,
    kernel_values: usize,
}

impl Hoisting {
    fn instruction(&mut self, instruction: &Instruction, rest: &mut Vec<Instruction>) {
        let results = instruction.operation.results();
        let invariant = instruction
            .operation
            .operands()
            .all(|operand| self.is_invariant(operand));
        let mut operation = instruction.operation.clone();
        let value = if invariant {
            operation.for_each_operand(|operand| {
                if let Operand::Value(value) = operand
                    && let Some(Location::Setup(number)) = self.location(*value)
                {
                    *value = number;
                }
            });
            self.setup_values
        } else {
            operation.for_each_operand(|operand| *operand = self.in_kernel(operand));
            self.kernel_values
        };
        let location = if invariant {
            Location::Setup
        } else {
            Location::Kernel
        };
        let end = instruction.value + results;
        if self.locations.len() < end {
            self.locations.resize(end, None);
        }
        for result in 0..results {
            self.locations[instruction.value + result] = Some(location(value + result));
        }
        let moved = Instruction {
            operation,
            value,
            expression: instruction.expression,
        };
        if invariant {
            self.setup_values += results;
            self.setup_instructions.push(moved);
        } else {
            self.kernel_values += results;
            rest.push(moved);
        }
    }

    fn is_invariant(&self, operand: &Operand) -> bool {
        match operand {
            Operand::Constant(_) | Operand::Pi | Operand::MinPositive => true,
            Operand::Symbol(symbol) => matches!(symbol, Symbol::Parameter(_)),
            Operand::Value(value) => matches!(self.location(*value), Some(Location::Setup(_))),
        }
    }

    fn location(&self, value: usize) -> Option<Location> {
        self.locations.get(value).copied().flatten()
    }

    /// An operand as the kernel reads it.
    fn in_kernel(&mut self, operand: &Operand) -> Operand {
        let Operand::Value(value) = operand else {
            return operand.clone();
        };
        match self.location(*value) {
            Some(Location::Kernel(number)) => Operand::Value(number),
            Some(Location::Setup(number)) => {
                let outputs = &mut self.outputs;
                let index = *self.symbols.entry(number).or_insert_with(|| {
                    outputs.push(Operand::Value(number));
                    u32::try_from(outputs.len() - 1).unwrap_or(u32::MAX)
                });
                Operand::Symbol(Symbol::Invariant(index))
            }
            None => operand.clone(),
        }
    }
}
