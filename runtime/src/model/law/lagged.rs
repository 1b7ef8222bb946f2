//! Actuators that follow a law with a lag.

use nalgebra::SVector;

use super::{Law, LawSeries};
use crate::integrate::IntegrationError;
use crate::linalg::VectorSpace;
use crate::model::phase::Phase;
use crate::scalar::Scalar;

/// A law whose `U` inputs follow another law with first-order lags; constructed by
/// [`Problem::lagged`](crate::Problem::lagged).
///
/// u̇ = (a − u)/τ, where a is the output of the other law. The inputs u are states, after the states of the other law.
#[derive(Clone, Copy, Debug)]
pub struct Lagged<L, S: Scalar, const U: usize> {
    pub(crate) law: L,
    /// The time constants τ.
    pub(crate) time_constants: SVector<S, U>,
}

/// Returns the phase without the lagged inputs.
fn asking<S: Scalar, Z: Clone, V, const N: usize>(x: &Phase<S, N, (Z, V)>) -> Phase<S, N, Z> {
    x.motion().with(x.z.0.clone())
}

impl<L, S, const N: usize, const U: usize> Law<N, SVector<S, U>, S> for Lagged<L, S, U>
where
    L: Law<N, SVector<S, U>, S>,
    S: Scalar,
{
    type States = (L::States, SVector<S, U>);

    const READS_MOTION: bool = L::READS_MOTION;

    #[inline]
    fn evaluate(
        &self,
        given: &SVector<S, U>,
        t: S,
        x: &Phase<S, N, Self::States>,
    ) -> (SVector<S, U>, Self::States) {
        let (asked, rates) = self.law.evaluate(given, t, &asking(x));
        let inputs = x.z.1;
        let lag = (asked - inputs).component_div(&self.time_constants);
        (inputs, (rates, lag))
    }

    fn check(&self) -> Result<(), IntegrationError> {
        let mut time_constants = self.time_constants.iter().enumerate();
        let invalid = time_constants.find_map(|(input, time_constant)| {
            let lanes = [time_constant.smallest(), time_constant.largest()];
            let refused = lanes
                .into_iter()
                .find(|tau| !(tau.is_finite() && *tau > 0.0));
            refused.map(|time_constant| IntegrationError::InvalidTimeConstant {
                input,
                time_constant,
            })
        });
        invalid.map_or_else(|| self.law.check(), Err)
    }

    fn next_update(&self, z: &Self::States) -> Option<f64> {
        self.law.next_update(&z.0)
    }

    fn update(&self, t: S, x: &mut Phase<S, N, Self::States>) {
        let mut inner = asking(x);
        self.law.update(t, &mut inner);
        let Phase { q, v, z } = inner;
        (x.q, x.v, x.z.0) = (q, v, z);
    }

    /// Solves τ u̇ + u = a term by term, where a is the series of the followed law.
    fn series<const HALF: usize, R>(
        &self,
        given: &SVector<S, U>,
        (t, x): (S, &Phase<S, N, Self::States>),
        unit: S,
        then: impl FnOnce(&[SVector<S, U>], &[Self::States]) -> R,
    ) -> Option<R> {
        let inner = asking(x);
        self.law
            .series::<HALF, R>(given, (t, &inner), unit, |asked, rates| {
                let zero = (inner.z.zeroed(), SVector::from_element(S::zero()));
                let mut states: [[Self::States; 2]; HALF] =
                    core::array::from_fn(|_| core::array::from_fn(|_| zero.clone()));
                let mut inputs = [[zero.1; 2]; HALF];
                let (mut last, mut order) = (x.z.1, S::zero());
                let mut rates = rates.iter();
                let terms = states.as_flattened_mut().iter_mut();
                for (k, (state, input)) in terms.zip(inputs.as_flattened_mut()).enumerate() {
                    *input = last;
                    order += S::one();
                    let asked = asked.get(k).copied().unwrap_or(zero.1);
                    last = (asked - last).component_div(&self.time_constants) * (unit / order);
                    state.1 = last;
                    if let Some(rate) = rates.next() {
                        state.0 = rate.clone();
                    }
                }
                then(inputs.as_flattened(), states.as_flattened())
            })
    }
}

impl<L, S, const N: usize, const U: usize> LawSeries<N, SVector<S, U>, S> for Lagged<L, S, U>
where
    L: LawSeries<N, SVector<S, U>, S>,
    S: Scalar,
{
}
