//! Ensembles of models with different parameters.

use nalgebra::SVector;

use super::equations_of_motion::EquationsOfMotion;
use super::lagrangian::Lagrangian;
use super::members_in_lanes::MembersInLanes;
use super::motion_series::MotionSeries;
use super::phase::Phase;
use super::quantities::Quantities;
use super::state::State;
use crate::integrate::{Ensemble, IntegrationError, Running, Solution};
use crate::scalar::Lanes;

impl<const L: usize, const HALF: usize> Ensemble<L, HALF> {
    /// Integrates motions of a model of plain numbers, each with parameters and inputs of its own, from its initial value to its
    /// final time.
    ///
    /// The position of a motion among `motions` and its outcome, or its error, are passed to `report`, in the order in which
    /// they end. A motion has the result that it has alone in such an ensemble, to the last bit. An invalid setting is an error of every motion.
    ///
    /// What depends on parameters alone is computed once for each motion. A model whose external functions read `self` is refused
    /// at compile time ([`MembersInLanes`]).
    pub fn run_members<M, const N: usize, const U: usize>(
        &self,
        motions: impl IntoIterator<Item = (M, State<f64, N>, f64)>,
        report: impl FnMut(usize, Result<Solution<f64, Phase<f64, N>>, IntegrationError>),
    ) where
        M: MembersInLanes
            + Quantities<N, f64, Inputs = SVector<f64, U>>
            + MotionSeries<N, Lanes<L>, Inputs = SVector<Lanes<L>, U>>
            + Lagrangian<N, Lanes<L>, Model = M>,
    {
        let mut running =
            Running::<Phase<Lanes<L>, N>, _, _, L, HALF>::new(self, motions.into_iter(), report);
        let mut equations: Option<EquationsOfMotion<M, Lanes<L>, N>> = None;
        while running.fill(|lane, (member, initial, end)| {
            match &mut equations {
                Some(equations) => equations.set_lane(lane, &member),
                none => *none = Some(EquationsOfMotion::of_member(member)),
            }
            (initial, end)
        }) {
            let Some(equations) = &equations else { return };
            running.advance(equations);
        }
    }

    /// Integrates motions of a model whose struct is generic over its scalar and whose parameters are [`Lanes`], with parameters of
    /// its own for each motion. [`run_members`](Self::run_members) does the same for structs of plain numbers.
    ///
    /// `begin` sets the parameters of a motion, in a lane of the model, and returns its initial value and final time. The
    /// position of a motion among `motions` and its outcome, or its error, are passed to `report`, in the order in which
    /// they end. An invalid setting is an error of every motion.
    ///
    /// What depends on parameters alone is computed again, for all lanes, whenever a motion begins.
    pub fn run_with_parameters<M, P, const N: usize>(
        &self,
        model: &mut M,
        motions: impl IntoIterator<Item = P>,
        mut begin: impl FnMut(&mut M, usize, P) -> (State<f64, N>, f64),
        report: impl FnMut(usize, Result<Solution<f64, Phase<f64, N>>, IntegrationError>),
    ) where
        M: Lagrangian<N, Lanes<L>, Model: MotionSeries<N, Lanes<L>>>,
    {
        let mut running =
            Running::<Phase<Lanes<L>, N>, _, _, L, HALF>::new(self, motions.into_iter(), report);
        while running.fill(|lane, motion| {
            let (initial, end) = begin(model, lane, motion);
            (initial, end)
        }) {
            running.advance(&model.dynamics());
        }
    }
}
