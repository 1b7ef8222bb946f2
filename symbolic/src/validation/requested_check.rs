//! What is derived for clauses that ask for it, compared with Lagrange's equations.

use super::reference::Reference;
use crate::Symbol;
use crate::validation::comparison::Comparisons;
use crate::validation::method::Method;
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::sum_with_size::{SumWithSize, add_each};

impl Reference<'_> {
    /// The rates of the momenta and of the energy.
    pub(super) fn compare_rates(&self, comparisons: &mut Comparisons) {
        let values = &self.values;
        if let Some(tape) = &self.tapes.momentum_rates {
            comparisons.balances(
                Method::MomentumRates,
                &self.at(tape),
                &values.momentum_rates,
            );
        }
        if let Some(tape) = &self.tapes.energy_rate {
            comparisons.balances(Method::EnergyRate, &self.at(tape), &[values.energy_rate]);
        }
    }

    /// M (v − q̇) = p − p(q, q̇, t) for the velocities v that have the momenta p which are given.
    pub(super) fn compare_velocities(&self, mass: &SquareMatrix, comparisons: &mut Comparisons) {
        let Some(tape) = &self.tapes.velocities else {
            return;
        };
        let n = self.accelerations.len();
        let values = |symbol: fn(u32) -> Symbol| {
            let symbols = (0..).map(symbol).take(n);
            symbols.map(|symbol| self.point.value(symbol))
        };
        // Pivots stand before them.
        let found = self.at(tape);
        let found = found.get(found.len() - n..).unwrap_or_default();
        let differences = found.iter().zip(values(Symbol::Velocity));
        let differences = differences.map(|(v, before)| v - before);
        let mut balances = mass.times(&differences.collect::<Vec<_>>());
        let momenta = self.values.momenta.iter();
        let momenta = momenta.zip(values(Symbol::RightHandSide));
        for (balance, (momentum, given)) in balances.iter_mut().zip(momenta) {
            balance.add(*momentum);
            balance.add(-given);
        }
        comparisons.vanishing(Method::Velocities, &balances);
    }

    /// Y π + r, with M q̈ − f at the same accelerations, behind which the residuals of constraints stand.
    pub(super) fn compare_regressor(
        &self,
        (accelerations, residuals): (&[f64], &[SumWithSize]),
        comparisons: &mut Comparisons,
    ) {
        let Some(regressor) = &self.tapes.regressor else {
            return;
        };
        let [columns, known, base] =
            core::array::from_fn(|i| self.evaluate(accelerations, &regressor[i]));
        let count = known.len().min(residuals.len());
        let mut sums = vec![SumWithSize::default(); count];
        for (sum, term) in sums.iter_mut().zip(known) {
            sum.add(term);
        }
        for (column, parameter) in columns.chunks(count.max(1)).zip(base) {
            for (sum, entry) in sums.iter_mut().zip(column) {
                sum.add(entry * parameter);
            }
        }
        add_each(&mut sums, -1.0, residuals);
        comparisons.vanishing(Method::Regressor, &sums);
    }
}
