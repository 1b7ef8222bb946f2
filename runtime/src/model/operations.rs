//! Operation counts of the emitted methods.

/// The operations of one emitted method by kind, including a numerical factorization of the mass matrix.
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
    /// Sines and cosines; the pair of one angle counts as one.
    pub sines_and_cosines: usize,
    /// All other elementary functions.
    pub functions: usize,
}

/// The operation counts of a model's methods.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// The count of `lagrangian`.
    pub lagrangian: OperationCount,
    /// The count of `energy`.
    pub energy: OperationCount,
    /// The count of `momenta`.
    pub momenta: OperationCount,
    /// The count of `mass_matrix`.
    pub mass_matrix: OperationCount,
    /// The count of `forcing`.
    pub forcing: OperationCount,
    /// The count of `generalized_forces`.
    pub generalized_forces: OperationCount,
    /// The count of `prepare`, which computes the quantities that depend only on parameters.
    pub prepare: OperationCount,
    /// The count of `accelerations`, after `prepare`.
    pub accelerations: OperationCount,
    /// The count of `inverse_dynamics`, after `prepare`.
    pub inverse_dynamics: OperationCount,
    /// The count of `linearize`.
    pub linearize: OperationCount,
}

impl Operations {
    /// The counts of a model without equations.
    #[doc(hidden)]
    pub const NONE: Self = operations([[0; 6]; 10]);
}

impl OperationCount {
    /// Returns the sum of all operations; each function counts as one.
    #[must_use]
    pub const fn total(&self) -> usize {
        self.additions
            + self.multiplications
            + self.divisions
            + self.square_roots
            + self.sines_and_cosines
            + self.functions
    }
}

/// Returns the counts of additions, multiplications, divisions, square roots, sines and cosines, and functions.
#[doc(hidden)]
#[must_use]
const fn operation_count(counts: [usize; 6]) -> OperationCount {
    OperationCount {
        additions: counts[0],
        multiplications: counts[1],
        divisions: counts[2],
        square_roots: counts[3],
        sines_and_cosines: counts[4],
        functions: counts[5],
    }
}

/// Returns the counts of all methods, in the order of the fields.
#[must_use]
pub const fn operations(counts: [[usize; 6]; 10]) -> Operations {
    Operations {
        lagrangian: operation_count(counts[0]),
        energy: operation_count(counts[1]),
        momenta: operation_count(counts[2]),
        mass_matrix: operation_count(counts[3]),
        forcing: operation_count(counts[4]),
        generalized_forces: operation_count(counts[5]),
        prepare: operation_count(counts[6]),
        accelerations: operation_count(counts[7]),
        inverse_dynamics: operation_count(counts[8]),
        linearize: operation_count(counts[9]),
    }
}
