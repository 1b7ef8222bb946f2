//! The directional derivative of accelerations and multipliers along a variation, by the programs for their derivatives.

use super::reference::Reference;
use super::tapes::SolutionTape;
use crate::validation::comparison::Comparisons;
use crate::validation::lagrange::Variation;
use crate::validation::method::Method;
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::sum_with_size::{SumWithSize, add_each, exact};

/// What a program for derivatives computes at a point.
struct Derivatives<'a> {
    program: &'a SolutionTape,
    values: Vec<f64>,
    /// How much what is differentiated by varies, column by column.
    weights: &'a [f64],
    /// Whether q̈, or f, stands before the columns.
    has_solution: bool,
}

impl Derivatives<'_> {
    /// Adds Σ column·weight of the columns that begin at `start`, and returns where they end.
    fn add_columns(&self, sums: &mut [SumWithSize], start: usize) -> usize {
        let columns = self.values[start..].chunks(sums.len().max(1));
        for (column, weight) in columns.zip(self.weights) {
            for (sum, entry) in sums.iter_mut().zip(column) {
                sum.add(weight * entry);
            }
        }
        start + self.weights.len() * sums.len()
    }
}

impl Reference<'_> {
    /// The derivatives by the state and the inputs. Where there are those by the inputs alone, nothing else varies.
    pub(super) fn compare_derivatives(&self, mass: &SquareMatrix, comparisons: &mut Comparisons) {
        let Some(by_inputs) = &self.tapes.input_jacobian else {
            return;
        };
        let mut parts = vec![self.derivatives(by_inputs, &self.variation.inputs, false)];
        let variations = if let Some(by_state) = &self.tapes.state_jacobian {
            parts.insert(0, self.derivatives(by_state, &self.variation.state, true));
            Some(self.values.variations.clone())
        } else {
            self.variations_along(&self.variation.of_inputs())
        };
        if let Some(variations) = variations {
            let balances = self.balances(mass, &parts, &variations);
            comparisons.vanishing(Method::Linearization, &balances);
        }
    }

    /// The derivatives by parameters.
    pub(super) fn compare_sensitivities(&self, mass: &SquareMatrix, comparisons: &mut Comparisons) {
        let Some((program, parameters)) = &self.tapes.sensitivities else {
            return;
        };
        let weights = (0..parameters.len()).map(|i| self.point.weight(3, i));
        let weights: Vec<f64> = weights.collect();
        let pairs = parameters.iter().copied().zip(weights.iter().copied());
        let (n, inputs) = (self.lagrange.coordinates, self.lagrange.inputs);
        let variation = Variation::of_parameters(n, inputs, pairs.collect());
        if let Some(variations) = self.variations_along(&variation) {
            let part = self.derivatives(program, &weights, true);
            let balances = self.balances(mass, &[part], &variations);
            comparisons.vanishing(Method::Sensitivities, &balances);
        }
    }

    fn derivatives<'a>(
        &self,
        program: &'a SolutionTape,
        weights: &'a [f64],
        has_solution: bool,
    ) -> Derivatives<'a> {
        Derivatives {
            program,
            values: self.at(&program.tape),
            weights,
            has_solution,
        }
    }

    /// δ(M q̈ − f) along another variation, at fixed q̈.
    fn variations_along(&self, variation: &Variation) -> Option<Vec<SumWithSize>> {
        let (point, perturbation) = (self.point, self.perturbation);
        let values = self
            .lagrange
            .values(point, variation, self.accelerations, perturbation)?;
        Some(values.variations)
    }

    /// M δq̈ + δ(M q̈ − f) at fixed q̈, which vanishes, and the differences of what else is computed to what the
    /// equations say: of q̈, or M q̈ − f, and of δ(M q̈ − f).
    fn balances(
        &self,
        mass: &SquareMatrix,
        parts: &[Derivatives<'_>],
        variations: &[SumWithSize],
    ) -> Vec<SumWithSize> {
        let Some(first) = parts.first() else {
            return Vec::new();
        };
        let (n, pivots) = (variations.len(), first.program.pivots);
        let solution = pivots.unwrap_or(n * (n + 1) / 2);
        let zeros = vec![SumWithSize::default(); n];
        let (mut columns, mut residuals) = (zeros.clone(), zeros);
        for part in parts {
            let start = solution + if part.has_solution { n } else { 0 };
            let end = part.add_columns(&mut columns, start);
            if part.program.is_along_variation {
                let along = part.values[end..].iter().copied().map(exact);
                add_each(&mut residuals, 1.0, &along.collect::<Vec<_>>());
            } else if pivots.is_some_and(|pivots| pivots > 0) {
                part.add_columns(&mut residuals, end);
            }
        }
        let (before, found) = first.values.split_at(solution);
        let found = found.get(..n).filter(|_| first.has_solution);
        match (pivots, found) {
            (Some(pivots), found) => {
                let mut balances = balance(mass, &columns, variations);
                balances.extend(differences(found.unwrap_or_default(), self.accelerations));
                if pivots > 0 {
                    add_each(&mut residuals, -1.0, variations);
                    balances.extend(residuals);
                }
                balances
            }
            (None, None) => {
                add_each(&mut columns, -1.0, variations);
                columns
            }
            (None, Some(forcing)) => {
                let matrix = SquareMatrix::symmetric(before, n);
                let mut balances = matrix.times(self.accelerations);
                let forces: Vec<_> = forcing.iter().copied().map(exact).collect();
                add_each(&mut balances, -1.0, &forces);
                // All programs compute M.
                let others = parts.iter().skip(1);
                balances
                    .extend(others.flat_map(|part| differences(&part.values[..solution], before)));
                let right: Vec<f64> = columns.iter().map(|sum| -sum.total).collect();
                let Some(changes) = matrix.solve(&right) else {
                    return vec![exact(f64::NAN)];
                };
                let changes: Vec<_> = changes.into_iter().map(exact).collect();
                balances.extend(balance(mass, &changes, variations));
                balances
            }
        }
    }
}

/// M δq̈ + δ(M q̈ − f).
fn balance(
    mass: &SquareMatrix,
    changes: &[SumWithSize],
    variations: &[SumWithSize],
) -> Vec<SumWithSize> {
    let totals: Vec<f64> = changes.iter().map(|change| change.total).collect();
    let mut balances = mass.times(&totals);
    add_each(&mut balances, 1.0, variations);
    balances
}

/// The differences between values and the expected ones.
fn differences(found: &[f64], expected: &[f64]) -> Vec<SumWithSize> {
    let exactly = |values: &[f64]| values.iter().copied().map(exact).collect::<Vec<_>>();
    let mut differences = exactly(found);
    add_each(&mut differences, -1.0, &exactly(expected));
    differences
}
