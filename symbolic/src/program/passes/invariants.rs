//! Gathering of invariants, which depend on parameters alone (reassociation and distribution: Briggs and Cooper,
//! Effective partial redundancy elimination, 1994).
//!
//! The invariant factors of a product are gathered into one value, and so are the invariant terms of a sum; a
//! division by an invariant becomes a multiplication by its reciprocal.

use std::collections::BTreeMap;

use crate::program::dag::{Dag, DagOperation, ValueId};
use crate::{Expression, Pass, Passes, Rational, Symbol};

/// The values of products of invariant factors, by numerator and denominator.
type GatheredInvariants = BTreeMap<(Vec<ValueId>, Vec<ValueId>), ValueId>;

impl Dag {
    /// Gathers invariants. That costs operations, which pays only where they run once.
    pub(crate) fn gather_invariants(&mut self, passes: Passes, roots: &[Expression]) {
        if !passes.has(Pass::Staging) {
            return;
        }
        if passes.has(Pass::Distribution) {
            self.distribute_invariants(roots);
        }
        if passes.has(Pass::Gathering) {
            self.absorb_coefficients(roots);
            self.gather_factors_and_terms(roots);
        }
    }

    /// Moves the coefficients of terms of a sum to the invariants among their factors: ½·w·(a + b) is w·(½·(a + b)),
    /// with one multiplication less in the kernel. Only values with a single use are changed.
    fn absorb_coefficients(&mut self, roots: &[Expression]) {
        let (order, invariant) = self.invariants(roots);
        let uses = self.uses(roots);
        for value in order {
            let DagOperation::Sum(terms) = &self.operations[value] else {
                continue;
            };
            if invariant[value] {
                continue;
            }
            let mut terms = terms.clone();
            for (term, coefficient) in &mut terms {
                let DagOperation::Quotient(above, below) = &self.operations[*term] else {
                    continue;
                };
                let mut factors = above.iter().chain(below);
                let absorbs = uses[*term] == 1 && factors.any(|x| is_set(&invariant, *x));
                if !absorbs || invariant[*term] || coefficient.abs().is_one() {
                    continue;
                }
                let (mut above, below) = (above.clone(), below.clone());
                above.push(self.push(DagOperation::Constant(coefficient.abs()), None));
                self.operations[*term] = DagOperation::Quotient(above, below);
                self.expressions[*term] = None;
                *coefficient = if coefficient.is_negative() {
                    Rational::MINUS_ONE
                } else {
                    Rational::ONE
                };
            }
            self.operations[value] = DagOperation::Sum(terms);
        }
    }

    /// Gathers the invariant factors and terms of products and sums that vary.
    fn gather_factors_and_terms(&mut self, roots: &[Expression]) {
        let order = self.order(roots);
        let mut gathered = GatheredInvariants::default();
        let mut invariant = vec![false; self.operations.len()];
        for value in order {
            invariant[value] = self.is_invariant(value, &invariant);
            if invariant[value] {
                continue;
            }
            match self.operations[value].clone() {
                DagOperation::Quotient(above, below) => {
                    self.gather_factors(value, above, below, &invariant, &mut gathered);
                }
                DagOperation::Sum(terms) => self.gather_terms(value, terms, &invariant),
                _ => {}
            }
        }
    }

    /// Distributes invariant factors of a product over a sum among its factors, where every term has an invariant
    /// factor already: (x·a + y·b)·c is x·(a·c) + y·(b·c), with one multiplication less in the kernel. Only values
    /// with a single use are changed.
    fn distribute_invariants(&mut self, roots: &[Expression]) {
        let (order, invariant) = self.invariants(roots);
        let uses = self.uses(roots);
        for value in order.into_iter().rev() {
            let DagOperation::Quotient(above, below) = &self.operations[value] else {
                continue;
            };
            let fixed = |x: &ValueId| is_set(&invariant, *x);
            if invariant[value] || !(above.iter().any(fixed) || below.iter().any(fixed)) {
                continue;
            }
            let (above, below) = (above.clone(), below.clone());
            let (fixed_above, above): (Vec<_>, Vec<_>) = above.into_iter().partition(fixed);
            let (fixed_below, below): (Vec<_>, Vec<_>) = below.into_iter().partition(fixed);
            let sum = above.iter().find(|x| self.absorbs(**x, &invariant, &uses));
            let Some(sum) = sum else {
                continue;
            };
            self.multiply_terms(*sum, &fixed_above, &fixed_below, &invariant);
            self.operations[value] = DagOperation::Quotient(above, below);
        }
    }

    /// Whether a value is a sum, used once, of terms that all have an invariant factor.
    fn absorbs(&self, value: ValueId, invariant: &[bool], uses: &[usize]) -> bool {
        let DagOperation::Sum(terms) = &self.operations[value] else {
            return false;
        };
        let has_invariant = |term: ValueId| match &self.operations[term] {
            _ if is_set(invariant, term) => true,
            DagOperation::Quotient(above, below) => {
                let mut factors = above.iter().chain(below);
                uses.get(term) == Some(&1) && factors.any(|x| is_set(invariant, *x))
            }
            _ => false,
        };
        uses.get(value) == Some(&1) && terms.iter().all(|(term, _)| has_invariant(*term))
    }

    /// Multiplies every term of a sum by constants.
    fn multiply_terms(
        &mut self,
        sum: ValueId,
        above: &[ValueId],
        below: &[ValueId],
        invariant: &[bool],
    ) {
        let DagOperation::Sum(mut terms) = self.operations[sum].clone() else {
            return;
        };
        for (term, _) in &mut terms {
            let (mut over, mut under) = match &self.operations[*term] {
                DagOperation::Quotient(over, under) if !is_set(invariant, *term) => {
                    (over.clone(), under.clone())
                }
                _ => (vec![*term], Vec::new()),
            };
            over.extend(above);
            under.extend(below);
            let product = DagOperation::Quotient(over, under);
            if is_set(invariant, *term) {
                *term = self.push(product, None);
            } else {
                self.operations[*term] = product;
                self.expressions[*term] = None;
            }
        }
        self.operations[sum] = DagOperation::Sum(terms);
        self.expressions[sum] = None;
    }

    /// The values that the roots need, in topological order, operands first.
    fn order(&self, roots: &[Expression]) -> Vec<ValueId> {
        let mut order = Vec::new();
        let mut entered = vec![false; self.operations.len()];
        let mut left = vec![false; self.operations.len()];
        let mut waiting: Vec<ValueId> = roots.iter().map(|root| self.value(*root)).collect();
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
            self.operations[value].for_each_operand(|operand| waiting.push(operand));
        }
        order
    }

    /// The values that the roots need, in topological order, and which values are invariant.
    fn invariants(&self, roots: &[Expression]) -> (Vec<ValueId>, Vec<bool>) {
        let mut invariant = vec![false; self.operations.len()];
        let order = self.order(roots);
        for value in &order {
            invariant[*value] = self.is_invariant(*value, &invariant);
        }
        (order, invariant)
    }

    /// Whether a value depends on parameters and numbers alone.
    fn is_invariant(&self, value: ValueId, invariant: &[bool]) -> bool {
        match &self.operations[value] {
            DagOperation::Constant(_) | DagOperation::Pi | DagOperation::MinPositive => true,
            DagOperation::Symbol(symbol) => matches!(symbol, Symbol::Parameter(_)),
            operation => {
                let mut all = true;
                operation.for_each_operand(|operand| all &= invariant[operand]);
                all
            }
        }
    }

    fn gather_factors(
        &mut self,
        value: ValueId,
        above: Vec<ValueId>,
        below: Vec<ValueId>,
        invariant: &[bool],
        gathered: &mut GatheredInvariants,
    ) {
        let is_invariant = |x: &ValueId| is_set(invariant, *x);
        let (fixed_above, mut above): (Vec<_>, Vec<_>) = above.into_iter().partition(is_invariant);
        let (fixed_below, below): (Vec<_>, Vec<_>) = below.into_iter().partition(is_invariant);
        if fixed_above.len() + fixed_below.len() > 1 || !fixed_below.is_empty() {
            let factors = (fixed_above, fixed_below);
            let value = gathered
                .entry(factors)
                .or_insert_with_key(|(above, below)| {
                    self.push(DagOperation::Quotient(above.clone(), below.clone()), None)
                });
            above.push(*value);
        } else {
            above.extend(fixed_above);
            above.sort_unstable();
        }
        self.operations[value] = DagOperation::Quotient(above, below);
    }

    fn gather_terms(
        &mut self,
        value: ValueId,
        terms: Vec<(ValueId, Rational)>,
        invariant: &[bool],
    ) {
        let (fixed, mut terms): (Vec<_>, Vec<_>) =
            terms.into_iter().partition(|(x, _)| is_set(invariant, *x));
        // A single invariant is gathered only if it has a coefficient.
        let plain = |(x, c): &(ValueId, Rational)| {
            c.abs().is_one() || matches!(self.operations[*x], DagOperation::Constant(_))
        };
        if fixed.len() > 1 || !fixed.iter().all(plain) {
            let gathered = self.push(DagOperation::Sum(fixed), None);
            terms.push((gathered, Rational::ONE));
        } else {
            terms.splice(0..0, fixed);
        }
        self.operations[value] = DagOperation::Sum(terms);
    }
}

/// Whether a value is marked as invariant; newer values are not.
fn is_set(invariant: &[bool], value: ValueId) -> bool {
    invariant.get(value).copied().unwrap_or(false)
}
