//! Linearized equations of motion.

use nalgebra::{SMatrix, SVector};

use crate::linalg::lane_select::LaneSelect;
use crate::scalar::Scalar;

/// The derivatives of the accelerations q̈(q, q̇, t) of a system with `N` degrees of freedom; see
/// [`linearize`](crate::Lagrangian::linearize).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization<S: Scalar, const N: usize> {
    /// ∂q̈ᵢ/∂qⱼ in row i, column j.
    pub position: SMatrix<S, N, N>,
    /// ∂q̈ᵢ/∂q̇ⱼ in row i, column j.
    pub velocity: SMatrix<S, N, N>,
    /// ∂q̈ᵢ/∂t.
    pub time: SVector<S, N>,
}

impl<S: Scalar, const N: usize> Linearization<S, N> {
    /// Returns the state matrix A = (0, 1; ∂q̈/∂q, ∂q̈/∂q̇) of the first-order system ẋ = A x + B u.
    ///
    /// x = (q, q̇) and u are deviations from the point of linearization;
    /// [`StateSpace::of`](crate::analysis::StateSpace::of) also computes B = (0; ∂q̈/∂u). A has `D` = 2 `N` rows and
    /// columns.
    ///
    /// About an equilibrium, A and B are constant. About a motion, x is the deviation from the motion, and A and B vary
    /// along it.
    ///
    /// ```
    /// use lagrangian::analysis::StateSpace;
    /// use lagrangian::nalgebra::{Matrix3, Vector2};
    /// use lagrangian::prelude::*;
    ///
    /// /// An inverted pendulum with a motor: l² θ̈ = g l sin θ + torque/m.
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(theta),
    ///     kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    ///     potential = m * g * l * cos(theta),
    ///     force(theta = torque),
    /// )]
    /// struct Inverted { m: f64, l: f64, g: f64, #[lagrangian(input)] torque: f64 }
    ///
    /// let model = Inverted { m: 2.0, l: 0.5, g: 9.81, torque: 0.0 };
    /// let upright = State::new(0.0, [0.0], [0.0]);
    /// let a: Matrix2<f64> = model.linearize(&upright).state_matrix();
    /// let b = StateSpace::<f64, 2, 1, 2>::of(&model, &upright).b;
    /// assert_eq!(a, Matrix2::new(0.0, 1.0, 9.81 / 0.5, 0.0));
    /// assert_eq!(b, Vector2::new(0.0, 2.0));
    ///
    /// // Discretized with a zero-order hold over a period h: exp((A, B; 0, 0) h) = (Ad, Bd; 0, 1);
    /// // Van Loan, IEEE Trans. Autom. Control 23 (1978) 395.
    /// let h = 0.01;
    /// let mut block = Matrix3::zeros();
    /// block.fixed_view_mut::<2, 2>(0, 0).copy_from(&(a * h));
    /// block.fixed_view_mut::<2, 1>(0, 2).copy_from(&(b * h));
    /// let discrete = block.exp();
    /// let rate = (9.81_f64 / 0.5).sqrt();
    /// assert!((discrete[(0, 0)] - (rate * h).cosh()).abs() < 1e-15);
    /// assert!((discrete[(0, 2)] - 2.0 * ((rate * h).cosh() - 1.0) / rate.powi(2)).abs() < 1e-15);
    /// ```
    ///
    /// Another `D` does not compile:
    ///
    /// ```compile_fail,E0080
    /// # use lagrangian::{Linearization, nalgebra::{SMatrix, SVector}};
    /// # let zeros = SMatrix::<f64, 2, 2>::zeros();
    /// # let linearization = Linearization { position: zeros, velocity: zeros, time: SVector::zeros() };
    /// let a: SMatrix<f64, 3, 3> = linearization.state_matrix();
    /// ```
    #[must_use]
    pub fn state_matrix<const D: usize>(&self) -> SMatrix<S, D, D> {
        const {
            assert!(
                D == 2 * N,
                "the state matrix has twice as many rows and columns as there are coordinates: `D` is 2 `N`, \
                 as in `state_matrix::<4>()` and `StateSpace::<f64, 4, U, Y>` for two"
            );
        }
        SMatrix::from_fn(|i, j| match (i.checked_sub(N), j.checked_sub(N)) {
            (None, None) => S::zero(),
            (None, Some(j)) => S::from_f64(if i == j { 1.0 } else { 0.0 }),
            (Some(i), None) => self.position[(i, j)],
            (Some(i), Some(j)) => self.velocity[(i, j)],
        })
    }
}

impl<S: Scalar, const N: usize> LaneSelect<S> for Linearization<S, N> {
    fn select(self, other: Self, mask: S) -> Self {
        Self {
            position: self.position.select(other.position, mask),
            velocity: self.velocity.select(other.velocity, mask),
            time: self.time.select(other.time, mask),
        }
    }
}
