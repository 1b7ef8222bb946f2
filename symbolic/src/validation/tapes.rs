//! The programs of a model that are validated, as tapes.

use crate::Symbol;
use crate::identity::real_point::RealPoint;
use crate::validation::perturbation::Perturbation;
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::tape::Tape;

/// The program for the accelerations and the multipliers x in A x = b, or for derivatives of them.
pub struct SolutionTape {
    /// If x is solved for symbolically: pivots, x, the columns of its derivatives, and if there are pivots those of
    /// δ(A x − b). If not: the lower triangle of A, row by row, b, and the columns of δ(A x − b), up to a common factor.
    /// There is neither x nor b beside derivatives by the inputs.
    pub tape: Tape,
    /// The number of pivots, if x is solved for symbolically.
    pub pivots: Option<usize>,
    /// Whether δ(A x − b) along a [variation](Symbol::Variation) is computed in place of its columns behind those of
    /// the derivatives.
    pub is_along_variation: bool,
}

/// The programs of the constraints of a model.
pub struct ConstraintTapes {
    /// How many of them are holonomic.
    pub holonomic: usize,
    /// Whether the gradients are independent at almost all states; otherwise only states that fulfil the constraints have
    /// accelerations.
    pub are_independent: bool,
    /// g of the holonomic constraints, which are the first ones, and 0 for the others.
    pub positions: Tape,
    /// w = G q̇ + a.
    pub velocities: Tape,
    /// G, column by column.
    pub jacobian: Tape,
    /// γ in G q̈ + γ = 0.
    pub rates: Tape,
}

/// The programs of a model.
pub struct Tapes {
    /// L.
    pub lagrangian: Tape,
    /// T and V; nothing where they were not declared.
    pub energies: Tape,
    /// The energy function.
    pub energy: Tape,
    /// p.
    pub momenta: Tape,
    /// M, row by row; none where its columns are the momenta at unit velocities.
    pub mass_matrix: Option<Tape>,
    /// f.
    pub forcing: Tape,
    /// Q.
    pub generalized_forces: Tape,
    /// M q̈ − f.
    pub inverse_dynamics: Tape,
    /// The setup program of q̈ and M q̈ − f, which computes the invariants.
    pub preparation: Tape,
    /// q̈, and behind it the multipliers of the constraints.
    pub accelerations: SolutionTape,
    /// The tapes of the constraints, if there are some.
    pub constraints: Option<ConstraintTapes>,
    /// Derivatives of q̈ by q, q̇ and t; none where they are those of the inverse dynamics on dual numbers, and with
    /// constraints.
    pub state_jacobian: Option<SolutionTape>,
    /// Derivatives of q̈ and the multipliers by the inputs; none where they are those of the inverse dynamics on dual
    /// numbers.
    pub input_jacobian: Option<SolutionTape>,
    /// Quantities for observers.
    pub outputs: Tape,
    /// ∂L/∂q + Q.
    pub momentum_rates: Option<Tape>,
    /// The velocities that have the momenta, which stand for right-hand sides; pivots may stand before them.
    pub velocities: Option<Tape>,
    /// Q·q̇ − ∂L/∂t.
    pub energy_rate: Option<Tape>,
    /// Derivatives of q̈ and the multipliers by parameters, and these in the order of the columns.
    pub sensitivities: Option<(SolutionTape, Vec<Symbol>)>,
    /// The columns of Y, then what is known, r, and the base parameters: M q̈ − f = Y π + r.
    pub regressor: Option<[Tape; 3]>,
}

impl Tapes {
    /// The values of a program that reads the invariants.
    pub(crate) fn prepared(
        &self,
        tape: &Tape,
        value: impl Fn(Symbol) -> f64,
        perturbation: Perturbation,
    ) -> Vec<f64> {
        let invariants = self.preparation.evaluate(&value, perturbation);
        let symbol = |symbol: Symbol| match symbol {
            Symbol::Invariant(index) => invariants[index as usize],
            _ => value(symbol),
        };
        tape.evaluate(&symbol, perturbation)
    }

    /// Whether the accelerations of a constrained model are solved for with pivoting at a point, by code that is not validated.
    pub(crate) fn uses_pivoting(&self, point: RealPoint) -> bool {
        let Some(pivots) = self
            .accelerations
            .pivots
            .filter(|_| self.constraints.is_some())
        else {
            return false;
        };
        let value = |symbol: Symbol| point.value(symbol);
        let outputs = self.prepared(&self.accelerations.tape, value, Perturbation(None));
        let mut pivots = outputs[..pivots].iter();
        pivots.any(|pivot| pivot.is_nan() || *pivot <= 0.0)
    }

    /// The accelerations at a point, if they exist.
    pub(crate) fn accelerations(
        &self,
        point: RealPoint,
        coordinates: usize,
        perturbation: Perturbation,
    ) -> Option<Vec<f64>> {
        if let Some((matrix, forcing)) = self.system(point, coordinates, perturbation) {
            let constraints = self.constraints.as_ref();
            let are_independent = constraints.is_none_or(|tapes| tapes.are_independent);
            let solution = are_independent.then(|| matrix.solve(&forcing)).flatten();
            return solution.filter(|accelerations| accelerations.iter().all(|x| x.is_finite()));
        }
        let value = |symbol: Symbol| point.value(symbol);
        let mut outputs = self.prepared(&self.accelerations.tape, value, perturbation);
        let accelerations = outputs.split_off(self.accelerations.pivots?);
        let mut all = accelerations.iter();
        all.all(|x| x.is_finite()).then_some(accelerations)
    }

    /// The matrix and the right-hand side at a point, where the accelerations are solved for numerically.
    pub(crate) fn system(
        &self,
        point: RealPoint,
        coordinates: usize,
        perturbation: Perturbation,
    ) -> Option<(SquareMatrix, Vec<f64>)> {
        if self.accelerations.pivots.is_some() {
            return None;
        }
        let value = |symbol: Symbol| point.value(symbol);
        let mut lower = self.prepared(&self.accelerations.tape, value, perturbation);
        let forcing = lower.split_off(lower.len() - coordinates);
        Some((SquareMatrix::symmetric(&lower, coordinates), forcing))
    }
}
