//! The passage of a motion through a discontinuity surface, on which a switching function g is zero.
//!
//! A. F. Filippov, *Differential Equations with Discontinuous Righthand Sides* (1988), § 10; L. Dieci & L. Lopez, *A
//! survey of numerical methods for IVPs of ODEs with discontinuous right-hand side*, J. Comput. Appl. Math. **236**
//! (2012) 3967–3991, section 2. If the vector fields on both sides point to the same side, the motion crosses the
//! surface (a transversal crossing); if both point towards the surface, it stays on it (a sliding mode).
//!
//! On the surface itself rounding would choose the branch. The equations are therefore evaluated a short time after it,
//! where the continuation of the motion before the surface has a certain sign of g. The motion between the surface and
//! this time on the old branch is then replaced by the motion on the new branch. This is repeated until it changes
//! nothing. The time of the crossing is a scalar: the state after it includes its digits beyond `f64` and its
//! derivative parts.

use super::branch_crossings::Crossing;
use super::residual::moved;
use super::{Series, TaylorCoefficients};
use crate::integrate::compensated::Compensated;
use crate::limits::events::MAX_COEFFICIENTS;
use crate::limits::taylor::{
    FIRST_PUSH, MAX_PUSH, PUSH_GROWTH, RESOLUTION, ROOT_ITERATIONS, SETTLING,
    SETTLING_OF_DERIVATIVES, UNIT_CHANGE, UNIT_CHANGES,
};
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// A step that leads to a discontinuity surface, of a single motion or of a motion in a lane.
pub(super) struct StepToSurface<'a, S: Scalar, D: Series<S> + ?Sized, const HALF: usize> {
    pub(super) dynamics: &'a D,
    /// The state at the beginning of the step.
    pub(super) from: &'a Compensated<D::State>,
    /// The series about the beginning of the step.
    pub(super) coefficients: &'a TaylorCoefficients<D::State, HALF>,
    /// The unit of time of the series.
    pub(super) unit: S,
    /// Converts a time to a scalar.
    pub(super) time: &'a dyn Fn(f64) -> S,
    /// Returns the argument of the series at a time.
    pub(super) argument: &'a dyn Fn(f64) -> S,
    pub(super) lane: usize,
    pub(super) begin: f64,
    /// The end of the step if there were no surface.
    pub(super) end: f64,
    /// The time that must not be passed.
    pub(super) target: f64,
}

/// A time and a state.
pub(super) struct Arrival<X> {
    pub(super) time: f64,
    pub(super) state: Compensated<X>,
}

/// The continuation of a motion at a discontinuity surface.
pub(super) enum Passage<X> {
    /// The motion continues after the surface, or ends on it.
    Crosses(Arrival<X>),
    /// The motion would be led back immediately: a sliding mode. The state is the one to which the branch before the
    /// surface leads.
    Slides(Arrival<X>),
    /// The sign of the switching function is not certain anywhere.
    Unclear,
}

/// A switching function along a series.
struct Along<S> {
    coefficients: [S; MAX_COEFFICIENTS],
}

impl<S: Scalar> Along<S> {
    /// Returns the value at an argument.
    fn value(&self, tau: S) -> S {
        let coefficients = self.coefficients.iter().rev();
        coefficients.fold(S::zero(), |sum, a| sum * tau + *a)
    }

    /// Returns the change from the beginning to an argument.
    fn change(&self, tau: S) -> S {
        let higher = self.coefficients.iter().skip(1).rev();
        tau * higher.fold(S::zero(), |sum, a| sum * tau + *a)
    }
}

impl<S: Scalar, D: Series<S> + ?Sized, const HALF: usize> StepToSurface<'_, S, D, HALF> {
    /// Determines how the motion continues. Series are computed in `behind`; the number of evaluations is added to
    /// `evaluations`.
    pub(super) fn pass(
        &self,
        crossing: Crossing,
        behind: &mut TaylorCoefficients<D::State, HALF>,
        evaluations: &mut u64,
    ) -> Passage<D::State> {
        let Some(root) = self.root(crossing) else {
            return Passage::Unclear;
        };
        let h = self.end - self.begin;
        let after = self.read(root) * self.read(self.unit);
        let time = self.begin + if after * h > 0.0 { after } else { 0.0 };
        // Steps end at times that are `f64` numbers, whatever the scalar.
        let epsilon = S::machine_epsilon().max(f64::EPSILON);
        let first = FIRST_PUSH * epsilon * (time.abs() + h.abs());
        let function = (crossing.function, root);
        // After a corner the series may converge only up to it, like the series of a square root.
        let long = 0.25 * libm::sqrt(epsilon) * h.abs();
        let t = time + long.copysign(h);
        if long > first
            && (self.target - t) * h.signum() > 0.0
            && let Some(passage) = self.settle(function, (t, true), behind, evaluations)
        {
            return passage;
        }
        let largest = first.max(MAX_PUSH * h.abs());
        let mut push = first.max(f64::MIN_POSITIVE);
        while push <= largest {
            let t = time + push.copysign(h);
            if (self.target - t) * h.signum() <= 0.0 {
                return Passage::Crosses(self.continued(self.target));
            }
            let found = self.settle(function, (t, false), behind, evaluations);
            if let Some(passage) = found {
                return passage;
            }
            push *= PUSH_GROWTH;
        }
        Passage::Unclear
    }

    /// Returns the argument at which the switching function is zero, to the digits of the scalar and with its
    /// derivative parts.
    fn root(&self, crossing: Crossing) -> Option<S> {
        let whole = (self.argument)(self.end);
        let mut root = whole * S::from_f64(crossing.at);
        let initial = self.from.reduced(self.dynamics);
        let along = self.along(
            (self.time)(self.begin),
            &initial,
            (self.coefficients, self.unit),
            crossing.function,
        )?;
        let [slope, last_terms] = self.slope_and_last_terms(&along, self.read(root));
        if slope == 0.0 {
            return Some(root);
        }
        // The root is already known to many digits; a multiple root is not improved.
        let resolution = RESOLUTION * f64::EPSILON * self.read(whole).abs();
        let largest = resolution.max(MAX_PUSH * self.read(root).abs());
        for _ in 0..ROOT_ITERATIONS {
            let value = if last_terms <= S::machine_epsilon() {
                along.value(root)
            } else {
                // The function is known only by its values.
                let state = self.from.plus(self.coefficients.change(root));
                let state = state.reduced(self.dynamics);
                let t = (self.time)(self.begin) + root * self.unit;
                let motion = (self.coefficients, self.unit);
                let there = self.along(t, &state, motion, crossing.function)?;
                there.value(S::zero())
            };
            let correction = value / S::from_f64(slope);
            let size = self.read(correction).abs();
            if size.is_nan() || size > largest {
                break;
            }
            root -= correction;
            if S::DERIVATIVES == 0 && size <= 0.0 {
                break;
            }
        }
        Some(root)
    }

    /// Returns the derivative of a switching function at an argument, and the larger of its last two terms there over
    /// the sum of all terms.
    fn slope_and_last_terms(&self, along: &Along<S>, tau: f64) -> [f64; 2] {
        let (mut power, mut before, mut order) = (1.0, 0.0, 0.0);
        let (mut slope, mut sum, mut last) = (0.0, 0.0, [0.0; 2]);
        for coefficient in along.coefficients.iter().take(2 * HALF + 1) {
            let coefficient = self.read(*coefficient);
            if coefficient != 0.0 {
                slope += order * coefficient * before;
            }
            last = [last[1], (coefficient * power).abs()];
            sum += last[1];
            (before, power, order) = (power, power * tau, order + 1.0);
        }
        [slope, f64::max(last[0], last[1]) / sum]
    }

    /// Determines how the motion continues, if that is certain at a time after the surface. If `of_corner` is set, only
    /// a corner is accepted: the motions on both branches then agree up to this time except for rounding.
    fn settle(
        &self,
        (function, root): (usize, S),
        (t, of_corner): (f64, bool),
        behind: &mut TaylorCoefficients<D::State, HALF>,
        evaluations: &mut u64,
    ) -> Option<Passage<D::State>> {
        let lag = (self.argument)(t) - root;
        let on_surface = self.coefficients.change(root);
        let here = (self.time)(t);
        let mut state = self.continued(t).state;
        // The value of the switching function predicted by the last series, and the first correction of the state.
        let (mut expected, mut first) = (None, None);
        let least = if S::DERIVATIVES > 0 {
            SETTLING_OF_DERIVATIVES
        } else {
            0
        };
        for round in 0..SETTLING {
            let x = state.reduced(self.dynamics);
            let unit = self.expand(here, &x, behind, evaluations)?;
            let along = self.along(here, &x, (behind, unit), function)?;
            let lag = lag * (self.unit / unit);
            let mut change = on_surface.clone();
            change.add_scaled(-S::one(), &behind.change(-lag));
            let next = self.from.plus(change);
            let value = self.read(along.value(S::zero()));
            let by_series = -self.read(along.change(-lag));
            let leaves = value * self.read(along.coefficients[1]) * self.read(lag) > 0.0;
            let is_certain = |expected: f64| (value - expected).abs() <= 0.25 * value.abs();
            let corrections = next.value().zip_map(state.value(), |x, y| (x - y).abs());
            if of_corner && !self.is_small(&corrections, state.value(), &corrections.zeroed()) {
                return None;
            }
            let first = first.get_or_insert_with(|| corrections.clone());
            let is_settled = round >= least && self.is_small(&corrections, state.value(), first);
            if is_settled && leaves && is_certain(by_series) {
                return Some(Passage::Crosses(Arrival {
                    time: t,
                    state: next,
                }));
            }
            if !leaves && expected.is_some_and(is_certain) {
                return Some(Passage::Slides(self.continued(t)));
            }
            if is_settled {
                return None;
            }
            expected = Some(by_series);
            state = next;
        }
        None
    }

    /// Returns the motion on the branch on which the step begins.
    fn continued(&self, t: f64) -> Arrival<D::State> {
        let change = self.coefficients.change((self.argument)(t));
        Arrival {
            time: t,
            state: self.from.plus(change),
        }
    }

    /// Computes a series, in a unit of time in which it is finite.
    fn expand(
        &self,
        t: S,
        x: &D::State,
        coefficients: &mut TaylorCoefficients<D::State, HALF>,
        evaluations: &mut u64,
    ) -> Option<S> {
        let mut unit = self.unit;
        let mut change = UNIT_CHANGE;
        for _ in 0..UNIT_CHANGES {
            self.dynamics.series((t, x), unit, coefficients, None);
            *evaluations += 1;
            let mut last = coefficients.higher().iter().rev().take(2);
            let is_finite = |x: &D::State| x.components().all(|x| self.read(x).is_finite());
            if last.all(is_finite) {
                return Some(unit);
            }
            unit *= S::from_f64(change);
            change *= change;
        }
        None
    }

    /// Returns a switching function along a series; only its value is valid if the series belongs to another state.
    fn along(
        &self,
        t: S,
        x: &D::State,
        (motion, unit): (&TaylorCoefficients<D::State, HALF>, S),
        function: usize,
    ) -> Option<Along<S>> {
        let (mut index, mut found) = (0, None);
        self.dynamics.branches(t, x, unit, motion, &mut |series| {
            if index == function {
                let mut along = Along {
                    coefficients: [S::zero(); MAX_COEFFICIENTS],
                };
                for (slot, coefficient) in along.coefficients.iter_mut().zip(series) {
                    *slot = coefficient;
                }
                found = Some(along);
            }
            index += 1;
        });
        found
    }

    /// Whether corrections of a state are rounding errors, or much smaller than the first corrections.
    fn is_small(&self, corrections: &D::State, x: &D::State, first: &D::State) -> bool {
        let epsilon = S::machine_epsilon();
        let sizes = x.components().zip(first.components());
        let mut triples = corrections.components().zip(sizes);
        triples.all(|(correction, (x, first))| {
            let rounding = 4.0 * epsilon * self.read(x).abs();
            let [correction, first] = [correction, first].map(|x| self.read(x));
            correction <= rounding || correction <= libm::sqrt(epsilon) * first
        })
    }

    fn read(&self, x: S) -> f64 {
        x.in_lane(self.lane)
    }
}

/// Returns the switching function that is zero to rounding at a state, if there is one.
#[cold]
pub(super) fn surface_at<S: Scalar, D: Series<S> + ?Sized, const HALF: usize>(
    dynamics: &D,
    (t, x): (S, &D::State),
    (motion, unit): (&TaylorCoefficients<D::State, HALF>, S),
    lane: usize,
) -> Option<usize> {
    // A bit for each function that is positive.
    let mut signs = [0_u128; 2];
    for (signs, alternation) in signs.iter_mut().zip([1.0, -1.0]) {
        let (t, moved) = moved(t, x, alternation);
        let mut bit = 1_u128;
        dynamics.branches(t, &moved, unit, motion, &mut |series| {
            let value = series.next().map_or(0.0, |value| value.in_lane(lane));
            if value > 0.0 {
                *signs |= bit;
            }
            bit = bit.checked_shl(1).unwrap_or(0);
        });
    }
    let differing = signs[0] ^ signs[1];
    (differing != 0).then(|| usize::try_from(differing.trailing_zeros()).unwrap_or(0))
}
