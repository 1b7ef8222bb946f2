//! What several products or several sums have in common becomes one value.
//!
//! Greedily: the pair of factors that occurs in most products is made a value of its own and stands in
//! their place, until every pair is in one product only. The same for pairs of terms, up to a common
//! multiple. Ties are broken by the order of values, so that the result does not depend on hashing.
//! When a pair is replaced, only the pairs that it is part of are counted anew.

use core::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::algebra::hashing::Table;
use crate::program::plan::{Plan, Recipe, Value};
use crate::{Pass, Passes, Rational};

/// Lists longer than this are left alone: their pairs grow with the square of the length.
const LONGEST: usize = 24;

/// Two parts of a list, in order. For a sum, with what the second is multiplied by if the first is not.
type Pair = (Value, Value, Rational);

/// Lists of parts in which pairs are looked for: the numerators of products, or sums.
trait Lists {
    /// How many parts a value is made of, if it is such a list.
    fn length(plan: &Plan, value: Value) -> Option<usize>;
    /// One part of a list, with its multiple.
    fn part(plan: &Plan, value: Value, position: usize) -> (Value, &Rational);
    /// Takes a part out of a list.
    fn remove(plan: &mut Plan, value: Value, position: usize);
    /// Puts a part into a list.
    fn push(plan: &mut Plan, value: Value, part: Value, multiple: Rational);
    /// A value made of one pair.
    fn make(plan: &mut Plan, pair: &Pair) -> Value;
}

struct Products;
struct Sums;

impl Plan {
    /// Finds what products have in common, then what sums have in common.
    pub(crate) fn share(&mut self, passes: Passes) {
        if passes.has(Pass::SharedProducts) {
            Sharing::<Products>::run(self);
        }
        if passes.has(Pass::SharedSums) {
            Sharing::<Sums>::run(self);
        }
    }

    fn numerator(&self, value: Value) -> &[Value] {
        match &self.recipes[value] {
            Recipe::Quotient(numerator, _) => numerator,
            _ => &[],
        }
    }

    fn terms(&self, value: Value) -> &[(Value, Rational)] {
        match &self.recipes[value] {
            Recipe::Sum(terms) => terms,
            _ => &[],
        }
    }
}

impl Lists for Products {
    fn length(plan: &Plan, value: Value) -> Option<usize> {
        match &plan.recipes[value] {
            Recipe::Quotient(numerator, _) => Some(numerator.len()),
            _ => None,
        }
    }

    fn part(plan: &Plan, value: Value, position: usize) -> (Value, &Rational) {
        static ONE: Rational = Rational::ONE;
        (plan.numerator(value)[position], &ONE)
    }

    fn remove(plan: &mut Plan, value: Value, position: usize) {
        if let Recipe::Quotient(numerator, _) = &mut plan.recipes[value] {
            numerator.remove(position);
        }
    }

    fn push(plan: &mut Plan, value: Value, part: Value, _: Rational) {
        if let Recipe::Quotient(numerator, _) = &mut plan.recipes[value] {
            numerator.push(part);
        }
    }

    fn make(plan: &mut Plan, (x, y, _): &Pair) -> Value {
        plan.push(Recipe::Quotient(vec![*x, *y], Vec::new()), None)
    }
}

impl Lists for Sums {
    fn length(plan: &Plan, value: Value) -> Option<usize> {
        match &plan.recipes[value] {
            Recipe::Sum(terms) => Some(terms.len()),
            _ => None,
        }
    }

    fn part(plan: &Plan, value: Value, position: usize) -> (Value, &Rational) {
        let (x, c) = &plan.terms(value)[position];
        (*x, c)
    }

    fn remove(plan: &mut Plan, value: Value, position: usize) {
        if let Recipe::Sum(terms) = &mut plan.recipes[value] {
            terms.remove(position);
        }
    }

    fn push(plan: &mut Plan, value: Value, part: Value, multiple: Rational) {
        let Recipe::Sum(terms) = &mut plan.recipes[value] else {
            return;
        };
        // What is shared may have been a term already.
        match terms.iter_mut().find(|(term, _)| *term == part) {
            Some((_, coefficient)) => *coefficient = &*coefficient + &multiple,
            None => terms.push((part, multiple)),
        }
        terms.retain(|(_, coefficient)| !coefficient.is_zero());
    }

    fn make(plan: &mut Plan, (x, y, ratio): &Pair) -> Value {
        plan.push(
            Recipe::Sum(vec![(*x, Rational::ONE), (*y, ratio.clone())]),
            None,
        )
    }
}

/// The lists that a pair occurs in.
#[derive(Default)]
struct Occurrences {
    /// In ascending order.
    lists: Vec<Value>,
    /// The number of lists under which the pair waits in the queue, or 0.
    queued: usize,
}

/// Where each pair occurs.
struct Sharing<'a, L> {
    plan: &'a mut Plan,
    occurrences: Table<Pair, Occurrences>,
    /// Pairs by how often they occurred when they were put here, which is checked again when they are taken.
    /// Of those that occur as often, one that is a whole list comes first: it is computed anyway.
    queue: BinaryHeap<(usize, bool, Reverse<Pair>)>,
    /// Pairs that occur in more or fewer lists than when the queue last heard of them.
    changed: Vec<Pair>,
    lists: core::marker::PhantomData<L>,
}

impl<'a, L: Lists> Sharing<'a, L> {
    fn run(plan: &'a mut Plan) {
        let mut sharing = Self {
            plan,
            occurrences: Table::default(),
            queue: BinaryHeap::new(),
            changed: Vec::new(),
            lists: core::marker::PhantomData,
        };
        for value in 0..sharing.plan.recipes.len() {
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
    fn enter(&mut self, pair: Pair, value: Value) {
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
    fn leave(&mut self, pair: Pair, value: Value) {
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
                let plan = &*self.plan;
                let whole = occurrences
                    .lists
                    .iter()
                    .any(|list| is_whole::<L>(plan, *list));
                self.queue.push((count, whole, Reverse(pair)));
            }
        }
    }

    /// The pairs of a list with at least one part for which `wanted` holds.
    fn pairs(&self, value: Value, wanted: impl Fn(Value) -> bool) -> Vec<Pair> {
        let length = L::length(self.plan, value).unwrap_or(0);
        let mut pairs = Vec::new();
        if length > LONGEST {
            return pairs;
        }
        for i in 0..length {
            let (x, c) = L::part(self.plan, value, i);
            let all = wanted(x);
            for j in i + 1..length {
                let (y, d) = L::part(self.plan, value, j);
                if !(all || wanted(y)) {
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
        // A list that is just the pair is the value already.
        let whole = lists
            .iter()
            .copied()
            .find(|value| is_whole::<L>(self.plan, *value));
        let shared = whole.unwrap_or_else(|| L::make(self.plan, pair));
        let scale = self.scale_of(shared, pair);
        for value in lists {
            if value != shared {
                self.replace_in(value, pair, shared, &scale);
            }
        }
        self.enter(pair.clone(), shared);
    }

    /// Puts the value that is made of a pair into one list that has the pair.
    fn replace_in(&mut self, value: Value, pair: &Pair, shared: Value, scale: &Rational) {
        let (first, second, _) = pair;
        for old in self.pairs(value, |x| x == *first || x == *second || x == shared) {
            self.leave(old, value);
        }
        let factor = self.take(value, *first);
        self.take(value, *second);
        L::push(self.plan, value, shared, ratio(&factor, scale));
        for new in self.pairs(value, |x| x == *first || x == *second || x == shared) {
            self.enter(new, value);
        }
    }

    /// Removes one part of a list, and returns its multiple.
    fn take(&mut self, value: Value, part: Value) -> Rational {
        let Some(position) = self.position(value, part) else {
            return Rational::ONE;
        };
        let multiple = L::part(self.plan, value, position).1.clone();
        L::remove(self.plan, value, position);
        multiple
    }

    fn position(&self, value: Value, part: Value) -> Option<usize> {
        let length = L::length(self.plan, value).unwrap_or(0);
        (0..length).find(|position| L::part(self.plan, value, *position).0 == part)
    }

    /// The multiple of the pair's first part in the value that is made of the pair.
    fn scale_of(&self, shared: Value, pair: &Pair) -> Rational {
        let position = self.position(shared, pair.0);
        position.map_or(Rational::ONE, |position| {
            L::part(self.plan, shared, position).1.clone()
        })
    }
}

/// Whether a list has two parts and nothing else is computed with it.
fn is_whole<L: Lists>(plan: &Plan, value: Value) -> bool {
    let divides =
        matches!(&plan.recipes[value], Recipe::Quotient(_, denominator) if !denominator.is_empty());
    !divides && L::length(plan, value) == Some(2)
}

/// x/y for y ≠ 0.
fn ratio(x: &Rational, y: &Rational) -> Rational {
    if x == y {
        return Rational::ONE;
    }
    y.reciprocal().map_or(Rational::ONE, |inverse| x * &inverse)
}
