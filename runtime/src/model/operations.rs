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
    pub const NONE: Self = operations([[0; METHODS]; 6]);
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

/// How many methods are counted.
const METHODS: usize = 10;

/// Returns the counts of all methods. Each row counts one kind of operation for all methods in the order of the fields: additions,
/// multiplications, divisions, square roots, sines and cosines, functions.
#[must_use]
pub const fn operations(counts: [[usize; METHODS]; 6]) -> Operations {
    Operations {
        lagrangian: of_method(&counts, 0),
        energy: of_method(&counts, 1),
        momenta: of_method(&counts, 2),
        mass_matrix: of_method(&counts, 3),
        forcing: of_method(&counts, 4),
        generalized_forces: of_method(&counts, 5),
        prepare: of_method(&counts, 6),
        accelerations: of_method(&counts, 7),
        inverse_dynamics: of_method(&counts, 8),
        linearize: of_method(&counts, 9),
    }
}

const fn of_method(counts: &[[usize; METHODS]; 6], method: usize) -> OperationCount {
    let [sums, products, quotients, roots, sines, functions] = counts;
    OperationCount {
        additions: sums[method],
        multiplications: products[method],
        divisions: quotients[method],
        square_roots: roots[method],
        sines_and_cosines: sines[method],
        functions: functions[method],
    }
}
