//! Linear state-space models.

use nalgebra::{Complex, SMatrix, SVector};

use super::controllability::Controllability;
use super::eigenvalues::eigenvalues;
use super::equilibrium::Variable;
use super::matrix_exponential::exponential;
use super::spectrum::Spectrum;
use crate::integrate::SingleNumber;
use crate::model::{Inputs, Lagrangian, State, StateJacobian};
use crate::scalar::Scalar;

/// A linear model ẋ = A x + B u + f₀, y = C x + D u + y₀ in the deviations x = (δq, δq̇) and u from the point of
/// linearization.
///
/// `D` is 2 `N`, or for a [constrained](StateSpace::reduced) model the number of its independent coordinates and velocities. `U` is
/// the number of inputs and `Y` the number of outputs, which are the states unless others are given. At an equilibrium f₀ is 0; elsewhere it is the derivative (q̇, q̈) at the point of linearization, and the
/// model holds for short times.
///
/// ```
/// use lagrangian::analysis::StateSpace;
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
/// let plant = StateSpace::<f64, 2, 1, 2>::of(&model, &State::new(0.0, [0.0], [0.0]));
/// assert!(plant.is_at_equilibrium(1e-12));
/// let rate = (9.81_f64 / 0.5).sqrt();
/// let poles = plant.poles().unwrap();
/// assert!((poles.abscissa() - rate).abs() < 1e-14);
///
/// // With a zero-order hold over 10 ms.
/// let sampled = plant.discretized(0.01);
/// assert!((sampled.a[(0, 0)] - (0.01 * rate).cosh()).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateSpace<S: Scalar, const D: usize, const U: usize, const Y: usize> {
    /// The state matrix A.
    pub a: SMatrix<S, D, D>,
    /// The input matrix B.
    pub b: SMatrix<S, D, U>,
    /// The output matrix C.
    pub c: SMatrix<S, Y, D>,
    /// The feedthrough matrix D.
    pub d: SMatrix<S, Y, U>,
    /// The derivative f₀ = (q̇, q̈) at the point of linearization.
    pub derivative: SVector<S, D>,
    /// The outputs y₀ at the point of linearization.
    pub output: SVector<S, Y>,
    /// The coordinates and velocities x₀ at the point of linearization.
    pub state: SVector<S, D>,
    /// The inputs u₀ at the point of linearization.
    pub inputs: SVector<S, U>,
    /// The coordinates and velocities that the components of x are.
    pub variables: [Variable; D],
}

/// A linear model in discrete time, xₖ₊₁ = A xₖ + B uₖ + f, yₖ = C xₖ + D uₖ + y₀; see [`StateSpace::discretized`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscreteStateSpace<S: Scalar, const D: usize, const U: usize, const Y: usize> {
    /// The state matrix A.
    pub a: SMatrix<S, D, D>,
    /// The input matrix B.
    pub b: SMatrix<S, D, U>,
    /// The output matrix C.
    pub c: SMatrix<S, Y, D>,
    /// The feedthrough matrix D.
    pub d: SMatrix<S, Y, U>,
    /// The increment f that f₀ adds in a period.
    pub increment: SVector<S, D>,
    /// The outputs y₀ at the point of linearization.
    pub output: SVector<S, Y>,
    /// The coordinates and velocities x₀ at the point of linearization.
    pub state: SVector<S, D>,
    /// The inputs u₀ at the point of linearization.
    pub inputs: SVector<S, U>,
    /// The coordinates and velocities that the components of x are.
    pub variables: [Variable; D],
    /// The sampling period.
    pub period: S,
}

/// Returns the variables of a model without constraints: all coordinates, then all velocities.
fn all_variables<const D: usize>() -> [Variable; D] {
    core::array::from_fn(|i| match i.checked_sub(D / 2) {
        None => Variable::Coordinate(i),
        Some(i) => Variable::Velocity(i),
    })
}

impl<S: Scalar, const D: usize, const U: usize> StateSpace<S, D, U, D> {
    /// Creates the model ẋ = A x + B u, whose outputs are the states.
    #[must_use]
    pub fn new(a: SMatrix<S, D, D>, b: SMatrix<S, D, U>) -> Self {
        let zero = SVector::zeros();
        Self {
            a,
            b,
            c: SMatrix::identity(),
            d: SMatrix::zeros(),
            derivative: zero,
            output: zero,
            state: zero,
            inputs: SVector::zeros(),
            variables: all_variables(),
        }
    }
}

impl<S: Scalar, const D: usize, const U: usize> DiscreteStateSpace<S, D, U, D> {
    /// Creates the model xₖ₊₁ = A xₖ + B uₖ, whose outputs are the states.
    #[must_use]
    pub fn new(a: SMatrix<S, D, D>, b: SMatrix<S, D, U>, period: S) -> Self {
        let zero = SVector::from_element(S::zero());
        Self {
            a,
            b,
            c: SMatrix::identity(),
            d: SMatrix::zeros(),
            increment: zero,
            output: zero,
            state: zero,
            inputs: SVector::from_element(S::zero()),
            variables: all_variables(),
            period,
        }
    }
}

impl<S: Scalar, const D: usize> StateSpace<S, D, 0, D> {
    /// Linearizes a model about a state, without inputs or with the inputs held at the values of its fields.
    ///
    /// A `D` other than 2 `N` does not compile.
    pub fn free<M, const N: usize>(model: &M, state: &State<S, N>) -> Self
    where
        M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
    {
        Self::about(model, state, SMatrix::zeros(), SVector::zeros())
    }
}

impl<S: Scalar, const D: usize, const U: usize> StateSpace<S, D, U, D> {
    /// Linearizes a model about a state and its inputs.
    ///
    /// The inputs are taken from the fields of the model or from [`with_inputs`](Lagrangian::with_inputs), for example
    /// as found by [`EquilibriumSearch::trim`](crate::analysis::EquilibriumSearch::trim). A `D` other than 2 `N` does
    /// not compile.
    pub fn of<M, const N: usize>(model: &M, state: &State<S, N>) -> Self
    where
        M: Lagrangian<N, S, Model: Inputs<N, U, S> + StateJacobian<N, S>> + ?Sized,
    {
        let b = below_zeros(&model.input_jacobian(state));
        Self::about(model, state, b, model.inputs())
    }

    fn about<M, const N: usize>(
        model: &M,
        state: &State<S, N>,
        b: SMatrix<S, D, U>,
        inputs: SVector<S, U>,
    ) -> Self
    where
        M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
    {
        let a = model.linearize(state).state_matrix();
        let x = stacked(&state.q, &state.v);
        Self {
            derivative: stacked(&state.v, &model.accelerations(state)),
            output: x,
            state: x,
            inputs,
            ..Self::new(a, b)
        }
    }
}

impl<S: Scalar, const D: usize, const U: usize, const Y: usize> StateSpace<S, D, U, Y> {
    /// Returns the model with other outputs y = C x + D u + y₀.
    #[must_use]
    pub fn with_outputs<const Z: usize>(
        &self,
        c: SMatrix<S, Z, D>,
        d: SMatrix<S, Z, U>,
        output: SVector<S, Z>,
    ) -> StateSpace<S, D, U, Z> {
        StateSpace {
            a: self.a,
            b: self.b,
            c,
            d,
            derivative: self.derivative,
            output,
            state: self.state,
            inputs: self.inputs,
            variables: self.variables,
        }
    }

    /// Returns whether the point of linearization is an equilibrium: whether no component of f₀ exceeds `tolerance`.
    ///
    /// A steady motion is not an equilibrium in this sense, since ignorable coordinates move.
    #[must_use]
    pub fn is_at_equilibrium(&self, tolerance: f64) -> bool {
        let mut components = self.derivative.iter();
        components.all(|x| x.abs().largest() <= tolerance)
    }
}

impl<S: SingleNumber, const D: usize, const U: usize, const Y: usize> StateSpace<S, D, U, Y> {
    /// Returns the poles, the eigenvalues of A, or `None` if an entry is not finite or the QR algorithm does not
    /// converge.
    #[must_use]
    pub fn poles(&self) -> Option<Spectrum<D>> {
        poles(&self.a)
    }

    /// Returns the part of the state that the inputs reach.
    #[must_use]
    pub fn controllability(&self) -> Controllability<D> {
        Controllability::of(&self.a, &self.b)
    }

    /// Returns the part of the state that the outputs show: the controllability of (Aᵀ, Cᵀ).
    #[must_use]
    pub fn observability(&self) -> Controllability<D> {
        Controllability::of(&self.a.transpose(), &self.c.transpose())
    }

    /// Returns the model with a zero-order hold: the inputs are constant over each period. It is not finite if the
    /// exponential overflows.
    #[must_use]
    pub fn discretized(&self, period: S) -> DiscreteStateSpace<S, D, U, Y> {
        let [a, integral] = exponential(&self.a, period);
        DiscreteStateSpace {
            a,
            b: integral * self.b,
            c: self.c,
            d: self.d,
            increment: integral * self.derivative,
            output: self.output,
            state: self.state,
            inputs: self.inputs,
            variables: self.variables,
            period,
        }
    }
}

impl<S: SingleNumber, const D: usize, const U: usize, const Y: usize>
    DiscreteStateSpace<S, D, U, Y>
{
    /// Returns the poles, the eigenvalues of A, or `None` if they are not found; stable poles lie within the unit
    /// circle.
    #[must_use]
    pub fn poles(&self) -> Option<Spectrum<D>> {
        poles(&self.a)
    }

    /// Returns the part of the state that the inputs reach.
    #[must_use]
    pub fn controllability(&self) -> Controllability<D> {
        Controllability::of(&self.a, &self.b)
    }
}

/// Returns the eigenvalues of a matrix.
pub(super) fn poles<S: Scalar, const D: usize>(a: &SMatrix<S, D, D>) -> Option<Spectrum<D>> {
    let mut entries: [[f64; D]; D] =
        core::array::from_fn(|i| core::array::from_fn(|j| a[(i, j)].largest()));
    let mut found = [[Complex::new(0.0, 0.0); D]; 2];
    let converged = eigenvalues(entries.as_flattened_mut(), D, D, found.as_flattened_mut());
    converged.then(|| Spectrum::new(found, D))
}

/// Returns a matrix whose upper half is zero.
fn below_zeros<S: Scalar, const D: usize, const N: usize, const U: usize>(
    lower: &SMatrix<S, N, U>,
) -> SMatrix<S, D, U> {
    SMatrix::from_fn(|i, j| i.checked_sub(N).map_or(S::zero(), |i| lower[(i, j)]))
}

pub(super) fn stacked<S: Scalar, const N: usize, const D: usize>(
    upper: &SVector<S, N>,
    lower: &SVector<S, N>,
) -> SVector<S, D> {
    SVector::from_fn(|i, _| match i.checked_sub(N) {
        None => upper[i],
        Some(i) => lower[i],
    })
}
