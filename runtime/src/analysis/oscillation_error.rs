//! The errors of small oscillations and of their modes.

use crate::error_messages::error_messages;
use crate::number_format::Readable;

/// The reason why there are no small oscillations about a state, or no modes of the requested kind.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum OscillationError {
    /// An acceleration is not zero: the state is neither an equilibrium nor a steady motion.
    Accelerated {
        /// The coordinate.
        name: &'static str,
        /// Its acceleration.
        acceleration: f64,
    },
    /// A force is not balanced: the state is neither an equilibrium nor a steady motion. Near a singular mass matrix,
    /// the accelerations may still be small in comparison with their derivatives.
    Unbalanced {
        /// The coordinate.
        name: &'static str,
        /// The force f in M q̈ = f.
        force: f64,
    },
    /// A coordinate that is not ignorable has a velocity: the motion is not steady.
    Moving {
        /// The coordinate.
        name: &'static str,
        /// Its velocity.
        velocity: f64,
    },
    /// The mass matrix is not positive definite.
    NoPositiveMass {
        /// The index of the coordinate at which its factorization fails.
        coordinate: usize,
        /// The pivot at this coordinate.
        pivot: f64,
    },
    /// The stiffness matrix is not symmetric: the position-dependent forces are not conservative, and there are no real
    /// modes.
    NotConservative {
        /// The largest difference of two entries that should be equal.
        asymmetry: f64,
    },
    /// There are gyroscopic or damping forces: the modes are complex.
    VelocityForces {
        /// The largest entry of G + C.
        largest: f64,
    },
    /// The QR algorithm did not converge, or an entry is infinite or NaN.
    NoEigenvalues,
}

error_messages! { OscillationError:
    Self::Accelerated { name, acceleration } =>
        "the state is no equilibrium: `{name}` has the acceleration {}; `EquilibriumSearch` finds one, and \
         `StateSpace` is linearized about any state",
        Readable(acceleration);
    Self::Unbalanced { name, force } =>
        "the state is no equilibrium: the force on `{name}` is {}, and the mass matrix may be nearly singular; `relative_pivots` \
         tells where; take a state or coordinates farther from the singularity",
        Readable(force);
    Self::Moving { name, velocity } =>
        "the motion is not steady: `{name}`, which is not ignorable, has the velocity {}",
        Readable(velocity);
    Self::NoPositiveMass { coordinate, pivot } =>
        "the mass matrix is not positive definite: the pivot of coordinate {coordinate} is {}",
        Readable(pivot);
    Self::NotConservative { asymmetry } =>
        "the stiffness matrix is not symmetric, by up to {}: forces are not conservative; `damped_modes` has the modes",
        Readable(asymmetry);
    Self::VelocityForces { largest } =>
        "there are gyroscopic or damping forces, with coefficients up to {}: `damped_modes` has the modes, which are \
         complex",
        Readable(largest);
    Self::NoEigenvalues =>
        "the eigenvalues were not found: an entry is not finite, or the QR algorithm has not converged";
}
