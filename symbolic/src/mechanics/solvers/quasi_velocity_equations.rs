//! The equations of motion as a system of first order in coordinates and quasi-velocities.

use std::collections::BTreeMap;

use crate::{Expression, Graph, Rational, Symbol};

/// The equations q̇ = E⁻¹ (w − b) and ẇ = g(q, w, t) in coordinates and as many quasi-velocities w = E q̇ + b, which
/// `velocities` and `rates` contain as [symbols](crate::Symbol::QuasiVelocity). For a rigid body they are the kinematics
/// of its angles and Euler's equations (3.5)–(3.7); q̈, the derivative of both, is longer.
#[derive(Clone, Debug)]
pub struct QuasiVelocityEquations {
    /// w, in terms of q̇.
    pub quasi_velocities: Vec<Expression>,
    /// q̇, in terms of w.
    pub velocities: Vec<Expression>,
    /// W, constant in the state and in time, row by row.
    pub inertia: Vec<Vec<Expression>>,
    /// W ẇ, in terms of w.
    pub torques: Vec<Expression>,
    /// ẇ, in terms of w.
    pub rates: Vec<Expression>,
}

impl QuasiVelocityEquations {
    /// The same equations with those of the quasi-velocities first that are among `preferred`, in this order and with
    /// the signs that they have there.
    #[must_use]
    pub(crate) fn in_terms_of(&self, graph: &mut Graph, preferred: &[Expression]) -> Self {
        let mut order = Vec::new();
        for (k, form) in self.quasi_velocities.iter().enumerate() {
            let opposite = graph.negate(*form);
            let place = |x| preferred.iter().position(|y| *y == x);
            let (place, sign) = match (place(*form), place(opposite)) {
                (None, Some(place)) => (place, Rational::MINUS_ONE),
                (place, _) => (place.unwrap_or(preferred.len()), Rational::ONE),
            };
            order.push((place, k, sign));
        }
        order.sort_by_key(|(place, k, _)| (*place, *k));
        let mut values = BTreeMap::new();
        for (new, (_, k, sign)) in (0..).zip(&order) {
            let symbol = graph.symbol(Symbol::QuasiVelocity(new));
            let old = u32::try_from(*k).unwrap_or(u32::MAX);
            values.insert(Symbol::QuasiVelocity(old), graph.scale(symbol, sign));
        }
        let permuted = |graph: &mut Graph, list: &[Expression]| -> Vec<_> {
            let scaled = order.iter().map(|(_, k, sign)| graph.scale(list[*k], sign));
            scaled.collect()
        };
        let rows: Vec<_> = self
            .inertia
            .iter()
            .map(|row| permuted(graph, row))
            .collect();
        let inertia = order.iter().map(|(_, k, sign)| {
            let row = rows[*k].iter();
            row.map(|entry| graph.scale(*entry, sign)).collect()
        });
        let inertia = inertia.collect();
        let [torques, rates] = [&self.torques, &self.rates].map(|list| {
            let list = graph.substitute(list, &values);
            permuted(graph, &list)
        });
        Self {
            quasi_velocities: permuted(graph, &self.quasi_velocities),
            velocities: graph.substitute(&self.velocities, &values),
            inertia,
            torques,
            rates,
        }
    }
}
