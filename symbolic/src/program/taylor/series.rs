//! The Taylor series of values, and what series are made of.

use crate::algebra::hashing::Table;
use crate::program::straight_line::Operand;
use crate::{ExternalFunction, Rational};

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

/// The sum Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ, which the recurrence reads as a [symbol](crate::Symbol::Convolution): the indices of x and y among
/// the factors.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Convolution(pub usize, pub usize);

/// Why a program that applies an external function has no Taylor series.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NoSeries {
    /// The function that the program applies.
    pub function: ExternalFunction,
    /// The function that it or one of its derivatives is, and the position of the argument, whose derivative the series
    /// needs and which is not declared; none if the derivatives apply functions at ever further arguments.
    pub undeclared: Option<(ExternalFunction, usize)>,
}
