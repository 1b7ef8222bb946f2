//! Lagrange's equations, d/dt (∂L/∂q̇ᵢ) − ∂L/∂qᵢ = Qᵢ (4.6), in the form M q̈ = f.
//!
//! With p = ∂L/∂q̇ the total derivative dp/dt is M q̈ plus the derivative of p along (q̇, 1) in (q, t),
//! so that f = ∂L/∂q − (∂p/∂q) q̇ − ∂p/∂t + Q. The term in ∂p/∂t is what time-dependent models need.
//! M is differentiated, never inverted: from M q̈ = f follows M ∂q̈/∂x = −∂(M q̈ − f)/∂x at fixed q̈.

use crate::algebra::derivative::Tangents;
use crate::mechanics::coordinate_properties::{self, CoordinateProperties};
use crate::mechanics::model::Energies;
use crate::mechanics::multiplied_out::Derived;
use crate::{Expression, Graph, Model, Pass, Rational, Symbol};

/// The equations of motion of a model, as expressions of its graph.
#[derive(Clone, Debug)]
pub struct Equations {
    /// The Lagrangian function L.
    pub lagrangian: Expression,
    /// The energy function h = Σ pᵢ q̇ᵢ − L.
    pub energy: Expression,
    /// The momenta p = ∂L/∂q̇.
    pub momenta: Vec<Expression>,
    /// The mass matrix M = ∂²L/∂q̇², row by row; symmetric.
    pub mass: Vec<Vec<Expression>>,
    /// The forcing f in M q̈ = f.
    pub forcing: Vec<Expression>,
    /// The generalized forces Q.
    pub generalized_forces: Vec<Expression>,
    /// M q̈ − f with the accelerations as symbols.
    pub inverse_dynamics: Vec<Expression>,
    /// Which coordinates are angles, ignorable or singular.
    pub coordinate_properties: CoordinateProperties,
}

/// Why a declaration has no equations of motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Defect {
    /// The Lagrangian does not contain the velocities of these coordinates.
    NoVelocity(Vec<u32>),
    /// det M vanishes identically; the velocities of these coordinates occur only in combinations.
    SingularMass(Vec<u32>),
    /// The momenta depend on these inputs, so that the inputs' unknown rates would act.
    MomentumOfInput(Vec<u32>),
}

impl Equations {
    /// Derives the equations of motion of `model`.
    ///
    /// # Errors
    ///
    /// The [`Defect`] for which there are none.
    pub fn derive(model: &mut Model) -> Result<Self, Defect> {
        let lagrangian = model.lagrangian();
        let graph = &mut model.graph;
        let velocities: Vec<_> = (0..model.coordinates).map(Symbol::Velocity).collect();
        let momenta = graph.jacobian(&[lagrangian], &velocities).concat();
        let mass = mass_matrix(graph, &momenta, &velocities);
        check_momenta(model, &momenta, &mass)?;
        let generalized_forces = model.generalized_forces();
        let forcing = model.forcing(lagrangian, &momenta, &generalized_forces);
        let energy = model.energy(lagrangian, &momenta);
        let coordinate_properties =
            coordinate_properties::analyze(model, lagrangian, &mass, &generalized_forces)?;
        let derived = Derived {
            momenta,
            mass,
            forcing,
        };
        let Derived {
            momenta,
            mass,
            forcing,
        } = derived.cheapest(model, lagrangian, &generalized_forces);
        let inverse_dynamics = inverse_dynamics(&mut model.graph, &mass, &forcing);
        Ok(Self {
            lagrangian,
            energy,
            momenta,
            mass,
            forcing,
            generalized_forces,
            inverse_dynamics,
            coordinate_properties,
        })
    }
}

impl Model {
    fn lagrangian(&mut self) -> Expression {
        match self.energies {
            Energies::Natural { kinetic, potential } => self.graph.subtract(kinetic, potential),
            Energies::General(lagrangian) => lagrangian,
        }
    }

    /// Qᵢ: the declared force less ∂D/∂q̇ᵢ.
    fn generalized_forces(&mut self) -> Vec<Expression> {
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
    fn energy(&mut self, lagrangian: Expression, momenta: &[Expression]) -> Expression {
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
            if coordinate_properties::vanishes(&self.graph, difference) {
                return total;
            }
        }
        energy
    }
}

fn mass_matrix(
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

fn inverse_dynamics(
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

fn check_momenta(
    model: &Model,
    momenta: &[Expression],
    mass: &[Vec<Expression>],
) -> Result<(), Defect> {
    let graph = &model.graph;
    let still: Vec<u32> = (0..model.coordinates)
        .zip(mass)
        .filter(|(_, row)| row.iter().all(|entry| graph.is_zero(*entry)))
        .map(|(i, _)| i)
        .collect();
    if !still.is_empty() {
        return Err(Defect::NoVelocity(still));
    }
    // In few models an input occurs in the momenta, and some have many inputs.
    let occurring = graph.symbols(momenta);
    let inputs: Vec<u32> = (0..model.inputs)
        .filter(|input| occurring.contains(&Symbol::Input(*input)))
        .filter(|input| coordinate_properties::depends(graph, momenta, Symbol::Input(*input)))
        .collect();
    if inputs.is_empty() {
        Ok(())
    } else {
        Err(Defect::MomentumOfInput(inputs))
    }
}
