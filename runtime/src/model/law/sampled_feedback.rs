//! Sampled feedback: a controller that is evaluated periodically and whose inputs are held in between.

use nalgebra::SVector;

use super::{Law, LawSeries, LawStates, StatesInLanes};
use crate::integrate::{IntegrationError, SingleNumber};
use crate::linalg::{IntoVector, LaneStates, VectorSpace};
use crate::model::phase::Phase;
use crate::model::state::State;
use crate::scalar::{Lanes, Scalar};

/// A controller with a memory of `J` numbers that is evaluated periodically, and whose `U` inputs are held in between
/// (zero-order hold); constructed by [`Problem::sampled_feedback`](crate::Problem::sampled_feedback).
#[derive(Clone, Copy, Debug)]
pub struct SampledFeedback<F, const U: usize, const J: usize> {
    pub(crate) law: F,
    /// The time of the first sampling.
    pub(crate) start: f64,
    pub(crate) period: f64,
}

/// The inputs and the memory of a sampled controller, which a state contains in [`z`](Phase::z).
///
/// Its components are the inputs, the memory, then the number of samplings.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sampled<S: Scalar, const U: usize, const J: usize> {
    /// The inputs, held since the last sampling.
    pub inputs: SVector<S, U>,
    /// The memory of the controller.
    pub memory: SVector<S, J>,
    /// The number of evaluations of the controller.
    pub samplings: S,
}

impl<S: Scalar, const U: usize, const J: usize> Sampled<S, U, J> {
    /// Returns the state before the first sampling, with a given memory.
    pub(crate) fn before(memory: SVector<S, J>) -> Self {
        Self {
            inputs: SVector::from_element(S::zero()),
            memory,
            samplings: S::zero(),
        }
    }
}

impl<S: Scalar, const U: usize, const J: usize> VectorSpace<S> for Sampled<S, U, J> {
    #[inline]
    fn add_scaled(&mut self, factor: S, other: &Self) {
        self.inputs.add_scaled(factor, &other.inputs);
        self.memory.add_scaled(factor, &other.memory);
        self.samplings += factor * other.samplings;
    }

    #[inline]
    fn map(&self, mut function: impl FnMut(S) -> S) -> Self {
        Self {
            inputs: self.inputs.map(&mut function),
            memory: self.memory.map(&mut function),
            samplings: function(self.samplings),
        }
    }

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        let held = self.inputs.iter().chain(self.memory.iter()).copied();
        held.chain(core::iter::once(self.samplings))
    }
}

impl<S: Scalar, const U: usize, const J: usize> LawStates<S> for Sampled<S, U, J> {}

impl<const L: usize, const U: usize, const J: usize> LaneStates<L> for Sampled<Lanes<L>, U, J> {
    type Lane = Sampled<f64, U, J>;

    fn broadcast(state: &Self::Lane) -> Self {
        Self {
            inputs: LaneStates::broadcast(&state.inputs),
            memory: LaneStates::broadcast(&state.memory),
            samplings: Lanes::from_f64(state.samplings),
        }
    }

    fn lane(&self, lane: usize) -> Self::Lane {
        Sampled {
            inputs: self.inputs.lane(lane),
            memory: self.memory.lane(lane),
            samplings: self.samplings.lane(lane),
        }
    }

    fn set_lane(&mut self, lane: usize, state: &Self::Lane) {
        self.inputs.set_lane(lane, &state.inputs);
        self.memory.set_lane(lane, &state.memory);
        self.samplings.set(lane, state.samplings);
    }
}

impl<const L: usize, const U: usize, const J: usize> StatesInLanes<L> for Sampled<f64, U, J> {
    type InLanes = Sampled<Lanes<L>, U, J>;
}

impl<F, A, S, const N: usize, const U: usize, const J: usize> Law<N, SVector<S, U>, S>
    for SampledFeedback<F, U, J>
where
    F: Fn(&State<S, N>, &mut SVector<S, J>) -> A,
    A: IntoVector<S, U>,
    S: Scalar,
{
    type States = Sampled<S, U, J>;

    /// The controller reads the full angles only where it is sampled.
    const READS_MOTION: bool = false;

    #[inline]
    fn evaluate(
        &self,
        _: &SVector<S, U>,
        _: S,
        x: &Phase<S, N, Sampled<S, U, J>>,
    ) -> (SVector<S, U>, Sampled<S, U, J>) {
        (x.z.inputs, x.z.zeroed())
    }

    fn check(&self) -> Result<(), IntegrationError> {
        let period = self.period;
        if period > 0.0 && period.is_finite() {
            Ok(())
        } else {
            Err(IntegrationError::InvalidPeriod { period })
        }
    }

    /// The next multiple of the period.
    fn next_update(&self, z: &Sampled<S, U, J>) -> Option<f64> {
        Some(self.start + z.samplings.smallest() * self.period)
    }

    fn update(&self, t: S, x: &mut Phase<S, N, Sampled<S, U, J>>) {
        x.z.inputs = (self.law)(&x.at_time(t), &mut x.z.memory).into_vector();
        x.z.samplings += S::one();
    }

    /// Between two samplings, the inputs are constant.
    fn series<const HALF: usize, R>(
        &self,
        _: &SVector<S, U>,
        (_, x): (S, &Phase<S, N, Sampled<S, U, J>>),
        _: S,
        then: impl FnOnce(&[SVector<S, U>], &[Sampled<S, U, J>]) -> R,
    ) -> Option<R> {
        Some(then(core::slice::from_ref(&x.z.inputs), &[]))
    }
}

/// Motions that share their steps in lanes cannot end them at their own samplings; in an [`Ensemble`](crate::Ensemble),
/// each motion has its own steps.
impl<F, A, S, const N: usize, const U: usize, const J: usize> LawSeries<N, SVector<S, U>, S>
    for SampledFeedback<F, U, J>
where
    F: Fn(&State<S, N>, &mut SVector<S, J>) -> A,
    A: IntoVector<S, U>,
    S: SingleNumber,
{
}
