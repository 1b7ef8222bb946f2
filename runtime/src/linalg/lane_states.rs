//! States of several motions at once, one in each lane.

use nalgebra::SVector;

use super::horner;
use super::vector_space::VectorSpace;
use crate::scalar::{Lanes, Scalar};

/// A state whose components are [`Lanes`]: the states of `L` motions, which can be read and set one by one.
///
/// ```
/// use lagrangian::{LaneStates, Lanes};
/// use lagrangian::nalgebra::SVector;
///
/// let mut states: SVector<Lanes<4>, 2> = LaneStates::broadcast(&SVector::from([1.0, 2.0]));
/// states.set_lane(3, &SVector::from([5.0, 6.0]));
/// assert_eq!(states[0], Lanes([1.0, 1.0, 1.0, 5.0]));
/// assert_eq!(states.lane(3), SVector::from([5.0, 6.0]));
/// ```
pub trait LaneStates<const L: usize>: VectorSpace<Lanes<L>> {
    /// The state of one motion.
    type Lane: VectorSpace<f64>;

    /// Returns this state in every lane.
    #[must_use]
    fn broadcast(state: &Self::Lane) -> Self;

    /// Returns the state in a lane; NaN if there is no such lane.
    #[must_use]
    fn lane(&self, lane: usize) -> Self::Lane;

    /// Sets the state in a lane; does nothing if there is no such lane.
    fn set_lane(&mut self, lane: usize, state: &Self::Lane);

    /// Returns x(τ) − x(0) and dx/dτ, for pairs of coefficients of odd and even order from order 1 on.
    ///
    /// States that are vectors compute one component after the other, whose sums stay in registers.
    #[inline]
    fn change_and_derivative<'a>(
        &self,
        pairs: impl DoubleEndedIterator<Item = [&'a Self; 2]> + Clone,
        tau: Lanes<L>,
    ) -> [Self; 2]
    where
        Self: 'a,
    {
        horner::change_and_derivative(pairs, tau, self.zeroed(), |x, tau, higher| {
            let mut sum = x.clone();
            sum.add_scaled(tau, higher);
            sum
        })
    }
}

/// Implements `LaneStates` for a struct whose fields have lanes.
macro_rules! lanes_by_fields {
    ([$($generics:tt)*] $states:ty => $state:ident<$($lane:ty),*> { $($field:ident),* }) => {
        impl<const L: usize, $($generics)*> LaneStates<L> for $states {
            type Lane = $state<$($lane),*>;

            #[inline]
            fn broadcast(state: &Self::Lane) -> Self {
                Self { $($field: LaneStates::broadcast(&state.$field)),* }
            }

            #[inline]
            fn lane(&self, lane: usize) -> Self::Lane {
                $state { $($field: self.$field.lane(lane)),* }
            }

            #[inline]
            fn set_lane(&mut self, lane: usize, state: &Self::Lane) {
                $(self.$field.set_lane(lane, &state.$field);)*
            }

            #[inline]
            fn change_and_derivative<'a>(
                &self,
                pairs: impl DoubleEndedIterator<Item = [&'a Self; 2]> + Clone,
                tau: Lanes<L>,
            ) -> [Self; 2]
            where
                Self: 'a,
            {
                let mut found = [self.clone(), self.clone()];
                $({
                    let pairs = pairs.clone().map(|pair| pair.map(|states| &states.$field));
                    let [change, derivative] = self.$field.change_and_derivative(pairs, tau);
                    (found[0].$field, found[1].$field) = (change, derivative);
                })*
                found
            }
        }
    };
}
pub(crate) use lanes_by_fields;

impl<const L: usize, const D: usize> LaneStates<L> for SVector<Lanes<L>, D> {
    type Lane = SVector<f64, D>;

    #[inline]
    fn broadcast(state: &Self::Lane) -> Self {
        state.map(Lanes::from_f64)
    }

    #[inline]
    fn lane(&self, lane: usize) -> Self::Lane {
        // One number is read in place: a component that is passed by value is copied to the stack, with all its lanes.
        let number = |component: &Lanes<L>| component.0.get(lane).copied();
        SVector::from_fn(|i, _| number(&self[i]).unwrap_or(f64::NAN))
    }

    #[inline]
    fn set_lane(&mut self, lane: usize, state: &Self::Lane) {
        for (component, number) in self.iter_mut().zip(state.iter()) {
            component.set(lane, *number);
        }
    }

    #[inline]
    fn change_and_derivative<'a>(
        &self,
        pairs: impl DoubleEndedIterator<Item = [&'a Self; 2]> + Clone,
        tau: Lanes<L>,
    ) -> [Self; 2] {
        let mut found = [*self; 2];
        for i in 0..D {
            let pairs = pairs.clone().map(|[odd, even]| [&odd[i], &even[i]]);
            let zero = Lanes::from_f64(0.0);
            let plus = |x: &Lanes<L>, tau: Lanes<L>, y: &Lanes<L>| tau.mul_add(*y, *x);
            [found[0][i], found[1][i]] = horner::change_and_derivative(pairs, tau, zero, plus);
        }
        found
    }
}

impl<const L: usize> LaneStates<L> for () {
    type Lane = ();

    #[inline]
    fn broadcast((): &Self::Lane) -> Self {}

    #[inline]
    fn lane(&self, _: usize) -> Self::Lane {}

    #[inline]
    fn set_lane(&mut self, _: usize, (): &Self::Lane) {}
}

impl<const L: usize, A: LaneStates<L>, B: LaneStates<L>> LaneStates<L> for (A, B) {
    type Lane = (A::Lane, B::Lane);

    #[inline]
    fn broadcast((first, second): &Self::Lane) -> Self {
        (A::broadcast(first), B::broadcast(second))
    }

    #[inline]
    fn lane(&self, lane: usize) -> Self::Lane {
        (self.0.lane(lane), self.1.lane(lane))
    }

    #[inline]
    fn set_lane(&mut self, lane: usize, (first, second): &Self::Lane) {
        self.0.set_lane(lane, first);
        self.1.set_lane(lane, second);
    }

    #[inline]
    fn change_and_derivative<'a>(
        &self,
        pairs: impl DoubleEndedIterator<Item = [&'a Self; 2]> + Clone,
        tau: Lanes<L>,
    ) -> [Self; 2]
    where
        Self: 'a,
    {
        let first = pairs.clone().map(|pair| pair.map(|x| &x.0));
        let second = pairs.map(|pair| pair.map(|x| &x.1));
        let [change, derivative] = self.0.change_and_derivative(first, tau);
        let second = self.1.change_and_derivative(second, tau);
        let [of_change, of_derivative] = second;
        [(change, of_change), (derivative, of_derivative)]
    }
}
