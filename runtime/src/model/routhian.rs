//! Models reduced by their ignorable coordinates, and the reconstruction of the full motion.
//!
//! Routh, A Treatise on the Stability of a Given State of Motion, 1877; Goldstein, Poole and Safko, Classical
//! Mechanics, 3rd edition 2002, section 8.3.

use nalgebra::SVector;

use super::lagrangian::Lagrangian;
use super::phase::Phase;
use super::quantities::Quantities;
use super::reconstruction::Reconstruction;
use super::state::State;
use crate::integrate::TaylorCoefficients;
use crate::scalar::Scalar;

/// A model with `N` coordinates whose declaration requests a reduced model with `R` coordinates, by the clause
/// `routhian(Name)`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no reduced model",
    note = "write the clause `routhian(Name)` in its declaration, with a name for the reduced model"
)]
pub trait RouthReduction<const N: usize, const R: usize> {
    /// The scalar of the parameters.
    type Scalar: Scalar;

    /// The reduced model.
    type Reduced;

    /// Returns the reduced model with the constant momenta (4.8) of this state, and the corresponding state of the
    /// reduced model.
    fn reduce(&self, state: &State<Self::Scalar, N>) -> (Self::Reduced, State<Self::Scalar, R>);
}

/// A model without the `K` ignorable coordinates of another model, whose constant momenta C are its parameters.
///
/// It is used like any other model. Its Lagrangian is −R with the Routhian R = Σ Cₐ q̇ₐ − L (4.9), in which the
/// velocities of the ignorable coordinates are eliminated exactly. Lagrange's equations of −R agree with the equations
/// of the full model for the other coordinates, with unchanged generalized forces. (Some books call L − Σ Cₐ q̇ₐ the
/// Routhian.) Its energy function equals the energy function of the full model, T + `V_eff`.
///
/// The ignorable coordinates follow by quadrature; see [`reconstruction`](Self::reconstruction).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a reduced model",
    note = "write the clause `routhian(Name)` in the declaration of the full model, which `reduce` leads to `Name`"
)]
pub trait Routhian<const N: usize, const K: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// The state of the full model.
    type FullState;

    /// The names of the ignorable coordinates, in order.
    const ELIMINATED: [&'static str; K];

    /// Returns the constant momenta C of the ignorable coordinates.
    fn constants(&self) -> SVector<S, K>;

    /// Returns the Routhian R = Σ Cₐ q̇ₐ − L (4.9).
    fn routhian(&self, state: &State<S, N>) -> S {
        -self.lagrangian(state)
    }

    /// Returns the effective potential `V_eff`, the value of R at q̇ = 0 (4.10); only the coordinates and the time of
    /// the state matter.
    ///
    /// It contains all contributions of the constants, such as C²/(2 I) of a spin. If R also has terms of first degree
    /// in the velocities, the motion is subject to gyroscopic forces as well, which do no work and do not occur here.
    ///
    /// It has a value at a pole sin q = 0 that is reached with these constants, and is accurate nearby.
    fn effective_potential(&self, state: &State<S, N>) -> S;

    /// Returns the velocities of the ignorable coordinates, from p = ∂L/∂q̇ = C.
    fn ignorable_velocities(&self, state: &State<S, N>) -> SVector<S, K> {
        self.eliminated_velocities(state, &self.model().prepare())
    }

    /// Returns the [`ignorable_velocities`](Self::ignorable_velocities), given the result of
    /// [`prepare`](Quantities::prepare).
    fn eliminated_velocities(
        &self,
        state: &State<S, N>,
        prepared: &<Self::Model as Quantities<N, S>>::Prepared,
    ) -> SVector<S, K>;

    /// Returns the state of the full model, given the values of the ignorable coordinates.
    fn full_state(&self, state: &State<S, N>, ignorable: &SVector<S, K>) -> Self::FullState;

    /// Returns the equations of motion of the reduced model together with the velocities of the ignorable coordinates.
    /// An integration then yields these coordinates, too: at every step, sample and point of dense output.
    fn reconstruction(&self) -> Reconstruction<'_, Self, S, N, K>
    where
        Self: Sized,
    {
        Reconstruction::new(self)
    }
}

/// A reduced model whose declaration has the clause `taylor`, with the series of the velocities of the ignorable
/// coordinates.
#[diagnostic::on_unimplemented(
    message = "the Taylor series of the ignorable coordinates of `{Self}` are not known",
    note = "write the clause `taylor` in the declaration of the full model, or integrate by `Dop853`"
)]
pub trait RouthianSeries<const N: usize, const K: usize, S: Scalar = f64>:
    Routhian<N, K, S>
{
    /// Returns the Taylor coefficients of the velocities of the ignorable coordinates along a motion through a state.
    ///
    /// The coefficients of the motion are given in the same unit of time; its coefficients of order 0 are not read.
    fn ignorable_velocity_series<const HALF: usize>(
        &self,
        state: &State<S, N>,
        prepared: &<Self::Model as Quantities<N, S>>::Prepared,
        unit: S,
        motion: &TaylorCoefficients<Phase<S, N>, HALF>,
    ) -> TaylorCoefficients<[S; K], HALF>;
}
