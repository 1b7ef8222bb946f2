//! The laws of several members, one in each SIMD lane.

use nalgebra::SVector;

use super::{Law, LawSeries, LawStates};
use crate::linalg::{LaneStates, VectorSpace as _};
use crate::model::phase::Phase;
use crate::scalar::{Lanes, Scalar as _};

/// The states of a law that is integrated in `L` lanes.
pub trait StatesInLanes<const L: usize>: LawStates<f64> {
    /// The states in all lanes.
    type InLanes: LawStates<Lanes<L>> + LaneStates<L, Lane = Self>;
}

impl<const L: usize> StatesInLanes<L> for () {
    type InLanes = ();
}

impl<const K: usize, const L: usize> StatesInLanes<L> for SVector<f64, K> {
    type InLanes = SVector<Lanes<L>, K>;
}

impl<A: StatesInLanes<L>, B: StatesInLanes<L>, const L: usize> StatesInLanes<L> for (A, B) {
    type InLanes = (A::InLanes, B::InLanes);
}

/// The law of each lane. Lanes are updated by their members.
#[derive(Clone, Copy, Debug)]
pub struct LawsInLanes<'a, W, const L: usize>(&'a [W; L]);

impl<'a, W, const L: usize> LawsInLanes<'a, W, L> {
    pub(in crate::model) fn new(laws: &'a [W; L]) -> Self {
        Self(laws)
    }
}

impl<W, const N: usize, const U: usize, const L: usize> Law<N, SVector<Lanes<L>, U>, Lanes<L>>
    for LawsInLanes<'_, W, L>
where
    W: Law<N, SVector<f64, U>, f64, States: StatesInLanes<L>>,
{
    type States = <W::States as StatesInLanes<L>>::InLanes;

    const READS_MOTION: bool = W::READS_MOTION;

    #[inline]
    fn evaluate(
        &self,
        given: &SVector<Lanes<L>, U>,
        t: Lanes<L>,
        x: &Phase<Lanes<L>, N, Self::States>,
    ) -> (SVector<Lanes<L>, U>, Self::States) {
        let mut evaluated = (*given, x.z.zeroed());
        if W::IS_HELD {
            return evaluated;
        }
        for (lane, law) in self.0.iter().enumerate() {
            let (inputs, rates) = law.evaluate(&given.lane(lane), t.lane(lane), &x.lane(lane));
            evaluated.0.set_lane(lane, &inputs);
            evaluated.1.set_lane(lane, &rates);
        }
        evaluated
    }

    fn series<const HALF: usize, R>(
        &self,
        given: &SVector<Lanes<L>, U>,
        (t, x): (Lanes<L>, &Phase<Lanes<L>, N, Self::States>),
        unit: Lanes<L>,
        then: impl FnOnce(&[SVector<Lanes<L>, U>], &[Self::States]) -> R,
    ) -> Option<R> {
        if W::IS_HELD {
            return Some(then(core::slice::from_ref(given), &[]));
        }
        let zero = x.z.zeroed();
        let mut inputs = [[SVector::from_element(Lanes::from_f64(0.0)); 2]; HALF];
        let mut states: [[Self::States; 2]; HALF] =
            core::array::from_fn(|_| core::array::from_fn(|_| zero.clone()));
        let inputs: &mut [SVector<Lanes<L>, U>] = inputs.as_flattened_mut();
        let states: &mut [Self::States] = states.as_flattened_mut();
        let (mut orders, mut known) = ([0, 0], true);
        for (lane, law) in self.0.iter().enumerate() {
            let motion = (t.lane(lane), &x.lane(lane));
            let of_lane = law.series::<HALF, ()>(
                &given.lane(lane),
                motion,
                unit.lane(lane),
                |of_inputs, of_states| {
                    orders[0] = orders[0].max(of_inputs.len());
                    orders[1] = orders[1].max(of_states.len());
                    for (all, one) in inputs.iter_mut().zip(of_inputs) {
                        all.set_lane(lane, one);
                    }
                    for (all, one) in states.iter_mut().zip(of_states) {
                        all.set_lane(lane, one);
                    }
                },
            );
            known &= of_lane.is_some();
        }
        let inputs = inputs.get(..orders[0])?;
        let states = states.get(..orders[1])?;
        known.then(|| then(inputs, states))
    }
}

impl<W, const N: usize, const U: usize, const L: usize> LawSeries<N, SVector<Lanes<L>, U>, Lanes<L>>
    for LawsInLanes<'_, W, L>
where
    W: LawSeries<N, SVector<f64, U>, f64, States: StatesInLanes<L>>,
{
}
