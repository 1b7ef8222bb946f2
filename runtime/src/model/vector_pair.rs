//! States of two vectors: coordinates, and velocities or momenta.

/// Implements the constructor, [`VectorSpace`](crate::VectorSpace) and [`LaneStates`](crate::linalg::LaneStates) of a struct with
/// the coordinates `q` and a second vector of that name; its own methods of `VectorSpace` stand in braces.
macro_rules! vector_pair {
    ($phase:ident, $second:ident, { $($own:item)* }) => {
        impl<S: Scalar, const N: usize> $phase<S, N> {
            #[doc = concat!("That of these `q` and `", stringify!($second), "`, arrays or vectors.")]
            pub fn new(q: impl IntoVector<S, N>, $second: impl IntoVector<S, N>) -> Self {
                Self {
                    q: q.into_vector(),
                    $second: $second.into_vector(),
                }
            }
        }

        impl<S: Scalar, const N: usize> VectorSpace<S> for $phase<S, N> {
            #[inline]
            fn add_scaled(&mut self, factor: S, other: &Self) {
                self.q.add_scaled(factor, &other.q);
                self.$second.add_scaled(factor, &other.$second);
            }

            #[inline]
            fn map(&self, mut function: impl FnMut(S) -> S) -> Self {
                Self {
                    q: self.q.map(&mut function),
                    $second: self.$second.map(&mut function),
                }
            }

            #[inline]
            fn zip_map(&self, other: &Self, mut function: impl FnMut(S, S) -> S) -> Self {
                Self {
                    q: VectorSpace::zip_map(&self.q, &other.q, &mut function),
                    $second: VectorSpace::zip_map(&self.$second, &other.$second, &mut function),
                }
            }

            #[inline]
            fn components(&self) -> impl Iterator<Item = S> + '_ {
                self.q.iter().chain(self.$second.iter()).copied()
            }

            $($own)*
        }

        impl<const L: usize, const N: usize> LaneStates<L> for $phase<Lanes<L>, N> {
            type Lane = $phase<f64, N>;

            #[inline]
            fn broadcast(state: &Self::Lane) -> Self {
                Self {
                    q: LaneStates::broadcast(&state.q),
                    $second: LaneStates::broadcast(&state.$second),
                }
            }

            #[inline]
            fn lane(&self, lane: usize) -> Self::Lane {
                $phase {
                    q: self.q.lane(lane),
                    $second: self.$second.lane(lane),
                }
            }

            #[inline]
            fn set_lane(&mut self, lane: usize, state: &Self::Lane) {
                self.q.set_lane(lane, &state.q);
                self.$second.set_lane(lane, &state.$second);
            }
        }
    };
}
pub(super) use vector_pair;
