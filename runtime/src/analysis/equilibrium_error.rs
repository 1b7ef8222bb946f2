//! The errors of a search for equilibria.

use super::equilibrium::{Equilibrium, Variable};
use super::tangent_error::TangentError;
use crate::error_messages::error_messages;
use crate::number_format::Readable;
use crate::scalar::Scalar;

/// The reason why no equilibrium or steady motion was found.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum EquilibriumError<S: Scalar, const N: usize, const U: usize> {
    /// No coordinate or input has the index.
    NoSuchVariable {
        /// The variable that was declared unknown, or whose momentum was given.
        variable: Variable,
    },
    /// Nothing is unknown: all coordinates are ignorable, or the list is empty.
    NoUnknown,
    /// A coordinate that is not ignorable has a velocity in the guess, or its velocity is unknown, in a model without constraints.
    Moving {
        /// Its name.
        name: &'static str,
        /// Its velocity in the guess.
        velocity: f64,
    },
    /// A momentum was given for a coordinate that is not ignorable, so that its momentum is not constant, or for a constrained model.
    NoConstantMomentum {
        /// Its name.
        name: &'static str,
    },
    /// The accelerations or their derivatives are infinite or not a number.
    NotFinite {
        /// The last iterate.
        last: Equilibrium<S, N, U>,
    },
    /// The search did not converge within the allowed number of steps.
    NoConvergence {
        /// The last iterate.
        last: Equilibrium<S, N, U>,
    },
    /// No step, however short, made the next correction smaller: the Jacobian is singular near the last iterate, or
    /// there is no equilibrium nearby.
    Stalled {
        /// The last iterate.
        last: Equilibrium<S, N, U>,
    },
    /// The sum of the squares of the accelerations is stationary at the last iterate, but not zero: to first order, the
    /// unknowns do not act on the remaining accelerations. There may be an equilibrium elsewhere.
    Unbalanced {
        /// The last iterate.
        last: Equilibrium<S, N, U>,
        /// The coordinate with the largest acceleration, or with the largest difference of its momentum, or with an
        /// unbalanced force.
        name: &'static str,
        /// This acceleration, difference or force.
        residual: f64,
    },
    /// The search ended at a state that does not meet the constraints.
    Inconsistent {
        /// The last iterate.
        last: Equilibrium<S, N, U>,
        /// The constraint that is violated most.
        constraint: &'static str,
        /// Its residual, or the residual of its velocity if the coordinates meet it.
        residual: f64,
    },
    /// In a constrained model, a coordinate that moves acts on others, so that the motion is not steady; or the configuration is singular.
    NotSteady {
        /// The last iterate.
        last: Equilibrium<S, N, U>,
        /// What was found where the motion was examined.
        reason: TangentError,
    },
    /// The search ended where the mass matrix is nearly singular, and the forces are not balanced there.
    SingularMass {
        /// The last iterate.
        last: Equilibrium<S, N, U>,
        /// The coordinate at which the mass matrix is singular.
        name: &'static str,
        /// Its [relative pivot](crate::Lagrangian::relative_pivots).
        pivot: f64,
        /// The coordinate whose force is not balanced.
        unbalanced: &'static str,
        /// That force, in the equation M q̈ = f.
        force: f64,
    },
}

impl<S: Scalar, const N: usize, const U: usize> EquilibriumError<S, N, U> {
    /// Returns the last iterate, if there was a search.
    pub fn last(&self) -> Option<&Equilibrium<S, N, U>> {
        match self {
            Self::NotFinite { last }
            | Self::NoConvergence { last }
            | Self::Stalled { last }
            | Self::Unbalanced { last, .. }
            | Self::Inconsistent { last, .. }
            | Self::NotSteady { last, .. }
            | Self::SingularMass { last, .. } => Some(last),
            _ => None,
        }
    }
}

error_messages! { [S: Scalar, const N: usize, const U: usize] EquilibriumError<S, N, U>:
    Self::NoSuchVariable { variable } =>
        "there is no {variable:?} among {N} coordinates and {U} inputs that may be unknown; inputs may be in \
         `EquilibriumSearch::trim`";
    Self::NoUnknown =>
        "nothing is unknown; all coordinates are ignorable or the list of unknowns is empty: name some by `unknown`";
    Self::Moving { name, velocity } =>
        "`{name}` is not ignorable, so that its velocity has to be given as 0 in an equilibrium or a steady motion; it is {}",
        Readable(velocity);
    Self::NoConstantMomentum { name } =>
        "`{name}` is not ignorable, or the model has constraints, so that its momentum is no constant that could be given";
    Self::NotFinite { last } =>
        "the accelerations or their derivatives are not finite after {} Newton steps, at {:?}",
        last.report.iterations, last.state;
    Self::NoConvergence { last } =>
        "Newton's method has not converged after {} steps; accelerations are up to {} at {:?}",
        last.report.iterations, Readable(last.report.residual), last.state;
    Self::Stalled { last } =>
        "Newton's method cannot go on after {} steps: the Jacobian is singular or there is no equilibrium near {:?}, \
         where accelerations are up to {}",
        last.report.iterations, last.state, Readable(last.report.residual);
    Self::Unbalanced { last, name, residual } =>
        "to first order the unknowns do not act on `{name}`: its acceleration or its force, or the difference of its momentum, is {} at \
         {:?}, where the sum of squares is stationary; search from another guess, or name other unknowns",
        Readable(residual), last.state;
    Self::Inconsistent { last, constraint, residual } =>
        "the search ended at {:?}, where the residual of the constraint `{constraint}` is {}; begin at a state that \
         `assemble` has found, or name more unknowns",
        last.state, Readable(residual);
    Self::NotSteady { reason: TangentError::Acts { coordinate, on, slope }, .. } =>
        "`{coordinate}` moves, and acts on `{on}` with the derivative {}: in a steady motion, only coordinates move on which \
         nothing depends; use such coordinates, as the angle about the axis of a circle",
        Readable(slope);
    Self::NotSteady { reason, .. } => "whether the motion is steady cannot be told: {reason}";
    Self::SingularMass { last, name, pivot, unbalanced, force } =>
        "the search ended where the mass matrix is singular at `{name}` (relative pivot {}), at {:?}; this is no equilibrium: \
         the force on `{unbalanced}` is {}; search from a guess farther from the singularity, or with other \
         coordinates",
        Readable(pivot), last.state, Readable(force);
}
