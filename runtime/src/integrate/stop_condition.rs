//! Stop conditions: predicates, and event functions whose zero crossings are located.

use detection::Detection;

/// A condition, or several, on which a [`Driver`](crate::Driver) stops; made by
/// [`Driver::stop_when`](crate::Driver::stop_when), [`Driver::stop_at_zero`](crate::Driver::stop_at_zero)
/// and [`Driver::stop_at_crossing`](crate::Driver::stop_at_crossing), and by nothing else: the trait is sealed.
pub trait StopCondition<X>: detection::Detection<X> {}

impl<X, C: detection::Detection<X>> StopCondition<X> for C {}

/// How conditions are evaluated.
pub(crate) mod detection {
    use super::MetConditions;

    /// What the driver calls.
    pub trait Detection<X> {
        /// Whether to locate where within a step the condition is first met.
        const LOCATED: bool;

        /// The value of the condition: a truth value, or that of the event functions.
        type Value: Copy;

        /// The value at the time and state given.
        fn value(&mut self, t: f64, x: &X) -> Self::Value;

        /// The conditions that are met by the value `after`, where it was `before`. At the initial time the two are
        /// the same.
        fn met(&self, before: Self::Value, after: Self::Value) -> MetConditions;

        /// The conditions that are met within the resolution of time after the initial time.
        fn met_after_start(&self, before: Self::Value, after: Self::Value) -> MetConditions {
            self.met(before, after)
        }

        /// Whether every event function is positive or negative.
        fn is_signed(value: Self::Value) -> bool {
            let _ = value;
            true
        }

        /// The value to compare the next one with: `after`, but the last sign of what is zero or NaN.
        fn last_signed(&self, before: Self::Value, after: Self::Value) -> Self::Value {
            let _ = before;
            after
        }
    }
}

/// Which stop conditions are met: a set of indices below 64.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MetConditions(u64);

impl MetConditions {
    /// The set of the indices at which the iterator is true.
    pub(crate) fn of(conditions: impl Iterator<Item = bool>) -> Self {
        let bits = (0..u64::BITS).zip(conditions);
        Self(bits.fold(0, |met, (i, is_met)| met | u64::from(is_met) << i))
    }

    /// Whether any condition is.
    #[must_use]
    pub fn any(self) -> bool {
        self.0 != 0
    }

    /// Whether the condition of that index is.
    #[must_use]
    pub fn contains(self, index: usize) -> bool {
        let shifted = u32::try_from(index)
            .ok()
            .and_then(|i| self.0.checked_shr(i));
        shifted.is_some_and(|bits| bits & 1 == 1)
    }

    /// The union of two sets.
    #[must_use]
    pub(crate) fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// No stop condition.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unconditional;

impl<X> Detection<X> for Unconditional {
    const LOCATED: bool = false;

    type Value = ();

    fn value(&mut self, _: f64, _: &X) {}

    fn met(&self, (): (), (): ()) -> MetConditions {
        MetConditions::default()
    }
}

/// The condition that a function of time and state is true at the end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Predicate<F>(pub(crate) F);

impl<X, F: FnMut(f64, &X) -> bool> Detection<X> for Predicate<F> {
    const LOCATED: bool = false;

    type Value = bool;

    fn value(&mut self, t: f64, x: &X) -> bool {
        (self.0)(t, x)
    }

    fn met(&self, _: bool, after: bool) -> MetConditions {
        MetConditions::of([after].into_iter())
    }
}

/// The direction in which an event function crosses zero in the course of an integration, also of a backward one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// In one direction or the other.
    Either,
}

impl Crossing {
    /// Whether zero is crossed or reached between two values. From zero there is no crossing, and NaN has no sign.
    fn between(self, before: f64, after: f64) -> bool {
        let rises = before < 0.0 && after >= 0.0;
        let falls = before > 0.0 && after <= 0.0;
        match self {
            Self::Rising => rises,
            Self::Falling => falls,
            Self::Either => rises || falls,
        }
    }

    /// The same between the initial time and the next distinguishable time. For either direction, a change
    /// of sign there is taken for the zero at the initial time.
    fn after_start(self, before: f64, after: f64) -> bool {
        self != Self::Either && self.between(before, after)
    }
}

/// Whether a number is positive or negative: not zero and not NaN.
fn has_sign(value: f64) -> bool {
    !value.is_nan() && value != 0.0
}

/// `after`, or `before` if it has no sign.
fn signed(before: f64, after: f64) -> f64 {
    if has_sign(after) { after } else { before }
}

/// The condition that an event function of time and state crosses zero, or one of several: `crossing` is a
/// [`Crossing`] for one value, or an array of them for an array of values.
#[derive(Clone, Copy, Debug)]
pub struct ZeroCrossing<F, C = Crossing> {
    /// The event function.
    pub(crate) function: F,
    /// The direction of the crossing.
    pub(crate) crossing: C,
}

impl<X, F: FnMut(f64, &X) -> f64> Detection<X> for ZeroCrossing<F, Crossing> {
    const LOCATED: bool = true;

    type Value = f64;

    fn value(&mut self, t: f64, x: &X) -> f64 {
        (self.function)(t, x)
    }

    fn met(&self, before: f64, after: f64) -> MetConditions {
        MetConditions::of([self.crossing.between(before, after)].into_iter())
    }

    fn met_after_start(&self, before: f64, after: f64) -> MetConditions {
        MetConditions::of([self.crossing.after_start(before, after)].into_iter())
    }

    fn is_signed(value: f64) -> bool {
        has_sign(value)
    }

    fn last_signed(&self, before: f64, after: f64) -> f64 {
        signed(before, after)
    }
}

impl<X, F, const K: usize> Detection<X> for ZeroCrossing<F, [Crossing; K]>
where
    F: FnMut(f64, &X) -> [f64; K],
{
    const LOCATED: bool = {
        assert!(K <= 64, "at most 64 conditions at a time");
        true
    };

    type Value = [f64; K];

    fn value(&mut self, t: f64, x: &X) -> [f64; K] {
        (self.function)(t, x)
    }

    fn met(&self, before: [f64; K], after: [f64; K]) -> MetConditions {
        let values = before.into_iter().zip(after);
        let crossings = self.crossing.iter().zip(values);
        MetConditions::of(
            crossings.map(|(crossing, (before, after))| crossing.between(before, after)),
        )
    }

    fn met_after_start(&self, before: [f64; K], after: [f64; K]) -> MetConditions {
        let values = before.into_iter().zip(after);
        let crossings = self.crossing.iter().zip(values);
        MetConditions::of(
            crossings.map(|(crossing, (before, after))| crossing.after_start(before, after)),
        )
    }

    fn is_signed(value: [f64; K]) -> bool {
        value.into_iter().all(has_sign)
    }

    fn last_signed(&self, before: [f64; K], after: [f64; K]) -> [f64; K] {
        core::array::from_fn(|i| signed(before[i], after[i]))
    }
}
