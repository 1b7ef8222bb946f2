//! Equations of motion of several members of an ensemble, one in each SIMD lane.

use nalgebra::SVector;

use super::equations_of_motion::EquationsOfMotion;
use super::lagrangian::Lagrangian;
use super::law::{LawSeries, LawsInLanes, StatesInLanes};
use super::members_in_lanes::MembersInLanes;
use super::motion_series::MotionSeries;
use super::phase::Phase;
use super::quantities::Quantities;
use crate::integrate::InLanes;
use crate::linalg::LaneStates as _;
use crate::scalar::Lanes;

/// The quantities that the equations of all lanes read: inputs, the results of [`Quantities::prepare`] for each member,
/// and laws.
#[derive(Clone, Debug)]
pub struct ParametersInLanes<M, V, P, W, const L: usize> {
    /// The value that is made once for all members.
    made: M,
    inputs: V,
    prepared: P,
    laws: [W; L],
}

/// Quantities that depend only on parameters are computed on `f64`, so that a lane agrees bit for bit with its member
/// integrated alone.
impl<M, W, const N: usize, const U: usize, const L: usize> InLanes<L>
    for EquationsOfMotion<M, f64, N, W>
where
    M: Lagrangian<N, f64>,
    M::Model: MotionSeries<N, f64, Inputs = SVector<f64, U>> + MembersInLanes<L>,
    ModelOf<M, N, L>: MotionSeries<N, Lanes<L>, Inputs = SVector<Lanes<L>, U>>
        + Lagrangian<N, Lanes<L>, Model = ModelOf<M, N, L>>,
    W: LawSeries<N, SVector<f64, U>, f64, States: StatesInLanes<L>> + Clone,
{
    type States = Phase<Lanes<L>, N, <W::States as StatesInLanes<L>>::InLanes>;

    type Parameters = ParametersInLanes<
        <M::Model as MembersInLanes<L>>::Made,
        SVector<Lanes<L>, U>,
        <ModelOf<M, N, L> as Quantities<N, Lanes<L>>>::Prepared,
        W,
        L,
    >;

    type Together<'a>
        = EquationsOfMotion<&'a ModelOf<M, N, L>, Lanes<L>, N, LawsInLanes<'a, W, L>>
    where
        Self: 'a;

    fn parameters(&self) -> Self::Parameters {
        let made = self.model.model().make();
        let mut parameters = ParametersInLanes {
            inputs: SVector::broadcast(&self.inputs),
            prepared: self.model.model().in_lanes(&made).prepare(),
            made,
            laws: core::array::from_fn(|_| self.law.clone()),
        };
        for lane in 0..L {
            self.set_lane(&mut parameters, lane);
        }
        parameters
    }

    fn set_lane(&self, parameters: &mut Self::Parameters, lane: usize) {
        let of_member = self.prepared.as_ref().iter();
        for (value, of_member) in parameters.prepared.as_mut().iter_mut().zip(of_member) {
            value.set(lane, *of_member);
        }
        parameters.inputs.set_lane(lane, &self.inputs);
        if let Some(law) = parameters.laws.get_mut(lane) {
            law.clone_from(&self.law);
        }
    }

    fn together<'a>(&'a self, parameters: &'a Self::Parameters) -> Self::Together<'a> {
        EquationsOfMotion {
            model: self.model.model().in_lanes(&parameters.made),
            inputs: parameters.inputs,
            prepared: parameters.prepared.clone(),
            law: LawsInLanes::new(&parameters.laws),
        }
    }
}

/// The model on which the lanes of a member are evaluated.
type ModelOf<M, const N: usize, const L: usize> =
    <<M as Lagrangian<N, f64>>::Model as MembersInLanes<L>>::InLanes;
