//! The outline of event functions in a step: which have no zero in it, and which have a single simple one.
//!
//! A polynomial has as many zeros in an interval as the sequence of its Bernstein coefficients has changes of sign, or fewer
//! by an even number (Descartes' rule of signs: G. E. Collins & A. G. Akritas, *Polynomial Real Root Isolation Using Descarte's
//! Rule of Signs*, SYMSAC 1976). One change that no error of a coefficient adds to thus proves that there is one zero.

use super::declared_event::DeclaredEvents;
use super::event_dynamics::{EventDynamics, SingleNumber};
use super::simple_zero::SimpleZero;
use super::terms::{Signs, Terms, of_function};
use crate::integrate::bernstein::as_number;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::taylor::TaylorCoefficients;

/// The course of a function in a step.
#[derive(Clone, Copy)]
pub(super) struct Course {
    /// The sign at the beginning.
    pub(super) sign: f64,
    /// Its only zero, if it has one.
    pub(super) zero: Option<SimpleZero>,
    /// The value of its polynomial in the middle of the step.
    pub(super) in_middle: f64,
    /// By how much a value of the function may differ from the polynomial.
    pub(super) allowed: f64,
}

impl Course {
    /// Before it is determined.
    const UNKNOWN: Self = Self {
        sign: 0.0,
        zero: None,
        in_middle: 0.0,
        allowed: 0.0,
    };

    /// Returns the course of a function with these terms and this value at the end of the step.
    fn of<const HALF: usize>(terms: &Terms<f64, HALF>, last: f64) -> Option<Self> {
        let sign = terms.first().signum();
        let (zero, sign_at_end) = match terms.signs(0.0)? {
            Signs::One => (None, sign),
            Signs::Two => (Some(SimpleZero::of(terms)?), -sign),
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

/// Computes the courses of the event functions from all terms of their series.
pub(super) struct Outline<'a, D: ?Sized, X, const K: usize> {
    pub(super) events: &'a DeclaredEvents<K>,
    pub(super) dynamics: &'a D,
    /// The state at the beginning of the step.
    pub(super) from: &'a X,
    /// The time of the end of the step.
    pub(super) end: f64,
    /// The event functions at the end of the step.
    pub(super) last: [f64; K],
}

impl<S, D, const K: usize> StepPolynomial<S, D::State> for Outline<'_, D, D::State, K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    /// `None` if one of the functions may have more zeros or differs from its polynomial, or if one of the functions at whose
    /// zeros they have corners may have a zero.
    type Output = Option<[Course; K]>;

    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        motion: &TaylorCoefficients<D::State, HALF>,
    ) -> Self::Output {
        let [begin, unit_of_time] = [t, unit].map(S::from_f64);
        let series: TaylorCoefficients<_, HALF> =
            (self.dynamics).event_series(begin, self.from, unit_of_time, motion)?;
        let length = (self.end - t) / unit;
        let accuracy = (S::machine_epsilon(), as_number(1 + 2 * HALF));
        let terms =
            |index: usize| Some(Terms::new(&of_function(&series, index)?, length, accuracy));
        let mut courses = [Course::UNKNOWN; K];
        let watched = self.events.events.iter().zip(self.last);
        for (course, ((index, _), last)) in courses.iter_mut().zip(watched) {
            *course = Course::of(&terms(*index)?, last)?;
            for branch in self.dynamics.branches(*index) {
                terms(*branch)?.sign(0.0)?;
            }
        }
        Some(courses)
    }
}
