//! The steps of the Taylor series method.

use super::coefficients::number;
use super::{Series, Taylor, TaylorCoefficients};
use crate::integrate::compensated::{Clock, Compensated};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::{
    Advance, Statistics, Stepper, checked_derivative, checked_state, remaining,
};
use crate::integrate::tolerance::Tolerance;
use crate::limits::taylor::{
    FIRST_UNIT, LANDING, MIN_STEP, RESIDUAL_PER_ORDER, RESIDUAL_ROUNDING, SHORTENING, UNIT_CHANGE,
    UNIT_CHANGES,
};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// Takes the steps of a [`Taylor`] method.
///
/// Time and state are compensated sums, so that their rounding errors do not grow over a long integration.
#[derive(Clone, Debug)]
pub struct TaylorStepper<X, const HALF: usize> {
    method: Taylor<HALF>,
    clock: Clock,
    state: Compensated<X>,
    /// The unit of time of the next series, a power of two near the size of the step: the coefficients of a series
    /// then neither overflow nor underflow.
    unit: f64,
    /// The polynomial of the last step, about the reduced state.
    coefficients: TaylorCoefficients<X, HALF>,
    /// Where the last step began, and its unit of time.
    last: Option<(Clock, X, f64)>,
    statistics: Statistics,
}

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    const ORDER: usize = 2 * HALF;

    pub(super) fn new<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        method: Taylor<HALF>,
        dynamics: &D,
        t: f64,
        x: X,
    ) -> Result<Self, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let derivative = checked_derivative(dynamics, t, &x)?;
        let tolerance = method.tolerance::<S>();
        let scale = dynamics.error_scale(&x);
        let largest = tolerance.relative.max(tolerance.absolute);
        let rate = largest_ratio(tolerance, &derivative, &scale) * largest;
        let unit = if rate.is_normal() {
            power_of_two_near(FIRST_UNIT / rate)
        } else {
            1.0
        };
        Ok(Self {
            method,
            clock: Clock::new(t),
            coefficients: TaylorCoefficients::new(x.clone()),
            state: Compensated::new(x),
            unit,
            last: None,
            statistics: Statistics {
                evaluations: 1,
                ..Statistics::default()
            },
        })
    }

    /// Computes the polynomial about the present time, in a unit in which its coefficients are finite.
    fn expand<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
    ) -> Result<(), IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let time = self.clock.time();
        let from = self.state.reduced(dynamics);
        let mut non_finite = None;
        for _ in 0..UNIT_CHANGES {
            let (t, unit) = (S::from_f64(time), S::from_f64(self.unit));
            dynamics.series(t, &from, unit, &mut self.coefficients);
            self.statistics.evaluations += 1;
            let mut last = self.coefficients.higher().iter().rev().take(2);
            non_finite = last.find_map(VectorSpace::first_non_finite);
            if non_finite.is_none() {
                return Ok(());
            }
            self.unit *= UNIT_CHANGE;
        }
        checked_derivative(dynamics, time, self.state.value())?;
        Err(IntegrationError::NoTaylorSeries {
            time,
            component: dynamics.component_name(non_finite.map_or(0, |(index, _)| index)),
        })
    }

    /// The step at which the last two terms meet the tolerance, in units (Jorba & Zou 2005, section 3.2). Where they are
    /// zero, as in every other term of an even motion, the terms before count, down to half the order. If those are zero,
    /// too, the motion is a polynomial, as that of a stone, and the step infinite: whether it is one, shows at its end.
    fn proposed<S: Scalar>(&self, tolerance: Tolerance, scale: &X) -> f64
    where
        X: VectorSpace<S>,
    {
        let higher = self.coefficients.higher();
        let mut logarithm = f64::INFINITY;
        for (position, coefficient) in higher.iter().rev().enumerate().take(HALF) {
            let ratio = largest_ratio(tolerance, coefficient, scale);
            if ratio > 0.0 {
                let order = number(Self::ORDER - position);
                logarithm = logarithm.min(-Scalar::ln(ratio) / order);
            }
            if position > 0 && logarithm < f64::INFINITY {
                break;
            }
        }
        Scalar::exp(logarithm)
    }

    /// The scales to which the relative tolerance refers, of what the components reach within a step of about the unit.
    fn scale<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(&self, dynamics: &D) -> X
    where
        X: VectorSpace<S>,
    {
        let mut reached = self.state.value().map(Scalar::abs);
        for coefficient in self.coefficients.higher().iter().take(2) {
            reached.add_scaled(S::one(), &coefficient.map(Scalar::abs));
        }
        dynamics.error_scale(&reached)
    }

    /// Whether the derivative at the end of a step is that of the polynomial, up to what the tolerance and rounding
    /// explain; else the motion is not the one that the series at its beginning says.
    fn holds<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        (h, tau): (f64, S),
        state: &Compensated<X>,
        tolerance: Tolerance,
    ) -> bool
    where
        X: VectorSpace<S>,
    {
        let t = S::from_f64(self.clock.after(h));
        let end = state.reduced(dynamics);
        let derivative = dynamics.derivative(t, &end);
        self.statistics.evaluations += 1;
        let mut residual = self.coefficients.derivative(tau);
        let unit = S::one() / S::from_f64(self.unit);
        residual = residual.map(|component| component * unit);
        residual.add_scaled(-S::one(), &derivative);
        let scale = dynamics.error_scale(state.value());
        let [relative, absolute] = [tolerance.relative, tolerance.absolute]
            .map(|tolerance| S::from_f64(tolerance * RESIDUAL_PER_ORDER * number(Self::ORDER)));
        let rounding = S::from_f64(RESIDUAL_ROUNDING * S::machine_epsilon());
        let h = S::from_f64(h.abs());
        let components = residual.components().zip(derivative.components());
        let sizes = scale.components().zip(end.components());
        let mut all = components.zip(sizes);
        all.all(|((residual, rate), (scale, value))| {
            let size = value.abs() + scale + h * rate.abs();
            let allowed = absolute + relative * scale + rounding * size;
            (h * residual.abs() - allowed).largest() <= 0.0
        })
    }
}

/// The largest component over its tolerance.
fn largest_ratio<S: Scalar, X: VectorSpace<S>>(tolerance: Tolerance, vector: &X, scale: &X) -> f64 {
    let scales = [scale.clone(), scale.clone()];
    tolerance.ratios(vector, &scales, 0.0).fold(0.0, f64::max)
}

/// The power of two below a positive number and within a factor of 2 of it, within the range of exponents that leaves
/// room for squares.
fn power_of_two_near(x: f64) -> f64 {
    libm::ldexp(1.0, libm::ilogb(x).clamp(-500, 500))
}

impl<S: Scalar, X: VectorSpace<S>, const HALF: usize> Stepper<S, X> for TaylorStepper<X, HALF> {
    const DENSE_OUTPUT: bool = true;

    fn time(&self) -> f64 {
        self.clock.time()
    }

    fn state(&self) -> &X {
        self.state.value()
    }

    fn previous_time(&self) -> f64 {
        self.last
            .as_ref()
            .map_or(self.clock, |(clock, ..)| *clock)
            .time()
    }

    fn statistics(&self) -> Statistics {
        self.statistics
    }
}

impl<S: Scalar, X: VectorSpace<S>, D: Series<S, State = X> + ?Sized, const HALF: usize>
    Advance<S, D> for TaylorStepper<X, HALF>
{
    fn step(&mut self, dynamics: &D, target: f64) -> Result<(), IntegrationError> {
        let Some(remaining) = remaining(&self.clock, target)? else {
            return Ok(());
        };
        self.last = None;
        self.expand(dynamics)?;
        let tolerance = self.method.tolerance::<S>();
        let scale = self.scale(dynamics);
        let longest = self.method.max_step.unwrap_or(f64::INFINITY);
        let mut proposed = (self.proposed(tolerance, &scale) * self.unit).min(longest);
        loop {
            let time = self.clock.time();
            let lands = LANDING * proposed >= remaining.abs();
            let h = if lands {
                remaining
            } else {
                proposed.copysign(remaining)
            };
            let tau = S::from_f64(h / self.unit);
            let state = self.state.plus(self.coefficients.change(tau));
            let finite = checked_state(dynamics, self.clock.after(h), state.value());
            if finite.is_ok() && self.holds(dynamics, (h, tau), &state, tolerance) {
                let previous = core::mem::replace(&mut self.state, state);
                self.last = Some((self.clock, previous.into_value(), self.unit));
                if lands {
                    self.clock = Clock::new(target);
                } else {
                    self.clock.advance(h);
                }
                if proposed.is_normal() {
                    self.unit = power_of_two_near(proposed);
                }
                self.statistics.steps += 1;
                return Ok(());
            }
            self.statistics.rejected += 1;
            proposed = h.abs() / SHORTENING;
            let least = MIN_STEP * f64::EPSILON * time.abs();
            if proposed <= least.max(f64::MIN_POSITIVE) {
                finite?;
                let t = S::from_f64(time);
                return Err(match dynamics.vanishing_inertia(t, self.state.value()) {
                    Some(singularity) => IntegrationError::VanishingInertia {
                        time,
                        step: proposed,
                        singularity,
                    },
                    None => IntegrationError::StepTooSmall {
                        time,
                        step: proposed,
                        component: None,
                        relative_only: tolerance.absolute == 0.0,
                    },
                });
            }
        }
    }

    fn interpolate(&mut self, _: &D, t: f64) -> X {
        let Some((clock, from, unit)) = &self.last else {
            return self.state.value().clone();
        };
        let mut x = from.clone();
        let tau = S::from_f64(clock.until(t) / unit);
        x.add_scaled(S::one(), &self.coefficients.change(tau));
        x
    }

    fn restart(&mut self, _: &D) {
        self.last = None;
    }
}
