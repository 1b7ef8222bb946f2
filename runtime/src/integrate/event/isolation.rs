//! Event functions whose zeros in a step are isolated from each other.

use super::event_dynamics::{EventDynamics, SingleNumber};
use super::functions_in_step::FunctionsInStep;
use super::simple_zero::SimpleZero;
use super::terms::Terms;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::taylor::TaylorCoefficients;
use crate::limits::events::{MAX_ISOLATED_ZEROS, MAX_ZERO_WIDTH, MIN_ISOLATING_PART};

/// A function whose zeros in a step are known, few and simple.
#[derive(Clone, Copy, Default)]
pub(super) struct Isolated {
    /// The sign at the beginning of the step.
    sign: f64,
    zeros: Zeros,
    /// The value of its polynomial in the middle of the step.
    pub(super) in_middle: f64,
    /// By how much a value of the function may differ from the polynomial.
    pub(super) allowed: f64,
}

impl Isolated {
    /// Returns the function with these terms and this value at the end of the step; `None` if it may have other zeros, or differs
    /// from its polynomial.
    fn of<const HALF: usize>(terms: &Terms<f64, HALF>, last: f64) -> Option<Self> {
        let function = Self {
            sign: terms.first().signum(),
            zeros: zeros(terms)?,
            in_middle: terms.value(0.5),
            allowed: terms.allowed(),
        };
        let agrees = terms.ends_near(last) && last * function.sign_at(1.0) > 0.0;
        agrees.then_some(function)
    }

    /// Returns the sign at a fraction of the step.
    pub(super) fn sign_at(&self, fraction: f64) -> f64 {
        let zeros = self.zeros.iter().flatten();
        let passed = zeros.take_while(|zero| zero.at <= fraction);
        passed.fold(self.sign, |sign, _| -sign)
    }

    /// Returns the zeros behind a fraction of the step.
    pub(super) fn zeros_behind(&self, fraction: f64) -> impl Iterator<Item = SimpleZero> {
        let zeros = self.zeros.into_iter().flatten();
        zeros.skip_while(move |zero| zero.at <= fraction)
    }
}

/// The zeros of a function in a step, in their order.
type Zeros = [Option<SimpleZero>; MAX_ISOLATED_ZEROS];

/// Returns the zeros of a function with these terms; `None` if there are too many, or if one cannot be isolated because of rounding
/// or further terms.
#[inline]
fn zeros<const HALF: usize>(terms: &Terms<f64, HALF>) -> Option<Zeros> {
    let step = [0.0, 1.0];
    let mut zeros = Zeros::default();
    match terms.sign_changes(step, 0.0) {
        Some(0) => Some(zeros),
        Some(1) => {
            zeros[0] = Some(SimpleZero::of(terms, step)?);
            Some(zeros)
        }
        _ => zeros_in_parts(terms),
    }
}

/// Returns the zeros, each alone in a part of the step: a part is halved until it has no more than one (Collins & Akritas 1976, as
/// for [`Terms::sign_changes`]). Shorter parts do not help if a sign at an end of the step is uncertain, or further terms are
/// visible.
#[inline(never)]
fn zeros_in_parts<const HALF: usize>(terms: &Terms<f64, HALF>) -> Option<Zeros> {
    if !terms.are_certain_at_ends() || terms.tail() > MAX_ZERO_WIDTH * terms.sum() {
        return None;
    }
    let mut zeros = Zeros::default();
    let mut places = zeros.iter_mut();
    let mut part = [0.0, 0.5];
    while part[0] < 1.0 {
        let [from, to] = part;
        match terms.sign_changes(part, 0.0) {
            Some(0) => part = [to, 1.0],
            Some(1) => {
                *places.next()? = Some(SimpleZero::of(terms, part)?);
                part = [to, 1.0];
            }
            _ if to - from > MIN_ISOLATING_PART => part[1] = 0.5 * (from + to),
            _ => return None,
        }
    }
    Some(zeros)
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
    /// `None` if one of the functions may have other zeros or differs from its polynomial, or if one of the functions at whose
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
    use alloc::vec;
    use alloc::vec::Vec;

    use super::Isolated;
    use crate::integrate::event::terms::Terms;
    use crate::integrate::taylor::TaylorCoefficients;

    /// The isolated function ∏ (u − root) of a step.
    fn with_roots(roots: &[f64]) -> Option<Isolated> {
        let mut series = TaylorCoefficients::<f64, 4>::new(0.0);
        *series.initial_mut() = 1.0;
        for (degree, root) in roots.iter().enumerate() {
            for k in (0..=degree).rev() {
                let lower = if k == 0 {
                    *series.initial()
                } else {
                    series.higher()[k - 1]
                };
                series.higher_mut()[k] = lower - root * series.higher()[k];
            }
            *series.initial_mut() *= -root;
        }
        let terms = Terms::new(&series, 1.0, (f64::EPSILON, 9.0));
        let last = roots.iter().fold(1.0, |value, root| value * (1.0 - root));
        Isolated::of(&terms, last)
    }

    #[test]
    fn zeros_are_isolated_in_parts_of_a_step() {
        for roots in [
            vec![],
            vec![0.7],
            vec![0.3, 0.6],
            vec![0.2, 0.5, 0.9],
            vec![0.05, 0.125, 0.5, 0.95],
        ] {
            let function = with_roots(&roots).unwrap();
            let found: Vec<f64> = function.zeros_behind(0.0).map(|zero| zero.at).collect();
            assert_eq!(found.len(), roots.len(), "{found:?}");
            for (found, expected) in found.iter().zip(&roots) {
                assert!((found - expected).abs() < 1e-13, "{found:?}");
            }
            let behind = function.zeros_behind(0.55).count();
            assert_eq!(behind, roots.iter().filter(|root| **root > 0.55).count());
            for fraction in [0.0, 0.1, 0.4, 0.55, 0.8, 1.0] {
                let value = roots
                    .iter()
                    .fold(1.0, |value, root| value * (fraction - root));
                assert!(value * function.sign_at(fraction) > 0.0, "{roots:?}");
            }
        }
    }

    #[test]
    fn zeros_that_are_close_together_or_too_many_are_left_to_the_search() {
        assert!(with_roots(&[0.3, 0.31]).is_none());
        assert!(with_roots(&[0.5, 0.5]).is_none());
        assert!(with_roots(&[0.1, 0.3, 0.5, 0.7, 0.9]).is_none());
    }

    /// The value at the end is near the polynomial relative to its terms, but on the other side of zero.
    #[test]
    fn a_function_with_another_sign_at_the_end_is_not_isolated() {
        let mut series = TaylorCoefficients::<f64, 3>::new(0.0);
        *series.initial_mut() = 1.0;
        series.higher_mut()[..2].copy_from_slice(&[1e6, -1e6]);
        let terms = Terms::new(&series, 1.0, (f64::EPSILON, 7.0));
        assert!(terms.ends_near(-5.0));
        assert!(Isolated::of(&terms, 1.0).is_some());
        assert!(Isolated::of(&terms, -5.0).is_none());
    }
}
