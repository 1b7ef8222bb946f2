//! Hand-written models, and the comparison of numbers.
#![allow(dead_code, unreachable_pub)] // Every binary has a copy of it, and none uses all.

use lagrangian::prelude::*;
use lagrangian::{InLanes, Series, SeriesMemory, TaylorCoefficients};
use nalgebra::{SMatrix, SVector};

/// Fails unless |a − b| ≤ tolerance; a value that is not finite is never close.
#[track_caller]
pub fn assert_close(a: f64, b: f64, tolerance: f64) {
    let error = (a - b).abs();
    assert!(
        error <= tolerance && tolerance.is_finite(),
        "{a:e} and {b:e} differ by {error:e}, more than {tolerance:e}"
    );
}

/// Motions of one system from initial states to their ends, in so many lanes.
pub fn in_lanes<const L: usize, D, const HALF: usize>(
    method: Taylor<HALF>,
    dynamics: &D,
    motions: impl IntoIterator<Item = (At<f64, D::State>, f64)>,
) -> Vec<Result<Solution<f64, D::State>, IntegrationError>>
where
    D: InLanes<L>,
{
    let (starts, ends): (Vec<_>, Vec<_>) = motions.into_iter().unzip();
    let problems = starts
        .into_iter()
        .map(|start| Problem::new(dynamics, start));
    let found = Ensemble::new(problems)
        .lanes::<L>()
        .solve(|index: usize| ends[index], method);
    let found = found.into_iter();
    found
        .map(|found| found.map_err(|partial| partial.error()))
        .collect()
}

/// Implements `InLanes` for a system whose members are alike.
#[macro_export]
macro_rules! alike_in_lanes {
    ($system:ty) => {
        impl<const L: usize> lagrangian::InLanes<L> for $system {
            type States = <$system as lagrangian::prelude::Dynamics<lagrangian::Lanes<L>>>::State;
            type Parameters = ();
            type Together<'a> = &'a Self;
            fn parameters(&self) {}
            fn set_lane(&self, (): &mut (), _: usize) {}
            fn together<'a>(&'a self, (): &'a ()) -> &'a Self {
                self
            }
        }
    };
}

/// a · b, for any scalar.
pub fn dot<S: Scalar, const N: usize>(a: &SVector<S, N>, b: &SVector<S, N>) -> S {
    a.iter()
        .zip(b.iter())
        .fold(S::zero(), |sum, (a, b)| sum + *a * *b)
}

/// M v, for any scalar.
pub fn apply<S: Scalar, const N: usize>(m: &SMatrix<S, N, N>, v: &SVector<S, N>) -> SVector<S, N> {
    SVector::from_fn(|i, _| (0..N).fold(S::zero(), |sum, j| sum + m[(i, j)] * v[j]))
}

/// A model given by its equations of motion, from which the rest of the trait follows.
pub trait Written<const N: usize, S: Scalar> {
    fn energy(&self, state: &State<S, N>) -> S;
    fn mass_matrix(&self, state: &State<S, N>) -> SMatrix<S, N, N>;
    fn forcing(&self, state: &State<S, N>) -> SVector<S, N>;
}

/// Implements `Lagrangian` for a [`Written`] model without inputs whose L is quadratic in the velocities.
#[macro_export]
macro_rules! written_model {
    ($model:ty, $n:literal) => {
        impl<S: Scalar> Lagrangian<$n, S> for $model {
            type Model = Self;
            fn model(&self) -> &Self {
                self
            }
        }

        impl<S: Scalar> lagrangian::quantities::Quantities<$n, S> for $model {
            type Inputs = SVector<S, 0>;
            type Prepared = [S; 0];
            fn inputs(&self) -> SVector<S, 0> {
                SVector::zeros()
            }
            fn prepare(&self) -> [S; 0] {
                []
            }
            fn lagrangian(&self, state: &State<S, $n>, _: &SVector<S, 0>, _: &[S; 0]) -> S {
                // h = T + V and L = T − V.
                $crate::common::dot(&Lagrangian::momenta(self, state), &state.v)
                    - Written::energy(self, state)
            }
            fn energy(&self, state: &State<S, $n>, _: &SVector<S, 0>) -> S {
                Written::energy(self, state)
            }
            fn momenta(&self, state: &State<S, $n>, _: &[S; 0]) -> SVector<S, $n> {
                $crate::common::apply(&Written::mass_matrix(self, state), &state.v)
            }
            fn mass_matrix(&self, state: &State<S, $n>, _: &[S; 0]) -> SMatrix<S, $n, $n> {
                Written::mass_matrix(self, state)
            }
            fn forcing(
                &self,
                state: &State<S, $n>,
                _: &SVector<S, 0>,
                _: &[S; 0],
            ) -> SVector<S, $n> {
                Written::forcing(self, state)
            }
            fn generalized_forces(&self, _: &State<S, $n>, _: &SVector<S, 0>) -> SVector<S, $n> {
                SVector::zeros()
            }
            fn accelerations(
                &self,
                state: &State<S, $n>,
                _: &SVector<S, 0>,
                _: &[S; 0],
            ) -> SVector<S, $n> {
                let mass = Written::mass_matrix(self, state);
                lagrangian::Factorization::new(mass).solve(&Written::forcing(self, state))
            }
            fn inverse_dynamics(
                &self,
                state: &State<S, $n>,
                _: &SVector<S, 0>,
                accelerations: &SVector<S, $n>,
                _: &[S; 0],
            ) -> SVector<S, $n> {
                $crate::common::apply(&Written::mass_matrix(self, state), accelerations)
                    - Written::forcing(self, state)
            }
        }
    };
}

/// A mathematical pendulum: θ̈ = −(g/l) sin θ.
#[derive(Clone, Debug)]
pub struct Pendulum {
    pub m: f64,
    pub g: f64,
    pub l: f64,
}

impl GeneralizedCoordinates<1> for Pendulum {
    const COORDINATES: [&'static str; 1] = ["theta"];
    const ANGLES: [bool; 1] = [true];
}

impl<S: Scalar> Written<1, S> for Pendulum {
    fn energy(&self, state: &State<S, 1>) -> S {
        let [m, g, l] = [self.m, self.g, self.l].map(S::from_f64);
        let half = S::from_f64(0.5);
        half * m * l * l * state.v[0] * state.v[0] - m * g * l * state.q[0].cos()
    }
    fn mass_matrix(&self, _: &State<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from([[S::from_f64(self.m * self.l * self.l)]])
    }
    fn forcing(&self, state: &State<S, 1>) -> SVector<S, 1> {
        SVector::from([-S::from_f64(self.m * self.g * self.l) * state.q[0].sin()])
    }
}

written_model!(Pendulum, 1);

/// The symmetric top of (4.7) in z-x-z Euler angles, with V = m g l cos θ.
#[derive(Clone, Debug)]
pub struct SymmetricTop {
    /// I.
    pub transverse: f64,
    /// Iₛ.
    pub axial: f64,
    /// m g l.
    pub weight: f64,
}

impl GeneralizedCoordinates<3> for SymmetricTop {
    const COORDINATES: [&'static str; 3] = ["phi", "theta", "psi"];
    const ANGLES: [bool; 3] = [true; 3];
    // The block of ψ is that of the whole matrix: det M = I² Iₛ sin²θ.
    const SINGULARITIES: [&'static [usize]; 3] = [&[1], &[], &[1]];
}

impl<S: Scalar> Written<3, S> for SymmetricTop {
    fn energy(&self, state: &State<S, 3>) -> S {
        let momenta = apply(&Written::mass_matrix(self, state), &state.v);
        S::from_f64(0.5) * dot(&momenta, &state.v) + S::from_f64(self.weight) * state.q[1].cos()
    }

    fn mass_matrix(&self, state: &State<S, 3>) -> SMatrix<S, 3, 3> {
        let [i, i_s] = [self.transverse, self.axial].map(S::from_f64);
        let (s, c) = state.q[1].sin_cos();
        let zero = S::zero();
        SMatrix::from([
            [i * s * s + i_s * c * c, zero, i_s * c],
            [zero, i, zero],
            [i_s * c, zero, i_s],
        ])
    }

    /// d/dt (∂T/∂q̇) − ∂T/∂q of (4.7) without the accelerations.
    fn forcing(&self, state: &State<S, 3>) -> SVector<S, 3> {
        let [i, i_s] = [self.transverse, self.axial].map(S::from_f64);
        let (s, c) = state.q[1].sin_cos();
        let [phi, theta, psi]: [S; 3] = state.v.into();
        let two = S::from_f64(2.0);
        let spin = phi * c + psi;
        SVector::from([
            -(two * (i - i_s) * s * c * phi * theta - i_s * s * theta * psi),
            i * phi * phi * s * c - i_s * spin * phi * s + S::from_f64(self.weight) * s,
            i_s * s * theta * phi,
        ])
    }
}

written_model!(SymmetricTop, 3);

/// L = ẋ ẏ − x y, whose mass matrix is indefinite and regular: ẍ = −x, ÿ = −y.
#[derive(Clone, Debug)]
pub struct Crossed;

impl GeneralizedCoordinates<2> for Crossed {
    const COORDINATES: [&'static str; 2] = ["x", "y"];
}

impl<S: Scalar> Written<2, S> for Crossed {
    fn energy(&self, state: &State<S, 2>) -> S {
        state.v[0] * state.v[1] + state.q[0] * state.q[1]
    }
    fn mass_matrix(&self, _: &State<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from([[S::zero(), S::one()], [S::one(), S::zero()]])
    }
    fn forcing(&self, state: &State<S, 2>) -> SVector<S, 2> {
        SVector::from([-state.q[1], -state.q[0]])
    }
}

written_model!(Crossed, 2);

/// ẋ = v, v̇ = −x, without names and angles: x = cos t from (1, 0).
pub struct Oscillator;

impl<S: Scalar> Dynamics<S> for Oscillator {
    type State = SVector<S, 2>;

    fn derivative(&self, _: S, x: &Self::State) -> Self::State {
        SVector::from([x[1], -x[0]])
    }
}

/// Linear equations: coefficient k + 1 from coefficient k.
impl<S: Scalar> Series<S> for Oscillator {
    fn series<const HALF: usize>(
        &self,
        (_, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        *coefficients.initial_mut() = *x;
        let mut order = S::zero();
        let mut last = *x;
        for coefficient in coefficients.higher_mut() {
            order += S::one();
            let step = unit / order;
            last = SVector::from([last[1] * step, -last[0] * step]);
            *coefficient = last;
        }
    }
}

alike_in_lanes!(Oscillator);

/// ẋ = f(t, x) of a closure, with `D` components.
pub struct Equation<F, const D: usize>(F);

/// The dynamics of a closure.
pub fn equation<const D: usize, F>(function: F) -> Equation<F, D>
where
    F: Fn(f64, &SVector<f64, D>) -> SVector<f64, D>,
{
    Equation(function)
}

impl<const D: usize, F> Dynamics for Equation<F, D>
where
    F: Fn(f64, &SVector<f64, D>) -> SVector<f64, D>,
{
    type State = SVector<f64, D>;

    fn derivative(&self, t: f64, x: &Self::State) -> Self::State {
        (self.0)(t, x)
    }
}
