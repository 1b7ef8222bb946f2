//! Steps that pass singular configurations of constraints, at which the gradients of constraints depend on each other for a
//! moment.
//!
//! The accelerations are smooth along a motion through such a configuration, but the system of equations from which they are
//! computed is singular there: errors of rounding in the Taylor coefficients of order k grow as the distance in time to the
//! power −k. Steps chosen from these coefficients would end at the configuration or become ever shorter on the way to it.
//! Steps are therefore chosen by the distance itself.

use super::coefficients::{number, power};
use crate::integrate::binary_logarithm::{exp2, log2};
use crate::limits::passing::SMALL_SINE;
use crate::limits::taylor::SHORTENING;
use crate::limits::taylor::passing::{
    BEHIND, BRACKET, FARTHER, INTERVALS, MAX_GROWTH, MIN_PART, MIN_SINE_PART, REFINEMENTS, SHORT,
    SINGULAR_SINE,
};

/// The nearest singular configuration ahead, at a distance in time from the beginning of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct SingularConfiguration {
    /// Infinite where there is none within reach of the step.
    distance: f64,
    /// The sine at the beginning of the step.
    first_sine: f64,
    /// The smallest sine within reach of the step.
    sine: f64,
    /// The part of the distance from which on a step is lengthened to pass.
    min_part: f64,
}

impl SingularConfiguration {
    /// No singular configuration.
    pub(super) const NONE: Self = Self {
        distance: f64::INFINITY,
        first_sine: 1.0,
        sine: 1.0,
        min_part: 1.0,
    };

    /// Returns the least length, as a part of the distance, of a step that rounding errors of the last coefficient limit: the
    /// step of a polynomial of this order to this tolerance, in machine epsilons.
    pub(super) fn min_part(tolerance: f64, order: usize) -> f64 {
        exp2(log2(tolerance / MAX_GROWTH) / number(order)).min(MIN_PART)
    }

    /// Returns the length of a step that was proposed with this length, so that the step or the next one passes.
    pub(super) fn lengthened(self, step: f64) -> f64 {
        if step < BEHIND * self.distance && step >= self.min_part * self.distance {
            BEHIND * self.distance
        } else {
            step
        }
    }

    /// Returns the length of the step after one of this length that does not agree with the motion.
    pub(super) fn shortened(self, step: f64) -> f64 {
        if step > FARTHER * BEHIND * self.distance {
            BEHIND * self.distance
        } else if step > self.distance {
            SHORT * self.distance
        } else {
            step / SHORTENING
        }
    }

    /// Returns the factor by which rounding errors of the coefficients up to this order grow in a step of this length: 1 if it
    /// does not pass.
    pub(super) fn growth(self, step: f64, order: usize) -> f64 {
        if step > self.distance {
            power(BEHIND, order)
        } else {
            1.0
        }
    }

    /// Whether a step of this length, with this sine at its end, ends at a singular configuration that was not found, or not where
    /// it is: rounding errors of the coefficients may hide it. A step that begins so near to it would see nothing else.
    pub(super) fn is_overlooked(self, step: f64, sine: f64) -> bool {
        step <= self.distance && sine < SINGULAR_SINE.min(MIN_SINE_PART * self.first_sine)
    }

    /// Whether the correction by which the end of a step is projected is limited to the tolerance. Where the gradients of
    /// constraints nearly depend on each other, rounding makes it larger.
    pub(super) fn limits_corrections(self) -> bool {
        self.sine > SMALL_SINE
    }

    /// Finds the singular configuration within reach of a step, in each lane: up to the length of the step divided by
    /// `min_part`.
    ///
    /// `sines` returns the sines at times after the beginning, along the polynomials of the steps. The square of a sine is
    /// smooth, and the smallest of its minima is found by parabolic interpolation (R. P. Brent, *Algorithms for Minimization
    /// without Derivatives* (1973), 5.2).
    pub(super) fn find<const L: usize>(
        (steps, min_part): (&[f64; L], f64),
        mut sines: impl FnMut(&[f64; L]) -> [f64; L],
    ) -> [Self; L] {
        let interval = steps.map(|step| step / (min_part * f64::from(INTERVALS)));
        let mut brackets: [Option<Bracket>; L] = [None; L];
        let mut last = [[f64::INFINITY; 2]; L];
        let (mut first, mut smallest) = ([1.0; L], [f64::INFINITY; L]);
        for k in 0..=INTERVALS {
            let times = interval.map(|interval| f64::from(k) * interval);
            let found = sines(&times);
            if k == 0 {
                first = found;
            }
            for lane in 0..L {
                let [before, middle] = last[lane];
                let is_minimum = k > 1 && middle <= before && middle <= found[lane];
                if is_minimum && brackets[lane].is_none_or(|other| middle < other.sines[1]) {
                    let center = times[lane] - interval[lane];
                    brackets[lane] = Some(Bracket {
                        center,
                        width: interval[lane],
                        sines: [before, middle, found[lane]],
                    });
                }
                last[lane] = [middle, found[lane]];
                smallest[lane] = smallest[lane].min(found[lane]);
            }
        }
        for _ in 0..REFINEMENTS {
            if brackets.iter().all(Option::is_none) {
                break;
            }
            let next = brackets.map(|bracket| bracket.map(Bracket::refined));
            let offsets = [-1.0, 0.0, 1.0];
            let found = offsets.map(|offset| {
                sines(&next.map(|bracket| bracket.map_or(0.0, |bracket| bracket.at(offset))))
            });
            for lane in 0..L {
                let sines = found.map(|found| found[lane]);
                brackets[lane] = next[lane].map(|next| Bracket { sines, ..next });
            }
        }
        core::array::from_fn(|lane| {
            let singular = brackets[lane].filter(|bracket| bracket.sines[1] < SINGULAR_SINE);
            Self {
                distance: singular.map_or(f64::INFINITY, |bracket| bracket.vertex().abs()),
                first_sine: first[lane],
                sine: smallest[lane],
                min_part,
            }
        })
    }
}

/// Three times at equal distances, and the sines there.
#[derive(Clone, Copy, Debug)]
struct Bracket {
    center: f64,
    width: f64,
    sines: [f64; 3],
}

impl Bracket {
    fn at(&self, offset: f64) -> f64 {
        self.center + offset * self.width
    }

    /// Returns the time at which the parabola through the squares of the sines has its extremum, within the bracket.
    fn vertex(&self) -> f64 {
        let [left, middle, right] = self.sines.map(|sine| sine * sine);
        let curvature = left - 2.0 * middle + right;
        if curvature > 0.0 {
            let offset = 0.5 * (left - right) / curvature;
            self.at(offset.clamp(-1.0, 1.0))
        } else {
            self.center
        }
    }

    /// Returns a smaller bracket about the vertex, in which the sines are not known yet.
    fn refined(self) -> Self {
        Self {
            center: self.vertex(),
            width: self.width * BRACKET,
            sines: [f64::NAN; 3],
        }
    }
}
