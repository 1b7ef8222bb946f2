//! Reuse of existing sums: f·x + f·y is computed as f·s where s = x + y is computed already (algebraic
//! common-subexpression elimination with divisors that are there: Hosangadi, Fallah and Kastner, Optimizing
//! polynomial expressions by algebraic factorization and common subexpression elimination, 2006).
//!
//! The time derivative of an angular velocity contains other angular velocities, and the forces of a chain the
//! velocities of its bodies: the product rule leaves their terms expanded, and here they are found again, up to a
//! common multiple.

use std::collections::{BTreeMap, BTreeSet};

use crate::Rational;
use crate::algebra::hashing::Table;
use crate::limits::MAX_SEARCHED_LIST_LENGTH;
use crate::program::dag::{Dag, DagOperation, ValueId};

/// Indices of the values before anything is collected.
struct Index {
    /// Products by their factors.
    products: Table<Vec<ValueId>, ValueId>,
    /// By value, the sums that it is a term of.
    sums: Vec<Vec<ValueId>>,
}

/// A sum found among the multiples of a factor.
struct Match {
    factor: ValueId,
    sum: ValueId,
    multiple: Rational,
    /// The terms that it stands for.
    terms: BTreeSet<ValueId>,
}

impl Dag {
    /// Collects existing sums in all sums. `uses` says how often each value is used.
    pub(crate) fn collect(&mut self, uses: &[usize]) {
        let index = Index::of(self);
        for value in 0..uses.len() {
            while let Some(found) = self.existing_sum(value, &index, uses) {
                self.replace(value, found);
            }
        }
    }

    /// A sum, computed before `value`, whose multiple by a factor is a part of `value`.
    fn existing_sum(&self, value: ValueId, index: &Index, uses: &[usize]) -> Option<Match> {
        let DagOperation::Sum(terms) = &self.operations[value] else {
            return None;
        };
        if terms.len() > MAX_SEARCHED_LIST_LENGTH {
            return None;
        }
        let multiples = self.multiples(terms, index);
        for (factor, quotients) in multiples
            .iter()
            .filter(|(_, quotients)| quotients.len() > 1)
        {
            for first in quotients.keys() {
                for sum in index.sums.get(*first).into_iter().flatten() {
                    if *sum >= value {
                        continue;
                    }
                    let found = self.as_multiple(*factor, quotients, *sum);
                    if let Some(found) = found.filter(|found| found.saves(uses)) {
                        return Some(found);
                    }
                }
            }
        }
        None
    }

    /// The factors that terms of a sum have twice or more, in ascending order.
    fn repeated_factors(&self, terms: &[(ValueId, Rational)]) -> Vec<ValueId> {
        let mut factors = Vec::new();
        for (term, _) in terms {
            if let DagOperation::Quotient(numerator, _) = &self.operations[*term] {
                factors.extend_from_slice(numerator);
            }
        }
        factors.sort_unstable();
        let mut repeated = Vec::new();
        for i in 1..factors.len() {
            if factors[i] == factors[i - 1] && repeated.last() != Some(&factors[i]) {
                repeated.push(factors[i]);
            }
        }
        repeated
    }

    /// For each repeated factor of the terms of a sum, the quotients of the terms by it: the value, the term and the
    /// coefficient.
    fn multiples(
        &self,
        terms: &[(ValueId, Rational)],
        index: &Index,
    ) -> BTreeMap<ValueId, BTreeMap<ValueId, (ValueId, Rational)>> {
        let mut multiples: BTreeMap<ValueId, BTreeMap<ValueId, (ValueId, Rational)>> =
            BTreeMap::new();
        let repeated = self.repeated_factors(terms);
        for (term, coefficient) in terms {
            let DagOperation::Quotient(numerator, denominator) = &self.operations[*term] else {
                continue;
            };
            if !denominator.is_empty() {
                continue;
            }
            for (position, factor) in numerator.iter().enumerate() {
                if repeated.binary_search(factor).is_err() {
                    continue;
                }
                let mut rest = numerator.clone();
                rest.remove(position);
                let quotient = match &*rest {
                    [single] => Some(*single),
                    _ => index.products.get(&rest).copied(),
                };
                if let Some(quotient) = quotient {
                    let quotients = multiples.entry(*factor).or_default();
                    quotients.insert(quotient, (*term, coefficient.clone()));
                }
            }
        }
        multiples
    }

    /// `sum` as a multiple among `quotients`, if all its terms are there in one ratio.
    fn as_multiple(
        &self,
        factor: ValueId,
        quotients: &BTreeMap<ValueId, (ValueId, Rational)>,
        sum: ValueId,
    ) -> Option<Match> {
        let DagOperation::Sum(parts) = &self.operations[sum] else {
            return None;
        };
        let mut ratio: Option<Rational> = None;
        let mut terms = BTreeSet::new();
        for (part, coefficient) in parts {
            let (term, multiple) = quotients.get(part)?;
            let quotient = multiple * &coefficient.reciprocal()?;
            if ratio.as_ref().is_some_and(|ratio| *ratio != quotient) {
                return None;
            }
            ratio = Some(quotient);
            terms.insert(*term);
        }
        Some(Match {
            factor,
            sum,
            multiple: ratio?,
            terms,
        })
    }

    fn replace(&mut self, value: ValueId, found: Match) {
        let mut factors = vec![found.factor, found.sum];
        factors.sort_unstable();
        let product = self.push(DagOperation::Quotient(factors, Vec::new()), None);
        if let DagOperation::Sum(terms) = &mut self.operations[value] {
            terms.retain(|(term, _)| !found.terms.contains(term));
            terms.push((product, found.multiple));
        }
    }
}

impl Match {
    /// Whether fewer operations remain: each term that nothing else uses saves a multiplication, each
    /// term but one an addition; the product with the sum costs one.
    fn saves(&self, uses: &[usize]) -> bool {
        let single = self
            .terms
            .iter()
            .filter(|term| uses.get(**term) == Some(&1));
        self.terms.len() - 1 + single.count() > 1
    }
}

impl Index {
    fn of(dag: &Dag) -> Self {
        let capacity = dag.operations.len();
        let mut products = Table::with_capacity_and_hasher(capacity, <_>::default());
        let mut sums = vec![Vec::new(); dag.operations.len()];
        for (value, operation) in dag.operations.iter().enumerate() {
            match operation {
                DagOperation::Quotient(numerator, denominator) if denominator.is_empty() => {
                    products.insert(numerator.clone(), value);
                }
                DagOperation::Sum(terms)
                    if (2..=MAX_SEARCHED_LIST_LENGTH).contains(&terms.len()) =>
                {
                    for (term, _) in terms {
                        sums[*term].push(value);
                    }
                }
                _ => {}
            }
        }
        Self { products, sums }
    }
}
