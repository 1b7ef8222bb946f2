//! The Taylor series of values, and what series are made of.

use crate::Rational;
use crate::algebra::hashing::Table;
use crate::program::straight_line::Operand;

/// The Taylor series of a value.
#[derive(Clone, Debug)]
pub(super) struct Series {
    /// Its term of order 0, an operand of the initial program.
    pub(super) constant: Operand,
    /// Its coefficient of order k, an operand of the recurrence; 0 if it does not vary.
    pub(super) coefficient: Operand,
}

impl Series {
    pub(super) fn varies(&self) -> bool {
        self.coefficient != ZERO
    }
}

pub(super) const ZERO: Operand = Operand::Constant(Rational::ZERO);

/// The index of a factor of convolutions.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Factor(pub(super) usize);

/// Different items, numbered in the order in which they were first met.
pub(super) struct Numbered<T> {
    pub(super) items: Vec<T>,
    numbers: Table<T, usize>,
}

impl<T: Clone + Eq + core::hash::Hash> Numbered<T> {
    pub(super) fn new() -> Self {
        Self {
            items: Vec::new(),
            numbers: Table::default(),
        }
    }

    /// The number of an item.
    pub(super) fn number(&mut self, item: T) -> u32 {
        let number = *self.numbers.entry(item).or_insert_with_key(|item| {
            self.items.push(item.clone());
            self.items.len() - 1
        });
        u32::try_from(number).unwrap_or(u32::MAX)
    }
}

/// Two functions that are each other's derivatives, up to the sign.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Pair {
    SineCosine,
    HyperbolicSineCosine,
}
