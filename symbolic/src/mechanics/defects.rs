//! Defects: why a declaration has no equations of motion.

use crate::mechanics::constraints::ConstraintDefect;
use crate::{Expression, Model, Symbol};

/// Why a declaration has no equations of motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Defect {
    /// The rows of M of these coordinates are zero: no energy is quadratic in their velocities.
    NoInertia(Vec<u32>),
    /// The rows of M of these coordinates vanish identically, though squares of their velocities are written: what turns or
    /// moves with them has no inertia.
    NothingResists(Vec<u32>),
    /// det M vanishes identically; the velocities of these coordinates occur only in combinations.
    SingularMass(Vec<u32>),
    /// The momenta depend on these inputs, so that the inputs' unknown rates would act.
    MomentumOfInput(Vec<u32>),
    /// The constraints have no equations.
    Constraint(ConstraintDefect),
}

/// Checks the velocities in the momenta, and that no input is in them. `rows` is M, or the matrix of the saddle point problem,
/// in which constraints may hold a coordinate without mass.
pub(crate) fn check_momenta(
    model: &Model,
    momenta: &[Expression],
    rows: &[Vec<Expression>],
) -> Result<(), Defect> {
    let graph = &model.graph;
    let massless: Vec<u32> = (0..model.coordinates)
        .zip(rows)
        .filter(|(_, row)| row.iter().all(|entry| graph.is_zero(*entry)))
        .map(|(i, _)| i)
        .collect();
    if !massless.is_empty() {
        return Err(Defect::NoInertia(massless));
    }
    // In few models an input occurs in the momenta, and some have many inputs.
    let occurring = graph.symbols(momenta);
    let inputs: Vec<u32> = (0..model.inputs)
        .filter(|input| occurring.contains(&Symbol::Input(*input)))
        .filter(|input| graph.depends_on(momenta, Symbol::Input(*input)))
        .collect();
    if inputs.is_empty() {
        Ok(())
    } else {
        Err(Defect::MomentumOfInput(inputs))
    }
}
