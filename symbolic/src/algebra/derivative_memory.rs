//! What derivatives of one graph are computed in, kept from one to the next.
//!
//! A model takes thousands of derivatives of single angles and small vectors, in one direction: memory for the whole
//! arena, and the direction of time, are not made anew for each.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::{Expression, Symbol};

/// The direction of a derivative: for each symbol its own derivative, 0 for those not named.
pub type Direction = BTreeMap<Symbol, Expression>;

/// The memory of the derivatives of one graph.
#[derive(Clone, Debug, Default)]
pub(crate) struct DerivativeMemory {
    /// By expression, zeros between two derivatives.
    zeros: Vec<Expression>,
    /// The direction of time, and for how many coordinates.
    time: Option<(u32, Rc<Direction>)>,
}

impl DerivativeMemory {
    /// Zeros for at least so many expressions. Whoever takes them returns them, all zero again.
    pub(crate) fn take_zeros(&mut self, length: usize, zero: Expression) -> Vec<Expression> {
        let mut zeros = core::mem::take(&mut self.zeros);
        if zeros.len() < length {
            zeros.resize(length.next_power_of_two(), zero);
        }
        zeros
    }

    /// Takes zeros back.
    pub(crate) fn return_zeros(&mut self, zeros: Vec<Expression>) {
        self.zeros = zeros;
    }

    /// The direction of time of a system with so many coordinates, if it is known.
    pub(crate) fn time(&self, coordinates: u32) -> Option<Rc<Direction>> {
        let (known, direction) = self.time.as_ref()?;
        (*known == coordinates).then(|| Rc::clone(direction))
    }

    /// Keeps the direction of time.
    pub(crate) fn keep_time(&mut self, coordinates: u32, direction: &Rc<Direction>) {
        self.time = Some((coordinates, Rc::clone(direction)));
    }
}
