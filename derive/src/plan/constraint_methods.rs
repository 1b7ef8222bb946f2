//! The programs of a model's constraints.

use lagrangian_symbolic::{ConstraintEquations, Expression, Model, Solution};

use super::method::Method;
use super::outputs::MethodOutputs;

/// The methods for the constraints of a model.
pub(crate) struct ConstraintMethods {
    /// How many of them are holonomic.
    pub(super) holonomic: usize,
    pub(super) are_independent: bool,
    /// g of the holonomic constraints, which are the first ones, and 0 for the others.
    pub(crate) positions: Method,
    /// w = G q̇ + a.
    pub(crate) velocities: Method,
    /// G, column by column.
    pub(crate) jacobian: Method,
    /// γ in G q̈ + γ = 0.
    pub(crate) rates: Method,
    /// The compliances, if some are declared.
    pub(crate) compliances: Option<Method>,
    /// Where the accelerations are solved for symbolically: what is positive where that is without pivoting.
    pub(crate) pivots: Option<Method>,
}

impl ConstraintMethods {
    /// The methods of a model; none without constraints.
    pub(super) fn schedule(
        model: &Model,
        equations: &ConstraintEquations,
        compliances: Option<&[Expression]>,
        solution: Option<&Solution>,
    ) -> Option<Self> {
        if equations.is_empty() {
            return None;
        }
        let mut positions = equations.positions.clone();
        positions.resize(equations.len(), model.graph.zero());
        let columns = (0..model.coordinates as usize).flat_map(|i| equations.column(i));
        let columns: Vec<_> = columns.collect();
        let vector = |values: &[_]| Method::single(model, values, MethodOutputs::Vector);
        Some(Self {
            holonomic: equations.positions.len(),
            are_independent: equations.surplus.is_empty(),
            positions: vector(&positions),
            velocities: vector(&equations.velocities),
            jacobian: Method::single(model, &columns, MethodOutputs::ConstraintJacobian),
            rates: vector(&equations.rates),
            compliances: compliances.map(vector),
            pivots: solution
                .map(|solution| Method::single(model, &solution.pivots, MethodOutputs::Pivots)),
        })
    }
}
