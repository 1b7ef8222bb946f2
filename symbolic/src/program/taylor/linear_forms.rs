//! The terms of order k as linear forms, and their sums in the order in which the terms become known.
//!
//! In a recurrence the terms of order k depend linearly on each other and on convolutions, with coefficients that do not
//! vary. Each order waits for the one before, so that the time of an order is that of its longest chain of operations:
//! constant factors are moved out of the chain into the invariants, powers of k are cancelled, and what is known last is
//! added last (tree-height reduction of arithmetic expressions: D. J. Kuck, The Structure of Computers and
//! Computations, 1978, chapter 2).

use super::series::{Numbered, ZERO};
use crate::program::numbering::Instructions;
use crate::program::straight_line::{Instruction, Operand, Operation};
use crate::{Rational, Symbol};

/// As many terms are added in two sums that do not wait for each other.
const TERMS_OF_TWO_SUMS: usize = 5;

/// A number ± c, where c is an operand of the program of order 0.
#[derive(Clone, PartialEq, Eq)]
struct Coefficient {
    is_negative: bool,
    size: Operand,
}

impl Coefficient {
    fn of(size: Operand) -> Self {
        match size {
            Operand::Constant(number) if number.is_negative() => Self {
                is_negative: true,
                size: Operand::Constant(-&number),
            },
            size => Self {
                is_negative: false,
                size,
            },
        }
    }

    fn one() -> Self {
        Self::of(Operand::Constant(Rational::ONE))
    }

    fn is_unit(&self) -> bool {
        matches!(&self.size, Operand::Constant(number) if number.is_one())
    }

    fn minus_one() -> Self {
        Self::of(Operand::Constant(Rational::MINUS_ONE))
    }

    fn times(&self, other: &Self, initial: &mut Instructions) -> Self {
        let size = match (&self.size, &other.size) {
            (_, size) if self.is_unit() => size.clone(),
            (size, _) if other.is_unit() => size.clone(),
            (Operand::Constant(x), Operand::Constant(y)) => Operand::Constant(x * y),
            (x, y) => initial.emit(Operation::Multiply(x.clone(), y.clone())),
        };
        Self {
            is_negative: self.is_negative != other.is_negative,
            size,
        }
    }
}

/// ± c kᵖ x.
#[derive(Clone)]
struct Term {
    coefficient: Coefficient,
    power: i32,
    /// An operand of the recurrence.
    operand: Operand,
}

impl Term {
    fn leaf(operand: &Operand) -> Self {
        Self {
            coefficient: Coefficient::one(),
            power: 0,
            operand: operand.clone(),
        }
    }

    /// What a factor is that does not vary, or is a power of k.
    fn scale(operand: &Operand, invariants: &[Operand]) -> Option<(Coefficient, i32)> {
        match operand {
            Operand::Symbol(Symbol::Order) => Some((Coefficient::one(), 1)),
            Operand::Symbol(Symbol::ReciprocalOrder) => Some((Coefficient::one(), -1)),
            Operand::Symbol(Symbol::Invariant(i)) => {
                let invariant = invariants.get(*i as usize)?;
                Some((Coefficient::of(invariant.clone()), 0))
            }
            Operand::Symbol(_) | Operand::Value(_) => None,
            constant => Some((Coefficient::of(constant.clone()), 0)),
        }
    }
}

/// A recurrence.
pub(super) struct Recurrence {
    pub(super) instructions: Vec<Instruction>,
    /// The operands of the program of order 0 that it reads.
    pub(super) invariants: Vec<Operand>,
    /// Its results, in two lists.
    pub(super) outputs: [Vec<Operand>; 2],
}

impl Recurrence {
    /// The same with short chains. Coefficients are put together in the program of order 0.
    pub(super) fn balanced(self, initial: &mut Instructions) -> Self {
        let forms = Forms::of(&self, initial);
        let mut balanced = Balanced {
            initial,
            old_invariants: self.invariants,
            invariants: Numbered::new(),
            instructions: Instructions::default(),
            depths: Vec::new(),
            found: vec![None; self.instructions.len()],
        };
        for (value, form) in forms.forms.iter().enumerate() {
            if forms.needed[value] {
                let operand = match form {
                    Form::Sum(terms) => balanced.sum(terms),
                    Form::Other(operation) => balanced.operation(operation.clone()),
                };
                balanced.found[value] = Some(operand);
            }
        }
        let outputs = self.outputs.map(|outputs| {
            let outputs = outputs.iter().map(|operand| balanced.operand(operand));
            outputs.collect()
        });
        Self {
            instructions: balanced.instructions.list,
            invariants: balanced.invariants.items,
            outputs,
        }
    }
}

/// What a value is.
enum Form {
    Sum(Vec<Term>),
    /// Not linear.
    Other(Operation),
}

/// What the values of a recurrence are in terms of those that have to be computed.
struct Forms {
    forms: Vec<Form>,
    needed: Vec<bool>,
}

impl Forms {
    /// Values are numbered as the instructions are.
    fn of(recurrence: &Recurrence, initial: &mut Instructions) -> Self {
        let uses = uses(recurrence);
        let mut forms: Vec<Form> = Vec::with_capacity(recurrence.instructions.len());
        for instruction in &recurrence.instructions {
            let known = |operand: &Operand| known(operand, &forms, &uses);
            let operation = &instruction.operation;
            let opposite = (Coefficient::minus_one(), 0);
            let mut negated = |x| scaled_by(&opposite, known(x), initial);
            let form = match operation {
                Operation::Add(x, y) => Some([known(x), known(y)].concat()),
                Operation::Subtract(x, y) => Some([known(x), negated(y)].concat()),
                Operation::Negate(x) => Some(negated(x)),
                Operation::Multiply(x, y) => {
                    let scale = |x, y| Some((Term::scale(x, &recurrence.invariants)?, known(y)));
                    let scaled = scale(x, y).or_else(|| scale(y, x));
                    scaled.map(|(scale, terms)| scaled_by(&scale, terms, initial))
                }
                _ => None,
            };
            forms.push(form.map_or_else(|| Form::Other(operation.clone()), Form::Sum));
        }
        let mut needed = vec![false; forms.len()];
        need(recurrence.outputs.iter().flatten(), &mut needed);
        for value in (0..forms.len()).rev() {
            match &forms[value] {
                _ if !needed[value] => {}
                Form::Sum(terms) => need(terms.iter().map(|term| &term.operand), &mut needed),
                Form::Other(operation) => need(operation.operands(), &mut needed),
            }
        }
        Self { forms, needed }
    }
}

fn need<'a>(operands: impl Iterator<Item = &'a Operand>, needed: &mut [bool]) {
    for operand in operands {
        if let Operand::Value(value) = operand {
            needed[*value] = true;
        }
    }
}

/// How often each value is used; a result counts twice.
fn uses(recurrence: &Recurrence) -> Vec<usize> {
    let mut uses = vec![0; recurrence.instructions.len()];
    let outputs = recurrence.outputs.iter().flatten();
    let operations = recurrence.instructions.iter();
    let operands = operations.flat_map(|instruction| instruction.operation.operands());
    for operand in outputs.clone().chain(outputs).chain(operands) {
        if let Operand::Value(value) = operand {
            uses[*value] += 1;
        }
    }
    uses
}

/// The terms of an operand: those of a value that is used once, or is a multiple of another one.
fn known(operand: &Operand, forms: &[Form], uses: &[usize]) -> Vec<Term> {
    if let Operand::Value(value) = operand
        && let Form::Sum(terms) = &forms[*value]
        && (uses[*value] == 1 || terms.len() == 1)
    {
        return terms.clone();
    }
    vec![Term::leaf(operand)]
}

fn scaled_by(
    (coefficient, power): &(Coefficient, i32),
    terms: Vec<Term>,
    initial: &mut Instructions,
) -> Vec<Term> {
    let scaled = terms.into_iter().map(|term| Term {
        coefficient: coefficient.times(&term.coefficient, initial),
        power: power + term.power,
        operand: term.operand,
    });
    scaled.collect()
}

/// The recurrence under construction.
struct Balanced<'a> {
    initial: &'a mut Instructions,
    old_invariants: Vec<Operand>,
    invariants: Numbered<Operand>,
    instructions: Instructions,
    /// The length of the longest chain before each value.
    depths: Vec<usize>,
    /// Where the old values are.
    found: Vec<Option<Operand>>,
}

/// ± c x, where x is known after a chain of operations.
struct Summand {
    coefficient: Coefficient,
    operand: Operand,
    depth: usize,
}

impl Balanced<'_> {
    /// An operand of the old recurrence.
    fn operand(&mut self, operand: &Operand) -> Operand {
        match operand {
            Operand::Value(value) => self.found[*value].clone().unwrap_or(ZERO),
            Operand::Symbol(Symbol::Invariant(i)) => {
                let invariant = self.old_invariants[*i as usize].clone();
                self.invariant(&invariant)
            }
            other => other.clone(),
        }
    }

    fn invariant(&mut self, constant: &Operand) -> Operand {
        match constant {
            Operand::Value(_) | Operand::Symbol(_) => {
                let index = self.invariants.number(constant.clone());
                Operand::Symbol(Symbol::Invariant(index))
            }
            constant => constant.clone(),
        }
    }

    fn depth(&self, operand: &Operand) -> usize {
        match operand {
            Operand::Value(value) => self.depths[*value],
            _ => 0,
        }
    }

    fn emit(&mut self, operation: Operation) -> Operand {
        let depths = operation.operands().map(|operand| self.depth(operand));
        let depth = depths.max().unwrap_or(0) + 1;
        let results = operation.results();
        let operand = self.instructions.emit(operation);
        if let Operand::Value(value) = operand
            && value == self.depths.len()
        {
            self.depths.extend((0..results).map(|_| depth));
        }
        operand
    }

    fn operation(&mut self, mut operation: Operation) -> Operand {
        operation.for_each_operand(|operand| *operand = self.operand(operand));
        self.emit(operation)
    }

    /// The value of a form: the terms with a power of k are added first, and then multiplied by it once.
    fn sum(&mut self, terms: &[Term]) -> Operand {
        let mut powers: Vec<i32> = terms.iter().map(|term| term.power).collect();
        powers.sort_unstable();
        powers.dedup();
        let mut summands = Vec::new();
        for power in powers {
            let terms = terms.iter().filter(|term| term.power == power);
            let mut of_power: Vec<Summand> = terms.map(|term| self.summand(term)).collect();
            if power == 0 {
                summands.append(&mut of_power);
                continue;
            }
            let coefficient = match &of_power[..] {
                [_] => core::mem::replace(&mut of_power[0].coefficient, Coefficient::one()),
                _ => Coefficient::one(),
            };
            let mut operand = self.total(of_power);
            let factor = if power > 0 {
                Symbol::Order
            } else {
                Symbol::ReciprocalOrder
            };
            for _ in 0..power.unsigned_abs() {
                operand = self.emit(Operation::Multiply(Operand::Symbol(factor), operand));
            }
            summands.push(Summand {
                coefficient,
                depth: self.depth(&operand),
                operand,
            });
        }
        self.total(summands)
    }

    fn summand(&mut self, term: &Term) -> Summand {
        let operand = self.operand(&term.operand);
        Summand {
            coefficient: term.coefficient.clone(),
            depth: self.depth(&operand),
            operand,
        }
    }

    /// The sum of several summands, the first of which are known first.
    fn total(&mut self, mut summands: Vec<Summand>) -> Operand {
        // A sum begins with a summand that needs no change of sign, if it can.
        let changes_sign =
            |summand: &Summand| summand.coefficient.is_negative && summand.coefficient.is_unit();
        summands.sort_by_key(|summand| (summand.depth, changes_sign(summand)));
        let in_two = summands.len() >= TERMS_OF_TWO_SUMS;
        let mut summands = summands.into_iter();
        let Some(first) = summands.next() else {
            return ZERO;
        };
        let mut sum = self.multiple(&first);
        let mut other: Option<Operand> = None;
        for summand in summands {
            if let Some(second) = &other {
                if self.depth(second) < self.depth(&sum) {
                    other = Some(core::mem::replace(&mut sum, second.clone()));
                }
            } else if in_two && summand.depth < self.depth(&sum) && !changes_sign(&summand) {
                other = Some(self.multiple(&summand));
                continue;
            }
            sum = self.plus(sum, &summand);
        }
        match other {
            Some(other) => self.emit(Operation::Add(sum, other)),
            None => sum,
        }
    }

    /// ± c x.
    fn multiple(&mut self, summand: &Summand) -> Operand {
        let operand = summand.operand.clone();
        let Coefficient { is_negative, size } = &summand.coefficient;
        match (summand.coefficient.is_unit(), is_negative) {
            (true, false) => operand,
            (true, true) => self.emit(Operation::Negate(operand)),
            (false, false) => {
                let size = self.invariant(size);
                self.emit(Operation::Multiply(size, operand))
            }
            (false, true) => {
                let opposite = match size {
                    Operand::Constant(number) => Operand::Constant(-number),
                    size => self.initial.emit(Operation::Negate(size.clone())),
                };
                let size = self.invariant(&opposite);
                self.emit(Operation::Multiply(size, operand))
            }
        }
    }

    /// The sum with one more summand.
    fn plus(&mut self, sum: Operand, summand: &Summand) -> Operand {
        let product = if summand.coefficient.is_unit() {
            summand.operand.clone()
        } else {
            let size = self.invariant(&summand.coefficient.size);
            self.emit(Operation::Multiply(size, summand.operand.clone()))
        };
        let operation = if summand.coefficient.is_negative {
            Operation::Subtract(sum, product)
        } else {
            Operation::Add(sum, product)
        };
        self.emit(operation)
    }
}
