//! Common-subexpression elimination in products and in sums (Breuer, Generation of optimal code for expressions via
//! factorization, 1969; Hosangadi, Fallah and Kastner, Optimizing polynomial expressions by algebraic factorization
//! and common subexpression elimination, 2006).
//!
//! Greedy: the pair of factors that occurs in most products becomes a value of its own and replaces them, until
//! every pair is in one product only. The same for pairs of terms, up to a common multiple. Ties are broken by the
//! order of values, so that the result does not depend on hashing. When a pair is replaced, only the pairs that
//! overlap it are counted anew.

use core::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::algebra::hashing::Table;
use crate::limits::MAX_SEARCHED_LIST_LENGTH;
use crate::program::dag::{Dag, DagOperation, ValueId};
use crate::{Pass, Passes, Rational};

/// Two parts of a list, in order. For a sum, with what the second is multiplied by if the first is not.
type Pair = (ValueId, ValueId, Rational);

/// Lists of parts in which pairs are looked for: the numerators of products, or sums.
trait Lists {
    /// How many parts a value is made of, if it is such a list.
    fn length(dag: &Dag, value: ValueId) -> Option<usize>;
    /// One part of a list, with its multiple.
    fn part(dag: &Dag, value: ValueId, position: usize) -> (ValueId, &Rational);
    /// Takes a part out of a list.
    fn remove(dag: &mut Dag, value: ValueId, position: usize);
    /// Puts a part into a list.
    fn push(dag: &mut Dag, value: ValueId, part: ValueId, multiple: Rational);
    /// A value made of one pair.
    fn make(dag: &mut Dag, pair: &Pair) -> ValueId;
}

struct Products;
struct Sums;

impl Dag {
    /// Eliminates common subexpressions of products, then those of sums.
    pub(crate) fn share(&mut self, passes: Passes) {
        if passes.has(Pass::SharedProducts) {
            Sharing::<Products>::run(self);
        }
        if passes.has(Pass::SharedSums) {
            Sharing::<Sums>::run(self);
        }
    }

    fn numerator(&self, value: ValueId) -> &[ValueId] {
        match &self.operations[value] {
            DagOperation::Quotient(numerator, _) => numerator,
            _ => &[],
        }
    }

    fn terms(&self, value: ValueId) -> &[(ValueId, Rational)] {
        match &self.operations[value] {
            DagOperation::Sum(terms) => terms,
            _ => &[],
        }
    }
}

impl Lists for Products {
    fn length(dag: &Dag, value: ValueId) -> Option<usize> {
        match &dag.operations[value] {
            DagOperation::Quotient(numerator, _) => Some(numerator.len()),
            _ => None,
        }
    }

    fn part(dag: &Dag, value: ValueId, position: usize) -> (ValueId, &Rational) {
        static ONE: Rational = Rational::ONE;
        (dag.numerator(value)[position], &ONE)
    }

    fn remove(dag: &mut Dag, value: ValueId, position: usize) {
        if let DagOperation::Quotient(numerator, _) = &mut dag.operations[value] {
            numerator.remove(position);
        }
    }

    fn push(dag: &mut Dag, value: ValueId, part: ValueId, _: Rational) {
        if let DagOperation::Quotient(numerator, _) = &mut dag.operations[value] {
            numerator.push(part);
        }
    }

    fn make(dag: &mut Dag, (x, y, _): &Pair) -> ValueId {
        dag.push(DagOperation::Quotient(vec![*x, *y], Vec::new()), None)
    }
}

impl Lists for Sums {
    fn length(dag: &Dag, value: ValueId) -> Option<usize> {
        match &dag.operations[value] {
            DagOperation::Sum(terms) => Some(terms.len()),
            _ => None,
        }
    }

    fn part(dag: &Dag, value: ValueId, position: usize) -> (ValueId, &Rational) {
        let (x, c) = &dag.terms(value)[position];
        (*x, c)
    }

    fn remove(dag: &mut Dag, value: ValueId, position: usize) {
        if let DagOperation::Sum(terms) = &mut dag.operations[value] {
            terms.remove(position);
        }
    }

    fn push(dag: &mut Dag, value: ValueId, part: ValueId, multiple: Rational) {
        let DagOperation::Sum(terms) = &mut dag.operations[value] else {
            return;
        };
        // What is shared may have been a term already.
        match terms.iter_mut().find(|(term, _)| *term == part) {
            Some((_, coefficient)) => *coefficient = &*coefficient + &multiple,
            None => terms.push((part, multiple)),
        }
        terms.retain(|(_, coefficient)| !coefficient.is_zero());
    }

    fn make(dag: &mut Dag, (x, y, ratio): &Pair) -> ValueId {
        dag.push(
            DagOperation::Sum(vec![(*x, Rational::ONE), (*y, ratio.clone())]),
            None,
        )
    }
}

/// The lists that a pair occurs in.
#[derive(Default)]
struct Occurrences {
    /// In ascending order.
    lists: Vec<ValueId>,
    /// The number of lists under which the pair waits in the queue, or 0.
    queued: usize,
}

/// Where each pair occurs.
struct Sharing<'a, L> {
    dag: &'a mut Dag,
    occurrences: Table<Pair, Occurrences>,
    /// Pairs by how often they occurred when they were put here, which is checked again when they are taken.
    /// Of pairs with equal counts, one that is a complete list comes first: it is computed already.
    queue: BinaryHeap<(usize, bool, Reverse<Pair>)>,
    /// Pairs that occur in more or fewer lists than when the queue last heard of them.
    changed: Vec<Pair>,
    /// The values that are part of one list at most, now and later: their pairs are in one list, too.
    unshared: Vec<bool>,
    lists: core::marker::PhantomData<L>,
}

impl<'a, L: Lists> Sharing<'a, L> {
    fn run(dag: &'a mut Dag) {
        let mut sharing = Self {
            occurrences: Table::default(),
            queue: BinaryHeap::new(),
            changed: Vec::new(),
            unshared: unshared::<L>(dag),
            lists: core::marker::PhantomData,
            dag,
        };
        for value in 0..sharing.dag.operations.len() {
            for pair in sharing.pairs(value, |_| true) {
                sharing.enter(pair, value);
            }
        }
        sharing.enqueue();
        while let Some((count, _, Reverse(pair))) = sharing.queue.pop() {
            let Some(occurrences) = sharing.occurrences.get_mut(&pair) else {
                continue;
            };
            if occurrences.queued == count {
                occurrences.queued = 0;
            }
            if occurrences.lists.len() == count {
                sharing.replace(&pair);
                sharing.enqueue();
            }
        }
    }

    /// Notes that a list has a pair.
    fn enter(&mut self, pair: Pair, value: ValueId) {
        let occurrences = self.occurrences.entry(pair.clone()).or_default();
        let lists = &mut occurrences.lists;
        match lists.last() {
            Some(last) if *last >= value => match lists.binary_search(&value) {
                Ok(_) => return,
                Err(position) => lists.insert(position, value),
            },
            _ => lists.push(value),
        }
        if lists.len() > 1 {
            self.changed.push(pair);
        }
    }

    /// Forgets that a list has a pair.
    fn leave(&mut self, pair: Pair, value: ValueId) {
        if let Some(occurrences) = self.occurrences.get_mut(&pair)
            && let Ok(position) = occurrences.lists.binary_search(&value)
        {
            occurrences.lists.remove(position);
            self.changed.push(pair);
        }
    }

    /// Tells the queue of all pairs that occur more or less often than before.
    fn enqueue(&mut self) {
        for pair in core::mem::take(&mut self.changed) {
            let Some(occurrences) = self.occurrences.get_mut(&pair) else {
                continue;
            };
            let count = occurrences.lists.len();
            if count > 1 && count != occurrences.queued {
                occurrences.queued = count;
                let dag = &*self.dag;
                let is_computed = occurrences
                    .lists
                    .iter()
                    .any(|list| is_complete::<L>(dag, *list));
                self.queue.push((count, is_computed, Reverse(pair)));
            }
        }
    }

    fn may_be_shared(&self, part: ValueId) -> bool {
        part >= self.unshared.len() || !self.unshared[part]
    }

    /// The pairs of a list that others may have, with at least one part for which `wanted` holds.
    fn pairs(&self, value: ValueId, wanted: impl Fn(ValueId) -> bool) -> Vec<Pair> {
        let length = L::length(self.dag, value).unwrap_or(0);
        let mut pairs = Vec::new();
        if length > MAX_SEARCHED_LIST_LENGTH {
            return pairs;
        }
        for i in 0..length {
            let (x, c) = L::part(self.dag, value, i);
            if !self.may_be_shared(x) {
                continue;
            }
            let all = wanted(x);
            for j in i + 1..length {
                let (y, d) = L::part(self.dag, value, j);
                if !(all || wanted(y)) || !self.may_be_shared(y) {
                    continue;
                }
                pairs.push(if x <= y {
                    (x, y, ratio(d, c))
                } else {
                    (y, x, ratio(c, d))
                });
            }
        }
        pairs
    }

    /// Makes a value of a pair and puts it into all lists that have the pair.
    fn replace(&mut self, pair: &Pair) {
        let occurrences = self.occurrences.get_mut(pair);
        let lists = occurrences.map_or_else(Vec::new, |known| core::mem::take(&mut known.lists));
        // A list that consists of the pair is the value already.
        let existing = lists
            .iter()
            .copied()
            .find(|value| is_complete::<L>(self.dag, *value));
        let shared = existing.unwrap_or_else(|| L::make(self.dag, pair));
        let scale = self.scale_of(shared, pair);
        for value in lists {
            if value != shared {
                self.replace_in(value, pair, shared, &scale);
            }
        }
        self.enter(pair.clone(), shared);
    }

    /// Puts the value that is made of a pair into one list that has the pair.
    fn replace_in(&mut self, value: ValueId, pair: &Pair, shared: ValueId, scale: &Rational) {
        let (first, second, _) = pair;
        for old in self.pairs(value, |x| x == *first || x == *second || x == shared) {
            self.leave(old, value);
        }
        let factor = self.take(value, *first);
        self.take(value, *second);
        L::push(self.dag, value, shared, ratio(&factor, scale));
        for new in self.pairs(value, |x| x == *first || x == *second || x == shared) {
            self.enter(new, value);
        }
    }

    /// Removes one part of a list, and returns its multiple.
    fn take(&mut self, value: ValueId, part: ValueId) -> Rational {
        let Some(position) = self.position(value, part) else {
            return Rational::ONE;
        };
        let multiple = L::part(self.dag, value, position).1.clone();
        L::remove(self.dag, value, position);
        multiple
    }

    fn position(&self, value: ValueId, part: ValueId) -> Option<usize> {
        let length = L::length(self.dag, value).unwrap_or(0);
        (0..length).find(|position| L::part(self.dag, value, *position).0 == part)
    }

    /// The multiple of the pair's first part in the value that is made of the pair.
    fn scale_of(&self, shared: ValueId, pair: &Pair) -> Rational {
        let position = self.position(shared, pair.0);
        position.map_or(Rational::ONE, |position| {
            L::part(self.dag, shared, position).1.clone()
        })
    }
}

/// Of each value, whether it is part of one list at most and no list itself, which could take the place of a pair.
fn unshared<L: Lists>(dag: &Dag) -> Vec<bool> {
    let mut uses = vec![0_usize; dag.operations.len()];
    for value in 0..dag.operations.len() {
        let length = L::length(dag, value).unwrap_or(0);
        if length > MAX_SEARCHED_LIST_LENGTH {
            continue;
        }
        for position in 0..length {
            uses[L::part(dag, value, position).0] += 1;
        }
    }
    let mut unshared = vec![false; uses.len()];
    for (value, uses) in uses.into_iter().enumerate() {
        unshared[value] = uses < 2 && L::length(dag, value).is_none_or(|length| length < 2);
    }
    unshared
}

/// Whether a list consists of two parts and nothing else.
fn is_complete<L: Lists>(dag: &Dag, value: ValueId) -> bool {
    let divides = matches!(&dag.operations[value], DagOperation::Quotient(_, denominator) if !denominator.is_empty());
    !divides && L::length(dag, value) == Some(2)
}

/// x/y for y ≠ 0.
fn ratio(x: &Rational, y: &Rational) -> Rational {
    if x == y {
        return Rational::ONE;
    }
    y.reciprocal().map_or(Rational::ONE, |inverse| x * &inverse)
}
