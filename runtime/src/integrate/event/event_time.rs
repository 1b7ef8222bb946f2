//! The time of an event in the arithmetic of the scalar, and the state at that time.
//!
//! A stepper measures time in `f64`, and finds an event at such a time t*. The exact time is t* + δ, with the delay δ
//! for which g(t* + δ, x(t* + δ)) = 0. With dual numbers δ consists of derivative parts, so that
//! dt*/dx₀ = −(∂g/∂x ∂x/∂x₀)/ġ; with double-doubles it consists of the digits beyond `f64`. A reaction sees the state
//! at t* + δ. The state that it leaves is moved back by δ along the motion that follows, so that the stepper continues
//! at t*. In this way the derivatives of a motion jump at an impact or a switch (R. I. Leine & H. Nijmeijer, *Dynamics
//! and Bifurcations of Non-Smooth Mechanical Systems*, 2004, ch. 7, the saltation matrix; I. A. Hiskens & M. A. Pai,
//! *Trajectory Sensitivity Analysis of Hybrid Systems*, IEEE Trans. Circuits Syst. I **47** (2000) 204–220).
//!
//! If an event function touches zero without a change of sign, the time has no derivative: its derivative parts are
//! then huge or not finite.

use super::Detection;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::derivative_apart;
use crate::limits::events::{DELAY_ITERATIONS, EXTRAPOLATIONS, MIN_CHANGE};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The data by which the delay of an event is computed: the time and state of the stepper, and the length of its last
/// step.
pub(crate) struct Located<'a, D: Dynamics<S> + ?Sized, S: Scalar> {
    pub(crate) dynamics: &'a D,
    pub(crate) t: f64,
    pub(crate) x: &'a D::State,
    pub(crate) step: f64,
}

impl<S: Scalar, D: Dynamics<S> + ?Sized> Located<'_, D, S> {
    /// Returns the delay of an event relative to t. It is zero if `f64` has all digits of the scalar, and for events of
    /// several motions at a time.
    ///
    /// This is Newton's method with a slope from finite differences: each iteration multiplies the error by the
    /// relative error of the slope.
    pub(crate) fn delay<G: Detection<S, D>>(&self, source: &mut G, event: usize) -> S {
        if S::DERIVATIVES == 0 && S::machine_epsilon() >= f64::EPSILON {
            return S::zero();
        }
        let here = S::from_f64(self.t);
        let Some(value) = source.function(self.dynamics, here, self.x, event) else {
            return S::zero();
        };
        let mut rest = beyond_f64(value);
        if is_zero(rest) {
            return S::zero();
        }
        let time_per_value = S::from_f64(self.time_per_value(source, event));
        let mut delay = S::zero();
        for _ in 0..DELAY_ITERATIONS {
            delay -= rest * time_per_value;
            let t = here + delay;
            let x = moved(self.dynamics, here, self.x, delay);
            match source.function(self.dynamics, t, &x, event) {
                Some(value) => rest = beyond_f64(value),
                None => break,
            }
        }
        // A zero that is double to rounding stays where `f64` has found it.
        let resolved = S::from_f64(f64::EPSILON * (self.t.abs() + self.step.abs()));
        if (delay.abs() - resolved).largest() > 0.0 {
            return S::zero();
        }
        delay
    }

    /// Returns one over the rate of an event function along the motion, by a central difference over a small part of
    /// the last step; the largest number if the function has an extremum.
    fn time_per_value<G: Detection<S, D>>(&self, source: &mut G, event: usize) -> f64 {
        let distance = EXTRAPOLATIONS[0] * self.step;
        let mut at = |distance: f64| {
            let step = S::from_f64(distance);
            let x = moved(self.dynamics, S::from_f64(self.t), self.x, step);
            let t = S::from_f64(self.t + distance);
            let value = source.function(self.dynamics, t, &x, event);
            value.map_or(f64::NAN, Scalar::smallest)
        };
        let [after, before] = [at(distance), at(-distance)];
        if (after - before).abs() > MIN_CHANGE * after.abs().max(before.abs()) {
            2.0 * distance / (after - before)
        } else {
            f64::MAX
        }
    }
}

/// Whether a number is zero in all of its derivative parts, too, which equality may ignore.
fn is_zero<S: Scalar>(x: S) -> bool {
    let vanishes = |part: usize| x.derivative_part(part).abs() <= 0.0;
    x == S::zero() && (0..S::DERIVATIVES).all(vanishes)
}

/// Whether two states differ, possibly only in derivative parts.
pub(crate) fn differs<S: Scalar, X: VectorSpace<S>>(a: &X, b: &X) -> bool {
    let pairs = a.components().zip(b.components());
    pairs.into_iter().any(|(a, b)| !is_zero(a - b))
}

/// Returns the part of a value that `f64` does not represent, where the value is zero to rounding.
fn beyond_f64<S: Scalar>(value: S) -> S {
    if S::machine_epsilon() < f64::EPSILON {
        value
    } else {
        value - S::from_f64(value.smallest())
    }
}

/// Returns the state at t + δ of the motion through (t, x), by a classical Runge–Kutta step, whose error is of order
/// δ⁵. If δ has derivative parts only, its powers beyond their order vanish, and the step is exact.
pub(crate) fn moved<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: S,
    x: &D::State,
    delay: S,
) -> D::State {
    if is_zero(delay) {
        return x.clone();
    }
    let zero = x.zeroed();
    let part = |numerator: f64, denominator: f64| delay * S::ratio(numerator, denominator);
    let slope = |time: S, slope: &D::State| {
        let mut there = x.clone();
        there.add_scaled(time, slope);
        derivative_apart(dynamics, t + time, &dynamics.reduced(&there, &zero))
    };
    let first = slope(S::zero(), &zero);
    let second = slope(part(1.0, 2.0), &first);
    let third = slope(part(1.0, 2.0), &second);
    let fourth = slope(delay, &third);
    let mut end = x.clone();
    for (weight, slope) in [(1.0, &first), (2.0, &second), (2.0, &third), (1.0, &fourth)] {
        end.add_scaled(part(weight, 6.0), slope);
    }
    end
}
