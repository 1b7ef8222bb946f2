//! Models in Hamiltonian form: q̇ = ∂H/∂p, ṗ = −∂H/∂q + Q (Hamilton, Second essay on a general method in dynamics, 1835).

use nalgebra::SVector;

use super::emitted::no_velocities;
use super::quantities::Quantities;
use super::state::State;
use crate::error_messages::error_messages;
use crate::scalar::Scalar;

/// A model whose declaration has the clause `hamiltonian`: its motion in coordinates and momenta.
///
/// H = Σ pᵢ q̇ᵢ − L is the energy function in terms of q, p and t. Its derivatives are those of L at the velocities that
/// belong to the momenta: ∂H/∂p = q̇ and ∂H/∂q = −∂L/∂q (Goldstein, Poole and Safko, Classical Mechanics, 2002,
/// section 8.1).
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(r, phi),
///     kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
///     potential = -k / r,
///     hamiltonian,
/// )]
/// struct Planet { m: f64, k: f64 }
///
/// let planet = Planet { m: 2.0, k: 3.0 };
/// let start = State::new(0.0, [1.0, 0.0], [0.0, 1.1]);
/// let equations = planet.canonical_equations();
/// let end = Problem::new(&equations, equations.canonical(&start)).solve(2.0, Dop853::new())?;
/// // The momentum of the ignorable coordinate stays, to the last digit.
/// assert_eq!(end.p[Planet::PHI], 2.0 * 1.1);
/// let state = equations.state(end.t, &end.x)?;
/// let expected = Problem::new(&planet, start).solve(2.0, Dop853::new())?;
/// assert!((state.q - expected.q).norm() < 1e-9 && (state.v - expected.v).norm() < 1e-9);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Hamiltonian form",
    note = "write the clause `hamiltonian` in its declaration"
)]
pub trait Hamiltonian<const N: usize, S: Scalar = f64>: Quantities<N, S> {
    /// [`Lagrangian::momentum_rates`](crate::Lagrangian::momentum_rates) under these inputs.
    fn momentum_rates(
        &self,
        state: &State<S, N>,
        inputs: &Self::Inputs,
        prepared: &Self::Prepared,
    ) -> SVector<S, N>;

    /// The velocities that have these momenta at the coordinates and the time of a state, where L is quadratic in the
    /// velocities: M(q, t) q̇ = p − p(q, 0, t), by the factors that the accelerations are solved for with.
    /// Not numbers where L is not quadratic, where M is factored
    /// numerically, and where a pivot is not positive; [`velocities`](crate::Lagrangian::velocities) then goes another way.
    fn solved_velocities(
        &self,
        state: &State<S, N>,
        momenta: &SVector<S, N>,
        prepared: &Self::Prepared,
    ) -> SVector<S, N> {
        let _ = (state, momenta, prepared);
        no_velocities()
    }
}

/// There are no velocities that have some momenta, or none was found.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum NoVelocities {
    /// Newton's method does not converge, or the mass matrix is singular.
    NotFound {
        /// The last change of a velocity; not finite where the mass matrix is singular.
        change: f64,
    },
    /// The Lagrangian function is not convex in the velocities, so that others may have the same momenta.
    NotConvex,
}

error_messages! { NoVelocities:
    Self::NotFound { change } if change.is_finite() =>
        "no velocities with these momenta were found: Newton's method still changes them by {change:e}";
    Self::NotFound { .. } =>
        "there are no velocities with these momenta: the mass matrix is singular, or a momentum is not finite";
    Self::NotConvex =>
        "several velocities may have these momenta: the Lagrangian function is not convex in the velocities, since the \
         mass matrix is not positive definite where they were found; integrate Lagrange's equations, `dynamics()`";
}
