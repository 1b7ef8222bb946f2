//! The states of laws.

use nalgebra::SVector;

use crate::integrate::TaylorCoefficients;
use crate::linalg::VectorSpace;
use crate::model::phase::Phase;
use crate::scalar::Scalar;

/// States that are integrated together with coordinates and velocities.
pub trait LawStates<S: Scalar>: VectorSpace<S> + Sized {
    /// Calls `then` with the series of coordinates and velocities alone.
    #[doc(hidden)]
    fn of_motion<R, const N: usize, const HALF: usize>(
        series: &TaylorCoefficients<Phase<S, N, Self>, HALF>,
        then: impl FnOnce(&TaylorCoefficients<Phase<S, N>, HALF>) -> R,
    ) -> R {
        then(&series.map(Phase::motion))
    }

    /// Sets the series of a motion about `x`: `expand` sets the series of coordinates and velocities, and `terms` are
    /// the coefficients of the states from order 1 on.
    #[doc(hidden)]
    fn expand<const N: usize, const HALF: usize>(
        x: &Phase<S, N, Self>,
        terms: &[Self],
        series: &mut TaylorCoefficients<Phase<S, N, Self>, HALF>,
        expand: impl FnOnce(&mut TaylorCoefficients<Phase<S, N>, HALF>),
    ) {
        let mut motion = TaylorCoefficients::new(x.motion());
        expand(&mut motion);
        let zero = x.z.zeroed();
        *series = motion.map(|term| term.with(zero.clone()));
        *series.initial_mut() = x.clone();
        for (coefficient, z) in series.higher_mut().iter_mut().zip(terms) {
            coefficient.z = z.clone();
        }
    }
}

/// Without states, nothing is copied.
impl<S: Scalar> LawStates<S> for () {
    #[inline]
    fn of_motion<R, const N: usize, const HALF: usize>(
        series: &TaylorCoefficients<Phase<S, N>, HALF>,
        then: impl FnOnce(&TaylorCoefficients<Phase<S, N>, HALF>) -> R,
    ) -> R {
        then(series)
    }

    #[inline]
    fn expand<const N: usize, const HALF: usize>(
        _: &Phase<S, N>,
        _: &[Self],
        series: &mut TaylorCoefficients<Phase<S, N>, HALF>,
        expand: impl FnOnce(&mut TaylorCoefficients<Phase<S, N>, HALF>),
    ) {
        expand(series);
    }
}

impl<S: Scalar, const K: usize> LawStates<S> for SVector<S, K> {}

impl<S: Scalar, A: LawStates<S>, B: LawStates<S>> LawStates<S> for (A, B) {}
