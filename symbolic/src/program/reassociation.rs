//! Sums whose terms are added in the order in which they are known (Hartley and Casavant, Tree-height minimization in
//! pipelined architectures, 1989).
//!
//! Input: a program. Output: one that adds the terms of each sum in another order, so that the one that is known last waits for
//! no other; where several are known at once and everything waits for their sum, they are added in two sums. The operations
//! are as many as before. What is one expression of the graph stays one term.

use crate::algebra::hashing::{Set, Table};
use crate::limits::{LATENCY_OF_ADDITION, LATENCY_OF_FUSED};
use crate::program::arrival::{Arrival, Arrivals};
use crate::program::straight_line::{Instruction, Operand, Operation, OutputGroup, Program};
use crate::{Pass, Passes};

/// A term of a sum.
#[derive(Clone)]
struct Term {
    operand: Operand,
    is_negative: bool,
    arrival: Arrival,
}

/// A sum of three or more terms.
struct Sum {
    /// The instruction that adds the last term.
    last: usize,
    /// The other instructions that add.
    inner: Vec<usize>,
    terms: Vec<Term>,
}

impl Program {
    /// The same program with the terms of sums of long groups in the order in which they are known; without
    /// [`Pass::Reassociation`] as it is.
    #[must_use]
    pub fn reassociated(mut self, passes: Passes) -> Self {
        if !passes.has(Pass::Reassociation) || !self.groups.iter().any(OutputGroup::is_long) {
            return self;
        }
        let operations = self
            .instructions()
            .map(|instruction| &instruction.operation);
        let additions = operations
            .filter(|operation| matches!(operation, Operation::Add(..) | Operation::Subtract(..)));
        let mut done: Set<Operation> = additions.cloned().collect();
        for place in 0..self.groups.len() {
            if self.groups[place].is_long() {
                let arrivals = Arrivals::of(&self.groups, place);
                self.groups[place].reassociate(&arrivals, &mut done);
            }
        }
        self.renumber();
        self
    }
}

impl OutputGroup {
    /// Puts the terms of sums in the order in which they are known; `done` are the additions of the program.
    fn reassociate(&mut self, arrivals: &Arrivals, done: &mut Set<Operation>) {
        let mut replaced: Vec<Option<Vec<Instruction>>> = vec![None; self.instructions.len()];
        for mut sum in self.sums(arrivals) {
            let value = self.instructions[sum.last].value;
            let operations = sum.additions(self, arrivals.slack(value));
            let own = sum.inner.iter().chain([&sum.last]);
            let own: Vec<_> = own
                .map(|index| &self.instructions[*index].operation)
                .collect();
            // Another sum may begin alike, and nothing is computed twice.
            let is_new =
                |new: &Instruction| own.contains(&&new.operation) || !done.contains(&new.operation);
            if operations.iter().all(is_new) {
                for operation in own {
                    done.remove(operation);
                }
                done.extend(operations.iter().map(|new| new.operation.clone()));
                for index in &sum.inner {
                    replaced[*index] = Some(Vec::new());
                }
                replaced[sum.last] = Some(operations);
            }
        }
        let instructions = core::mem::take(&mut self.instructions);
        let instructions = instructions.into_iter().zip(replaced);
        self.instructions = instructions
            .flat_map(|(instruction, replaced)| replaced.unwrap_or_else(|| vec![instruction]))
            .collect();
    }

    /// The sums of three or more terms.
    fn sums(&self, arrivals: &Arrivals) -> Vec<Sum> {
        let mut inner: Table<usize, Sum> = Table::default();
        let mut sums = Vec::new();
        for (index, instruction) in self.instructions.iter().enumerate() {
            let (x, y, is_difference) = match &instruction.operation {
                Operation::Add(x, y) => (x, y, false),
                Operation::Subtract(x, y) => (x, y, true),
                _ => continue,
            };
            let mut sum = Sum {
                last: index,
                inner: Vec::new(),
                terms: Vec::new(),
            };
            for (operand, is_negative) in [(x, false), (y, is_difference)] {
                let part = operand.value().and_then(|value| inner.remove(&value));
                sum.add(operand, part, is_negative, arrivals);
            }
            if self.is_inner(instruction, arrivals) {
                inner.insert(instruction.value, sum);
            } else if sum.terms.len() > 2 {
                sums.push(sum);
            }
        }
        sums
    }

    /// Whether an instruction adds some terms of a longer sum.
    fn is_inner(&self, instruction: &Instruction, arrivals: &Arrivals) -> bool {
        let user = arrivals.user(instruction.value);
        let user = user.map(|user| &self.instructions[user].operation);
        instruction.expression.is_none()
            && matches!(user, Some(Operation::Add(x, y) | Operation::Subtract(x, y)) if x != y)
    }
}

impl Sum {
    /// Adds an operand, which is a sum itself or a term.
    fn add(
        &mut self,
        operand: &Operand,
        part: Option<Self>,
        is_negative: bool,
        arrivals: &Arrivals,
    ) {
        let Some(part) = part else {
            self.terms.push(Term {
                operand: operand.clone(),
                is_negative,
                arrival: arrivals.get(operand),
            });
            return;
        };
        self.inner.extend(part.inner);
        self.inner.push(part.last);
        self.terms.extend(part.terms.into_iter().map(|term| Term {
            is_negative: term.is_negative != is_negative,
            ..term
        }));
    }

    /// The instructions that add the terms, the one that is known first before all others. The sum may be late by `slack`.
    fn additions(&mut self, group: &OutputGroup, slack: usize) -> Vec<Instruction> {
        let last = &group.instructions[self.last];
        self.terms.sort_by_key(Term::known);
        let values = self
            .inner
            .iter()
            .map(|index| group.instructions[*index].value);
        let mut chain = Chain {
            values: values.chain([last.value]).collect::<Vec<_>>().into_iter(),
            instructions: Vec::with_capacity(self.terms.len()),
        };
        // Of two sums each takes every other term, from the last one on.
        let is_even = |place: &usize| (self.terms.len() - place).is_multiple_of(2);
        let (others, late): (Vec<_>, Vec<_>) = (0..self.terms.len()).partition(is_even);
        let [others, late] = [others, late].map(|places| {
            let terms = places.into_iter().map(|place| &self.terms[place]);
            terms.collect::<Vec<_>>()
        });
        let all: Vec<_> = self.terms.iter().collect();
        if time(&all) > time(&others).max(time(&late)) + LATENCY_OF_ADDITION + slack {
            let [x, y] = [chain.add(&others), chain.add(&late)];
            chain.add(&[&x, &y]);
        } else {
            chain.add(&all);
        }
        if let Some(instruction) = chain.instructions.last_mut() {
            instruction.expression = last.expression;
        }
        chain.instructions
    }
}

impl Term {
    /// When it is known, or the factors of a product that is fused with the sum are.
    fn known(&self) -> usize {
        self.arrival.factors.unwrap_or(self.arrival.time)
    }
}

/// When the sum of terms is known that are added one after the other.
fn time(terms: &[&Term]) -> usize {
    let Some((first, others)) = terms.split_first() else {
        return 0;
    };
    others.iter().fold(first.arrival.time, |time, term| {
        let latency = match term.arrival.factors {
            Some(_) => LATENCY_OF_FUSED,
            None => LATENCY_OF_ADDITION,
        };
        time.max(term.known()) + latency
    })
}

/// Additions, one after the other.
struct Chain {
    /// The numbers of the values that are not computed yet.
    values: std::vec::IntoIter<usize>,
    instructions: Vec<Instruction>,
}

impl Chain {
    /// Adds terms, beginning with the first that is not negative; where all are, the sum is.
    fn add(&mut self, terms: &[&Term]) -> Term {
        let start = terms.iter().position(|term| !term.is_negative);
        let mut total = terms[start.unwrap_or(0)].clone();
        for (place, term) in terms.iter().enumerate() {
            if place == start.unwrap_or(0) {
                continue;
            }
            let operands = (total.operand, term.operand.clone());
            let operation = if term.is_negative && !total.is_negative {
                Operation::Subtract(operands.0, operands.1)
            } else {
                Operation::Add(operands.0, operands.1)
            };
            let value = self.values.next().unwrap_or_default();
            self.instructions.push(Instruction {
                operation,
                value,
                expression: None,
            });
            total.operand = Operand::Value(value);
        }
        total
    }
}
