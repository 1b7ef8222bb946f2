//! What depends on the parameters alone is computed once, and not at every evaluation.
//!
//! In a plan, the constant factors of a product are gathered into one value, and so are the constant
//! terms of a sum; a division by a constant becomes a multiplication by its reciprocal. A program is then
//! parted in two: what can be computed before the first evaluation, and what is left, in which those
//! values are [symbols](crate::Symbol::Prepared).

use std::collections::BTreeMap;

use crate::program::plan::{Plan, Recipe, Value};
use crate::program::straight_line::{Instruction, Operand, Phase, Program};
use crate::{Expression, Pass, Passes, Rational, Symbol};

/// The values that were made of constant factors, above and below.
type Gathered = BTreeMap<(Vec<Value>, Vec<Value>), Value>;

impl Plan {
    /// Brings together what is constant. That costs operations which are worth it only where they are
    /// done once.
    pub(crate) fn arrange_constants(&mut self, passes: Passes, roots: &[Expression]) {
        if !passes.has(Pass::Preparation) {
            return;
        }
        if passes.has(Pass::Distribution) {
            self.distribute_constants(roots);
        }
        if passes.has(Pass::Gathering) {
            self.absorb_coefficients(roots);
            self.gather_constants(roots);
        }
    }

    /// Moves numbers in front of terms of a sum to the constants among their factors: ½·w·(a + b) is w·(½·(a + b)),
    /// with one multiplication less once the constants are known. Only what is used once is changed.
    fn absorb_coefficients(&mut self, roots: &[Expression]) {
        let mut constant = vec![false; self.recipes.len()];
        let order = self.order(roots);
        for value in &order {
            constant[*value] = self.is_constant(*value, &constant);
        }
        let uses = self.uses(roots);
        for value in order {
            let Recipe::Sum(mut terms) = self.recipes[value].clone() else {
                continue;
            };
            if constant[value] {
                continue;
            }
            for (term, coefficient) in &mut terms {
                let Recipe::Quotient(above, below) = &self.recipes[*term] else {
                    continue;
                };
                let mut factors = above.iter().chain(below);
                let absorbs = uses[*term] == 1 && factors.any(|x| is_set(&constant, *x));
                if !absorbs || constant[*term] || coefficient.abs().is_one() {
                    continue;
                }
                let (mut above, below) = (above.clone(), below.clone());
                above.push(self.push(Recipe::Constant(coefficient.abs()), None));
                self.recipes[*term] = Recipe::Quotient(above, below);
                self.expressions[*term] = None;
                *coefficient = if coefficient.is_negative() {
                    Rational::MINUS_ONE
                } else {
                    Rational::ONE
                };
            }
            self.recipes[value] = Recipe::Sum(terms);
        }
    }

    /// Gathers what is constant in products and sums that are not.
    fn gather_constants(&mut self, roots: &[Expression]) {
        let order = self.order(roots);
        let mut gathered = Gathered::default();
        let mut constant = vec![false; self.recipes.len()];
        for value in order {
            constant[value] = self.is_constant(value, &constant);
            if constant[value] {
                continue;
            }
            match self.recipes[value].clone() {
                Recipe::Quotient(above, below) => {
                    self.gather_factors(value, above, below, &constant, &mut gathered);
                }
                Recipe::Sum(terms) => self.gather_terms(value, terms, &constant),
                _ => {}
            }
        }
    }

    /// Moves constant factors of a product into a sum among its factors, where every term has a constant
    /// factor already: (x·a + y·b)·c is x·(a·c) + y·(b·c), with one multiplication less once the constants
    /// are known. Only what is used once is changed.
    fn distribute_constants(&mut self, roots: &[Expression]) {
        let mut constant = vec![false; self.recipes.len()];
        let order = self.order(roots);
        for value in &order {
            constant[*value] = self.is_constant(*value, &constant);
        }
        let uses = self.uses(roots);
        for value in order.into_iter().rev() {
            let Recipe::Quotient(above, below) = self.recipes[value].clone() else {
                continue;
            };
            if constant[value] {
                continue;
            }
            let fixed = |x: &Value| is_set(&constant, *x);
            let (fixed_above, above): (Vec<_>, Vec<_>) = above.into_iter().partition(fixed);
            let (fixed_below, below): (Vec<_>, Vec<_>) = below.into_iter().partition(fixed);
            let sum = above.iter().find(|x| self.absorbs(**x, &constant, &uses));
            let Some(sum) = sum.filter(|_| fixed_above.len() + fixed_below.len() > 0) else {
                continue;
            };
            self.multiply_terms(*sum, &fixed_above, &fixed_below, &constant);
            self.recipes[value] = Recipe::Quotient(above, below);
        }
    }

    /// Whether a value is a sum, used once, of terms that all have a constant factor.
    fn absorbs(&self, value: Value, constant: &[bool], uses: &[usize]) -> bool {
        let Recipe::Sum(terms) = &self.recipes[value] else {
            return false;
        };
        let has_constant = |term: Value| match &self.recipes[term] {
            _ if is_set(constant, term) => true,
            Recipe::Quotient(above, below) => {
                let mut factors = above.iter().chain(below);
                uses.get(term) == Some(&1) && factors.any(|x| is_set(constant, *x))
            }
            _ => false,
        };
        uses.get(value) == Some(&1) && terms.iter().all(|(term, _)| has_constant(*term))
    }

    /// Multiplies every term of a sum by constants.
    fn multiply_terms(&mut self, sum: Value, above: &[Value], below: &[Value], constant: &[bool]) {
        let Recipe::Sum(mut terms) = self.recipes[sum].clone() else {
            return;
        };
        for (term, _) in &mut terms {
            let (mut over, mut under) = match &self.recipes[*term] {
                Recipe::Quotient(over, under) if !is_set(constant, *term) => {
                    (over.clone(), under.clone())
                }
                _ => (vec![*term], Vec::new()),
            };
            over.extend(above);
            under.extend(below);
            let product = Recipe::Quotient(over, under);
            if is_set(constant, *term) {
                *term = self.push(product, None);
            } else {
                self.recipes[*term] = product;
                self.expressions[*term] = None;
            }
        }
        self.recipes[sum] = Recipe::Sum(terms);
        self.expressions[sum] = None;
    }

    /// The values that the roots are made of, operands first.
    fn order(&self, roots: &[Expression]) -> Vec<Value> {
        let mut order = Vec::new();
        let mut entered = vec![false; self.recipes.len()];
        let mut left = vec![false; self.recipes.len()];
        let mut waiting: Vec<Value> = roots.iter().map(|root| self.value(*root)).collect();
        while let Some(value) = waiting.last().copied() {
            if entered[value] {
                waiting.pop();
                if !left[value] {
                    left[value] = true;
                    order.push(value);
                }
                continue;
            }
            entered[value] = true;
            self.recipes[value].for_each_operand(|operand| waiting.push(operand));
        }
        order
    }

    /// Whether a value is made of parameters and numbers.
    fn is_constant(&self, value: Value, constant: &[bool]) -> bool {
        match &self.recipes[value] {
            Recipe::Constant(_) | Recipe::Pi | Recipe::MinPositive => true,
            Recipe::Symbol(symbol) => matches!(symbol, Symbol::Parameter(_)),
            recipe => {
                let mut all = true;
                recipe.for_each_operand(|operand| all &= constant[operand]);
                all
            }
        }
    }

    fn gather_factors(
        &mut self,
        value: Value,
        above: Vec<Value>,
        below: Vec<Value>,
        constant: &[bool],
        gathered: &mut Gathered,
    ) {
        let is_constant = |x: &Value| is_set(constant, *x);
        let (fixed_above, mut above): (Vec<_>, Vec<_>) = above.into_iter().partition(is_constant);
        let (fixed_below, below): (Vec<_>, Vec<_>) = below.into_iter().partition(is_constant);
        if fixed_above.len() + fixed_below.len() > 1 || !fixed_below.is_empty() {
            let factors = (fixed_above, fixed_below);
            let value = gathered
                .entry(factors)
                .or_insert_with_key(|(above, below)| {
                    self.push(Recipe::Quotient(above.clone(), below.clone()), None)
                });
            above.push(*value);
        } else {
            above.extend(fixed_above);
            above.sort_unstable();
        }
        self.recipes[value] = Recipe::Quotient(above, below);
    }

    fn gather_terms(&mut self, value: Value, terms: Vec<(Value, Rational)>, constant: &[bool]) {
        let (fixed, mut terms): (Vec<_>, Vec<_>) =
            terms.into_iter().partition(|(x, _)| is_set(constant, *x));
        // A lone constant is gathered only if it has a coefficient that would have to be multiplied.
        let plain = |(x, c): &(Value, Rational)| {
            c.abs().is_one() || matches!(self.recipes[*x], Recipe::Constant(_))
        };
        if fixed.len() > 1 || !fixed.iter().all(plain) {
            let gathered = self.push(Recipe::Sum(fixed), None);
            terms.push((gathered, Rational::ONE));
        } else {
            terms.splice(0..0, fixed);
        }
        self.recipes[value] = Recipe::Sum(terms);
    }
}

/// Whether a value is known to be constant; not those made since.
fn is_set(constant: &[bool], value: Value) -> bool {
    constant.get(value).copied().unwrap_or(false)
}

/// A program in two parts.
#[derive(Clone, Debug, Default)]
pub struct Prepared {
    /// What depends on parameters alone; its one group of outputs are the values that are prepared.
    pub before: Program,
    /// The rest, which reads the prepared values as symbols.
    pub after: Program,
}

impl Program {
    /// The program in two parts; without [`Pass::Preparation`] all of it is in the second.
    #[must_use]
    pub fn parted(self, passes: Passes) -> Prepared {
        if passes.has(Pass::Preparation) {
            return self.prepared();
        }
        let phases = vec![Phase::default()];
        Prepared {
            before: Self { phases },
            after: self,
        }
    }

    /// Parts the program in what depends on parameters alone and the rest.
    #[must_use]
    pub fn prepared(&self) -> Prepared {
        let mut parting = Parting::default();
        for phase in &self.phases {
            let mut rest = Phase::default();
            for instruction in &phase.instructions {
                parting.instruction(instruction, &mut rest.instructions);
            }
            rest.outputs = phase
                .outputs
                .iter()
                .map(|operand| parting.after(operand))
                .collect();
            parting.parts.after.phases.push(rest);
        }
        parting.parts.before.phases.push(Phase {
            instructions: parting.constant_instructions,
            outputs: parting.outputs,
        });
        parting.parts
    }
}

/// Where a value is in the two parts.
#[derive(Clone, Copy)]
enum Place {
    Before(usize),
    After(usize),
}

#[derive(Default)]
struct Parting {
    parts: Prepared,
    constant_instructions: Vec<Instruction>,
    outputs: Vec<Operand>,
    places: BTreeMap<usize, Place>,
    symbols: BTreeMap<usize, u32>,
    before: usize,
    rest: usize,
}

impl Parting {
    fn instruction(&mut self, instruction: &Instruction, rest: &mut Vec<Instruction>) {
        let results = instruction.operation.results();
        let constant = instruction
            .operation
            .operands()
            .all(|operand| self.is_constant(operand));
        let mut operation = instruction.operation.clone();
        let value = if constant {
            operation.for_each_operand(|operand| {
                if let Operand::Value(value) = operand
                    && let Some(Place::Before(number)) = self.places.get(value)
                {
                    *value = *number;
                }
            });
            self.before
        } else {
            operation.for_each_operand(|operand| *operand = self.after(operand));
            self.rest
        };
        let place = if constant {
            Place::Before
        } else {
            Place::After
        };
        for result in 0..results {
            self.places
                .insert(instruction.value + result, place(value + result));
        }
        let moved = Instruction {
            operation,
            value,
            expression: instruction.expression,
        };
        if constant {
            self.before += results;
            self.constant_instructions.push(moved);
        } else {
            self.rest += results;
            rest.push(moved);
        }
    }

    fn is_constant(&self, operand: &Operand) -> bool {
        match operand {
            Operand::Constant(_) | Operand::Pi | Operand::MinPositive => true,
            Operand::Symbol(symbol) => matches!(symbol, Symbol::Parameter(_)),
            Operand::Value(value) => matches!(self.places.get(value), Some(Place::Before(_))),
        }
    }

    /// An operand as the second part reads it.
    fn after(&mut self, operand: &Operand) -> Operand {
        let Operand::Value(value) = operand else {
            return operand.clone();
        };
        match self.places.get(value) {
            Some(Place::After(number)) => Operand::Value(*number),
            Some(Place::Before(number)) => {
                let outputs = &mut self.outputs;
                let index = *self.symbols.entry(*number).or_insert_with(|| {
                    outputs.push(Operand::Value(*number));
                    u32::try_from(outputs.len() - 1).unwrap_or(u32::MAX)
                });
                Operand::Symbol(Symbol::Prepared(index))
            }
            None => operand.clone(),
        }
    }
}
