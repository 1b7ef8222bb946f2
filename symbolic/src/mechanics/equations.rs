//! Lagrange's equations, d/dt (∂L/∂q̇ᵢ) − ∂L/∂qᵢ = Qᵢ (4.6), in the form M q̈ = f.
//!
//! With p = ∂L/∂q̇ the total derivative dp/dt is M q̈ plus the derivative of p along (q̇, 1) in (q, t),
//! so that f = ∂L/∂q − (∂p/∂q) q̇ − ∂p/∂t + Q. The term in ∂p/∂t is what time-dependent models need.
//! M is differentiated, never inverted: from M q̈ = f follows M ∂q̈/∂x = −∂(M q̈ − f)/∂x at fixed q̈.

use crate::mechanics::conservation::Conservation;
use crate::mechanics::constraints::ConstraintEquations;
use crate::mechanics::coordinate_properties::{self, CoordinateProperties};
use crate::mechanics::defects::{Defect, check_momenta};
use crate::mechanics::expanded_energy::LagrangeTerms;
use crate::mechanics::ignorability::Ignorability;
use crate::mechanics::lagrange::{inverse_dynamics, mass_matrix};
use crate::mechanics::saddle_point::saddle_point_matrix;
use crate::{Expression, Model, Symbol};

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
    /// The equations of the constraints.
    pub constraints: ConstraintEquations,
    /// M q̈ − f with the accelerations as symbols.
    pub inverse_dynamics: Vec<Expression>,
    /// Which coordinates are angles, ignorable or singular.
    pub coordinate_properties: CoordinateProperties,
    /// Which momenta are constant, and whether the energy function is.
    pub conservation: Conservation,
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
        let constraints = ConstraintEquations::derive(model).map_err(Defect::Constraint)?;
        let matrix = saddle_point_matrix(&mut model.graph, &mass, &constraints.regular_rows());
        check_momenta(model, &momenta, &matrix)?;
        let generalized_forces = model.generalized_forces();
        let forcing = model.forcing(lagrangian, &momenta, &generalized_forces);
        let energy = model.energy(lagrangian, &momenta);
        let ignorability = Ignorability::of(model, lagrangian, &generalized_forces, &constraints);
        let Ignorability {
            is_ignorable,
            has_constant_momentum,
        } = ignorability;
        let mut roots = vec![lagrangian];
        roots.extend(&generalized_forces);
        roots.extend(constraints.positions.iter().chain(&constraints.velocities));
        let coordinate_properties =
            coordinate_properties::analyze(model, &roots, &matrix, is_ignorable)?;
        let forces = (&*generalized_forces, &constraints);
        let conservation = Conservation::of(model, lagrangian, forces, has_constant_momentum);
        let terms = LagrangeTerms {
            momenta,
            mass,
            forcing,
        };
        let LagrangeTerms {
            momenta,
            mass,
            mut forcing,
        } = terms.cheapest(
            model,
            lagrangian,
            &generalized_forces,
            &coordinate_properties,
        );
        for force in &mut forcing {
            *force = model.graph.over_common_denominators(*force);
        }
        let inverse_dynamics = inverse_dynamics(&mut model.graph, &mass, &forcing);
        Ok(Self {
            lagrangian,
            energy,
            momenta,
            mass,
            forcing,
            generalized_forces,
            constraints,
            inverse_dynamics,
            coordinate_properties,
            conservation,
        })
    }
}
