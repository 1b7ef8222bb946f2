//! The directional derivative of accelerations along a variation, by the programs for derivatives of q̈.

use std::collections::BTreeMap;

use crate::validation::lagrange::Variation;
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::sum_with_size::SumWithSize;

/// The outputs of the programs for derivatives.
#[derive(Clone, Copy)]
pub(crate) enum LinearizationOutputs {
    /// Pivots in this number, q̈ (by the state only), columns of ∂q̈/∂x, and columns of ∂(M q̈ − f)/∂x if there
    /// are pivots.
    Solved(usize),
    /// The same, but by the state δ(M q̈ − f) along a variation in place of the last columns.
    SolvedAlongVariation(usize),
    /// The lower triangle of M, f (by the state only), and columns of ∂(M q̈ − f)/∂x.
    System,
}

/// The values of the programs for derivatives at a point.
pub(crate) struct LinearizationCheck {
    pub(crate) state: Vec<f64>,
    pub(crate) inputs: Vec<f64>,
    pub(crate) linearization_outputs: LinearizationOutputs,
}

impl LinearizationCheck {
    /// M δq̈ + δ(M q̈ − f) at fixed q̈, which vanishes, and the differences of what else is computed to what the
    /// equations say: of q̈, or M q̈ − f, and of δ(M q̈ − f).
    pub(crate) fn balances(
        &self,
        mass: &SquareMatrix,
        accelerations: &[f64],
        variations: &[SumWithSize],
        variation: &Variation,
    ) -> Vec<SumWithSize> {
        let n = variations.len();
        let triangle = n * (n + 1) / 2;
        match self.linearization_outputs {
            LinearizationOutputs::Solved(pivots)
            | LinearizationOutputs::SolvedAlongVariation(pivots) => {
                let columns = n * variation.state.len();
                let changes = self.sum(n, [pivots + n, pivots], variation);
                let mut balances = balance(mass, &changes, variations);
                let found = &self.state[pivots..pivots + n];
                balances.extend(differences(found, accelerations));
                if pivots > 0 {
                    let starts = [pivots + n + columns, pivots + n * variation.inputs.len()];
                    let residuals = self.residuals(n, starts, variation);
                    for (mut balance, expected) in residuals.into_iter().zip(variations) {
                        balance.total -= expected.total;
                        balance.size += expected.size;
                        balances.push(balance);
                    }
                }
                balances
            }
            LinearizationOutputs::System => {
                let residuals = self.sum(n, [triangle + n, triangle], variation);
                let right: Vec<f64> = residuals.iter().map(|sum| -sum.total).collect();
                let matrix = SquareMatrix::symmetric(&self.state[..triangle], n);
                // Both programs compute M.
                let mut equations = matrix.times(accelerations);
                let (first, second) = (&self.inputs[..triangle], &self.state[..triangle]);
                equations.extend(differences(first, second));
                for (equation, force) in equations.iter_mut().zip(&self.state[triangle..][..n]) {
                    equation.add(-force);
                }
                let Some(changes) = matrix.solve(&right) else {
                    return vec![UNDEFINED];
                };
                let exact = |total: f64| SumWithSize {
                    total,
                    size: total.abs(),
                };
                let changes: Vec<_> = changes.into_iter().map(exact).collect();
                equations.extend(balance(mass, &changes, variations));
                equations
            }
        }
    }

    /// δ(M q̈ − f), from what begins by the state and by the inputs.
    fn residuals(&self, n: usize, starts: [usize; 2], variation: &Variation) -> Vec<SumWithSize> {
        if let LinearizationOutputs::Solved(_) = self.linearization_outputs {
            return self.sum(n, starts, variation);
        }
        let by_inputs = Variation {
            state: Vec::new(),
            inputs: variation.inputs.clone(),
            velocities: Vec::new(),
            parameters: BTreeMap::new(),
        };
        let mut residuals = self.sum(n, starts, &by_inputs);
        for (residual, value) in residuals.iter_mut().zip(&self.state[starts[0]..]) {
            residual.add(*value);
        }
        residuals
    }

    /// Σ column·weight, where the columns begin by the state and by the inputs.
    fn sum(&self, n: usize, starts: [usize; 2], variation: &Variation) -> Vec<SumWithSize> {
        let mut sums = vec![SumWithSize::default(); n];
        let parts = [
            (&self.state, starts[0], &variation.state),
            (&self.inputs, starts[1], &variation.inputs),
        ];
        for (values, start, weights) in parts {
            for (j, weight) in weights.iter().enumerate() {
                for (i, sum) in sums.iter_mut().enumerate() {
                    sum.add(weight * values[start + j * n + i]);
                }
            }
        }
        sums
    }
}

/// What should vanish of the derivatives of q̈ by the inputs alone: M δq̈ + δ(M q̈ − f) where they are solved for, and what is
/// found of δ(M q̈ − f) less its value.
pub(crate) fn input_balances(
    found: &[f64],
    pivots: Option<usize>,
    mass: &SquareMatrix,
    (variations, variation): (&[SumWithSize], &Variation),
) -> Vec<SumWithSize> {
    let n = variations.len();
    let sum = |start: usize| {
        let mut sums = vec![SumWithSize::default(); n];
        for (j, weight) in variation.inputs.iter().enumerate() {
            for (i, sum) in sums.iter_mut().enumerate() {
                sum.add(weight * found[start + j * n + i]);
            }
        }
        sums
    };
    let less_variations = |mut sums: Vec<SumWithSize>| {
        for (sum, expected) in sums.iter_mut().zip(variations) {
            sum.total -= expected.total;
            sum.size += expected.size;
        }
        sums
    };
    let Some(pivots) = pivots else {
        return less_variations(sum(n * (n + 1) / 2));
    };
    let mut balances = balance(mass, &sum(pivots), variations);
    if pivots > 0 {
        balances.extend(less_variations(sum(pivots + n * variation.inputs.len())));
    }
    balances
}

/// M δq̈ + δ(M q̈ − f).
fn balance(
    mass: &SquareMatrix,
    changes: &[SumWithSize],
    variations: &[SumWithSize],
) -> Vec<SumWithSize> {
    let totals: Vec<f64> = changes.iter().map(|change| change.total).collect();
    let mut balances = mass.times(&totals);
    for (balance, variation) in balances.iter_mut().zip(variations) {
        balance.total += variation.total;
        balance.size += variation.size;
    }
    balances
}

/// Values less those that they should be.
fn differences(found: &[f64], expected: &[f64]) -> Vec<SumWithSize> {
    let mut differences = Vec::with_capacity(found.len());
    for (found, expected) in found.iter().zip(expected) {
        let mut difference = SumWithSize::default();
        difference.add(*found);
        difference.add(-expected);
        differences.push(difference);
    }
    differences
}

const UNDEFINED: SumWithSize = SumWithSize {
    total: f64::NAN,
    size: f64::NAN,
};
