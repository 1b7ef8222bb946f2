//! Sums that are computed anyway: f·x + f·y is computed as f·s where s = x + y is a value already.
//!
//! The time derivative of an angular velocity contains other angular velocities, and the forces of a
//! chain the velocities of its bodies: written out as the product rule leaves them, their terms are
//! found again here, up to a common multiple.

use std::collections::{BTreeMap, BTreeSet};

use crate::Rational;
use crate::program::plan::{Plan, Recipe, Value};

/// Sums longer than this are not looked for, and in sums longer than this nothing is.
const LONGEST: usize = 24;

/// What is known of the values before anything is collected.
struct Known {
    /// Products by their factors.
    products: BTreeMap<Vec<Value>, Value>,
    /// The sums that a value is a term of.
    sums: BTreeMap<Value, Vec<Value>>,
}

/// A sum found among the multiples of a factor.
struct Found {
    factor: Value,
    sum: Value,
    multiple: Rational,
    /// The terms that it stands for.
    terms: BTreeSet<Value>,
}

impl Plan {
    /// Collects known sums in all sums. `uses` says how often each value is used.
    pub(crate) fn collect(&mut self, uses: &[usize]) {
        let known = Known::of(self);
        for value in 0..uses.len() {
            while let Some(found) = self.known_sum(value, &known, uses) {
                self.replace(value, found);
            }
        }
    }

    /// A sum, computed before `value`, whose multiple by a factor is a part of `value`.
    fn known_sum(&self, value: Value, known: &Known, uses: &[usize]) -> Option<Found> {
        let Recipe::Sum(terms) = &self.recipes[value] else {
            return None;
        };
        if terms.len() > LONGEST {
            return None;
        }
        let multiples = self.multiples(terms, known);
        for (factor, quotients) in multiples
            .iter()
            .filter(|(_, quotients)| quotients.len() > 1)
        {
            for first in quotients.keys() {
                for sum in known.sums.get(first).into_iter().flatten() {
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

    /// For each factor of the terms of a sum, what the terms are without it: the value, the term and the
    /// coefficient.
    fn multiples(
        &self,
        terms: &[(Value, Rational)],
        known: &Known,
    ) -> BTreeMap<Value, BTreeMap<Value, (Value, Rational)>> {
        let mut multiples: BTreeMap<Value, BTreeMap<Value, (Value, Rational)>> = BTreeMap::new();
        for (term, coefficient) in terms {
            let Recipe::Quotient(numerator, denominator) = &self.recipes[*term] else {
                continue;
            };
            if !denominator.is_empty() {
                continue;
            }
            for (position, factor) in numerator.iter().enumerate() {
                let mut rest = numerator.clone();
                rest.remove(position);
                let quotient = match &*rest {
                    [single] => Some(*single),
                    _ => known.products.get(&rest).copied(),
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
        factor: Value,
        quotients: &BTreeMap<Value, (Value, Rational)>,
        sum: Value,
    ) -> Option<Found> {
        let Recipe::Sum(parts) = &self.recipes[sum] else {
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
        Some(Found {
            factor,
            sum,
            multiple: ratio?,
            terms,
        })
    }

    fn replace(&mut self, value: Value, found: Found) {
        let mut factors = vec![found.factor, found.sum];
        factors.sort_unstable();
        let product = self.push(Recipe::Quotient(factors, Vec::new()), None);
        if let Recipe::Sum(terms) = &mut self.recipes[value] {
            terms.retain(|(term, _)| !found.terms.contains(term));
            terms.push((product, found.multiple));
        }
    }
}

impl Found {
    /// Whether fewer operations are left: each term that nothing else uses saves a multiplication, each
    /// term but one an addition; the product with the sum costs one.
    fn saves(&self, uses: &[usize]) -> bool {
        let single = self
            .terms
            .iter()
            .filter(|term| uses.get(**term) == Some(&1));
        self.terms.len() - 1 + single.count() > 1
    }
}

impl Known {
    fn of(plan: &Plan) -> Self {
        let (mut products, mut sums) = (BTreeMap::new(), BTreeMap::new());
        for (value, recipe) in plan.recipes.iter().enumerate() {
            match recipe {
                Recipe::Quotient(numerator, denominator) if denominator.is_empty() => {
                    products.insert(numerator.clone(), value);
                }
                Recipe::Sum(terms) if (2..=LONGEST).contains(&terms.len()) => {
                    for (term, _) in terms {
                        sums.entry(*term).or_insert_with(Vec::new).push(value);
                    }
                }
                _ => {}
            }
        }
        Self { products, sums }
    }
}
