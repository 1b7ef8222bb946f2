//! What several products or several sums have in common becomes one value.
//!
//! Greedily: the pair of factors that occurs in most products is made a value of its own and stands in
//! their place, until every pair is in one product only. The same for pairs of terms, up to a common
//! multiple. Ties are broken by the order of values, so that the result does not depend on hashing.

use core::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

use crate::Rational;
use crate::program::plan::{Plan, Recipe, Value, merged};

/// Lists longer than this are left alone: their pairs grow with the square of the length.
const LONGEST: usize = 24;

/// Two parts of a list, in order. For a sum, with what the second is multiplied by if the first is not.
type Pair = (Value, Value, Rational);

/// Lists of parts in which pairs are looked for: the numerators of products, or sums.
trait Lists {
    /// The parts of a value, with their multiples.
    fn parts(plan: &Plan, value: Value) -> Option<Vec<(Value, Rational)>>;
    /// The value with other parts.
    fn rebuild(plan: &mut Plan, value: Value, parts: Vec<(Value, Rational)>);
    /// A value made of one pair.
    fn make(plan: &mut Plan, pair: &Pair) -> Value;
}

struct Products;
struct Sums;

impl Plan {
    /// Finds what products have in common, then what sums have in common.
    pub(crate) fn share(&mut self) {
        Sharing::<Products>::run(self);
        Sharing::<Sums>::run(self);
    }
}

impl Lists for Products {
    fn parts(plan: &Plan, value: Value) -> Option<Vec<(Value, Rational)>> {
        match &plan.recipes[value] {
            Recipe::Quotient(numerator, _) => {
                Some(numerator.iter().map(|x| (*x, Rational::ONE)).collect())
            }
            _ => None,
        }
    }

    fn rebuild(plan: &mut Plan, value: Value, parts: Vec<(Value, Rational)>) {
        if let Recipe::Quotient(numerator, _) = &mut plan.recipes[value] {
            *numerator = parts.into_iter().map(|(x, _)| x).collect();
        }
    }

    fn make(plan: &mut Plan, (x, y, _): &Pair) -> Value {
        plan.push(Recipe::Quotient(vec![*x, *y], Vec::new()), None)
    }
}

impl Lists for Sums {
    fn parts(plan: &Plan, value: Value) -> Option<Vec<(Value, Rational)>> {
        match &plan.recipes[value] {
            Recipe::Sum(terms) => Some(terms.clone()),
            _ => None,
        }
    }

    fn rebuild(plan: &mut Plan, value: Value, parts: Vec<(Value, Rational)>) {
        // What is shared may have been a part already. Else the order stays as it was.
        let once = merged(parts.iter().cloned());
        let repeats = once.len() < parts.len();
        plan.recipes[value] = Recipe::Sum(if repeats { once } else { parts });
    }

    fn make(plan: &mut Plan, (x, y, ratio): &Pair) -> Value {
        plan.push(
            Recipe::Sum(vec![(*x, Rational::ONE), (*y, ratio.clone())]),
            None,
        )
    }
}

/// Where each pair occurs.
struct Sharing<'a, L> {
    plan: &'a mut Plan,
    occurrences: BTreeMap<Pair, BTreeSet<Value>>,
    /// Pairs by how often they occurred when they were put here; checked again when taken.
    queue: BinaryHeap<(usize, Reverse<Pair>)>,
    lists: core::marker::PhantomData<L>,
}

impl<'a, L: Lists> Sharing<'a, L> {
    fn run(plan: &'a mut Plan) {
        let mut sharing = Self {
            plan,
            occurrences: BTreeMap::new(),
            queue: BinaryHeap::new(),
            lists: core::marker::PhantomData,
        };
        for value in 0..sharing.plan.recipes.len() {
            sharing.enter(value);
        }
        while let Some((count, Reverse(pair))) = sharing.queue.pop() {
            let now = sharing.occurrences.get(&pair).map_or(0, BTreeSet::len);
            if now > 1 && now == count {
                sharing.replace(&pair);
            }
        }
    }

    /// Notes the pairs of a list.
    fn enter(&mut self, value: Value) {
        for pair in self.pairs(value) {
            let lists = self.occurrences.entry(pair.clone()).or_default();
            lists.insert(value);
            if lists.len() > 1 {
                self.queue.push((lists.len(), Reverse(pair)));
            }
        }
    }

    /// Forgets the pairs of a list.
    fn leave(&mut self, value: Value) {
        for pair in self.pairs(value) {
            if let Some(lists) = self.occurrences.get_mut(&pair) {
                lists.remove(&value);
                if lists.len() > 1 {
                    self.queue.push((lists.len(), Reverse(pair)));
                }
            }
        }
    }

    fn pairs(&self, value: Value) -> BTreeSet<Pair> {
        let parts = L::parts(self.plan, value).unwrap_or_default();
        if parts.len() > LONGEST {
            return BTreeSet::new();
        }
        let mut pairs = BTreeSet::new();
        for (i, (x, c)) in parts.iter().enumerate() {
            for (y, d) in &parts[i + 1..] {
                let ((x, c), (y, d)) = if x <= y {
                    ((x, c), (y, d))
                } else {
                    ((y, d), (x, c))
                };
                let ratio = c.reciprocal().map_or(Rational::ONE, |inverse| d * &inverse);
                pairs.insert((*x, *y, ratio));
            }
        }
        pairs
    }

    /// Makes a value of a pair and puts it into all lists that have the pair.
    fn replace(&mut self, pair: &Pair) {
        let lists = self.occurrences.remove(pair).unwrap_or_default();
        // A list that is just the pair is the value already.
        let whole = lists.iter().copied().find(|value| self.is_whole(*value));
        let shared = whole.unwrap_or_else(|| L::make(self.plan, pair));
        for value in lists {
            if value == shared {
                continue;
            }
            self.leave(value);
            let mut parts = L::parts(self.plan, value).unwrap_or_default();
            let factor = take(&mut parts, pair.0);
            take(&mut parts, pair.1);
            let scale = self.scale_of(shared, pair);
            let multiple = scale
                .reciprocal()
                .map_or(Rational::ONE, |inverse| &factor * &inverse);
            parts.push((shared, multiple));
            L::rebuild(self.plan, value, parts);
            self.enter(value);
        }
        self.enter(shared);
    }

    /// Whether a list has two parts and nothing else is computed with it.
    fn is_whole(&self, value: Value) -> bool {
        let divides = matches!(&self.plan.recipes[value], Recipe::Quotient(_, denominator) if !denominator.is_empty());
        !divides && L::parts(self.plan, value).is_some_and(|parts| parts.len() == 2)
    }

    /// The multiple of the pair's first part in the value that is made of the pair.
    fn scale_of(&self, shared: Value, pair: &Pair) -> Rational {
        let parts = L::parts(self.plan, shared).unwrap_or_default();
        let first = parts.into_iter().find(|(x, _)| *x == pair.0);
        first.map_or(Rational::ONE, |(_, c)| c)
    }
}

/// Removes one part of a list, and returns its multiple.
fn take(parts: &mut Vec<(Value, Rational)>, part: Value) -> Rational {
    match parts.iter().position(|(x, _)| *x == part) {
        Some(position) => parts.remove(position).1,
        None => Rational::ONE,
    }
}
