//! The equations of motion as M q̈ − f = 0, and the solution of M x = r.

use crate::Expression;

/// The equations M q̈ − f = 0, whose `residuals` contain q̈ as [symbols](crate::Symbol::Acceleration). They take fewer
/// products than q̈ solved for, since the factors of M are not in them.
#[derive(Clone, Debug)]
pub struct ImplicitEquations {
    /// M q̈ − f, up to a common factor.
    pub residuals: Vec<Expression>,
    /// x in M x = r, M with the same common factor, in terms of r as [symbols](crate::Symbol::RightHandSide); empty where M
    /// is factored numerically.
    pub solution: Vec<Expression>,
}
