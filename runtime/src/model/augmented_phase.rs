//! Coordinates, velocities, and further components: the states of a controller.

use nalgebra::SVector;

use super::phase::Phase;
use super::state::State;
use crate::integrate::{At, TypicalSizes};
use crate::linalg::{ErrorTolerance, IntoVector, LaneStates, VectorSpace};
use crate::scalar::{Lanes, Scalar};

/// Coordinates q and velocities q̇ of a system with `N` degrees of freedom, and the `K` states z of its
/// controller: the state that an integrator steps under [`WithController`](crate::WithController).
///
/// At a time, it is made from a pair of a [`State`] and z:
///
/// ```
/// use lagrangian::{At, AugmentedPhase, State};
///
/// let state = State::new(2.0, [0.5], [0.0]);
/// let start: At<f64, AugmentedPhase<f64, 1, 2>> = (state, [0.0, 0.25]).into();
/// assert_eq!(start.state(), state);
/// assert_eq!(start.controller[1], 0.25);
/// ```
///
/// Its components are the coordinates, the velocities, then the states of the controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "S: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de>"
    ))
)]
pub struct AugmentedPhase<S: Scalar, const N: usize, const K: usize> {
    /// Coordinates q.
    pub q: SVector<S, N>,
    /// Velocities q̇.
    pub v: SVector<S, N>,
    /// The states z of the controller.
    pub controller: SVector<S, K>,
}

/// What a phase with further components `$more` is to an integrator.
macro_rules! further_components {
    ($phase:ident, $more:ident) => {
        impl<S: Scalar, const N: usize, const K: usize> $phase<S, N, K> {
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
            #[must_use]
            pub(crate) fn at(&self, t: S) -> State<S, N> {
                self.phase().at(t)
            }
        }

        impl<S: Scalar, const N: usize, const K: usize> VectorSpace<S> for $phase<S, N, K> {
            #[inline]
            fn add_scaled(&mut self, factor: S, other: &Self) {
                self.q.add_scaled(factor, &other.q);
                self.v.add_scaled(factor, &other.v);
                self.$more.add_scaled(factor, &other.$more);
            }

            #[inline]
            fn map(&self, mut function: impl FnMut(S) -> S) -> Self {
                Self {
                    q: self.q.map(&mut function),
                    v: self.v.map(&mut function),
                    $more: self.$more.map(&mut function),
                }
            }

            #[inline]
            fn zip_map(&self, other: &Self, mut function: impl FnMut(S, S) -> S) -> Self {
                let Self { q, v, $more } = self;
                Self {
                    q: VectorSpace::zip_map(q, &other.q, &mut function),
                    v: VectorSpace::zip_map(v, &other.v, &mut function),
                    $more: VectorSpace::zip_map($more, &other.$more, &mut function),
                }
            }

            #[inline]
            fn components(&self) -> impl Iterator<Item = S> + '_ {
                let motion = self.q.iter().chain(self.v.iter());
                motion.chain(self.$more.iter()).copied()
            }

            #[inline]
            fn allowed_error(&self, tolerance: &ErrorTolerance<S>) -> Self {
                let Phase { q, v } = self.phase().allowed_error(tolerance);
                let $more = self.$more.map(|z| tolerance.of_coordinate(z.abs()));
                Self { q, v, $more }
            }

            fn rate(&self, sizes: &Self) -> Option<S> {
                self.phase().rate(&sizes.phase())
            }
        }

        impl<const L: usize, const N: usize, const K: usize> LaneStates<L>
            for $phase<Lanes<L>, N, K>
        {
            type Lane = $phase<f64, N, K>;

            #[inline]
            fn broadcast(state: &Self::Lane) -> Self {
                Self {
                    q: LaneStates::broadcast(&state.q),
                    v: LaneStates::broadcast(&state.v),
                    $more: LaneStates::broadcast(&state.$more),
                }
            }

            #[inline]
            fn lane(&self, lane: usize) -> Self::Lane {
                $phase {
                    q: self.q.lane(lane),
                    v: self.v.lane(lane),
                    $more: self.$more.lane(lane),
                }
            }

            #[inline]
            fn set_lane(&mut self, lane: usize, state: &Self::Lane) {
                self.q.set_lane(lane, &state.q);
                self.v.set_lane(lane, &state.v);
                self.$more.set_lane(lane, &state.$more);
            }
        }

        impl<S: Scalar, const N: usize, const K: usize> At<S, $phase<S, N, K>> {
            /// The state of the mechanical system alone.
            #[inline]
            #[must_use]
            pub fn state(&self) -> State<S, N> {
                self.x.at(self.t)
            }
        }

        /// The state of the mechanical system, and the further components.
        impl<S, C, const N: usize, const K: usize> From<(State<S, N>, C)> for At<S, $phase<S, N, K>>
        where
            S: Scalar,
            C: IntoVector<S, K>,
        {
            fn from((state, $more): (State<S, N>, C)) -> Self {
                let Phase { q, v } = state.x;
                let $more = $more.into_vector();
                let x = $phase { q, v, $more };
                Self { t: state.t, x }
            }
        }

        /// Of the coordinates, and of the further components.
        impl<S: Scalar, const N: usize, const K: usize> TypicalSizes<$phase<S, N, K>>
            for ([f64; N], [f64; K])
        {
            fn into_state(self) -> $phase<S, N, K> {
                let sizes = SVector::from(self.0.map(S::from_f64));
                $phase {
                    q: sizes,
                    v: sizes,
                    $more: SVector::from(self.1.map(S::from_f64)),
                }
            }
        }
    };
}
pub(super) use further_components;

further_components!(AugmentedPhase, controller);
