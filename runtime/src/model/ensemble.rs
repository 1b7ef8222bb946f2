//! Ensembles of models with different parameters.

use super::lagrangian::Lagrangian;
use super::motion_series::MotionSeries;
use super::phase::Phase;
use super::state::State;
use crate::integrate::{Ensemble, IntegrationError, Running, Solution};
use crate::scalar::Lanes;

impl<const L: usize, const HALF: usize> Ensemble<L, HALF> {
    /// Integrates motions of a model whose parameters are [`Lanes`], with parameters of its own for each motion.
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
