//! The order of instructions in long programs, so that fewer values wait in memory for their use.
//!
//! Input: a program. Output: the same instructions in another order, values numbered anew. A product that one sum alone adds
//! stands before it: both are one fused operation. Operands are computed depth first, the one that takes the longest chain of
//! operations first (Sethi and Ullman, The generation of optimal code for arithmetic expressions, 1970); and as soon as all
//! operands of an operation are there, and for one of them it is the last use, it runs (Goodman and Hsu, Code scheduling and
//! register allocation in large basic blocks, 1988), so that its result takes the register of that one. Which chain is the
//! longest says nothing of a recursion that goes out and in again: its intermediate results are computed in its own order.
//! Programs that fit registers stay as they are.

use crate::algebra::hashing::Table;
use crate::limits::MAX_GROUP_AS_SCHEDULED_LENGTH;
use crate::program::arrival::Arrivals;
use crate::program::straight_line::{Instruction, Operand, Operation, OutputGroup, Program};
use crate::{Expression, Graph, Pass};

impl Program {
    /// The same program with the instructions of long groups in an order for registers, in which the intermediate results of
    /// a recursion come one after the other; without [`Pass::Ordering`] as it is.
    #[must_use]
    pub fn ordered(mut self, graph: &Graph, recursion: &[Expression]) -> Self {
        if !graph.passes.has(Pass::Ordering) || !self.groups.iter().any(OutputGroup::is_long) {
            return self;
        }
        let recursion = recursion.iter();
        let recursion: Vec<_> = recursion.map(|result| graph.computed(*result)).collect();
        for place in 0..self.groups.len() {
            if !self.groups[place].is_long() {
                continue;
            }
            let arrivals = Arrivals::of(&self.groups, place);
            let group = &mut self.groups[place];
            let order = Operations::of(group, &arrivals).order(group, &recursion);
            let mut instructions: Vec<_> = group.instructions.drain(..).map(Some).collect();
            let ordered = order.into_iter().filter_map(|i| instructions[i].take());
            group.instructions = ordered.collect();
        }
        self.renumber();
        self
    }
}

impl OutputGroup {
    /// Whether the values of the group do not fit registers, so that the order of its instructions matters.
    #[must_use]
    pub const fn is_long(&self) -> bool {
        self.instructions.len() > MAX_GROUP_AS_SCHEDULED_LENGTH
    }
}

/// The operations of a group: an instruction each, with the products that are fused with it.
struct Operations {
    /// The instructions of each, in the order in which they run; the last one computes the result.
    instructions: Vec<Vec<usize>>,
    /// The operations whose results each one needs, each once, and those that need its own.
    needs: Vec<Vec<usize>>,
    users: Vec<Vec<usize>>,
    /// When each result is known at the earliest.
    heights: Vec<usize>,
    /// The operation that computes a value; none of the sines and cosines that are computed at once, before all others.
    of_value: Table<usize, usize>,
    /// The instructions that compute these.
    angles: Vec<usize>,
}

impl Operations {
    fn of(group: &OutputGroup, arrivals: &Arrivals) -> Self {
        let mut all = Self {
            instructions: Vec::with_capacity(group.instructions.len()),
            needs: Vec::with_capacity(group.instructions.len()),
            users: Vec::with_capacity(group.instructions.len()),
            heights: Vec::with_capacity(group.instructions.len()),
            of_value: Table::default(),
            angles: Vec::new(),
        };
        // What is fused with the instruction that uses it, by its value.
        let mut parts: Table<usize, (Vec<usize>, Vec<usize>)> = Table::default();
        for (index, instruction) in group.instructions.iter().enumerate() {
            let operation = &instruction.operation;
            if let Operation::SineAndCosine(Operand::Symbol(_)) = operation {
                all.angles.push(index);
                continue;
            }
            let (mut instructions, mut needs) = (Vec::new(), Vec::new());
            let mut operands: Vec<_> = operation
                .operands()
                .filter(|x| x.value().is_some())
                .collect();
            operands.sort_by_key(|operand| arrivals.get(operand).time);
            for value in operands.into_iter().filter_map(Operand::value) {
                if let Some((earlier, needed)) = parts.remove(&value) {
                    instructions.extend(earlier);
                    needs.extend(needed);
                } else {
                    needs.extend(all.of_value.get(&value).copied());
                }
            }
            instructions.push(index);
            if arrivals.is_fused(group, instruction) {
                parts.insert(instruction.value, (instructions, needs));
                continue;
            }
            all.heights
                .push(arrivals.get(&Operand::Value(instruction.value)).time);
            all.push(instruction, instructions, needs);
        }
        all
    }

    fn push(&mut self, instruction: &Instruction, instructions: Vec<usize>, needs: Vec<usize>) {
        let number = self.instructions.len();
        let mut distinct: Vec<usize> = Vec::with_capacity(needs.len());
        for need in needs {
            if !distinct.contains(&need) {
                distinct.push(need);
            }
        }
        for need in &distinct {
            self.users[*need].push(number);
        }
        let values = instruction.values();
        self.of_value.extend(values.map(|value| (value, number)));
        self.instructions.push(instructions);
        self.needs.push(distinct);
        self.users.push(Vec::new());
    }

    /// The indices of the instructions in the order in which they run.
    fn order(&self, group: &OutputGroup, recursion: &[Expression]) -> Vec<usize> {
        let named = group.instructions.iter();
        let named: Table<Expression, usize> = named
            .filter_map(|instruction| Some((instruction.expression?, instruction.value)))
            .collect();
        let recursion = recursion
            .iter()
            .filter_map(|expression| named.get(expression).copied());
        let outputs = group.outputs.iter().filter_map(Operand::value);
        let first = recursion.chain(outputs);
        let first = first.filter_map(|value| self.of_value.get(&value).copied());
        let mut order = Order::new(self);
        for number in self.depth_first(first) {
            order.run(number);
        }
        let operations = order
            .list
            .iter()
            .flat_map(|number| &self.instructions[*number]);
        self.angles.iter().chain(operations).copied().collect()
    }

    /// All operations, operands with the longest chains first, so that `first` come one after the other.
    fn depth_first(&self, first: impl Iterator<Item = usize>) -> Vec<usize> {
        let count = self.needs.len();
        let mut is_done = vec![false; count];
        let mut order = Vec::with_capacity(count);
        // What nothing needs comes last, in its order.
        for root in first.chain(0..count) {
            let mut waiting = vec![root];
            while let Some(number) = waiting.last().copied() {
                let missing = self.needs[number].iter().filter(|need| !is_done[**need]);
                if is_done[number] {
                    waiting.pop();
                } else if let Some(next) = missing.max_by_key(|need| self.heights[**need]) {
                    waiting.push(*next);
                } else {
                    is_done[number] = true;
                    order.push(number);
                    waiting.pop();
                }
            }
        }
        order
    }
}

/// An order that is being made.
struct Order<'a> {
    operations: &'a Operations,
    list: Vec<usize>,
    is_done: Vec<bool>,
    /// How many results each operation waits for.
    missing: Vec<usize>,
    /// How many operations still need each result.
    remaining: Vec<usize>,
}

impl<'a> Order<'a> {
    fn new(operations: &'a Operations) -> Self {
        Self {
            operations,
            list: Vec::with_capacity(operations.needs.len()),
            is_done: vec![false; operations.needs.len()],
            missing: operations.needs.iter().map(Vec::len).collect(),
            remaining: operations.users.iter().map(Vec::len).collect(),
        }
    }

    /// Runs an operation whose operands are there, and then all that thereby can take over a register.
    fn run(&mut self, number: usize) {
        let operations = self.operations;
        let mut waiting = vec![number];
        while let Some(number) = waiting.pop() {
            if self.is_done[number] {
                continue;
            }
            self.is_done[number] = true;
            self.list.push(number);
            let needs = &operations.needs[number];
            for need in needs {
                self.remaining[*need] -= 1;
            }
            for user in &operations.users[number] {
                self.missing[*user] -= 1;
            }
            for result in [number].iter().chain(needs) {
                let users = operations.users[*result].iter().copied();
                waiting.extend(users.filter(|user| self.takes_over(*user)));
            }
        }
    }

    /// Whether an operation can run, and is the last to use one of its operands.
    fn takes_over(&self, number: usize) -> bool {
        let is_last_use = |need: &usize| self.remaining[*need] == 1;
        !self.is_done[number]
            && self.missing[number] == 0
            && self.operations.needs[number].iter().any(is_last_use)
    }
}
