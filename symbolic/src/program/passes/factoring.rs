//! Factoring of sums: x·a + x·b is computed as x·(a + b) (a greedy multivariate Horner scheme: Hosangadi, Fallah and
//! Kastner, Optimizing polynomial expressions by algebraic factorization and common subexpression elimination, 2006).
//!
//! Only terms that are computed for this one sum are regrouped, so that nothing shared is computed
//! twice. Each group saves as many multiplications as it has terms, less one.

use std::collections::BTreeMap;

use crate::Rational;
use crate::program::dag::{Dag, DagOperation, ValueId, merged};

impl Dag {
    /// Regroups all sums. `uses` says how often each value is used.
    pub(crate) fn factor(&mut self, uses: &[usize]) {
        let mut waiting: Vec<ValueId> = (0..self.operations.len()).rev().collect();
        while let Some(value) = waiting.pop() {
            let DagOperation::Sum(terms) = &self.operations[value] else {
                continue;
            };
            let Some(factor) = self.common_factor(terms, uses) else {
                continue;
            };
            let (group, mut rest): (Vec<_>, Vec<_>) = terms
                .clone()
                .into_iter()
                .partition(|(x, _)| self.contains(*x, factor, uses));
            let inner: Vec<_> = group
                .into_iter()
                .map(|(x, c)| (self.without(x, factor), c))
                .collect();
            let sum = self.push(DagOperation::Sum(merged(inner)), None);
            let product = self.push(DagOperation::Quotient(vec![factor, sum], Vec::new()), None);
            rest.push((product, Rational::ONE));
            self.operations[value] = DagOperation::Sum(rest);
            waiting.extend([value, sum]);
        }
    }

    /// The factor that most of the terms contain, if it is two of them at least.
    fn common_factor(&self, terms: &[(ValueId, Rational)], uses: &[usize]) -> Option<ValueId> {
        let mut counts: BTreeMap<ValueId, usize> = BTreeMap::new();
        for (x, _) in terms {
            let mut factors = self.free_factors(*x, uses).to_vec();
            factors.dedup();
            for factor in factors {
                *counts.entry(factor).or_default() += 1;
            }
        }
        let (factor, count) = counts.into_iter().rev().max_by_key(|(_, count)| *count)?;
        (count > 1).then_some(factor)
    }

    /// The factors of a term that is computed for one sum only.
    fn free_factors(&self, term: ValueId, uses: &[usize]) -> &[ValueId] {
        match &self.operations[term] {
            DagOperation::Quotient(numerator, _)
                if uses.get(term).is_none_or(|uses| *uses == 1) =>
            {
                numerator
            }
            _ => &[],
        }
    }

    fn contains(&self, term: ValueId, factor: ValueId, uses: &[usize]) -> bool {
        self.free_factors(term, uses).contains(&factor)
    }

    /// A product without one of its factors: the product itself, changed, as nothing else uses it.
    fn without(&mut self, product: ValueId, factor: ValueId) -> ValueId {
        let DagOperation::Quotient(numerator, denominator) = &mut self.operations[product] else {
            return product;
        };
        if let Some(position) = numerator.iter().position(|x| *x == factor) {
            numerator.remove(position);
        }
        self.expressions[product] = None;
        match (&**numerator, &**denominator) {
            ([single], []) => {
                let single = *single;
                self.operations[product] = DagOperation::Constant(Rational::ZERO);
                single
            }
            ([], []) => {
                self.operations[product] = DagOperation::Constant(Rational::ONE);
                product
            }
            _ => product,
        }
    }
}
