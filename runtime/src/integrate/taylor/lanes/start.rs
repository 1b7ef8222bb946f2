//! The beginnings of motions in lanes.

use super::{TaylorLanes, any, lanes, non_finite};
use crate::integrate::error::IntegrationError;
use crate::integrate::taylor::Series;
use crate::integrate::taylor::step_size::unit_near;
use crate::integrate::tolerance::{Tolerance, largest_ratios, time_scale};
use crate::limits::taylor::FIRST_UNIT;
use crate::linalg::LaneStates;
use crate::scalar::Lanes;

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Checks new lanes, and chooses their first units of time.
    #[inline]
    pub(super) fn begin<D>(&mut self, dynamics: &D)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        if any(&self.is_new) {
            self.begin_new(dynamics);
        }
    }

    #[cold]
    fn begin_new<D>(&mut self, dynamics: &D)
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let derivative = self.derivative(dynamics);
        let tolerance = self.method.tolerance::<Lanes<L>>();
        let state = self.state.value();
        let rates = tolerance.rates(dynamics, state, &derivative);
        let allowed = dynamics.allowed_error(state, &tolerance.over(Lanes([1.0; L])));
        let largest = tolerance.relative.max(tolerance.absolute);
        let ratios = largest_ratios(&derivative, &Tolerance::weights(&allowed));
        for lane in lanes(&core::mem::replace(&mut self.is_new, [false; L])) {
            self.statistics[lane].evaluations += 1;
            if let Some(error) = self.setting_error(dynamics, lane, &derivative) {
                self.fail(lane, error);
            }
            let time = match rates {
                Some(rates) => time_scale(rates.map(|rates| rates.0[lane])),
                None => 1.0 / (ratios.0[lane] * largest),
            };
            let usable = Some(time).filter(|time| time.is_normal());
            self.time_scale[lane] = usable.unwrap_or(1.0 / FIRST_UNIT);
            self.unit[lane] = unit_near(FIRST_UNIT * self.time_scale[lane]);
            self.check_start(dynamics, lane);
        }
    }

    pub(super) fn derivative<D>(&self, dynamics: &D) -> X
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let value = self.state.value();
        dynamics.derivative(Lanes(self.time), &dynamics.reduced(value, &value.zeroed()))
    }

    /// Returns an error in the settings of the method, the time, the state or its derivative in a lane, if there is
    /// one.
    pub(super) fn setting_error<D>(
        &self,
        dynamics: &D,
        lane: usize,
        derivative: &X,
    ) -> Option<IntegrationError>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let time = self.time[lane];
        if let Err(error) = self.method.check() {
            return Some(error);
        }
        if !time.is_finite() {
            return Some(IntegrationError::NonFiniteTime { time });
        }
        if let Some((index, value)) = non_finite(self.state.value(), lane) {
            let component = dynamics.component_name(index);
            return Some(IntegrationError::NonFiniteState {
                time,
                component,
                value,
            });
        }
        non_finite(derivative, lane).map(|(index, value)| IntegrationError::NonFiniteDerivative {
            time,
            component: dynamics.component_name(index),
            value,
        })
    }
}
