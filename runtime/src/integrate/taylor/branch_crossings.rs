//! Where a motion passes from one branch of its equations to another.
//!
//! A series continues the branch on which a step begins: that of |u|, sgn u, min, max and atan2. A contact that begins and
//! ends within a step does not show at its end. The arguments whose signs distinguish branches have series of their own, whose
//! zeros are found as those of declared events are; between two of them the series is compared with the equations.

use crate::integrate::event::Polynomial;
use crate::limits::taylor::MOST_CROSSINGS;
use crate::scalar::DoubleDouble;

/// Visits the Taylor coefficients of arguments of branches, those of one after those of another.
pub type BranchVisitor<'a, S> = dyn FnMut(&mut dyn Iterator<Item = S>) + 'a;

/// The zeros of arguments of branches within a step, in parts of it and ascending.
#[derive(Clone, Copy, Debug)]
pub(super) struct BranchCrossings {
    zeros: [f64; MOST_CROSSINGS],
    count: usize,
    /// Whether there are more of them, or terms of a series are too large for numbers.
    overflows: bool,
}

impl BranchCrossings {
    pub(super) const NONE: Self = Self {
        zeros: [1.0; MOST_CROSSINGS],
        count: 0,
        overflows: false,
    };

    /// Whether a step has more zeros than are kept, or a length at which terms of a series overflow: it is too long to be checked.
    pub(super) fn overflows(&self) -> bool {
        self.overflows
    }

    /// Adds the zeros of an argument with these coefficients, over a step that is so many units of its series long. An argument
    /// that has no series at the beginning of the step has none.
    pub(super) fn add(
        &mut self,
        coefficients: impl Iterator<Item = DoubleDouble>,
        length: f64,
        epsilon: f64,
    ) {
        let mut has_series = true;
        let coefficients =
            coefficients.inspect(|coefficient| has_series &= coefficient.to_f64().is_finite());
        let Some(polynomial) = Polynomial::over(coefficients, length, epsilon) else {
            self.overflows |= has_series;
            return;
        };
        if polynomial.has_one_sign() {
            return;
        }
        let mut next = polynomial.next_root(0.0, 0.0);
        while let Some(root) = next {
            if root.before * root.behind < 0.0 {
                let Some(zero) = self.zeros.get_mut(self.count) else {
                    self.overflows = true;
                    return;
                };
                *zero = root.at;
                self.count += 1;
                self.zeros[..self.count].sort_unstable_by(f64::total_cmp);
            }
            next = polynomial.next_root(root.until, root.behind);
        }
    }

    /// Two times between each zero and the next, or the end of the step. They divide it by the golden section: what is symmetric
    /// or antisymmetric about the middle does not vanish at both.
    pub(super) fn times_between(&self) -> impl Iterator<Item = f64> + '_ {
        let zeros = &self.zeros[..self.count];
        let next = zeros.iter().skip(1).chain(core::iter::once(&1.0));
        zeros.iter().zip(next).flat_map(|(zero, next)| {
            let minor = GOLDEN_SECTION * (next - zero);
            [zero + minor, next - minor]
        })
    }
}

/// The smaller part, (3 − √5)/2.
const GOLDEN_SECTION: f64 = 0.381_966_011_250_105_1;
