//! The order of instructions in long programs, so that fewer values wait in memory for their use.
//!
//! Input: a program. Output: the same instructions in another order, values numbered anew. Operands are computed depth first,
//! the one that takes the longest chain of operations first (Sethi and Ullman, The generation of optimal code for arithmetic
//! expressions, 1970); and as soon as all operands of an instruction are there, and for one of them it is the last use, it
//! runs (Goodman and Hsu, Code scheduling and register allocation in large basic blocks, 1988), so that its result takes
//! the register of that one. Programs that fit registers stay as they are.

use crate::algebra::hashing::Table;
use crate::limits::LONGEST_GROUP_AS_SCHEDULED;
use crate::program::straight_line::{Instruction, Operand, OutputGroup, Program};
use crate::{Pass, Passes};

impl Program {
    /// The same program with the instructions of long groups in an order for registers; without [`Pass::Ordering`] as it is.
    #[must_use]
    pub fn ordered(mut self, passes: Passes) -> Self {
        let is_long = |group: &OutputGroup| group.instructions.len() > LONGEST_GROUP_AS_SCHEDULED;
        if !passes.has(Pass::Ordering) || !self.groups.iter().any(is_long) {
            return self;
        }
        for group in self.groups.iter_mut().filter(|group| is_long(group)) {
            let mut instructions: Vec<_> = group.instructions.drain(..).map(Some).collect();
            let list: Vec<&Instruction> = instructions.iter().flatten().collect();
            let order = Dependences::of(&list).order(&group.outputs);
            let ordered = order.into_iter().filter_map(|i| instructions[i].take());
            group.instructions = ordered.collect();
        }
        self.renumber();
        self
    }

    /// Numbers the values in the order in which they are computed.
    fn renumber(&mut self) {
        let mut numbers: Table<usize, usize> = Table::default();
        let mut next = 0;
        for group in &mut self.groups {
            let renumber = |operand: &mut Operand, numbers: &Table<usize, usize>| {
                if let Operand::Value(value) = operand
                    && let Some(number) = numbers.get(value)
                {
                    *value = *number;
                }
            };
            for instruction in &mut group.instructions {
                let operation = &mut instruction.operation;
                operation.for_each_operand(|operand| renumber(operand, &numbers));
                let results = operation.results();
                numbers.extend((0..results).map(|i| (instruction.value + i, next + i)));
                instruction.value = next;
                next += results;
            }
            for output in &mut group.outputs {
                renumber(output, &numbers);
            }
        }
    }
}

/// Which instructions of a group need which values, by their indices.
struct Dependences {
    /// The values of the group that each instruction needs, each once.
    needs: Vec<Vec<usize>>,
    /// The instructions that need a value, and the one that computes it.
    users: Table<usize, Vec<usize>>,
    producer: Table<usize, usize>,
    /// The number of operations of the longest chain that ends with the instruction.
    heights: Vec<usize>,
    /// The values that each instruction computes: the first, and how many.
    results: Vec<(usize, usize)>,
}

impl Dependences {
    fn of(instructions: &[&Instruction]) -> Self {
        let mut all = Self {
            needs: Vec::with_capacity(instructions.len()),
            users: Table::default(),
            producer: Table::default(),
            heights: Vec::with_capacity(instructions.len()),
            results: Vec::with_capacity(instructions.len()),
        };
        for (index, instruction) in instructions.iter().enumerate() {
            let mut needs: Vec<usize> = Vec::new();
            for operand in instruction.operation.operands() {
                if let Operand::Value(value) = operand
                    && all.producer.contains_key(value)
                    && !needs.contains(value)
                {
                    needs.push(*value);
                }
            }
            let heights = needs.iter().map(|value| all.heights[all.producer[value]]);
            let height = 1 + heights.max().unwrap_or(0);
            for value in &needs {
                all.users.entry(*value).or_default().push(index);
            }
            let results = instruction.operation.results();
            let values = (0..results).map(|i| instruction.value + i);
            all.producer.extend(values.map(|value| (value, index)));
            all.results.push((instruction.value, results));
            all.heights.push(height);
            all.needs.push(needs);
        }
        all
    }

    /// The indices of the instructions in the order in which they run.
    fn order(&self, outputs: &[Operand]) -> Vec<usize> {
        let mut order = Running::new(self);
        for index in self.depth_first(outputs) {
            order.run(index);
        }
        order.list
    }

    /// Operands with the longest chains first.
    fn depth_first(&self, outputs: &[Operand]) -> Vec<usize> {
        let count = self.needs.len();
        let mut is_done = vec![false; count];
        let mut order = Vec::with_capacity(count);
        let roots = outputs.iter().filter_map(|output| match output {
            Operand::Value(value) => self.producer.get(value).copied(),
            _ => None,
        });
        // What no output needs comes last, in its order.
        for root in roots.chain(0..count) {
            let mut waiting = vec![root];
            while let Some(index) = waiting.last().copied() {
                let producers = self.needs[index].iter().map(|value| self.producer[value]);
                let missing = producers.filter(|producer| !is_done[*producer]);
                if is_done[index] {
                    waiting.pop();
                } else if let Some(next) = missing.max_by_key(|producer| self.heights[*producer]) {
                    waiting.push(next);
                } else {
                    is_done[index] = true;
                    order.push(index);
                    waiting.pop();
                }
            }
        }
        order
    }
}

/// An order that is being made.
struct Running<'a> {
    dependences: &'a Dependences,
    list: Vec<usize>,
    is_done: Vec<bool>,
    /// How many values each instruction waits for.
    missing: Vec<usize>,
    /// How many instructions still need a value.
    remaining: Table<usize, usize>,
}

impl<'a> Running<'a> {
    fn new(dependences: &'a Dependences) -> Self {
        let users = dependences.users.iter();
        Self {
            dependences,
            list: Vec::with_capacity(dependences.needs.len()),
            is_done: vec![false; dependences.needs.len()],
            missing: dependences.needs.iter().map(Vec::len).collect(),
            remaining: users.map(|(value, users)| (*value, users.len())).collect(),
        }
    }

    /// Runs an instruction whose operands are there, and then all that thereby can take over a register.
    fn run(&mut self, index: usize) {
        let dependences = self.dependences;
        let mut waiting = vec![index];
        while let Some(index) = waiting.pop() {
            if self.is_done[index] {
                continue;
            }
            self.is_done[index] = true;
            self.list.push(index);
            let (first, count) = dependences.results[index];
            let results = first..first + count;
            for value in &dependences.needs[index] {
                if let Some(remaining) = self.remaining.get_mut(value) {
                    *remaining -= 1;
                }
            }
            for value in results.clone() {
                for user in self.users(value) {
                    self.missing[*user] -= 1;
                }
            }
            for value in results.chain(dependences.needs[index].iter().copied()) {
                let users = self.users(value).iter().copied();
                waiting.extend(users.filter(|user| self.takes_over(*user)));
            }
        }
    }

    fn users(&self, value: usize) -> &'a [usize] {
        self.dependences
            .users
            .get(&value)
            .map_or(&[], Vec::as_slice)
    }

    /// Whether an instruction can run, and is the last to use one of its operands.
    fn takes_over(&self, index: usize) -> bool {
        let is_last_use = |value: &usize| self.remaining.get(value) == Some(&1);
        !self.is_done[index]
            && self.missing[index] == 0
            && self.dependences.needs[index].iter().any(is_last_use)
    }
}
