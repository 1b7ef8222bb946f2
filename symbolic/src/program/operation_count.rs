//! The number of operations of a program, and their cost.

use crate::limits::{
    COST_OF_DIVISION, COST_OF_FUNCTION, COST_OF_SINE_AND_COSINE, COST_OF_SQUARE_ROOT,
};
use crate::{Operation, Program, Unary};

/// The number of operations of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OperationCount {
    /// Additions, subtractions and changes of sign.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Sines and cosines; the pair of one angle counts once.
    pub sines_and_cosines: usize,
    /// All other functions, external ones included.
    pub functions: usize,
}

impl OperationCount {
    /// The counts in the order of the fields.
    #[must_use]
    pub const fn by_kind(&self) -> [usize; 6] {
        [
            self.additions,
            self.multiplications,
            self.divisions,
            self.square_roots,
            self.sines_and_cosines,
            self.functions,
        ]
    }

    /// The sum of all operations, each function counted as one.
    #[must_use]
    pub fn total(&self) -> usize {
        self.by_kind().iter().sum()
    }

    /// The cost of all operations, in additions.
    #[must_use]
    pub const fn cost(&self) -> usize {
        self.additions
            + self.multiplications
            + COST_OF_DIVISION * self.divisions
            + COST_OF_SQUARE_ROOT * self.square_roots
            + COST_OF_SINE_AND_COSINE * self.sines_and_cosines
            + COST_OF_FUNCTION * self.functions
    }
}

impl Program {
    /// The number of operations of each kind.
    #[must_use]
    pub fn count(&self) -> OperationCount {
        self.count_before(self.groups.len())
    }

    /// The number of operations of each kind in so many groups.
    #[must_use]
    pub fn count_before(&self, groups: usize) -> OperationCount {
        let mut count = OperationCount::default();
        let groups = self.groups.iter().take(groups);
        for instruction in groups.flat_map(|group| &group.instructions) {
            *match instruction.operation {
                Operation::Add(..) | Operation::Subtract(..) | Operation::Negate(_) => {
                    &mut count.additions
                }
                Operation::Multiply(..) => &mut count.multiplications,
                Operation::Divide(..) => &mut count.divisions,
                Operation::SquareRoot(_) => &mut count.square_roots,
                Operation::SineAndCosine(_) | Operation::Unary(Unary::Sin | Unary::Cos, _) => {
                    &mut count.sines_and_cosines
                }
                Operation::Unary(..) | Operation::Binary(..) | Operation::Application(..) => {
                    &mut count.functions
                }
            } += 1;
        }
        count
    }
}
