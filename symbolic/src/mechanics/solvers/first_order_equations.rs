//! The equations of motion as a system of first order in coordinates and further variables.

use super::quasi_velocity_equations::QuasiVelocityEquations;
use crate::Expression;

/// The equations q̇ = u(q, z) and ż = g(q, z, t) in coordinates and variables z, which `velocities` and `rates` contain as
/// [symbols](crate::Symbol::QuasiVelocity), since quasi-velocities are such variables. A rate that is 0 is that of a constant.
#[derive(Clone, Debug)]
pub struct FirstOrderEquations {
    /// z, in terms of q and q̇.
    pub values: Vec<Expression>,
    /// q̇, in terms of z.
    pub velocities: Vec<Expression>,
    /// ż, in terms of z.
    pub rates: Vec<Expression>,
}

impl From<QuasiVelocityEquations> for FirstOrderEquations {
    fn from(equations: QuasiVelocityEquations) -> Self {
        Self {
            values: equations.quasi_velocities,
            velocities: equations.velocities,
            rates: equations.rates,
        }
    }
}
