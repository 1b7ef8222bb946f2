//! The times at which a motion passes from one branch of its equations to another.
//!
//! A series continues the branch on which a step begins, for example of |u|, sgn u, min, max or atan2. A contact that
//! begins and ends within a step does not show at its end. The switching functions, whose signs distinguish branches,
//! have their own series. After each change of their signs the series of the motion is compared with the equations. If
//! they differ, the step ends at that change (L. Dieci & L. Lopez, *A survey of numerical methods for IVPs of ODEs with
//! discontinuous right-hand side*, J. Comput. Appl. Math. **236** (2012) 3967–3991, section 3).

use super::unit_polynomial::UnitPolynomial;
use crate::limits::events::MAX_COEFFICIENTS;
use crate::limits::taylor::{CONVERGED, MAX_CROSSINGS, MAX_HALVINGS, ONE_SIGN};

/// A visitor of the Taylor coefficients of each switching function in turn.
pub type BranchVisitor<'a, S> = dyn FnMut(&mut dyn Iterator<Item = S>) + 'a;

/// A sign change of a switching function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// The position as a fraction of the step.
    pub(super) at: f64,
    /// The index of the switching function.
    pub(super) function: usize,
}

/// The sign changes of switching functions within a step, in order.
#[derive(Clone, Copy, Debug)]
pub(super) struct BranchCrossings {
    crossings: [Crossing; MAX_CROSSINGS],
    count: usize,
    /// The number of functions that were examined.
    functions: usize,
    /// The fraction of the step within which two times are equal to rounding.
    resolution: f64,
    /// The fraction of the step over which the series of all functions converge; at most 1.
    pub(super) converging: f64,
    /// A function that is zero to rounding at the end of the step.
    pub(super) at_end: Option<usize>,
    /// Whether a function consists of rounding errors only, so that its sign changes are unknown.
    pub(super) has_noise: bool,
}

/// A step in which switching functions change their signs.
pub(super) struct SearchedStep<T, M> {
    /// The length of the step in units of the series.
    pub(super) length: f64,
    /// The machine epsilon of the coefficients.
    pub(super) epsilon: f64,
    /// The larger of the last two terms of the motion's series at the end of the step, over the sum of all terms.
    pub(super) last_terms: T,
    /// The sum of the terms of the motion's series in the component with the largest sum.
    pub(super) size: M,
}

impl BranchCrossings {
    /// Creates an empty list for a step of which a fraction `resolution` is a rounding error of the time.
    pub(super) fn none(resolution: f64) -> Self {
        Self {
            crossings: [Crossing {
                at: 1.0,
                function: 0,
            }; MAX_CROSSINGS],
            count: 0,
            functions: 0,
            resolution,
            converging: 1.0,
            at_end: None,
            has_noise: false,
        }
    }

    /// Adds the sign changes of the next function, which has these coefficients. A function without a series at the
    /// beginning of the step has none.
    pub(super) fn add<T: Fn() -> f64, M: Fn() -> f64>(
        &mut self,
        coefficients: impl Iterator<Item = f64>,
        step: &SearchedStep<T, M>,
    ) {
        let function = self.functions;
        self.functions += 1;
        let (mut terms, mut count) = ([0.0; MAX_COEFFICIENTS], 0);
        let (mut power, mut rest, mut is_finite) = (1.0, 0.0, true);
        for (term, coefficient) in terms.iter_mut().zip(coefficients) {
            is_finite &= coefficient.is_finite();
            // A high power may be infinite.
            *term = if coefficient == 0.0 {
                0.0
            } else {
                coefficient * power
            };
            rest += term.abs();
            power *= step.length;
            count += 1;
        }
        rest -= terms[0].abs();
        if !is_finite || terms[0].abs() > ONE_SIGN * rest {
            return;
        }
        let terms = &terms[..count];
        let part = converging_part(terms, || CONVERGED.max((step.last_terms)()));
        if part < 1.0 {
            if rest <= NOISE * step.epsilon * (step.size)() {
                self.has_noise = true;
            } else {
                self.converging = self.converging.min(part);
            }
            return;
        }
        let polynomial = UnitPolynomial::new(terms.iter().copied(), step.epsilon);
        self.add_changes(function, &polynomial);
    }

    fn add_changes(&mut self, function: usize, polynomial: &UnitPolynomial) {
        let resolution = self.resolution;
        if self.begins_on_other_branch(polynomial) {
            self.insert(Crossing { at: 0.0, function });
        }
        for change in polynomial.sign_changes(resolution) {
            let is_at_begin = change.at <= resolution;
            if !is_at_begin {
                self.insert(Crossing {
                    at: change.at,
                    function,
                });
            }
        }
        let (value, slope) = (polynomial.value(1.0), polynomial.slope(1.0));
        let has_no_sign = value.abs() <= polynomial.uncertainty(1.0);
        if has_no_sign && slope != 0.0 || value.abs() <= resolution * slope.abs() {
            self.at_end = self.at_end.or(Some(function));
        }
    }

    /// Whether the sign at the beginning of a step, by which its branch was chosen, differs from the sign just after
    /// the beginning.
    fn begins_on_other_branch(&self, polynomial: &UnitPolynomial) -> bool {
        let mut coefficients = polynomial.coefficients().iter();
        let value = coefficients.next().copied().unwrap_or(0.0);
        let slope = polynomial.coefficients().get(1).copied().unwrap_or(0.0);
        if value.abs() > self.resolution * slope.abs() {
            return false;
        }
        let uncertainty = polynomial.uncertainty(1.0);
        let mut behind = coefficients.filter(|term| term.abs() > uncertainty);
        let Some(behind) = behind.next() else {
            return false;
        };
        value == 0.0 || value * behind < 0.0
    }

    /// Adds a sign change, unless there already is one at that time. If there are more than can be kept, the last ones
    /// are dropped, and the step is to end before them.
    fn insert(&mut self, crossing: Crossing) {
        let kept = &self.crossings[..self.count];
        let is_together = |other: &Crossing| (other.at - crossing.at).abs() <= self.resolution;
        if kept.iter().any(is_together) {
            return;
        }
        let position = kept.partition_point(|other| other.at <= crossing.at);
        if self.count == MAX_CROSSINGS {
            let last = kept.last().map_or(1.0, |last| last.at.max(crossing.at));
            self.converging = self.converging.min(last);
        } else {
            self.count += 1;
        }
        let mut moved = crossing;
        for slot in self.crossings.iter_mut().take(self.count).skip(position) {
            core::mem::swap(slot, &mut moved);
        }
    }

    /// Returns each sign change with two times between it and the next one, or the end of the step. They divide this
    /// interval by the golden section, so that a function that is symmetric or antisymmetric about the middle does not
    /// vanish at both.
    pub(super) fn with_times_behind(&self) -> impl Iterator<Item = (Crossing, [f64; 2])> + '_ {
        let crossings = &self.crossings[..self.count];
        let next = crossings.iter().skip(1).map(|next| next.at);
        let pairs = crossings.iter().zip(next.chain(core::iter::once(1.0)));
        pairs.filter_map(|(crossing, next)| {
            let minor = GOLDEN_SECTION * (next - crossing.at);
            let is_within = next - crossing.at > self.resolution;
            is_within.then_some((*crossing, [crossing.at + minor, next - minor]))
        })
    }
}

/// Returns the fraction of a step over which the last two terms are small relative to the sum of all terms.
fn converging_part(terms: &[f64], allowed: impl Fn() -> f64) -> f64 {
    let (mut part, mut limit) = (1.0, CONVERGED);
    for halving in 0..MAX_HALVINGS {
        let (mut power, mut sum, mut last) = (1.0, 0.0, [0.0; 2]);
        for term in terms {
            let size = (term * power).abs();
            sum += size;
            last = [last[1], size];
            power *= part;
        }
        let greatest = f64::max(last[0], last[1]);
        if greatest > limit * sum && halving == 0 {
            limit = allowed();
        }
        if greatest <= limit * sum {
            break;
        }
        part *= 0.5;
    }
    part
}

/// Terms below this number of rounding errors of the motion's terms are rounding errors.
const NOISE: f64 = 64.0;

/// The smaller part of the golden section, (3 − √5)/2.
const GOLDEN_SECTION: f64 = 0.381_966_011_250_105_1;
