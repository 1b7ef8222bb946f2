//! The equations of motion of a constrained system as one symmetric system with the accelerations and the multipliers as
//! unknowns (Benzi, Golub and Liesen, Numerical solution of saddle point problems, 2005),
//!
//! ⎡ M  −Gᵀ⎤ ⎡q̈⎤   ⎡f⎤
//! ⎣−G   0 ⎦ ⎣λ⎦ = ⎣γ⎦
//!
//! They are Lagrange's equations at ṡ = 0 of a system with C coordinates s more, and the Lagrangian function L − ṡᵀ w: its
//! momenta are p − Gᵀ ṡ and −w, so that s̈ is λ. Multipliers therefore follow the accelerations of the coordinates, as further
//! accelerations.

use crate::matrix::rows::{differences, sums};
use crate::mechanics::constraint::Constraint;
use crate::mechanics::constraints::ConstraintEquations;
use crate::mechanics::model::Energies;
use crate::{Equations, Expression, Graph, LinearSystem, Model, Rational, Symbol};

/// The matrix of the saddle point problem with these M and G, row by row; M itself without constraints.
pub(crate) fn saddle_point_matrix(
    graph: &mut Graph,
    mass: &[Vec<Expression>],
    jacobian: &[Vec<Expression>],
) -> Vec<Vec<Expression>> {
    let jacobian: Vec<Vec<_>> = jacobian
        .iter()
        .map(|row| row.iter().map(|entry| graph.negate(*entry)).collect())
        .collect();
    let mut matrix = mass.to_vec();
    for (i, row) in matrix.iter_mut().enumerate() {
        row.extend(jacobian.iter().map(|constraint| constraint[i]));
    }
    let size = mass.len() + jacobian.len();
    matrix.extend(jacobian);
    for row in &mut matrix {
        row.resize(size, graph.zero());
    }
    matrix
}

impl ConstraintEquations {
    /// The residuals M q̈ − f − Gᵀ λ and −G q̈ − γ, from M q̈ − f.
    pub(crate) fn residuals(
        &self,
        graph: &mut Graph,
        inverse_dynamics: &[Expression],
    ) -> Vec<Expression> {
        let reactions = self.reactions(graph, inverse_dynamics.len());
        let mut residuals = differences(graph, inverse_dynamics, &reactions);
        for (row, rate) in self.jacobian.iter().zip(&self.rates) {
            let mut terms = vec![(*rate, Rational::MINUS_ONE)];
            for (i, entry) in (0..).zip(row) {
                let acceleration = graph.symbol(Symbol::Acceleration(i));
                terms.push((graph.multiply(*entry, acceleration), Rational::MINUS_ONE));
            }
            residuals.push(graph.sum(terms));
        }
        residuals
    }

    /// The reactions Gᵀ λ on the coordinates.
    pub(crate) fn reactions(&self, graph: &mut Graph, coordinates: usize) -> Vec<Expression> {
        let mut reactions = Vec::with_capacity(coordinates);
        for i in 0..coordinates {
            let mut terms = Vec::with_capacity(self.len());
            for (row, multiplier) in self.jacobian.iter().zip(self.multipliers()) {
                let multiplier = graph.symbol(multiplier);
                terms.push((graph.multiply(row[i], multiplier), Rational::ONE));
            }
            reactions.push(graph.sum(terms));
        }
        reactions
    }

    /// The symbols of the multipliers.
    pub fn multipliers(&self) -> impl Iterator<Item = Symbol> {
        let coordinates = self.jacobian.first().map_or(0, Vec::len);
        let symbols = (0..).map(Symbol::Acceleration);
        symbols.skip(coordinates).take(self.len())
    }
}

impl Equations {
    /// The equations with the reactions among the forces.
    pub(crate) fn with_reactions(&self, graph: &mut Graph) -> Self {
        let reactions = self.constraints.reactions(graph, self.mass.len());
        Self {
            generalized_forces: sums(graph, &self.generalized_forces, &reactions),
            forcing: sums(graph, &self.forcing, &reactions),
            inverse_dynamics: differences(graph, &self.inverse_dynamics, &reactions),
            ..self.clone()
        }
    }
}

impl LinearSystem {
    /// The system with the multipliers among its unknowns.
    pub(crate) fn with_constraints(
        self,
        graph: &mut Graph,
        constraints: &ConstraintEquations,
    ) -> Self {
        if constraints.is_empty() {
            return self;
        }
        let mut forcing = self.forcing;
        forcing.extend(&constraints.rates);
        Self {
            mass: saddle_point_matrix(graph, &self.mass, &constraints.jacobian),
            forcing,
            inverse_dynamics: constraints.residuals(graph, &self.inverse_dynamics),
            recursion: self.recursion,
        }
    }
}

impl Model {
    /// The system with a coordinate s more for each constraint and the Lagrangian function L − ṡᵀ w, without constraints.
    pub(crate) fn with_multiplier_coordinates(&self) -> Self {
        let mut extended = self.clone();
        let constraints = extended.holonomic_first();
        extended.constraints = Vec::new();
        let graph = &mut extended.graph;
        let direction = graph.constant_velocity_direction(self.coordinates);
        let mut terms = Vec::with_capacity(constraints.len());
        for (coordinate, i) in (self.coordinates..).zip(constraints) {
            let velocity = match &self.constraints[i] {
                Constraint::Holonomic(g) => graph.directional_derivatives(&[*g], &direction)[0],
                Constraint::Nonholonomic(velocity) => *velocity,
            };
            let rate = graph.symbol(Symbol::Velocity(coordinate));
            terms.push((graph.multiply(rate, velocity), Rational::ONE));
            extended.forces.push(graph.zero());
            extended.coordinates += 1;
        }
        let product = graph.sum(terms);
        extended.energies = match self.energies {
            Energies::Natural { kinetic, potential } => Energies::Natural {
                kinetic,
                potential: graph.add(potential, product),
            },
            Energies::General(lagrangian) => Energies::General(graph.subtract(lagrangian, product)),
        };
        extended
    }
}
