//! Lagrange's formula: M, f, Q and the energy function from the energies, and the Lagrange derivatives
//! 𝓛ᵢ = D ∂/∂q̇ᵢ − ∂/∂qᵢ (Lagrange, Mécanique analytique, 1788), where D is the time derivative at constant velocities.

use crate::algebra::derivative::Tangents;
use crate::matrix::rows::{differences, transposed};
use crate::mechanics::model::Energies;
use crate::{Expression, Graph, Model, Pass, Rational, Symbol};

impl Model {
    /// L, or T − V.
    pub(crate) fn lagrangian(&mut self) -> Expression {
        match self.energies {
            Energies::Natural { kinetic, potential } => self.graph.subtract(kinetic, potential),
            Energies::General(lagrangian) => lagrangian,
        }
    }

    /// Qᵢ: the declared force less ∂D/∂q̇ᵢ.
    pub(crate) fn generalized_forces(&mut self) -> Vec<Expression> {
        let mut forces = Vec::with_capacity(self.forces.len());
        let dissipation = [self.dissipation];
        let mut drags = Tangents::new(&self.graph, &dissipation, &self.velocity_symbols());
        for (i, force) in self.forces.iter().enumerate() {
            let drag = drags.column(&mut self.graph, &dissipation, i)[0];
            forces.push(self.graph.subtract(*force, drag));
        }
        forces
    }

    /// fᵢ = ∂L/∂qᵢ − (∂pᵢ/∂q) q̇ − ∂pᵢ/∂t + Qᵢ.
    pub(crate) fn forcing(
        &mut self,
        lagrangian: Expression,
        momenta: &[Expression],
        generalized_forces: &[Expression],
    ) -> Vec<Expression> {
        let graph = &mut self.graph;
        let direction = graph.constant_velocity_direction(self.coordinates);
        let rates = graph.directional_derivatives(momenta, &direction);
        let coordinates: Vec<_> = (0..self.coordinates).map(Symbol::Coordinate).collect();
        let mut slopes = Tangents::new(graph, &[lagrangian], &coordinates);
        let mut forcing = Vec::with_capacity(rates.len());
        for ((i, rate), force) in rates.into_iter().enumerate().zip(generalized_forces) {
            let slope = slopes.column(graph, &[lagrangian], i)[0];
            forcing.push(graph.sum([
                (slope, Rational::ONE),
                (rate, Rational::MINUS_ONE),
                (*force, Rational::ONE),
            ]));
        }
        forcing
    }

    /// Σ pᵢ q̇ᵢ − L; T + V, which it then equals, for T quadratic in the velocities and V free of them.
    pub(crate) fn energy(&mut self, lagrangian: Expression, momenta: &[Expression]) -> Expression {
        let mut terms = vec![(lagrangian, Rational::MINUS_ONE)];
        for (i, momentum) in (0..).zip(momenta) {
            let velocity = self.graph.symbol(Symbol::Velocity(i));
            let product = self.graph.multiply(*momentum, velocity);
            terms.push((product, Rational::ONE));
        }
        let energy = self.graph.sum(terms);
        if let Energies::Natural { kinetic, potential } = self.energies
            && self.graph.passes.has(Pass::TotalEnergy)
        {
            let total = self.graph.add(kinetic, potential);
            let difference = self.graph.subtract(energy, total);
            if self.graph.vanishes(&[difference]) {
                return total;
            }
        }
        energy
    }
}

/// M = ∂p/∂q̇, row by row.
pub(crate) fn mass_matrix(
    graph: &mut Graph,
    momenta: &[Expression],
    velocities: &[Symbol],
) -> Vec<Vec<Expression>> {
    let mut mass = vec![vec![graph.zero(); momenta.len()]; momenta.len()];
    let mut tangents = Tangents::new(graph, momenta, velocities);
    for j in 0..momenta.len() {
        // M is symmetric: below the diagonal suffices.
        let column = tangents.part_of_column(graph, &momenta[j..], j);
        for (i, entry) in (j..).zip(column) {
            mass[i][j] = entry;
            mass[j][i] = entry;
        }
    }
    mass
}

/// M q̈ − f with the accelerations as symbols.
pub(crate) fn inverse_dynamics(
    graph: &mut Graph,
    mass: &[Vec<Expression>],
    forcing: &[Expression],
) -> Vec<Expression> {
    let mut residuals = Vec::with_capacity(forcing.len());
    for (row, force) in mass.iter().zip(forcing) {
        let mut terms = vec![(*force, Rational::MINUS_ONE)];
        for (j, entry) in (0..).zip(row) {
            let acceleration = graph.symbol(Symbol::Acceleration(j));
            terms.push((graph.multiply(*entry, acceleration), Rational::ONE));
        }
        residuals.push(graph.sum(terms));
    }
    residuals
}

impl Graph {
    /// 𝓛ᵢ(x) = D ∂x/∂q̇ᵢ − ∂x/∂qᵢ for each of `roots`, in row and column (root, i).
    pub(crate) fn lagrange_derivatives(
        &mut self,
        roots: &[Expression],
        coordinates: u32,
    ) -> Vec<Vec<Expression>> {
        let symbols = |symbol: fn(u32) -> Symbol| (0..coordinates).map(symbol).collect::<Vec<_>>();
        let momenta = self.jacobian(roots, &symbols(Symbol::Velocity));
        let direction = self.constant_velocity_direction(coordinates);
        let rates = self.directional_derivatives(&momenta.concat(), &direction);
        let slopes = self.jacobian(roots, &symbols(Symbol::Coordinate));
        let mut columns = Vec::with_capacity(slopes.len());
        for (rates, slopes) in rates.chunks(roots.len().max(1)).zip(&slopes) {
            columns.push(differences(self, rates, slopes));
        }
        transposed(&columns)
    }
}
