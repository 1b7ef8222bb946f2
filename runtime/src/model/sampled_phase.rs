//! Coordinates and velocities, and what a sampled controller holds.

use nalgebra::SVector;

use super::phase::Phase;
use super::state::State;
use crate::integrate::At;
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// Coordinates q and velocities q̇ of a system with `N` degrees of freedom, the `U` inputs that a sampled controller holds
/// and its memory of `J` numbers: the state under [`Problem::sampled_feedback`](crate::Problem::sampled_feedback).
///
/// Its components are the coordinates, the velocities, the inputs, the memory, then the number of samplings.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>"
    ))
)]
pub struct SampledPhase<S: Scalar, const N: usize, const U: usize, const J: usize> {
    /// Coordinates q.
    pub q: SVector<S, N>,
    /// Velocities q̇.
    pub v: SVector<S, N>,
    /// The inputs, held since the last sampling.
    pub inputs: SVector<S, U>,
    /// The memory of the controller.
    pub memory: SVector<S, J>,
    /// How often the controller was evaluated.
    pub samplings: S,
}

impl<S: Scalar, const N: usize, const U: usize, const J: usize> SampledPhase<S, N, U, J> {
    /// A phase before the first sampling.
    pub(super) fn before_sampling(phase: Phase<S, N>, memory: SVector<S, J>) -> Self {
        Self {
            memory,
            ..Self::moving(phase)
        }
    }

    /// The phase, where nothing else is or changes.
    #[inline]
    pub(super) fn moving(Phase { q, v }: Phase<S, N>) -> Self {
        Self {
            q,
            v,
            inputs: SVector::repeat(S::zero()),
            memory: SVector::repeat(S::zero()),
            samplings: S::zero(),
        }
    }

    /// Coordinates and velocities alone.
    #[inline]
    #[must_use]
    pub fn phase(&self) -> Phase<S, N> {
        Phase {
            q: self.q,
            v: self.v,
        }
    }

    /// The state of the mechanical system at time `t`.
    #[inline]
    pub(crate) fn at(&self, t: S) -> State<S, N> {
        self.phase().at(t)
    }
}

impl<S: Scalar, const N: usize, const U: usize, const J: usize> At<S, SampledPhase<S, N, U, J>> {
    /// The state of the mechanical system alone.
    #[inline]
    #[must_use]
    pub fn state(&self) -> State<S, N> {
        self.x.at(self.t)
    }
}

impl<S: Scalar, const N: usize, const U: usize, const J: usize> VectorSpace<S>
    for SampledPhase<S, N, U, J>
{
    #[inline]
    fn add_scaled(&mut self, factor: S, other: &Self) {
        self.q.add_scaled(factor, &other.q);
        self.v.add_scaled(factor, &other.v);
        self.inputs.add_scaled(factor, &other.inputs);
        self.memory.add_scaled(factor, &other.memory);
        self.samplings += factor * other.samplings;
    }

    #[inline]
    fn map(&self, mut function: impl FnMut(S) -> S) -> Self {
        Self {
            q: self.q.map(&mut function),
            v: self.v.map(&mut function),
            inputs: self.inputs.map(&mut function),
            memory: self.memory.map(&mut function),
            samplings: function(self.samplings),
        }
    }

    #[inline]
    fn zip_map(&self, other: &Self, mut function: impl FnMut(S, S) -> S) -> Self {
        Self {
            q: VectorSpace::zip_map(&self.q, &other.q, &mut function),
            v: VectorSpace::zip_map(&self.v, &other.v, &mut function),
            inputs: VectorSpace::zip_map(&self.inputs, &other.inputs, &mut function),
            memory: VectorSpace::zip_map(&self.memory, &other.memory, &mut function),
            samplings: function(self.samplings, other.samplings),
        }
    }

    #[inline]
    fn components(&self) -> impl Iterator<Item = S> + '_ {
        let motion = self.q.iter().chain(self.v.iter());
        let held = motion.chain(self.inputs.iter()).chain(self.memory.iter());
        held.copied().chain(core::iter::once(self.samplings))
    }

    #[inline]
    fn allowed_error(&self, tolerance: &ErrorTolerance<S>) -> Self {
        let Phase { q, v } = self.phase().allowed_error(tolerance);
        let of_held = self.map(|held| tolerance.of_coordinate(held.abs()));
        Self { q, v, ..of_held }
    }

    fn rate(&self, sizes: &Self) -> Option<S> {
        self.phase().rate(&sizes.phase())
    }
}
