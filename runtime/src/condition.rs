//! When to stop.

use crate::driver::Unconditional;

/// A condition on which a [`Driver`](crate::Driver) stops; made by
/// [`Driver::stop_when`](crate::Driver::stop_when) and
/// [`Driver::stop_at_zero`](crate::Driver::stop_at_zero).
pub trait Condition<X> {
    /// Whether to find out where within a step the condition is first met.
    const LOCATED: bool;

    /// The value on which it depends, at the time and state given.
    fn value(&mut self, t: f64, x: &X) -> f64;

    /// Whether it is met by the value `after`, where it was `before` at the start of the step. At
    /// the start of the motion the two are the same.
    fn met(&self, before: f64, after: f64) -> bool;
}

impl<X> Condition<X> for Unconditional {
    const LOCATED: bool = false;

    fn value(&mut self, _: f64, _: &X) -> f64 {
        0.0
    }

    fn met(&self, _: f64, _: f64) -> bool {
        false
    }
}

/// That a function of time and state is true at the end of a step.
#[derive(Clone, Copy, Debug)]
pub struct When<F>(pub F);

impl<X, F: FnMut(f64, &X) -> bool> Condition<X> for When<F> {
    const LOCATED: bool = false;

    fn value(&mut self, t: f64, x: &X) -> f64 {
        f64::from(u8::from((self.0)(t, x)))
    }

    fn met(&self, _: f64, after: f64) -> bool {
        after > 0.0
    }
}

/// That a function of time and state changes its sign.
#[derive(Clone, Copy, Debug)]
pub struct AtZero<F>(pub F);

impl<X, F: FnMut(f64, &X) -> f64> Condition<X> for AtZero<F> {
    const LOCATED: bool = true;

    fn value(&mut self, t: f64, x: &X) -> f64 {
        (self.0)(t, x)
    }

    /// A motion that begins at zero leaves it first.
    fn met(&self, before: f64, after: f64) -> bool {
        (before > 0.0 && after <= 0.0) || (before < 0.0 && after >= 0.0)
    }
}
