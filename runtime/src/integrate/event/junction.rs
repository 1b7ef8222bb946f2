//! The junction of two runs: to which of them an event belongs.
//!
//! A run that begins knows a time and a state, but nothing about the run before it. So both decide by the values of the
//! event functions at the state that is handed over. A run that ends there reports the events whose functions have
//! reached zero or changed sign; a run that begins there takes the signs that it finds. A function counts as zero if
//! rounding cannot distinguish it from zero: a few roundings of the time and of the components of the state change it
//! by as much as its value. Leaving zero is then no event: the function has a sign again when it is distinguishable
//! from zero. A function that touches zero within the resolution of time also counts as zero. A function that touches
//! zero farther away has already touched it if it moves away from zero.
//!
//! For an event in one direction, the sign of a function that is distinguishable from zero is taken as it is. For an
//! event in either direction, a change of sign within the resolution of time, before or after, also counts as zero. For
//! example, an impact that stops a run lies just after the zero because of rounding, and the motion away from it passes
//! the zero once more.

use super::memory::Memory;
use super::met_conditions::MetConditions;
use super::values::Values;
use super::{Crossing, EventFunctions};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::stepper::derivative_apart;
use crate::limits::events::{MOVED_EPSILONS, TIME_RESOLUTION, TOUCHING};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The event functions at a state that one run hands over to another.
pub(super) struct Junction<V> {
    pub(super) values: V,
    /// The effect of rounding on the values.
    pub(super) noise: V,
    /// The functions that count as zero.
    pub(super) zeros: MetConditions,
}

impl<V: Values> Junction<V> {
    pub(super) fn at<S, D, G>(source: &mut G, dynamics: &D, t: f64, x: &D::State) -> Self
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
    {
        let values = source.values(dynamics, t, x);
        let noise = rounding(source, dynamics, (t, x), &values);
        let pairs = values.as_slice().iter().zip(noise.as_slice());
        let zeros = MetConditions::of(pairs.map(|(value, noise)| value.abs() <= *noise));
        let mut junction = Self {
            values,
            noise,
            zeros,
        };
        junction.find_zeros_within_resolution(source, dynamics, (t, x));
        junction
    }

    /// Adds the functions that touch zero within the resolution of time, and those that change sign there. For events
    /// in either direction this is the resolution of a stepper. For events in one direction it is the resolution of the
    /// scalar, and they are only considered if the scalar has more digits than the time.
    fn find_zeros_within_resolution<S, D, G>(
        &mut self,
        source: &mut G,
        dynamics: &D,
        (t, x): (f64, &D::State),
    ) where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
    {
        let events = 0..self.values.as_slice().len();
        let asked = MetConditions::of(events.map(|event| !self.zeros.contains(event)));
        if !asked.any() {
            return;
        }
        let is_finer = S::machine_epsilon() < f64::EPSILON;
        let reduced = dynamics.reduced(x, &x.zeroed());
        let rate = derivative_apart(dynamics, S::from_f64(t), &reduced);
        let time_scale = time_scale(x, &rate);
        let of_scalar = MOVED_EPSILONS * S::machine_epsilon();
        let of_time = TIME_RESOLUTION * f64::EPSILON * t.abs();
        for (is_either, distance) in [
            (true, of_time + of_scalar * time_scale),
            (false, of_scalar * (t.abs() + time_scale)),
        ] {
            if distance <= 0.0 || !is_either && !is_finer {
                continue;
            }
            let [before, behind] = [-distance, distance].map(|distance| {
                let mut there = x.clone();
                there.add_scaled(S::from_f64(distance), &rate);
                source.values(dynamics, t + distance, &there)
            });
            let pairs = before.as_slice().iter().zip(behind.as_slice());
            for (event, (before, behind)) in pairs.enumerate().filter(|(i, _)| asked.contains(*i)) {
                let in_either = source.event(event).crossing() == Crossing::Either;
                let is_zero = if before * behind <= 0.0 {
                    in_either == is_either
                } else {
                    is_either && touches([*before, self.value(event), *behind])
                };
                if is_zero {
                    self.zeros.insert(event);
                }
            }
        }
    }

    pub(super) fn value(&self, event: usize) -> f64 {
        let value = self.values.as_slice().get(event).copied();
        value.unwrap_or(f64::NAN)
    }

    /// Returns the magnitude that a value has to exceed to show that a function has left its zero.
    fn hysteresis(&self, event: usize) -> f64 {
        let noise = self.noise.as_slice().get(event).copied().unwrap_or(0.0);
        noise.max(self.value(event).abs())
    }
}

/// Returns the time in which a state changes by its size; 0 if it is at rest.
fn time_scale<S: Scalar, X: VectorSpace<S>>(x: &X, rate: &X) -> f64 {
    let size = |x: &X| x.fold(S::zero(), |sum, x| sum + x.abs()).largest();
    let scale = size(x) / size(rate);
    if scale.is_finite() { scale } else { 0.0 }
}

/// Whether the parabola through three neighbouring values touches zero between them, where the outer two have the same
/// sign.
fn touches([before, here, behind]: [f64; 3]) -> bool {
    let [before, here, behind] = [before, here, behind].map(|value| value * behind.signum());
    let curvature = before + behind - 2.0 * here;
    let slope = 0.5 * (behind - before);
    let lowest = here - 0.5 * slope * slope / curvature;
    curvature > 0.0 && slope.abs() <= curvature && lowest <= TOUCHING * before.max(behind)
}

impl<V: Values> Memory<V> {
    /// Returns the memory of a run that begins.
    pub(super) fn at_start<S, D, G>(source: &mut G, dynamics: &D, t: f64, x: &D::State) -> Self
    where
        S: Scalar,
        D: Dynamics<S> + ?Sized,
        G: EventFunctions<S, D, Values = V>,
    {
        let junction = Junction::at(source, dynamics, t, x);
        let mut memory = Self::new(t, junction.values);
        memory.leave(&junction, t);
        memory
    }

    /// Records which functions are zero at a time: they have no signs until they leave zero.
    pub(super) fn leave(&mut self, junction: &Junction<V>, t: f64) {
        for event in junction.zeros.indices() {
            let least = junction.hysteresis(event);
            let [signs, hysteresis, zeros] =
                [&mut self.signs, &mut self.hysteresis, &mut self.zero_at].map(V::as_mut_slice);
            for (slice, value) in [(signs, 0.0), (hysteresis, least), (zeros, t)] {
                if let Some(place) = slice.get_mut(event) {
                    *place = value;
                }
            }
        }
        self.left = junction.zeros;
    }
}

/// 1/φ = φ − 1, the conjugate of the golden ratio. The fractional parts of its multiples are distinct and evenly spread
/// (D. E. Knuth, *The Art of Computer Programming*, volume 3, 2nd edition 1998, section 6.4, theorem S).
const GOLDEN_RATIO_CONJUGATE: f64 = 0.618_033_988_749_894_8;

/// Returns the changes of the values when the time and the state are moved by some rounding errors.
pub(super) fn rounding<S, D, G>(
    source: &mut G,
    dynamics: &D,
    (t, x): (f64, &D::State),
    values: &G::Values,
) -> G::Values
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
    G: EventFunctions<S, D>,
{
    let part = MOVED_EPSILONS * S::machine_epsilon();
    let epsilon = S::from_f64(part);
    let mut noise = G::Values::ZERO;
    for alternation in [1.0, -1.0] {
        // Each component is moved by another part of itself: with equal parts, the sum of two opposite components would
        // not change.
        let (mut sign, mut fraction) = (1.0, 0.0);
        let moved = x.map(|component| {
            sign *= alternation;
            fraction += GOLDEN_RATIO_CONJUGATE;
            if fraction >= 1.0 {
                fraction -= 1.0;
            }
            component + component * S::from_f64(sign * (0.5 + fraction)) * epsilon
        });
        let time = t - alternation * t * MOVED_EPSILONS * f64::EPSILON.min(part);
        let there = source.values(dynamics, time, &moved);
        let pairs = there.as_slice().iter().zip(values.as_slice());
        for (noise, (there, here)) in noise.as_mut_slice().iter_mut().zip(pairs) {
            *noise = noise.max((there - here).abs());
        }
    }
    noise
}
