//! A part of a step in which event functions are polynomials.

use super::declared_event::DeclaredEvents;
use super::event_dynamics::{EventDynamics, SingleNumber};
use super::polynomial::{Polynomial, Root};
use crate::integrate::at::At;
use crate::integrate::step_polynomial::StepPolynomial;
use crate::integrate::taylor::TaylorCoefficients;
use crate::limits::events::{MOVED_EPSILONS, UNCERTAINTY};
use crate::linalg::VectorSpace;
use crate::scalar::{DoubleDouble, Scalar};

/// A part of a step over which the series of the event functions converge.
#[derive(Clone, Copy)]
pub(super) struct Window<const K: usize> {
    pub(super) begin: f64,
    pub(super) end: f64,
    /// The fraction of the window after which an event function may have another branch, because it has a corner there.
    pub(super) corner: Option<f64>,
    /// The values of the event functions at the end of the window.
    pub(super) last: [f64; K],
    /// Whether the polynomials agree with the functions.
    pub(super) is_known: bool,
}

impl<const K: usize> Window<K> {
    /// Returns the fraction of the window up to a time.
    pub(super) fn fraction(&self, t: f64) -> f64 {
        (t - self.begin) / (self.end - self.begin)
    }

    /// Returns the first time that is not before a fraction of the window.
    pub(super) fn time(&self, fraction: f64) -> f64 {
        if fraction >= 1.0 {
            return self.end;
        }
        let time = self.begin + fraction * (self.end - self.begin);
        if self.fraction(time) >= fraction {
            time
        } else if self.end >= self.begin {
            time.next_up()
        } else {
            time.next_down()
        }
    }

    /// Returns the fraction from which on the signs of the polynomials are not the signs of the functions.
    fn trusted(&self) -> f64 {
        if self.is_known {
            self.corner.unwrap_or(f64::INFINITY)
        } else {
            0.0
        }
    }

    /// Whether a root of a polynomial is a root of the function.
    pub(super) fn trusts(&self, root: &Root) -> bool {
        root.at < self.trusted()
    }

    /// Returns a root of an event's polynomial with the sign that the function has after it: at a corner the function
    /// may turn back.
    pub(super) fn behind(&self, event: usize, root: Root) -> Root {
        let value = self.last.get(event).copied().unwrap_or(f64::NAN);
        if self.trusts(&root) || value.is_nan() {
            return root;
        }
        let behind = if value == 0.0 { 0.0 } else { value.signum() };
        let until = 1.0;
        Root {
            behind,
            until,
            ..root
        }
    }

    /// Returns the sign of an event's function after its last root, if it is certain. `sign` is the sign after the last
    /// event; `from` and `resume` tell up to where it is known. After a corner the polynomial has no sign: a jump there
    /// is seen when the next window begins.
    pub(super) fn last_sign(
        &self,
        polynomial: &Polynomial,
        (from, resume): (f64, f64),
        sign: f64,
    ) -> f64 {
        let trusted = self.trusted();
        if trusted > 1.0 {
            return polynomial.last_sign(from.max(resume), sign);
        }
        if resume >= 1.0 {
            return sign;
        }
        let before = polynomial.certain_sign(trusted.max(0.0));
        before.unwrap_or_else(|| polynomial.last_sign(from, sign))
    }
}

/// The polynomials of event functions from the beginning of a window.
pub(super) struct Expansion<const K: usize> {
    pub(super) polynomials: [Polynomial; K],
    /// The end of the window.
    pub(super) end: f64,
    /// The fraction of the window at which there is a corner.
    pub(super) corner: Option<f64>,
    /// Whether the window begins so close to a corner that rounding may have chosen the branch.
    pub(super) is_at_corner: bool,
}

/// Derives the polynomials of event functions in a window from the polynomial of a step.
pub(super) struct Search<'a, D: ?Sized, X, const K: usize> {
    pub(super) events: &'a DeclaredEvents<K>,
    pub(super) dynamics: &'a D,
    /// The beginning of the window.
    pub(super) from: &'a At<f64, X>,
    /// The latest possible end of the window.
    pub(super) end: f64,
    /// The shortest permitted window.
    pub(super) least: f64,
    /// The shortest duration that is safely distinguishable.
    pub(super) resolution: f64,
}

impl<S, D, const K: usize> StepPolynomial<S, D::State> for Search<'_, D, D::State, K>
where
    S: SingleNumber,
    D: EventDynamics<S> + ?Sized,
{
    type Output = Option<Expansion<K>>;

    /// Expands the event functions in a window.
    ///
    /// The series of an event function may converge more slowly than the series of the motion, for which the step was
    /// chosen. The window is then shorter than the step. It is halved until the last two terms are rounding errors,
    /// either of the terms of the function or of their operands, or until they are as small relative to the others as
    /// the last terms of the motion in the step. The window ends just after the first corner.
    fn visit<const HALF: usize>(
        self,
        t: f64,
        unit: f64,
        motion: &TaylorCoefficients<D::State, HALF>,
    ) -> Self::Output {
        let At { t: begin, x } = self.from;
        let offset = (begin - t) / unit;
        let shifted = (offset != 0.0).then(|| motion.shifted(S::from_f64(offset)));
        let motion = shifted.as_ref().unwrap_or(motion);
        let (time, unit_of_time) = (S::from_f64(*begin), S::from_f64(unit));
        let series: TaylorCoefficients<_, HALF> =
            (self.dynamics).event_series(time, x, unit_of_time, motion)?;
        let (moved, moved_motion) = moved_by_rounding(x, motion);
        let other: TaylorCoefficients<_, HALF> =
            (self.dynamics).event_series(time, &moved, unit_of_time, &moved_motion)?;
        let allowed = UNCERTAINTY * S::machine_epsilon();
        let allowed = allowed.max(motion.last_terms((self.end - begin) / unit));
        let whole = self.end - begin;
        let watched = self.events.events.iter();
        let branches = watched.flat_map(|(index, _)| self.dynamics.branches(*index));
        let (mut part, mut polynomials) = (1.0, [Polynomial::ZERO; K]);
        loop {
            let length = part * whole / unit;
            let mut converge = true;
            for (polynomial, (index, _)) in polynomials.iter_mut().zip(self.events.events) {
                let moved = polynomial_of(&other, index, length)?;
                *polynomial = polynomial_of(&series, index, length)?.compared_with(&moved);
                converge &= polynomial.has_converged(allowed);
            }
            for index in branches.clone() {
                let moved = polynomial_of(&other, *index, length)?;
                let polynomial = polynomial_of(&series, *index, length)?;
                converge &= polynomial.compared_with(&moved).has_converged(allowed);
            }
            if converge || 0.5 * part * whole.abs() < self.least {
                break;
            }
            part *= 0.5;
        }
        let least = self.resolution / (whole * part).abs();
        let (mut corner, mut is_at_corner) = (None::<Root>, false);
        for index in branches {
            let polynomial = polynomial_of(&series, *index, part * whole / unit)?;
            is_at_corner |= polynomial.is_zero_within(least);
            let found = first_change(&polynomial);
            corner = found
                .into_iter()
                .chain(corner)
                .min_by(|a, b| a.at.total_cmp(&b.at));
        }
        let behind = corner.map(|root| root.until.max(root.at + 2.0 * least));
        let cut = behind.filter(|behind| *behind < 1.0).unwrap_or(1.0);
        if cut < 1.0 {
            part *= cut;
            for (polynomial, (index, _)) in polynomials.iter_mut().zip(self.events.events) {
                let length = part * whole / unit;
                let moved = polynomial_of(&other, index, length)?;
                *polynomial = polynomial_of(&series, index, length)?.compared_with(&moved);
            }
        }
        Some(Expansion {
            polynomials,
            end: if part < 1.0 {
                begin + whole * part
            } else {
                self.end
            },
            corner: corner.map(|root| (root.at - 2.0 * least) / cut),
            is_at_corner,
        })
    }
}

/// Moves a state and the motion from it up and down by some rounding errors. The resulting change of a function's
/// series is the effect of rounding on it, and may be as large as the series itself if terms cancel, as in
/// √(x² + y²) − 1 on a circle. The signs are taken from a linear congruential sequence (W. H. Press et al., *Numerical
/// Recipes*, 2nd edition 1992, section 7.1), so that no symmetry of a function cancels them.
fn moved_by_rounding<S: Scalar, X: VectorSpace<S>, const HALF: usize>(
    x: &X,
    motion: &TaylorCoefficients<X, HALF>,
) -> (X, TaylorCoefficients<X, HALF>) {
    let epsilon = S::from_f64(MOVED_EPSILONS * S::machine_epsilon());
    let (up, down) = (S::one() + epsilon, S::one() - epsilon);
    let mut random = 0_u32;
    let mut moved = |x: &X| {
        x.map(|component| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            component * if random >> 31 == 0 { up } else { down }
        })
    };
    let mut moved_motion = motion.clone();
    for coefficient in moved_motion.higher_mut() {
        *coefficient = moved(coefficient);
    }
    (moved(x), moved_motion)
}

/// Returns the polynomial of a function over a part of a step with this length, in units of the series.
fn polynomial_of<S, V, const HALF: usize>(
    series: &TaylorCoefficients<V, HALF>,
    index: usize,
    length: f64,
) -> Option<Polynomial>
where
    S: Scalar,
    V: AsRef<[S]> + Clone,
{
    let values = core::iter::once(series.initial()).chain(series.higher());
    let coefficients = values.map(|values| {
        let value = values.as_ref().get(index).copied();
        double_double(value.unwrap_or(S::zero()))
    });
    Polynomial::over(coefficients, length, S::machine_epsilon())
}

/// Returns the first root at which a polynomial changes its sign.
fn first_change(polynomial: &Polynomial) -> Option<Root> {
    let mut next = polynomial.next_root(0.0, 0.0);
    while let Some(root) = next {
        if root.before * root.behind < 0.0 || root.until >= 1.0 {
            return Some(root);
        }
        next = polynomial.next_root(root.until, root.behind);
    }
    None
}

/// Converts a number, with its digits beyond `f64`.
pub(crate) fn double_double<S: Scalar>(value: S) -> DoubleDouble {
    let high = value.smallest();
    let low = (value - S::from_f64(high)).smallest();
    DoubleDouble::new(high, if low.is_finite() { low } else { 0.0 })
}
