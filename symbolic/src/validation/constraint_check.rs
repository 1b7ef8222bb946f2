//! The constraints of a model, compared with its extension by multipliers.

use super::reference::Reference;
use super::tapes::ConstraintTapes;
use crate::Symbol;
use crate::validation::comparison::Comparisons;
use crate::validation::method::Method;

impl Reference<'_> {
    /// Adds the power −λᵀ a = λᵀ (G q̇ − w) of the constraints to the rate of the energy.
    pub(super) fn add_power(&mut self, jacobian: &[f64], velocities: &[f64]) {
        let multipliers = self.lagrange.multipliers;
        let free = self.accelerations.len() - multipliers;
        for (velocity, multiplier) in velocities.iter().zip(&self.accelerations[free..]) {
            self.values.energy_rate.add(-multiplier * velocity);
        }
        for (i, column) in (0..).zip(jacobian.chunks(multipliers)) {
            let velocity = self.point.value(Symbol::Velocity(i));
            for (entry, multiplier) in column.iter().zip(&self.accelerations[free..]) {
                self.values.energy_rate.add(entry * multiplier * velocity);
            }
        }
    }

    /// w, which is the opposite of the last momenta, and ġ of the holonomic constraints, which is w.
    pub(super) fn compare_constraints(
        &self,
        tapes: &ConstraintTapes,
        comparisons: &mut Comparisons,
    ) {
        let free = self.accelerations.len() - self.lagrange.multipliers;
        let velocities = self.at(&tapes.velocities);
        let opposite: Vec<f64> = velocities.iter().map(|w| -w).collect();
        let momenta = &self.values.momenta[free..];
        comparisons.values(Method::Constraints, &opposite, momenta);
        let symbol = |symbol| {
            let (variation, accelerations) = (self.variation, self.accelerations);
            self.lagrange
                .moving(self.point, symbol, variation, accelerations)
        };
        let positions = tapes.positions.evaluate(&symbol, self.perturbation);
        let rates = positions.iter().take(tapes.holonomic);
        let rates: Vec<f64> = rates.map(|position| position.first).collect();
        comparisons.values(Method::Constraints, &rates, &velocities);
    }
}
