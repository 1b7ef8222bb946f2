//! Derivatives of a motion by its initial values and by parameters.

use nalgebra::{SMatrix, SVector};

use super::phase::Phase;
use super::state::State;
use crate::integrate::{Dynamics, IntegrationError, Integrator, Problem};
use crate::scalar::Dual;

/// The derivatives of a motion at a time by the `K` variables of its [dual numbers](Dual).
///
/// Variables 0 to 2 `N` − 1 are the initial coordinates and velocities; variables from 2 `N` on are other given
/// quantities, such as parameters.
///
/// The steps of the integration are differentiated, so that the variational equations are solved by the method of the
/// integration (E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., 1993,
/// section I.14). Over a period, the matrix is the monodromy matrix, whose eigenvalues are the Floquet multipliers.
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::{Dual, StateTransition};
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(x),
///     kinetic = 0.5 * m * dot(x).powi(2),
///     potential = 0.5 * k * x.powi(2),
/// )]
/// struct Oscillator<T: Scalar> { m: T, k: T }
///
/// // By x(0), ẋ(0) and, third, the stiffness.
/// let oscillator = Oscillator { m: Dual::<f64, 3>::constant(1.0), k: Dual::variable(4.0, 2) };
/// let start = State::new(0.0, [1.0], [0.0]);
/// let transition = StateTransition::over(&Taylor::new(), &oscillator.dynamics(), &start, 10.0)?;
///
/// let matrix = transition.matrix::<2>();
/// let (sine, cosine) = 20.0_f64.sin_cos();
/// assert!((matrix - Matrix2::new(cosine, 0.5 * sine, -2.0 * sine, cosine)).norm() < 1e-13);
/// let by_stiffness = transition.by_parameters::<1>();
/// // x = cos √k t.
/// assert!((by_stiffness.q[0] + 10.0 / 4.0 * sine).abs() < 1e-13);
/// # Ok::<(), IntegrationError>(())
/// ```
///
/// For several times, use [`initial`](Self::initial) as the initial value of a sampled motion, and [`of`](Self::of) on
/// its samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateTransition<const N: usize, const K: usize> {
    /// The state at this time.
    pub state: State<f64, N>,
    /// ∂qᵢ/∂(variable j) in row i, column j.
    pub q: SMatrix<f64, N, K>,
    /// ∂q̇ᵢ/∂(variable j) in row i, column j.
    pub v: SMatrix<f64, N, K>,
}

impl<const N: usize, const K: usize> StateTransition<N, K> {
    /// Computes the derivatives over the motion from `initial` to the time `end`, which may lie before it. The final
    /// time does not depend on the variables.
    ///
    /// # Errors
    ///
    /// Any of [`IntegrationError`].
    pub fn over<'d, I, D>(
        method: &I,
        dynamics: &'d D,
        initial: &State<f64, N>,
        end: f64,
    ) -> Result<Self, IntegrationError>
    where
        D: Dynamics<Dual<f64, K>, State = Phase<Dual<f64, K>, N>> + ?Sized,
        I: Integrator<Dual<f64, K>, &'d D> + Clone,
    {
        let end = Problem::new(dynamics, Self::initial(initial)).solve(end, method.clone())?;
        Ok(Self::of(&end))
    }

    /// Returns an initial value in which variables 0 to 2 `N` − 1 are the coordinates and velocities.
    ///
    /// `K` is 2 `N`, or more with parameters:
    ///
    /// ```compile_fail,E0080
    /// # use lagrangian::{State, StateTransition};
    /// let initial = StateTransition::<1, 1>::initial(&State::new(0.0, [1.0], [0.0]));
    /// ```
    #[must_use]
    pub fn initial(state: &State<f64, N>) -> State<Dual<f64, K>, N> {
        const {
            assert!(
                K >= 2 * N,
                "a state transition is by all coordinates and velocities: `K` is 2 `N`, and more with parameters"
            );
        }
        let q = SVector::from_fn(|i, _| Dual::variable(state.q[i], i));
        let v = SVector::from_fn(|i, _| Dual::variable(state.v[i], N + i));
        State::new(Dual::constant(state.t), q, v)
    }

    /// Returns the derivatives at a sample.
    #[must_use]
    pub fn of(sample: &State<Dual<f64, K>, N>) -> Self {
        let Phase { q, v, z: () } = sample.x;
        let gradients =
            |of: &SVector<Dual<f64, K>, N>| SMatrix::from_fn(|i, j| of[i].derivative[j]);
        Self {
            state: State::new(
                sample.t.value,
                q.map(|coordinate| coordinate.value),
                v.map(|velocity| velocity.value),
            ),
            q: gradients(&q),
            v: gradients(&v),
        }
    }

    /// Returns the state-transition matrix Φ = ∂x(t)/∂x(0), where x = (q, q̇). It has `D` = 2 `N` rows and columns.
    ///
    /// In canonical variables the matrix is symplectic, Φᵀ J Φ = J. To obtain it with the momenta p = M q̇ + …,
    /// multiply by the derivatives of p at both ends.
    #[must_use]
    pub fn matrix<const D: usize>(&self) -> SMatrix<f64, D, D> {
        const {
            assert!(
                D == 2 * N,
                "the state-transition matrix has twice as many rows and columns as there are coordinates: `D` is 2 `N`, \
                 as in `matrix::<4>()` for two"
            );
        }
        SMatrix::from_fn(|i, j| match i.checked_sub(N) {
            None => self.q[(i, j)],
            Some(i) => self.v[(i, j)],
        })
    }

    /// Returns the derivatives of the state by the `P` = `K` − 2 `N` parameters: for each parameter, a column of `q`
    /// and of `v`.
    #[must_use]
    pub fn by_parameters<const P: usize>(&self) -> ByParameters<N, P> {
        const {
            assert!(
                P + 2 * N == K,
                "the numbers from 2 `N` on are parameters: `P` is `K` − 2 `N`"
            );
        }
        ByParameters {
            q: SMatrix::from_fn(|i, j| self.q[(i, 2 * N + j)]),
            v: SMatrix::from_fn(|i, j| self.v[(i, 2 * N + j)]),
        }
    }
}

/// The derivatives of a state by parameters; see [`StateTransition::by_parameters`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByParameters<const N: usize, const P: usize> {
    /// ∂qᵢ/∂pⱼ in row i, column j.
    pub q: SMatrix<f64, N, P>,
    /// ∂q̇ᵢ/∂pⱼ in row i, column j.
    pub v: SMatrix<f64, N, P>,
}
