//! The steps of the Taylor series method.

use super::coefficients::number;
use super::{Series, Taylor, TaylorCoefficients};
use crate::integrate::compensated::{Clock, Compensated};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::stepper::{Advance, Statistics, Stepper, checked_derivative, remaining};
use crate::integrate::tolerance::Tolerance;
use crate::limits::taylor::{
    CHANGES, FIRST_UNIT, INNER_CHECKS, LANDING, LONG_STEP, MIN_STEP, MOVED_EPSILONS,
    NEGLIGIBLE_TERM, RESIDUAL_PER_ORDER, RESIDUAL_ROUNDING, SHORTENING, UNIT_CHANGE, UNIT_CHANGES,
};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// Takes the steps of a [`Taylor`] method.
///
/// The state is a compensated sum, so that its rounding errors do not grow over a long integration. Steps end at times
/// that are numbers, so that the time has none.
#[derive(Clone, Debug)]
pub struct TaylorStepper<X, const HALF: usize> {
    method: Taylor<HALF>,
    clock: Clock,
    state: Compensated<X>,
    /// The unit of time of the next series, a power of two near the size of the step: the coefficients of a series
    /// then neither overflow nor underflow.
    unit: f64,
    /// The polynomial of the last step, about the reduced state.
    pub(super) coefficients: TaylorCoefficients<X, HALF>,
    /// Where the last step began, and its unit of time.
    pub(super) last: Option<(Clock, Compensated<X>, f64)>,
    /// The length of the last step, 0 before the first.
    length: f64,
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
            length: 0.0,
            statistics: Statistics {
                evaluations: 1,
                ..Statistics::default()
            },
        })
    }

    /// Computes the polynomial about the present time, in a unit in which its coefficients are finite, and the step that
    /// it proposes.
    fn expand<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
    ) -> Result<f64, IntegrationError>
    where
        X: VectorSpace<S>,
    {
        let time = self.clock.time();
        let from = self.state.reduced(dynamics);
        let mut non_finite = None;
        let mut change = UNIT_CHANGE;
        for _ in 0..UNIT_CHANGES {
            let (t, unit) = (S::from_f64(time), S::from_f64(self.unit));
            dynamics.series(t, &from, unit, &mut self.coefficients);
            self.statistics.evaluations += 1;
            let mut last = self.coefficients.higher().iter().rev().take(2);
            non_finite = last.find_map(VectorSpace::first_non_finite);
            if non_finite.is_none() {
                let proposed = self.proposed(&self.scale(dynamics));
                // It is 0 where a coefficient over its tolerance is not finite.
                if proposed > 0.0 {
                    return Ok(proposed * self.unit);
                }
            }
            self.unit *= change;
            change *= change;
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
    fn proposed<S: Scalar>(&self, scale: &X) -> f64
    where
        X: VectorSpace<S>,
    {
        let tolerance = self.method.tolerance::<S>();
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

    /// The polynomial at a time: its argument and the state.
    fn at<S: Scalar>(&self, t: f64) -> (S, Compensated<X>)
    where
        X: VectorSpace<S>,
    {
        let [high, low] = difference(t, self.clock.time()).map(S::from_f64);
        let tau = (high + low) / S::from_f64(self.unit);
        (tau, self.state.plus(self.coefficients.change(tau)))
    }

    /// An error with the component at which the derivative at the end of a step, or within a long one, is not that of
    /// the polynomial: the motion is then not the one that the series at its beginning says.
    fn check<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        end: (f64, S, &Compensated<X>),
    ) -> Result<(), usize>
    where
        X: VectorSpace<S>,
    {
        let time = self.clock.time();
        let h = end.0 - time;
        self.check_at(dynamics, end, h.abs())?;
        if h.abs() > LONG_STEP * self.length || self.is_of_low_degree(dynamics, end.1, end.2) {
            for i in 1..=INNER_CHECKS {
                let t = time + h * (f64::from(i) / f64::from(INNER_CHECKS + 1));
                let (tau, state) = self.at(t);
                self.check_at(dynamics, (t, tau, &state), h.abs())?;
            }
        }
        Ok(())
    }

    /// Whether the terms of half the order hardly count at τ: then the tolerance says little about the length of the
    /// step, and much may happen within it that the series does not see, such as a pulse.
    fn is_of_low_degree<S: Scalar, D: Dynamics<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
        tau: S,
        state: &Compensated<X>,
    ) -> bool
    where
        X: VectorSpace<S>,
    {
        let tolerance = self.method.tolerance::<S>();
        let scale = dynamics.error_scale(state.value());
        let power = Scalar::powf(tau.abs().largest(), number(HALF));
        let mut middle = self.coefficients.higher().iter().take(HALF).rev().take(2);
        middle.all(|term| largest_ratio(tolerance, term, &scale) * power < NEGLIGIBLE_TERM)
    }

    /// The check at one time, for a step of length `h`. Rounding explains a difference, and the tolerance does.
    fn check_at<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        (t, tau, state): (f64, S, &Compensated<X>),
        h: f64,
    ) -> Result<(), usize>
    where
        X: VectorSpace<S>,
    {
        let (t, state, h) = (S::from_f64(t), state.reduced(dynamics), S::from_f64(h));
        let derivative = dynamics.derivative(t, &state);
        self.statistics.evaluations += 1;
        let mut residual = self.coefficients.derivative(tau);
        let unit = S::one() / S::from_f64(self.unit);
        residual = residual.map(|component| component * unit);
        residual.add_scaled(-S::one(), &derivative);
        let tolerance = self.method.tolerance::<S>();
        let [relative, absolute] = [tolerance.relative, tolerance.absolute]
            .map(|tolerance| S::from_f64(tolerance * RESIDUAL_PER_ORDER * number(Self::ORDER)));
        let rounding = S::from_f64(RESIDUAL_ROUNDING * S::machine_epsilon());
        let scale = dynamics.error_scale(&state);
        let mut allowed = scale.map(|scale| absolute + (relative + rounding) * scale);
        allowed.add_scaled(rounding, &state.map(Scalar::abs));
        allowed.add_scaled(rounding * h, &derivative.map(Scalar::abs));
        let residual = residual.map(|component| (component * h).abs());
        if first_beyond(&residual, &allowed).is_none() {
            return Ok(());
        }
        self.allow_condition(dynamics, (t, &state), &derivative, (h, &mut allowed));
        first_beyond(&residual, &allowed).map_or(Ok(()), Err)
    }

    /// Allows what the condition of the derivative explains: by how much it changes where time and state are moved by
    /// some rounding errors.
    #[cold]
    fn allow_condition<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &mut self,
        dynamics: &D,
        (t, state): (S, &X),
        derivative: &X,
        (h, allowed): (S, &mut X),
    ) where
        X: VectorSpace<S>,
    {
        for alternation in [1.0, -1.0] {
            let epsilon = MOVED_EPSILONS * S::machine_epsilon();
            let mut sign = 1.0;
            let moved = state.map(|x| {
                sign *= alternation;
                x + x.abs() * S::from_f64(sign * epsilon)
            });
            let mut change = dynamics.derivative(t + t * S::from_f64(epsilon), &moved);
            self.statistics.evaluations += 1;
            change.add_scaled(-S::one(), derivative);
            allowed.add_scaled(h * S::from_f64(CHANGES), &change.map(Scalar::abs));
        }
    }
}

/// The first component that is not at most what is allowed; one that is not finite is not.
fn first_beyond<S: Scalar, X: VectorSpace<S>>(residual: &X, allowed: &X) -> Option<usize> {
    let mut pairs = residual.components().zip(allowed.components());
    pairs.position(|(residual, allowed)| {
        let excess = (residual - allowed).largest();
        excess.is_nan() || excess > 0.0
    })
}

/// The exact difference of two numbers as the sum of two (Knuth, *The Art of Computer Programming* **2**, 3rd edition
/// (1997), section 4.2.2, theorem B).
pub(super) fn difference(x: f64, y: f64) -> [f64; 2] {
    let high = x - y;
    let part = high - x;
    [high, (x - (high - part)) - (y + part)]
}

/// The error of a step that is too small.
#[cold]
fn too_small<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    (time, x): (f64, &D::State),
    step: f64,
    component: usize,
    tolerance: Tolerance,
) -> IntegrationError {
    match dynamics.vanishing_inertia(S::from_f64(time), x) {
        Some(singularity) => IntegrationError::VanishingInertia {
            time,
            step,
            singularity,
        },
        None => IntegrationError::StepTooSmall {
            time,
            step,
            component: Some(dynamics.component_name(component)),
            relative_only: tolerance.absolute == 0.0,
        },
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
        let time = self.clock.time();
        let least = (MIN_STEP * f64::EPSILON * time.abs()).max(f64::MIN_POSITIVE);
        let longest = self.method.max_step.unwrap_or(f64::INFINITY);
        let mut proposed = self.expand(dynamics)?.min(longest);
        let mut component = 0;
        loop {
            let lands = LANDING * proposed >= remaining.abs();
            if !lands && proposed <= least {
                let (here, tolerance) = ((time, self.state.value()), self.method.tolerance::<S>());
                return Err(too_small(dynamics, here, proposed, component, tolerance));
            }
            let end = if lands {
                target
            } else {
                time + proposed.copysign(remaining)
            };
            let (tau, state) = self.at(end);
            let checked = match state.value().first_non_finite() {
                None => self.check(dynamics, (end, tau, &state)),
                Some((index, _)) => Err(index),
            };
            let length = (end - time).abs();
            if let Err(index) = checked {
                component = index;
                self.statistics.rejected += 1;
                proposed = length / SHORTENING;
                continue;
            }
            let previous = core::mem::replace(&mut self.state, state);
            self.last = Some((self.clock, previous, self.unit));
            self.clock = Clock::new(end);
            self.length = length;
            if proposed.is_normal() {
                self.unit = power_of_two_near(proposed);
            }
            self.statistics.steps += 1;
            return Ok(());
        }
    }

    fn interpolate(&mut self, _: &D, t: f64) -> X {
        let Some((clock, from, unit)) = &self.last else {
            return self.state.value().clone();
        };
        let [high, low] = difference(t, clock.time()).map(S::from_f64);
        let tau = (high + low) / S::from_f64(*unit);
        from.plus(self.coefficients.change(tau)).into_value()
    }

    fn restart(&mut self, _: &D) {
        self.last = None;
    }

    fn restart_at(&mut self, dynamics: &D, t: f64, x: X) -> Result<(), IntegrationError> {
        let statistics = self.statistics;
        *self = Self::new(self.method, dynamics, t, x)?;
        self.statistics = self.statistics.plus(statistics);
        Ok(())
    }
}
