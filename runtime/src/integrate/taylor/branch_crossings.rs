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
}

impl BranchCrossings {
    pub(super) const NONE: Self = Self {
        zeros: [1.0; MOST_CROSSINGS],
        count: 0,
    };

    /// Adds the zeros of an argument with these coefficients, over a step that is so many units of its series long.
    pub(super) fn add(
        &mut self,
        coefficients: impl Iterator<Item = DoubleDouble>,
        length: f64,
        epsilon: f64,
    ) {
        let mut power = DoubleDouble::from(1.0);
        let scaled = coefficients.map(|coefficient| {
            let scaled = coefficient * power;
            power *= DoubleDouble::from(length);
            scaled
        });
        let Some(polynomial) = Polynomial::new(scaled, epsilon) else {
            return;
        };
        if polynomial.has_one_sign() {
            return;
        }
        let mut next = polynomial.next_root(0.0, 0.0);
        while let Some(root) = next.filter(|_| self.count < MOST_CROSSINGS) {
            if root.before * root.behind < 0.0 {
                self.zeros[self.count] = root.at;
                self.count += 1;
                self.zeros[..self.count].sort_unstable_by(f64::total_cmp);
            }
            next = polynomial.next_root(root.until, root.behind);
        }
    }

    /// The middles between each zero and the next, or the end of the step.
    pub(super) fn middles(&self) -> impl Iterator<Item = f64> + '_ {
        let zeros = &self.zeros[..self.count];
        let next = zeros.iter().skip(1).chain(core::iter::once(&1.0));
        zeros
            .iter()
            .zip(next)
            .map(|(zero, next)| 0.5 * (zero + next))
    }
}
