//! The event functions without zeros in the last steps of all lanes.

use super::TaylorLanes;
use crate::integrate::bernstein::as_number;
use crate::integrate::event::{MetConditions, OneSignedInLanes, Terms};
use crate::integrate::taylor::{Series, TaylorCoefficients};
use crate::limits::events::{LEADING_HALF_ORDER, MIN_REMAINING_PART};
use crate::linalg::LaneStates;
use crate::scalar::Lanes;

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Returns, for each lane, the watched event functions whose first terms exclude a zero in the last step.
    pub(crate) fn one_signed<D>(&self, dynamics: &D, watched: MetConditions) -> OneSignedInLanes<L>
    where
        D: Series<Lanes<L>, State = X>,
    {
        let mut found = OneSignedInLanes::UNKNOWN;
        if HALF <= LEADING_HALF_ORDER {
            return found;
        }
        let (times, from, unit) = &self.previous;
        let (t, end, unit) = (Lanes(*times), Lanes(self.time), Lanes(*unit));
        let motion = &self.coefficients;
        let ends = ((t, from.value()), (end, self.state.value()));
        let length = (end - t) / unit;
        let accuracy = (f64::EPSILON, as_number(1 + Self::ORDER));
        let mut insert =
            |index: usize, function: &TaylorCoefficients<_, LEADING_HALF_ORDER>, last| {
                let terms = Terms::new(function, length, accuracy);
                found.insert(index, &signs(&terms, last));
            };
        dynamics.events_in_step(ends.0, unit, motion, ends.1, (watched, &mut insert));
        found
    }
}

/// Returns the sign that a function has in the whole step of a lane, or 0 if it is not certain from its first terms and its
/// value at the end.
#[inline]
fn signs<const L: usize>(terms: &Terms<Lanes<L>, LEADING_HALF_ORDER>, last: Lanes<L>) -> [f64; L] {
    let signs = terms.sign_of_lanes(MIN_REMAINING_PART);
    let difference = terms.difference_at_end(last);
    // If the last terms of a function vanish, a few terms tell nothing about the others.
    let excess = terms.tail() - terms.rounding();
    core::array::from_fn(|lane| {
        let agrees = difference.0[lane] <= 0.0 && signs[lane] * last.0[lane] > 0.0;
        if agrees && excess.0[lane] > 0.0 {
            signs[lane]
        } else {
            0.0
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{LEADING_HALF_ORDER, signs};
    use crate::integrate::event::Terms;
    use crate::integrate::taylor::TaylorCoefficients;
    use crate::scalar::Lanes;

    /// In each lane: a function with one sign, one with another sign at the end, one with zeros, and one of which only the last
    /// terms differ from zero.
    #[test]
    fn lanes_have_the_signs_that_their_first_terms_prove() {
        let mut series = TaylorCoefficients::<Lanes<4>, LEADING_HALF_ORDER>::new(Lanes([0.0; 4]));
        *series.initial_mut() = Lanes([-1.0, 1.0, 1.0, 1.0]);
        let parabola = [[-1e6, 1e6, -5.0, 0.0], [1e6, -1e6, 4.5, 0.0]].map(Lanes);
        series.higher_mut()[..2].copy_from_slice(&parabola);
        series.higher_mut()[2 * LEADING_HALF_ORDER - 2..]
            .copy_from_slice(&[Lanes([1e-8, 1e-8, 1e-8, 0.0]); 2]);
        let terms = Terms::new(&series, Lanes([1.0; 4]), (f64::EPSILON, 17.0));
        let signs = |last| Lanes(signs(&terms, Lanes(last)));
        assert_eq!(signs([-1.0, -5.0, 0.5, 1.0]), Lanes([-1.0, 0.0, 0.0, 0.0]));
        assert_eq!(signs([-1.0, 1.0, 0.5, 1.0]), Lanes([-1.0, 1.0, 0.0, 0.0]));
    }
}
