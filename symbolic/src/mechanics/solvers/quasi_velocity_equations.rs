//! The equations of motion as a system of first order in coordinates and quasi-velocities.

use crate::Expression;

/// The equations q̇ = E⁻¹ (w − b) and ẇ = g(q, w, t) in coordinates and as many quasi-velocities w = E q̇ + b, which
/// `velocities` and `rates` contain as [symbols](crate::Symbol::QuasiVelocity). For a rigid body they are the kinematics
/// of its angles and Euler's equations (3.5)–(3.7); q̈, the derivative of both, is longer.
#[derive(Clone, Debug)]
pub struct QuasiVelocityEquations {
    /// w, in terms of q̇.
    pub quasi_velocities: Vec<Expression>,
    /// q̇, in terms of w.
    pub velocities: Vec<Expression>,
    /// ẇ, in terms of w.
    pub rates: Vec<Expression>,
}
