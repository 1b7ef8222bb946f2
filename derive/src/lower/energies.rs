//! Energies and Rayleigh's dissipation function: the sums of their clauses.

use lagrangian_symbolic::{Energies, Expression, Rational, Symbol, TypedOperation, Value};

use crate::lower::expression::Lowerer;
use crate::syntax::clauses::Clause;

impl Lowerer<'_> {
    /// The sum of all clauses with one keyword.
    pub(super) fn total(&mut self, clauses: &[Clause]) -> Option<Value> {
        let values: Vec<_> = clauses
            .iter()
            .map(|clause| self.scalar(&clause.expression))
            .collect();
        let zero = self.constant(0)?;
        values.into_iter().try_fold(zero, |total, value| {
            let terms = [total, value?].map(|term| (term, Rational::ONE));
            self.add(TypedOperation::Sum(terms.to_vec()))
        })
    }

    /// T and V.
    pub(super) fn natural(
        &mut self,
        clauses: &[Clause],
        kinetic: Value,
        potential: Value,
    ) -> Energies {
        let [kinetic, potential] = [kinetic, potential].map(|x| self.typed.expression(x));
        self.check_velocities(clauses, kinetic);
        Energies::Natural { kinetic, potential }
    }

    /// L.
    pub(super) fn general(&mut self, clauses: &[Clause], lagrangian: Value) -> Energies {
        let lagrangian = self.typed.expression(lagrangian);
        self.check_velocities(clauses, lagrangian);
        Energies::General(lagrangian)
    }

    /// A kinetic energy or a Lagrangian without velocities has no equations of motion.
    fn check_velocities(&mut self, clauses: &[Clause], energy: Expression) {
        if self.coordinates == 0 {
            return;
        }
        let moving = self.graph().contents(energy).has_velocity();
        if let (false, Some(clause)) = (moving, clauses.first()) {
            self.diagnostics.error(
                &clause.expression,
                "this contains no velocity, so nothing moves: write velocities as `dot(q)`, \
                 as in `0.5 * m * dot(x).powi(2)`",
            );
        }
    }

    /// Rayleigh's dissipation function, whose forces −∂D/∂q̇ are to depend on the velocities.
    pub(super) fn dissipation(&mut self, clauses: &[Clause]) -> Option<Expression> {
        let mut total = Some(self.graph().zero());
        for clause in clauses {
            let value = self.scalar(&clause.expression);
            let value = value.map(|value| self.typed.expression(value));
            let value = value.filter(|value| self.check_dissipation(clause, *value).is_some());
            let graph = &mut self.typed.geometry.graph;
            total = total
                .zip(value)
                .map(|(total, value)| graph.add(total, value));
        }
        total
    }

    fn check_dissipation(&mut self, clause: &Clause, value: Expression) -> Option<()> {
        if self.graph().is_zero(value) {
            return Some(());
        }
        if !self.graph().contents(value).has_velocity() {
            return self.reject(
                &clause.expression,
                "this contains no velocity, so that it has no effect: write velocities as `dot(q)`, as in \
                 `0.5 * c * dot(x).powi(2)`",
            );
        }
        // On a copy: what is built for a check stays out of the equations.
        let mut graph = self.graph().clone();
        let velocities: Vec<_> = (0..self.coordinates).map(Symbol::Velocity).collect();
        let slopes = graph.jacobian(&[value], &velocities).concat();
        if slopes
            .iter()
            .any(|slope| graph.contents(*slope).has_velocity())
        {
            return Some(());
        }
        self.reject(
            &clause.expression,
            "this is linear in the velocities, so that its force −∂D/∂q̇ does not oppose the motion: write \
             `0.5 * c * dot(x).powi(2)` for viscous friction, `c * dot(x).abs()` for dry friction, and a force that \
             does not depend on velocities under `force`",
        )
    }
}
