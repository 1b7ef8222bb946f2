//! Event functions that have at most one zero in a step, so that the step isolates their zeros.

use super::event_dynamics::{EventDynamics, SingleNumber};
use super::functions_in_step::FunctionsInStep;
use super::simple_zero::SimpleZero;
use super::terms::Terms;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::taylor::TaylorCoefficients;

/// A function that has at most one zero in a step.
#[derive(Clone, Copy, Default)]
pub(super) struct Isolated {
    /// The sign at the beginning.
    pub(super) sign: f64,
    pub(super) zero: Option<SimpleZero>,
    /// The value of its polynomial in the middle of the step.
    pub(super) in_middle: f64,
    /// By how much a value of the function may differ from the polynomial.
    pub(super) allowed: f64,
}

impl Isolated {
    /// Returns the function with these terms and this value at the end of the step; `None` if it may have more zeros, or differs
    /// from its polynomial.
    fn of<const HALF: usize>(terms: &Terms<f64, HALF>, last: f64) -> Option<Self> {
        let sign = terms.first().signum();
        let (zero, sign_at_end) = match terms.sign_changes(0.0)? {
            0 => (None, sign),
            1 => (Some(SimpleZero::of(terms)?), -sign),
            _ => return None,
        };
        let agrees = terms.is_near(1.0, last) && last * sign_at_end > 0.0;
        agrees.then(|| Self {
            sign,
            zero,
            in_middle: terms.value(0.5),
            allowed: terms.allowed(),
        })
    }
}

/// Finds the zeros of event functions from all terms of their series.
pub(super) struct Isolation<'a, D: ?Sized, X, const K: usize>(
    pub(super) FunctionsInStep<'a, D, X, K>,
);

impl<S, D, const K: usize> StepPolynomial<S, D::State> for Isolation<'_, D, D::State, K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    /// `None` if one of the functions may have more zeros or differs from its polynomial, or if one of the functions at whose
    /// zeros they have corners may have a zero.
    type Output = Option<[Isolated; K]>;

    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        motion: &TaylorCoefficients<D::State, HALF>,
    ) -> Self::Output {
        let isolated = Isolated::of::<HALF>;
        self.0.examined((t, unit), motion, 0.0, isolated)
    }
}

#[cfg(test)]
mod tests {
    use super::Isolated;
    use crate::integrate::event::terms::Terms;
    use crate::integrate::taylor::TaylorCoefficients;

    /// The value at the end is near the polynomial relative to its terms, but on the other side of zero.
    #[test]
    fn a_function_with_another_sign_at_the_end_is_not_isolated() {
        let mut series = TaylorCoefficients::<f64, 3>::new(0.0);
        *series.initial_mut() = 1.0;
        series.higher_mut()[..2].copy_from_slice(&[1e6, -1e6]);
        let terms = Terms::new(&series, 1.0, (f64::EPSILON, 7.0));
        assert!(terms.is_near(1.0, -5.0));
        assert!(Isolated::of(&terms, 1.0).is_some());
        assert!(Isolated::of(&terms, -5.0).is_none());
    }
}
